//! How much of a tree a ray visits.

use rayproof::bounds::tree::build;
use rayproof::bounds::{Bounds, bound, primitive_boxes, validate};
use rayproof::cpu::search::Search;
use rayproof::cpu::wide::Wide;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::{GIVEN_UP, no_hit};
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::real::Real;
use rayproof::kernel::trace::find_hit;
use rayproof::layout::NO_HIT;
use rayproof::tier::{Bounded, Extended, Textbook};

use super::common::random::Numbers;
use super::trees::scenes;
use super::{ODD, is_no_ray, meets_no_box, odd_rays, ordinary_ray, ray_of, spoilt, thorough};

/// Visits of rays with one kind of odd number in some places, in parts of the mean of
/// ordinary ones, at most: as in the verification of Embree.
const MOST: f64 = 2.5;

/// Boxes and shapes that a ray tests.
fn visits<R: Real>(flat: &Flat<R>, ray: Ray<f32>) -> u32 {
    let mut hit = no_hit();
    find_hit(flat, probe_of::<R>(ray.converted()), &mut hit);
    assert_ne!(hit.tests, GIVEN_UP, "{ray:?}");
    hit.tests + hit.bound_tests
}

fn mean<R: Real>(flat: &Flat<R>, rays: impl Iterator<Item = Ray<f32>>) -> f64 {
    let (mut count, mut sum) = (0.0, 0.0);
    for ray in rays {
        count += 1.0;
        sum += f64::from(visits(flat, ray));
    }
    sum / count
}

fn ends_soon<R: Real>(name: &str, flat: &Flat<R>) {
    let mut n = Numbers(3);
    let ordinary = mean(flat, (0..2000).map(|_| ordinary_ray(&mut n)));
    let times = if thorough() { 500 } else { 50 };
    for odd in ODD {
        for places in 1..64 {
            let rays = (0..times).map(|_| spoilt(ordinary_ray(&mut n), places, odd));
            let odd_mean = mean(flat, rays);
            assert!(
                odd_mean <= MOST * ordinary,
                "{name}: {odd} in {places:b}: {odd_mean} visits for {ordinary}"
            );
        }
    }
}

#[test]
fn odd_rays_end_as_soon_as_ordinary_ones() {
    for (name, scene) in scenes() {
        let mut flat = flatten::<f64>(&scene);
        bound(&mut flat, Bounds::Tree);
        ends_soon::<f32>(name, &flat.converted());
        ends_soon::<Bounded>(name, &flat.converted());
        if thorough() {
            ends_soon::<Extended>(name, &flat.converted());
            ends_soon::<f64>(name, &flat);
        }
    }
}

/// The control: from so far away boxes are wider than the scene, and all are visited.
#[test]
fn a_ray_that_visits_everything_is_noticed() {
    let (_, scene) = &scenes()[0];
    let mut flat = flatten::<f32>(scene);
    bound(&mut flat, Bounds::Tree);
    let mut n = Numbers(3);
    let ordinary = mean(&flat, (0..2000).map(|_| ordinary_ray(&mut n)));
    let far = visits(&flat, ray_of([1e12, -0.5, -4.0, -1.0, 0.0, 0.0]));
    assert!(f64::from(far) > 100.0 * ordinary, "{far}, {ordinary}");
}

/// They are done with after the root, in both trees.
#[test]
fn rays_that_meet_no_box_visit_nothing() {
    fn nothing<R: Real>(flat: &Flat<R>) {
        let wide = Wide::new(flat);
        let planes = flat.planes.len() as u32;
        let mut search = Search::new(flat, Some(&wide));
        let rays = odd_rays(4, 20_000);
        let mut some = 0;
        for ray in rays.into_iter().filter(|&ray| meets_no_box(ray)) {
            assert!(visits(flat, ray) <= 2 + planes, "{ray:?}");
            let mut hit = no_hit();
            search.closest(probe_of::<R>(ray.converted()), &mut hit);
            assert_eq!(hit.tests, planes, "{ray:?}");
            assert!(hit.id == NO_HIT || !is_no_ray(ray), "{ray:?}");
            some += 1;
        }
        assert!(some > 10_000, "{some}");
    }
    for (_, scene) in scenes() {
        let mut flat = flatten::<f64>(&scene);
        bound(&mut flat, Bounds::Tree);
        nothing::<f32>(&flat.converted());
        nothing::<Bounded>(&flat.converted());
        nothing::<Extended>(&flat.converted());
        nothing::<f64>(&flat);
        let mut flat = flatten::<Textbook>(&scene);
        bound(&mut flat, Bounds::Tree);
        nothing::<Textbook>(&flat);
    }
}

/// No tree is deeper than the stack, whatever it is made of.
#[test]
fn trees_of_every_shape_are_valid() {
    for (name, scene) in scenes() {
        let flat = flatten::<f32>(&scene);
        let items = primitive_boxes(&flat);
        let kind_of = |id| flat.kind_of(id).0;
        let tree = build(items.clone(), &kind_of);
        validate(&tree, &items, &kind_of).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    }
}
