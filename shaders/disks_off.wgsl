// A scene without disks.

fn test_disks(probe: Probe, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    return end;
}

fn disk_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}

fn disk_is_left(ray: Ray, hit: Hit) -> bool {
    return false;
}
