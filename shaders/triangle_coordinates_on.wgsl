// Where on a texture a place of a triangle lies.

// Where the table begins that a scene does not have.
const NO_COORDINATES: u32 = 0xffffffffu;

// The texture coordinates of a vertex.
fn vertex_uv_at(vertex: u32) -> vec2<f32> {
    let across = word_at(sampling.vertex_uvs, 2u * vertex);
    let upward = word_at(sampling.vertex_uvs, 2u * vertex + 1u);
    return bitcast<vec2<f32>>(vec2<u32>(across, upward));
}

// The texture coordinates of the place where a triangle was hit: those of its corners,
// weighted. None where all of these are 0, 0: so has it who has none.
fn triangle_coordinates(ray: Ray, hit: Hit, coordinates: ptr<function, vec2<f32>>) -> bool {
    let uvs = hidden_end(sampling.vertex_uvs, f32(ray.direction.x));
    if hit.id < tables.first_triangle || uvs == NO_COORDINATES {
        return false;
    }
    let corners = corners_at(hit.row);
    let a = vertex_uv_at(corners.x);
    let b = vertex_uv_at(corners.y);
    let c = vertex_uv_at(corners.z);
    let none = vec2<f32>();
    if all(a == none) && all(b == none) && all(c == none) {
        return false;
    }
    let triangle = triangle_at(corners);
    let parts = vec3<f32>(triangle_weights(ray, triangle));
    *coordinates = (a * parts.x + b * parts.y) + c * parts.z;
    return true;
}
