//! Each use of f64 that can be rewritten, and some that cannot.

use super::tests::{PRELUDE, RAYS, TWO_FLOAT, UNIFORMS, calculate, differences, exact, open};
use super::tests::{program, random};
use crate::effects::{DIVIDE_NATIVE, Device, Entry, Fetch, select_files};
use crate::gpu::program::{Program, Source};
use crate::gpu::samples::hash;
use crate::kernel::real::Real;
use crate::kernel::two_float::TwoFloat;
use crate::tier::{Formulas, Width};

/// Results of an invocation.
const RESULTS: usize = 35;

const OPERATIONS: Source = Source::new(
    "operations",
    "
        const TENTH: real = 0.1;
        const STEPS: vec3<real> = vec3<real>(0.5, TENTH, -3.0);
        struct Held { values: array<real, 3>, last: vec4<real> }
        struct Uniforms { right: vec3<real>, x: real, up: vec3<real> }
        @group(0) @binding(2) var<uniform> uniforms: Uniforms;
        var<private> total: vec2<real> = vec2<real>(0.1, 0.2);
        fn add_to(sum: ptr<function, real>, value: real) { *sum += value; }
        fn bits(a: real, b: real) -> u32 {
            return select(0u, 1u, a < b) + select(0u, 2u, a <= b) + select(0u, 4u, a > b)
                + select(0u, 8u, a >= b) + select(0u, 16u, a == b) + select(0u, 32u, a != b);
        }
        fn chosen(a: real, b: real, at: u32) -> real {
            switch at % 3u {
                case 0u: { return a - 1.0; }
                case 1u: { return -b; }
                default: {}
            }
            return TENTH;
        }
        @compute @workgroup_size(64)
        fn calculate(@builtin(global_invocation_id) at: vec3<u32>) {
            if 2u * at.x >= arrayLength(&inputs) { return; }
            let a = number_at(2u * at.x);
            let b = number_at(2u * at.x + 1u);
            let out = 35u * at.x;
            keep(out, a + b);
            keep(out + 1u, a - b);
            keep(out + 2u, a * b);
            keep(out + 3u, a / b);
            keep(out + 4u, sqrt(abs(a)));
            keep(out + 5u, min(a, b));
            keep(out + 6u, max(a, b));
            keep(out + 7u, real(bits(a, b) + 64u * bits(a, a)));
            keep(out + 8u, real(0xffffff00u + at.x % 256u));
            keep(out + 9u, real(f32(a)));
            keep(out + 10u, chosen(a, b, at.x));
            let steps = STEPS * a - b * STEPS;
            keep_vector(out + 11u, steps);
            let single = vec3<f32>(steps) * 0.1f;
            keep_vector(out + 14u, vec3<real>(single) / steps);
            var held = Held();
            held.values[1] = a;
            held.last = vec4<real>(steps.zx, vec2<real>(b));
            held.last.y *= 2.0;
            var sum: real = 0.3;
            for (var i = 0u; i < 3u; i++) { add_to(&sum, held.values[i] + held.last[i]); }
            keep(out + 17u, sum);
            var local = vec3<real>(0.1, 0.2, 0.3);
            local.z = held.last.w;
            keep_vector(out + 18u, select(local, -steps, a < b));
            keep_vector(out + 21u, select(local, steps, vec3<bool>(a == a, a != a, b < b)));
            total += vec2<real>(a, b);
            keep(out + 24u, total.x);
            keep(out + 25u, total[at.x % 2u]);
            keep_vector(out + 26u, abs(steps.yyx) + 1.0);
            keep_vector(out + 29u, max(steps, vec3<real>()));
            keep_vector(out + 32u, uniforms.right * uniforms.x + uniforms.up);
        }",
);

/// The same in Rust.
fn on_cpu(a: TwoFloat, b: TwoFloat, at: u32) -> Vec<TwoFloat> {
    let real = TwoFloat::from_f64;
    let tenth = real(0.1);
    let bits = |a: TwoFloat, b: TwoFloat| {
        [a < b, a <= b, a > b, a >= b, a == b, a != b]
            .iter()
            .rev()
            .fold(0, |bits, bit| 2 * bits + u32::from(*bit))
    };
    let least = |a, b| if b < a { b } else { a };
    let greatest = |a, b| if a < b { b } else { a };
    let chosen = match at % 3 {
        0 => a - real(1.0),
        1 => -b,
        _ => tenth,
    };
    let mut results = vec![a + b, a - b, a * b, a / b, a.abs().sqrt()];
    results.extend([least(a, b), greatest(a, b)]);
    results.push(TwoFloat::from_u32(bits(a, b) + 64 * bits(a, a)));
    results.push(TwoFloat::from_u32(0xffff_ff00 + at % 256));
    results.extend([real(f64::from(a.to_f32())), chosen]);
    let steps = [0.5, 0.1, -3.0].map(|step| real(step) * a - b * real(step));
    results.extend(steps);
    results.extend(steps.map(|step| real(f64::from(step.to_f32() * 0.1)) / step));
    let last = [steps[2], steps[0] * TwoFloat::TWO, b];
    let values = [TwoFloat::ZERO, a, TwoFloat::ZERO];
    let each = values.iter().zip(last);
    results.push(each.fold(real(0.3), |sum, (x, y)| sum + (*x + y)));
    let local = [tenth, real(0.2), b];
    results.extend(if a < b {
        steps.map(|step| -step)
    } else {
        local
    });
    results.extend([steps[0], local[1], local[2]]);
    let total = [tenth + a, real(0.2) + b];
    results.extend([total[0], total[at as usize % 2]]);
    let turned = [steps[1], steps[1], steps[0]];
    results.extend(turned.map(|step| step.abs() + real(1.0)));
    results.extend(steps.map(|step| greatest(step, TwoFloat::ZERO)));
    let [right, up] = [&UNIFORMS[..3], &UNIFORMS[4..]].map(|v| v.iter().copied().map(real));
    results.extend(
        right
            .zip(up)
            .map(|(right, up)| right * real(UNIFORMS[3]) + up),
    );
    results
}

