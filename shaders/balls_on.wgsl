// Bounding balls.

// The ball in a row of the table.
fn ball_at(row: u32) -> Sphere {
    let quad = reals_at(tables.balls, row);
    return Sphere(quad.xyz, quad.w);
}

// Whether the ray meets the ball in a row of the table.
fn meets_bounding_ball(probe: Probe, row: u32) -> bool {
    return meets_ball(probe.ray, ball_at(row));
}
