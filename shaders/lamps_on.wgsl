// Lamps that have a size.
//
// Shirley, Wang, Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM
// Transactions on Graphics 15(1), 1996.

@group(0) @binding(22) var<uniform> lamps: LampTable;

// Where the lamps are.
struct LampTable {
    start: u32,
    count: u32,
    padding: vec2<u32>,
}

// A lamp: five quads.
struct LampRecord {
    center: vec3<f32>,
    form: u32,
    right: vec3<f32>,
    reach: f32,
    up: vec3<f32>,
    radius: f32,
    normal: vec3<f32>,
    area: f32,
    radiance: vec3<f32>,
}

// The forms, as src/layout numbers them, and what stands for "no lamp" there.
const SPHERE_LAMP: u32 = 0u;
const DISK_LAMP: u32 = 1u;
const NO_LAMP: u32 = 0xffffffffu;

// A whole turn, in radians.
const WHOLE_TURN: f32 = 6.2831855;

// 1 / pi: what a surface looks like under so much light.
const PER_PI: f32 = 0.31830987;

// A lamp that covers less of what a place sees does not light it: the least normal number,
// so that its inverse is finite.
const LEAST_ANGLE: f32 = 1.1754943508222875e-38;

// Lamp `index`.
fn lamp_at(index: u32) -> LampRecord {
    let row = 5u * index;
    let form = fetch(lamps.start + row).w;
    let center = floats_at(lamps.start, row).xyz;
    let right = floats_at(lamps.start, row + 1u);
    let up = floats_at(lamps.start, row + 2u);
    let normal = floats_at(lamps.start, row + 3u);
    let radiance = floats_at(lamps.start, row + 4u).xyz;
    return LampRecord(
        center, form, right.xyz, right.w, up.xyz, up.w, normal.xyz, normal.w, radiance,
    );
}

// How many lamps there are.
fn count_lamps() -> u32 {
    return lamps.count;
}

// 1 - cos of the angle by which a spherical lamp reaches from its middle, as seen from this
// far from there; 0 from within.
//
// By the square of the sine, so that nothing cancels where the lamp is small.
fn cap_height(lamp: LampRecord, from_center: vec3<f32>) -> f32 {
    let square = dot_product_f32(from_center, from_center);
    let own = lamp.radius * lamp.radius;
    if square <= own {
        return 0.0;
    }
    let sine_square = divide_f32(own, square);
    return divide_f32(sine_square, 1.0 + square_root_f32(1.0 - sine_square));
}

// The solid angle that stands for a point drawn on a lamp, seen `towards` there from a place:
// what its density is the inverse of. 0 where the lamp does not light the place.
fn angle_of_lamp(lamp: LampRecord, place: vec3<f32>, towards: vec3<f32>) -> f32 {
    if lamp.form == SPHERE_LAMP {
        return WHOLE_TURN * cap_height(lamp, place - lamp.center);
    }
    let square = dot_product_f32(towards, towards);
    let along = -dot_product_f32(lamp.normal, towards);
    if square == 0.0 || along <= 0.0 {
        return 0.0;
    }
    return divide_f32(lamp.area, square) * divide_f32(along, square_root_f32(square));
}

// The inverse of such an angle; 0 where there is none.
fn density_of_angle(angle: f32) -> f32 {
    if angle < LEAST_ANGLE {
        return 0.0;
    }
    return divide_f32(1.0, angle);
}

// The outward normal of a point drawn on a sphere, evenly by the angle under which a place
// sees it that is outside of the sphere.
//
// In units of the sines and cosines of the angle at the place (to the lamp's edge:
// `largest`) and at the middle, by the law of sines: nothing cancels but near the surface.
fn drawn_normal(lamp: LampRecord, from_center: vec3<f32>, pair: vec2<f32>) -> vec3<f32> {
    let distance = vector_length_f32(from_center);
    let largest = divide_f32(lamp.radius, distance);
    let cap = cap_height(lamp, from_center);
    let lowered = pair.x * cap;
    let cosine = 1.0 - lowered;
    // The square of the sine, over that of the largest.
    let part = pair.x * divide_f32(2.0 - lowered, 2.0 - cap);
    let rest = 1.0 - part;
    // By roundings it may be below 0.
    let chord = square_root_f32(select(0.0, rest, rest > 0.0));
    let along = part * largest + cosine * chord;
    let across = square_root_f32(part) * (cosine - largest * chord);
    let point = circle_point(pair.y);
    let axes = axes_around(divided_f32(from_center, distance));
    return from_axes(axes, across * point.x, across * point.y, along);
}

// From the middle of a disk or of a rectangle to a point drawn on it.
fn drawn_point(lamp: LampRecord, pair: vec2<f32>) -> vec3<f32> {
    var point = vec2<f32>(pair.x * 2.0 - 1.0, pair.y * 2.0 - 1.0);
    if lamp.form == DISK_LAMP {
        point = disk_point(pair);
    }
    return lamp.right * point.x + lamp.up * point.y;
}

// What comes from a point drawn on a lamp.
//
// The ray that looks for what is in between ends as far before the lamp as it would start
// if it left there. So it does not meet the lamp: both its ends are on the outer side.
fn arriving_from_lamp(lamp: u32, path: Path, surface: Surface) -> Arriving {
    let record = lamp_at(lamp);
    let place = surface.position;
    let pair = number_pair(path.numbers, dimension_of_lamp(path.leg, lamp));
    var normal = record.normal;
    var point = record.center;
    if record.form == SPHERE_LAMP {
        normal = drawn_normal(record, place - record.center, pair);
        point = point + normal * record.radius;
    } else {
        point = point + drawn_point(record, pair);
    }
    let towards = point - place;
    let length = vector_length_f32(towards);
    let angle = angle_of_lamp(record, place, towards);
    let density = density_of_angle(angle);
    if length == 0.0 || density == 0.0 {
        return nothing_arriving();
    }
    let reach = record.reach + taxicab_length_f32(place);
    var arriving = nothing_arriving();
    arriving.towards = towards;
    arriving.length = length;
    arriving.color = record.radiance * (angle * PER_PI);
    arriving.goal = leave_surface(point, normal, normal, reach);
    arriving.limit = 1.0;
    arriving.density = density;
    return arriving;
}

// Whether a ray comes to the side of a lamp that shines.
fn meets_front(lamp: LampRecord, position: vec3<f32>, direction: vec3<f32>) -> bool {
    var outward = lamp.normal;
    if lamp.form == SPHERE_LAMP {
        outward = position - lamp.center;
    }
    return dot_product_f32(outward, direction) < 0.0;
}

// How much of a lamp's light is due to a path that found it; 1 for what is no lamp.
fn weight_of_lamp(path: Path, hit: Hit, surface: Surface, material: u32) -> f32 {
    let lamp = finish_words_at(material, ABSORPTION).w;
    if lamp == NO_LAMP {
        return 1.0;
    }
    let record = lamp_at(lamp);
    if !meets_front(record, surface.position, vec3<f32>(path.ray.direction)) {
        return 0.0;
    }
    if path.density == 0.0 {
        return 1.0;
    }
    let place = leg_start(path);
    let angle = angle_of_lamp(record, place, surface.position - place);
    return found_weight(path.density, density_of_angle(angle));
}