/// Pairs of 2^-20 to 2^20; of every third one, the second is all but the first.
fn pairs() -> Vec<TwoFloat> {
    let pair = |index: u32| {
        let number = |seed| random(seed) * 2.0_f64.powi((hash(seed) % 40) as i32 - 20);
        let (a, b) = (number(2 * index), number(2 * index + 1));
        let near = a * (1.0 + f64::from(index % 5) * 2.0_f64.powi(-46));
        [a, if index.is_multiple_of(3) { near } else { b }].map(TwoFloat::from_f64)
    };
    (0..RAYS).flat_map(pair).collect()
}

#[test]
fn every_operation_has_the_bits_of_the_twin() {
    let gpu = open();
    if !gpu.is_bit_exact() {
        return;
    }
    let inputs = pairs();
    let each = inputs.chunks(2).zip(0..RAYS);
    let expected: Vec<TwoFloat> = each.flat_map(|(ab, at)| on_cpu(ab[0], ab[1], at)).collect();
    assert_eq!(expected.len(), RESULTS * RAYS as usize);
    let found = calculate(
        &gpu,
        &program(TWO_FLOAT, OPERATIONS),
        &inputs,
        expected.len(),
    );
    for result in 0..RESULTS {
        let only = |all: &[TwoFloat]| -> Vec<TwoFloat> {
            all.iter().skip(result).step_by(RESULTS).copied().collect()
        };
        let different = differences(&only(&found), &only(&expected));
        assert_eq!(different, 0, "result {result}");
    }

    let operations: [fn(f64, f64) -> f64; 5] = [
        |a, b| a + b,
        |a, b| a - b,
        |a, b| a * b,
        |a, b| a / b,
        |a, _| a.abs().sqrt(),
    ];
    for (index, operation) in operations.iter().enumerate() {
        let worst = |value: fn(TwoFloat) -> f64| {
            let results = found.iter().skip(index).step_by(RESULTS);
            let each = inputs.chunks(2).zip(results);
            each.map(|(ab, result)| (operation(exact(ab[0]), exact(ab[1])), value(*result)))
                .filter(|(expected, found)| expected != found)
                .map(|(expected, found)| ((found - expected) / expected).abs())
                .fold(0.0, f64::max)
        };
        let two = worst(exact);
        println!("operation {index}: worst error 2^{:.2}", two.log2());
        assert!(two < 2.0_f64.powi(-44), "operation {index}: {two:e}");
        let one = worst(|result| f64::from(result.high));
        assert!(one > 2.0_f64.powi(-26), "the control: {one:e}");
    }
}

/// The error of a module with this function, if any.
fn refusal(function: &str) -> Option<String> {
    let text = format!(
        "{function}
        @compute @workgroup_size(64) fn calculate() {{ keep(0u, tried(number_at(0u))); }}"
    );
    let tried = Source::new("tried", text.leak());
    let error = Program::in_width(&[PRELUDE, TWO_FLOAT, tried], Width::Extended).err();
    error.map(|error| error.to_string())
}

#[test]
fn what_cannot_be_rewritten_is_refused() {
    for body in [
        "floor(a)",
        "a % 2.0",
        "f64(i32(a))",
        "f64(f32(a) > 0.0f) + a",
        "dot(vec2<f64>(a), vec2<f64>(a))",
        "select(a, a, any(vec2<f64>(a) < vec2<f64>(1.0)))",
        "(mat2x2<f64>() * vec2<f64>(a)).x",
        "a + 1e300",
        "fract(a)",
    ] {
        let refused = refusal(&format!("fn tried(a: real) -> real {{ return {body}; }}"));
        let reason = refused.unwrap_or_else(|| panic!("`{body}` is not refused"));
        println!("{body}: {reason}");
        assert!(
            reason.contains("two f32") || reason.contains("no f32"),
            "{reason}"
        );
    }
    let accepted = refusal("fn tried(a: real) -> real { return a + 1e30; }");
    assert_eq!(accepted, None, "the control");

    // Without the functions that stand for operations.
    let entry = Source::new(
        "entry",
        "@compute @workgroup_size(64) fn calculate() { keep(0u, number_at(0u) * 2.0); }",
    );
    let error = Program::in_width(&[PRELUDE, entry], Width::Extended).unwrap_err();
    assert!(error.to_string().contains("no function"), "{error}");
}

/// All effects at once; the screen's list of doubts counts with an atomic.
#[test]
fn every_effect_can_be_rewritten() {
    for entry in [Entry::Tile, Entry::DoubtfulPixels] {
        for fetch in Fetch::ALL {
            let device = Device {
                count: true,
                formulas: Formulas::Stable,
                width: Width::Extended,
                entry,
                divide: DIVIDE_NATIVE,
                fetch,
            };
            let mut files = select_files(|_| true, device);
            Program::in_width(&files, device.width).unwrap();
            files.retain(|file| file.name != TWO_FLOAT.name);
            assert!(
                Program::in_width(&files, device.width).is_err(),
                "the control"
            );
        }
    }
}
