//! A child process in a folder of its own, measured and bounded. No shell takes part.

use super::{Limits, Used};
use std::collections::BTreeSet;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use wait4::{ResUse, Wait4};

/// Bytes of what a program printed last that are kept for an error message.
const KEPT: usize = 4096;
/// Lines of it that are shown.
const SHOWN: usize = 20;
/// The child is looked after this often: soon at first, for short runs are timed too.
const FIRST_LOOK: Duration = Duration::from_micros(200);
const LAST_LOOK: Duration = Duration::from_millis(10);

/// The children that run now, by their ids, which are those of their groups.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

/// Stops every program that runs for this one, with the processes that it started: whoever quits at once must not leave them behind,
/// since the terminal's Ctrl-C does not reach them.
pub fn stop_all() {
    if let Ok(running) = RUNNING.lock() {
        running.iter().for_each(|id| kill_group(*id));
    }
}

/// A child in the list of those that run.
struct Listed(u32);

impl Listed {
    fn new(child: &Child) -> Self {
        if let Ok(mut running) = RUNNING.lock() {
            running.insert(child.id());
        }
        Self(child.id())
    }
}

impl Drop for Listed {
    fn drop(&mut self) {
        if let Ok(mut running) = RUNNING.lock() {
            running.remove(&self.0);
        }
    }
}

/// Runs the words in the folder; what it used, or in words why it failed.
pub(super) fn run(words: &[String], folder: &Path, limits: Limits) -> Result<Used, String> {
    let start = Instant::now();
    let mut child = command(words, folder).spawn().map_err(|e| format!("it cannot be started: {e}"))?;
    let listed = Listed::new(&child);
    let (output, errors) = (Printed::default(), Printed::default());
    let pipes = (child.stdout.take(), child.stderr.take());
    let finished = thread::scope(|scope| {
        scope.spawn(|| pipes.0.map(|p| output.drain(p)));
        scope.spawn(|| pipes.1.map(|p| errors.drain(p)));
        let finished = look_after(&mut child, start, limits, || output.count() + errors.count());
        // whoever else is left in its group would keep the pipes open
        kill_group(child.id());
        finished
    });
    drop(listed);
    let said = || if errors.is_empty() { output.tail() } else { errors.tail() };
    let finished = finished.map_err(|why| format!("{why}{}", said()))?;
    if !finished.status.success() {
        return Err(format!("{}{}", ending(finished.status), said()));
    }
    let rusage = finished.rusage;
    Ok(Used {
        seconds: start.elapsed().as_secs_f64(),
        processor: (rusage.utime + rusage.stime).as_secs_f64(),
        peak_bytes: rusage.maxrss,
    })
}

fn command(words: &[String], folder: &Path) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command
}

/// Waits until the child is done or has used up what it may.
fn look_after(child: &mut Child, start: Instant, limits: Limits, printed: impl Fn() -> u64) -> Result<ResUse, String> {
    let mut pause = FIRST_LOOK;
    loop {
        if let Some(finished) = child.try_wait4().map_err(|e| format!("it cannot be waited for: {e}"))? {
            return Ok(finished);
        }
        let excess = if start.elapsed().as_secs_f64() > limits.seconds {
            Some(format!("it took longer than {} s and was stopped; --solver-limit gives it more", limits.seconds))
        } else if printed() > limits.printed {
            Some(format!("it printed more than {} bytes and was stopped", limits.printed))
        } else {
            None
        };
        if let Some(why) = excess {
            kill_group(child.id());
            // the group may be empty where there are none
            let _ = child.kill();
            let _ = child.wait();
            return Err(why);
        }
        thread::sleep(pause);
        pause = (2 * pause).min(LAST_LOOK);
    }
}

/// Ends every process of a child's group that is still there.
fn kill_group(id: u32) {
    #[cfg(unix)]
    if let Ok(id) = i32::try_from(id) {
        use nix::sys::signal::{Signal, killpg};
        // no such group: nobody is left, which is what is wanted
        let _ = killpg(nix::unistd::Pid::from_raw(id), Signal::SIGKILL);
    }
    #[cfg(not(unix))]
    let _ = id;
}

