//! Any rays on a device, listed.

use wgpu::BufferUsages;

use super::device::Gpu;
use super::kernel::Kernel;
use super::loaded::Loaded;
use super::portions::Portions;
use super::render::searches_at_once;
use super::retrace::Retrace;
use super::selfcheck::read;
use super::stage::uniforms;
use crate::effects::Entry;
use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::found::{Found, given_up, refuse_lists};
use crate::kernel::camera::Ray;
use crate::kernel::real::Real;
use crate::layout::{Dispatch, Run};
use crate::tier::{Bounded, Double, Formulas};
use crate::watch::Unwatched;

/// Invocations of a workgroup of `trace_rays`.
const WORKGROUP: u32 = 64;

/// Rays of a dispatch at most, and tests that they make together where there is no tree:
/// some tenths of a second on slow software.
const MOST_RAYS: usize = 1 << 17;
const MOST_TESTS: usize = 1 << 28;

/// Finds the closest hit of each ray, in numbers of one kind.
///
/// # Errors
///
/// As of a render; [`Error::Limit`] where one dispatch cannot test everything.
pub fn trace_rays<R: Real>(gpu: &Gpu, flat: &Flat<R>, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
    RayList::set_up(gpu, flat, rays.len())?.run(gpu, rays)
}

/// Finds the closest hit of each ray with bounds of the error, and of those in doubt once
/// more in wider numbers; tells how many those are.
///
/// # Errors
///
/// As [`trace_rays`].
pub fn trace_adaptively(
    gpu: &Gpu,
    first: &Flat<Bounded>,
    second: &Flat<Double>,
    rays: &[Ray<f32>],
) -> Result<(Vec<Found>, u64)> {
    let mut list = RayList::set_up(gpu, first, rays.len())?;
    let shared = [
        ("doubtful", &list.doubtful),
        ("rays", &list.rays),
        ("found", &list.found),
    ];
    let portions = Portions::default();
    let retrace = Retrace::set_up(gpu, second, Entry::DoubtfulRays, &shared, portions)?;
    list.retrace = Some(retrace);
    let found = list.run(gpu, rays)?;
    let retraced = list.retrace.as_ref().map_or(0, Retrace::rays);
    Ok((found, retraced))
}

/// A scene, and room for a portion of the rays.
struct RayList {
    kernel: Kernel,
    frame: wgpu::BindGroup,
    scene: wgpu::BindGroup,
    dispatch: wgpu::Buffer,
    rays: wgpu::Buffer,
    found: wgpu::Buffer,
    doubtful: wgpu::Buffer,
    retrace: Option<Retrace>,
    orders: Dispatch,
    portion: usize,
}

impl RayList {
    fn set_up<R: Real>(gpu: &Gpu, flat: &Flat<R>, rays: usize) -> Result<Self> {
        refuse_lists(flat)?;
        let tests = flat.primitives() as usize;
        let portions = Portions::default();
        if !searches_at_once(flat, portions) {
            return Err(Error::Limit(format!(
                "{tests} tests a ray are more than a dispatch makes: take bounds `tree`"
            )));
        }
        let tests_per_ray = if flat.pairs.is_empty() {
            tests.max(1)
        } else {
            1
        };
        let portion = (MOST_TESTS / tests_per_ray).min(MOST_RAYS).min(rays.max(1));
        let loaded = Loaded::new(gpu, flat, Entry::Rays, portions, &|_| {})?;
        let filled = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let working = filled | BufferUsages::COPY_SRC;
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, uniform)?;
        let rays = gpu.create_buffer("rays", (portion * size_of::<[f32; 8]>()) as u64, filled)?;
        let found =
            gpu.create_buffer("found", (portion * size_of::<[u32; 4]>()) as u64, working)?;
        let bounded = R::FORMULAS == Formulas::Bounded;
        let list = if bounded { 1 + portion } else { 0 };
        let readable = if gpu.maps_storage() {
            filled | BufferUsages::MAP_READ
        } else {
            working
        };
        let list_bytes = (list * size_of::<u32>()) as u64;
        let doubtful = gpu.create_buffer("doubtful", list_bytes, readable)?;
        let mut frame = uniforms(gpu, flat, &loaded.tables)?;
        frame.extend([
            ("dispatch", dispatch.clone()),
            ("rays", rays.clone()),
            ("found", found.clone()),
            ("doubtful", doubtful.clone()),
        ]);
        let [frame, scene] = loaded.bind(gpu, &frame)?;
        Ok(Self {
            kernel: loaded.kernel,
            frame,
            scene,
            dispatch,
            rays,
            found,
            doubtful,
            retrace: None,
            orders: all_of(flat),
            portion,
        })
    }

    fn run(&mut self, gpu: &Gpu, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        let mut found = Vec::with_capacity(rays.len());
        for rays in rays.chunks(self.portion) {
            let packed: Vec<[f32; 8]> = rays.iter().map(pack).collect();
            gpu.queue
                .write_buffer(&self.rays, 0, bytemuck::cast_slice(&packed));
            let orders = Dispatch {
                rows: rays.len() as u32,
                ..self.orders
            };
            gpu.queue
                .write_buffer(&self.dispatch, 0, bytemuck::bytes_of(&orders));
            let workgroups = [orders.rows.div_ceil(WORKGROUP), 1, 1];
            let groups = [&self.frame, &self.scene];
            self.kernel
                .run(gpu, "trace_rays", &groups, workgroups, None)?;
            if let Some(retrace) = &mut self.retrace {
                retrace.run(gpu, &self.doubtful, &orders, None, &Unwatched)?;
            }
            for quad in read::<[u32; 4]>(gpu, &self.found, rays.len())? {
                found.push(unpack(quad)?);
            }
        }
        Ok(found)
    }
}

/// Orders to test all there is.
fn all_of<R>(flat: &Flat<R>) -> Dispatch {
    let run = |end: usize| Run {
        begin: 0,
        end: end as u32,
        padding: [0; 2],
    };
    Dispatch {
        size: [1, 1],
        spheres: run(flat.spheres.len()),
        planes: run(flat.planes.len()),
        disks: run(flat.disks.len()),
        triangles: run(flat.triangles.len()),
        fresh: 1,
        slices: 1,
        last: 1,
        ..Dispatch::default()
    }
}

fn pack(ray: &Ray<f32>) -> [f32; 8] {
    let ([ox, oy, oz], [dx, dy, dz]): ([f32; 3], [f32; 3]) =
        (ray.origin.into(), ray.direction.into());
    [ox, oy, oz, 0.0, dx, dy, dz, 0.0]
}

fn unpack([first, second, third, id]: [u32; 4]) -> Result<Found> {
    let [first, second, third] = [first, second, third].map(|bits| f64::from(f32::from_bits(bits)));
    if first < 0.0 {
        return Err(given_up());
    }
    Ok(Found::new((first + second) + third, id))
}
