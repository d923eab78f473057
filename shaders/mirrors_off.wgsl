// Nothing mirrors.

fn mirror_look(look: ptr<function, Look>, path: Path, surface: Surface, material: u32, view: vec3<f32>) {
}

fn mirrored_light(
    path: Path,
    surface: Surface,
    look: Look,
    view: vec3<f32>,
    arriving: Arriving,
    color: vec3<f32>,
) -> vec3<f32> {
    return vec3<f32>();
}

fn mirror_light(path: ptr<function, Path>, surface: Surface, look: Look, view: vec3<f32>) -> bool {
    return false;
}
