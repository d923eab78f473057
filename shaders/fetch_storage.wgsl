// The scene in a storage buffer: what hardware reads best.

@group(1) @binding(0) var<storage, read> scene: array<vec4<u32>>;

// Quad `at` of the scene.
fn fetch(at: u32) -> vec4<u32> {
    return scene[at];
}

// Word `at` of the scene.
fn fetch_word(at: u32) -> u32 {
    return scene[at >> 2u][at & 3u];
}
