// No mirror is rough.

fn energy_of(material: u32, width: f32, cosine: f32) -> f32 {
    return 1.0;
}

fn glossy_light(
    path: Path,
    surface: Surface,
    look: Look,
    view: vec3<f32>,
    arriving: Arriving,
    color: vec3<f32>,
) -> vec3<f32> {
    return vec3<f32>();
}

fn scatter_glossily(path: ptr<function, Path>, surface: Surface, look: Look, view: vec3<f32>) -> bool {
    return false;
}
