// How fast the scene is read: as in a search, by neighbours mostly alike, and each place
// known only when the last one has been read. The host knows the sums.

@group(0) @binding(0) var<storage, read_write> sums: array<u32>;

const READS: u32 = 64u;

@compute @workgroup_size(64)
fn read_quads(@builtin(global_invocation_id) at: vec3<u32>) {
    var place = at.x >> 3u;
    var sum = 0u;
    for (var read = 0u; read < READS; read++) {
        let quad = fetch(place & 4095u);
        sum += ((quad.x ^ quad.y) ^ quad.z) ^ quad.w;
        place = (place * 1664525u + 1013904223u) ^ (quad.x >> 7u);
    }
    sums[at.x] = sum;
}
