//! How far a hit is along its ray, as a quotient or as a root, and which of two is nearer.

use std::cmp::Ordering;

use super::exact::Exact;
use super::number::{Divide, Number};

/// A t that is known to be positive.
#[derive(Debug, Clone)]
pub enum Distance<N> {
    /// `over` / `under`.
    Quotient {
        /// Of the sign of `under`.
        over: N,
        /// Not zero.
        under: N,
    },
    /// A root of a t^2 - 2 b t + c.
    Root {
        /// Greater than zero; the same for all spheres of a ray.
        a: N,
        /// Half the sum of the roots, times a.
        b: N,
        /// The product of the roots, times a.
        c: N,
        /// b^2 - a c, which is not negative.
        discriminant: N,
        /// Whether it is the larger root.
        is_far: bool,
    },
}

impl<N: Divide> Distance<N> {
    /// t. Of the two forms of a root the one is taken in which nothing cancels.
    pub fn value(&self) -> N {
        match self {
            Self::Quotient { over, under } => over.over(under),
            Self::Root {
                a,
                b,
                c,
                discriminant,
                is_far,
            } => {
                let root = discriminant.square_root();
                if !is_far {
                    c.over(&b.plus(&root))
                } else if b.sign() == Some(Ordering::Less) {
                    c.over(&b.minus(&root))
                } else {
                    b.plus(&root).over(a)
                }
            }
        }
    }
}

/// The sign of a number, which is certain.
fn sign(number: &Exact) -> Ordering {
    number.sign().expect("exact")
}

/// How x + y root(z) compares with zero: where x and y differ in sign, by their squares.
fn sign_with_root(x: &Exact, y: &Exact, z: &Exact) -> Ordering {
    let of_root = match sign(z) {
        Ordering::Equal => Ordering::Equal,
        _ => sign(y),
    };
    let of_x = sign(x);
    if of_root == Ordering::Equal || of_root == of_x {
        return of_x;
    }
    if of_x == Ordering::Equal {
        return of_root;
    }
    match sign(&x.times(x).minus(&y.times(y).times(z))) {
        Ordering::Greater => of_x,
        Ordering::Equal => Ordering::Equal,
        Ordering::Less => of_root,
    }
}

/// 1 for the larger root, else -1.
fn side(is_far: bool) -> Exact {
    Exact::exact(if is_far { 1.0 } else { -1.0 })
}

/// How two hits of one ray compare, exactly: no root is taken, only squares.
pub fn compare(first: &Distance<Exact>, second: &Distance<Exact>) -> Ordering {
    use Distance::{Quotient, Root};
    match (first, second) {
        (
            Quotient { over, under },
            Quotient {
                over: other_over,
                under: other_under,
            },
        ) => {
            let left = over.times(other_under);
            let right = other_over.times(under);
            let order = sign(&left.minus(&right));
            if sign(under) == sign(other_under) {
                order
            } else {
                order.reverse()
            }
        }
        (Quotient { .. }, Root { .. }) => compare(second, first).reverse(),
        (
            Root {
                a,
                b,
                discriminant,
                is_far,
                ..
            },
            Quotient { over, under },
        ) => {
            // (b +- root) / a against over / under, times a and the square of under.
            let x = b.times(under).minus(&a.times(over)).times(under);
            let y = side(*is_far).times(under).times(under);
            sign_with_root(&x, &y, discriminant)
        }
        (
            Root {
                b,
                discriminant,
                is_far,
                ..
            },
            Root {
                b: other_b,
                discriminant: other_discriminant,
                is_far: other_is_far,
                ..
            },
        ) => compare_roots(
            &b.minus(other_b),
            (discriminant, *is_far),
            (other_discriminant, *other_is_far),
        ),
    }
}

/// The sign of x +- root(z) -+ root(w), each with whether it is the larger root.
fn compare_roots(
    x: &Exact,
    (z, is_far): (&Exact, bool),
    (w, other_far): (&Exact, bool),
) -> Ordering {
    let roots = match (is_far, other_far) {
        (true, true) => sign(&z.minus(w)),
        (false, false) => sign(&w.minus(z)),
        (true, false) => sign(&z.plus(w)),
        (false, true) => sign(&z.plus(w)).reverse(),
    };
    let of_x = sign(x);
    if roots == Ordering::Equal || roots == of_x {
        return of_x;
    }
    if of_x == Ordering::Equal {
        return roots;
    }
    // x^2 against the square of the roots' sum: z + w -+ 2 root(z w).
    let twice = Exact::exact(if is_far == other_far { 2.0 } else { -2.0 });
    let rest = x.times(x).minus(&z.plus(w));
    match sign_with_root(&rest, &twice, &z.times(w)) {
        Ordering::Greater => of_x,
        Ordering::Equal => Ordering::Equal,
        Ordering::Less => roots,
    }
}
