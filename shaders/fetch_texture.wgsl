// The scene in a texture: past the largest storage binding, and where storage
// buffers are read one lane after the other, as lavapipe does.

@group(1) @binding(0) var scene: texture_2d<u32>;

// Quads of a texture's row, as a power of two.
const ROW_BITS: u32 = 13u;

// Quad `at` of the scene.
fn fetch(at: u32) -> vec4<u32> {
    return textureLoad(scene, vec2<u32>(at & ((1u << ROW_BITS) - 1u), at >> ROW_BITS), 0);
}

// Word `at` of the scene.
fn fetch_word(at: u32) -> u32 {
    return fetch(at >> 2u)[at & 3u];
}
