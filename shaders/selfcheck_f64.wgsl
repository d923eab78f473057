// Division and square root in f64.

struct Input64 {
    a: f64,
    b: f64,
}

struct Probe64 {
    quotient: f64,
    root: f64,
}

@group(0) @binding(0) var<storage, read> inputs: array<Input64>;
@group(0) @binding(1) var<storage, read_write> probes: array<Probe64>;

@compute @workgroup_size(64)
fn measure(@builtin(global_invocation_id) at: vec3<u32>) {
    if at.x >= arrayLength(&inputs) {
        return;
    }
    let input = inputs[at.x];
    probes[at.x] = Probe64(input.a / input.b, sqrt(abs(input.a)));
}
