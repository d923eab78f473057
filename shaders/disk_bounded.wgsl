// Where a ray meets a disk, and how far that may be off. The bounds are derived in
// docs/numerics.md.

// Where the ray meets the disk, within bounds, wherever that is.
fn bound_disk(probe: Probe, disk: Disk) -> Meeting {
    let ray = probe.ray;
    let crossing = bound_crossing(ray, disk.center, disk.normal);
    if crossing.high >= MISS {
        return crossing;
    }
    let from_center = (ray.origin - disk.center) + ray.direction * crossing.t;
    let reach = (taxicab_length(disk.center) + taxicab_length(ray.origin)) + disk.radius;
    let along = taxicab_length(ray.direction) * (crossing.high - crossing.low);
    let error = along + reach * ERROR;
    let slack = (2.0 * disk.radius + error) * error;
    let room = disk.radius * disk.radius - dot_product(from_center, from_center);
    if room < -slack {
        return certain_meeting(MISS);
    }
    if room <= slack {
        return doubtful_meeting(crossing.low);
    }
    return crossing;
}

// Where the ray meets the disk within the disk's own box, within bounds.
fn meet_disk(probe: Probe, disk: Disk) -> Meeting {
    let meeting = bound_disk(probe, disk);
    if meeting.low >= MISS {
        return meeting;
    }
    let own = ball_box(vec3<f32>(disk.center), f32(disk.radius));
    return meeting_in_box(probe.slabs, own, meeting);
}
