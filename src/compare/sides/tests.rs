use super::*;
use crate::compare::{compare_pictures, difference_of_pictures};

const BITS: Tolerance = Tolerance {
    max_ulp: 0,
    max_abs: 0.0,
    different_pixels: 0,
};

fn encoded(bits: u16, codes: &[[u16; 3]]) -> Picture {
    Picture {
        name: format!("{bits}.png"),
        width: codes.len() as u32,
        height: 1,
        values: PictureValues::Encoded {
            bits,
            codes: codes.to_vec(),
        },
    }
}

#[test]
fn codes_of_png_files_by_hand() {
    let left = encoded(8, &[[0, 0, 0], [257 * 100, 257 * 7, 65535]]);
    let right = encoded(8, &[[0, 0, 0], [257 * 103, 257 * 7, 65535]]);
    let found = compare_pictures(&left, &right, &BITS).unwrap();
    assert_eq!((found.left.as_str(), found.different_pixels), ("8.png", 1));
    // One code of 255 is one ulp; 3/255 apart in one of six values.
    assert_eq!(found.max_ulp, 3);
    assert_eq!(found.max_abs, 3.0 / 255.0);
    assert_eq!(found.rmse, ((3.0_f64 / 255.0).powi(2) / 6.0).sqrt());
    assert!(found.flip.unwrap() > 0.0 && !found.pass);
    assert!(compare_pictures(&left, &left, &BITS).unwrap().pass);

    let right = encoded(16, &[[0, 0, 0], [257 * 100 + 1, 257 * 7, 65535]]);
    let found = compare_pictures(&left, &right, &BITS).unwrap();
    assert_eq!((found.different_pixels, found.max_ulp), (1, 1));
    let tolerance = Tolerance { max_ulp: 1, ..BITS };
    assert!(compare_pictures(&left, &right, &tolerance).unwrap().pass);
}

fn linear(name: &str, color: Option<[f32; 3]>, channels: Vec<(&str, Samples)>) -> Picture {
    let channels = channels.into_iter();
    let channels = channels.map(|(name, samples)| Channel {
        name: name.into(),
        samples,
    });
    Picture {
        name: name.into(),
        width: 1,
        height: 1,
        values: PictureValues::Linear {
            color: color.map(|c| vec![c]),
            channels: channels.collect(),
        },
    }
}

#[test]
fn channels_of_exr_files_are_all_compared() {
    let depth = |z| ("depth.Z", Samples::Float(vec![z]));
    let id = |id| ("id", Samples::Integer(vec![id]));
    let left = linear("a", Some([1.0; 3]), vec![depth(4.0), id(7)]);
    let right = linear("b", Some([1.0; 3]), vec![depth(4.5), id(8)]);
    assert!(compare_pictures(&left, &left, &BITS).unwrap().pass);
    let found = compare_pictures(&left, &right, &BITS).unwrap();
    assert_eq!((found.different_pixels, found.id_mismatches), (1, 1));
    assert_eq!((found.max_abs, found.max_ulp), (0.0, 1 << 20));

    // Without colour, the figures are those of the floats there are.
    let left = linear("a", None, vec![depth(4.0), id(7)]);
    let right = linear("b", None, vec![depth(4.5), id(7)]);
    let found = compare_pictures(&left, &right, &BITS).unwrap();
    assert_eq!((found.max_abs, found.rmse, found.flip), (0.5, 0.5, None));
    assert!(!found.pass);
}

#[test]
fn files_that_do_not_hold_the_same_are_refused() {
    let depth = || ("depth.Z", Samples::Float(vec![1.0]));
    let pairs = [
        (
            linear("a", Some([0.0; 3]), vec![]),
            linear("b", None, vec![]),
            "b has no channel R, G, B",
        ),
        (
            linear("a", None, vec![]),
            linear("b", None, vec![depth()]),
            "a has no channel depth.Z",
        ),
        (
            linear("a", None, vec![("id", Samples::Float(vec![1.0]))]),
            linear("b", None, vec![("id", Samples::Integer(vec![1]))]),
            "channel 'id' holds floats in one",
        ),
        (
            linear("a", Some([0.0; 3]), vec![]),
            encoded(8, &[[0; 3]]),
            "a PNG and an EXR",
        ),
        (
            encoded(8, &[[0; 3]]),
            encoded(8, &[[0; 3]; 2]),
            "1 x 1 pixels and the right one 2 x 1",
        ),
    ];
    for (left, right, why) in pairs {
        let error = compare_pictures(&left, &right, &BITS).unwrap_err();
        assert!(matches!(error, Error::Usage(_)), "{error}");
        assert!(error.to_string().contains(why), "{error}");
        assert!(difference_of_pictures(&left, &right, DifferenceMap::Flip).is_err());
    }
}
