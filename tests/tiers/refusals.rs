//! What is refused, and how it is said.

use rayproof::accuracy::Widths;
use rayproof::bounds::Bounds;
use rayproof::flatten::flatten;
use rayproof::gpu::device::Gpu;
use rayproof::render::Settings;
use rayproof::{Accuracy, Backend, Error, Unwatched};

use super::common::aimed::aimed_rays;
use super::common::{gpu, scene};

/// A driver that may contract and reorder cannot add in two f32.
#[test]
fn extended_is_refused_where_sums_are_not_exact() {
    let mut gpu: Gpu = gpu();
    assert_eq!(gpu.lacks(Accuracy::Extended), None);
    gpu.give_up_exactness().unwrap();
    assert!(!gpu.arithmetic.two_sum, "lavapipe rearranges what it may");
    let reason = gpu.lacks(Accuracy::Extended).unwrap();
    assert!(reason.contains("TwoSum"), "{reason}");
    assert!(reason.contains(&gpu.adapter.name), "{reason}");
    // The control: what needs no exact sums is still there.
    assert_eq!(gpu.lacks(Accuracy::Robust), None);
    let backend = Backend::Gpu(Box::new(gpu));
    let scene = scene("shapes").with_size(8, 8);
    let render = |accuracy: Accuracy| {
        let settings = Settings::from(accuracy);
        rayproof::render(&scene, &backend, settings, &Unwatched)
    };
    let error = render(Accuracy::Extended).unwrap_err();
    assert!(matches!(error, Error::Usage(_)), "{error:?}");
    render(Accuracy::Robust).unwrap();
}

/// Rays of a list go through a tree, or through all there is, in one dispatch.
#[test]
fn lists_of_volumes_are_refused_for_lists_of_rays() {
    let scene = scene("shapes");
    let gpu = Backend::Gpu(Box::new(gpu()));
    let widths = |bounds| Widths::of(flatten::<f64>(&scene), bounds);
    let rays = aimed_rays(&super::aimed::hard_flat(), 10, 1);
    for accuracy in Accuracy::ALL {
        for bounds in [Bounds::Spheres { levels: 1 }, Bounds::Boxes { levels: 2 }] {
            for backend in [&gpu, &Backend::Cpu(None)] {
                let refused = widths(bounds).trace_rays(backend, accuracy, &rays);
                let error = refused.unwrap_err();
                assert!(matches!(error, Error::Limit(_)), "{error:?}");
                assert!(error.to_string().contains("tree"), "{error}");
            }
        }
        // The controls.
        for bounds in [Bounds::Tree, Bounds::None] {
            let (found, _) = widths(bounds).trace_rays(&gpu, accuracy, &rays).unwrap();
            assert_eq!(found.len(), rays.len());
        }
    }
    let none = widths(Bounds::Tree).trace_rays(&gpu, Accuracy::Robust, &[]);
    assert!(none.unwrap().0.is_empty());
}
