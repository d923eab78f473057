//! What samples are made of: the bits on the GPU are those of the CPU.

use std::collections::HashMap;

use super::device::Gpu;
use super::program::Program;
use super::samples::hash;
use super::selfcheck::{output, read, run};
use super::source::Source;
use crate::kernel::angles::{polar_turn, polar_z, turn_of};
use crate::kernel::circle::{circle_point, disk_point};
use crate::kernel::exponential::{exponential, logarithm};
use crate::kernel::frame::{axes_around, cosine_direction, from_axes, to_axes};
use crate::kernel::numbers::{number, number_pair, numbers_of};
use crate::kernel::vector::{Vec3, unit_vector, vec3};

macro_rules! file {
    ($name:literal) => {
        Source::new($name, include_str!(concat!("../../shaders/", $name)))
    };
}

/// Results of an invocation, and their names.
const RESULTS: [&str; 22] = [
    "circle_point.x",
    "circle_point.y",
    "disk_point.x",
    "disk_point.y",
    "number_pair.x",
    "number_pair.y",
    "number",
    "exponential",
    "logarithm",
    "turn_of",
    "polar_turn",
    "polar_z",
    "cosine_direction.x",
    "cosine_direction.y",
    "cosine_direction.z",
    "to_axes.x",
    "to_axes.y",
    "to_axes.z",
    "from_axes.x",
    "from_axes.y",
    "from_axes.z",
    "numbers_of",
];

/// Each function once. The results are kept as bits.
const KERNEL: Source = Source::new(
    "sampling_tests",
    "
        struct Input {
            turn: f32,
            power: f32,
            positive: f32,
            height: f32,
            point: vec2<f32>,
            pair: vec2<f32>,
            normal: vec3<f32>,
            seed: u32,
            at: vec2<u32>,
            sample: u32,
            dimension: u32,
        }
        @group(0) @binding(0) var<storage, read> inputs: array<Input>;
        @group(0) @binding(1) var<storage, read_write> results: array<array<u32, 22>>;
        @compute @workgroup_size(64)
        fn calculate(@builtin(global_invocation_id) at: vec3<u32>) {
            if at.x >= arrayLength(&inputs) { return; }
            let input = inputs[at.x];
            let on_circle = bitcast<vec2<u32>>(circle_point(input.turn));
            let on_disk = bitcast<vec2<u32>>(disk_point(input.pair));
            let numbers = numbers_of(input.seed, input.at.x, input.at.y, input.sample);
            let pair = bitcast<vec2<u32>>(number_pair(numbers, input.dimension));
            let axes = axes_around(input.normal);
            let vector = vec3<f32>(input.point, input.height);
            let direction = bitcast<vec3<u32>>(cosine_direction(input.normal, input.pair));
            let told = bitcast<vec3<u32>>(to_axes(axes, vector));
            let back = bitcast<vec3<u32>>(from_axes(axes, vector.x, vector.y, vector.z));
            results[at.x] = array<u32, 22>(
                on_circle.x, on_circle.y,
                on_disk.x, on_disk.y,
                pair.x, pair.y,
                bitcast<u32>(number(numbers, input.dimension)),
                bitcast<u32>(exponential(input.power)),
                bitcast<u32>(logarithm(input.positive)),
                bitcast<u32>(turn_of(input.point.x, input.point.y)),
                bitcast<u32>(polar_turn(input.height)),
                bitcast<u32>(polar_z(input.turn)),
                direction.x, direction.y, direction.z,
                told.x, told.y, told.z,
                back.x, back.y, back.z,
                numbers.pixel + numbers.sample,
            );
        }",
);

#[repr(C)]
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Input {
    turn: f32,
    power: f32,
    positive: f32,
    height: f32,
    point: [f32; 2],
    pair: [f32; 2],
    normal: [f32; 3],
    seed: u32,
    at: [u32; 2],
    sample: u32,
    dimension: u32,
}

const INPUTS: u32 = 100_000;

/// From 0 up to but not 1.
fn unit(seed: u32) -> f32 {
    (hash(seed) >> 8) as f32 / 16_777_216.0
}

fn input(index: u32) -> Input {
    let random = |salt: u32| unit(16 * index + salt);
    let between = |salt: u32| random(salt) * 2.0 - 1.0;
    let tiny = |value: f32, index: u32| value * 2.0_f32.powi(-((index % 40) as i32));
    let normal = match index % 4 {
        0 => vec3(between(0), between(1), tiny(between(2), index)),
        1 => vec3(tiny(between(0), index), tiny(between(1), index), between(2)),
        2 => [0, 1, 2]
            .map(|axis| {
                if axis == index / 4 % 3 {
                    between(3).signum()
                } else {
                    0.0
                }
            })
            .into(),
        _ => vec3(between(0), between(1), between(2)),
    };
    // Each sixteenth at a corner, the middle or an edge of the square.
    let pair = match index % 16 {
        0 => [(index / 16 % 3) as f32 * 0.5, (index / 48 % 3) as f32 * 0.5],
        1 => [random(4), random(4)],
        _ => [random(4), random(5)],
    };
    Input {
        turn: if index < 33 {
            index as f32 / 32.0
        } else {
            random(6)
        },
        power: if index < 100 {
            -(index as f32)
        } else {
            tiny(-90.0 * random(7), index)
        },
        // Any positive normal number, or one near 1.
        positive: f32::from_bits(if index.is_multiple_of(2) {
            0x0080_0000 + hash(16 * index + 8) % 0x7f00_0000
        } else {
            0x3f00_0000 + hash(16 * index + 8) % 0x0100_0000
        }),
        height: match index {
            0..5 => index as f32 * 0.5 - 1.0,
            _ if index.is_multiple_of(8) => 1.0 - tiny(random(9), index),
            _ => between(9) * 1.01,
        },
        point: match index {
            0..9 => [(index % 3) as f32 - 1.0, (index / 3) as f32 - 1.0],
            _ => [between(10), tiny(between(11), index)],
        },
        pair,
        normal: unit_vector(normal).into(),
        seed: index % 7,
        at: [hash(16 * index + 12) % 4096, index % 2160],
        sample: if index.is_multiple_of(2) {
            index % 1024
        } else {
            hash(index)
        },
        dimension: index % 50,
    }
}

