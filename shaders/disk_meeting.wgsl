// Where a ray meets a disk, within the disk's own box.

// Where the ray meets the disk.
fn meet_disk(probe: Probe, disk: Disk) -> Meeting {
    let t = intersect_disk(probe.ray, disk);
    if t < MISS {
        let own = ball_box(vec3<f32>(disk.center), f32(disk.radius));
        return certain_meeting(clamp_to_box(probe.slabs, own, t));
    }
    return certain_meeting(MISS);
}
