//! Ctrl-C: the first lets the levels that run come to their end, the second quits at once.

use crate::failure::Failure;
use signorini_study::external::stop_all;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit status of a run that was interrupted, as shells have it: 128 and the number of the signal.
pub const STATUS: u8 = 130;

static ASKED: AtomicBool = AtomicBool::new(false);

/// Whether the user asked to stop.
pub fn is_asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}

/// From now on Ctrl-C asks before it quits.
pub fn listen() -> Result<(), Failure> {
    let asked = || {
        if ASKED.swap(true, Ordering::SeqCst) {
            quit();
        }
        complain!("\nstopping: levels that run come to their end and are kept; Ctrl-C again quits at once\n");
    };
    handle(asked)
}

/// From now on Ctrl-C quits at once, and takes the programs along that solve for this one.
pub fn take_along() -> Result<(), Failure> {
    handle(quit)
}

fn quit() {
    stop_all();
    std::process::exit(i32::from(STATUS));
}

fn handle(what: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    ctrlc::set_handler(what).map_err(|e| Failure::new(format!("no handler for Ctrl-C: {e}"), "run again"))
}

/// What to tell of a run that was interrupted: what is kept in `out`, and how to go on.
pub fn failure(out: &Path) -> Failure {
    let folder = out.join(".partial");
    let kept = kept(&folder);
    let levels = if kept == 1 { "1 level".to_owned() } else { format!("{kept} levels") };
    let what = format!("interrupted; {levels} of unfinished cases kept in {}", folder.display());
    Failure::new(what, format!("the same command goes on from there: {}", command())).with_status(STATUS)
}

/// How many finished levels there are.
fn kept(folder: &Path) -> usize {
    let below = |path: &Path| std::fs::read_dir(path).into_iter().flatten().flatten().map(|entry| entry.path());
    let is_level = |path: &Path| path.extension().is_some_and(|e| e == "json");
    below(folder).flat_map(|case| below(&case).collect::<Vec<_>>()).filter(|path| is_level(path)).count()
}

/// The command line, as a shell takes it.
fn command() -> String {
    let words = std::env::args().skip(1).map(|word| quoted(&word));
    std::iter::once("signorini".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

/// In quotation marks where a shell would read more than a word.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:@+%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_would_read_more() {
        for (word, text) in
            [("run", "run"), ("a b", "'a b'"), ("body.*.x=[1]", "'body.*.x=[1]'"), ("it's", "'it'\\''s'")]
        {
            assert_eq!(quoted(word), text);
        }
    }
}
