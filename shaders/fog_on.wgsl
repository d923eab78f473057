// Fog: a medium that is the same everywhere, and scatters light evenly.
//
// Kajiya, Von Herzen, "Ray Tracing Volume Densities", SIGGRAPH 1984, of one density; and
// Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th edition, 14.1, for how far a ray
// comes.

@group(0) @binding(20) var<uniform> fog: FogRecord;

// What it scatters, and what it takes out of a ray in a unit of length; 0 where there is none.
struct FogRecord {
    albedo: vec3<f32>,
    density: f32,
}

// A place in fog scatters to all sides alike, of all directions a part of 1 / (4 pi) each; a
// white surface sends 1 / pi times the cosine. So this stands for the cosine.
const EVEN_COSINE: f32 = 0.25;

// The place in fog that scatters the path's light before it comes to the hit, if one does.
//
// The ways that are drawn are as long as light comes, so that of what is drawn nothing is
// taken out besides: the transmittance cancels.
fn meets_fog(
    path: Path,
    hit: Hit,
    surface: ptr<function, Surface>,
    look: ptr<function, Look>,
) -> bool {
    let density = hidden(fog.density, path.throughput.x);
    if density == 0.0 || path.is_inside {
        return false;
    }
    let drawn = number(path.numbers, dimension_of(path.leg, FOG_WAY));
    let way = divide_f32(-logarithm(1.0 - drawn), fog.density);
    var end = ENDLESS;
    if hit.id != NO_HIT {
        end = way_to_hit(path, hit);
    }
    if way >= end {
        return false;
    }
    let along = unit_vector_f32(vec3<f32>(path.ray.direction));
    let none = vec3<f32>();
    *surface = Surface(leg_start(path) + along * way, none, none, 0.0);
    *look = Look(fog.albedo, 0.0, none, 0.0, 1.0, true);
    (*look).evenly = even_chance(path, *look);
    return true;
}

// What fog leaves of light that comes to a place: of what comes from infinitely far, nothing.
fn through_fog(color: vec3<f32>, arriving: Arriving) -> vec3<f32> {
    if hidden(fog.density, color.x) == 0.0 {
        return color;
    }
    if arriving.is_far {
        return vec3<f32>();
    }
    return color * exponential(-(fog.density * arriving.length));
}

// What of arriving light counts at a place: at a surface, the cosine.
fn cosine_towards(surface: Surface, look: Look, arriving: Arriving) -> f32 {
    if look.is_fog {
        return EVEN_COSINE;
    }
    return cosine_at_surface(surface, arriving);
}

// The same for a unit direction.
fn even_cosine(surface: Surface, look: Look, direction: vec3<f32>) -> f32 {
    if look.is_fog {
        return EVEN_COSINE;
    }
    return dot_product_f32(surface.normal, direction);
}

// A direction, drawn as a place scatters light evenly: in fog, any one alike.
//
// Archimedes: parts of the sphere are as large as their heights.
fn even_direction(surface: Surface, look: Look, pair: vec2<f32>) -> vec3<f32> {
    if !look.is_fog {
        return cosine_direction(surface.normal, pair);
    }
    let radius = square_root_f32(4.0 * (pair.x * (1.0 - pair.x)));
    let around = circle_point(pair.y);
    return vec3<f32>(radius * around.x, radius * around.y, 1.0 - 2.0 * pair.x);
}
