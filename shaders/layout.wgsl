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
    power: real,
}

struct Ball {
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

struct MaterialRecord {
    albedo: vec3<f32>,
}

struct LightRecord {
    vector: vec3<f32>,
    flags: u32,
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

struct Volume {
    bound: u32,
    first: u32,
    count: u32,
    skip: u32,
}

struct BoxRecord {
    low: vec3<f32>,
    high: vec3<f32>,
}

// Where each table of the scene begins, in quads.
struct Tables {
    spheres: u32,
    sphere_ids: u32,
    planes: u32,
    disks: u32,
    disk_ids: u32,
    triangles: u32,
    vertices: u32,
    vertex_normals: u32,
    pairs: u32,
    volumes: u32,
    volume_count: u32,
    tile_words: u32,
    balls: u32,
    boxes: u32,
    materials: u32,
    material_indices: u32,
    lights: u32,
    light_count: u32,
    first_plane: u32,
    first_disk: u32,
    first_triangle: u32,
}

// A level of the quad-tree over the screen.
struct ScreenLevel {
    side: u32,
    across: u32,
    first: u32,
    is_root: u32,
    parent_across: u32,
    parent_first: u32,
    padding: vec2<u32>,
}

// A run of primitives of one kind, as rows of its table.
struct Run {
    begin: u32,
    end: u32,
    padding: vec2<u32>,
}

struct Dispatch {
    size: vec2<u32>,
    first_row: u32,
    rows: u32,
    spheres: Run,
    planes: Run,
    disks: Run,
    triangles: Run,
    fresh: u32,
    slices: u32,
    steps: u32,
    last: u32,
    first_doubtful: u32,
    legs: u32,
    sample: u32,
    band_row: u32,
}

struct HitRecord {
    t: real,
    id: u32,
    row: u32,
    tests: u32,
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
@group(0) @binding(1) var<uniform> camera: array<array<vec4<f32>, PARTS>, 3>;
@group(0) @binding(2) var<uniform> surroundings: Surroundings;
@group(0) @binding(3) var<uniform> tables: Tables;
@group(0) @binding(4) var<storage, read_write> hits: array<HitRecord>;
@group(0) @binding(5) var<storage, read_write> pixels: array<Pixel>;
