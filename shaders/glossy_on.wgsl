// Rough mirrors: they scatter light about where a smooth one would send it.

// The energies of a width, at as many cosines.
const ENERGIES: u32 = 64u;

// Where an energy is in the row of its width, from 0 to the last. Half of the row is for
// cosines up to about the width, where it changes, and the more the smaller they are.
fn place_of_energy(cosine: f32, width: f32) -> f32 {
    let twice = 2.0 * width;
    let part = divide_f32(cosine * (1.0 + twice), cosine + twice);
    return square_root_f32(part) * f32(ENERGIES - 1u);
}

// What of light a rough mirror would throw back that threw back all: the rest is what falls on
// its small mirrors a second time, which is not followed. See `src/flatten/energies.rs`; what
// is between two numbers of the row is off by 2^-11 of it at most.
fn energy_of(material: u32, width: f32, cosine: f32) -> f32 {
    let place = place_of_energy(cosine, width);
    let whole = u32(place);
    let index = select(ENERGIES - 2u, whole, whole < ENERGIES - 2u);
    let at = finish_words_at(material, TEXTURE).z * ENERGIES + index;
    let energy = bitcast<f32>(word_at(sampling.energies, at));
    let next = bitcast<f32>(word_at(sampling.energies, at + 1u));
    return energy + (next - energy) * (place - f32(index));
}

// The direction of the viewer by the mirror's axes, above the surface whatever the roundings.
fn view_in(axes: Axes, view: vec3<f32>) -> vec3<f32> {
    var seen = to_axes(axes, view);
    if seen.z < LEAST_COSINE {
        seen.z = LEAST_COSINE;
    }
    return seen;
}

// See `mirrored_light`. What the small mirrors throw back twice is added in the form of what
// they throw back once: so all of it is what the reflectance says, and none is lost.
fn glossy_light(
    path: Path,
    surface: Surface,
    look: Look,
    view: vec3<f32>,
    arriving: Arriving,
    color: vec3<f32>,
) -> vec3<f32> {
    let axes = axes_around(normal_to_viewer(surface, view));
    let seen = view_in(axes, view);
    let light = to_axes(axes, divided_f32(arriving.towards, arriving.length));
    if light.z <= 0.0 {
        return vec3<f32>();
    }
    let shape = shape_of_lobe(seen, light, look.width);
    var of_path = 0.0;
    if path.reflections > 0u {
        of_path = (1.0 - look.evenly) * (shape * INVERSE_PI);
    }
    let part = shape * lit_by_cosine(seen, light, look.width);
    let weight = searched_weight(arriving.density, of_path);
    return color * look.reflectance * (divide_f32(part, look.energy) * weight);
}

// Has the path go on from a rough mirror.
fn scatter_glossily(path: ptr<function, Path>, surface: Surface, look: Look, view: vec3<f32>) -> bool {
    let axes = axes_around(normal_to_viewer(surface, view));
    let seen = view_in(axes, view);
    let pair = number_pair((*path).numbers, dimension_of((*path).leg, SCATTER));
    let light = mirrored(-seen, visible_normal(seen, look.width, pair));
    let direction = from_axes(axes, light.x, light.y, light.z);
    if light.z <= 0.0 || dot_product_f32(surface.facing, direction) <= 0.0 {
        return false;
    }
    let chance = 1.0 - look.evenly;
    (*path).density = chance * (shape_of_lobe(seen, light, look.width) * INVERSE_PI);
    let part = light.z * lit_by_cosine(seen, light, look.width);
    let left = look.reflectance * divide_f32(part, look.energy * chance);
    return send_on(path, surface, direction, left);
}
