//! What a tree is built from: boxes in fours, which compile to one vector each.

use crate::kernel::aabb::Aabb;
use crate::kernel::vector::vec3;

/// A low and a high corner. The fourth numbers mean nothing.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(32))]
pub(super) struct Extent {
    pub low: [f32; 4],
    pub high: [f32; 4],
}

/// A primitive's box. The fourth number of `low` holds its id's bits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item(Extent);

/// The extent of nothing.
pub(super) const EMPTY: Extent = Extent {
    low: [f32::MAX; 4],
    high: [f32::MIN; 4],
};

/// The smaller of each two: a comparison and a choice, one instruction.
fn smaller(a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|i| if a[i] < b[i] { a[i] } else { b[i] })
}

/// The larger of each two.
fn larger(a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|i| if a[i] > b[i] { a[i] } else { b[i] })
}

impl Extent {
    /// The smallest that holds both.
    #[inline(always)]
    pub fn with(self, other: Extent) -> Extent {
        Extent {
            low: smaller(self.low, other.low),
            high: larger(self.high, other.high),
        }
    }

    /// The smallest that holds it and a point.
    #[inline(always)]
    pub fn with_point(self, point: [f32; 4]) -> Extent {
        Extent {
            low: smaller(self.low, point),
            high: larger(self.high, point),
        }
    }

    /// Half the surface.
    pub fn half_area(&self) -> f32 {
        let size: [f32; 3] = std::array::from_fn(|axis| self.high[axis] - self.low[axis]);
        size[0] * size[1] + size[1] * size[2] + size[2] * size[0]
    }

    pub fn aabb(&self) -> Aabb {
        Aabb {
            low: vec3(self.low[0], self.low[1], self.low[2]),
            high: vec3(self.high[0], self.high[1], self.high[2]),
        }
    }
}

impl Item {
    pub fn new((aabb, id): (Aabb, u32)) -> Self {
        let (low, high) = (aabb.low, aabb.high);
        Self(Extent {
            low: [low.x, low.y, low.z, f32::from_bits(id)],
            high: [high.x, high.y, high.z, 0.0],
        })
    }

    pub fn id(&self) -> u32 {
        self.0.low[3].to_bits()
    }

    #[inline(always)]
    pub fn extent(&self) -> Extent {
        self.0
    }

    /// Its box's middle, twice.
    #[inline(always)]
    pub fn twice_center(&self) -> [f32; 4] {
        std::array::from_fn(|i| self.0.low[i] + self.0.high[i])
    }
}
