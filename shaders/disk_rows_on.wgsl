// Disks, where they are at the sample's time.

// The disk in a row of the table.
fn disk_at(row: u32) -> Disk {
    let first = reals_at(tables.disks, 2u * row);
    let center = moved(first.xyz, word_at(tables.disk_ids, row));
    return Disk(center, first.w, reals_at(tables.disks, 2u * row + 1u).xyz);
}
