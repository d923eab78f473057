// A ball as a bounding volume: does the ray come near enough?

// Whether the ray meets the ball after t = 0. As in sphere.wgsl, without the
// roots; docs/numerics.md derives by how much a ball is larger than what it holds.
fn meets_ball(ray: Ray, ball: Ball) -> bool {
    let f = ray.origin - ball.center;
    let d = ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let l = f + d * divide(b, a);
    let square = ball.radius * ball.radius;
    let ahead = b > 0.0 || dot_product(f, f) <= square;
    return ahead && dot_product(l, l) <= square;
}
