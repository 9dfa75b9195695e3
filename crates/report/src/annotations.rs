//! A run as annotations of GitHub's workflows: a line per case that did not pass, tied to its study file.

use crate::junit::Judged;
use crate::summary::name;
use crate::verdict::{self, Standing};
use signorini_study::record::Outcome;
use std::path::Path;

/// One line per case that failed (`::error`), could not be judged or drifted (`::warning`; drift with `strict` is an error).
/// `place` gives a record's study file and the line of its case.
pub fn github<'a>(cases: &[Judged<'a>], strict: bool, place: impl Fn(&Judged<'a>) -> (String, usize)) -> String {
    cases.iter().flat_map(|case| of_case(case, strict, &place(case))).collect()
}

/// The annotation of bad input, which has no case; its place is in the words.
pub fn github_bad_input(message: &str) -> String {
    format!("::error title=signorini: bad input::{}\n", data(message.trim_end()))
}

fn of_case(case: &Judged<'_>, strict: bool, place: &(String, usize)) -> Vec<String> {
    let record = case.record;
    let level = match verdict::standing(record) {
        Standing::Plain(Outcome::Fail) | Standing::ControlMissed => Some("error"),
        Standing::Plain(Outcome::Inconclusive) => Some("warning"),
        _ => None,
    };
    let title = |words: &str| format!("{}: {words}", name(record));
    let verdict = level.map(|l| line(l, place, &title(&verdict::words(record)), &verdict::why(record)));
    let drift: Vec<String> = case.drift.1.iter().map(ToString::to_string).collect();
    let drift = (!drift.is_empty())
        .then(|| line(if strict { "error" } else { "warning" }, place, &title("drift"), &drift.join("\n")));
    verdict.into_iter().chain(drift).collect()
}

/// `::error file=…,line=…,title=…::message`
fn line(level: &str, (file, line): &(String, usize), title: &str, message: &str) -> String {
    format!("::{level} file={},line={line},title={}::{}\n", property(file), property(title), data(message))
}

/// What would end a message is written as its code.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// What would end a property, too.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

/// The file relative to `root`, with slashes, as a service shows it; whole where it lies elsewhere.
pub fn relative(file: &Path, root: &Path) -> String {
    let file = file.strip_prefix(root).unwrap_or(file);
    file.components().map(|c| c.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_end_a_part_is_escaped() {
        let text = line("error", &("studies/a,b.toml".into(), 3), "a: b", "50 %\nof it: all");
        assert_eq!(text, "::error file=studies/a%2Cb.toml,line=3,title=a%3A b::50 %25%0Aof it: all\n");
    }

    #[test]
    fn files_are_named_from_the_root() {
        assert_eq!(relative(Path::new("/r/studies/a.toml"), Path::new("/r")), "studies/a.toml");
        assert_eq!(relative(Path::new("studies/a.toml"), Path::new("/r")), "studies/a.toml");
    }
}
