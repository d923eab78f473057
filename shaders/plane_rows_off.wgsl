// Planes that stand still.

// The plane in a row of the table.
fn plane_at(row: u32) -> Plane {
    let point = reals_at(tables.planes, 2u * row).xyz;
    return Plane(point, reals_at(tables.planes, 2u * row + 1u).xyz);
}
