//! Where a node of a tree is split: the cheapest of some planes by the surface area
//! heuristic, through bins where there are many primitives, through each of their
//! middles where there are few.

use rayon::prelude::*;

use super::item::{EMPTY, Extent, Item};

/// Bins an axis is cut into. More than 16 hardly improves a tree (Wald 2007,
/// section 4).
const BINS: usize = 16;

/// As many primitives as are sorted rather than binned.
const FEW: usize = 8;

/// As many primitives as are binned by several threads.
const MANY: usize = 1 << 15;

/// The cost of visiting a pair, in shape tests: two boxes and a stack.
const VISIT: f32 = 1.0;

/// An f32 from which on the unit is 1: adding it rounds to whole numbers, which then
/// are its lowest bits.
const WHOLE: f32 = 8_388_608.0;

/// A part of a node on its way to become one: the box around its primitives, and the
/// one around their middles, twice.
#[derive(Debug, Clone, Copy)]
pub(super) struct Half {
    pub bounds: Extent,
    pub centers: Extent,
}

impl Half {
    const EMPTY: Half = Half {
        bounds: EMPTY,
        centers: EMPTY,
    };

    #[inline(always)]
    fn with(self, item: &Item) -> Half {
        Half {
            bounds: self.bounds.with(item.extent()),
            centers: self.centers.with_point(item.twice_center()),
        }
    }

    fn joined(self, other: Half) -> Half {
        Half {
            bounds: self.bounds.with(other.bounds),
            centers: self.centers.with(other.centers),
        }
    }

    /// Of these primitives.
    pub fn of(items: &[Item]) -> Half {
        items.iter().fold(Half::EMPTY, Half::with)
    }

    /// The same by several threads: minima and maxima do not depend on the order.
    pub fn of_many(items: &[Item]) -> Half {
        if items.len() <= MANY {
            return Half::of(items);
        }
        items
            .par_chunks(MANY)
            .map(Half::of)
            .reduce(|| Half::EMPTY, Half::joined)
    }
}

/// A way to split a node's primitives.
pub(super) enum Split {
    /// Between two bins.
    Bins(Plane),
    /// After the given number of them in the order of their middles on an axis.
    Sorted { axis: usize, count: usize },
}

/// A plane between two bins.
pub(super) struct Plane {
    axis: usize,
    to_bin: ToBin,
    /// The first bin on the right.
    bin: u32,
}

/// The cheapest split and its cost in shape tests, unless all middles coincide or
/// the areas overflow.
pub(super) fn best_split(items: &[Item], whole: &Half) -> Option<(Split, f32)> {
    let (split, cost) = if items.len() <= FEW {
        best_of_few(items)?
    } else {
        best_of_bins(items, whole)?
    };
    Some((split, VISIT + cost / whole.bounds.half_area()))
}

/// Puts what lies left of the split first, and tells how much that is, and the two
/// halves.
pub(super) fn divide_items(items: &mut [Item], split: &Split) -> (usize, Half, Half) {
    match *split {
        Split::Sorted { axis, count } => {
            sort_few(items, axis);
            (count, Half::of(&items[..count]), Half::of(&items[count..]))
        }
        Split::Bins(ref plane) => partition(items, plane),
    }
}

/// Sorts by insertion, by middle and id.
fn sort_few(items: &mut [Item], axis: usize) {
    let after = |a: &Item, b: &Item| {
        let (at_a, at_b) = (a.twice_center()[axis], b.twice_center()[axis]);
        at_a > at_b || (at_a == at_b && a.id() > b.id())
    };
    for end in 1..items.len() {
        let mut at = end;
        while at > 0 && after(&items[at - 1], &items[at]) {
            items.swap(at - 1, at);
            at -= 1;
        }
    }
}

fn best_of_few(items: &[Item]) -> Option<(Split, f32)> {
    let mut best: Option<(Split, f32)> = None;
    let count = items.len();
    let mut sorted = [items[0]; FEW];
    let sorted = &mut sorted[..count];
    sorted.copy_from_slice(items);
    for axis in 0..3 {
        sort_few(sorted, axis);
        let mut costs = [0.0; FEW];
        let mut sum = EMPTY;
        for left in (1..count).rev() {
            sum = sum.with(sorted[left].extent());
            costs[left] = sum.half_area() * (count - left) as f32;
        }
        let mut sum = EMPTY;
        for left in 1..count {
            sum = sum.with(sorted[left - 1].extent());
            let cost = sum.half_area() * left as f32 + costs[left];
            if cost < best.as_ref().map_or(f32::MAX, |best| best.1) {
                best = Some((Split::Sorted { axis, count: left }, cost));
            }
        }
    }
    best
}

