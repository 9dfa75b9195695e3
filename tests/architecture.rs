//! The rules of ARCHITECTURE.md that a compiler does not check.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository's root")
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a source folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn dependencies_point_one_way() {
    let order = ["contact", "study", "report", "cli"];
    for (rank, name) in order.iter().enumerate() {
        let manifest = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).expect("a manifest");
        for (other_rank, other) in order.iter().enumerate() {
            let depends = manifest.lines().any(|l| l.starts_with(&format!("signorini-{other}")));
            assert!(!depends || other_rank < rank, "{name} must not depend on {other}");
        }
    }
    let contact = fs::read_to_string(root().join("crates/contact/Cargo.toml")).expect("a manifest");
    for serializer in ["serde", "toml", "csv", "plotters"] {
        assert!(!contact.contains(serializer), "contact knows no file format, so it has no use for {serializer}");
    }
}

#[test]
fn contact_opens_no_file_reads_no_clock_and_prints_nothing() {
    let banned = ["std::fs", "std::io", "std::time", "Instant::", "println!", "print!(", "eprintln!", "std::env"];
    for path in sources(&root().join("crates/contact/src")) {
        let text = fs::read_to_string(&path).expect("a source file");
        for word in banned {
            assert!(!text.contains(word), "{} uses {word}", path.display());
        }
    }
}

#[test]
fn report_solves_nothing_and_cli_computes_nothing() {
    for (folder, banned) in [("report", "signorini_contact"), ("cli", "signorini_contact")] {
        for path in sources(&root().join("crates").join(folder).join("src")) {
            let text = fs::read_to_string(&path).expect("a source file");
            assert!(!text.contains(banned), "{} reaches for {banned}", path.display());
        }
    }
}

#[test]
fn nothing_unfinished_or_muted_is_committed() {
    let marks = [concat!("todo", "!("), concat!("unimplemented", "!("), concat!("#[", "ignore"), concat!("dbg", "!(")];
    for folder in ["crates", "tests"] {
        for path in sources(&root().join(folder)) {
            let text = fs::read_to_string(&path).expect("a source file");
            for mark in marks {
                assert!(!text.contains(mark), "{} contains {mark}", path.display());
            }
        }
    }
}
