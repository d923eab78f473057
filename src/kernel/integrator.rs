//! A path of light, followed from the camera: at each place that it comes to, what light is
//! there and where the path goes on.
//!
//! Kajiya, "The Rendering Equation", SIGGRAPH 1986. What a scene does not call for has no part
//! in it: the functions of its file find nothing then.

use super::anti_aliasing::in_pixel;
use super::blockers::is_shadowed;
use super::camera::{Ray, camera_ray};
use super::clear_bodies::{is_clear, pass_clear, pass_medium};
use super::cutouts::seen_hit;
use super::dimensions::{LOBE, dimension_of};
use super::divide::divide;
use super::emission::emitted;
use super::fog::{cosine_towards, meets_fog, through_fog};
use super::hit::{Hit, Surface};
use super::indirect::{even_chance, even_weight, scatter_evenly, survives};
use super::layers::layers_of;
use super::lens::through_lens;
use super::mirrors::{mirror_light, mirror_look, mirrored_light};
use super::motion::{from_moving_camera, open_shutter};
use super::numbers::{Numbers, number, numbers_of};
use super::occlusion::ambient_light;
use super::offset::leave_surface;
use super::real::Real;
use super::sky::seen_sky;
use super::sources::{arriving_from, count_sources};
use super::textures::textured;
use super::trace::surface_of;
use super::tracer::Tracer;
use super::vector::{Vec3, taxicab_length, unit_vector, vec3, vector_length};
use crate::flat::Flat;
use crate::layout::{NO_HIT, Pixel};

/// A path on its way.
#[derive(Debug, Clone, Copy)]
pub struct Path<R> {
    /// The ray that it has come to.
    pub ray: Ray<R>,
    /// What it is sampled by.
    pub numbers: Numbers,
    /// What of the light that is found at the ray's far end reaches the pixel.
    pub throughput: Vec3<f32>,
    /// The light found so far.
    pub radiance: Vec3<f32>,
    /// What a clear body around the ray takes out of it in a unit of length.
    pub absorption: Vec3<f32>,
    /// Whether it goes through a clear body.
    pub is_inside: bool,
    /// The density, by solid angle, with which the ray's direction was drawn where lamps are
    /// searched for as well; 0 where only the ray itself finds them.
    pub density: f32,
    /// The ray's number.
    pub leg: u32,
    /// How often it may still be scattered.
    pub bounces: u32,
    /// How often it may still be mirrored or refracted.
    pub reflections: u32,
    /// How far the path had come on this leg where the ray begins: through holes.
    pub passed: f32,
}

/// How a place looks from where it is seen.
#[derive(Debug, Clone, Copy, Default)]
pub struct Look {
    /// Of the light there, what it scatters evenly.
    pub albedo: Vec3<f32>,
    /// How likely the path goes on as it is scattered evenly; else as it is mirrored.
    pub evenly: f32,
    /// What is mirrored.
    pub reflectance: Vec3<f32>,
    /// By how rough a mirror: its width; 0 where it is smooth.
    pub width: f32,
    /// By what the mirror's light is divided, so that none is lost.
    pub energy: f32,
    /// Whether it is a place in fog, not on a surface.
    pub is_fog: bool,
}

/// A path that begins at the camera.
pub fn path_from_camera<R: Real>(flat: &Flat<R>, ray: Ray<R>, numbers: Numbers) -> Path<R> {
    Path {
        ray,
        numbers,
        throughput: vec3(1.0, 1.0, 1.0),
        radiance: Vec3::default(),
        absorption: Vec3::default(),
        is_inside: false,
        density: 0.0,
        leg: 0,
        bounces: flat.sampling.bounces,
        reflections: flat.sampling.reflections,
        passed: 0.0,
    }
}

/// Where the path's leg begins: its ray does, unless it has come through holes.
pub fn leg_start<R: Real>(path: &Path<R>) -> Vec3<f32> {
    let origin = path.ray.origin.to_f32();
    if path.passed == 0.0 {
        return origin;
    }
    origin - unit_vector(path.ray.direction.to_f32()) * path.passed
}

/// How far it is from there to the hit.
pub fn way_to_hit<R: Real>(path: &Path<R>, hit: Hit<R>) -> f32 {
    (hit.t * vector_length(path.ray.direction)).to_f32() + path.passed
}

/// Adds light that is found at the ray's far end.
pub fn add_light<R: Real>(path: &mut Path<R>, radiance: Vec3<f32>) {
    path.radiance = path.radiance + path.throughput.times(radiance);
}

/// Sends the path on from a place; of the light that it finds there, so much is left.
pub fn send_on<R: Real>(
    path: &mut Path<R>,
    surface: &Surface,
    direction: Vec3<f32>,
    left: Vec3<f32>,
) -> bool {
    let origin = leave_surface::<R>(surface.position, surface.facing, direction, surface.reach);
    path.ray = Ray { origin, direction }.converted();
    path.throughput = path.throughput.times(left);
    // What is no number goes on, and is counted in the end.
    taxicab_length(path.throughput) != 0.0
}

