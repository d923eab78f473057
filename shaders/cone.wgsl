// A cone of rays from the camera: those of a tile of the screen.

// The sine from which on a cone is so wide that it meets everything.
const WIDE: f32 = 0.7;

// What is added to a cone's sine, and to a ball's radius in parts of its reach: above
// the roundings of rays, cones and this test, at most 20 of 2^-24.
const CONE_SLACK: f32 = 32.0 / 16777216.0;

// All directions within an angle of the axis.
struct Cone {
    // Unit length.
    axis: vec3<real>,
    // Of the angle; WIDE or more for a cone that meets everything.
    sine: real,
    cosine: real,
}

// The larger of the sine so far and that of the direction's angle to the axis.
fn widened_sine(sine: real, axis: vec3<real>, direction: vec3<real>) -> real {
    if dot_product(axis, direction) <= 0.0 {
        return 1.0;
    }
    let across = divide(vector_length(cross_product(axis, direction)), vector_length(direction));
    return select(sine, across, across > sine);
}

// The cone around four rays, the corners of a tile; all rays between them are in it.
fn cone_around(a: vec3<real>, b: vec3<real>, c: vec3<real>, d: vec3<real>) -> Cone {
    let axis = unit_vector((a + b) + (c + d));
    var sine = real(0.0);
    sine = widened_sine(sine, axis, a);
    sine = widened_sine(sine, axis, b);
    sine = widened_sine(sine, axis, c);
    sine = widened_sine(sine, axis, d) + real(CONE_SLACK);
    if sine >= real(WIDE) {
        return Cone(axis, sine, 0.0);
    }
    return Cone(axis, sine, square_root(1.0 - sine * sine));
}

// Whether a ray of the cone may come near enough to the ball.
fn cone_meets_ball(cone: Cone, ball: Ball) -> bool {
    let c = ball.center;
    let along = dot_product(cone.axis, c);
    let across = vector_length(cross_product(cone.axis, c));
    let distance = across * cone.cosine - along * cone.sine;
    let reach = ((abs(c.x) + abs(c.y)) + abs(c.z)) + ball.radius;
    return cone.sine >= real(WIDE) || distance <= ball.radius + reach * real(CONE_SLACK);
}
