// Holes in shapes: where a texture's alpha is small, there is nothing.

// A ray goes through so many holes at most; what comes then is solid, so that a search ends.
const MOST_HOLES: u32 = 64u;

// Below this alpha there is a hole.
const SOLID_ALPHA: f32 = 0.5;

// Whether a primitive may have holes.
fn has_holes(id: u32) -> bool {
    return finish_words_at(word_at(tables.material_indices, id), TEXTURE).y != 0u;
}

// Whether there is a hole where a primitive was hit that may have some.
fn is_hole(ray: Ray, hit: Hit, surface: Surface) -> bool {
    let material = word_at(tables.material_indices, hit.id);
    let texture = texture_at(finish_words_at(material, TEXTURE).x);
    let coordinates = texture_coordinates(ray, hit, surface, texture);
    return texture_color(texture, coordinates).w < SOLID_ALPHA;
}

// What the path's ray meets first that is no hole. Behind a hole the ray begins anew, and the
// path knows how far it has come.
fn seen_hit(path: ptr<function, Path>) -> Hit {
    (*path).passed = 0.0;
    var hit = no_hit();
    let end = hidden_end(MOST_HOLES + 1u, f32((*path).ray.direction.x));
    for (var hole = 0u; hole < end; hole++) {
        hit = no_hit();
        hit.tile = NO_TILE;
        closest_hit(probe_of((*path).ray), &hit);
        (*path).is_lost |= hit.tests == GIVEN_UP;
        if hit.id == NO_HIT || hole == MOST_HOLES || !has_holes(hit.id) {
            break;
        }
        let surface = surface_of((*path).ray, hit);
        if !is_hole((*path).ray, hit, surface) {
            break;
        }
        (*path).passed = way_to_hit(*path, hit);
        let direction = vec3<f32>((*path).ray.direction);
        let origin = leave_surface(surface.position, surface.facing, direction, surface.reach);
        (*path).ray.origin = vec3<real>(origin);
    }
    return hit;
}

// Whether a ray meets anything no later than at `limit`, in lengths of its direction. Behind a
// hole it begins anew, towards the same end.
fn is_blocked(
    path: ptr<function, Path>,
    origin: vec3<f32>,
    direction: vec3<f32>,
    limit: f32,
) -> bool {
    var start = origin;
    var way = direction;
    var end = limit;
    let holes = hidden_end(MOST_HOLES + 1u, direction.x);
    for (var hole = 0u; hole < holes; hole++) {
        let ray = Ray(vec3<real>(start), vec3<real>(way));
        var hit = no_hit();
        hit.tile = NO_TILE;
        hit.t = real(end);
        closest_hit(probe_of(ray), &hit);
        (*path).is_lost |= hit.tests == GIVEN_UP;
        if hit.id == NO_HIT {
            return false;
        }
        if hole == MOST_HOLES || !has_holes(hit.id) {
            break;
        }
        let surface = surface_of(ray, hit);
        if !is_hole(ray, hit, surface) {
            break;
        }
        start = leave_surface(surface.position, surface.facing, way, surface.reach);
        if limit == ENDLESS {
            continue;
        }
        way = (origin + direction * limit) - start;
        end = 1.0;
        // The end may be nearer than where it starts anew.
        if dot_product_f32(way, direction) <= 0.0 {
            return false;
        }
    }
    return true;
}
