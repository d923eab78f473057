// Shapes and a camera that move while the shutter is open.
//
// Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: each sample sees them as
// they are at a time of its own.

@group(0) @binding(19) var<uniform> motion: MotionRecord;

// How far the camera goes while the shutter is open, and where it is told how far shapes do:
// by their ids, 0 or one more than a row of `velocities`.
struct MotionRecord {
    camera: vec3<f32>,
    // 0 where no shape moves: then there are no tables.
    moving: u32,
    velocities: u32,
    rows: u32,
    padding: vec2<u32>,
}

// When the sample is taken, see `shutter_time`.
var<private> shutter: f32;

// When a sample is taken: -1/2 as the shutter opens, below 1/2 as it closes.
fn shutter_time(numbers: Numbers) -> f32 {
    return number(numbers, IN_TIME) - 0.5;
}

// Has the shapes stand where they are at the sample's time.
fn open_shutter(numbers: Numbers) {
    shutter = shutter_time(numbers);
}

// A ray of the camera from where it is at the sample's time.
fn from_moving_camera(ray: Ray) -> Ray {
    return Ray(ray.origin + vec3<real>(motion.camera * shutter), ray.direction);
}

// Where a place of the primitive `id` is at the sample's time.
fn moved(place: vec3<real>, id: u32) -> vec3<real> {
    if hidden_end(motion.moving, shutter) == 0u {
        return place;
    }
    let row = word_at(motion.rows, id);
    if row == 0u {
        return place;
    }
    return place + vec3<real>(floats_at(motion.velocities, row - 1u).xyz * shutter);
}
