// What the host writes and reads: one struct a record of src/layout.rs.

struct Camera {
    right: vec3<real>,
    offset_x: real,
    up: vec3<real>,
    offset_y: real,
    forward: vec3<real>,
}

struct Sphere {
    center: vec3<real>,
    radius: real,
}

struct Plane {
    point: vec3<real>,
    normal: vec3<real>,
}

struct Disk {
    center: vec3<real>,
    radius: real,
    normal: vec3<real>,
}

struct Triangle {
    a: vec3<real>,
    b: vec3<real>,
    c: vec3<real>,
}

struct CornerNormals {
    a: vec3<f32>,
    b: vec3<f32>,
    c: vec3<f32>,
}

struct Pair {
    left_low: vec3<f32>,
    left: u32,
    left_high: vec3<f32>,
    left_count: u32,
    right_low: vec3<f32>,
    right: u32,
    right_high: vec3<f32>,
    right_count: u32,
}

struct MaterialRecord {
    albedo: vec3<f32>,
}

struct LightRecord {
    vector: vec3<f32>,
    inverse_square: u32,
    color: vec3<f32>,
}

struct Surroundings {
    start: vec3<f32>,
    offset: f32,
    end: vec3<f32>,
    slope: f32,
    ambient: vec3<f32>,
    point_lights: u32,
}

// A run of primitives of one kind; the primitive id of index i is first_id + i.
struct Run {
    begin: u32,
    end: u32,
    first_id: u32,
    padding: u32,
}

struct Dispatch {
    size: vec2<u32>,
    first_row: u32,
    rows: u32,
    spheres: Run,
    planes: Run,
    disks: Run,
    triangles: Run,
    first_id: u32,
    primitives: u32,
    fresh: u32,
}

struct Pixel {
    color: vec3<f32>,
    depth: f32,
    normal: vec3<f32>,
    id: u32,
    position: vec3<f32>,
    tests: u32,
}

@group(0) @binding(0) var<uniform> dispatch: Dispatch;
@group(0) @binding(1) var<uniform> camera: Camera;
@group(0) @binding(2) var<storage, read_write> pixels: array<Pixel>;
@group(0) @binding(3) var<uniform> surroundings: Surroundings;
@group(1) @binding(0) var<storage, read> materials: array<MaterialRecord>;
@group(1) @binding(1) var<storage, read> lights: array<LightRecord>;
// The material of each primitive, then the primitives of the tree's leaves.
@group(2) @binding(0) var<storage, read> indices: array<u32>;
