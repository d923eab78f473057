//! Shaders in two f32 on the GPU against the same kernel in Rust, bit for bit.

use std::collections::HashMap;

use crate::gpu::device::Gpu;
use crate::gpu::exact::forbid_contraction;
use crate::gpu::program::{Program, Source};
use crate::gpu::samples::hash;
use crate::gpu::selfcheck::{output, read, run};
use crate::gpu::spirv::{HEADER, instructions};
use crate::kernel::camera::Ray;
use crate::kernel::real::Real;
use crate::kernel::sphere::{intersect_sphere, sphere_normal, sphere_point};
use crate::kernel::triangle::{intersect_triangle, shear_of, triangle_normal, triangle_weights};
use crate::kernel::two_float::TwoFloat;
use crate::kernel::vector::Vec3;
use crate::layout::{Sphere, Triangle};
use crate::tier::Width;

macro_rules! shader {
    ($name:literal) => {
        Source::new($name, include_str!(concat!("../../../shaders/", $name)))
    };
}

pub(super) const TWO_FLOAT: Source = shader!("two_float.wgsl");

const FILES: [Source; 6] = [
    shader!("divide_native.wgsl"),
    shader!("vector.wgsl"),
    shader!("near_spheres_off.wgsl"),
    shader!("sphere.wgsl"),
    shader!("triangle.wgsl"),
    PRELUDE,
];

pub(super) const PRELUDE: Source = Source::new(
    "prelude",
    "
        alias real = f64;
        const MISS: real = 3.4028234663852886e38;
        struct Ray { origin: vec3<real>, direction: vec3<real> }
        struct Sphere { center: vec3<real>, radius: real, power: real }
        struct Triangle { a: vec3<real>, b: vec3<real>, c: vec3<real> }
        fn divide_f32(a: f32, b: f32) -> f32 { return a / b; }
        fn square_root_f32(a: f32) -> f32 { return sqrt(a); }
        fn copy_sign(magnitude: real, sign: real) -> real {
            let size = abs(magnitude);
            return select(size, -size, sign < 0.0);
        }
        fn real_of_parts(high: f32, low: f32) -> real { return real(high) + real(low); }
        fn parts_of_real(value: real) -> vec2<f32> {
            let high = f32(value);
            return vec2<f32>(high, f32(value - real(high)));
        }
        @group(0) @binding(0) var<storage, read> inputs: array<vec2<f32>>;
        @group(0) @binding(1) var<storage, read_write> results: array<vec2<f32>>;
        fn number_at(index: u32) -> real { return real_of_parts(inputs[index].x, inputs[index].y); }
        fn vector_at(index: u32) -> vec3<real> {
            return vec3<real>(number_at(index), number_at(index + 1u), number_at(index + 2u));
        }
        fn keep(index: u32, value: real) { results[index] = parts_of_real(value); }
        fn keep_vector(index: u32, value: vec3<real>) {
            for (var i = 0u; i < 3u; i++) { keep(index + i, value[i]); }
        }",
);

/// Ray, sphere and triangle; what is found there.
const TRACE: Source = Source::new(
    "trace",
    "
        @compute @workgroup_size(64)
        fn calculate(@builtin(global_invocation_id) at: vec3<u32>) {
            let first = 19u * at.x;
            if first >= arrayLength(&inputs) { return; }
            let ray = Ray(vector_at(first), vector_at(first + 3u));
            let sphere = Sphere(vector_at(first + 6u), number_at(first + 9u), MISS);
            let triangle = Triangle(
                vector_at(first + 10u), vector_at(first + 13u), vector_at(first + 16u));
            let t = intersect_sphere(ray, sphere);
            let normal = sphere_normal(ray, sphere, t);
            let out = 14u * at.x;
            keep(out, t);
            keep_vector(out + 1u, normal);
            keep_vector(out + 4u, sphere_point(ray, sphere, normal, t));
            keep(out + 7u, intersect_triangle(ray, shear_of(ray), triangle));
            keep_vector(out + 8u, triangle_weights(ray, triangle));
            keep_vector(out + 11u, triangle_normal(triangle));
        }",
);

