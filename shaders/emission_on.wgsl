// Surfaces that shine by themselves.

// The radiance of a surface by itself; of a lamp, as much as is due to paths that find it.
fn emitted(path: Path, hit: Hit, surface: Surface, material: u32) -> vec3<f32> {
    let radiance = finish_at(material, EMISSION).xyz;
    return radiance * weight_of_lamp(path, hit, surface, material);
}
