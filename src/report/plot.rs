//! Error against time as an SVG, both on logarithmic axes.

use super::axis::Axis;
use super::labels::{Drawn, Rect};

/// A drawing of curves over two logarithmic axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Above the drawing.
    pub title: String,
    /// Below it.
    pub x_label: String,
    /// At its left.
    pub y_label: String,
    /// What is drawn.
    pub curves: Vec<Curve>,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// For the legend.
    pub name: String,
    /// Joined in the order of `x`.
    pub points: Vec<Point>,
}

/// One measurement. It is left out where `x` is not above 0, `y` is below 0 or either
/// is not finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Beside the point.
    pub label: String,
    /// Such as a time.
    pub x: f64,
    /// Such as an error; 0 is drawn on a line of its own, below all others.
    pub y: f64,
    /// Drawn hollow: see [`mark_dominated`].
    pub dominated: bool,
}

impl Point {
    fn is_drawable(&self) -> bool {
        self.x.is_finite() && self.x > 0.0 && self.y.is_finite() && self.y >= 0.0
    }
}

/// Marks each point to which another one is to be preferred: no worse in `x` and `y`,
/// and better in one. Less is better; a point with NaN takes no part.
pub fn mark_dominated(points: &mut [Point]) {
    let places: Vec<_> = points.iter().map(|point| (point.x, point.y)).collect();
    for point in points {
        let beats =
            |&(x, y): &(f64, f64)| x <= point.x && y <= point.y && (x < point.x || y < point.y);
        point.dominated = places.iter().any(beats);
    }
}

/// Width and height of the drawing in pixels.
const SIZE: (u32, u32) = (900, 560);

/// The field in which points are drawn.
const FIELD: Rect = Rect {
    left: 82.0,
    top: 56.0,
    right: 700.0,
    bottom: 490.0,
};

/// Height of the strip for errors of 0, the line in its middle.
const ZERO_STRIP: f64 = 84.0;

/// Okabe and Ito's colours, which the colour-blind tell apart, darkest first.
const COLORS: [&str; 7] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000",
];

/// Markers about (0, 0), so that curves differ in more than their colours.
const MARKERS: [&str; 4] = [
    "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z",
    "M-4 -4H4V4H-4z",
    "M0 -5.5L5.5 0L0 5.5L-5.5 0z",
    "M0 -5L5 4H-5z",
];

impl Plot {
    /// The drawing as a file. Equal plots give equal files.
    pub fn to_svg(&self) -> String {
        let curves: Vec<Vec<&Point>> = self.curves.iter().map(Curve::drawable).collect();
        let points = || curves.iter().flatten();
        let has_zero = points().any(|point| point.y == 0.0);
        let strip = if has_zero { ZERO_STRIP } else { 0.0 };
        let x = Axis::around(points().map(|point| point.x), FIELD.left, FIELD.right);
        let errors = points().map(|point| point.y).filter(|y| *y > 0.0);
        let y = Axis::decades(errors, FIELD.bottom - strip, FIELD.top);

        let mut svg = self.head();
        draw_axes(&mut svg, &x, &y, has_zero);
        let zero = FIELD.bottom - 0.5 * ZERO_STRIP;
        let place = |point: &&Point| {
            let height = if point.y == 0.0 {
                zero
            } else {
                y.place(point.y)
            };
            (x.place(point.x), height)
        };
        let places: Vec<Vec<_>> = curves
            .iter()
            .map(|points| points.iter().map(place).collect())
            .collect();
        draw_curves(&mut svg, &curves, &places);
        self.draw_legend(&mut svg, points().any(|point| point.dominated));
        if points().next().is_none() {
            let (x, y) = (
                0.5 * (FIELD.left + FIELD.right),
                0.5 * (FIELD.top + FIELD.bottom),
            );
            svg += &text(
                x,
                y,
                "font-size=\"14\" text-anchor=\"middle\"",
                "nothing to draw",
            );
        }
        svg + "</svg>\n"
    }

    fn head(&self) -> String {
        let (width, height) = SIZE;
        let (middle_x, middle_y) = (
            0.5 * (FIELD.left + FIELD.right),
            0.5 * (FIELD.top + FIELD.bottom),
        );
        let middle = "text-anchor=\"middle\" font-size=\"13\"";
        let title = "text-anchor=\"middle\" font-size=\"17\" font-weight=\"bold\"";
        // A ground of its own: a page may be dark.
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" fill=\"#222222\">\n\
             <rect width=\"{width}\" height=\"{height}\" rx=\"8\" fill=\"#ffffff\"/>\n"
        ) + &text(middle_x, 32.0, title, &self.title)
            + &text(middle_x, 534.0, middle, &self.x_label)
            + &text(
                0.0,
                0.0,
                &format!("{middle} transform=\"translate(24 {middle_y:.1}) rotate(-90)\""),
                &self.y_label,
            )
    }

    fn draw_legend(&self, svg: &mut String, any_dominated: bool) {
        let left = FIELD.right + 26.0;
        let mut top = FIELD.top + 12.0;
        for (index, curve) in self.curves.iter().enumerate() {
            let color = color_of(index);
            *svg += &format!(
                "<path d=\"M{:.1} {top:.1}h24\" stroke=\"{color}\" stroke-width=\"1.5\"/>\n",
                left - 12.0
            );
            *svg += &marker(index, (left, top), color);
            *svg += &text(left + 20.0, top + 4.0, "font-size=\"13\"", &curve.name);
            top += 22.0;
        }
        if any_dominated {
            top += 6.0;
            *svg += &marker(0, (left, top), "#ffffff\" stroke=\"#555555");
            let note = "another is no worse in";
            *svg += &text(left + 20.0, top + 4.0, "font-size=\"12\"", note);
            let note = "both, and better in one";
            *svg += &text(left + 20.0, top + 19.0, "font-size=\"12\"", note);
        }
    }
}

