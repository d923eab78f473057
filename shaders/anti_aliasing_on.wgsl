// A pixel's samples go through it all over, not through one point.

// A ray of the camera, moved to the sample's place in the pixel.
fn in_pixel(ray: Ray, size: vec2<u32>, numbers: Numbers) -> Ray {
    let pair = number_pair(numbers, IN_PIXEL);
    let eye = camera_at();
    // In halves of the picture's size, as the camera's axes reach from its middle to its edges.
    let right = divide_f32(2.0 * sampling.spread * (pair.x - 0.5), f32(size.x));
    let down = divide_f32(2.0 * sampling.spread * (pair.y - 0.5), f32(size.y));
    let moved = ray.direction + eye.right * real(right) - eye.up * real(down);
    return Ray(ray.origin, moved);
}