pub(super) fn open() -> Gpu {
    Gpu::open(None).unwrap_or_else(|error| panic!("{error}"))
}

pub(super) fn program(two_float: Source, entry: Source) -> Program {
    let mut files = FILES.to_vec();
    files.extend([two_float, entry]);
    Program::in_width(&files, Width::Extended).unwrap_or_else(|error| panic!("{error}"))
}

pub(super) fn calculate(
    gpu: &Gpu,
    program: &Program,
    inputs: &[TwoFloat],
    count: usize,
) -> Vec<TwoFloat> {
    let kernel = gpu.compile(program).unwrap();
    let uploaded = gpu.upload("inputs", bytemuck::cast_slice(inputs)).unwrap();
    let results = output(gpu, "results", 8 * count as u64).unwrap();
    let uniforms = UNIFORMS.map(TwoFloat::from_f64);
    let uniforms = gpu.upload_uniform("uniforms", bytemuck::bytes_of(&uniforms));
    let buffers = HashMap::from([
        ("inputs", uploaded),
        ("results", results),
        ("uniforms", uniforms.unwrap()),
    ]);
    run(gpu, &kernel, "calculate", &buffers, RAYS.div_ceil(64)).unwrap();
    read(gpu, &buffers["results"], count).unwrap()
}

/// Two vectors, each with a number after it.
pub(super) const UNIFORMS: [f64; 8] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];

/// Numbers that have other bits; any NaN equals any other.
pub(super) fn differences(found: &[TwoFloat], expected: &[TwoFloat]) -> usize {
    assert_eq!(found.len(), expected.len());
    let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    let pairs = found.iter().zip(expected);
    pairs
        .filter(|(a, b)| !(same(a.high, b.high) && same(a.low, b.low)))
        .count()
}

pub(super) const RAYS: u32 = 10_048;

/// A number from -1 to 1, of 48 bits.
pub(super) fn random(seed: u32) -> f64 {
    let bits = u64::from(hash(2 * seed)) << 32 | u64::from(hash(2 * seed + 1));
    (bits as i64 >> 16) as f64 / 2.0_f64.powi(47)
}

/// Rays from near the origin at a sphere and a triangle ahead, of many sizes.
fn scenes() -> Vec<TwoFloat> {
    let mut inputs = Vec::new();
    for ray in 0..RAYS {
        let number = |salt: u32| random(32 * ray + salt);
        let vector = |salt: u32| [0, 1, 2].map(|axis| number(salt + axis));
        let ahead = |salt: u32| {
            let [x, y, z] = vector(salt);
            [x, y, z - 3.0]
        };
        let [x, y, _] = vector(3);
        let scale = 2.0_f64.powi((hash(ray) % 24) as i32 - 12);
        let lengths = [ahead(6).to_vec(), vec![number(9).abs() + 0.25]];
        let corners = [ahead(10), ahead(13), ahead(16)];
        inputs.extend(vector(0).map(|x| 0.1 * scale * x));
        inputs.extend([0.3 * x, 0.3 * y, -1.0]);
        inputs.extend(lengths.concat().iter().map(|x| scale * x));
        inputs.extend(corners.concat().iter().map(|x| scale * x));
    }
    inputs.into_iter().map(TwoFloat::from_f64).collect()
}

