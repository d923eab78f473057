// One invocation a pixel: from its ray to its colour.
//
// A tile is a band of rows. It takes one dispatch of `trace_tile` for each run
// of primitives, with the closest hit carried in `pixels` (t in place of the depth), and
// one dispatch of `shade_tile` for each set of buffers that primitives lie in.

// What the ray sees at its hit, a primitive of the bound buffers.
fn shade_hit(ray: Ray, hit: Hit) -> Pixel {
    var surface: Surface;
    sphere_surface(ray, hit, &surface);
    plane_surface(ray, hit, &surface);
    disk_surface(ray, hit, &surface);
    triangle_surface(ray, hit, &surface);
    let material = materials[indices[hit.id - dispatch.first_id]];
    let depth = f32(hit.t * vector_length(ray.direction));
    let color = scattered_light(surface, material.albedo);
    return Pixel(color, depth, surface.normal, hit.id, surface.position, hit.tests);
}

// What the ray sees that meets nothing.
fn shade_miss(ray: Ray, hit: Hit) -> Pixel {
    let color = background_color(vec3<f32>(ray.direction));
    return Pixel(color, 0.0, vec3<f32>(), NO_HIT, vec3<f32>(), hit.tests);
}

// Finds the closest hit of the tile's pixels among the primitives of the
// dispatch and of those before it.
@compute @workgroup_size(8, 8)
fn trace_tile(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let index = at.y * dispatch.size.x + at.x;
    var hit = no_hit();
    if dispatch.fresh == 0u {
        hit = Hit(pixels[index].depth, pixels[index].id, pixels[index].tests);
    }
    let ray = camera_ray(dispatch.size, at.x, dispatch.first_row + at.y);
    closest_hit(probe_of(ray), &hit);
    pixels[index].depth = hit.t;
    pixels[index].id = hit.id;
    pixels[index].tests = hit.tests;
}

// Colours the tile's pixels whose closest hit lies in the bound buffers, and
// those that hit nothing.
@compute @workgroup_size(8, 8)
fn shade_tile(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let index = at.y * dispatch.size.x + at.x;
    let hit = Hit(pixels[index].depth, pixels[index].id, pixels[index].tests);
    let ray = camera_ray(dispatch.size, at.x, dispatch.first_row + at.y);
    if hit.id == NO_HIT {
        pixels[index] = shade_miss(ray, hit);
    } else if hit.id - dispatch.first_id < dispatch.primitives {
        pixels[index] = shade_hit(ray, hit);
    }
}
