use super::*;
use crate::frame::{Frame, Layer, write_rgb8};
use crate::scene::Transfer;
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use proptest::prelude::*;
use std::path::PathBuf;
use std::sync::LazyLock;

/// A frame with the values that are hard to keep.
fn hard_frame() -> Frame {
    let mut frame = Frame::new(5, 3).unwrap();
    let hard = [
        -0.0,
        f32::NAN,
        f32::from_bits(0x7F80_0001), // signalling
        f32::from_bits(0xFFC1_2345), // with a payload
        f32::NEG_INFINITY,
        f32::from_bits(1),
        f32::MAX,
        0.1,
    ];
    for i in 0..frame.pixels() {
        let value = |k: usize| hard[(i + k) % hard.len()];
        frame.color[i] = [value(0), value(1), value(2)];
        frame.depth[i] = value(3);
        frame.normal[i] = [value(4), value(5), value(6)];
        frame.position[i] = [value(7), value(8), value(9)];
        frame.id[i] = u32::MAX - i as u32;
    }
    frame
}

fn in_folder(name: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    (folder, path)
}

fn read_bytes(bytes: &[u8]) -> Result<Picture> {
    let (_folder, path) = in_folder("file");
    std::fs::write(&path, bytes).unwrap();
    read_image(&path)
}

fn exr_bytes(frame: &Frame, layers: &[Layer]) -> Vec<u8> {
    let (_folder, path) = in_folder("a.exr");
    frame.write_exr(&path, layers).unwrap();
    std::fs::read(path).unwrap()
}

fn png_bytes(data: &[u8], width: u32, height: u32, color: ExtendedColorType) -> Vec<u8> {
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes)
        .write_image(data, width, height, color)
        .unwrap();
    bytes
}

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|v| v.to_bits()).collect()
}

#[test]
fn exr_keeps_every_bit_of_every_layer() {
    let frame = hard_frame();
    let picture = read_bytes(&exr_bytes(&frame, &Layer::ALL)).unwrap();
    assert_eq!((picture.width, picture.height), (5, 3));
    let PictureValues::Linear {
        color: Some(color),
        channels,
    } = picture.values
    else {
        panic!("{picture:?}");
    };
    assert_eq!(bits(color.as_flattened()), bits(frame.color.as_flattened()));

    let names: Vec<&str> = channels.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "depth.Z",
            "id",
            "normal.X",
            "normal.Y",
            "normal.Z",
            "position.X",
            "position.Y",
            "position.Z"
        ]
    );
    let axis = |pixels: &[[f32; 3]], axis: usize| pixels.iter().map(|p| p[axis]).collect();
    for channel in channels {
        let floats: Vec<f32> = match channel.name.as_str() {
            "id" => {
                assert_eq!(channel.samples, Samples::Integer(frame.id.clone()));
                continue;
            }
            "depth.Z" => frame.depth.clone(),
            "normal.X" => axis(&frame.normal, 0),
            "normal.Y" => axis(&frame.normal, 1),
            "normal.Z" => axis(&frame.normal, 2),
            "position.X" => axis(&frame.position, 0),
            "position.Y" => axis(&frame.position, 1),
            _ => axis(&frame.position, 2),
        };
        let Samples::Float(read) = channel.samples else {
            panic!("{} holds integers", channel.name);
        };
        assert_eq!(bits(&read), bits(&floats), "{}", channel.name);
    }
}

#[test]
fn exr_holds_the_layers_asked_for_and_the_same_bytes_each_time() {
    let frame = hard_frame();
    let bytes = exr_bytes(&frame, &[Layer::Id, Layer::Id]);
    assert_eq!(bytes, exr_bytes(&frame, &[Layer::Id]));
    let picture = read_bytes(&bytes).unwrap();
    let PictureValues::Linear {
        color: None,
        channels,
    } = picture.values
    else {
        panic!("{picture:?}");
    };
    assert_eq!(channels.len(), 1);

    let (_folder, path) = in_folder("a.exr");
    let error = frame.write_exr(&path, &[]).unwrap_err();
    assert!(matches!(error, Error::Usage(_)) && !path.exists());
}

#[test]
fn png_reads_back_what_was_shown() {
    let frame = hard_frame();
    let (_folder, path) = in_folder("a.png");
    for layer in Layer::ALL {
        frame.write_png(&path, layer, Transfer::Srgb).unwrap();
        let picture = read_image(&path).unwrap();
        assert_eq!((picture.width, picture.height), (5, 3));
        let shown = frame.to_rgb8(layer, Transfer::Srgb);
        let codes = shown
            .chunks(3)
            .map(|p| [0, 1, 2].map(|i| 257 * u16::from(p[i])));
        let codes = codes.collect();
        assert_eq!(picture.values, PictureValues::Encoded { bits: 8, codes });
    }
}

