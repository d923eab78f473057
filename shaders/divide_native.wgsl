// Division and square root, on a device that rounds both correctly.

// a / b.
fn divide(a: real, b: real) -> real {
    return a / b;
}

// The square root of a.
fn square_root(a: real) -> real {
    return sqrt(a);
}
