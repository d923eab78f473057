// A lens: what is not at its focus is out of focus.
//
// Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984: a thin lens bends all rays
// through it that belong to a point of the picture to one point of the plane in focus.

@group(0) @binding(18) var<uniform> lens: LensRecord;

// The lens's axes, as long as its radius; and how far a ray must turn at the end of each to
// meet at the focus, at distance 1.
struct LensRecord {
    right: vec3<f32>,
    radius: f32,
    up: vec3<f32>,
    turn_right: vec3<f32>,
    turn_up: vec3<f32>,
}

// A ray of the camera through the sample's place on the lens.
fn through_lens(ray: Ray, numbers: Numbers) -> Ray {
    if hidden(lens.radius, f32(ray.direction.x)) == 0.0 {
        return ray;
    }
    let place = disk_point(number_pair(numbers, IN_LENS));
    let aside = lens.right * place.x + lens.up * place.y;
    let turn = lens.turn_right * place.x + lens.turn_up * place.y;
    return Ray(ray.origin + vec3<real>(aside), ray.direction - vec3<real>(turn));
}
