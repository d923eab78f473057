//! What a GPU search costs that is written plainly: `plain.wgsl`, over the same tree.

use std::time::Instant;

use bytemuck::{Pod, Zeroable};
use rayproof::bounds::primitive_boxes;
use rayproof::bounds::tree::{Node, Tree, build};
use rayproof::flat::{Flat, Kind};
use rayproof::gpu::adapter::adapters;
use rayproof::kernel::triangles::triangle_of;
use wgpu::util::DeviceExt;
use wgpu::{BufferUsages, Device, Queue};

use crate::{Found, Outcome, Search};

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Pair {
    left_low: [f32; 3],
    left: u32,
    left_high: [f32; 3],
    right: u32,
    right_low: [f32; 3],
    padding_0: u32,
    right_high: [f32; 3],
    padding_1: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Triangle {
    a: [f32; 3],
    id: u32,
    b: [f32; 3],
    padding_0: u32,
    c: [f32; 3],
    padding_1: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Camera {
    right: [f32; 3],
    width: u32,
    up: [f32; 3],
    height: u32,
    forward: [f32; 3],
    padding: u32,
}

/// Searches, from the submission to the end; what is read back is not timed.
pub fn on_gpu(flat: &Flat<f32>) -> Outcome<Search<'_>> {
    let plain = Plain::new(flat)?;
    Ok(Box::new(move |found| {
        let started = Instant::now();
        plain.run()?;
        let seconds = started.elapsed().as_secs_f64();
        plain.read(found)?;
        Ok(seconds)
    }))
}

/// The plain search, ready to run.
struct Plain {
    device: Device,
    queue: Queue,
    pipeline: wgpu::ComputePipeline,
    bindings: wgpu::BindGroup,
    found: wgpu::Buffer,
    size: [u32; 2],
    ids: Vec<u32>,
}

impl Plain {
    fn new(flat: &Flat<f32>) -> Outcome<Self> {
        let (device, queue) = open()?;
        let tree = build(primitive_boxes(flat), &|_| Kind::Triangle);
        let buffer = |bytes: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: None,
                contents: bytes,
                usage,
            })
        };
        let camera = Camera {
            right: flat.camera.right,
            width: flat.size[0],
            up: flat.camera.up,
            height: flat.size[1],
            forward: flat.camera.forward,
            padding: 0,
        };
        let pixels = flat.size[0] as usize * flat.size[1] as usize;
        let found = buffer(
            &vec![0; 8 * pixels],
            BufferUsages::STORAGE | BufferUsages::COPY_SRC,
        );
        let module = device.create_shader_module(wgpu::include_wgsl!("plain.wgsl"));
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("trace"),
            compilation_options: Default::default(),
            cache: None,
        });
        let buffers = [
            buffer(bytemuck::bytes_of(&camera), BufferUsages::UNIFORM),
            buffer(bytemuck::cast_slice(&pairs(&tree)), BufferUsages::STORAGE),
            buffer(
                bytemuck::cast_slice(&triangles(flat, &tree)),
                BufferUsages::STORAGE,
            ),
            found.clone(),
        ];
        let entries: Vec<_> = (0..)
            .zip(&buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        Ok(Self {
            device,
            queue,
            pipeline,
            bindings,
            found,
            size: flat.size,
            ids: tree.ids,
        })
    }

    fn run(&self) -> Outcome<()> {
        let mut encoder = self.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &self.bindings, &[]);
            pass.dispatch_workgroups(self.size[0].div_ceil(8), self.size[1].div_ceil(8), 1);
        }
        self.queue.submit([encoder.finish()]);
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        Ok(())
    }

    fn read(&self, found: &mut [Found]) -> Outcome<()> {
        let bytes = self.found.size();
        let staging = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: bytes,
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(&self.found, 0, &staging, 0, bytes);
        self.queue.submit([encoder.finish()]);
        staging.map_async(wgpu::MapMode::Read, .., |_| {});
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        let view = staging.get_mapped_range(..)?;
        let records: &[[u32; 2]] = bytemuck::cast_slice(&view);
        for (found, &[t, row]) in found.iter_mut().zip(records) {
            *found = match self.ids.get(row as usize) {
                Some(&id) => (f32::from_bits(t), id),
                None => (f32::INFINITY, row),
            };
        }
        Ok(())
    }
}

fn open() -> Outcome<(Device, Queue)> {
    let best = adapters().into_iter().next();
    let adapter = best.ok_or("there is no GPU adapter")?;
    let descriptor = wgpu::DeviceDescriptor {
        required_limits: adapter.limits(),
        ..Default::default()
    };
    Ok(pollster::block_on(adapter.request_device(&descriptor))?)
}

fn pairs(tree: &Tree) -> Vec<Pair> {
    let mut place = vec![0; tree.nodes.len()];
    let inner = tree.nodes.iter().enumerate().filter(|(_, n)| n.count == 0);
    for (pair, (node, _)) in (0..).zip(inner) {
        place[node] = pair;
    }
    let child = |index: usize| {
        let node = &tree.nodes[index];
        if node.count == 0 {
            place[index]
        } else {
            1 << 31 | node.count << 26 | node.first
        }
    };
    let pair = |node: &Node| {
        let (left, right) = (node.first as usize, node.first as usize + 1);
        let [left_box, right_box] = [left, right].map(|index| tree.nodes[index].aabb);
        Pair {
            left_low: left_box.low.into(),
            left: child(left),
            left_high: left_box.high.into(),
            right: child(right),
            right_low: right_box.low.into(),
            padding_0: 0,
            right_high: right_box.high.into(),
            padding_1: 0,
        }
    };
    let inner = tree.nodes.iter().filter(|node| node.count == 0);
    inner.map(pair).collect()
}

/// In the order of the leaves; `id` is the place.
fn triangles(flat: &Flat<f32>, tree: &Tree) -> Vec<Triangle> {
    let mut row_of = vec![0; flat.primitives() as usize];
    for (row, corners) in flat.triangles.iter().enumerate() {
        row_of[corners.id as usize] = row;
    }
    let placed = tree.ids.iter().zip(0..);
    placed
        .map(|(&id, place)| {
            let triangle = triangle_of(flat, flat.triangles[row_of[id as usize]]);
            Triangle {
                a: triangle.a,
                id: place,
                b: triangle.b,
                padding_0: 0,
                c: triangle.c,
                padding_1: 0,
            }
        })
        .collect()
}