#[test]
fn png_of_16_bits_and_of_greys() {
    let codes: [u16; 6] = [0, 1, 258, 40_000, 65_534, 65_535];
    let native: Vec<u8> = codes.iter().flat_map(|c| c.to_ne_bytes()).collect();
    let file = png_bytes(&native, 2, 1, ExtendedColorType::Rgb16);
    let values = PictureValues::Encoded {
        bits: 16,
        codes: vec![[0, 1, 258], [40_000, 65_534, 65_535]],
    };
    assert_eq!(read_bytes(&file).unwrap().values, values);

    let file = png_bytes(&[7, 255], 2, 1, ExtendedColorType::L8);
    let values = PictureValues::Encoded {
        bits: 8,
        codes: vec![[7 * 257; 3], [65_535; 3]],
    };
    assert_eq!(read_bytes(&file).unwrap().values, values);
}

#[test]
fn only_opaque_png_files_are_read() {
    let file = png_bytes(
        &[1, 2, 3, 255, 4, 5, 6, 255],
        2,
        1,
        ExtendedColorType::Rgba8,
    );
    assert!(read_bytes(&file).is_ok());
    let file = png_bytes(
        &[1, 2, 3, 255, 4, 5, 6, 254],
        2,
        1,
        ExtendedColorType::Rgba8,
    );
    let said = read_bytes(&file).unwrap_err().to_string();
    assert!(said.contains("pixel 1, 0 is transparent"), "{said}");
}

#[test]
fn bytes_that_do_not_fit_the_size_are_refused() {
    let (_folder, path) = in_folder("a.png");
    for (width, height, length) in [(2, 2, 11), (0, 0, 3), (u32::MAX, u32::MAX, 0)] {
        let error = write_rgb8(&path, width, height, &vec![0; length]).unwrap_err();
        assert!(matches!(error, Error::Usage(_)), "{error}");
    }
    let mut frame = hard_frame();
    frame.depth.pop();
    assert!(
        frame
            .write_png(&path, Layer::Depth, Transfer::Srgb)
            .is_err()
    );
    assert!(frame.write_exr(&path, &Layer::ALL).is_err());
    assert!(!path.exists());
}

#[test]
fn what_is_no_picture_says_so() {
    let (folder, path) = in_folder("missing.png");
    let cases = [
        (read_image(&path), "No such file"),
        (read_image(folder.path()), "not a regular file"),
        (read_image(Path::new("/dev/zero")), "not a regular file"),
        (read_bytes(b""), "neither a PNG nor an EXR"),
        (read_bytes(b"GIF89a"), "neither a PNG nor an EXR"),
        (read_bytes(PNG_SIGNATURE), "broken PNG"),
        (read_bytes(EXR_SIGNATURE), "broken EXR"),
    ];
    for (result, why) in cases {
        let error = result.unwrap_err();
        assert!(matches!(error, Error::Asset { .. }), "{error}");
        assert!(error.to_string().contains(why), "{error}");
    }
}

#[test]
fn a_size_that_only_the_header_has_is_refused() {
    // Width and height of a PNG are bytes 16 to 24, followed by 5 bytes and the
    // check sum of the chunk.
    let mut file = png_bytes(&[0; 3], 1, 1, ExtendedColorType::Rgb8);
    file[16..24].copy_from_slice(&[0, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF]);
    let sum = crc32(&file[12..29]).to_be_bytes();
    file[29..33].copy_from_slice(&sum);
    let error = read_bytes(&file).unwrap_err();
    assert!(matches!(error, Error::Limit(_)), "{error}");
    assert!(
        error.to_string().contains("16777215 x 2147483647"),
        "{error}"
    );
}

/// PNG specification, annex D.
fn crc32(bytes: &[u8]) -> u32 {
    let fold = |sum: u32, byte: &u8| {
        (0..8).fold(sum ^ u32::from(*byte), |s, _| {
            (s >> 1) ^ (0xEDB8_8320 * (s & 1))
        })
    };
    !bytes.iter().fold(u32::MAX, fold)
}

#[test]
fn truncated_files_are_errors_at_every_length() {
    let files = [
        exr_bytes(&hard_frame(), &Layer::ALL),
        png_bytes(&[9; 300], 10, 10, ExtendedColorType::Rgb8),
    ];
    // The last chunk of a PNG, 12 bytes, holds nothing that is missed.
    for (file, optional) in files.iter().zip([0, 12]) {
        for length in 0..file.len() - optional {
            assert!(
                read_bytes(&file[..length]).is_err(),
                "{length} of {}",
                file.len()
            );
        }
        assert!(read_bytes(file).is_ok());
    }
}

static PNG: LazyLock<Vec<u8>> =
    LazyLock::new(|| png_bytes(&[9; 300], 10, 10, ExtendedColorType::Rgb8));
static EXR: LazyLock<Vec<u8>> = LazyLock::new(|| exr_bytes(&hard_frame(), &Layer::ALL));

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5000))]

    #[test]
    fn broken_files_never_panic(
        is_png: bool,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
        cut in prop::option::weighted(0.1, any::<prop::sample::Index>()),
    ) {
        let mut file = if is_png {
            PNG.clone()
        } else {
            EXR.clone()
        };
        for (at, byte) in changes {
            let at = at.index(file.len());
            file[at] = byte;
        }
        if let Some(cut) = cut {
            file.truncate(cut.index(file.len()));
        }
        // Any answer will do.
        let _ = decode(Path::new("broken"), &file);
    }
}
