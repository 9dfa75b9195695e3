//! Shipped studies with something deleted, doubled or replaced.

use super::random::Random;
use std::fs;
use std::path::{Path, PathBuf};

const NUMBERS: [&str; 14] = [
    "0",
    "-1",
    "1",
    "1e308",
    "-1e308",
    "1e-308",
    "5e-324",
    "nan",
    "inf",
    "-0.0",
    "2",
    "0.5",
    "9223372036854775807",
    "1e17",
];
const WORDS: [&str; 12] = [
    "\"fixed\"",
    "\"sliding\"",
    "\"free\"",
    "\"traction\"",
    "\"none\"",
    "\"overkill\"",
    "\"refused\"",
    "[]",
    "[[0, 0]]",
    "true",
    "\"x/0\"",
    "{}",
];

/// Every shipped study with its id, in the order of the names.
pub fn shipped_texts() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let mut paths: Vec<PathBuf> = ["", "hard", "controls"].iter().flat_map(|f| files(&root.join(f))).collect();
    paths.sort();
    let read = |p: &PathBuf| {
        let id = p.file_stem().expect("a name").to_string_lossy().into_owned();
        (id, fs::read_to_string(p).expect("a study"))
    };
    paths.iter().map(read).collect()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder of studies").map(|e| e.expect("an entry").path());
    entries.filter(|p| p.extension().is_some_and(|e| e == "toml")).collect()
}

/// One to three mutations.
pub fn mangled(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    for _ in 0..=random.below(3) {
        text = mutated(&text, random);
    }
    text
}

fn mutated(text: &str, random: &mut Random) -> String {
    let mut tokens = tokens(text);
    let at = random.below(tokens.len());
    match random.below(8) {
        0 => drop(tokens.remove(at)),
        1 => tokens.insert(at, tokens[at]),
        2 => tokens[at] = *random.pick(&WORDS),
        3 => {
            let other = random.below(tokens.len());
            tokens.swap(at, other);
        }
        4 => return without_a_line(text, random),
        5 => return with_a_byte(text, random),
        // numbers above all: they are where a reader lets a study through that a mesh cannot take
        _ => {
            let numbers: Vec<usize> =
                (0..tokens.len()).filter(|&k| tokens[k].starts_with(|c: char| c.is_ascii_digit())).collect();
            if let Some(&k) = numbers.get(random.below(numbers.len())) {
                tokens[k] = *random.pick(&NUMBERS);
            }
        }
    }
    tokens.concat()
}

/// Words and numbers, and what stands between them, in order.
fn tokens(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '.' || c == '_';
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let word = is_word(first);
        let end = rest.find(|c| is_word(c) != word).unwrap_or(rest.len());
        let (token, after) = rest.split_at(end);
        tokens.push(token);
        rest = after;
    }
    tokens.push("");
    tokens
}

fn without_a_line(text: &str, random: &mut Random) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let (gone, count) = (random.below(lines.len()), 1 + random.below(4));
    let kept = lines.iter().enumerate().filter(|(k, _)| !(gone..gone + count).contains(k));
    kept.map(|(_, line)| format!("{line}\n")).collect()
}

fn with_a_byte(text: &str, random: &mut Random) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if !bytes.is_empty() {
        let at = random.below(bytes.len());
        bytes[at] = random.below(256) as u8;
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
