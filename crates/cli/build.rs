//! Tells the binary which commit it was built from.

use std::process::Command;

fn main() {
    let git = |args: &[&str]| {
        let output = Command::new("git").args(args).output().ok().filter(|o| o.status.success())?;
        String::from_utf8(output.stdout).ok().map(|s| s.trim().to_owned())
    };
    let commit = git(&["rev-parse", "--short=12", "HEAD"]).unwrap_or_else(|| "unknown commit".into());
    println!("cargo::rustc-env=SIGNORINI_COMMIT={commit}");
    for path in ["HEAD", "refs"].map(|p| git(&["rev-parse", "--git-path", p])).into_iter().flatten() {
        println!("cargo::rerun-if-changed={path}");
    }
}
