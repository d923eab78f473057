//! The intervals of the bounded formulas, shape by shape: what f64 finds lies within.

use rayon::prelude::*;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::hit::Meeting;
use rayproof::kernel::probe::{Probe, probe_of};
use rayproof::kernel::real::Real;
use rayproof::kernel::triangles::triangle_of;
use rayproof::kernel::{
    disk_bounded, disk_meeting, plane_bounded, plane_meeting, sphere_bounded, sphere_meeting,
    triangle_bounded, triangle_meeting,
};
use rayproof::tier::Bounded;

use super::common::aimed::{aimed_rays, hard_scene};
use super::{HARD, thorough};

/// The kinds of primitives.
const KINDS: [&str; 4] = ["sphere", "plane", "disk", "triangle"];

/// How the intervals of a kind fared.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Tally {
    /// Intervals that hold a hit for certain.
    certain: u64,
    /// Hits in doubt.
    doubtful: u64,
    /// Where f64 found something else.
    wrong: u64,
    /// The same, if the intervals were a hundred times narrower.
    wrong_if_narrower: u64,
    /// The most of its half interval that a t was off.
    most: f64,
}

impl Tally {
    /// Takes in a meeting with its bounds, and t as f64 has it.
    fn add(&mut self, bounded: Meeting<Bounded>, t: f64) {
        let [middle, low, high] = [bounded.t, bounded.low, bounded.high].map(Real::to_f64);
        let miss = f64::from(f32::MAX);
        if low >= miss {
            self.wrong += u64::from(t < miss);
        } else if high >= miss {
            self.doubtful += 1;
            self.wrong += u64::from(t < low);
        } else {
            self.certain += 1;
            self.wrong += u64::from(t < low || t > high);
            let room = if t < middle {
                middle - low
            } else {
                high - middle
            };
            let part = (t - middle).abs() / room;
            self.wrong_if_narrower += u64::from(part > 0.01);
            self.most = if part > self.most { part } else { self.most };
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            certain: self.certain + other.certain,
            doubtful: self.doubtful + other.doubtful,
            wrong: self.wrong + other.wrong,
            wrong_if_narrower: self.wrong_if_narrower + other.wrong_if_narrower,
            most: self.most.max(other.most),
        }
    }
}

fn add_all<'a, S: 'a, D: 'a>(
    tally: &mut Tally,
    bounded: impl IntoIterator<Item = S>,
    double: impl IntoIterator<Item = D>,
    meet: impl Fn(S) -> Meeting<Bounded>,
    meet_in_double: impl Fn(D) -> Meeting<f64>,
) {
    for (bounded, double) in bounded.into_iter().zip(double) {
        tally.add(meet(bounded), meet_in_double(double).t);
    }
}

/// A ray against every primitive.
fn tally_ray(
    first: (&Flat<Bounded>, Probe<Bounded>),
    second: (&Flat<f64>, Probe<f64>),
) -> [Tally; 4] {
    let ((flat, probe), (wide, wide_probe)) = (first, second);
    let mut tallies = [Tally::default(); 4];
    let [spheres, planes, disks, triangles] = &mut tallies;
    add_all(
        spheres,
        &flat.spheres,
        &wide.spheres,
        |sphere| sphere_bounded::meet_sphere(probe, sphere),
        |sphere| sphere_meeting::meet_sphere(wide_probe, sphere),
    );
    add_all(
        planes,
        &flat.planes,
        &wide.planes,
        |plane| plane_bounded::meet_plane(probe, plane),
        |plane| plane_meeting::meet_plane(wide_probe, plane),
    );
    add_all(
        disks,
        &flat.disks,
        &wide.disks,
        |disk| disk_bounded::meet_disk(probe, disk),
        |disk| disk_meeting::meet_disk(wide_probe, disk),
    );
    add_all(
        triangles,
        &flat.triangles,
        &wide.triangles,
        |corners| triangle_bounded::meet_triangle(probe, &triangle_of(flat, *corners)),
        |corners| triangle_meeting::meet_triangle(wide_probe, &triangle_of(wide, *corners)),
    );
    tallies
}

/// Fails where an interval does not hold what f64 finds.
fn tally_rays(case: &str, wide: &Flat<f64>, rays: &[(Ray<Bounded>, Ray<f64>)]) -> [Tally; 4] {
    let flat = wide.converted::<Bounded>();
    let tallies: Vec<[Tally; 4]> = rays
        .par_iter()
        .map(|(ray, wide_ray)| {
            let second = (wide, probe_of(*wide_ray));
            tally_ray((&flat, probe_of(*ray)), second)
        })
        .collect();
    for (index, tallies) in tallies.iter().enumerate() {
        for (kind, tally) in KINDS.iter().zip(tallies) {
            assert_eq!(
                tally.wrong, 0,
                "{case}, {index}: {kind}, {:?}",
                rays[index].1
            );
        }
    }
    let none = [Tally::default(); 4];
    let sum = |sum: [Tally; 4], more: [Tally; 4]| [0, 1, 2, 3].map(|k| sum[k].plus(more[k]));
    tallies.into_iter().fold(none, sum)
}

/// There are hits, so many of them in doubt, and narrower intervals would not hold.
fn control(total: [Tally; 4], doubtful: u64) {
    for (kind, tally) in KINDS.iter().zip(total) {
        println!("{kind}: {:.2} of a half interval at most", tally.most);
        assert!(
            tally.certain > 500 && tally.doubtful >= doubtful,
            "{kind}: {tally:?}"
        );
        assert!(tally.wrong_if_narrower > 0, "{kind}: {tally:?}");
    }
}

/// Adds up over the scenes.
fn over_scenes(tally: impl Fn(&str, &Flat<f64>) -> [Tally; 4]) -> [Tally; 4] {
    let mut total = [Tally::default(); 4];
    for (turned, scale) in HARD {
        let wide = flatten::<f64>(&hard_scene(turned, scale).with_size(160, 120));
        let tallies = tally(&format!("turned: {turned}, scale {scale:e}"), &wide);
        total = [0, 1, 2, 3].map(|kind| total[kind].plus(tallies[kind]));
    }
    total
}

#[test]
fn intervals_hold_what_f64_finds() {
    let count = if thorough() { 400_000 } else { 4000 };
    let total = over_scenes(|case, wide| {
        let rays: Vec<_> = aimed_rays(wide, count, 77)
            .into_iter()
            .map(|ray| (ray.converted(), ray.converted()))
            .collect();
        tally_rays(case, wide, &rays)
    });
    control(total, 20);
}

/// Those of a picture are rounded before they start.
#[test]
fn intervals_hold_what_the_rays_of_a_picture_find() {
    let total = over_scenes(|case, wide| {
        let camera = wide.converted::<Bounded>().camera;
        let pixels = (0..120).flat_map(|y| (0..160).map(move |x| (x, y)));
        let rays: Vec<_> = pixels
            .map(|(x, y)| {
                let ray = camera_ray(&camera, wide.size, x, y);
                (ray, camera_ray(&wide.camera, wide.size, x, y))
            })
            .collect();
        tally_rays(case, wide, &rays)
    });
    control(total, 0);
}
