use super::*;
use crate::frame::Layer;

const EXACT: Tolerance = Tolerance {
    max_ulp: 0,
    max_abs: 0.0,
    different_pixels: 0,
};

/// Two hits in the first row, nothing in the second.
fn frame() -> Frame {
    let mut frame = Frame::new(2, 2).unwrap();
    for i in 0..2 {
        frame.color[i] = [0.5, 0.25, 0.125];
        frame.depth[i] = 4.0;
        frame.normal[i] = [0.0, 0.6, 0.8];
        frame.position[i] = [1.0, 2.0, -3.0];
        frame.id[i] = i as u32;
    }
    frame.color[3] = [1.0, 0.0, 2.0];
    frame
}

fn compare(left: &Frame, right: &Frame) -> Comparison {
    compare_frames(left, right, &EXACT).unwrap()
}

fn next_up(value: &mut f32) {
    *value = value.next_up();
}

#[test]
fn equal_frames_pass() {
    let found = compare(&frame(), &frame());
    assert_eq!(Tolerance::default(), EXACT);
    assert!(found.pass);
    assert_eq!((found.pixels, found.different_pixels), (4, 0));
    assert_eq!((found.max_abs, found.rmse, found.psnr_db), (0.0, 0.0, None));
    assert_eq!(
        (found.flip, found.id_mismatches, found.max_ulp),
        (Some(0.0), 0, 0)
    );
    let names: Vec<&str> = found.layers.iter().map(|l| l.layer.as_str()).collect();
    assert_eq!(names, Layer::ALL.map(Layer::name));
}

#[test]
fn one_ulp_in_any_layer_is_found() {
    type Change = (Layer, fn(&mut Frame));
    let changes: [Change; 5] = [
        (Layer::Color, |f| next_up(&mut f.color[1][2])),
        (Layer::Depth, |f| next_up(&mut f.depth[1])),
        (Layer::Normal, |f| next_up(&mut f.normal[1][0])),
        (Layer::Position, |f| next_up(&mut f.position[1][1])),
        (Layer::Id, |f| f.id[1] += 1),
    ];
    for (changed, change) in changes {
        let mut right = frame();
        change(&mut right);
        let found = compare(&frame(), &right);
        assert!(!found.pass, "{changed}");
        assert_eq!(found.different_pixels, 1, "{changed}");
        assert_eq!(found.outside_pixels, 1, "{changed}");
        let ids = u64::from(changed == Layer::Id);
        assert_eq!(found.id_mismatches, ids, "{changed}");
        assert_eq!(u64::from(found.max_ulp), 1 - ids, "{changed}");
        for layer in &found.layers {
            let here = u64::from(layer.layer == changed.name());
            assert_eq!(layer.different_pixels, here, "{changed}");
        }
        assert!(compare(&right, &right).pass);
    }
}

#[test]
fn a_pixel_that_differs_in_all_layers_counts_once() {
    let mut right = frame();
    right.color[0] = [0.0; 3];
    right.depth[0] = 0.0;
    right.normal[0] = [0.0; 3];
    right.position[0] = [0.0; 3];
    right.id[0] = 9;
    let found = compare(&frame(), &right);
    assert_eq!((found.different_pixels, found.id_mismatches), (1, 1));
}

#[test]
fn color_figures_by_hand() {
    let mut right = frame();
    right.color[0] = [0.75, 0.25, 0.25]; // 0.25, 0, 0.125 apart
    right.color[3] = [1.0, 0.0, 1.5]; // 0.5 apart
    let found = compare(&frame(), &right);
    assert_eq!(found.different_pixels, 2);
    assert_eq!(found.max_abs, 0.5);
    // (1/16 + 1/64 + 1/4) / 12 = 21/768
    let rmse = (21.0_f64 / 768.0).sqrt();
    assert_eq!(found.rmse, rmse);
    assert_eq!(found.psnr_db, Some(-20.0 * rmse.log10()));
    assert!((found.psnr_db.unwrap() - 15.631_7).abs() < 1e-3);
    assert!(found.flip.unwrap() > 0.0);
    // 0.5 to 0.75 is half a binade, 2.0 to 1.5 too, 0.125 to 0.25 a whole one.
    assert_eq!(found.max_ulp, 1 << 23);
}

#[test]
fn signs_of_zero_and_nan_are_bits() {
    let mut right = frame();
    right.color[3][1] = -0.0;
    let found = compare(&frame(), &right);
    assert_eq!((found.different_pixels, found.max_ulp), (1, 1));
    assert_eq!((found.max_abs, found.rmse, found.pass), (0.0, 0.0, false));

    let mut left = frame();
    left.color[3][1] = f32::NAN;
    assert!(compare(&left, &left).pass);
    right.color[3][1] = f32::from_bits(f32::NAN.to_bits() + 1);
    let found = compare(&left, &right);
    assert_eq!((found.different_pixels, found.max_ulp), (1, 1));

    let found = compare(&left, &frame());
    assert_eq!((found.different_pixels, found.max_ulp), (1, u32::MAX));
    assert_eq!((found.max_abs, found.psnr_db), (f64::INFINITY, None));
    let json = serde_json::to_value(&found).unwrap();
    assert!(json["max_abs"].is_null() && json["rmse"].is_null());
}

