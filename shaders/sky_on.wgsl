// An environment that shines from all sides.
//
// Where light is searched for in it, directions are drawn by cells of the same solid angle,
// as likely as they are bright: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th
// edition, 12.5.2. How the cells and their sums come about is in src/flatten/sky.rs.

@group(0) @binding(21) var<uniform> environment: Environment;

// Its numbers, and where its tables begin.
struct Environment {
    start: vec3<f32>,
    offset: f32,
    end: vec3<f32>,
    slope: f32,
    turn: f32,
    width: u32,
    height: u32,
    texels: u32,
    sums: u32,
    count: u32,
    padding: vec2<u32>,
}

// Cells in a row: all azimuths; and rows of them, the first around the zenith: all heights.
// Powers of 2.
const COLUMNS: u32 = 256u;
const ROWS: u32 = 128u;

// The number of cells over 4 pi: the density of directions, by solid angle, where all are as
// likely, in units of a cell's chance.
const CELL_DENSITY: f32 = 2607.5945;

// 1 / pi: what a surface looks like under so much light from the sky.
const SKY_PER_PI: f32 = 0.31830987;

// A cell of directions, and where in it one is.
struct Draw {
    // The number of the row, or of the cell in it.
    index: u32,
    // From one edge to the other: 0 to 1.
    place: f32,
    // The chance of being drawn.
    chance: f32,
}

// How many skies there are: one or none.
fn count_skies() -> u32 {
    return environment.count;
}

// What a whole turn more or less leaves of a turn: from 0 up to but not 1.
fn within_turn(turn: f32) -> f32 {
    if turn < 0.0 {
        let more = turn + 1.0;
        return select(0.0, more, more < 1.0);
    }
    return select(turn, turn - 1.0, turn >= 1.0);
}

// How far a direction is from the image's left edge, in turns.
fn turn_in_image(direction: vec3<f32>) -> f32 {
    return within_turn(turn_of(direction.x, direction.z) + environment.turn);
}

// The texel in a column and a row.
fn sky_texel_at(x: u32, y: u32) -> vec3<f32> {
    return floats_at(environment.texels, y * environment.width + x).xyz;
}

// A sum.
fn sum_at(index: u32) -> f32 {
    return bitcast<f32>(word_at(environment.sums, index));
}

// The radiance of an image in a direction of unit length: between the middles of texels
// that of the four around.
fn image_radiance(direction: vec3<f32>) -> vec3<f32> {
    let width = environment.width;
    let height = environment.height;
    let across = turn_in_image(direction) * f32(width) - 0.5;
    let down = polar_turn(direction.y) * f32(height) - 0.5;
    let left = floor(across);
    let top = floor(down);
    // The left edge and the right edge meet; beyond the poles there is nothing.
    var x0 = width - 1u;
    if left >= 0.0 {
        x0 = u32(left);
    }
    let x1 = select(0u, x0 + 1u, x0 + 1u < width);
    var y0 = 0u;
    if top >= 0.0 {
        y0 = u32(top);
    }
    let below = u32(top + 1.0);
    let y1 = select(height - 1u, below, below < height);
    let right = across - left;
    let upper = sky_texel_at(x0, y0) * (1.0 - right) + sky_texel_at(x1, y0) * right;
    let lower = sky_texel_at(x0, y1) * (1.0 - right) + sky_texel_at(x1, y1) * right;
    let low = down - top;
    return upper * (1.0 - low) + lower * low;
}

// The radiance in a direction of unit length.
fn sky_radiance(direction: vec3<f32>) -> vec3<f32> {
    if hidden_end(environment.width, direction.x) > 0u {
        return image_radiance(direction);
    }
    let weight = environment.offset + environment.slope * direction.y;
    return environment.start * (1.0 - weight) + environment.end * weight;
}

// The chance of one of `count` with the sums that begin at `first`.
fn chance_of(first: u32, count: u32, index: u32) -> f32 {
    var end = 1.0;
    if index + 1u < count {
        end = sum_at(first + index + 1u);
    }
    return end - sum_at(first + index);
}

// Draws one of `count`, a power of 2, by a number: the last whose sum is not above it. The
// number's place between two sums is used once more.
fn draw(first: u32, count: u32, number: f32) -> Draw {
    var index = 0u;
    var half = count >> 1u;
    while half > 0u {
        if sum_at(first + index + half) <= number {
            index += half;
        }
        half >>= 1u;
    }
    let chance = chance_of(first, count, index);
    let above = number - sum_at(first + index);
    return Draw(index, divide_f32(above + 0.5 * STEP, chance), chance);
}

// The density, by solid angle, with which a direction of unit length is drawn.
fn sky_density(direction: vec3<f32>) -> f32 {
    let down = (1.0 - direction.y) * (0.5 * f32(ROWS));
    let across = turn_in_image(direction) * f32(COLUMNS);
    var row = 0u;
    if down >= 0.0 {
        row = u32(down);
    }
    row = select(ROWS - 1u, row, row < ROWS);
    var column = u32(across);
    column = select(COLUMNS - 1u, column, column < COLUMNS);
    let of_row = chance_of(0u, ROWS, row);
    let of_cell = chance_of(ROWS + row * COLUMNS, COLUMNS, column);
    return (of_row * of_cell) * CELL_DENSITY;
}

// What comes from the sky, by a direction drawn by its brightness.
fn arriving_from_sky(path: Path, surface: Surface) -> Arriving {
    let pair = number_pair(path.numbers, dimension_of(path.leg, SKY));
    let row = draw(0u, ROWS, pair.x);
    let cell = draw(ROWS + row.index * COLUMNS, COLUMNS, pair.y);
    let density = (row.chance * cell.chance) * CELL_DENSITY;
    // The height less 1, so that nothing cancels near the poles.
    let lowered = (f32(row.index) + row.place) * (2.0 / f32(ROWS));
    let radius = square_root_f32(lowered * (2.0 - lowered));
    let across = (f32(cell.index) + cell.place) * (1.0 / f32(COLUMNS));
    let point = circle_point(within_turn(across - environment.turn));
    let direction = vec3<f32>(radius * point.x, 1.0 - lowered, radius * point.y);
    var arriving = nothing_arriving();
    arriving.towards = direction;
    arriving.color = divided_f32(sky_radiance(direction) * SKY_PER_PI, density);
    arriving.goal = direction;
    arriving.is_far = true;
    arriving.limit = ENDLESS;
    arriving.density = density;
    return arriving;
}

// What a path sees that meets nothing: of the environment, as much as is due to paths that
// find it.
fn seen_sky(path: Path) -> vec3<f32> {
    let direction = vec3<f32>(path.ray.direction);
    if hidden_end(environment.count, direction.x) == 0u {
        return background_color(direction);
    }
    let unit = unit_vector_f32(direction);
    let radiance = sky_radiance(unit);
    if path.density == 0.0 {
        return radiance;
    }
    return radiance * found_weight(path.density, sky_density(unit));
}
