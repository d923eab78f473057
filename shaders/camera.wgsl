// From a pixel to its ray.

// The points origin + t * direction, t > 0. The direction has any length.
struct Ray {
    origin: vec3<real>,
    direction: vec3<real>,
}

// The camera, of its numbers' parts.
fn camera_at() -> Camera {
    let right = reals_of(camera[0]);
    let up = reals_of(camera[1]);
    return Camera(right.xyz, right.w, up.xyz, up.w, reals_of(camera[2]).xyz);
}

// `pixel` as a fraction of half the size: -1 at the near edge, 1 at the far edge.
fn screen_coordinate(pixel: u32, offset: real, size: u32) -> real {
    let at = 2.0 * (real(pixel) + offset);
    return divide(at - real(size), real(size));
}

// The ray through pixel (x, y), y downward from the top row. The scene is
// camera-relative, so the origin is zero.
fn camera_ray(size: vec2<u32>, x: u32, y: u32) -> Ray {
    let eye = camera_at();
    let sx = screen_coordinate(x, eye.offset_x, size.x);
    let sy = screen_coordinate(y, eye.offset_y, size.y);
    let across = eye.right * sx - eye.up * sy;
    return Ray(vec3<real>(0.0, 0.0, 0.0), across + eye.forward);
}
