//! What the end-to-end tests share: a folder of their own, the program just built, and two studies to vary.

// Every test program compiles this module and uses a part of it.
#![allow(dead_code)]

use signorini_study::record::StudyRecord;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder for one test, removed at its end. It has its own empty `reference/`, so that no baseline from further up
/// reaches the run.
pub struct Folder(pub PathBuf);

impl Folder {
    /// A new folder named by the test.
    pub fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("signorini-e2e-{test}-{}", std::process::id()));
        fs::create_dir_all(path.join("reference")).expect("the temporary folder can be written");
        Self(path)
    }

    /// A new folder with the study as `studies/<id>.toml`.
    pub fn with_study(test: &str, study: &str) -> Self {
        let folder = Self::new(test);
        folder.add(study);
        folder
    }

    /// Puts a study into `studies/`, under the name that its `id` asks for.
    pub fn add(&self, study: &str) {
        let id = study.split('"').nth(1).expect("a study starts with its id");
        self.write(&format!("studies/{id}.toml"), study);
    }

    /// Writes a file below the folder.
    pub fn write(&self, path: &str, text: &str) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().expect("a file in the folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }

    /// A path below the folder.
    pub fn path(&self, path: &str) -> PathBuf {
        self.0.join(path)
    }

    /// The text of a file below the folder.
    pub fn text(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
    }

    /// The record in `<out>/<case>/record.json`.
    pub fn record(&self, case: &str) -> StudyRecord {
        StudyRecord::from_json(&self.text(&format!("{case}/record.json"))).expect("a record")
    }

    /// The program with these arguments (separated by blanks), about to start in this folder.
    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_signorini"));
        command.args(arguments.split_whitespace()).current_dir(&self.0).stdin(Stdio::null());
        command
    }

    /// Runs the program in this folder.
    pub fn signorini(&self, arguments: &str) -> Ended {
        Ended::new(self.command(arguments).output().expect("the program starts"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// How the program ended and what it said.
#[derive(Debug)]
pub struct Ended {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Ended {
    /// From the output of a finished program.
    pub fn new(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
        Self {
            status: output.status.code().expect("an exit status"),
            out: text(output.stdout),
            err: text(output.stderr),
        }
    }

    /// Demands an exit status.
    pub fn expect(self, status: i32) -> Self {
        assert_eq!(self.status, status, "\n{}\n{}", self.out, self.err);
        self
    }

    /// Demands an exit status and words on standard error.
    pub fn complains(self, status: i32, words: &[&str]) -> Self {
        let ended = self.expect(status);
        for word in words {
            assert!(ended.err.contains(word), "no {word:?} in\n{}", ended.err);
        }
        ended
    }
}

/// Replaces the one place where `old` stands.
pub fn edit(text: &str, old: &str, new: &str) -> String {
    assert_eq!(text.matches(old).count(), 1, "{old:?} must stand once in the text");
    text.replacen(old, new, 1)
}

/// Every file below a folder with its bytes, by path, but those called `except`; pages without their times.
pub fn tree(root: &Path, except: &str) -> Vec<(String, Vec<u8>)> {
    let wanted = |path: &String| Path::new(path).file_name().is_some_and(|name| name != except);
    let read = |path: String| {
        let bytes = fs::read(root.join(&path)).expect("a file");
        let is_page = path.ends_with("index.html");
        let bytes = if is_page { timeless(&String::from_utf8_lossy(&bytes)).into_bytes() } else { bytes };
        (path, bytes)
    };
    names(root).into_iter().filter(wanted).map(read).collect()
}

/// A page without the times that stand between its marks.
pub fn timeless(page: &str) -> String {
    let parts = page.split("<!--times-->").map(|part| part.split_once("<!--/times-->").map_or(part, |(_, rest)| rest));
    parts.collect()
}

/// Every file below a folder, sorted. What vanishes while it is looked at is not there.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
        if path.is_dir() { found.extend(files(&path)) } else { found.push(path) }
    }
    found.sort();
    found
}

/// Every file below a folder, by its path from there.
pub fn names(root: &Path) -> Vec<String> {
    let below = |path: PathBuf| path.strip_prefix(root).expect("a path below").to_string_lossy().into_owned();
    files(root).into_iter().map(below).collect()
}

/// Demands equal trees, naming the first file that differs.
pub fn same_tree(a: &[(String, Vec<u8>)], b: &[(String, Vec<u8>)]) {
    let paths = |t: &[(String, Vec<u8>)]| t.iter().map(|(path, _)| path.clone()).collect::<Vec<_>>();
    assert_eq!(paths(a), paths(b));
    for ((path, x), (_, y)) in a.iter().zip(b) {
        assert!(x == y, "{path} differs");
    }
}

/// Two unit squares, the gap opening like a cube at `x = 1/√6`: Theorem 3.1 with a smooth solution, one case.
pub const SMOOTH: &str = r#"id = "smooth"
title = "Smooth"
claim = "theorem-3-1"
question = "Does P1 converge like h?"
setup = "Two squares with one switch point."
refuted_by = "A rate below 1."

[parameters]
k = 3
m = 2

[levels]
quick = [8, 16, 32, 64]
full = [8, 16, 32, 64]

[[body]]
name = "upper"
material = { lame = [1.5, 1.0] }
rectangle = [[0, 0], [1, 1]]

[[body]]
name = "lower"
material = { lame = [3.0, 2.0] }
rectangle = [[0, -1], [1, 0]]

[[boundary]]
body = "upper"
name = "top"
along = [[0, 1], [1, 1]]
condition = "fixed"

[[boundary]]
body = "upper"
name = "left"
along = [[0, 0], [0, 1]]
condition = "traction"

[[boundary]]
body = "upper"
name = "right"
along = [[1, 0], [1, 1]]
condition = "traction"

[[boundary]]
body = "lower"
name = "bottom"
along = [[0, -1], [1, -1]]
condition = "fixed"

[[boundary]]
body = "lower"
name = "left"
along = [[0, -1], [0, 0]]
condition = "traction"

[[boundary]]
body = "lower"
name = "right"
along = [[1, -1], [1, 0]]
condition = "traction"

[contact]
along = [[0, 0], [1, 0]]

[exact]
builtin = "P"

[expected]
rate = 1
"#;

/// The upper square loaded on its top, held vertically by contact alone; no exact solution. Errors against a finer mesh.
pub const LOADED: &str = r#"id = "loaded"
title = "Loaded"
claim = "two-squares"
question = "Do the solutions converge?"
setup = "A square pressed on another one."
refuted_by = "Errors that stop falling."

[levels]
quick = [4, 8, 16, 32]
full = [4, 8, 16, 32]

[reference]
kind = "overkill"
quick = 128
full = 128

[[body]]
name = "upper"
material = { young = 1.0, poisson = 0.3, plane = "strain" }
rectangle = [[0, 0], [1, 1]]

[[body]]
name = "lower"
material = { young = 1.0, poisson = 0.3, plane = "strain" }
rectangle = [[0, -1], [1, 0]]

[[boundary]]
body = "upper"
name = "top"
along = [[0, 1], [1, 1]]
condition = "traction"
value = ["0", "-0.1*(1 - 1.75*x)"]

[[boundary]]
body = "upper"
name = "left"
along = [[0, 0], [0, 1]]
condition = "sliding"

[[boundary]]
body = "upper"
name = "right"
along = [[1, 0], [1, 1]]
condition = "free"

[[boundary]]
body = "lower"
name = "bottom"
along = [[0, -1], [1, -1]]
condition = "fixed"

[[boundary]]
body = "lower"
name = "left"
along = [[0, -1], [0, 0]]
condition = "free"

[[boundary]]
body = "lower"
name = "right"
along = [[1, -1], [1, 0]]
condition = "free"

[contact]
along = [[0, 0], [1, 0]]

[expected]
rate = 0.711
asymptotic_only = true
reason = "the corner between clamped and free sides governs large sizes only"
"#;

/// Projected successive over-relaxation for `min ½xᵀKx − fᵀx, x ≤ upper`, in the one language that every Unix system has.
const RELAXATION: &str = r#"
FNR == 1 { file++ }
/^%/ { next }
FILENAME ~ /K.mtx$/ && size[file]++ == 0 {
    n = $1
    if (n > LARGEST) { print "too large: " n | "cat 1>&2"; close("cat 1>&2"); stopped = 1; exit 2 }
    next
}
FILENAME ~ /K.mtx$/ { add($1, $2, $3); if ($1 != $2) add($2, $1, $3); next }
size[file]++ == 0 { next }
FILENAME ~ /f.mtx$/ { f[++nf] = $1 }
FILENAME ~ /upper.mtx$/ { upper[++nu] = $1 == "inf" ? 1e300 : $1 }
function add(i, j, v) {
    if (i == j) { diagonal[i] = v; return }
    count[i]++; column[i, count[i]] = j; value[i, count[i]] = v
}
END {
    if (stopped) exit 2
    for (step = 0; step < STEPS; step++)
        for (i = 1; i <= n; i++) {
            rest = f[i]
            for (k = 1; k <= count[i]; k++) rest -= value[i, k] * x[column[i, k]]
            x[i] += 1.85 * (rest / diagonal[i] - x[i])
            if (x[i] > upper[i]) x[i] = upper[i]
        }
    print "%%MatrixMarket matrix array real general\n" n " 1" > "x.mtx"
    for (i = 1; i <= n; i++) printf "%.17g\n", x[i] > "x.mtx"
}
"#;

/// An external solver of `steps` sweeps, to be called by `awk -f solve.awk K.mtx f.mtx upper.mtx`; it fails above `largest` unknowns.
pub fn relaxation(steps: usize, largest: usize) -> String {
    RELAXATION.replace("STEPS", &steps.to_string()).replace("LARGEST", &largest.to_string())
}
