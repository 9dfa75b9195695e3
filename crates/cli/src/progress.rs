//! Progress: a bar with the time left on a terminal, plain lines elsewhere.

use indicatif::{ProgressBar, ProgressStyle};
use signorini_study::record::StudyRecord;
use signorini_study::run::Watch;
use std::io::IsTerminal;

/// Tells on standard error how far a run has come.
pub struct Progress {
    bar: Option<ProgressBar>,
    lines: bool,
}

impl Progress {
    /// A bar over `levels` levels where standard error is a terminal; nothing with `quiet`.
    pub fn new(levels: usize, quiet: bool) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let bar = (terminal && !quiet).then(|| ProgressBar::new(levels as u64).with_style(style()));
        Self { bar, lines: !terminal && !quiet }
    }

    /// A case is done and written.
    pub fn case_done(&self, record: &StudyRecord) {
        if self.lines {
            let outcome = format!("{:?}", record.verdict.outcome).to_lowercase();
            complain!(
                "{}: {outcome}
",
                name(&record.study, &record.case)
            );
        }
    }

    /// Everything is done: the bar goes.
    pub fn finish(&self) {
        self.bar.iter().for_each(ProgressBar::finish_and_clear);
    }
}

/// `study`, or `study/case` where a study has several.
fn name(study: &str, case: &str) -> String {
    if study == case { study.to_owned() } else { format!("{study}/{case}") }
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{bar:40} {pos}/{len} levels  {elapsed} elapsed, {eta} left  {wide_msg}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Watch for Progress {
    fn level_done(&self, study: &str, case: &str, _level: usize) {
        if let Some(bar) = &self.bar {
            bar.inc(1);
            bar.set_message(name(study, case));
        }
    }
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
