// Volumes are counted.

@group(0) @binding(7) var<storage, read_write> counts: array<vec2<u32>>;

// Counts a volume that was tested, and whether the ray met it.
fn count_bound(hit: ptr<function, Hit>, met: bool) {
    (*hit).bound_tests += 1u;
    (*hit).bound_hits += u32(met);
}

// Adds what was counted to the pixel's counts.
fn keep_counts(index: u32, hit: Hit) {
    let counted = vec2<u32>(hit.bound_tests, hit.bound_hits);
    if dispatch.fresh == 1u {
        counts[index] = counted;
    } else {
        counts[index] = counts[index] + counted;
    }
}
