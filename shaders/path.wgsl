// A path: from the surface that a ray meets, the next ray.

// The kind of an aim: thrown back as by a mirror.
const MIRRORED: f32 = 0.0;

// The kind of an aim: in a given direction.
const TOWARDS: f32 = 1.0;

// The kind of an aim: to a given point, which is at t = 1.
const TO: f32 = 2.0;

// The kind of an aim: refracted, by a given ratio of indices.
const REFRACTED: f32 = 3.0;

// Where a path goes on from a surface.
struct AimRecord {
    // The direction, the point, or the ratio in x.
    vector: vec3<f32>,
    // Which of these.
    kind: f32,
}

// The largest number: of rays whose numbers would be larger, a path goes nowhere.
const LARGEST: f32 = 3.4028234663852886e38;

// Whether a path has come to its end: it goes nowhere.
fn is_over(ray: Ray) -> bool {
    return taxicab_length_f32(vec3<f32>(ray.direction)) == 0.0;
}

// The direction in which a path leaves the surface that it met in `direction`.
fn leaving_direction(aim: AimRecord, surface: Surface, direction: vec3<f32>) -> vec3<f32> {
    if aim.kind == TOWARDS {
        return aim.vector;
    }
    if aim.kind == TO {
        return aim.vector - surface.position;
    }
    if aim.kind == REFRACTED {
        return refracted(direction, surface.facing, aim.vector.x);
    }
    return mirrored(direction, surface.facing);
}

// The ray that leaves the surface that a ray met, its numbers those of f32 in every width;
// one that goes nowhere where the ray met nothing.
fn next_ray(ray: Ray, hit: Hit, aim: AimRecord) -> Ray {
    let nowhere = Ray(ray.origin, vec3<real>(vec3<f32>()));
    if hit.id == NO_HIT {
        return nowhere;
    }
    let surface = surface_of(ray, hit);
    var direction = leaving_direction(aim, surface, vec3<f32>(ray.direction));
    let origin = leave_surface(surface.position, surface.facing, direction, surface.reach);
    if aim.kind == TO {
        direction = aim.vector - origin;
    }
    // So that no number is none either.
    let is_sound = taxicab_length_f32(origin) + taxicab_length_f32(direction) <= LARGEST;
    if !is_sound {
        return nowhere;
    }
    return Ray(vec3<real>(origin), vec3<real>(direction));
}