/// What `TRACE` does, in Rust, and how many spheres and triangles are hit.
fn on_cpu<R: Real>(inputs: &[R]) -> (Vec<R>, [usize; 2]) {
    let mut results = Vec::new();
    let mut hits = [0; 2];
    for input in inputs.chunks(19) {
        let vector = |at: usize| [input[at], input[at + 1], input[at + 2]];
        let ray = Ray {
            origin: Vec3::from(vector(0)),
            direction: Vec3::from(vector(3)),
        };
        let (center, radius) = (vector(6), input[9]);
        let sphere = Sphere::new(center, radius);
        let triangle = Triangle {
            a: vector(10),
            b: vector(13),
            c: vector(16),
            ..Default::default()
        };
        let t = intersect_sphere(ray, &sphere);
        let normal = sphere_normal(ray, &sphere, t);
        results.push(t);
        results.extend(<[R; 3]>::from(normal));
        results.extend(<[R; 3]>::from(sphere_point(ray, &sphere, normal, t)));
        let t_triangle = intersect_triangle(ray, shear_of(ray), &triangle);
        results.push(t_triangle);
        results.extend(<[R; 3]>::from(triangle_weights(ray, &triangle)));
        results.extend(<[R; 3]>::from(triangle_normal(&triangle)));
        hits[0] += usize::from(t < R::MISS);
        hits[1] += usize::from(t_triangle < R::MISS);
    }
    (results, hits)
}

#[test]
fn the_gpu_has_the_bits_of_the_twin() {
    let gpu = open();
    if !gpu.is_bit_exact() {
        return;
    }
    let inputs = scenes();
    let (expected, hits) = on_cpu(&inputs);
    println!("of {RAYS} rays {hits:?} hit");
    assert!(hits.iter().all(|hits| *hits > 300), "{hits:?}");
    let mut program = program(TWO_FLOAT, TRACE);
    let found = calculate(&gpu, &program, &inputs, expected.len());
    assert_eq!(differences(&found, &expected), 0, "of {}", expected.len());

    // The controls: floats that need not be kept as written, and a changed formula.
    program.spirv = without_no_contraction(&program.spirv);
    let loose = calculate(&gpu, &program, &inputs, expected.len());
    let sloppy = calculate(&gpu, &changed(), &inputs, expected.len());
    for found in [loose, sloppy] {
        let different = differences(&found, &expected);
        println!("control: {different} of {}", expected.len());
        assert!(different > expected.len() / 100, "{different}");
    }
}

/// With a product that leaves out its last term.
fn changed() -> Program {
    let (last, without) = ("product.y + across", "product.y + a.x * b.y");
    assert_eq!(TWO_FLOAT.text.matches(last).count(), 1);
    let text = TWO_FLOAT.text.replace(last, without).leak();
    program(Source { text, ..TWO_FLOAT }, TRACE)
}

fn without_no_contraction(spirv: &[u32]) -> Vec<u32> {
    let mut loose = spirv[..HEADER].to_vec();
    let kept = instructions(spirv)
        .filter(|(_, opcode, words)| !(*opcode == 71 && words[2] == 42))
        .flat_map(|(_, _, words)| words.iter().copied());
    loose.extend(kept);
    assert_eq!(forbid_contraction(&loose), spirv);
    loose
}

/// The kernel in two f32 is nearer to that in f64 than 2^-24 by far.
#[test]
fn two_f32_trace_almost_as_f64() {
    let inputs = scenes();
    let wide: Vec<f64> = inputs.iter().map(|x| exact(*x)).collect();
    let narrow: Vec<f32> = inputs.iter().map(|x| x.high).collect();
    let median = |distances: Vec<f64>| {
        let mut errors: Vec<f64> = distances.into_iter().filter(|e| e.is_finite()).collect();
        errors.sort_by(f64::total_cmp);
        errors[errors.len() / 2]
    };
    let (expected, _) = on_cpu(&wide);
    let error = |found: f64, expected: f64| ((found - expected) / expected).abs();
    let (two, _) = on_cpu(&inputs);
    let two = two.iter().zip(&expected).map(|(x, y)| error(exact(*x), *y));
    let (one, _) = on_cpu(&narrow);
    let one = one
        .iter()
        .zip(&expected)
        .map(|(x, y)| error(f64::from(*x), *y));
    let (two, one) = (median(two.collect()), median(one.collect()));
    println!("median errors: two f32 {two:e}, one {one:e}");
    assert!(two < 2.0_f64.powi(-44), "{two:e}");
    assert!(one > 2.0_f64.powi(-26), "the control: {one:e}");
}

pub(super) fn exact(a: TwoFloat) -> f64 {
    f64::from(a.high) + f64::from(a.low)
}
