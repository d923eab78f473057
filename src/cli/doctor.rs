//! `rayproof doctor`.

use serde::Serialize;

use super::Outcome;
use super::flags::Common;
use super::report;
use rayproof::error::{Error, Result};
use rayproof::gpu::adapter::{AdapterDescription, adapters};
use rayproof::gpu::device::Gpu;
use rayproof::gpu::fetch_probe::{FetchSpeed, fetch_speeds, is_confirmed};
use rayproof::gpu::selfcheck::Arithmetic;

/// What is known of one adapter.
#[derive(Serialize)]
struct Diagnosis {
    #[serde(flatten)]
    adapter: AdapterDescription,
    limits: Limits,
    features: Vec<&'static str>,
    /// Pictures are expected to equal the CPU's bit for bit.
    bit_exact: bool,
    arithmetic: Option<Arithmetic>,
    /// How fast the scene is read in each way, in the order in which they are chosen.
    fetch: Vec<FetchSpeed>,
    /// Whether that order is the fastest.
    fetch_confirmed: Option<bool>,
    /// Why the device did not open.
    error: Option<String>,
}

/// The limits that matter here.
#[derive(Serialize)]
struct Limits {
    max_storage_buffer_binding_size: u64,
    max_buffer_size: u64,
    max_storage_buffers_per_shader_stage: u32,
    max_compute_workgroups_per_dimension: u32,
}

#[derive(Serialize)]
struct Diagnoses {
    adapters: Vec<Diagnosis>,
}

/// Shows every adapter and measures its arithmetic; where none is used without
/// being named, the error says what to install.
pub(super) fn run(common: &Common) -> Result<Outcome> {
    let diagnoses = Diagnoses {
        adapters: adapters().iter().map(diagnose).collect(),
    };
    if common.json {
        report::print(&report::json(&diagnoses))?;
    } else if !common.quiet {
        report::print(
            &diagnoses
                .adapters
                .iter()
                .map(summary)
                .collect::<Vec<_>>()
                .join("\n"),
        )?;
    }
    // The same verdict as `--backend gpu` would meet.
    match diagnoses.adapters.as_slice() {
        [] => Err(Error::NoAdapter("this machine offers none".into())),
        all if all.iter().all(|one| one.adapter.backend == "gl") => Err(Error::NoAdapter(
            "this machine offers OpenGL only, which is used only where `--adapter` names it".into(),
        )),
        _ => Ok(Outcome::Done),
    }
}

fn diagnose(adapter: &wgpu::Adapter) -> Diagnosis {
    let limits = adapter.limits();
    let features = adapter.features();
    let named = [
        (wgpu::Features::PASSTHROUGH_SHADERS, "passthrough-shaders"),
        (wgpu::Features::SHADER_F64, "shader-f64"),
        (wgpu::Features::TIMESTAMP_QUERY, "timestamp-query"),
        (wgpu::Features::SUBGROUP, "subgroup"),
    ];
    let gpu = Gpu::open_adapter(adapter, None);
    let speeds = gpu.as_ref().ok().map(fetch_speeds);
    let fetch = speeds.and_then(Result::ok).unwrap_or_default();
    Diagnosis {
        adapter: AdapterDescription::of(adapter),
        limits: Limits {
            max_storage_buffer_binding_size: limits.max_storage_buffer_binding_size,
            max_buffer_size: limits.max_buffer_size,
            max_storage_buffers_per_shader_stage: limits.max_storage_buffers_per_shader_stage,
            max_compute_workgroups_per_dimension: limits.max_compute_workgroups_per_dimension,
        },
        features: named
            .into_iter()
            .filter(|(feature, _)| features.contains(*feature))
            .map(|(_, name)| name)
            .collect(),
        fetch_confirmed: (!fetch.is_empty()).then(|| is_confirmed(&fetch)),
        fetch,
        bit_exact: gpu.as_ref().is_ok_and(Gpu::is_bit_exact),
        arithmetic: gpu.as_ref().ok().map(|gpu| gpu.arithmetic.clone()),
        error: gpu.err().map(|error| error.to_string()),
    }
}

fn summary(diagnosis: &Diagnosis) -> String {
    let about = &diagnosis.adapter;
    let mut rows = vec![
        (
            "adapter",
            format!("{} ({}, {})", about.name, about.kind, about.backend),
        ),
        ("driver", about.driver.clone()),
        (
            "limits",
            format!(
                "{} MiB a binding, {} MiB a buffer, {} storage buffers",
                diagnosis.limits.max_storage_buffer_binding_size >> 20,
                diagnosis.limits.max_buffer_size >> 20,
                diagnosis.limits.max_storage_buffers_per_shader_stage
            ),
        ),
        ("features", diagnosis.features.join(", ")),
    ];
    if let Some(error) = &diagnosis.error {
        rows.push(("error", error.clone()));
    }
    if let Some(arithmetic) = &diagnosis.arithmetic {
        rows.extend(arithmetic_rows(arithmetic));
    }
    if let Some(confirmed) = diagnosis.fetch_confirmed {
        let ways = diagnosis.fetch.iter();
        let speeds = ways.map(|speed| format!("{} {:.1}", speed.fetch.name(), speed.ns_per_quad));
        let order = if confirmed {
            ""
        } else {
            ", not the fastest first"
        };
        let speeds = speeds.collect::<Vec<_>>().join(", ");
        rows.push(("reading", format!("{speeds} ns a quad{order}")));
    }
    rows.push(("verdict", verdict(diagnosis).to_string()));
    report::table(&rows)
}

fn verdict(diagnosis: &Diagnosis) -> &'static str {
    let flushes = diagnosis.arithmetic.as_ref().is_some_and(|a| !a.denormals);
    match (diagnosis.bit_exact, flushes) {
        (true, false) => "pictures equal the CPU's bit for bit",
        (true, true) => {
            "pictures equal the CPU's bit for bit, but for values below 1.2e-38, which are flushed"
        }
        (false, _) => "pictures equal the CPU's within a tolerance only",
    }
}

fn arithmetic_rows(arithmetic: &Arithmetic) -> [(&'static str, String); 6] {
    let yes = |is: bool, yes: &str, no: &str| (if is { yes } else { no }).to_string();
    let corrected = if arithmetic.corrected {
        ", corrected"
    } else {
        ""
    };
    [
        (
            "exact sums",
            format!(
                "TwoSum {}, TwoProd {}",
                yes(arithmetic.two_sum, "exact", "wrong"),
                yes(arithmetic.two_prod, "exact", "wrong")
            ),
        ),
        (
            "contraction",
            format!(
                "{}, fma {}",
                yes(arithmetic.contraction, "yes", "no"),
                yes(arithmetic.fma_fused, "fused", "not fused")
            ),
        ),
        (
            "rounding",
            format!(
                "division {} ulp, square root {} ulp{corrected}",
                arithmetic.division_ulp, arithmetic.sqrt_ulp
            ),
        ),
        (
            "special values",
            format!(
                "denormals {}, NaN {}",
                yes(arithmetic.denormals, "kept", "flushed"),
                yes(
                    arithmetic.nan_unequal,
                    "as in IEEE 754",
                    "not told from numbers"
                )
            ),
        ),
        (
            "f64",
            match arithmetic.f64_ulp {
                Some(ulp) => format!("yes, division and square root {ulp} ulp"),
                None => "no".to_string(),
            },
        ),
        (
            "loops",
            match arithmetic.loop_budget {
                Some(budget) => format!("silently stopped after {budget} iterations"),
                None => "not stopped".to_string(),
            },
        ),
    ]
}
