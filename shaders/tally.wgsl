// The sum of a pixel's samples.

struct Tally {
    squares: f32,
    faults: u32,
}

// The bits of an f32's exponent: all set in infinities and in what is no number.
const EXPONENT: u32 = 0x7f800000u;

// What of a colour's channels the eye sees as brightness: Rec. 709.
const LUMINANCE: vec3<f32> = vec3<f32>(0.2126, 0.7152, 0.0722);

// Whether a number is one, and finite: by its bits, for a driver may take it for granted.
fn is_sound(number: f32) -> bool {
    return (bitcast<u32>(number) & EXPONENT) != EXPONENT;
}

// How bright a colour is.
fn luminance(color: vec3<f32>) -> f32 {
    return (LUMINANCE.x * color.x + LUMINANCE.y * color.y) + LUMINANCE.z * color.z;
}

// Adds a sample to the sum of those before it; one that is no number is counted and left out.
fn add_sample(sum: ptr<function, Pixel>, tally: ptr<function, Tally>, color: vec3<f32>) {
    let bright = luminance(color);
    let square = bright * bright;
    if !(is_sound(color.x) && is_sound(color.y) && is_sound(color.z) && is_sound(square)) {
        (*tally).faults += 1u;
        return;
    }
    (*sum).color = (*sum).color + color;
    (*tally).squares += square;
}
