// A closest-hit search as one would write it first: two boxes of six floats a node, in
// storage buffers; nested ifs; Möller and Trumbore's test.

struct Pair {
    left_low: vec3<f32>,
    left: u32,
    left_high: vec3<f32>,
    right: u32,
    right_low: vec3<f32>,
    padding_0: u32,
    right_high: vec3<f32>,
    padding_1: u32,
}

struct Triangle {
    a: vec3<f32>,
    id: u32,
    b: vec3<f32>,
    padding_0: u32,
    c: vec3<f32>,
    padding_1: u32,
}

struct Camera {
    right: vec3<f32>,
    width: u32,
    up: vec3<f32>,
    height: u32,
    forward: vec3<f32>,
    padding: u32,
}

struct Found {
    t: f32,
    id: u32,
}

@group(0) @binding(0) var<uniform> camera: Camera;
@group(0) @binding(1) var<storage, read> pairs: array<Pair>;
@group(0) @binding(2) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(3) var<storage, read_write> found: array<Found>;

const LEAF: u32 = 0x80000000u;
const FAR: f32 = 3.4e38;

// Where the ray enters the box, or FAR.
fn enter_box(inverse: vec3<f32>, low: vec3<f32>, high: vec3<f32>, best: f32) -> f32 {
    let to_low = low * inverse;
    let to_high = high * inverse;
    let near = min(to_low, to_high);
    let far = max(to_low, to_high);
    let enter = max(max(near.x, near.y), max(near.z, 0.0));
    let exit = min(min(far.x, far.y), min(far.z, best));
    if enter <= exit {
        return enter;
    }
    return FAR;
}

fn meet(direction: vec3<f32>, triangle: Triangle) -> f32 {
    let ab = triangle.b - triangle.a;
    let ac = triangle.c - triangle.a;
    let across = cross(direction, ac);
    let determinant = dot(ab, across);
    if determinant == 0.0 {
        return FAR;
    }
    let from_a = -triangle.a;
    let u = dot(from_a, across) / determinant;
    if u < 0.0 || u > 1.0 {
        return FAR;
    }
    let normal = cross(from_a, ab);
    let v = dot(direction, normal) / determinant;
    if v < 0.0 || u + v > 1.0 {
        return FAR;
    }
    let t = dot(ac, normal) / determinant;
    if t > 0.0 {
        return t;
    }
    return FAR;
}

@compute @workgroup_size(8, 8)
fn trace(@builtin(global_invocation_id) pixel: vec3<u32>) {
    if pixel.x >= camera.width || pixel.y >= camera.height {
        return;
    }
    let x = (2.0 * (f32(pixel.x) + 0.5) - f32(camera.width)) / f32(camera.width);
    let y = (2.0 * (f32(pixel.y) + 0.5) - f32(camera.height)) / f32(camera.height);
    let direction = camera.right * x - camera.up * y + camera.forward;
    let inverse = 1.0 / direction;
    var best = Found(FAR, 0xffffffffu);
    var stack: array<u32, 64>;
    var depth = 1u;
    while depth > 0u {
        depth--;
        let at = stack[depth];
        if (at & LEAF) != 0u {
            let first = at & 0x03ffffffu;
            let count = (at >> 26u) & 31u;
            for (var row = first; row < first + count; row++) {
                let t = meet(direction, triangles[row]);
                if t < best.t {
                    best = Found(t, triangles[row].id);
                }
            }
        } else {
            let left = enter_box(inverse, pairs[at].left_low, pairs[at].left_high, best.t);
            let right = enter_box(inverse, pairs[at].right_low, pairs[at].right_high, best.t);
            if left < FAR && right < FAR {
                let left_first = left <= right;
                stack[depth] = select(pairs[at].left, pairs[at].right, left_first);
                stack[depth + 1u] = select(pairs[at].right, pairs[at].left, left_first);
                depth += 2u;
            } else if left < FAR {
                stack[depth] = pairs[at].left;
                depth++;
            } else if right < FAR {
                stack[depth] = pairs[at].right;
                depth++;
            }
        }
    }
    found[pixel.y * camera.width + pixel.x] = best;
}
