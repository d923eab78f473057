//! What a tier sees along a pixel's ray: its answer, and every shape by itself.

use std::collections::HashMap;

use crate::count::Counters;
use crate::error::Result;
use crate::flat::Flat;
use crate::found::Found;
use crate::kernel::camera::camera_ray;
use crate::kernel::doubt::is_in_doubt;
use crate::kernel::hit::{Meeting, no_hit};
use crate::kernel::near_spheres::is_near;
use crate::kernel::probe::{Probe, probe_of};
use crate::kernel::real::Real;
use crate::kernel::screen::tile_of;
use crate::kernel::trace::find_hit;
use crate::kernel::triangles::{meet_triangle, triangle_of};
use crate::kernel::{
    disk_bounded, disk_meeting, plane_bounded, plane_meeting, sphere_bounded, sphere_meeting,
};
use crate::layout::{Disk, Plane, Sphere};
use crate::tier::{Accuracy, Formulas};

/// What a tier sees. What is missed, or not known to be met, is at infinity.
pub(super) struct View {
    /// Its answer, by way of the volumes.
    pub(super) found: Found,
    /// The interval of the answer's t, and where the first rival's begins.
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) rival: f64,
    /// Whether the answer is in doubt.
    pub(super) in_doubt: bool,
    /// What the ray tested.
    pub(super) counters: Counters,
    /// What it meets or may meet, by id; each shape is tested by itself, without volumes.
    pub(super) meetings: HashMap<u32, Meeting<f64>>,
    /// The same where the powers of near spheres are those of the rounded numbers, if there
    /// are any: what the oracle can be compared with, which knows of no powers.
    rounded: Option<HashMap<u32, Meeting<f64>>>,
}

impl View {
    /// Where it meets a shape for certain.
    pub(super) fn t_of(&self, id: u32) -> Option<f64> {
        certain(&self.meetings, id)
    }

    /// The same if it had nothing but the rounded numbers.
    pub(super) fn rounded_t_of(&self, id: u32) -> Option<f64> {
        certain(self.rounded.as_ref().unwrap_or(&self.meetings), id)
    }
}

fn certain(meetings: &HashMap<u32, Meeting<f64>>, id: u32) -> Option<f64> {
    let meeting = meetings.get(&id)?;
    (meeting.high < f64::INFINITY).then_some(meeting.t)
}

/// What each kind of number sees.
pub(super) struct Seen {
    pub(super) textbook: View,
    pub(super) robust: View,
    pub(super) extended: View,
    pub(super) double: View,
    /// Of the adaptive tier.
    pub(super) first_pass: View,
}

impl Seen {
    /// What a tier sees, in its first pass if it has two.
    pub(super) fn of(&self, accuracy: Accuracy) -> &View {
        match accuracy {
            Accuracy::Textbook => &self.textbook,
            Accuracy::Robust => &self.robust,
            Accuracy::Extended => &self.extended,
            Accuracy::Double => &self.double,
            Accuracy::Adaptive => &self.first_pass,
        }
    }

    pub(super) fn all(&self) -> impl Iterator<Item = &View> {
        Accuracy::ALL.into_iter().map(|accuracy| self.of(accuracy))
    }
}

/// Looks along the ray of a pixel.
pub(super) fn see<R: Real>(flat: &Flat<R>, x: u32, y: u32) -> Result<View> {
    let probe = probe_of(camera_ray(&flat.camera, flat.size, x, y));
    let mut hit = no_hit();
    hit.tile = tile_of(flat.size, x, y);
    find_hit(flat, probe, &mut hit);
    Ok(View {
        found: Found::at(hit)?,
        low: widened(hit.low),
        high: widened(hit.high),
        rival: widened(hit.rival),
        in_doubt: is_in_doubt(hit),
        counters: Counters {
            bound_tests: hit.bound_tests.into(),
            bound_hits: hit.bound_hits.into(),
            shape_tests: hit.tests.into(),
        },
        meetings: meetings(flat, probe),
        rounded: flat.spheres.iter().any(is_near).then(|| {
            let mut rounded = flat.clone();
            rounded.take_powers_anew();
            meetings(&rounded, probe)
        }),
    })
}

/// A t in f64; infinite where it stands for a miss.
fn widened<R: Real>(t: R) -> f64 {
    if t < R::MISS {
        t.to_f64()
    } else {
        f64::INFINITY
    }
}

fn meetings<R: Real>(flat: &Flat<R>, probe: Probe<R>) -> HashMap<u32, Meeting<f64>> {
    let spheres = flat.sphere_ids.iter().zip(&flat.spheres);
    let planes = (flat.first_plane()..).zip(&flat.planes);
    let disks = flat.disk_ids.iter().zip(&flat.disks);
    let triangles = flat.triangles.iter();
    spheres
        .map(|(id, sphere)| (*id, meet_sphere(probe, sphere)))
        .chain(planes.map(|(id, plane)| (id, meet_plane(probe, plane))))
        .chain(disks.map(|(id, disk)| (*id, meet_disk(probe, disk))))
        .chain(triangles.map(|corners| {
            let triangle = triangle_of(flat, *corners);
            (corners.id, meet_triangle(probe, &triangle))
        }))
        .filter(|(_, meeting)| meeting.low < R::MISS)
        .map(|(id, Meeting { t, low, high })| {
            let [t, low, high] = [t, low, high].map(widened);
            (id, Meeting { t, low, high })
        })
        .collect()
}

fn meet_sphere<R: Real>(probe: Probe<R>, sphere: &Sphere<R>) -> Meeting<R> {
    match R::FORMULAS {
        Formulas::Bounded => sphere_bounded::meet_sphere(probe, sphere),
        _ => sphere_meeting::meet_sphere(probe, sphere),
    }
}

fn meet_plane<R: Real>(probe: Probe<R>, plane: &Plane<R>) -> Meeting<R> {
    match R::FORMULAS {
        Formulas::Bounded => plane_bounded::meet_plane(probe, plane),
        _ => plane_meeting::meet_plane(probe, plane),
    }
}

fn meet_disk<R: Real>(probe: Probe<R>, disk: &Disk<R>) -> Meeting<R> {
    match R::FORMULAS {
        Formulas::Bounded => disk_bounded::meet_disk(probe, disk),
        _ => disk_meeting::meet_disk(probe, disk),
    }
}
