// Planes, where they are at the sample's time.

// The plane in a row of the table.
fn plane_at(row: u32) -> Plane {
    let point = reals_at(tables.planes, 2u * row).xyz;
    let normal = reals_at(tables.planes, 2u * row + 1u).xyz;
    return Plane(moved(point, tables.first_plane + row), normal);
}
