// Where a ray meets a sphere, within the sphere's own box.

// Where the ray meets the sphere.
fn meet_sphere(probe: Probe, sphere: Sphere) -> Meeting {
    let t = intersect_sphere(probe.ray, sphere);
    if t < MISS {
        let own = ball_box(vec3<f32>(sphere.center), f32(sphere.radius));
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    return certain_meeting(MISS);
}
