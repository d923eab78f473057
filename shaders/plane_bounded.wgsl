// Where a ray meets a plane, and how far that may be off. The bounds are derived in
// docs/numerics.md.

// The error of height and slope, in parts of the lengths that they are made of: at most 12
// roundings, 8 of them the direction's.
const PLANE_ERROR: f32 = 16.0 / 16777216.0;

// Where the ray meets the plane through `point`, within bounds.
fn bound_crossing(ray: Ray, point: vec3<real>, normal: vec3<real>) -> Meeting {
    let height = dot_product(point - ray.origin, normal);
    let slope = dot_product(ray.direction, normal);
    let unit = taxicab_length(normal) * PLANE_ERROR;
    let height_error = (taxicab_length(point) + taxicab_length(ray.origin)) * unit;
    let slope_error = taxicab_length(ray.direction) * unit;
    if abs(slope) <= slope_error * 4.0 {
        return doubtful_meeting(divide(abs(height) - height_error, abs(slope) + slope_error));
    }
    let t = divide(height, slope);
    let error = divide(height_error + abs(t) * slope_error, abs(slope));
    return meeting_within(t, error * 1.5);
}

// Where the ray meets the plane, within bounds.
fn meet_plane(probe: Probe, plane: Plane) -> Meeting {
    return bound_crossing(probe.ray, plane.point, plane.normal);
}
