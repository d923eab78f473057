// Spheres that stand still.

// The sphere in a row of the table.
fn sphere_at(row: u32) -> Sphere {
    let quad = reals_at(tables.spheres, 2u * row);
    return Sphere(quad.xyz, quad.w, reals_at(tables.spheres, 2u * row + 1u).x);
}
