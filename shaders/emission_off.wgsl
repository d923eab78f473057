// No surface shines by itself.

fn emitted(path: Path, hit: Hit, surface: Surface, material: u32) -> vec3<f32> {
    return vec3<f32>();
}
