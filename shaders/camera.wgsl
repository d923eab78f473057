// From a pixel to its ray.

// The points origin + t * direction, t > 0. The direction has any length.
struct Ray {
    origin: vec3<real>,
    direction: vec3<real>,
}

// `pixel` as a fraction of half the size: -1 at the near edge, 1 at the far edge.
fn screen_coordinate(pixel: u32, offset: real, size: u32) -> real {
    let at = 2.0 * (real(pixel) + offset);
    return divide(at - real(size), real(size));
}

// The ray through pixel (x, y), y downward from the top row. The scene is
// camera-relative, so the origin is zero.
fn camera_ray(size: vec2<u32>, x: u32, y: u32) -> Ray {
    let sx = screen_coordinate(x, camera.offset_x, size.x);
    let sy = screen_coordinate(y, camera.offset_y, size.y);
    let across = camera.right * sx - camera.up * sy;
    return Ray(vec3<real>(0.0, 0.0, 0.0), across + camera.forward);
}
