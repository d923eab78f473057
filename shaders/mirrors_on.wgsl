// Mirrors, smooth and rough.

// Notes what a place mirrors: by the angle to its normal, not to those of a rough mirror's
// small ones, so that what is left for its albedo is known.
fn mirror_look(look: ptr<function, Look>, path: Path, surface: Surface, material: u32, view: vec3<f32>) {
    let finish = finish_at(material, MIRROR);
    if taxicab_length_f32(finish.xyz) == 0.0 {
        return;
    }
    let cosine = cosine_to_viewer(normal_to_viewer(surface, view), view);
    (*look).reflectance = askew(finish.xyz, cosine);
    (*look).width = finish.w;
    if finish.w > 0.0 {
        (*look).energy = energy_of(material, finish.w, cosine);
    }
}

// What a rough mirror sends to the viewer of light that was searched for: `color` is what a
// white surface would look like by it. In a smooth mirror such light is seen only where a path
// finds it.
fn mirrored_light(
    path: Path,
    surface: Surface,
    look: Look,
    view: vec3<f32>,
    arriving: Arriving,
    color: vec3<f32>,
) -> vec3<f32> {
    if look.width == 0.0 {
        return vec3<f32>();
    }
    return glossy_light(path, surface, look, view, arriving, color);
}

// Has the path go on as a mirror sends it, smooth or rough.
fn mirror_light(path: ptr<function, Path>, surface: Surface, look: Look, view: vec3<f32>) -> bool {
    if (*path).reflections == 0u || taxicab_length_f32(look.reflectance) == 0.0 {
        return false;
    }
    (*path).reflections -= 1u;
    if look.width > 0.0 {
        return scatter_glossily(path, surface, look, view);
    }
    let direction = mirrored(-view, normal_to_viewer(surface, view));
    if dot_product_f32(surface.facing, direction) <= 0.0 {
        return false;
    }
    (*path).density = 0.0;
    let left = divided_f32(look.reflectance, 1.0 - look.evenly);
    return send_on(path, surface, direction, left);
}
