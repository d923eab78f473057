// Bounding boxes in a list.

// The box in a row of the table.
fn box_at(row: u32) -> BoxRecord {
    let low = floats_at(tables.boxes, 2u * row).xyz;
    return BoxRecord(low, floats_at(tables.boxes, 2u * row + 1u).xyz);
}

// Whether the ray meets the box in a row of the table.
fn meets_bounding_box(probe: Probe, row: u32) -> bool {
    let bounds = box_at(row);
    let interval = clip_to_box(probe.slabs, bounds.low, bounds.high);
    return interval.enter <= interval.exit;
}
