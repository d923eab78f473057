// Bounding balls.

// Whether the ray meets the ball in a row of the table.
fn meets_bounding_ball(probe: Probe, row: u32) -> bool {
    return meets_ball(probe.ray, ball_at(row));
}
