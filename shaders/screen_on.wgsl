// The screen as a quad-tree: which volumes the rays of a tile may meet. A tile asks only
// for those that its parent's rays may meet. The smallest tiles are 8 pixels wide.

// Bit e of a tile's words: whether its rays may meet entry e of the list of volumes.
// First the smallest tiles' words, then level by level those of larger ones.
@group(0) @binding(8) var<storage, read_write> masks: array<u32>;
@group(0) @binding(9) var<uniform> split: ScreenLevel;

// Entries of a word.
const WORD: u32 = 32u;

// The smallest tile that a pixel lies in.
fn tile_of(size: vec2<u32>, x: u32, y: u32) -> u32 {
    return (y >> 3u) * ((size.x + 7u) >> 3u) + (x >> 3u);
}

// Whether rays of the tile may meet an entry of the list.
fn is_on_tile(tile: u32, entry: u32) -> bool {
    let word = entry / WORD;
    if tile == NO_TILE || word >= tables.tile_words {
        return true;
    }
    return ((masks[tile * tables.tile_words + word] >> (entry % WORD)) & 1u) == 1u;
}

// The cone around the pixels of a tile whose first one is (x, y).
fn cone_of_tile(size: vec2<u32>, x: u32, y: u32, side: u32) -> Cone {
    let right = min(x + side, size.x) - 1u;
    let bottom = min(y + side, size.y) - 1u;
    return cone_around(
        camera_ray(size, x, y).direction,
        camera_ray(size, right, y).direction,
        camera_ray(size, x, bottom).direction,
        camera_ray(size, right, bottom).direction,
    );
}

// Of the candidates of a word, those that the cone's rays may meet.
fn met_by_cone(cone: Cone, word: u32, candidates: u32) -> u32 {
    var met = 0u;
    for (var bit = 0u; bit < WORD && (candidates >> bit) != 0u; bit++) {
        if ((candidates >> bit) & 1u) == 1u {
            let bound = volume_at(WORD * word + bit).bound;
            if bound == EVERYTHING || cone_meets_ball(cone, ball_at(bound)) {
                met |= 1u << bit;
            }
        }
    }
    return met;
}

// The candidates of the largest tile: all entries.
fn all_of_word(word: u32, entries: u32) -> u32 {
    let here = min(entries - WORD * word, WORD);
    return 0xffffffffu >> (WORD - here);
}

// One word of one tile of a level.
@compute @workgroup_size(64)
fn split_tiles(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x >= split.across * tables.tile_words {
        return;
    }
    let word = at.x % tables.tile_words;
    let x = at.x / tables.tile_words;
    let tile = at.y * split.across + x;
    var candidates = all_of_word(word, tables.volume_count);
    if split.is_root == 0u {
        let parent = (at.y >> 1u) * split.parent_across + (x >> 1u);
        candidates = masks[split.parent_first + parent * tables.tile_words + word];
    }
    let cone = cone_of_tile(dispatch.size, x * split.side, at.y * split.side, split.side);
    masks[split.first + tile * tables.tile_words + word] = met_by_cone(cone, word, candidates);
}
