//! `divide_corrected.wgsl` against Rust, on operators made looser than any
//! device's, and the self-check that calls for it.

use std::collections::HashMap;

use miette::Diagnostic;

use super::device::Gpu;
use super::program::{Program, Source};
use super::samples::{hash, quotient_near_midpoint, root_near_midpoint};
use super::selfcheck::{measure_f32, output, read, run};
use crate::effects::{DIVIDE_CORRECTED, Device, Entry, Fetch, select_files};
use crate::tier::{Formulas, Width};

const REAL: Source = Source::new("real", "alias real = f32;");

/// Operators that are off by -`MOST_OFF` to `MOST_OFF` ulp, as the inputs' bits say.
const LOOSE: &str = "
    fn moved(exact: f32, a: f32, b: f32) -> f32 {
        var bits = (bitcast<u32>(a) ^ (bitcast<u32>(b) * 0x9e3779b9u)) * 0x85ebca6bu;
        bits = (bits ^ (bits >> 15u)) * 0xc2b2ae35u;
        let off = i32((bits >> 16u) % (2u * MOST_OFF + 1u)) - i32(MOST_OFF);
        return bitcast<f32>(bitcast<i32>(exact) + select(off, 0, exact == 0.0));
    }";

/// Both operations as they stand in the file, and the operators beneath them.
const KERNEL: Source = Source::new(
    "divide_tests",
    "
        @group(0) @binding(0) var<storage, read> inputs: array<vec2<u32>>;
        @group(0) @binding(1) var<storage, read_write> results: array<vec4<u32>>;
        @compute @workgroup_size(64)
        fn calculate(@builtin(global_invocation_id) at: vec3<u32>) {
            if at.x >= arrayLength(&inputs) { return; }
            let a = bitcast<f32>(inputs[at.x].x);
            let b = bitcast<f32>(inputs[at.x].y);
            results[at.x] = bitcast<vec4<u32>>(
                vec4(divide(a, b), square_root(a), native_quotient(a, b), native_root(a)));
        }",
);

/// What does not equal Rust's bits; any NaN equals any other.
#[derive(Debug, Default, PartialEq)]
struct Wrong {
    quotients: usize,
    roots: usize,
    native_quotients: usize,
    native_roots: usize,
    first: Option<String>,
}

impl Wrong {
    fn note(&mut self, a: f32, b: f32, results: &[f32; 4]) {
        let expected = [a / b, a.sqrt(), a / b, a.sqrt()];
        let [quotient, root, native_quotient, native_root] = std::array::from_fn(|i| {
            let same = results[i].to_bits() == expected[i].to_bits();
            !(same || (results[i].is_nan() && expected[i].is_nan()))
        });
        self.quotients += usize::from(quotient);
        self.roots += usize::from(root);
        self.native_quotients += usize::from(native_quotient);
        self.native_roots += usize::from(native_root);
        if quotient || root {
            let text = || format!("{a:e}, {b:e}: {results:?}, not {expected:?}");
            self.first.get_or_insert_with(text);
        }
    }
}

/// The file with its operators up to `most_off` ulp off.
fn loosened(most_off: u32) -> Source {
    let mut text = DIVIDE_CORRECTED.text.to_string();
    for (plain, loose) in [
        ("return a / b;", "return moved(a / b, a, b);"),
        ("return sqrt(a);", "return moved(sqrt(a), a, 1.0);"),
    ] {
        assert_eq!(text.matches(plain).count(), 1, "places of `{plain}`");
        text = text.replace(plain, loose);
    }
    text += &LOOSE.replace("MOST_OFF", &format!("{most_off}u"));
    Source::new(DIVIDE_CORRECTED.name, text.leak())
}

fn calculate(gpu: &Gpu, divide: Source, inputs: &[[f32; 2]]) -> Wrong {
    let program = Program::build(&[REAL, divide, KERNEL]).unwrap();
    let kernel = gpu.compile(&program).unwrap();
    let mut wrong = Wrong::default();
    for inputs in inputs.chunks(1 << 18) {
        let uploaded = gpu.upload("inputs", bytemuck::cast_slice(inputs)).unwrap();
        let results = output(gpu, "results", 16 * inputs.len() as u64).unwrap();
        let buffers = HashMap::from([("inputs", uploaded), ("results", results)]);
        let workgroups = inputs.len().div_ceil(64) as u32;
        run(gpu, &kernel, "calculate", &buffers, workgroups).unwrap();
        let results: Vec<[f32; 4]> = read(gpu, &buffers["results"], inputs.len()).unwrap();
        for (&[a, b], results) in inputs.iter().zip(&results) {
            wrong.note(a, b, results);
        }
    }
    wrong
}

