// The screen is not divided.

fn tile_of(size: vec2<u32>, x: u32, y: u32) -> u32 {
    return 0u;
}

fn is_on_tile(tile: u32, entry: u32) -> bool {
    return true;
}
