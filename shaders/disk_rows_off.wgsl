// Disks that stand still.

// The disk in a row of the table.
fn disk_at(row: u32) -> Disk {
    let first = reals_at(tables.disks, 2u * row);
    return Disk(first.xyz, first.w, reals_at(tables.disks, 2u * row + 1u).xyz);
}