/// The light that a place sends towards the viewer, of what comes straight from lamps: none
/// of a smooth mirror that scatters nothing.
fn lit_by_all<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
) -> Vec3<f32> {
    if taxicab_length(look.albedo) + look.width == 0.0 {
        return Vec3::default();
    }
    let mut even = ambient_light(flat, tracer, path, surface, look);
    let mut glossy = Vec3::default();
    for source in 0..count_sources(flat) {
        let arriving = arriving_from(flat, source, path, surface);
        let cosine = cosine_towards(surface, look, &arriving);
        if cosine <= 0.0 {
            continue;
        }
        let color = arriving.color * divide(cosine, arriving.square);
        if is_shadowed(flat, tracer, path, surface, &arriving) {
            continue;
        }
        let thinned = through_fog(flat, color, &arriving);
        let weight = even_weight(flat, look, &arriving, cosine);
        even = even + thinned * weight;
        glossy = glossy + mirrored_light(flat, path, surface, look, view, &arriving, thinned);
    }
    look.albedo.times(even) + glossy
}

/// Adds what the path finds at a place, and tells whether it goes on.
fn meet_place<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
    surface: &Surface,
    look: &Look,
    view: Vec3<f32>,
) -> bool {
    let light = lit_by_all(flat, tracer, path, surface, look, view);
    add_light(path, light);
    if number(path.numbers, dimension_of(path.leg, LOBE)) < look.evenly {
        return scatter_evenly(path, surface, look);
    }
    mirror_light(path, surface, look, view)
}

/// Adds what the path finds at its ray's far end, and tells whether it goes on.
fn meet<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    path: &mut Path<R>,
    hit: Hit<R>,
) -> bool {
    let view = -unit_vector(path.ray.direction.to_f32());
    pass_medium(path, hit);
    if let Some((surface, look)) = meets_fog(flat, path, hit) {
        return meet_place(flat, tracer, path, &surface, &look, view);
    }
    if hit.id == NO_HIT {
        let sky = seen_sky(flat, path);
        add_light(path, sky);
        return false;
    }
    let surface = surface_of(flat, path.ray, hit);
    let material = flat.material_indices[hit.id as usize];
    let shines = emitted(flat, path, hit, &surface, material);
    add_light(path, shines);
    if is_clear(flat, material) {
        return pass_clear(flat, path, hit, &surface, material);
    }
    let look = look_of(flat, path, hit, &surface, material, view);
    meet_place(flat, tracer, path, &surface, &look, view)
}

/// How a material looks where it was hit.
fn look_of<R: Real>(
    flat: &Flat<R>,
    path: &Path<R>,
    hit: Hit<R>,
    surface: &Surface,
    material: u32,
    view: Vec3<f32>,
) -> Look {
    let mut look = Look {
        energy: 1.0,
        ..Look::default()
    };
    mirror_look(flat, &mut look, path, surface, material, view);
    let albedo = Vec3::from(flat.materials[material as usize].albedo);
    let color = textured(flat, path.ray, hit, surface, material, albedo);
    look.albedo = color.times(vec3(1.0, 1.0, 1.0) - look.reflectance);
    look.evenly = even_chance(path, &look);
    look
}

/// What a ray of the camera sees.
pub fn follow<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    ray: Ray<R>,
    numbers: Numbers,
) -> Pixel {
    let mut path = path_from_camera(flat, ray, numbers);
    let mut pixel = Pixel::default();
    let legs = 1 + flat.sampling.bounces + flat.sampling.reflections;
    for leg in 0..legs {
        path.leg = leg;
        let hit = seen_hit(flat, tracer, &mut path);
        if leg == 0 {
            pixel = layers_of(flat, &path, hit);
        }
        if !meet(flat, tracer, &mut path, hit) || !survives(flat, &mut path) {
            break;
        }
    }
    pixel.color = path.radiance.into();
    pixel
}

/// What sample `sample` of pixel (x, y) sees.
pub fn sample_pixel<R: Real>(
    flat: &Flat<R>,
    tracer: &mut impl Tracer<R>,
    x: u32,
    y: u32,
    sample: u32,
) -> Pixel {
    let numbers = numbers_of(flat.sampling.seed, x, y, sample);
    open_shutter(flat, tracer, numbers);
    let mut ray = camera_ray(&flat.camera, flat.size, x, y);
    ray = in_pixel(flat, ray, numbers);
    ray = through_lens(flat, ray, numbers);
    ray = from_moving_camera(flat, ray, numbers);
    follow(flat, tracer, ray, numbers)
}
