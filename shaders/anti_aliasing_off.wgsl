// One sample a pixel, through the point that the camera gives.

fn in_pixel(ray: Ray, size: vec2<u32>, numbers: Numbers) -> Ray {
    return ray;
}
