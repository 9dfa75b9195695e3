//! The known name that is nearest to a mistyped one.

/// The candidate with the fewest edits from `name`, if it is near enough to be what was meant; the first of equals.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (name.chars().count() / 2).clamp(1, 2);
    candidates
        .into_iter()
        .map(|c| (edits(name, c), c))
        .filter(|&(distance, c)| distance <= limit && distance < c.chars().count())
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, c)| c)
}

/// The fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`, case ignored.
pub(crate) fn edits(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut d = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            d[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = d[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let best = replaced.min(d[i - 1][j] + 1).min(d[i][j - 1] + 1);
                let swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                if swapped { best.min(d[i - 2][j - 2] + 1) } else { best }
            };
        }
    }
    d[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_count_swaps_as_one() {
        for (a, b, n) in [
            ("sin", "sin", 0),
            ("sni", "sin", 1),
            ("", "abc", 3),
            ("sqr", "sqrt", 1),
            ("Alpha", "beta", 4),
            ("kitten", "sitting", 3),
        ] {
            assert_eq!(edits(a, b), n, "{a} {b}");
            assert_eq!(edits(b, a), n, "{b} {a}");
        }
    }

    #[test]
    fn far_names_are_not_suggested() {
        assert_eq!(nearest("aplha", ["beta", "alpha"]), Some("alpha"));
        assert_eq!(nearest("z", ["x", "y"]), None);
        assert_eq!(nearest("pressure", ["x", "y", "sqrt"]), None);
    }
}
