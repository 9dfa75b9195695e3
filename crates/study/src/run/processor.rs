//! Processor time of this process, as Linux tells it.

use std::fs;

/// Ticks per second in `/proc/<pid>/stat`: the kernel's interface to programs, 100 on every platform.
const TICKS: f64 = 100.0;

/// Processor seconds of this process so far, all threads together; nothing where the system does not tell.
///
/// The scheduler's own count of the living threads serves, in nanoseconds; without it that of `/proc/self/stat`, in hundredths of
/// a second.
pub fn processor_seconds() -> Option<f64> {
    // the scheduler brings a running thread's count up to date when it yields, else at its tick of a few milliseconds
    std::thread::yield_now();
    of_threads().or_else(of_process)
}

/// `/proc/self/task/*/schedstat`: nanoseconds on a processor, nanoseconds waiting, slices.
fn of_threads() -> Option<f64> {
    let mut nanoseconds = 0u64;
    for thread in fs::read_dir("/proc/self/task").ok()? {
        let text = fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        nanoseconds += text.split_whitespace().next()?.parse::<u64>().ok()?;
    }
    Some(nanoseconds as f64 * 1e-9)
}

fn of_process() -> Option<f64> {
    ticks(&fs::read_to_string("/proc/self/stat").ok()?).map(|t| t as f64 / TICKS)
}

/// User and system time, the fields 14 and 15; the second field, a name in brackets, may hold blanks.
fn ticks(stat: &str) -> Option<u64> {
    let (_, fields) = stat.rsplit_once(") ")?;
    let mut of_interest = fields.split_whitespace().skip(11).map(str::parse::<u64>);
    Some(of_interest.next()?.ok()? + of_interest.next()?.ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_blanks_and_brackets_shifts_no_field() {
        let stat = "7 (a (b) c) R 1 2 3 4 -1 5 6 7 8 9 210 33 1 1 20 0 1";
        assert_eq!(ticks(stat), Some(243));
        assert_eq!(ticks("7 R 1"), None);
    }

    #[test]
    fn time_on_the_processor_does_not_run_backwards() {
        let before = processor_seconds();
        let work: f64 = (0..2_000_000).map(|k| f64::from(k).sqrt()).sum();
        assert!(work > 0.0);
        assert!(processor_seconds() >= before);
    }
}
