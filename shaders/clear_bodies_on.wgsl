// Clear bodies: light goes through them, bent, and is thrown back at their surface.
//
// Of a bundle of rays that gets narrower in a body, the radiance grows with the square of the
// index, and falls again where it leaves. A path counts radiance by that square, which stays
// the same (Nicodemus, "Radiance", American Journal of Physics 31(5), 1963): so no factor
// stands here, and a lamp in a body is as bright as it looks from without.
//
// A body is all that is on its surface's inner side: it may touch no other one, and a camera
// in it sees what is absorbed only from the next surface on. Nothing is lit through a clear
// surface by lights without size: for them a clear body throws a shadow.

// Whether bodies of the material are clear.
fn is_clear(material: u32) -> bool {
    return finish_at(material, EMISSION).w > 0.0;
}

// What is left of light after a way in a body that absorbs it at this rate.
//
// Beer's law.
fn left_after(rate: f32, distance: f32) -> f32 {
    if rate == 0.0 {
        return 1.0;
    }
    return exponential(-(rate * distance));
}

// Takes out of the path what the body around its ray absorbs on its way to the hit.
fn pass_medium(path: ptr<function, Path>, hit: Hit) {
    let rate = (*path).absorption;
    if hit.id == NO_HIT || taxicab_length_f32(rate) == 0.0 {
        return;
    }
    let distance = way_to_hit(*path, hit);
    let left = vec3<f32>(
        left_after(rate.x, distance),
        left_after(rate.y, distance),
        left_after(rate.z, distance),
    );
    (*path).throughput = (*path).throughput * left;
}

// Whether a ray comes to its hit from the inner side.
fn leaves_body(ray: Ray, hit: Hit) -> bool {
    return sphere_is_left(ray, hit)
        || plane_is_left(ray, hit)
        || disk_is_left(ray, hit)
        || triangle_is_left(ray, hit);
}

// Where light goes on that comes from `view`: through the surface or back.
fn bent(view: vec3<f32>, normal: vec3<f32>, ratio: f32, goes_through: bool) -> vec3<f32> {
    if goes_through {
        return refracted(-view, normal, ratio);
    }
    return mirrored(-view, normal);
}

// Has the path go on from a clear surface: through it, or thrown back.
fn pass_clear(path: ptr<function, Path>, hit: Hit, surface: Surface, material: u32) -> bool {
    if (*path).reflections == 0u {
        return false;
    }
    (*path).reflections -= 1u;
    (*path).density = 0.0;
    let ior = finish_at(material, EMISSION).w;
    let leaves = leaves_body((*path).ray, hit);
    let ratio = select(divide_f32(1.0, ior), ior, leaves);
    let view = -unit_vector_f32(vec3<f32>((*path).ray.direction));
    let normal = normal_to_viewer(surface, view);
    let part = thrown_back(cosine_to_viewer(normal, view), ratio);
    let goes_through = number((*path).numbers, dimension_of((*path).leg, LOBE)) >= part;
    var direction = bent(view, normal, ratio, goes_through);
    if (dot_product_f32(surface.facing, direction) < 0.0) != goes_through {
        // A smooth normal that is too far from the shape's own.
        direction = bent(view, surface.facing, ratio, goes_through);
    }
    if dot_product_f32(surface.facing, direction) < 0.0 {
        (*path).is_inside = !leaves;
        let rates = finish_at(material, ABSORPTION).xyz;
        (*path).absorption = select(rates, vec3<f32>(), leaves);
    }
    return send_on(path, surface, direction, vec3<f32>(1.0, 1.0, 1.0));
}
