//! Any text is an expression, with a value and derivatives, or refused with a message and a column; nothing panics.
#![no_main]

use libfuzzer_sys::fuzz_target;
use signorini_study::expr::Expression;
use std::collections::BTreeMap;

fuzz_target!(|text: &str| {
    let parameters = BTreeMap::from([("s".to_string(), 0.25)]);
    match Expression::parse(text, &["x", "y"], &parameters) {
        Ok(expression) => {
            let _: f64 = expression.eval(&[0.3, -0.7]);
            let _: f64 = expression.derivative(0).eval(&[0.3, -0.7]);
        }
        Err(error) => assert!(!error.message.is_empty() && error.column <= text.chars().count() + 1),
    }
});
