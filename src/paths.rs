//! Paths: rays of a list that go on from the surfaces that they meet.

use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::kernel::path::{AimRecord, MIRRORED, REFRACTED, TO, TOWARDS};
use crate::kernel::vector::{Vec3, vec3};

/// Where a path goes on from each surface that it meets, as the shape itself faces, smooth
/// normals left aside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Aim {
    /// Thrown back, as by a mirror.
    Mirrored,
    /// In this direction, on the side of the surface to which it points.
    Towards(Vec3<f32>),
    /// To this point, camera-relative, which is at t = 1.
    To(Vec3<f32>),
    /// Refracted, or thrown back where no light goes through.
    Refracted {
        /// The index of refraction on the side from which the path comes by that beyond, the
        /// same at each surface.
        ratio: f32,
    },
}

impl Aim {
    /// As the kernel reads it.
    pub(crate) fn record(self) -> AimRecord {
        let (vector, kind) = match self {
            Self::Mirrored => (Vec3::default(), MIRRORED),
            Self::Towards(direction) => (direction, TOWARDS),
            Self::To(point) => (point, TO),
            Self::Refracted { ratio } => (vec3(ratio, 0.0, 0.0), REFRACTED),
        };
        AimRecord { vector, kind }
    }
}

/// What the legs of some paths find.
#[derive(Debug, Clone, PartialEq)]
pub struct Paths {
    /// What each leg finds, the legs of a path one after the other; after one that finds
    /// nothing, none does.
    pub found: Vec<Found>,
    /// The ray after each path's last leg, which would be the next; its direction is zero
    /// where the path has left the scene.
    pub ends: Vec<Ray<f32>>,
    /// How often a path, or a stretch of one, was followed a second time.
    pub retraced: u64,
}

/// Shapes that an invocation tests at most, and the legs that it follows through a tree: both
/// keep it within the 65,535 loop iterations that lavapipe allows.
const MOST_TESTS: u32 = 60_000;
const LEGS_THROUGH_TREE: u32 = 32;

/// How many legs of a path are followed at once. A longer one is followed in such stretches;
/// what is in doubt is a stretch, on either backend.
pub(crate) fn stretch<R>(flat: &Flat<R>) -> u32 {
    if flat.pairs.is_empty() {
        (MOST_TESTS / (flat.primitives() + 1)).max(1)
    } else {
        LEGS_THROUGH_TREE
    }
}

/// Refuses what is not one aim a ray, or no path at all.
pub(crate) fn check_aims(rays: &[Ray<f32>], aims: &[Aim], legs: u32) -> Result<()> {
    if rays.len() != aims.len() {
        let (rays, aims) = (rays.len(), aims.len());
        return Err(Error::Usage(format!("{aims} aims for {rays} rays")));
    }
    if legs == 0 {
        return Err(Error::Usage("a path has one leg at least".into()));
    }
    Ok(())
}
