//! The words of a command.

use std::path::Path;

/// A command that cannot be run.
#[derive(Debug, PartialEq, thiserror::Error)]
pub enum CommandError {
    /// A quotation mark without its partner.
    #[error("the command `{0}` has an open quotation; close it")]
    Open(String),
    /// Nothing to run.
    #[error("the command is empty; name a program, as in --solver 'python3 solve.py'")]
    Empty,
    /// The program is neither a file nor on the search path.
    #[error("there is no program `{0}`: neither a file here nor on the PATH")]
    Missing(String),
}

/// Splits a command line as a shell does; words that name existing files become absolute.
pub(super) fn words(text: &str) -> Result<Vec<String>, CommandError> {
    let words = shlex::split(text).ok_or_else(|| CommandError::Open(text.into()))?;
    let program = words.first().filter(|w| !w.is_empty()).ok_or(CommandError::Empty)?;
    if !Path::new(program).is_file() && !is_on_path(program) {
        return Err(CommandError::Missing(program.clone()));
    }
    // a program on the search path goes before a file of its name, as in a shell
    let keeps = |k: usize, w: &String| k == 0 && !w.contains('/');
    Ok(words.iter().enumerate().map(|(k, w)| if keeps(k, w) { w.clone() } else { absolute(w) }).collect())
}

fn absolute(word: &str) -> String {
    let path = Path::new(word);
    // not canonical: a link in bin/ may tell a program which environment is its own
    let absolute = path.exists().then(|| std::path::absolute(path).ok()).flatten();
    absolute.map_or_else(|| word.to_owned(), |p| p.to_string_lossy().into_owned())
}

fn is_on_path(program: &str) -> bool {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    !program.contains('/') && std::env::split_paths(&folders).any(|f| f.join(program).is_file())
}

/// The stem of the first argument that is a file, else of the program.
pub(super) fn name(words: &[String]) -> String {
    let file = words.iter().skip(1).find(|w| Path::new(w).is_file());
    let chosen = file.or(words.first()).map_or("", String::as_str);
    Path::new(chosen).file_stem().map_or_else(|| chosen.to_owned(), |s| s.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_split_and_files_are_found() {
        let found = words("sh -c 'exit 0' Cargo.toml").unwrap();
        assert_eq!(&found[..3], ["sh", "-c", "exit 0"]);
        assert!(Path::new(&found[3]).is_absolute() && found[3].ends_with("Cargo.toml"));
        assert_eq!(name(&found), "Cargo");
        assert_eq!(name(&words("sh -c true").unwrap()), "sh");
    }

    #[test]
    fn what_cannot_be_run_is_refused() {
        assert_eq!(words("sh -c 'exit"), Err(CommandError::Open("sh -c 'exit".into())));
        assert_eq!(words("  "), Err(CommandError::Empty));
        assert_eq!(words("no-such-program x"), Err(CommandError::Missing("no-such-program".into())));
        assert_eq!(words("./no-such-file"), Err(CommandError::Missing("./no-such-file".into())));
    }
}
