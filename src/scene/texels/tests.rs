//! Each format there and back, and each refusal.

mod files;

use std::fs;

use image::ExtendedColorType;
use tempfile::TempDir;

use super::*;
use files::{exr_of, hdr_of, jpeg_of, png_of};

fn read_with(bytes: &[u8], options: &ImageOptions) -> Result<Texels> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("image");
    fs::write(&path, bytes).expect("a file");
    load(&path, options)
}

fn read(bytes: &[u8]) -> Texels {
    read_with(bytes, &ImageOptions::default()).expect("a readable image")
}

fn refusal_with(bytes: &[u8], options: &ImageOptions) -> String {
    let error = read_with(bytes, options).expect_err("a refusal");
    assert_eq!(error.exit_code(), 3, "{error}");
    error.to_string()
}

fn refusal(bytes: &[u8]) -> String {
    refusal_with(bytes, &ImageOptions::default())
}

/// IEC 61966-2-1, from its text.
fn iec(code: f64) -> f32 {
    let linear = if code <= 0.04045 {
        code / 12.92
    } else {
        ((code + 0.055) / 1.055).powf(2.4)
    };
    linear as f32
}

#[test]
fn every_png_code_is_decoded_by_the_formula() {
    let codes: Vec<u8> = (0..=255).flat_map(|c| [c, 255 - c, c / 2, c]).collect();
    let image = read(&png_of(&codes, 16, 16, ExtendedColorType::Rgba8));
    assert_eq!((image.width, image.height), (16, 16));
    for (texel, code) in image.texels.iter().zip(codes.as_chunks::<4>().0) {
        let [r, g, b, a] = code.map(|c| f64::from(c) / 255.0);
        assert_eq!(*texel, [iec(r), iec(g), iec(b), a as f32]);
    }
    let codes: Vec<u16> = (0..=u16::MAX).collect();
    let bytes = bytemuck::cast_slice(&codes);
    let image = read(&png_of(bytes, 256, 256, ExtendedColorType::L16));
    for (texel, code) in image.texels.iter().zip(codes) {
        let grey = iec(f64::from(code) / 65535.0);
        assert_eq!(*texel, [grey, grey, grey, 1.0]);
    }
}

#[test]
fn rows_run_from_the_top() {
    let codes = [
        255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 9, 9, 9,
    ];
    let image = read(&png_of(&codes, 3, 2, ExtendedColorType::Rgb8));
    assert_eq!(image.texels[2], [0.0, 0.0, 1.0, 1.0]);
    assert_eq!(image.texels[3], [1.0; 4]);
    assert!(image.name.ends_with("image"));
}

#[test]
fn a_jpeg_of_one_color_keeps_it() {
    for (bytes, kind) in [
        ([200_u8, 30, 90].repeat(20 * 10), ExtendedColorType::Rgb8),
        (vec![77_u8; 20 * 10], ExtendedColorType::L8),
    ] {
        let image = read(&jpeg_of(&bytes, 20, 10, kind));
        assert_eq!((image.width, image.height), (20, 10));
        let code = |at: usize| f64::from(bytes[at.min(bytes.len() - 1)]);
        for texel in &image.texels {
            for (channel, wished) in texel.iter().zip(if bytes.len() == 200 {
                [code(0); 3]
            } else {
                [code(0), code(1), code(2)]
            }) {
                // The way to luma and chroma and back rounds thrice.
                let within = |off: f64| iec((wished + off) / 255.0);
                assert!((within(-2.0)..=within(2.0)).contains(channel), "{texel:?}");
            }
            assert_eq!(texel[3], 1.0);
        }
    }
}

