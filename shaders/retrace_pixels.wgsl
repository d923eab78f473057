// The pixels of a tile whose rays are in doubt.

// Finds the closest hit of a pixel of the tile anew, and colours it.
fn trace_anew(index: u32) {
    let x = index % dispatch.size.x;
    let y = dispatch.first_row + index / dispatch.size.x;
    let ray = camera_ray(dispatch.size, x, y);
    var hit = no_hit();
    hit.tile = tile_of(dispatch.size, x, y);
    closest_hit(probe_of(ray), &hit);
    pixels[index] = shade(ray, hit);
}
