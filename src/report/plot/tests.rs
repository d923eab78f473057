use super::*;

fn point(label: &str, x: f64, y: f64) -> Point {
    Point {
        label: label.into(),
        x,
        y,
        dominated: false,
    }
}

fn plot(curves: Vec<Vec<Point>>) -> Plot {
    let named = curves.into_iter().enumerate().map(|(index, points)| Curve {
        name: format!("curve {index}"),
        points,
    });
    Plot {
        title: "Errors".into(),
        x_label: "ms".into(),
        y_label: "ulp".into(),
        curves: named.collect(),
    }
}

/// How often something stands in a file.
fn count(svg: &str, part: &str) -> usize {
    svg.matches(part).count()
}

fn marked(mut points: Vec<Point>) -> Vec<bool> {
    mark_dominated(&mut points);
    points.into_iter().map(|point| point.dominated).collect()
}

#[test]
fn a_point_is_dominated_by_one_that_is_no_worse_and_once_better() {
    let slower = vec![point("", 1.0, 5.0), point("", 2.0, 5.0)];
    assert_eq!(marked(slower), [false, true]);
    let worse = vec![point("", 1.0, 6.0), point("", 1.0, 5.0)];
    assert_eq!(marked(worse), [true, false]);
    // Controls: a trade, and two that are equal.
    let trade = vec![point("", 1.0, 5.0), point("", 2.0, 4.0)];
    assert_eq!(marked(trade), [false, false]);
    let equal = vec![point("", 1.0, 5.0), point("", 1.0, 5.0)];
    assert_eq!(marked(equal), [false, false]);
    let zeros = vec![point("", 1.0, 0.0), point("", 2.0, 0.0)];
    assert_eq!(marked(zeros), [false, true]);
}

#[test]
fn nan_neither_dominates_nor_is_dominated_and_old_marks_go() {
    let mut points = vec![point("", 1.0, f64::NAN), point("", 2.0, 4.0)];
    points[1].dominated = true;
    assert_eq!(marked(points), [false, false]);
}

#[test]
fn dominated_points_are_hollow() {
    let mut points = vec![point("a", 1.0, 1.0), point("b", 2.0, 2.0)];
    let hollow = "fill=\"#ffffff\" stroke=";
    assert_eq!(count(&plot(vec![points.clone()]).to_svg(), hollow), 0);
    mark_dominated(&mut points);
    // One point, and one in the legend.
    assert_eq!(count(&plot(vec![points]).to_svg(), hollow), 2);
}

#[test]
fn zero_has_a_line_of_its_own() {
    let zero = text(74.0, 452.0, "font-size=\"12\" text-anchor=\"end\"", "0");
    let with = plot(vec![vec![point("a", 1.0, 1e-3), point("b", 2.0, 0.0)]]).to_svg();
    assert!(with.contains(&zero), "{with}");
    assert!(with.contains("448.0\" fill=\"none\""), "{with}");
    let without = plot(vec![vec![point("a", 1.0, 1e-3)]]).to_svg();
    assert!(!without.contains(&zero));
    // Nothing but zeros.
    assert!(
        plot(vec![vec![point("a", 1.0, 0.0)]])
            .to_svg()
            .contains(&zero)
    );
}

#[test]
fn powers_of_ten_are_raised() {
    let svg = plot(vec![vec![point("a", 1.0, 1e-10), point("b", 2.0, 30.0)]]).to_svg();
    assert!(svg.contains(">10⁻¹⁰</text>") && svg.contains(">10⁰</text>"));
}

#[test]
fn empty_plots_and_curves_are_drawn() {
    let empty = plot(vec![]).to_svg();
    assert!(empty.contains("nothing to draw") && empty.ends_with("</svg>\n"));
    let svg = plot(vec![vec![], vec![point("a", 1.0, 1.0)]]).to_svg();
    assert!(svg.contains("curve 0") && svg.contains("curve 1"));
    assert!(!svg.contains("nothing to draw"));
}

#[test]
fn points_that_have_no_place_are_left_out() {
    let bad = [
        point("bad", f64::NAN, 1.0),
        point("bad", 1.0, f64::NAN),
        point("bad", f64::INFINITY, 1.0),
        point("bad", 1.0, f64::INFINITY),
        point("bad", 0.0, 1.0),
        point("bad", 1.0, -1.0),
    ];
    let good = vec![point("good", 1.0, 1.0)];
    let all = [good.clone(), bad.to_vec()].concat();
    assert_eq!(plot(vec![all]).to_svg(), plot(vec![good]).to_svg());
    let svg = plot(vec![bad.to_vec()]).to_svg();
    assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("bad"));
}

#[test]
fn extreme_numbers_stay_in_the_picture() {
    let points = vec![point("a", 1e-300, 5e-324), point("b", 1e300, 1e308)];
    let svg = plot(vec![points]).to_svg();
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    assert!(svg.len() < 10_000, "{}", svg.len());
}

#[test]
fn labels_are_escaped() {
    let mut plot = plot(vec![vec![point("<&>", 1.0, 1.0)]]);
    plot.title = "a < b\u{0}".into();
    plot.curves[0].name = "x & y".into();
    let svg = plot.to_svg();
    assert!(svg.contains(">&lt;&amp;&gt;</text>"));
    assert!(svg.contains(">a &lt; b </text>") && svg.contains(">x &amp; y</text>"));
    assert!(!svg.contains("<&>"));
}

#[test]
fn points_are_joined_from_left_to_right_and_the_order_changes_no_line() {
    let points = vec![
        point("a", 1.0, 1.0),
        point("b", 10.0, 9.0),
        point("c", 5.0, 3.0),
    ];
    let line = |points: Vec<Point>| -> String {
        let svg = plot(vec![points]).to_svg();
        let line = svg.lines().find(|line| line.starts_with("<polyline"));
        line.expect("a line").into()
    };
    let reversed = points.iter().rev().cloned().collect();
    assert_eq!(line(points.clone()), line(reversed));
    assert_eq!(
        plot(vec![points.clone()]).to_svg(),
        plot(vec![points]).to_svg()
    );
}
