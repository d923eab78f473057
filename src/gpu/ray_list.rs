//! A list of rays on a device, a portion at a time.

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
use crate::kernel::path::AimRecord;
use crate::kernel::real::Real;
use crate::layout::{Dispatch, Run};
use crate::tier::{Double, Formulas};
use crate::watch::Unwatched;

/// Invocations of a workgroup of `trace_rays`.
const WORKGROUP: u32 = 64;

/// Legs of a dispatch at most, and tests that they make together where there is no tree:
/// some tenths of a second on slow software.
const MOST_LEGS: usize = 1 << 17;
const MOST_TESTS: usize = 1 << 28;

/// A scene, and room for a portion of the rays.
pub(super) struct RayList {
    kernel: Kernel,
    frame: wgpu::BindGroup,
    scene: wgpu::BindGroup,
    dispatch: wgpu::Buffer,
    rays: wgpu::Buffer,
    aims: wgpu::Buffer,
    found: wgpu::Buffer,
    ends: wgpu::Buffer,
    doubtful: wgpu::Buffer,
    retrace: Option<Retrace>,
    orders: Dispatch,
    /// Rays of a portion.
    pub(super) portion: usize,
}

impl RayList {
    /// Makes room for so many rays, and for so many legs of each at once.
    ///
    /// # Errors
    ///
    /// As of a render; [`Error::Limit`] where one dispatch cannot test everything.
    pub(super) fn set_up<R: Real>(
        gpu: &Gpu,
        flat: &Flat<R>,
        entry: Entry,
        rays: usize,
        legs: u32,
    ) -> Result<Self> {
        refuse_lists(flat)?;
        let tests = flat.primitives() as usize;
        let portions = Portions::default();
        if !searches_at_once(flat, portions) {
            return Err(Error::Limit(format!(
                "{tests} tests a ray are more than a dispatch makes: take bounds `tree`"
            )));
        }
        let tests_per_leg = if flat.pairs.is_empty() {
            tests.max(1)
        } else {
            1
        };
        let most = (MOST_TESTS / tests_per_leg).min(MOST_LEGS) / legs as usize;
        let portion = most.max(1).min(rays.max(1));
        let loaded = Loaded::new(gpu, flat, entry, portions, &|_| {})?;
        let filled = BufferUsages::STORAGE | BufferUsages::COPY_DST;
        let working = filled | BufferUsages::COPY_SRC;
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let dispatch = gpu.create_buffer("dispatch", size_of::<Dispatch>() as u64, uniform)?;
        let bytes = |count: usize, size: usize| (count * size) as u64;
        let ray_bytes = bytes(portion, size_of::<[f32; 8]>());
        let rays = gpu.create_buffer("rays", ray_bytes, filled)?;
        let found_bytes = bytes(portion * legs as usize, size_of::<[u32; 4]>());
        let found = gpu.create_buffer("found", found_bytes, working)?;
        // Only paths have aims and ends.
        let paths = if entry == Entry::Paths { portion } else { 0 };
        let aims = gpu.create_buffer("aims", bytes(paths, size_of::<[f32; 4]>()), filled)?;
        let ends = gpu.create_buffer("ends", bytes(paths, size_of::<[f32; 8]>()), working)?;
        let bounded = R::FORMULAS == Formulas::Bounded;
        let list = if bounded { 1 + portion } else { 0 };
        let readable = if gpu.maps_storage() {
            filled | BufferUsages::MAP_READ
        } else {
            working
        };
        let doubtful = gpu.create_buffer("doubtful", bytes(list, size_of::<u32>()), readable)?;
        let mut frame = uniforms(gpu, flat, &loaded.tables)?;
        frame.extend([
            ("dispatch", dispatch.clone()),
            ("rays", rays.clone()),
            ("aims", aims.clone()),
            ("found", found.clone()),
            ("ends", ends.clone()),
            ("doubtful", doubtful.clone()),
        ]);
        let [frame, scene] = loaded.bind(gpu, &frame)?;
        Ok(Self {
            kernel: loaded.kernel,
            frame,
            scene,
            dispatch,
            rays,
            aims,
            found,
            ends,
            doubtful,
            retrace: None,
            orders: all_of(flat),
            portion,
        })
    }

    /// Has rays in doubt traced once more, in wider numbers.
    ///
    /// # Errors
    ///
    /// As [`Retrace::set_up`].
    pub(super) fn with_second(
        mut self,
        gpu: &Gpu,
        second: &Flat<Double>,
        entry: Entry,
    ) -> Result<Self> {
        let shared = [
            ("doubtful", &self.doubtful),
            ("rays", &self.rays),
            ("aims", &self.aims),
            ("found", &self.found),
            ("ends", &self.ends),
        ];
        let portions = Portions::default();
        self.retrace = Some(Retrace::set_up(gpu, second, entry, &shared, portions)?);
        Ok(self)
    }

    /// How often a ray, or a stretch of its path, was traced a second time.
    pub(super) fn retraced(&self) -> u64 {
        self.retrace.as_ref().map_or(0, Retrace::rays)
    }

    /// Hands over a portion of the rays, and where their paths go on, if there are any.
    pub(super) fn load(&self, gpu: &Gpu, rays: &[Ray<f32>], aims: &[AimRecord]) {
        let rays: Vec<[f32; 8]> = rays.iter().map(pack).collect();
        let aims: Vec<[f32; 4]> = aims.iter().map(pack_aim).collect();
        gpu.queue
            .write_buffer(&self.rays, 0, bytemuck::cast_slice(&rays));
        gpu.queue
            .write_buffer(&self.aims, 0, bytemuck::cast_slice(&aims));
    }

    /// Traces the first `rays` rays of those at hand, their paths for so many legs; gives what
    /// they find, ray by ray.
    ///
    /// # Errors
    ///
    /// As of a render; [`Error::Limit`] where a ray is given up.
    pub(super) fn trace(&mut self, gpu: &Gpu, rays: usize, legs: u32) -> Result<Vec<Found>> {
        let orders = Dispatch {
            rows: rays as u32,
            legs,
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
        let quads = read::<[u32; 4]>(gpu, &self.found, rays * legs as usize)?;
        quads.into_iter().map(unpack).collect()
    }

    /// Has the paths at hand go on from where they ended.
    pub(super) fn go_on(&self, gpu: &Gpu, rays: usize) {
        let bytes = rays * size_of::<[f32; 8]>();
        gpu.copy(&self.ends, &self.rays, bytes as u64);
    }

    /// Where the paths at hand ended.
    ///
    /// # Errors
    ///
    /// As [`Gpu::wait`].
    pub(super) fn ends(&self, gpu: &Gpu, rays: usize) -> Result<Vec<Ray<f32>>> {
        let ends = read::<[f32; 8]>(gpu, &self.ends, rays)?;
        Ok(ends.into_iter().map(unpack_ray).collect())
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

fn unpack_ray([ox, oy, oz, _, dx, dy, dz, _]: [f32; 8]) -> Ray<f32> {
    Ray {
        origin: [ox, oy, oz].into(),
        direction: [dx, dy, dz].into(),
    }
}

fn pack_aim(aim: &AimRecord) -> [f32; 4] {
    let [x, y, z]: [f32; 3] = aim.vector.into();
    [x, y, z, aim.kind]
}

fn unpack([first, second, third, id]: [u32; 4]) -> Result<Found> {
    let [first, second, third] = [first, second, third].map(|bits| f64::from(f32::from_bits(bits)));
    if first < 0.0 {
        return Err(given_up());
    }
    Ok(Found::new((first + second) + third, id))
}
