//! What a device's arithmetic does, measured when it is opened.
//!
//! WGSL promises little: `/` may be 2.5 ulp off, `sqrt` more, denormal numbers
//! may become zero, sums may be rearranged. What a picture can be held to
//! depends on what the device does in fact.

use std::collections::HashMap;

use bytemuck::{Pod, Zeroable};
use serde::Serialize;
use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::program::Program;
use super::samples::{any_normal_quotient, hash, number};
use super::samples::{quotient_near_midpoint, root_near_midpoint};
use super::source::Source;
use crate::effects::{DIVIDE_CORRECTED, DIVIDE_NATIVE};
use crate::error::Result;

/// Sets of numbers tried. A formula that goes wrong does so in a fair part of all
/// inputs: TwoSum in 86 %, contraction in 17 %, a dividend times a reciprocal in
/// 27 %. A division that lacks nothing but its last rounding went wrong in none of
/// a million, yet in 8 % of those next to a midpoint.
pub(crate) const INPUTS: u32 = 8192;

/// Loop iterations tried: four times what lavapipe allows an invocation.
const LOOPS: u32 = 1 << 18;

/// What a device's arithmetic does.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Arithmetic {
    /// TwoSum gives the exact error.
    pub two_sum: bool,
    /// TwoProd, by splitting, gives the exact error.
    pub two_prod: bool,
    /// a * b - (a * b) is not always 0.
    pub contraction: bool,
    /// `fma` rounds once.
    pub fma_fused: bool,
    /// The largest error of the device's own `/`, beyond correct rounding, in ulp.
    pub division_ulp: u32,
    /// The largest error of the device's own `sqrt`, likewise.
    pub sqrt_ulp: u32,
    /// Quotients and roots come from the corrected formulas, and these are right.
    pub corrected: bool,
    /// Denormal numbers are kept.
    pub denormals: bool,
    /// A NaN differs from itself.
    pub nan_unequal: bool,
    /// f64 is there.
    pub f64: bool,
    /// The largest error of `/` and `sqrt` in f64, in ulp.
    pub f64_ulp: Option<u32>,
    /// Iterations after which the driver silently stops a loop; none if it ran
    /// all that were tried.
    pub loop_budget: Option<u32>,
}

impl Arithmetic {
    /// Every operation of the kernel has Rust's bits, so pictures should too: where
    /// `denormals` is false, as long as no value falls below the least normal one.
    pub fn is_exact(&self) -> bool {
        self.two_sum && self.two_prod && !self.contraction && self.is_rounded()
    }

    /// Quotients and roots are rounded correctly.
    pub fn is_rounded(&self) -> bool {
        (self.division_ulp == 0 && self.sqrt_ulp == 0) || self.corrected
    }

    /// The shader file that divides correctly on this device.
    pub(crate) fn divide_file(&self) -> Source {
        if self.corrected {
            DIVIDE_CORRECTED
        } else {
            DIVIDE_NATIVE
        }
    }
}

const SELFCHECK: Source = Source::new(
    "selfcheck.wgsl",
    include_str!("../../shaders/selfcheck.wgsl"),
);
const SELFCHECK_F64: Source = Source::new(
    "selfcheck_f64.wgsl",
    include_str!("../../shaders/selfcheck_f64.wgsl"),
);
const REAL: Source = Source::new("real", "alias real = f32;");

#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct Input {
    a: f32,
    b: f32,
    dividend: f32,
    divisor: f32,
    radicand: f32,
    shrink: f32,
    nan: f32,
}

#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct Probe {
    two_sum: f32,
    two_prod: f32,
    contraction: f32,
    fused: f32,
    quotient: f32,
    root: f32,
    tiny: f32,
    nan_unequal: u32,
}

#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
struct Pair64 {
    a: f64,
    b: f64,
}

/// Measures an open device.
///
/// # Errors
///
/// When a shader does not compile or the device is lost.
pub(super) fn measure_arithmetic(gpu: &Gpu) -> Result<Arithmetic> {
    let mut arithmetic = measure_f32(gpu, DIVIDE_NATIVE)?;
    if arithmetic.division_ulp > 0 || arithmetic.sqrt_ulp > 0 {
        let corrected = measure_f32(gpu, DIVIDE_CORRECTED)?;
        arithmetic.corrected = corrected.division_ulp == 0 && corrected.sqrt_ulp == 0;
    }
    arithmetic.f64 = gpu.has_f64();
    if arithmetic.f64 {
        arithmetic.f64_ulp = Some(measure_f64(gpu)?);
    }
    Ok(arithmetic)
}

