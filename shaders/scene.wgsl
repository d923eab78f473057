// The scene's tables: what each record is, read quad by quad.

// Word `index` of a table of words.
fn word_at(table: u32, index: u32) -> u32 {
    return fetch_word(4u * table + index);
}

// The bits of a NaN that no arithmetic makes.
const NEVER: u32 = 0x7fc12345u;

// The end of a loop that a uniform gives, hidden from the driver behind a number of the ray.
// One that sees it may compile the shader anew for each dispatch, to make the end a
// constant: lavapipe does, and spends two milliseconds on it.
fn hidden_end(end: u32, number: f32) -> u32 {
    return select(end, 0u, bitcast<u32>(number) == NEVER);
}

// A number that a uniform gives, hidden likewise where something is decided by it, alone or
// beside the number of a loop's turn: lavapipe 22.3 notes such numbers in a table, and notes
// those of all but the first buffer in the wrong place, see docs/wgsl.md.
fn hidden(value: f32, number: f32) -> f32 {
    return bitcast<f32>(hidden_end(bitcast<u32>(value), number));
}

// Quad `index` of a table, as f32.
fn floats_at(table: u32, index: u32) -> vec4<f32> {
    return bitcast<vec4<f32>>(fetch(table + index));
}

// The material of the primitive `id`.
fn material_of(id: u32) -> MaterialRecord {
    let index = word_at(tables.material_indices, id);
    return MaterialRecord(floats_at(tables.materials, index).xyz);
}

// Set in a light's flags: it weakens with the square of the distance, it throws shadows; as
// in src/layout.rs.
const WEAKENS: u32 = 1u;
const SHADOW: u32 = 2u;

// Light `index`.
fn light_at(index: u32) -> LightRecord {
    let first = fetch(tables.lights + 2u * index);
    let second = floats_at(tables.lights, 2u * index + 1u);
    return LightRecord(bitcast<vec3<f32>>(first.xyz), first.w, second.xyz);
}

// The bound of a volume that every ray meets; as in src/layout.rs.
const EVERYTHING: u32 = 0xffffffffu;

// Entry `entry` of the list of volumes.
fn volume_at(entry: u32) -> Volume {
    let quad = fetch(tables.volumes + entry);
    return Volume(quad.x, quad.y, quad.z, quad.w);
}

// The bounding ball in a row of the table.
fn ball_at(row: u32) -> Ball {
    let quad = reals_at(tables.balls, row);
    return Ball(quad.xyz, quad.w);
}
