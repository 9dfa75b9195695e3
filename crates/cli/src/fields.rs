//! `--fields`: which levels keep their fields.

use clap::Args;
use signorini_study::fields::Keep;
use signorini_study::record::StudyRecord;

/// Fields of levels.
#[derive(Args, Debug, Clone)]
#[command(next_help_heading = "Output")]
pub struct FieldsArg {
    /// Levels whose displacement, strain, stress and contact pressure are kept, drawn and written for ParaView (VTU) and NumPy:
    /// `none`, `all`, `last`, or numbers from 0, separated by commas. Without it one level of each case is kept and drawn, the
    /// finest with at most 3200 triangles, and no NumPy file is written.
    #[arg(long, value_name = "LEVELS", value_parser = keep)]
    pub fields: Option<Keep>,
}

impl FieldsArg {
    /// What to keep.
    pub fn keep(&self) -> Keep {
        self.fields.clone().unwrap_or(Keep::Page)
    }

    /// What to say of a case that lacks a level that was asked for.
    pub fn missing(&self, record: &StudyRecord) -> Option<String> {
        let Some(Keep::Levels(asked)) = &self.fields else { return None };
        let finest = record.levels.iter().filter(|l| l.has_solution()).map(|l| l.level).max()?;
        let missing = asked.iter().find(|level| **level > finest)?;
        let (study, case) = (&record.study, &record.case);
        let name = if record.several { format!("{study}/{case}") } else { study.clone() };
        Some(format!("{name}: no level {missing} to keep the fields of; levels run from 0 to {finest}\n"))
    }
}

fn keep(text: &str) -> Result<Keep, String> {
    let number = |word: &str| {
        let hint =
            format!("`{word}` is neither none, all, last nor a level's number; levels count from 0, e.g. --fields 0,3");
        word.trim().parse().map_err(|_| hint)
    };
    match text {
        "none" => Ok(Keep::None),
        "all" => Ok(Keep::All),
        "last" => Ok(Keep::Last),
        numbers => Ok(Keep::Levels(numbers.split(',').map(number).collect::<Result<_, _>>()?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_numbers_are_read_and_others_are_named() {
        assert_eq!(keep("all"), Ok(Keep::All));
        assert_eq!(keep("0, 3"), Ok(Keep::Levels(vec![0, 3])));
        for wrong in ["finest", "1,,2", "-1", "", "1.5"] {
            assert!(keep(wrong).unwrap_err().contains("e.g. --fields 0,3"), "{wrong}");
        }
    }
}
