// One ray: from its search to its colour.

// Tests the primitives in some rows of a kind's table, as src/flat.rs counts kinds,
// and tells the row that it came to.
fn test_rows(probe: Probe, kind: u32, begin: u32, end: u32, hit: ptr<function, Hit>) -> u32 {
    if kind == 0u {
        return test_spheres(probe, begin, end, hit);
    }
    if kind == 1u {
        return test_disks(probe, begin, end, hit);
    }
    return test_triangles(probe, begin, end, hit);
}

// The surface at the ray's hit.
fn surface_of(ray: Ray, hit: Hit) -> Surface {
    var surface: Surface;
    sphere_surface(ray, hit, &surface);
    plane_surface(ray, hit, &surface);
    disk_surface(ray, hit, &surface);
    triangle_surface(ray, hit, &surface);
    return surface;
}

// What the ray sees at its hit.
fn shade_hit(ray: Ray, hit: Hit) -> Pixel {
    let surface = surface_of(ray, hit);
    let material = material_of(hit.id);
    let depth = f32(hit.t * vector_length(ray.direction));
    let color = scattered_light(surface, material.albedo);
    return Pixel(color, depth, surface.normal, hit.id, surface.position, hit.tests);
}

// What the ray sees that meets nothing.
fn shade_miss(ray: Ray, hit: Hit) -> Pixel {
    let color = background_color(vec3<f32>(ray.direction));
    return Pixel(color, 0.0, vec3<f32>(), NO_HIT, vec3<f32>(), hit.tests);
}

// What the ray sees.
fn shade(ray: Ray, hit: Hit) -> Pixel {
    if hit.id == NO_HIT {
        return shade_miss(ray, hit);
    }
    return shade_hit(ray, hit);
}
