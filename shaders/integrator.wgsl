// A path of light, followed from the camera: at each place that it comes to, what light is
// there and where the path goes on.
//
// Kajiya, "The Rendering Equation", SIGGRAPH 1986. What a scene does not call for is not in
// here: the functions of its files do nothing then.

// A path on its way.
struct Path {
    ray: Ray,
    numbers: Numbers,
    // What of the light that is found at the ray's far end reaches the pixel.
    throughput: vec3<f32>,
    // The light found so far.
    radiance: vec3<f32>,
    // What a clear body around the ray takes out of it in a unit of length.
    absorption: vec3<f32>,
    // The density, by solid angle, with which the ray's direction was drawn where lamps are
    // searched for as well; 0 where only the ray itself finds them.
    density: f32,
    // The ray's number.
    leg: u32,
    // How often it may still be scattered, and mirrored or refracted.
    bounces: u32,
    reflections: u32,
    // Whether it goes through a clear body.
    is_inside: bool,
    // How far the path had come on this leg where the ray begins: through holes.
    passed: f32,
    // A search was given up.
    is_lost: bool,
}

// How a place looks from where it is seen.
struct Look {
    // Of the light there, what it scatters evenly.
    albedo: vec3<f32>,
    // How likely the path goes on as it is scattered evenly; else as it is mirrored.
    evenly: f32,
    // What is mirrored, and by how rough a mirror: its width; 0 where it is smooth.
    reflectance: vec3<f32>,
    width: f32,
    // By what the mirror's light is divided, so that none is lost.
    energy: f32,
    // Whether it is a place in fog, not on a surface.
    is_fog: bool,
}

// A path that begins at the camera.
fn path_from_camera(ray: Ray, numbers: Numbers) -> Path {
    let none = vec3<f32>();
    let all = vec3<f32>(1.0, 1.0, 1.0);
    let bounces = hidden_end(sampling.bounces, f32(ray.direction.x));
    let ways = hidden_end(sampling.reflections, f32(ray.direction.x));
    return Path(ray, numbers, all, none, none, 0.0, 0u, bounces, ways, false, 0.0, false);
}

// Where the path's leg begins: its ray does, unless it has come through holes.
fn leg_start(path: Path) -> vec3<f32> {
    let origin = vec3<f32>(path.ray.origin);
    if path.passed == 0.0 {
        return origin;
    }
    return origin - unit_vector_f32(vec3<f32>(path.ray.direction)) * path.passed;
}

// How far it is from there to the hit.
fn way_to_hit(path: Path, hit: Hit) -> f32 {
    return f32(hit.t * vector_length(path.ray.direction)) + path.passed;
}

// Adds light that is found at the ray's far end.
fn add_light(path: ptr<function, Path>, radiance: vec3<f32>) {
    (*path).radiance = (*path).radiance + (*path).throughput * radiance;
}

// Sends the path on from a place; of the light that it finds there, so much is left.
fn send_on(
    path: ptr<function, Path>,
    surface: Surface,
    direction: vec3<f32>,
    left: vec3<f32>,
) -> bool {
    let origin = leave_surface(surface.position, surface.facing, direction, surface.reach);
    (*path).ray = Ray(vec3<real>(origin), vec3<real>(direction));
    (*path).throughput = (*path).throughput * left;
    // What is no number goes on, and is counted in the end.
    return taxicab_length_f32((*path).throughput) != 0.0;
}

// The light that a place sends towards the viewer, of what comes straight from lamps: none
// of a smooth mirror that scatters nothing.
fn lit_by_all(path: ptr<function, Path>, surface: Surface, look: Look, view: vec3<f32>) -> vec3<f32> {
    if taxicab_length_f32(look.albedo) + look.width == 0.0 {
        return vec3<f32>();
    }
    var even = ambient_light(path, surface, look);
    var glossy = vec3<f32>();
    let end = hidden_end(count_sources(), view.x);
    for (var source = 0u; source < end; source++) {
        let arriving = arriving_from(source, *path, surface);
        let cosine = cosine_towards(surface, look, arriving);
        if cosine <= 0.0 {
            continue;
        }
        let color = arriving.color * divide_f32(cosine, arriving.square);
        if is_shadowed(path, surface, arriving) {
            continue;
        }
        let thinned = through_fog(color, arriving);
        let weight = even_weight(look, arriving, cosine);
        even = even + thinned * weight;
        glossy = glossy + mirrored_light(*path, surface, look, view, arriving, thinned);
    }
    return look.albedo * even + glossy;
}

// Adds what the path finds at a place, and tells whether it goes on.
fn meet_place(
    path: ptr<function, Path>,
    surface: Surface,
    look: Look,
    view: vec3<f32>,
) -> bool {
    add_light(path, lit_by_all(path, surface, look, view));
    if number((*path).numbers, dimension_of((*path).leg, LOBE)) < look.evenly {
        return scatter_evenly(path, surface, look);
    }
    return mirror_light(path, surface, look, view);
}

// Adds what the path finds at its ray's far end, and tells whether it goes on.
fn meet(path: ptr<function, Path>, hit: Hit) -> bool {
    let view = -unit_vector_f32(vec3<f32>((*path).ray.direction));
    pass_medium(path, hit);
    var surface: Surface;
    var look: Look;
    if !meets_fog(*path, hit, &surface, &look) {
        if hit.id == NO_HIT {
            add_light(path, seen_sky(*path));
            return false;
        }
        surface = surface_of((*path).ray, hit);
        let material = word_at(tables.material_indices, hit.id);
        add_light(path, emitted(*path, hit, surface, material));
        if is_clear(material) {
            return pass_clear(path, hit, surface, material);
        }
        look = look_of(*path, hit, surface, material, view);
    }
    return meet_place(path, surface, look, view);
}

// How a material looks where it was hit.
fn look_of(path: Path, hit: Hit, surface: Surface, material: u32, view: vec3<f32>) -> Look {
    var look: Look;
    look.energy = 1.0;
    mirror_look(&look, path, surface, material, view);
    let color = textured(path.ray, hit, surface, material, material_of(hit.id).albedo);
    look.albedo = color * (vec3<f32>(1.0, 1.0, 1.0) - look.reflectance);
    look.evenly = even_chance(path, look);
    return look;
}

// What a ray of the camera sees.
fn follow(ray: Ray, numbers: Numbers) -> Pixel {
    var path = path_from_camera(ray, numbers);
    var pixel: Pixel;
    let legs = 1u + sampling.bounces + sampling.reflections;
    let end = hidden_end(legs, f32(ray.direction.x));
    for (var leg = 0u; leg < end; leg++) {
        path.leg = leg;
        let hit = seen_hit(&path);
        if leg == 0u {
            pixel = layers_of(path, hit);
        }
        if !meet(&path, hit) || !survives(&path) {
            break;
        }
    }
    pixel.color = path.radiance;
    if path.is_lost {
        pixel.tests = GIVEN_UP;
    }
    return pixel;
}

// What sample `sample` of pixel (x, y) sees.
fn sample_pixel(size: vec2<u32>, x: u32, y: u32, sample: u32) -> Pixel {
    let numbers = numbers_of(sampling.seed, x, y, sample);
    open_shutter(numbers);
    var ray = camera_ray(size, x, y);
    ray = in_pixel(ray, size, numbers);
    ray = through_lens(ray, numbers);
    ray = from_moving_camera(ray);
    return follow(ray, numbers);
}
