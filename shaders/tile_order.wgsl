// Which invocation of a dispatch over a tile is for which of its pixels.

// The bits 0, 2 and 4 of an index, moved together: one coordinate of a place on
// Morton's curve, the other being that of half the index.
fn even_bits(index: u32) -> u32 {
    return (index & 1u) | ((index >> 1u) & 2u) | ((index >> 2u) & 4u);
}

// The pixel of an invocation, in the tile. A workgroup covers 8 x 8 pixels along
// Morton's curve, so that neighbours run together. The rows of workgroups are dealt
// out to slices, so that what a driver hands to one thread lies all over the tile.
fn tile_pixel(workgroup: vec3<u32>, lane: u32) -> vec2<u32> {
    let down = workgroup.y * dispatch.slices + workgroup.z;
    return vec2<u32>(8u * workgroup.x + even_bits(lane), 8u * down + even_bits(lane >> 1u));
}
