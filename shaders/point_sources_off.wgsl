// No point lights.

fn arriving_from_point(light: u32, position: vec3<f32>) -> Arriving {
    return nothing_arriving();
}
