// A scene without disks.

fn test_disk(probe: Probe, row: u32, hit: ptr<function, Hit>) {
}

fn closest_disk(probe: Probe, hit: ptr<function, Hit>) {
}

fn disk_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}