/// From twice a middle to the bins on all axes.
#[derive(Clone, Copy)]
struct ToBin {
    start: [f32; 4],
    scale: [f32; 4],
}

impl ToBin {
    fn new(centers: &Extent) -> Self {
        let scale = std::array::from_fn(|axis| {
            let scale = (BINS - 1) as f32 / (centers.high[axis] - centers.low[axis]);
            // One bin for an axis without extent.
            if axis < 3 && scale.is_finite() {
                scale
            } else {
                0.0
            }
        });
        let start = std::array::from_fn(|axis| if axis < 3 { centers.low[axis] } else { 0.0 });
        Self { start, scale }
    }

    #[inline(always)]
    fn bins(&self, twice_center: [f32; 4]) -> [u32; 4] {
        std::array::from_fn(|i| {
            // From 0 to 15, rounded: the first and the last bin are half as wide.
            let bin = (twice_center[i] - self.start[i]) * self.scale[i] + WHOLE;
            bin.to_bits() & (BINS as u32 - 1)
        })
    }
}

/// The bins of the three axes: what is in each, and how much.
#[derive(Clone)]
struct Bins {
    bounds: [[Extent; BINS]; 3],
    counts: [[u32; BINS]; 3],
}

impl Bins {
    const EMPTY: Bins = Bins {
        bounds: [[EMPTY; BINS]; 3],
        counts: [[0; BINS]; 3],
    };

    fn fill(&mut self, items: &[Item], to_bin: ToBin) {
        for item in items {
            let bins = to_bin.bins(item.twice_center());
            for (axis, &bin) in bins[..3].iter().enumerate() {
                let bin = bin as usize;
                self.bounds[axis][bin] = self.bounds[axis][bin].with(item.extent());
                self.counts[axis][bin] += 1;
            }
        }
    }

    fn joined(mut self, other: Bins) -> Bins {
        for axis in 0..3 {
            for bin in 0..BINS {
                self.bounds[axis][bin] = self.bounds[axis][bin].with(other.bounds[axis][bin]);
                self.counts[axis][bin] += other.counts[axis][bin];
            }
        }
        self
    }
}

fn best_of_bins(items: &[Item], whole: &Half) -> Option<(Split, f32)> {
    let to_bin = ToBin::new(&whole.centers);
    let bins = if items.len() > MANY {
        let filled = |items: &[Item]| {
            let mut bins = Bins::EMPTY;
            bins.fill(items, to_bin);
            bins
        };
        items
            .par_chunks(MANY / 4)
            .map(filled)
            .reduce(|| Bins::EMPTY, Bins::joined)
    } else {
        let mut bins = Bins::EMPTY;
        bins.fill(items, to_bin);
        bins
    };
    let mut best = None;
    let mut least = f32::MAX;
    for axis in 0..3 {
        let (bounds, counts) = (&bins.bounds[axis], &bins.counts[axis]);
        if to_bin.scale[axis] == 0.0 {
            continue;
        }
        let mut costs = [0.0; BINS];
        let (mut sum, mut count) = (EMPTY, 0);
        for bin in (1..BINS).rev() {
            (sum, count) = (sum.with(bounds[bin]), count + counts[bin]);
            costs[bin] = if count > 0 {
                sum.half_area() * count as f32
            } else {
                f32::MAX
            };
        }
        let (mut sum, mut count) = (EMPTY, 0);
        for bin in 1..BINS {
            (sum, count) = (sum.with(bounds[bin - 1]), count + counts[bin - 1]);
            if count == 0 {
                continue;
            }
            let cost = sum.half_area() * count as f32 + costs[bin];
            if cost < least {
                least = cost;
                best = Some((axis, bin as u32));
            }
        }
    }
    let (axis, bin) = best?;
    Some((Split::Bins(Plane { axis, to_bin, bin }), least))
}

/// Swaps from both ends.
fn partition(items: &mut [Item], plane: &Plane) -> (usize, Half, Half) {
    let is_left = |item: &Item| plane.to_bin.bins(item.twice_center())[plane.axis] < plane.bin;
    let (mut left, mut right) = (Half::EMPTY, Half::EMPTY);
    let (mut start, mut end) = (0, items.len());
    loop {
        while start < end && is_left(&items[start]) {
            left = left.with(&items[start]);
            start += 1;
        }
        while start < end && !is_left(&items[end - 1]) {
            end -= 1;
            right = right.with(&items[end]);
        }
        if start >= end {
            return (start, left, right);
        }
        items.swap(start, end - 1);
    }
}
