// Disk: its plane, then the distance from its centre.

// The t > 0 at which the ray meets the disk, its rim included, or MISS.
fn intersect_disk(ray: Ray, disk: Disk) -> real {
    let t = intersect_plane(ray, disk.center, disk.normal);
    let from_center = (ray.origin - disk.center) + ray.direction * t;
    if dot_product(from_center, from_center) <= disk.radius * disk.radius {
        return t;
    }
    return MISS;
}
