//! Where the names of points are written: beside them, and where least is in the way.

/// Height of a label, and its width for each character, in pixels: estimates, since
/// the font is the viewer's own.
const HEIGHT: f64 = 13.0;
const CHARACTER: f64 = 6.0;

/// From a point to its label, tried in this order.
const DISTANCES: [f64; 4] = [8.0, 20.0, 34.0, 48.0];

/// What covering something costs, as pixels of distance.
const OVER_LABEL: f64 = 1000.0;
const OVER_POINT: f64 = 300.0;
const OVER_LINE: f64 = 12.0;
const OUTSIDE: f64 = 3000.0;

/// A rectangle, its corners in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    /// A square around a point.
    fn around((x, y): (f64, f64), radius: f64) -> Self {
        Self {
            left: x - radius,
            top: y - radius,
            right: x + radius,
            bottom: y + radius,
        }
    }

    fn meets(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn is_in(&self, other: &Self) -> bool {
        self.left >= other.left
            && self.right <= other.right
            && self.top >= other.top
            && self.bottom <= other.bottom
    }

    /// Middle of the text's base line.
    pub(super) fn base(&self) -> (f64, f64) {
        (0.5 * (self.left + self.right), self.bottom - 3.0)
    }

    /// The place of the rectangle that is nearest to a point.
    pub(super) fn nearest(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (
            x.clamp(self.left, self.right),
            y.clamp(self.top, self.bottom),
        )
    }
}

/// What is drawn already.
#[derive(Debug)]
pub(super) struct Drawn {
    /// Where labels may be.
    pub(super) inside: Rect,
    /// Markers.
    pub(super) points: Vec<(f64, f64)>,
    /// Lines between them.
    pub(super) lines: Vec<[(f64, f64); 2]>,
    /// Labels, as they are placed.
    pub(super) labels: Vec<Rect>,
}

impl Drawn {
    /// Places one more label.
    pub(super) fn place(&mut self, point: (f64, f64), text: &str) -> Rect {
        let width = CHARACTER * text.chars().count() as f64;
        let mut best = (f64::INFINITY, Rect::around(point, 0.0));
        for distance in DISTANCES {
            for direction in DIRECTIONS {
                let label = beside(point, direction, distance, width);
                let cost = distance + self.cost(&label);
                // The first of equals: the order of the lists says what looks best.
                if cost < best.0 {
                    best = (cost, label);
                }
            }
        }
        self.labels.push(best.1);
        best.1
    }

    fn cost(&self, label: &Rect) -> f64 {
        let labels = self.labels.iter().filter(|other| label.meets(other));
        let covered = |point: &&(f64, f64)| label.meets(&Rect::around(**point, 6.0));
        let points = self.points.iter().filter(covered);
        let lines = self.lines.iter().filter(|line| crosses(line, label));
        let outside = if label.is_in(&self.inside) {
            0.0
        } else {
            OUTSIDE
        };
        OVER_LABEL * labels.count() as f64
            + OVER_POINT * points.count() as f64
            + OVER_LINE * lines.count() as f64
            + outside
    }
}

/// Right, left, above, below, and between.
const DIRECTIONS: [(f64, f64); 8] = [
    (1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (-1.0, 0.0),
    (1.0, -1.0),
    (1.0, 1.0),
    (-1.0, -1.0),
    (-1.0, 1.0),
];

fn beside(point: (f64, f64), (dx, dy): (f64, f64), distance: f64, width: f64) -> Rect {
    let x = point.0 + dx * (distance + 0.5 * width);
    let y = point.1 + dy * (distance + 0.5 * HEIGHT);
    Rect {
        left: x - 0.5 * width,
        top: y - 0.5 * HEIGHT,
        right: x + 0.5 * width,
        bottom: y + 0.5 * HEIGHT,
    }
}

/// Whether a line goes through a rectangle, by places along it.
fn crosses([from, to]: &[(f64, f64); 2], rect: &Rect) -> bool {
    let length = (to.0 - from.0).hypot(to.1 - from.1);
    let steps = (length / 4.0).ceil().max(1.0) as u32;
    (0..=steps).any(|step| {
        let share = f64::from(step) / f64::from(steps);
        let place = (
            from.0 + share * (to.0 - from.0),
            from.1 + share * (to.1 - from.1),
        );
        rect.meets(&Rect::around(place, 1.0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nothing() -> Drawn {
        Drawn {
            inside: Rect::around((100.0, 100.0), 100.0),
            points: Vec::new(),
            lines: Vec::new(),
            labels: Vec::new(),
        }
    }

    #[test]
    fn a_label_alone_is_at_the_right() {
        let label = nothing().place((100.0, 100.0), "robust");
        assert_eq!((label.left, label.right), (108.0, 144.0));
        assert_eq!((label.top, label.bottom), (93.5, 106.5));
    }

    #[test]
    fn labels_of_one_place_keep_apart() {
        let mut drawn = nothing();
        for _ in 0..8 {
            drawn.place((100.0, 100.0), "robust");
        }
        for (i, label) in drawn.labels.iter().enumerate() {
            assert!(label.is_in(&drawn.inside));
            assert!(!drawn.labels[..i].iter().any(|other| other.meets(label)));
        }
    }

    #[test]
    fn labels_keep_off_rims_points_and_lines() {
        let rim = nothing().place((190.0, 100.0), "robust");
        assert!(rim.right <= 200.0);
        let mut drawn = nothing();
        drawn.points.push((120.0, 100.0));
        drawn.lines.push([(100.0, 0.0), (100.0, 100.0)]);
        let label = drawn.place((100.0, 100.0), "robust");
        assert!(label.top > 100.0, "{label:?}");
    }
}
