//! Volumes are counted.

use super::hit::Hit;

/// Counts a volume that was tested, and whether the ray met it.
pub fn count_bound<R>(hit: &mut Hit<R>, met: bool) {
    hit.bound_tests += 1;
    hit.bound_hits += u32::from(met);
}
