//! The shader files for a scene on a device.

use super::device::{DIVIDE_NATIVE, Device};
use super::{EFFECTS, Effect, file};
use crate::flat::Counts;
use crate::gpu::program::Source;
use crate::tier::{Formulas, Width};

/// Files that every scene needs.
const ALWAYS: &[Source] = &[
    file!("layout.wgsl"),
    file!("scene.wgsl"),
    file!("vector.wgsl"),
    file!("vector.wgsl").in_f32(),
    file!("camera.wgsl"),
    file!("aabb.wgsl"),
    file!("own_box.wgsl"),
    file!("offset.wgsl"),
    file!("probe.wgsl"),
    file!("hit.wgsl"),
    file!("doubt_off.wgsl"),
    file!("background.wgsl"),
    file!("lambert.wgsl"),
    file!("trace.wgsl"),
];

/// In place of which files a textbook's are taken.
const TEXTBOOK: &[(&str, Source)] = &[
    ("own_box.wgsl", file!("own_box_textbook.wgsl")),
    ("offset.wgsl", file!("offset_textbook.wgsl")),
    ("sphere.wgsl", file!("sphere_textbook.wgsl")),
    ("plane.wgsl", file!("plane_textbook.wgsl")),
    ("triangle.wgsl", file!("triangle_textbook.wgsl")),
];

/// In place of which files those are taken that bound their error.
const BOUNDED: &[(&str, Source)] = &[
    ("doubt_off.wgsl", file!("doubt_on.wgsl")),
    ("sphere_meeting.wgsl", file!("sphere_bounded.wgsl")),
    ("plane_meeting.wgsl", file!("plane_bounded.wgsl")),
    ("disk_meeting.wgsl", file!("disk_bounded.wgsl")),
    ("triangle_meeting.wgsl", file!("triangle_bounded.wgsl")),
];

/// The file with these formulas.
fn by_formulas(file: Source, formulas: Formulas) -> Source {
    let others = match formulas {
        Formulas::Textbook => TEXTBOOK,
        Formulas::Stable => &[],
        Formulas::Bounded => BOUNDED,
    };
    let other = others.iter().find(|(name, _)| *name == file.name);
    other.map_or(file, |(_, other)| *other)
}

/// The number type of the geometry.
fn real_file(width: Width) -> Source {
    match width {
        Width::Single => file!("real_f32.wgsl"),
        Width::Extended => file!("real_two.wgsl"),
        Width::Double => file!("real_f64.wgsl"),
    }
}

/// The shader files for a scene on a device, each once.
pub fn shader_files(counts: &Counts, device: Device) -> Vec<Source> {
    select_files(|effect| effect.is_called_for(counts), device)
}

/// The shader files with exactly the effects that `chosen` accepts.
pub fn select_files(chosen: impl Fn(&Effect) -> bool, device: Device) -> Vec<Source> {
    let divide = match device.width {
        Width::Single => device.divide,
        // Wider numbers are divided as the device does it, or by way of f32.
        Width::Extended | Width::Double => DIVIDE_NATIVE,
    };
    let mut files = vec![real_file(device.width)];
    files.extend(ALWAYS);
    if device.width == Width::Extended {
        files.push(file!("two_float.wgsl"));
    }
    files.extend([divide, device.divide.in_f32()]);
    files.push(device.fetch.file());
    files.extend(device.entry.files().into_iter().flatten());
    files.push(if device.count {
        file!("count_on.wgsl")
    } else {
        file!("count_off.wgsl")
    });
    for effect in EFFECTS {
        files.extend(effect.files(chosen(effect), device.entry));
    }
    let mut once: Vec<Source> = Vec::new();
    for file in files {
        let file = by_formulas(file, device.formulas);
        if !once.iter().any(|present| present.is_same(&file)) {
            once.push(file);
        }
    }
    without_stubs(once)
}

/// The files without those `X_off` for which another effect brings `X_on`.
fn without_stubs(files: Vec<Source>) -> Vec<Source> {
    let is_on = |stem: &str| {
        let on = |file: &Source| file.name.strip_suffix("_on.wgsl") == Some(stem);
        files.iter().any(on)
    };
    let is_stub = |file: &Source| file.name.strip_suffix("_off.wgsl").is_some_and(is_on);
    let kept = files.iter().filter(|file| !is_stub(file));
    kept.copied().collect()
}