fn ending(status: ExitStatus) -> String {
    match status.code() {
        Some(code) => format!("it ended with exit status {code}"),
        None => format!("it was ended: {status}"),
    }
}

/// What a program prints: how much, and the end of it.
#[derive(Default)]
struct Printed {
    count: AtomicU64,
    tail: Mutex<Vec<u8>>,
    is_cut: AtomicBool,
}

impl Printed {
    fn drain(&self, mut pipe: impl Read) {
        let mut buffer = [0; 8192];
        // an unreadable pipe has ended
        while let Some(n) = pipe.read(&mut buffer).ok().filter(|n| *n > 0) {
            self.count.fetch_add(n as u64, Ordering::Relaxed);
            let Ok(mut tail) = self.tail.lock() else { return };
            tail.extend_from_slice(&buffer[..n]);
            let excess = tail.len().saturating_sub(KEPT);
            if excess > 0 {
                tail.drain(..excess);
                self.is_cut.store(true, Ordering::Relaxed);
            }
        }
    }

    fn count(&self) -> u64 {
        self.count.load(Ordering::Relaxed)
    }

    fn is_empty(&self) -> bool {
        self.count() == 0
    }

    /// The last lines, set apart.
    fn tail(&self) -> String {
        let Ok(tail) = self.tail.lock() else { return String::new() };
        let text = String::from_utf8_lossy(&tail);
        let lines: Vec<&str> = text.lines().collect();
        let last = &lines[lines.len().saturating_sub(SHOWN)..];
        let is_cut = self.is_cut.load(Ordering::Relaxed) || last.len() < lines.len();
        let head = if is_cut { "\n  | …" } else { "" };
        let shown: String = last.iter().map(|l| format!("\n  | {l}")).collect();
        if shown.is_empty() { "; it said nothing".into() } else { format!("; it said{head}{shown}") }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str, limits: Limits) -> Result<Used, String> {
        run(&["sh".into(), "-c".into(), script.into()], &std::env::temp_dir(), limits)
    }

    #[test]
    fn a_program_that_ends_well_is_measured() {
        let used = shell("echo fine; i=0; while [ $i -lt 20000 ]; do i=$((i+1)); done", Limits::default()).unwrap();
        assert!(used.seconds > 0.0 && used.processor > 0.0 && used.peak_bytes > 100_000, "{used:?}");
    }

    #[test]
    fn a_failure_comes_with_its_last_words() {
        let why = shell("echo output; echo 'singular matrix' >&2; exit 3", Limits::default()).unwrap_err();
        assert_eq!(why, "it ended with exit status 3; it said\n  | singular matrix");
        assert_eq!(shell("exit 1", Limits::default()).unwrap_err(), "it ended with exit status 1; it said nothing");
        let why =
            shell("i=0; while [ $i -lt 30 ]; do i=$((i+1)); echo $i; done; exit 1", Limits::default()).unwrap_err();
        assert!(why.contains("\n  | …\n  | 11\n") && why.ends_with("\n  | 30"), "{why}");
        let none = run(&["/no/such/program".into()], &std::env::temp_dir(), Limits::default()).unwrap_err();
        assert!(none.starts_with("it cannot be started"), "{none}");
        assert!(shell("kill -9 $$", Limits::default()).unwrap_err().contains("signal: 9"));
    }

    #[test]
    fn a_program_that_takes_too_much_is_stopped_with_its_children() {
        let quick = Limits { seconds: 0.2, ..Limits::default() };
        // the background child holds the pipes open for a minute unless it is stopped as well
        let why = shell("sleep 60 & sleep 60", quick).unwrap_err();
        assert!(why.starts_with("it took longer than 0.2 s and was stopped"), "{why}");
        let few = Limits { printed: 10_000, ..Limits::default() };
        let why = shell("while :; do echo again and again; done", few).unwrap_err();
        assert!(why.starts_with("it printed more than 10000 bytes and was stopped"), "{why}");
        assert!(shell("sleep 60 & exit 0", Limits::default()).is_ok(), "what it leaves behind is stopped");
    }
}