/// What the shader does, on the CPU.
fn on_cpu(input: &Input) -> Vec<u32> {
    let numbers = numbers_of(input.seed, input.at[0], input.at[1], input.sample);
    let normal = Vec3::from(input.normal);
    let axes = axes_around(normal);
    let [x, y, z] = [input.point[0], input.point[1], input.height];
    let mut floats = Vec::new();
    floats.extend(circle_point(input.turn));
    floats.extend(disk_point(input.pair));
    floats.extend(number_pair(numbers, input.dimension));
    floats.push(number(numbers, input.dimension));
    floats.push(exponential(input.power));
    floats.push(logarithm(input.positive));
    floats.push(turn_of(x, y));
    floats.push(polar_turn(z));
    floats.push(polar_z(input.turn));
    floats.extend(<[f32; 3]>::from(cosine_direction(normal, input.pair)));
    floats.extend(<[f32; 3]>::from(to_axes(axes, vec3(x, y, z))));
    floats.extend(<[f32; 3]>::from(from_axes(axes, x, y, z)));
    let mut bits: Vec<u32> = floats.into_iter().map(f32::to_bits).collect();
    bits.push(numbers.pixel.wrapping_add(numbers.sample));
    bits
}

fn files(gpu: &Gpu) -> Vec<Source> {
    vec![
        gpu.arithmetic.divide_file().in_f32(),
        file!("vector.wgsl").in_f32(),
        file!("numbers.wgsl"),
        file!("circle.wgsl"),
        file!("frame.wgsl"),
        file!("exponential.wgsl"),
        file!("angles.wgsl"),
        KERNEL,
    ]
}

/// How many of the inputs give other bits, of each result.
fn differences(gpu: &Gpu, files: &[Source], inputs: &[Input]) -> Vec<usize> {
    let program = Program::build(files).unwrap();
    let kernel = gpu.compile(&program).unwrap();
    let mut different = vec![0; RESULTS.len()];
    let bytes = (size_of::<u32>() * RESULTS.len() * inputs.len()) as u64;
    let uploaded = gpu.upload("inputs", bytemuck::cast_slice(inputs)).unwrap();
    let results = output(gpu, "results", bytes).unwrap();
    let buffers = HashMap::from([("inputs", uploaded), ("results", results)]);
    let workgroups = inputs.len().div_ceil(64) as u32;
    run(gpu, &kernel, "calculate", &buffers, workgroups).unwrap();
    let count = RESULTS.len() * inputs.len();
    let found: Vec<u32> = read(gpu, &buffers["results"], count).unwrap();
    for (input, found) in inputs.iter().zip(found.chunks(RESULTS.len())) {
        let expected = on_cpu(input);
        assert_eq!(expected.len(), found.len());
        for (result, (found, expected)) in found.iter().zip(&expected).enumerate() {
            different[result] += usize::from(found != expected);
        }
    }
    different
}

#[test]
fn every_bit_is_that_of_the_twin() {
    let gpu = Gpu::open(None).unwrap();
    if !gpu.is_bit_exact() {
        return;
    }
    let inputs: Vec<Input> = (0..INPUTS).map(input).collect();
    let different = differences(&gpu, &files(&gpu), &inputs);
    for (name, different) in RESULTS.iter().zip(&different) {
        assert_eq!(*different, 0, "{name}");
    }

    // The control: in each file one constant is changed a little, or an operand.
    for (name, plain, other, results) in [
        ("numbers.wgsl", "0x53a22864u", "0x53a22866u", 4..7),
        ("numbers.wgsl", "0xf0f0f0f0u", "0xf0f0f0e0u", 5..6),
        ("numbers.wgsl", " 1013904223u;", " 1013904222u;", 21..22),
        ("circle.wgsl", "-41.341747", "-41.34174", 0..4),
        ("circle.wgsl", "64.93914", "64.93915", 0..4),
        ("frame.wgsl", "1.0 - (", "1.0000001 - (", 12..15),
        ("frame.wgsl", "(-1.0, sign", "(-1.0000001, sign", 15..17),
        (
            "frame.wgsl",
            "(axes.along, v)",
            "(axes.along, v.xyx)",
            17..18,
        ),
        ("frame.wgsl", "along * z", "along * (z * 1.0000001)", 18..21),
        ("exponential.wgsl", "0.041668102", "0.04167", 7..8),
        ("exponential.wgsl", "0.20001231", "0.20002", 8..9),
        ("angles.wgsl", "0.031747796", "0.03175", 9..10),
        ("angles.wgsl", "0.023855526", "0.02386", 10..11),
        ("angles.wgsl", "turn * 0.5)", "turn * 0.50000006)", 11..12),
    ] {
        let mut files = files(&gpu);
        let file = files.iter_mut().find(|file| file.name == name).unwrap();
        assert!(file.text.contains(plain), "`{plain}` in {name}");
        file.text = file.text.replace(plain, other).leak();
        let different = differences(&gpu, &files, &inputs[..10_000]);
        for result in results {
            assert!(different[result] > 0, "{other}: {}", RESULTS[result]);
        }
    }
}
