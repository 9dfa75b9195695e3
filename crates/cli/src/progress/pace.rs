//! The time left, from the work that is done and not from counts: the finest level takes as long as all others together.

use std::time::Duration;

/// How much work is done, and when the last piece of it was.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    total: u64,
    done: u64,
    at: Duration,
}

impl Pace {
    /// Nothing of so much work is done.
    pub fn new(total: u64) -> Self {
        Self { total, done: 0, at: Duration::ZERO }
    }

    /// A piece of work is done, so long after the start.
    pub fn done(&mut self, work: u64, at: Duration) {
        self.done += work;
        self.at = self.at.max(at);
    }

    /// What is left at the pace so far; `None` before the first piece is done. Between two pieces it counts down, and at
    /// zero it waits.
    pub fn left(&self, now: Duration) -> Option<Duration> {
        if self.done == 0 {
            return None;
        }
        let whole = self.at.as_secs_f64() / self.done as f64 * self.total.saturating_sub(self.done) as f64;
        let since = now.saturating_sub(self.at).as_secs_f64();
        Some(Duration::try_from_secs_f64((whole - since).max(0.0)).unwrap_or_default())
    }
}

/// `40 s`, `3 min`, `2 h 5 min`: as exact as an estimate is.
pub fn words(left: Duration) -> String {
    let seconds = left.as_secs();
    match seconds {
        0 => "a moment".into(),
        1..100 => format!("{seconds} s"),
        100..6000 => format!("{} min", (seconds + 30) / 60),
        _ => format!("{} h {} min", seconds / 3600, seconds % 3600 / 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn s(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    #[test]
    fn the_time_left_follows_the_work_and_counts_down() {
        let mut pace = Pace::new(85);
        assert_eq!(pace.left(s(9)), None);
        // levels of 1, 4 and 16 units; one of 64 is left, and takes about three times as long as all of them
        [(1, 1), (4, 5), (16, 21)].into_iter().for_each(|(work, at)| pace.done(work, s(at)));
        assert_eq!(pace.left(s(21)), Some(s(64)));
        assert_eq!(pace.left(s(41)), Some(s(44)));
        assert_eq!(pace.left(s(200)), Some(s(0)));
        pace.done(64, s(90));
        assert_eq!(pace.left(s(90)), Some(s(0)));
    }

    #[test]
    fn time_in_words() {
        for (seconds, text) in [(0, "a moment"), (59, "59 s"), (100, "2 min"), (3000, "50 min"), (7500, "2 h 5 min")] {
            assert_eq!(words(s(seconds)), text);
        }
    }
}