/// Over a million pairs of numbers; roots are taken of the first.
fn inputs() -> Vec<[f32; 2]> {
    let mut inputs = special_inputs();
    for index in 0..1 << 20_u32 {
        let random = [hash(2 * index), hash(2 * index + 1)];
        inputs.push(random.map(f32::from_bits));
    }
    for index in 0..1 << 16_u32 {
        let random = hash(index);
        // Midpoints stay midpoints under powers of two, roots under even ones.
        let power = |exponent: u32| f32::from_bits((64 + exponent % 126) << 23);
        let (a, b) = quotient_near_midpoint(random);
        inputs.push([a * power(random), b * power(random >> 8)]);
        inputs.push([
            root_near_midpoint(index as i32 - (1 << 15)) * power(2 * (random >> 9) + 1),
            b,
        ]);
        // Denormal quotients, half of them ties: odd multiples of half the smallest.
        let (multiple, divisor) = (f64::from(random & 0x7fff), f64::from(random >> 24 | 1));
        let scale = 2_f64.powi(1 + (random >> 15) as i32 % 100);
        let dividend = multiple * divisor * scale * f64::from(f32::from_bits(1)) / 2.0;
        assert_eq!(f64::from(dividend as f32), dividend, "no digit is lost");
        inputs.push([dividend as f32, (divisor * scale) as f32]);
        // Denormal numbers and small quotients of all sizes.
        let small = f32::from_bits(hash(!index) >> (8 + index % 24));
        inputs.push([small, f32::from_bits(random & 0x807f_ffff | 0x3e80_0000)]);
        inputs.push([small, f32::from_bits(hash(random) >> (8 + random % 24))]);
        inputs.push([near_short(random), near_short(hash(random))]);
    }
    inputs
}

/// Every pair of zeros, infinities, NaN, and the first and last numbers of many
/// powers of two, denormal ones too, of either sign.
fn special_inputs() -> Vec<[f32; 2]> {
    let mut special = vec![0, 0x7f80_0000, 0x7f80_0001, 0x7fc0_0000, 0x7fff_ffff];
    special.extend((0..23).flat_map(|bit| [1 << bit, (1 << bit) + 1, (2 << bit) - 1]));
    let exponents = (1..=8)
        .chain((9..247).step_by(9))
        .chain(247..=254)
        .chain(126..=130);
    special.extend(exponents.flat_map(|e| [0, 1, 0x7f_fffe, 0x7f_ffff].map(|f| (e << 23) + f)));
    let signed = special.iter().flat_map(|&bits| [bits, bits | 0x8000_0000]);
    let signed: Vec<f32> = signed.map(f32::from_bits).collect();
    signed
        .iter()
        .flat_map(|&a| signed.iter().map(move |&b| [a, b]))
        .collect()
}

/// A number up to two away from one with 11 bits or fewer, of any exponent.
fn near_short(random: u32) -> f32 {
    let short = (random << 3) & 0x7fff_ffff & (!0 << (13 + random % 12));
    f32::from_bits(short.wrapping_add(random >> 30).wrapping_sub(1))
}

fn open() -> Gpu {
    Gpu::open(None).unwrap_or_else(|error| match error.help() {
        Some(help) => panic!("{error}; {help}"),
        None => panic!("{error}"),
    })
}

#[test]
fn loose_operators_are_corrected_to_the_last_bit() {
    let mut gpu = open();
    let inputs = inputs();
    assert!(inputs.len() > 1_000_000);
    for most_off in [1, 4, 30] {
        let wrong = calculate(&gpu, loosened(most_off), &inputs);
        assert_eq!(
            (wrong.quotients, wrong.roots),
            (0, 0),
            "{most_off} ulp: {wrong:?}"
        );
        // The control. One of three offsets is none; half of the roots are NaN.
        assert!(
            wrong.native_quotients > inputs.len() / 2,
            "{most_off} ulp: {wrong:?}"
        );
        assert!(
            wrong.native_roots > inputs.len() / 4,
            "{most_off} ulp: {wrong:?}"
        );
    }
    let wrong = calculate(&gpu, loosened(1000), &inputs);
    assert!(
        wrong.quotients > 0 && wrong.roots > 0,
        "beyond what is promised: {wrong:?}"
    );

    // Nothing in the correction relies on floats that are kept as written.
    gpu.give_up_exactness().unwrap();
    let wrong = calculate(&gpu, loosened(4), &inputs);
    assert_eq!(
        (wrong.quotients, wrong.roots),
        (0, 0),
        "contracted: {wrong:?}"
    );
}

