//! Any text is a study or refused with a message; nothing panics.
#![no_main]

use libfuzzer_sys::fuzz_target;
use signorini_study::study::Study;
use std::path::Path;

fuzz_target!(|text: &str| {
    // a study is found by its file name; the usual ids are long, so the file takes the one that the text gives itself
    let id = text.split('"').nth(1).filter(|id| !id.contains(['/', '\0'])).unwrap_or("x");
    if let Err(error) = Study::parse(text, Path::new(&format!("{id}.toml"))) {
        assert!(!error.message.is_empty());
    }
});
