// A scene without disks.

fn closest_disk(ray: Ray, hit: ptr<function, Hit>) {
}

fn disk_surface(ray: Ray, hit: Hit, surface: ptr<function, Surface>) {
}
