//! "Did you mean ...?"

/// Longer words are not compared: the time grows with the square.
const MAX_LENGTH: usize = 64;

/// The candidates that a slip of the fingers could have turned into `word`,
/// nearest first; a third of the letters may be wrong, at least one.
pub(super) fn near<'c>(word: &str, candidates: impl IntoIterator<Item = &'c str>) -> Vec<&'c str> {
    let limit = (word.chars().count() / 3).max(1);
    let mut found: Vec<_> = candidates
        .into_iter()
        .filter(|c| c.len().max(word.len()) <= MAX_LENGTH)
        .map(|c| (distance(word, c), c))
        .filter(|(d, _)| *d <= limit)
        .collect();
    found.sort_unstable();
    found.into_iter().map(|(_, c)| c).collect()
}

/// "did you mean `a`?", or all there is to choose from, as far as it fits.
pub(super) fn suggestion<'c>(
    word: &str,
    all_are: &str,
    candidates: impl IntoIterator<Item = &'c str> + Clone,
) -> String {
    /// More than a line of names helps nobody.
    const MAX_LISTED: usize = 16;
    let near = near(word, candidates.clone());
    if let Some(first) = near.first() {
        let or: String = near[1..]
            .iter()
            .take(2)
            .map(|n| format!(" or `{n}`"))
            .collect();
        return format!("did you mean `{first}`{or}?");
    }
    let all: Vec<_> = candidates.into_iter().collect();
    if all.is_empty() {
        return format!("{all_are}: none");
    }
    let listed: Vec<_> = all
        .iter()
        .take(MAX_LISTED)
        .map(|c| format!("`{c}`"))
        .collect();
    let rest = all.len().saturating_sub(MAX_LISTED);
    let rest = if rest > 0 {
        format!(" and {rest} more")
    } else {
        String::new()
    };
    format!("{all_are}: {}{rest}", listed.join(", "))
}

/// Fewest insertions, deletions, substitutions and swaps of neighbours from one
/// word to the other (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.chars().collect();
    let b: Vec<char> = b.chars().collect();
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let substituted = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = substituted.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(before[j - 2] + 1);
            }
            row.push(least);
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_recognised_and_another_word_is_not() {
        let keys = ["radius", "center", "material"];
        assert_eq!(near("raduis", keys), ["radius"]);
        assert_eq!(near("centre", keys), ["center"]);
        assert!(near("colour", keys).is_empty());
    }

    #[test]
    fn distances() {
        let cases = [
            ("", "abc", 3),
            ("ab", "ba", 1),
            ("abc", "abc", 0),
            ("kitten", "sitting", 3),
        ];
        for (a, b, expected) in cases {
            assert_eq!(distance(a, b), expected, "{a} {b}");
            assert_eq!(distance(b, a), expected, "{b} {a}");
        }
    }

    #[test]
    fn without_a_near_name_the_names_are_listed_up_to_a_line() {
        assert_eq!(suggestion("xyz", "keys", ["a1234"]), "keys: `a1234`");
        let many: Vec<String> = (0..20).map(|i| format!("name{i}")).collect();
        let help = suggestion("q", "keys", many.iter().map(String::as_str));
        assert!(help.ends_with("`name15` and 4 more"), "{help}");
        assert_eq!(suggestion("q", "keys", []), "keys: none");
    }
}
