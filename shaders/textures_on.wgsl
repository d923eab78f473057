// Textures: the albedo from place to place.

// What a texture repeats, and where.
struct TextureRecord {
    // Where the camera is in a repeat of the world, and how long that is.
    offset: vec3<f32>,
    size: f32,
    // A checker's other colour.
    color: vec3<f32>,
    // An image's first texel.
    first: u32,
    // How often it repeats over a shape's own coordinates.
    repeat: vec2<f32>,
    // Texels across, and down; 0 of a checker.
    width: u32,
    height: u32,
}

// In place of a finish's texture: it has none.
const UNTEXTURED: u32 = 0xffffffffu;

// From here on an f32 has no digits behind the point, so that no place of a repeat is told.
const NO_FRACTION: f32 = 8388608.0;

// Texture `index`.
fn texture_at(index: u32) -> TextureRecord {
    let first = floats_at(sampling.textures, 3u * index);
    let second = fetch(sampling.textures + 3u * index + 1u);
    let third = fetch(sampling.textures + 3u * index + 2u);
    return TextureRecord(
        first.xyz,
        first.w,
        bitcast<vec3<f32>>(second.xyz),
        second.w,
        bitcast<vec2<f32>>(third.xy),
        third.z,
        third.w,
    );
}

// How far within its repeat a coordinate is: from 0 to 1, where 1 is the rounding of what is
// just below.
fn within_repeat(coordinate: f32) -> f32 {
    if abs(coordinate) >= NO_FRACTION {
        return 0.0;
    }
    return coordinate - floor(coordinate);
}

// The coordinates of a place in the world along the two axes that its surface lies most
// along: from the side x and y, or z and y; from above x and z. In repeats.
fn box_coordinates(texture: TextureRecord, surface: Surface) -> vec2<f32> {
    let place = surface.position + texture.offset;
    let along = abs(surface.facing);
    var plane = place.xy;
    if along.x > along.y && along.x > along.z {
        plane.x = place.z;
    } else if along.y > along.z {
        plane.y = place.z;
    }
    return vec2<f32>(divide_f32(plane.x, texture.size), divide_f32(plane.y, texture.size));
}

// Where on a texture a place lies, in repeats: by the coordinates of its shape, or where that
// has none, by its own in the world.
fn texture_coordinates(
    ray: Ray,
    hit: Hit,
    surface: Surface,
    texture: TextureRecord,
) -> vec2<f32> {
    var on_shape: vec2<f32>;
    if sphere_coordinates(hit, surface, &on_shape) || triangle_coordinates(ray, hit, &on_shape) {
        return on_shape * texture.repeat;
    }
    return box_coordinates(texture, surface);
}

// A square of a checker: white where the repeat begins, by turns.
fn checker_color(texture: TextureRecord, across: f32, upward: f32) -> vec4<f32> {
    if (across >= 0.5) == (upward >= 0.5) {
        return vec4<f32>(1.0, 1.0, 1.0, 1.0);
    }
    return vec4<f32>(texture.color, 1.0);
}

// The number of a texel, of so many that repeat: one before the first is the last.
fn wrapped(index: i32, count: u32) -> u32 {
    if index < 0 {
        return count - 1u;
    }
    return select(u32(index), 0u, u32(index) >= count);
}

// From one colour to another, by a part of the way.
fn between(start: vec4<f32>, end: vec4<f32>, part: f32) -> vec4<f32> {
    return start + (end - start) * part;
}

// An image between the middles of its texels: blended across and then down.
fn image_color(texture: TextureRecord, across: f32, upward: f32) -> vec4<f32> {
    let right = across * f32(texture.width) - 0.5;
    let down = (1.0 - upward) * f32(texture.height) - 0.5;
    let column = floor(right);
    let row = floor(down);
    let first = wrapped(i32(column), texture.width);
    let second = wrapped(i32(column) + 1, texture.width);
    let upper = texture.first + wrapped(i32(row), texture.height) * texture.width;
    let lower = texture.first + wrapped(i32(row) + 1, texture.height) * texture.width;
    let of_upper = between(
        floats_at(sampling.texels, upper + first),
        floats_at(sampling.texels, upper + second),
        right - column,
    );
    let of_lower = between(
        floats_at(sampling.texels, lower + first),
        floats_at(sampling.texels, lower + second),
        right - column,
    );
    return between(of_upper, of_lower, down - row);
}

// The colour of a texture, and its alpha, at these coordinates.
fn texture_color(texture: TextureRecord, coordinates: vec2<f32>) -> vec4<f32> {
    let across = within_repeat(coordinates.x);
    let upward = within_repeat(coordinates.y);
    if texture.width == 0u {
        return checker_color(texture, across, upward);
    }
    return image_color(texture, across, upward);
}

// The albedo, times the texture of the place.
fn textured(ray: Ray, hit: Hit, surface: Surface, material: u32, albedo: vec3<f32>) -> vec3<f32> {
    let index = finish_words_at(material, TEXTURE).x;
    if index == UNTEXTURED {
        return albedo;
    }
    let texture = texture_at(index);
    let coordinates = texture_coordinates(ray, hit, surface, texture);
    return albedo * texture_color(texture, coordinates).xyz;
}
