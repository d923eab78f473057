// No textures.

fn textured(ray: Ray, hit: Hit, surface: Surface, material: u32, albedo: vec3<f32>) -> vec3<f32> {
    return albedo;
}
