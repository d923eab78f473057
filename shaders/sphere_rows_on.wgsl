// Spheres, where they are at the sample's time.

// The sphere in a row of the table.
fn sphere_at(row: u32) -> Sphere {
    let quad = reals_at(tables.spheres, 2u * row);
    let center = moved(quad.xyz, word_at(tables.sphere_ids, row));
    return Sphere(center, quad.w, reals_at(tables.spheres, 2u * row + 1u).x);
}