#[test]
fn hdr_and_exr_are_linear_as_they_are() {
    // Eight bits with a common exponent: these come back to the bit.
    let texels = [[1.0, 0.5, 0.25], [1000.0, 0.0, 96.0], [0.0; 3], [3.0; 3]];
    let image = read(&hdr_of(&texels, 2, 2));
    let opaque = texels.map(|[r, g, b]| [r, g, b, 1.0]);
    assert_eq!(image.texels, opaque);
    let other_name = [b"#?RGBE" as &[u8], &hdr_of(&texels, 2, 2)[10..]].concat();
    assert_eq!(read(&other_name).texels, opaque);

    let [r, g, b, a]: [&[f32]; 4] = [&[0.1, 7e9], &[0.2, 1e-40], &[0.3, 0.0], &[0.4, 1.0]];
    let image = read(&exr_of((2, 1), &[("R", r), ("G", g), ("B", b), ("A", a)]));
    assert_eq!((image.width, image.height), (2, 1));
    assert_eq!(image.texels, [[0.1, 0.2, 0.3, 0.4], [7e9, 1e-40, 0.0, 1.0]]);
    let image = read(&exr_of((1, 2), &[("Y", r)]));
    assert_eq!(image.texels, [[0.1, 0.1, 0.1, 1.0], [7e9, 7e9, 7e9, 1.0]]);
    assert!(refusal(&exr_of((1, 2), &[("depth.Z", r)])).contains("R, G and B"));
}

#[test]
fn a_texel_that_is_no_color_is_refused_with_its_place() {
    for wrong in [f32::NAN, f32::INFINITY, -0.5] {
        let red = [1.0, 1.0, 1.0, 1.0, 1.0, wrong];
        let rest: &[f32] = &[1.0; 6];
        let file = exr_of((3, 2), &[("R", &red), ("G", rest), ("B", rest)]);
        let message = refusal(&file);
        assert!(
            message.contains("the texel 2 from the left and 1 from the top"),
            "{message}"
        );
    }
}

#[test]
fn what_is_cut_off_is_refused() {
    let noise: Vec<u8> = (0..3 * 40 * 40_u32).map(|i| (i * i % 251) as u8).collect();
    let light: Vec<_> = noise
        .as_chunks::<3>()
        .0
        .iter()
        .map(|c| c.map(f32::from))
        .collect();
    let plane: Vec<f32> = noise[..1600].iter().map(|&c| f32::from(c)).collect();
    let rgb = ExtendedColorType::Rgb8;
    for file in [
        png_of(&noise, 40, 40, rgb),
        jpeg_of(&noise, 40, 40, rgb),
        hdr_of(&light, 40, 40),
        exr_of((40, 40), &[("Y", &plane)]),
    ] {
        read(&file);
        for part in [1, 3, 5, 9, 12, 19] {
            refusal(&file[..file.len() * part / 20]);
        }
    }
}

#[test]
fn garbage_is_refused_and_never_panics() {
    assert!(refusal(b"").contains("PNG, JPEG, OpenEXR or Radiance HDR"));
    assert!(refusal(b"GIF89a and so on").contains("PNG"));
    let plane = [0.5; 64];
    let files = [
        png_of(&[9; 192], 8, 8, ExtendedColorType::Rgb8),
        jpeg_of(&[9; 192], 8, 8, ExtendedColorType::Rgb8),
        hdr_of(&[[1.0; 3]; 64], 8, 8),
        exr_of((8, 8), &[("Y", &plane)]),
    ];
    for file in files {
        // Some damage goes unnoticed, as in a comment; none may do harm.
        for at in 0..file.len().min(600) {
            for value in [0, 0x7f, 0xff] {
                let mut damaged = file.clone();
                damaged[at] = value;
                if let Ok(image) = read_with(&damaged, &ImageOptions::default()) {
                    assert_eq!(image.check(), Ok(()));
                }
            }
        }
    }
}

#[test]
fn an_hdr_in_another_space_or_order_is_refused() {
    for line in [
        "FORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n",
        "\n+Y 1 +X 1\n",
        "\n+X 1 -Y 1\n",
    ] {
        for first in ["#?RADIANCE", "#?RGBE"] {
            let file = [first.as_bytes(), b"\n", line.as_bytes(), &[9; 4]].concat();
            refusal(&file);
        }
    }
}

