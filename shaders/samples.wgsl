// The samples of a picture's pixels, one invocation and dispatch each.

@group(0) @binding(16) var<storage, read_write> tallies: array<Tally>;
@group(0) @binding(17) var<uniform> sampling: SamplingRecord;

// How a picture is sampled, and where tables begin that only its samples read.
struct SamplingRecord {
    seed: u32,
    bounces: u32,
    reflections: u32,
    strategy: u32,
    spread: f32,
    occlusion: f32,
    finishes: u32,
    vertex_uvs: u32,
    textures: u32,
    texels: u32,
    energies: u32,
    padding: u32,
}

// The quads of a finish: how a surface mirrors, shines, absorbs, is coloured.
const MIRROR: u32 = 0u;
const EMISSION: u32 = 1u;
const ABSORPTION: u32 = 2u;
const TEXTURE: u32 = 3u;

// A quad of a material's finish.
fn finish_at(material: u32, quad: u32) -> vec4<f32> {
    return floats_at(sampling.finishes, 4u * material + quad);
}

// The same, as words.
fn finish_words_at(material: u32, quad: u32) -> vec4<u32> {
    return fetch(sampling.finishes + 4u * material + quad);
}

// Whether loops still run: a driver that allows an invocation so many turns leaves each
// further loop after its first.
fn loops_still_run(number: f32) -> bool {
    var turns = 0u;
    let end = hidden_end(2u, number);
    for (var turn = 0u; turn < end; turn++) {
        turns += 1u;
    }
    return turns == 2u;
}

// Takes a sample of each pixel of the tile.
@compute @workgroup_size(64)
fn sample_tile(
    @builtin(workgroup_id) workgroup: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let at = tile_pixel(workgroup, lane);
    if at.x >= dispatch.size.x || at.y >= dispatch.rows {
        return;
    }
    let y = dispatch.first_row + at.y;
    let index = (y - dispatch.band_row) * dispatch.size.x + at.x;
    let sample = sample_pixel(dispatch.size, at.x, y, dispatch.sample);
    let color = sample.color;
    var sum = sample;
    var tally = Tally(0.0, 0u);
    if hidden_end(dispatch.sample, color.x) == 0u {
        sum.color = vec3<f32>();
    } else {
        sum = pixels[index];
        tally = tallies[index];
    }
    if sample.tests == GIVEN_UP || !loops_still_run(color.x) {
        // It took more steps than the driver allows.
        tally.faults += 1u;
    } else {
        add_sample(&sum, &tally, color);
    }
    pixels[index] = sum;
    tallies[index] = tally;
}
