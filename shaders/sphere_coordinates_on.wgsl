// Where on a texture a place of a sphere lies.

// The texture coordinates of the place where a sphere was hit: its longitude from -x by way
// of +z, in turns, and its latitude from the lower pole, in half turns. So an image lies on
// it as on a globe, its middle in +x. None of another shape.
fn sphere_coordinates(
    hit: Hit,
    surface: Surface,
    coordinates: ptr<function, vec2<f32>>,
) -> bool {
    if hit.id >= tables.first_plane {
        return false;
    }
    let center = vec3<f32>(sphere_at(hit.row).center);
    // The normal is as near as its digits are, the place only as near as its distance allows.
    var outward = surface.facing;
    if dot_product_f32(outward, surface.position - center) < 0.0 {
        outward = -outward;
    }
    *coordinates = vec2<f32>(turn_of(-outward.x, outward.z), polar_turn(-outward.y));
    return true;
}