#[test]
fn a_header_that_claims_much_takes_no_memory() {
    let mut png = png_of(&[9; 192], 8, 8, ExtendedColorType::Rgb8);
    png[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    // The header's checksum.
    let sum = crc(&png[12..29]);
    png[29..33].copy_from_slice(&sum.to_be_bytes());
    refusal(&png);
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n";
    assert!(refusal(hdr).contains("60000 x 60000 texels are more than the 8388608 allowed"));
    let mut jpeg = jpeg_of(&[9; 192], 8, 8, ExtendedColorType::Rgb8);
    let frame = jpeg
        .windows(2)
        .position(|w| w == [0xff, 0xc0])
        .expect("a frame");
    jpeg[frame + 5..frame + 9].copy_from_slice(&[0xff; 4]);
    assert!(refusal(&jpeg).contains("65535 x 65535 texels"));
}

/// The checksum of a PNG's chunk, bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    let step = |sum: u32| (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 };
    let byte = |sum: u32, b: &u8| (0..8).fold(sum ^ u32::from(*b), |sum, _| step(sum));
    !bytes.iter().fold(u32::MAX, byte)
}

#[test]
fn no_texels_are_refused() {
    let mut png = png_of(&[9; 192], 8, 8, ExtendedColorType::Rgb8);
    png[16..24].fill(0);
    let sum = crc(&png[12..29]);
    png[29..33].copy_from_slice(&sum.to_be_bytes());
    refusal(&png);
    refusal(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 4\n");
    assert!(Texels::default().check().is_err());
}

#[test]
fn limits_are_exact() {
    let file = png_of(&[9; 12], 2, 2, ExtendedColorType::Rgb8);
    let options = |max_bytes, max_texels| ImageOptions {
        max_bytes,
        max_texels,
        root: None,
    };
    let length = file.len() as u64;
    assert!(read_with(&file, &options(length, 4)).is_ok());
    assert!(refusal_with(&file, &options(length - 1, 4)).contains("bytes"));
    assert!(refusal_with(&file, &options(length, 3)).contains("2 x 2 texels are more than the 3"));
    let file = exr_of((2, 2), &[("Y", &[1.0; 4])]);
    assert!(
        refusal_with(&file, &options(u64::MAX, 3)).contains("2 x 2 texels are more than the 3")
    );
}

fn folder_with(names: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = png_of(&[9; 12], 2, 2, ExtendedColorType::Rgb8);
    for name in names {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("in the folder")).expect("a folder");
        fs::write(path, &file).expect("a file");
    }
    folder
}

#[test]
fn an_image_is_loaded_once_and_all_share_the_room() {
    let folder = folder_with(&["a.png", "b.png"]);
    let mut images = Images::new(ImageOptions {
        max_texels: 7,
        ..ImageOptions::default()
    });
    let first = images.load(&folder.path().join("a.png")).expect("an image");
    let again = images
        .load(&folder.path().join(".").join("a.png"))
        .expect("an image");
    assert!(Arc::ptr_eq(&first, &again));
    let error = images.load(&folder.path().join("b.png")).expect_err("full");
    let told = "2 x 2 texels beside 4 in other images are more than the 7 allowed";
    assert!(error.to_string().contains(told), "{error}");
}

#[test]
fn only_regular_files_under_the_root_are_read() {
    let folder = folder_with(&["out.png", "in/a.png"]);
    let options = ImageOptions {
        root: Some(folder.path().join("in")),
        ..ImageOptions::default()
    };
    let path = |name: &str| folder.path().join(name);
    assert!(load(&path("in/a.png"), &options).is_ok());
    let message = |name: &str| {
        load(&path(name), &options)
            .expect_err("refused")
            .to_string()
    };
    assert!(message("in/../out.png").contains("lies outside"));
    assert!(message("in/b.png").contains("no such file"));
    assert!(message("in").contains("a folder"));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(path("out.png"), path("in/link.png")).expect("a link");
        assert!(message("in/link.png").contains("lies outside"));
    }
}
