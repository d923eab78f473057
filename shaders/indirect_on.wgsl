// Light that comes by way of other surfaces.

// The leg from which on a path may end by lot.
const FIRST_LOT: u32 = 2u;

// 1 / pi.
const BY_PI: f32 = 0.31830987;

// The density, by solid angle, of directions that are drawn by their cosine.
fn even_density(cosine: f32) -> f32 {
    return cosine * BY_PI;
}

// How likely a path goes on evenly from a place: as bright as that is, beside the mirror.
fn even_chance(path: Path, look: Look) -> f32 {
    let even = taxicab_length_f32(look.albedo);
    if path.bounces == 0u || even == 0.0 {
        return 0.0;
    }
    let mirrored = taxicab_length_f32(look.reflectance);
    if path.reflections == 0u || mirrored == 0.0 {
        return 1.0;
    }
    return divide_f32(even, even + mirrored);
}

// The weight of light that was searched for, as for what is scattered evenly: the path may
// find it too.
fn even_weight(look: Look, arriving: Arriving, cosine: f32) -> f32 {
    return searched_weight(arriving.density, look.evenly * even_density(cosine));
}

// Has the path go on from where light is scattered evenly. The cosine of the surface, and
// what its directions are drawn by, cancel.
fn scatter_evenly(path: ptr<function, Path>, surface: Surface, look: Look) -> bool {
    let pair = number_pair((*path).numbers, dimension_of((*path).leg, SCATTER));
    let direction = even_direction(surface, look, pair);
    if dot_product_f32(surface.facing, direction) < 0.0 {
        return false;
    }
    (*path).bounces -= 1u;
    (*path).density = look.evenly * even_density(even_cosine(surface, look, direction));
    return send_on(path, surface, direction, divided_f32(look.albedo, look.evenly));
}

// Has a path that brings little end by lot; what goes on stands for those that do not. With
// direct light alone, none ends so.
//
// Arvo, Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990.
fn survives(path: ptr<function, Path>) -> bool {
    let bounces = hidden_end(sampling.bounces, (*path).throughput.x);
    if bounces == 0u || (*path).leg < FIRST_LOT {
        return true;
    }
    let left = (*path).throughput;
    let largest = largest_coordinate_f32(left);
    if largest >= 1.0 {
        return true;
    }
    if number((*path).numbers, dimension_of((*path).leg, ROULETTE)) >= largest {
        return false;
    }
    (*path).throughput = divided_f32(left, largest);
    return true;
}
