// Where a ray meets a plane.

// Where the ray meets the plane.
fn meet_plane(probe: Probe, plane: Plane) -> Meeting {
    return certain_meeting(intersect_plane(probe.ray, plane.point, plane.normal));
}
