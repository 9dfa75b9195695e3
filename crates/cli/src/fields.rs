//! `--fields`: which levels keep their fields.

use clap::Args;
use signorini_study::fields::Keep;

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