#[test]
fn what_a_display_clips_makes_no_flip() {
    let mut right = frame();
    right.color[3][2] = 7.0;
    let found = compare(&frame(), &right);
    assert_eq!((found.flip, found.max_abs), (Some(0.0), 5.0));
}

#[test]
fn tolerances_let_through_what_they_name() {
    let mut right = frame();
    right.depth[0] = f32::from_bits(4.0_f32.to_bits() + 3);
    right.color[1][0] += 0.125;
    let passes = |tolerance: Tolerance| compare_frames(&frame(), &right, &tolerance).unwrap().pass;
    assert!(!passes(EXACT));
    let allow = |different_pixels| Tolerance {
        different_pixels,
        ..EXACT
    };
    assert!(passes(allow(2)) && !passes(allow(1)));
    let ulp = |max_ulp| Tolerance {
        max_ulp,
        ..allow(1)
    };
    assert!(passes(ulp(3)) && !passes(ulp(2)));
    let abs = |max_abs| Tolerance { max_abs, ..EXACT };
    assert!(passes(abs(0.125)) && !passes(abs(0.124)));

    // A tolerance says nothing about ids.
    right = frame();
    right.id[0] = 5;
    let loose = Tolerance {
        max_ulp: u32::MAX,
        max_abs: f64::INFINITY,
        different_pixels: 0,
    };
    assert!(!compare_frames(&frame(), &right, &loose).unwrap().pass);
}

#[test]
fn a_tolerance_that_is_no_number_is_refused() {
    for max_abs in [f64::NAN, -1.0] {
        let tolerance = Tolerance { max_abs, ..EXACT };
        let error = compare_frames(&frame(), &frame(), &tolerance).unwrap_err();
        assert!(matches!(error, Error::Usage(_)), "{error}");
    }
}

#[test]
fn sizes_that_differ_are_named() {
    let error = compare_frames(&frame(), &Frame::new(4, 1).unwrap(), &EXACT).unwrap_err();
    assert!(matches!(error, Error::Usage(_)));
    let said = error.to_string();
    assert!(said.contains("2 x 2") && said.contains("4 x 1"), "{said}");
}

#[test]
fn a_frame_of_the_wrong_length_is_refused() {
    let mut broken = frame();
    broken.id.pop();
    assert!(matches!(
        compare_frames(&frame(), &broken, &EXACT),
        Err(Error::Usage(_))
    ));
    assert!(matches!(
        compare_frames(&broken, &frame(), &EXACT),
        Err(Error::Usage(_))
    ));
}

#[test]
fn json_has_the_fields_that_scripts_rely_on() {
    let json = serde_json::to_value(compare(&frame(), &frame())).unwrap();
    let fields = [
        "pixels",
        "different_pixels",
        "max_abs",
        "rmse",
        "psnr_db",
        "flip",
        "id_mismatches",
        "max_ulp",
        "pass",
        "left",
        "right",
        "tolerance",
        "layers",
    ];
    for field in fields {
        assert!(json.get(field).is_some(), "{field} in {json}");
    }
}

#[test]
fn sums_do_not_depend_on_threads() {
    let mut left = Frame::new(311, 97).unwrap();
    let mut right = left.clone();
    for i in 0..left.pixels() {
        left.color[i] = [(i as f32).sin(), 0.3, (i as f32 * 0.7).cos()];
        right.color[i] = [(i as f32 * 1.01).sin(), 0.1, 0.0];
    }
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| compare(&left, &right))
    };
    assert_eq!(on(1), on(7));
}

#[test]
fn a_difference_picture_is_black_where_all_bits_are_equal() {
    let black = |rgb: &[u8]| rgb.iter().all(|c| *c == 0);
    for map in [DifferenceMap::Flip, DifferenceMap::Absolute] {
        let rgb = difference_of_frames(&frame(), &frame(), map).unwrap();
        assert_eq!(rgb.len(), 12);
        assert!(black(&rgb));

        // A bit in a layer beside colour is seen, and nothing else is.
        let mut right = frame();
        next_up(&mut right.position[2][0]);
        let rgb = difference_of_frames(&frame(), &right, map).unwrap();
        assert!(
            black(&rgb[..6]) && black(&rgb[9..]) && !black(&rgb[6..9]),
            "{rgb:?}"
        );
    }
}

#[test]
fn the_greatest_difference_is_palest() {
    let mut right = frame();
    right.color[0][0] += 0.125;
    right.color[1][0] += 0.25;
    right.color[2][0] = f32::NAN;
    let rgb = difference_of_frames(&frame(), &right, DifferenceMap::Absolute).unwrap();
    let brightness = |i: usize| {
        rgb[3 * i..3 * i + 3]
            .iter()
            .map(|c| u32::from(*c))
            .sum::<u32>()
    };
    assert!(brightness(3) == 0 && 0 < brightness(0) && brightness(0) < brightness(1));
    assert_eq!(brightness(1), brightness(2));
}
