// A pinhole.

fn through_lens(ray: Ray, numbers: Numbers) -> Ray {
    return ray;
}
