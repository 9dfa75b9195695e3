//! Traces that make no sense are named.

use super::*;
use crate::exact::{TraceError, TraceName};
use signorini_contact::Body;

fn error(texts: &TraceTexts) -> TraceError {
    Traces::parse(texts, &BTreeMap::from([("s".to_string(), 0.4)]), [SOFT, STIFF]).expect_err("this is broken")
}

#[test]
fn an_expression_that_does_not_parse_names_body_and_trace() {
    let wrong = "1 + tetha";
    for (texts, shown) in [
        (TraceTexts { w: [wrong, P.w[1]], ..P }, "trace w of Ω':"),
        (TraceTexts { w: [P.w[0], wrong], ..P }, "trace w of Ω'':"),
        (TraceTexts { a: [P.a[0], wrong], ..P }, "trace a of Ω'':"),
        (TraceTexts { p: wrong, ..P }, "stress p:"),
        (TraceTexts { cutoff: Some([wrong, "1"]), ..P }, "cutoff of Ω':"),
        (TraceTexts { line: LineText::Graph { f: ["0", wrong] }, ..P }, "graph f of Ω'':"),
    ] {
        let text = error(&texts).to_string();
        assert!(text.starts_with(shown) && text.contains("unknown name `tetha`"), "{text}");
    }
}

/// Every line has its own parameter, and the plane's coordinates belong to the cutoff alone.
#[test]
fn each_line_knows_its_own_parameter() {
    for (line, knows) in [(LineText::Straight, "x"), (UNIT_CIRCLE, "theta"), (LineText::Graph { f: ["0", "0"] }, "eta")]
    {
        for name in ["x", "y", "theta", "eta"] {
            let texts = TraceTexts { line, w: ["1", name], a: ["0", "0"], p: "0", cutoff: Some(["x + y", "1"]) };
            let parsed = Traces::parse(&texts, &BTreeMap::new(), [SOFT, STIFF]);
            assert_eq!(parsed.is_ok(), name == knows, "{name} on {line:?}");
        }
        let texts = TraceTexts { line, w: ["1", "1"], a: ["0", "0"], p: "0", cutoff: Some(["1", "theta + eta"]) };
        let TraceError::Expression { name, body, source } = error(&texts) else { panic!("not an expression") };
        assert_eq!((name, body, source.column), (TraceName::Cutoff, Some(Body::Second), 1));
    }
}

#[test]
fn a_circle_needs_a_radius() {
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let line = LineText::Arc { centre: Point::zeros(), radius, middle: 0.0 };
        let text = error(&TraceTexts { line, ..ARC }).to_string();
        assert!(text.contains("must be positive and finite"), "{text}");
    }
}
