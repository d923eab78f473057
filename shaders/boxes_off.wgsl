// No bounding boxes in a list.

fn meets_bounding_box(probe: Probe, row: u32) -> bool {
    return true;
}
