use super::*;

fn image(width: u32, height: u32, texel: impl Fn(u32, u32) -> f32) -> Texels {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Texels {
        name: "sky".into(),
        width,
        height,
        texels: places.map(|(x, y)| [texel(x, y); 4]).collect(),
    }
}

/// Each point of the sphere has the light of two texels across and of two down.
#[test]
fn an_even_image_has_even_weights() {
    for (width, height) in [(1, 1), (3, 2), (256, 128), (700, 333)] {
        let weights = image_weights(&image(width, height, |_, _| 0.5));
        for weight in &weights {
            // Sums of some hundred terms in f64.
            assert!((weight - 2.0).abs() < 1e-9, "{width} x {height}: {weight}");
        }
    }
    let uneven = image_weights(&image(4, 2, |x, _| x as f32));
    assert!(uneven.iter().any(|weight| (weight - uneven[0]).abs() > 0.1));
}

/// Wherever interpolated light reaches, a cell has weight, and nowhere else.
#[test]
fn a_texel_weighs_where_its_light_reaches() {
    for (x, y) in [(0, 0), (20, 5), (31, 15)] {
        let weights = image_weights(&image(32, 16, |u, v| f32::from(u8::from((u, v) == (x, y)))));
        for (cell, weight) in weights.iter().enumerate() {
            let [row, column] = [cell / COLUMNS as usize, cell % COLUMNS as usize];
            // A cell is an eighth of a texel wide, and so its edges fall on the light's.
            let across = (column as f64 + 0.5) / 8.0 - 0.5 - f64::from(x);
            let across = (across + 16.0).rem_euclid(32.0) - 16.0;
            let edges = [row, row + 1].map(|row| {
                let height = 1.0 - row as f64 * 2.0 / f64::from(ROWS);
                height.acos() / std::f64::consts::PI * 16.0 - 0.5 - f64::from(y)
            });
            let is_below = y == 0 || edges[1] > -1.0;
            let is_above = y == 15 || edges[0] < 1.0;
            let reaches = across.abs() < 1.0 && is_below && is_above;
            assert_eq!(*weight > 0.0, reaches, "{x} {y}: {row} {column}");
        }
    }
}

#[test]
fn sums_are_whole_steps_and_leave_each_one() {
    let mut sun = vec![0.0; 256];
    sun[200] = 1e30;
    let rising: Vec<f64> = (0..128).map(f64::from).collect();
    for weights in [vec![1.0; 256], sun, rising] {
        let sums = partial_sums(&weights);
        assert_eq!((sums.len(), sums[0]), (weights.len(), 0.0));
        let steps: Vec<f64> = sums.iter().map(|sum| f64::from(sum / STEP)).collect();
        let whole: f64 = weights.iter().sum();
        let ends = steps.iter().skip(1).copied().chain([f64::from(1.0 / STEP)]);
        for ((begin, end), weight) in steps.iter().zip(ends).zip(&weights) {
            assert_eq!(begin.fract(), 0.0);
            assert!(end - begin >= 1.0, "{begin} {end}");
            // Both ends are rounded, and moved by at most a step for each that has none.
            let wanted = weight / whole * f64::from(1.0 / STEP);
            let moved = weights.len() as f64 + 1.0;
            assert!(
                (end - begin - wanted).abs() <= moved,
                "{begin} {end} {wanted}"
            );
        }
    }
}

/// A dark cell has its floor, and everything dark is drawn evenly.
#[test]
fn no_cell_is_never_drawn() {
    let cells = (COLUMNS * ROWS) as usize;
    let dark = sums_of(&vec![0.0; cells]);
    assert_eq!(dark[1], 1.0 / ROWS as f32);
    assert_eq!(dark[ROWS as usize + 1], 1.0 / COLUMNS as f32);
    let mut sun = vec![0.0; cells];
    sun[5000] = 7.0;
    let sums = sums_of(&sun);
    assert_eq!(sums.len(), (ROWS + COLUMNS * ROWS) as usize);
    // A row without the sun has its part of the floor's.
    let row = f64::from(sums[1] - sums[0]);
    let expected = FLOOR / (1.0 + FLOOR) / f64::from(ROWS);
    assert!(
        (row - expected).abs() <= f64::from(STEP),
        "{row} {expected}"
    );
}
