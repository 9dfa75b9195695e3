//! Progress: a bar with the time left on a terminal, plain lines elsewhere.

mod pace;

use crate::interrupt;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use pace::Pace;
use signorini_study::record::StudyRecord;
use signorini_study::run::{Step, Watch};
use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// The bar moves on its own this often, so that a long solve is seen to run.
const TICK: Duration = Duration::from_millis(250);

/// Tells on standard error how far a run has come, and stops it where the user asks.
pub struct Progress {
    bar: Option<ProgressBar>,
    lines: bool,
    pace: Arc<Mutex<Pace>>,
    /// The steps that run, in the order in which they began.
    running: Mutex<Vec<String>>,
}

impl Progress {
    /// A bar over so much `work` where standard error is a terminal; nothing with `quiet`.
    pub fn new(work: u64, quiet: bool) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let pace = Arc::new(Mutex::new(Pace::new(work)));
        let bar = (terminal && !quiet).then(|| ProgressBar::new(work).with_style(style(pace.clone())));
        bar.iter().for_each(|bar| bar.enable_steady_tick(TICK));
        Self { bar, lines: !terminal && !quiet, pace, running: Mutex::default() }
    }

    /// A case is done and written.
    pub fn case_done(&self, record: &StudyRecord) {
        if self.lines {
            let outcome = format!("{:?}", record.verdict.outcome).to_lowercase();
            complain!("{}: {outcome}\n", name(&record.study, &record.case));
        }
    }

    /// Everything is done: the bar goes.
    pub fn finish(&self) {
        self.bar.iter().for_each(ProgressBar::finish_and_clear);
    }

    /// Changes what runs, and shows the step that has been running for the longest.
    fn show(&self, change: impl FnOnce(&mut Vec<String>)) {
        let (Some(bar), Ok(mut running)) = (&self.bar, self.running.lock()) else { return };
        change(&mut running);
        let others = if running.len() > 1 { format!(" and {} more", running.len() - 1) } else { String::new() };
        bar.set_message(running.first().map_or(String::new(), |first| format!("{first}{others}")));
    }
}

impl Watch for Progress {
    fn begun(&self, step: &Step<'_>) {
        self.show(|running| running.push(words(step)));
    }

    fn done(&self, step: &Step<'_>) {
        let words = words(step);
        self.show(|running| {
            if let Some(place) = running.iter().position(|r| *r == words) {
                running.remove(place);
            }
        });
        if let (Some(bar), Ok(mut pace)) = (&self.bar, self.pace.lock()) {
            pace.done(step.work, bar.elapsed());
            bar.inc(step.work);
        }
    }

    fn stops(&self) -> bool {
        interrupt::is_asked()
    }
}

/// `study`, or `study/case` where a study has several.
fn name(study: &str, case: &str) -> String {
    if study == case { study.to_owned() } else { format!("{study}/{case}") }
}

/// `theorem-3-1-natural/structured n = 512`
fn words(step: &Step<'_>) -> String {
    let what = if step.is_reference { "reference, n" } else { "n" };
    format!("{} {what} = {}", name(step.study, step.case), step.cells)
}

fn style(pace: Arc<Mutex<Pace>>) -> ProgressStyle {
    let left = move |state: &ProgressState, out: &mut dyn Write| {
        let left = pace.lock().ok().and_then(|pace| pace.left(state.elapsed()));
        let words = left.map_or("…".into(), pace::words);
        // a bar that cannot be drawn is no reason to stop
        let _ = out.write_str(&words);
    };
    ProgressStyle::with_template("{bar:30} {percent:>3} %  {elapsed} elapsed, {left} left  {wide_msg}")
        .map(|style| style.with_key("left", left))
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Tells on standard error how many things of one sort are done, where it is a terminal.
pub struct Count(Option<ProgressBar>);

impl Count {
    /// A bar over so many of `things`; nothing with `quiet`.
    pub fn new(number: usize, things: &str, quiet: bool) -> Self {
        let template = format!("{{bar:40}} {{pos}}/{{len}} {things}  {{elapsed}} elapsed, {{eta}} left");
        let style = ProgressStyle::with_template(&template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let shown = std::io::stderr().is_terminal() && !quiet;
        Self(shown.then(|| ProgressBar::new(number as u64).with_style(style)))
    }

    /// One more.
    pub fn done(&self) {
        self.0.iter().for_each(|bar| bar.inc(1));
    }

    /// The bar goes.
    pub fn finish(&self) {
        self.0.iter().for_each(ProgressBar::finish_and_clear);
    }
}