pub(super) fn measure_f32(gpu: &Gpu, divide: Source) -> Result<Arithmetic> {
    let program = Program::build(&[REAL, divide, SELFCHECK])?;
    let kernel = gpu.compile(&program)?;
    let inputs: Vec<Input> = (0..INPUTS).map(input).collect();
    let buffers = HashMap::from([
        (
            "inputs",
            gpu.upload("inputs", bytemuck::cast_slice(&inputs))?,
        ),
        (
            "probes",
            output(gpu, "probes", size_of::<Probe>() as u64 * u64::from(INPUTS))?,
        ),
        ("loops", output(gpu, "loops", 64)?),
    ]);
    gpu.queue
        .write_buffer(&buffers["loops"], 0, bytemuck::bytes_of(&[LOOPS, 0, 1]));
    run(gpu, &kernel, "measure", &buffers, INPUTS.div_ceil(64))?;
    run(gpu, &kernel, "count_loops", &buffers, 1)?;
    let probes: Vec<Probe> = read(gpu, &buffers["probes"], INPUTS as usize)?;
    let loops: Vec<u32> = read(gpu, &buffers["loops"], 2)?;

    let each = || inputs.iter().zip(&probes);
    Ok(Arithmetic {
        two_sum: each().all(|(i, p)| p.two_sum == two_sum_error(i.a, i.b)),
        two_prod: each().all(|(i, p)| p.two_prod == two_prod_error(i.a, i.b)),
        contraction: each().any(|(_, p)| p.contraction != 0.0),
        fma_fused: each().all(|(i, p)| p.fused == two_prod_error(i.a, i.b)),
        division_ulp: each()
            .map(|(i, p)| ulps(p.quotient, i.dividend / i.divisor))
            .max()
            .unwrap_or(0),
        sqrt_ulp: each()
            .map(|(i, p)| ulps(p.root, i.radicand.sqrt()))
            .max()
            .unwrap_or(0),
        denormals: each().all(|(i, p)| p.tiny == i.a * i.shrink),
        nan_unequal: probes.iter().all(|p| p.nan_unequal == 1),
        loop_budget: (loops[1] < LOOPS).then_some(loops[1]),
        ..Arithmetic::default()
    })
}

fn measure_f64(gpu: &Gpu) -> Result<u32> {
    let kernel = gpu.compile(&Program::build(&[SELFCHECK_F64])?)?;
    let inputs: Vec<Pair64> = (0..INPUTS)
        .map(|index| {
            let Input { a, b, .. } = input(index);
            // Digits beyond f32's.
            Pair64 {
                a: f64::from(a) / 3.0,
                b: f64::from(b) / 7.0,
            }
        })
        .collect();
    let buffers = HashMap::from([
        (
            "inputs",
            gpu.upload("inputs", bytemuck::cast_slice(&inputs))?,
        ),
        (
            "probes",
            output(
                gpu,
                "probes",
                size_of::<Pair64>() as u64 * u64::from(INPUTS),
            )?,
        ),
    ]);
    run(gpu, &kernel, "measure", &buffers, INPUTS.div_ceil(64))?;
    let probes: Vec<Pair64> = read(gpu, &buffers["probes"], INPUTS as usize)?;
    let worst = inputs.iter().zip(&probes).map(|(i, p)| {
        let quotient = p.a.to_bits().abs_diff((i.a / i.b).to_bits());
        let root = p.b.to_bits().abs_diff(i.a.abs().sqrt().to_bits());
        u32::try_from(quotient.max(root)).unwrap_or(u32::MAX)
    });
    Ok(worst.max().unwrap_or(0))
}

pub(super) fn output(gpu: &Gpu, name: &str, bytes: u64) -> Result<wgpu::Buffer> {
    let usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
    gpu.create_buffer(name, bytes, usage)
}

pub(super) fn run(
    gpu: &Gpu,
    kernel: &Kernel,
    entry: &str,
    buffers: &HashMap<&'static str, wgpu::Buffer>,
    workgroups: u32,
) -> Result<()> {
    let group = kernel.bind(gpu, 0, |name| {
        buffers.get(name).map(|buffer| buffer.as_entire_binding())
    })?;
    kernel
        .run(gpu, entry, &[&group], [workgroups, 1, 1], None)
        .map(|_| ())
}

pub(super) fn read<T: Pod>(gpu: &Gpu, buffer: &wgpu::Buffer, count: usize) -> Result<Vec<T>> {
    let bytes = (count * size_of::<T>()) as u64;
    let staging = gpu.create_buffer(
        "staging",
        bytes,
        BufferUsages::COPY_DST | BufferUsages::MAP_READ,
    )?;
    Ok(bytemuck::pod_collect_to_vec(
        &gpu.read_back(buffer, &staging, bytes)?,
    ))
}

/// Sums and products of `a` and `b`, of either sign and of up to 2^8 in ratio,
/// have errors and do not overflow. Quotients and roots are tried on the same
/// numbers, next to midpoints, and over all exponents.
fn input(index: u32) -> Input {
    let random = |salt: u32| hash(index.wrapping_mul(4).wrapping_add(salt));
    let (a, b) = (
        number(random(0), 123 + random(2) % 8),
        number(random(1), 123 + random(3) % 8),
    );
    let (dividend, divisor, radicand) = match index % 4 {
        0 => {
            let (dividend, divisor) = quotient_near_midpoint(random(0));
            let radicand = root_near_midpoint(index as i32 / 4 - INPUTS as i32 / 8);
            (dividend, divisor, radicand)
        }
        1 => {
            let (dividend, divisor) = any_normal_quotient(random(0), random(1), random(2));
            (dividend, divisor, dividend.abs())
        }
        _ => (a, b, a.abs()),
    };
    let shrink = f32::MIN_POSITIVE / 1024.0;
    Input {
        a,
        b,
        dividend,
        divisor,
        radicand,
        shrink,
        nan: f32::NAN,
    }
}

fn two_sum_error(a: f32, b: f32) -> f32 {
    let sum = a + b;
    let part = sum - a;
    (a - (sum - part)) + (b - part)
}

/// A product of two f32 is exact in f64.
fn two_prod_error(a: f32, b: f32) -> f32 {
    (f64::from(a) * f64::from(b) - f64::from(a * b)) as f32
}

/// Representable numbers from `a` to `b`, both of one sign.
fn ulps(a: f32, b: f32) -> u32 {
    a.to_bits().abs_diff(b.to_bits())
}