impl Curve {
    /// From left to right.
    fn drawable(&self) -> Vec<&Point> {
        let mut points: Vec<_> = self.points.iter().filter(|p| p.is_drawable()).collect();
        points.sort_by(|left, right| left.x.total_cmp(&right.x));
        points
    }
}

fn draw_axes(svg: &mut String, x: &Axis, y: &Axis, has_zero: bool) {
    let Rect {
        left,
        top,
        right,
        bottom,
    } = FIELD;
    let small = "font-size=\"12\" text-anchor";
    let mut grid = String::new();
    for (value, written) in x.round_values() {
        let at = x.place(value);
        grid += &format!("M{at:.1} {top:.1}V{bottom:.1}");
        *svg += &text(at, bottom + 18.0, &format!("{small}=\"middle\""), &written);
    }
    for exponent in y.powers() {
        let at = y.place_exponent(exponent.into());
        grid += &format!("M{left:.1} {at:.1}H{right:.1}");
        let power = format!("10{}", superscript(exponent));
        *svg += &text(left - 8.0, at + 4.0, &format!("{small}=\"end\""), &power);
    }
    *svg += &format!("<path d=\"{grid}\" stroke=\"#e2e2e2\" fill=\"none\"/>\n");
    if has_zero {
        let (edge, line) = (bottom - ZERO_STRIP, bottom - 0.5 * ZERO_STRIP);
        *svg += &format!(
            "<rect x=\"{left:.1}\" y=\"{edge:.1}\" width=\"{:.1}\" height=\"{ZERO_STRIP:.1}\" \
             fill=\"#f3f3f3\"/>\n\
             <path d=\"M{left:.1} {line:.1}H{right:.1}\" stroke=\"#999999\" \
             stroke-dasharray=\"2 4\"/>\n",
            right - left
        );
        *svg += &text(left - 8.0, line + 4.0, &format!("{small}=\"end\""), "0");
    }
    *svg += &format!(
        "<path d=\"M{left:.1} {top:.1}V{bottom:.1}H{right:.1}\" stroke=\"#555555\" fill=\"none\"/>\n"
    );
}

fn draw_curves(svg: &mut String, curves: &[Vec<&Point>], places: &[Vec<(f64, f64)>]) {
    let pairs = |places: &Vec<(f64, f64)>| -> Vec<_> {
        places.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    };
    let mut drawn = Drawn {
        inside: FIELD,
        points: places.concat(),
        lines: places.iter().flat_map(pairs).collect(),
        labels: Vec::new(),
    };
    for (index, places) in places.iter().enumerate() {
        let way: Vec<_> = places
            .iter()
            .map(|(x, y)| format!("{x:.1},{y:.1}"))
            .collect();
        *svg += &format!(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\"0.6\"/>\n",
            way.join(" "),
            color_of(index)
        );
    }
    for (index, (points, places)) in curves.iter().zip(places).enumerate() {
        let color = color_of(index);
        for (point, place) in points.iter().zip(places) {
            let label = drawn.place(*place, &point.label);
            let (x, y) = label.nearest(*place);
            if (x - place.0).hypot(y - place.1) > 16.0 {
                *svg += &format!(
                    "<path d=\"M{:.1} {:.1}L{x:.1} {y:.1}\" stroke=\"#aaaaaa\"/>\n",
                    place.0, place.1
                );
            }
            let fill = if point.dominated { "#ffffff" } else { color };
            *svg += &marker(index, *place, &format!("{fill}\" stroke=\"{color}"));
            let (x, y) = label.base();
            let style = format!("font-size=\"11\" text-anchor=\"middle\" fill=\"{color}\"");
            *svg += &text(x, y, &style, &point.label);
        }
    }
}

fn color_of(index: usize) -> &'static str {
    COLORS[index % COLORS.len()]
}

fn marker(index: usize, (x, y): (f64, f64), fill: &str) -> String {
    let path = MARKERS[index % MARKERS.len()];
    format!("<path d=\"{path}\" transform=\"translate({x:.1} {y:.1})\" fill=\"{fill}\"/>\n")
}

fn text(x: f64, y: f64, attributes: &str, content: &str) -> String {
    let content = escaped(content);
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" {attributes}>{content}</text>\n")
}

/// A number in characters that stand high in every font, which a shifted part of a text
/// does not in every viewer.
fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raise = |character: char| {
        let digit = character.to_digit(10);
        digit.map_or('⁻', |digit| DIGITS[digit as usize])
    };
    number.to_string().chars().map(raise).collect()
}

/// As XML wants it; control characters, of which it allows but three, become spaces.
fn escaped(content: &str) -> String {
    let content = content.replace(char::is_control, " ");
    content
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests;
