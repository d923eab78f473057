// Nothing moves.

fn open_shutter(numbers: Numbers) {
}

fn from_moving_camera(ray: Ray) -> Ray {
    return ray;
}