#[test]
fn the_correction_fits_beside_every_other_file() {
    let device = Device {
        divide: DIVIDE_CORRECTED,
        fetch: Fetch::Storage,
        count: false,
        formulas: Formulas::Stable,
        width: Width::Single,
        entry: Entry::Tile,
    };
    Program::build(&select_files(|_| true, device)).unwrap();
    // The control: the names of one file twice.
    assert!(Program::build(&[REAL, DIVIDE_CORRECTED, DIVIDE_CORRECTED]).is_err());
}

/// A quotient and a root with one residual step: all but correctly rounded.
const NEARLY: Source = Source::new(
    "nearly",
    "
        fn product_error(a: f32, b: f32, product: f32) -> f32 {
            let a_high = bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
            let b_high = bitcast<f32>(bitcast<u32>(b) & 0xfffff000u);
            let a_low = a - a_high;
            let b_low = b - b_high;
            return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
        }
        fn divide(a: f32, b: f32) -> f32 {
            let reciprocal = 1.0 / b;
            let quotient = a * reciprocal;
            let product = quotient * b;
            let residual = (a - product) - product_error(quotient, b, product);
            return quotient + residual * reciprocal;
        }
        fn square_root(a: f32) -> f32 {
            let root = bitcast<f32>(bitcast<u32>(sqrt(a)) + 1u);
            let square = root * root;
            let residual = (a - square) - product_error(root, root, square);
            return root + residual * (0.5 / root);
        }
        fn native_quotient(a: f32, b: f32) -> f32 { return a * (1.0 / b); }
        fn native_root(a: f32) -> f32 { return a * inverseSqrt(a); }",
);

#[test]
fn only_midpoints_tell_a_nearly_correct_division() {
    let gpu = open();
    // Significands alone, so that no residual is denormal.
    let significand = |salt: u32| f32::from_bits((hash(salt) & 0xff_ffff) | 0x3f00_0000);
    let random = |i: u32| [significand(2 * i), significand(2 * i + 1)];
    let random: Vec<[f32; 2]> = (0..1 << 20).map(random).collect();
    let wrong = calculate(&gpu, NEARLY, &random);
    // None where the operators beneath are right, one in some 10^5 where loose.
    let rare = random.len() >> 14;
    assert!(wrong.quotients < rare && wrong.roots < rare, "{wrong:?}");
    assert!(
        wrong.native_quotients > 0 && wrong.native_roots > 0,
        "{wrong:?}"
    );

    let hard: Vec<[f32; 2]> = (0..1 << 12)
        .map(|i| quotient_near_midpoint(hash(i)).into())
        .collect();
    let wrong = calculate(&gpu, NEARLY, &hard);
    assert!(wrong.quotients > hard.len() / 32, "{wrong:?}");
}

/// A division that reckons with a reciprocal, and flushes it if it is denormal.
const FLUSHING: Source = Source::new(
    "flushing",
    "
        fn divide(a: f32, b: f32) -> f32 {
            return select(a / b, 0.0, abs(b) > 8.507059173023462e37);
        }
        fn square_root(a: f32) -> f32 { return sqrt(a); }",
);

#[test]
fn the_self_check_tells_loose_operators_from_corrected_ones() {
    let gpu = open();
    let measure = |divide: Source| {
        let arithmetic = measure_f32(&gpu, divide).unwrap();
        (arithmetic.division_ulp, arithmetic.sqrt_ulp)
    };
    assert_eq!(measure(DIVIDE_CORRECTED), (0, 0));
    assert_eq!(measure(loosened(4)), (0, 0));
    let (division_ulp, sqrt_ulp) = measure(NEARLY);
    assert!(division_ulp > 0 && sqrt_ulp > 0);
    assert!(measure(FLUSHING).0 > 0);
}
