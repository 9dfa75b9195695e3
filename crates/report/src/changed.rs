//! What options changed of the study of a record.

use signorini_study::record::StudyRecord;

/// A list of the keys with their values; empty of a study as its file has it.
pub(crate) fn section(record: &StudyRecord) -> String {
    let Some(changed) = &record.changed else { return String::new() };
    let line = |s: &signorini_study::record::Setting| {
        format!("- `{}` = `{}`{}", s.key, s.value, if s.swept { ", swept" } else { "" })
    };
    let lines: Vec<String> = changed.settings.iter().map(line).collect();
    format!(
        "Not the study as its file has it: options changed `{}`. It has no baseline.\n\n{}\n",
        changed.study,
        lines.join("\n")
    )
}

/// Study and options, as they are typed.
pub(crate) fn arguments(record: &StudyRecord) -> String {
    match &record.changed {
        Some(changed) => format!("{} {}", changed.study, changed.options.join(" ")),
        None => record.study.clone(),
    }
}
