//! From a TOML value to a number, a vector, a colour, a word: each reader says
//! what it expected and what it found, and where.

use glam::DVec3;
use toml::Spanned;
use toml::de::DeValue;

use super::faults::Faults;
use super::near::suggestion;
use crate::scene::Rgb;
use crate::scene::check::{self, Verdict};

/// A TOML value that knows where it stands.
pub(super) type Value<'i> = Spanned<DeValue<'i>>;

/// A reader that also holds what it read to a rule.
pub(super) fn ruled<T: Copy>(
    read: impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
    rule: impl Fn(&str, T) -> Verdict,
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T> {
    move |value, what, faults| {
        let read = read(value, what, faults)?;
        faults.judge(value.span(), rule(what, read)).then_some(read)
    }
}

/// A finite number within [`check::MAX_MAGNITUDE`]; integers count as numbers.
pub(super) fn number(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<f64> {
    let x = match value.get_ref() {
        DeValue::Float(x) => x.as_str().parse().ok(),
        DeValue::Integer(i) if i.radix() == 10 => i.as_str().parse().ok(),
        DeValue::Integer(i) => i128::from_str_radix(i.as_str(), i.radix())
            .ok()
            .map(|i| i as f64),
        _ => {
            wrong_type(value, what, "a number", faults);
            return None;
        }
    };
    // Only a hexadecimal, octal or binary integer beyond 128 bits is left over.
    let x = x.unwrap_or(f64::INFINITY);
    let overflowed = x.is_infinite() && !faults.text_at(value.span()).contains("inf");
    if overflowed {
        let found = faults.text_at(value.span());
        faults.push(
            value.span(),
            format!("`{what}` is {found}, beyond {:e}", check::MAX_MAGNITUDE),
            "too large",
            "this is more than an f64 can hold",
        );
        return None;
    }
    faults
        .judge(value.span(), check::number(what, x))
        .then_some(x)
}

/// A whole number within `range`; `rule` words the refusal.
pub(super) fn whole(
    rule: impl Fn(&str, u64) -> Verdict,
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<u64> {
    move |value, what, faults| {
        let DeValue::Integer(i) = value.get_ref() else {
            wrong_type(value, what, "a whole number", faults);
            return None;
        };
        match u64::from_str_radix(i.as_str(), i.radix()) {
            Ok(n) => faults.judge(value.span(), rule(what, n)).then_some(n),
            Err(_) => {
                let found = faults.text_at(value.span());
                faults.push(
                    value.span(),
                    format!("`{what}` must be a whole number that is not negative, but is {found}"),
                    "out of range",
                    "write a number such as 1",
                );
                None
            }
        }
    }
}

/// Three values of the same kind, each read by `read`.
pub(super) fn triple<T: Copy>(
    read: impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<[T; 3]> {
    several(
        read,
        "write three values between brackets, such as [0, 1, 0]",
    )
}

/// Two values of the same kind.
pub(super) fn pair<T: Copy>(
    read: impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<[T; 2]> {
    several(read, "write two values between brackets, such as [1, 2]")
}

fn several<T: Copy, const COUNT: usize>(
    read: impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
    help: &str,
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<[T; COUNT]> {
    move |value, what, faults| {
        let DeValue::Array(array) = value.get_ref() else {
            wrong_type(value, what, &format!("an array of {COUNT}"), faults);
            return None;
        };
        if array.len() != COUNT {
            let message = format!("`{what}` takes {COUNT} values, found {}", array.len());
            faults.push(value.span(), message, "wrong length", help);
            return None;
        }
        // Read all of them before giving up, so that each fault is told.
        let read: [_; COUNT] = std::array::from_fn(|i| read(&array[i], what, faults));
        let read: Vec<T> = read.into_iter().flatten().collect();
        read.try_into().ok()
    }
}

/// Three numbers.
pub(super) fn vector(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<DVec3> {
    triple(number)(value, what, faults).map(DVec3::from)
}

/// A linear colour.
pub(super) fn color(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<Rgb> {
    triple(ruled(number, check::not_negative))(value, what, faults)
}

/// A fraction, one for all channels or one for each.
pub(super) fn fractions(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<Rgb> {
    let fraction = ruled(number, check::fraction);
    match value.get_ref() {
        DeValue::Array(_) => triple(fraction)(value, what, faults),
        DeValue::Integer(_) | DeValue::Float(_) => fraction(value, what, faults).map(|x| [x; 3]),
        _ => {
            wrong_type(value, what, "a number or an array of 3", faults);
            None
        }
    }
}

/// A colour that the albedo is or is multiplied with.
pub(super) fn albedo(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<Rgb> {
    triple(ruled(number, |what, x| check::albedo(what, [x; 3])))(value, what, faults)
}

/// A string.
pub(super) fn text(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<String> {
    match value.get_ref() {
        DeValue::String(s) => Some(s.to_string()),
        _ => {
            wrong_type(value, what, "a string", faults);
            None
        }
    }
}

/// `true` or `false`.
pub(super) fn boolean(value: &Value<'_>, what: &str, faults: &mut Faults<'_>) -> Option<bool> {
    match value.get_ref() {
        DeValue::Boolean(b) => Some(*b),
        _ => {
            wrong_type(value, what, "true or false", faults);
            None
        }
    }
}

/// One of a few words.
pub(super) fn choice<T: Copy>(
    options: &[(&'static str, T)],
) -> impl Fn(&Value<'_>, &str, &mut Faults<'_>) -> Option<T> {
    move |value, what, faults| {
        let word = text(value, what, faults)?;
        let found = options.iter().find(|(name, _)| *name == word);
        if found.is_none() {
            faults.push(
                value.span(),
                format!("`{what}` cannot be \"{word}\""),
                "unknown",
                suggestion(&word, "it can be", options.iter().map(|(name, _)| *name)),
            );
        }
        found.map(|(_, option)| *option)
    }
}

/// Records that a value is of the wrong type.
pub(super) fn wrong_type(value: &Value<'_>, what: &str, expected: &str, faults: &mut Faults<'_>) {
    let found = type_name(value.get_ref());
    faults.push(
        value.span(),
        format!("`{what}`: expected {expected}, found {found}"),
        found,
        format!("write {expected}"),
    );
}

/// What a value is, for people.
pub(super) fn type_name(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) => "an integer",
        DeValue::Float(_) => "a float",
        DeValue::Boolean(_) => "a boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}
