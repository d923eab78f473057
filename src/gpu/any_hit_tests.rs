//! The any-hit search on the GPU against the CPU's, and against the closest hit.

use super::device::Gpu;
use super::program::Source;
use super::render::{Portions, Prepared};
use crate::bounds::{Bounds, bound};
use crate::cpu::search::Search;
use crate::cpu::wide::Wide;
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::kernel::camera::camera_ray;
use crate::kernel::hit::no_hit;
use crate::kernel::probe::{Probe, probe_of};
use crate::kernel::trace::find_hit;
use crate::kernel::tree::any_hit;
use crate::scene::Scene;
use crate::watch::Unwatched;

fn bounded(name: &str) -> Flat<f32> {
    let file = format!("{}/assets/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut flat = flatten(&Scene::load(file).unwrap().with_size(97, 61));
    bound(&mut flat, Bounds::Tree);
    flat
}

/// Has the shader say, in place of the tests, whether something is met up to `limit`.
fn ask_for_any_hit(files: &mut [Source], limit: f32) {
    let search = "closest_hit(probe_of(ray), &hit);";
    let file = files.iter_mut().find(|file| file.name == "tile.wgsl");
    let file = file.unwrap();
    // In the pass of its own, and in that which colours.
    assert_eq!(file.text.matches(search).count(), 2);
    let ask = format!(
        "let met = any_hit(probe_of(ray), {limit}f, &hit);
        hit = no_hit();
        hit.tests = select(0u, 1u, met);"
    );
    file.text = file.text.replace(search, &ask).leak();
}

/// Of each pixel, whether something is met up to `limit`.
fn on_gpu(flat: &Flat<f32>, limit: f32) -> Vec<bool> {
    let gpu = Gpu::open(None).unwrap();
    let change = |files: &mut Vec<Source>| ask_for_any_hit(files, limit);
    let mut prepared = Prepared::changed(&gpu, flat, Portions::default(), &change).unwrap();
    let mut met = Vec::new();
    prepared
        .run(&Unwatched, &mut |_, pixels| {
            met.extend(pixels.iter().map(|pixel| pixel.tests == 1));
        })
        .unwrap();
    met
}

/// Each pixel's ray, and the t of its closest hit.
fn closest(flat: &Flat<f32>) -> Vec<(Probe<f32>, f32)> {
    let pixels = (0..flat.size[1]).flat_map(|y| (0..flat.size[0]).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| {
            let probe = probe_of(camera_ray(&flat.camera, flat.size, x, y));
            let mut hit = no_hit();
            find_hit(flat, probe, &mut hit);
            (probe, hit.t)
        })
        .collect()
}

#[test]
fn any_hit_is_there_where_the_closest_is_near_enough() {
    for name in ["shapes", "knot"] {
        let flat = bounded(name);
        let wide = Wide::new(&flat);
        let mut search = Search::new(&flat, Some(&wide));
        let closest = closest(&flat);
        let mut hits: Vec<f32> = closest.iter().map(|(_, t)| *t).collect();
        hits.retain(|&t| t < f32::MAX);
        hits.sort_by(f32::total_cmp);
        assert!(hits.len() > 500);
        let third = hits.len() / 3;
        // Up to a hit and just below it: `limit` itself counts.
        for limit in [hits[third], hits[third].next_down(), hits[2 * third], 1e9] {
            let met = on_gpu(&flat, limit);
            for ((probe, t), met) in closest.iter().zip(&met) {
                let near = *t <= limit;
                let here = format!("{name}, limit {limit}, {probe:?}");
                assert_eq!(*met, near, "GPU, {here}");
                assert_eq!(any_hit(&flat, *probe, limit, &mut no_hit()), near, "{here}");
                assert_eq!(search.any(*probe, limit), near, "wide, {here}");
            }
            let count = met.iter().filter(|met| **met).count();
            assert_eq!(
                count,
                hits.partition_point(|&t| t <= limit),
                "{name}, {limit}"
            );
        }
    }
}
