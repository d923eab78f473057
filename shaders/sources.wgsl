// The sources of light, one after the other: what comes from each to a place.

// What comes from a source to a place, if nothing is in between.
struct Arriving {
    // From the place towards the source, and how long this is.
    towards: vec3<f32>,
    length: f32,
    // What a white surface looks like that faces it squarely, times `square`.
    color: vec3<f32>,
    square: f32,
    // The point of the source, or the direction to it, from where it is infinitely far.
    goal: vec3<f32>,
    is_far: bool,
    // Something before this part of the way keeps it off; 0 where nothing does.
    limit: f32,
    // The density, by solid angle, with which this direction was drawn; 0 where only a
    // source that is searched for is found.
    density: f32,
}

// The farthest that a shadow ray may look.
const ENDLESS: f32 = 3.4028234663852886e38;

// Nothing comes.
fn nothing_arriving() -> Arriving {
    let none = vec3<f32>();
    return Arriving(none, 1.0, none, 1.0, none, false, 0.0, 0.0);
}

// How many sources there are: the lights without size, the lamps, the sky.
fn count_sources() -> u32 {
    return tables.light_count + count_lamps() + count_skies();
}

// What comes from a source.
fn arriving_from(source: u32, path: Path, surface: Surface) -> Arriving {
    let position = surface.position;
    if source < hidden_end(surroundings.point_lights, position.x) {
        return arriving_from_point(source, position);
    }
    let lights = hidden_end(tables.light_count, position.x);
    if source < lights {
        return arriving_from_direction(source);
    }
    let lamp = source - lights;
    if lamp < hidden_end(count_lamps(), position.x) {
        return arriving_from_lamp(lamp, path, surface);
    }
    return arriving_from_sky(path, surface);
}

// The cosine at which light comes to a surface.
fn cosine_at_surface(surface: Surface, arriving: Arriving) -> f32 {
    return divide_f32(dot_product_f32(surface.normal, arriving.towards), arriving.length);
}

// How the weights of directions are found, as src/layout numbers the strategies.
const ONLY_LIGHTS: u32 = 1u;
const ONLY_SURFACES: u32 = 2u;

// The weight of light that was searched for with one density, where a path could have found
// it with the other: Veach's balance heuristic.
fn searched_weight(density: f32, of_path: f32) -> f32 {
    let strategy = hidden_end(sampling.strategy, density);
    if of_path == 0.0 || density == 0.0 || strategy == ONLY_LIGHTS {
        return 1.0;
    }
    if strategy == ONLY_SURFACES {
        return 0.0;
    }
    return divide_f32(density, density + of_path);
}

// The weight of light that a path found with one density, where it was searched for with the
// other.
fn found_weight(of_path: f32, density: f32) -> f32 {
    let strategy = hidden_end(sampling.strategy, density);
    if of_path == 0.0 || strategy == ONLY_SURFACES {
        return 1.0;
    }
    if strategy == ONLY_LIGHTS {
        return 0.0;
    }
    return divide_f32(of_path, of_path + density);
}
