//! Polygons into triangles by ear clipping (Meisters 1975, "Polygons have
//! ears"; Eberly, "Triangulation by Ear Clipping": only the neighbours of a
//! removed corner need a new look).

use glam::{DVec2, DVec3};

/// Concave polygons with more corners are cut as fans: the search is quadratic,
/// and a few thousand corners already take some 10 ms.
const MAX_CLIPPED_CORNERS: usize = 4096;

/// How a polygon came apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Cut {
    /// Properly; a convex polygon becomes the fan from corner 0.
    Ears,
    /// As a fan from corner 0, right or not: in the plane it crosses itself, or
    /// it is concave and too large.
    Fan,
    /// It has no area.
    Nothing,
}

/// Cuts polygons; keeps its memory between them.
#[derive(Debug, Default)]
pub(super) struct Clipper {
    /// The corners in the polygon's dominant plane, counter-clockwise.
    flat: Vec<DVec2>,
    previous: Vec<usize>,
    next: Vec<usize>,
    /// Corners that turn left, by the sign of the computed area.
    convex: Vec<bool>,
    /// Corners found to be no ear since their neighbours last changed.
    blocked: Vec<bool>,
    /// Remaining corners that are not convex.
    reflex: usize,
    triangles: Vec<[usize; 3]>,
}

impl Clipper {
    /// Cuts a polygon of three corners or more, none at the place of the next.
    /// A warped one is cut as it looks along the largest axis of its mean
    /// (Newell) normal.
    pub fn cut(&mut self, corners: &[DVec3]) -> Cut {
        self.triangles.clear();
        let normal = newell_normal(corners);
        if normal == DVec3::ZERO {
            return Cut::Nothing;
        }
        if corners.len() == 3 {
            self.triangles.push([0, 1, 2]);
            return Cut::Ears;
        }
        self.start(corners, normal);
        let too_many = corners.len() > MAX_CLIPPED_CORNERS && self.reflex > 0;
        if too_many || !self.clip() {
            self.triangles.clear();
            let last = corners.len() - 1;
            self.triangles.extend((1..last).map(|i| [0, i, i + 1]));
            return Cut::Fan;
        }
        Cut::Ears
    }

    /// The triangles of the last [`Self::cut`], as indices of corners, turning
    /// as the polygon does.
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    fn start(&mut self, corners: &[DVec3], normal: DVec3) {
        let count = corners.len();
        self.flat.clear();
        self.flat
            .extend(corners.iter().map(|&c| project(c, normal)));
        self.next.clear();
        self.next.extend((1..count).chain([0]));
        self.previous.clear();
        self.previous
            .extend([count - 1].into_iter().chain(0..count - 1));
        self.convex.clear();
        self.convex.resize(count, true);
        self.blocked.clear();
        self.blocked.resize(count, false);
        self.reflex = 0;
        for corner in 0..count {
            self.look(corner);
        }
    }

    /// Removes ears until a triangle is left; false if there is none to remove.
    /// The triangles together wind about every point as often as the polygon,
    /// and none is reversed, so on success none overlaps another unless the
    /// polygon overlaps itself.
    fn clip(&mut self) -> bool {
        let mut remaining = self.flat.len();
        // From corner 1 on, so that a convex polygon becomes the fan from 0.
        let mut at = 1;
        let mut failures = 0;
        while remaining > 3 {
            if self.is_ear(at) {
                self.triangles.push([self.previous[at], at, self.next[at]]);
                at = self.remove(at);
                remaining -= 1;
                failures = 0;
            } else if failures < remaining {
                failures += 1;
                at = self.next[at];
            } else {
                return false;
            }
        }
        self.triangles.push([self.previous[at], at, self.next[at]]);
        self.convex[at]
    }

    /// Twice the signed area of three corners in the dominant plane.
    fn area(&self, a: usize, b: usize, c: usize) -> f64 {
        (self.flat[b] - self.flat[a]).perp_dot(self.flat[c] - self.flat[a])
    }

    /// Takes note of whether a corner is convex.
    fn look(&mut self, corner: usize) {
        let convex = self.area(self.previous[corner], corner, self.next[corner]) > 0.0;
        match (self.convex[corner], convex) {
            (true, false) => self.reflex += 1,
            (false, true) => self.reflex -= 1,
            _ => {}
        }
        self.convex[corner] = convex;
        self.blocked[corner] = false;
    }

    /// Takes a corner out and returns the one after it.
    fn remove(&mut self, corner: usize) -> usize {
        let (before, after) = (self.previous[corner], self.next[corner]);
        self.next[before] = after;
        self.previous[after] = before;
        self.reflex -= usize::from(!self.convex[corner]);
        self.look(before);
        self.look(after);
        after
    }

    /// A convex corner whose triangle holds no other corner, rim included. A
    /// triangle that holds any corner holds one that is not convex.
    fn is_ear(&mut self, tip: usize) -> bool {
        if !self.convex[tip] || self.blocked[tip] {
            return false;
        }
        if self.reflex == 0 {
            return true;
        }
        let (before, after) = (self.previous[tip], self.next[tip]);
        let mut other = self.next[after];
        while other != before {
            if !self.convex[other] && self.holds([before, tip, after], other) {
                self.blocked[tip] = true;
                return false;
            }
            other = self.next[other];
        }
        true
    }

    /// Whether `corner` lies in a triangle or on its rim, yet at none of its
    /// corners (where the two sides of a bridge to a hole meet).
    fn holds(&self, [a, b, c]: [usize; 3], corner: usize) -> bool {
        self.area(a, b, corner) >= 0.0
            && self.area(b, c, corner) >= 0.0
            && self.area(c, a, corner) >= 0.0
            && [a, b, c].iter().all(|&i| self.flat[i] != self.flat[corner])
    }
}

/// Perpendicular to a polygon, as long as twice its area; relative to the first
/// corner, so that a polygon far from the origin loses nothing.
fn newell_normal(corners: &[DVec3]) -> DVec3 {
    let edges = corners.windows(2).map(|pair| {
        let (a, b) = (pair[0] - corners[0], pair[1] - corners[0]);
        a.cross(b)
    });
    edges.sum()
}

/// Leaves out the coordinate in which the normal is largest, so that what turns
/// counter-clockwise around the normal does so in the plane.
fn project(corner: DVec3, normal: DVec3) -> DVec2 {
    let size = normal.abs();
    let (flat, up) = if size.z >= size.x && size.z >= size.y {
        (DVec2::new(corner.x, corner.y), normal.z)
    } else if size.y >= size.x {
        (DVec2::new(corner.z, corner.x), normal.y)
    } else {
        (DVec2::new(corner.y, corner.z), normal.x)
    };
    if up < 0.0 {
        DVec2::new(flat.y, flat.x)
    } else {
        flat
    }
}

#[cfg(test)]
#[path = "polygon_tests.rs"]
mod tests;
