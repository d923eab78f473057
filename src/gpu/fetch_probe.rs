//! A short probe of how fast a device reads the scene, in each way that it can.

use std::collections::HashMap;
use std::time::Instant;

use serde::Serialize;

use super::device::Gpu;
use super::memory::{SceneMemory, capacity, order};
use super::program::{Program, Source};
use super::samples::hash;
use super::scene::{PackedScene, Quad};
use super::selfcheck::{output, read};
use crate::effects::Fetch;
use crate::error::{Error, Result};
use crate::layout::Tables;

/// Quads that are read, as many as a uniform buffer holds.
const QUADS: u32 = 4096;

/// Invocations, and the reads of each, as in `fetch_probe.wgsl`.
const INVOCATIONS: u32 = 1 << 14;
const READS: u32 = 64;

/// Runs of which the fastest counts; the first compiles.
const RUNS: usize = 4;

const PROBE: Source = Source::new(
    "fetch_probe.wgsl",
    include_str!("../../shaders/fetch_probe.wgsl"),
);

/// How fast one way is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FetchSpeed {
    /// The way.
    pub fetch: Fetch,
    /// Wall time of a dispatch over its reads.
    pub ns_per_quad: f64,
}

/// Every way that the device has, in the order in which a scene is tried to be put there.
///
/// # Errors
///
/// As of a render; [`Error::DeviceLost`] where a way reads wrong numbers.
pub fn fetch_speeds(gpu: &Gpu) -> Result<Vec<FetchSpeed>> {
    let scene = PackedScene {
        quads: (0..QUADS).map(quad).collect(),
        tables: Tables::default(),
    };
    let ways = order(gpu).into_iter();
    ways.filter(|fetch| scene.bytes() <= capacity(gpu, *fetch))
        .map(|fetch| fetch_speed(gpu, &scene, fetch))
        .collect()
}

/// Whether the first way that a large scene may take is faster than those after it, and
/// so is the first one for a small scene.
pub fn is_confirmed(speeds: &[FetchSpeed]) -> bool {
    let of = |fetch| speeds.iter().find(|speed| speed.fetch == fetch);
    let large: Vec<_> = speeds
        .iter()
        .filter(|speed| speed.fetch != Fetch::Uniform)
        .collect();
    let small = match (speeds.first(), of(Fetch::Uniform)) {
        (Some(first), Some(uniform)) if first.fetch == Fetch::Uniform => large
            .iter()
            .all(|other| uniform.ns_per_quad <= other.ns_per_quad),
        _ => true,
    };
    small && large.is_sorted_by(|a, b| a.ns_per_quad <= b.ns_per_quad)
}

fn quad(place: u32) -> Quad {
    [0, 1, 2, 3].map(|word| hash(4 * place + word))
}

fn fetch_speed(gpu: &Gpu, scene: &PackedScene, fetch: Fetch) -> Result<FetchSpeed> {
    let program = Program::build(&[fetch.file(), PROBE])?;
    let kernel = gpu.compile(&program)?;
    let memory = SceneMemory::upload(gpu, scene, fetch)?;
    let bytes = u64::from(INVOCATIONS) * size_of::<u32>() as u64;
    let buffers = HashMap::from([("sums", output(gpu, "sums", bytes)?)]);
    let sums = kernel.bind(gpu, 0, |name| {
        buffers.get(name).map(|buffer| buffer.as_entire_binding())
    })?;
    let quads = kernel.bind(gpu, 1, |_| Some(memory.binding()))?;
    let mut fastest = f64::INFINITY;
    for _ in 0..RUNS {
        let started = Instant::now();
        let workgroups = [INVOCATIONS / 64, 1, 1];
        kernel.run(gpu, "read_quads", &[&sums, &quads], workgroups, None)?;
        fastest = fastest.min(started.elapsed().as_secs_f64());
    }
    let sums: Vec<u32> = read(gpu, &buffers["sums"], INVOCATIONS as usize)?;
    if (0..).zip(&sums).any(|(at, sum)| *sum != expected_sum(at)) {
        return Err(Error::DeviceLost(format!(
            "{} reads a scene wrong: {fetch:?}",
            gpu.adapter.name
        )));
    }
    Ok(FetchSpeed {
        fetch,
        ns_per_quad: fastest * 1e9 / f64::from(INVOCATIONS * READS),
    })
}

/// What an invocation must sum up.
fn expected_sum(at: u32) -> u32 {
    let mut place = at >> 3;
    let mut sum = 0_u32;
    for _ in 0..READS {
        let [x, y, z, w] = quad(place % QUADS);
        sum = sum.wrapping_add(x ^ y ^ z ^ w);
        place = place.wrapping_mul(1_664_525).wrapping_add(1_013_904_223) ^ (x >> 7);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_reads_right() {
        let gpu = Gpu::open(None).unwrap();
        let speeds = fetch_speeds(&gpu).unwrap();
        assert!(speeds.len() >= 2, "{speeds:?}");
        assert!(speeds.iter().all(|speed| speed.ns_per_quad > 0.0));
    }

    #[test]
    fn the_order_is_confirmed_or_not() {
        let speeds = |uniform, texture, storage| {
            let of = |fetch, ns_per_quad| FetchSpeed { fetch, ns_per_quad };
            [
                of(Fetch::Uniform, uniform),
                of(Fetch::Texture, texture),
                of(Fetch::Storage, storage),
            ]
        };
        assert!(is_confirmed(&speeds(1.0, 2.0, 3.0)));
        assert!(!is_confirmed(&speeds(1.0, 4.0, 3.0)));
        assert!(!is_confirmed(&speeds(5.0, 2.0, 3.0)));
        // Hardware: a uniform buffer is the last resort, whatever its speed.
        let [uniform, texture, storage] = speeds(1.0, 3.0, 2.0);
        assert!(is_confirmed(&[storage, texture, uniform]));
        assert!(!is_confirmed(&[texture, storage, uniform]));
        assert!(is_confirmed(&[]));
    }
}
