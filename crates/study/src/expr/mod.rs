//! The expression language of study files: a text in a few variables, evaluated with or without derivatives.
//!
//! ```text
//! condition := both { "or" both }                 both  := negation { "and" negation }
//! negation  := "not" negation | comparison        comparison := sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]
//! sum       := term { ("+" | "-") term }          term  := sign { ("*" | "/") sign }
//! sign      := ("-" | "+") sign | power           power := primary [ "^" sign ]
//! primary   := number | name | name "(" arguments ")" | "(" condition ")"
//! ```
//!
//! So `-x^2 = -(x^2)`, `2^3^2 = 2^(3^2)` and `2^-1` is allowed. `if(condition, a, b)` evaluates only the branch taken.
//!
//! ```
//! use signorini_study::expr::Expression;
//! use std::collections::BTreeMap;
//!
//! let s = BTreeMap::from([("s".to_string(), 0.25)]);
//! let gap = Expression::parse("pos(x - s)^3", &["x", "y"], &s).unwrap();
//! assert_eq!(gap.eval(&[0.75, 0.0]), 0.125);
//!
//! let wrong = Expression::parse("sqr(x)", &["x", "y"], &s).unwrap_err();
//! assert!(wrong.to_string().contains("did you mean `sqrt`"));
//! ```

mod build;
mod derivative;
mod dual;
#[cfg(test)]
mod dual_tests;
mod error;
mod functions;
mod lexer;
mod parser;
mod scalar;
#[cfg(test)]
mod tests;
mod tree;

pub use dual::{Along, Dual, Dual2};
pub use error::ExprError;
pub use scalar::{Real, atan2, positive_power, power, sqrt};

use std::collections::BTreeMap;

/// A parsed expression in named variables, its parameters already replaced by their values.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    text: String,
    variables: usize,
    root: tree::Node,
}

impl Expression {
    /// Parses `text` in the given variables. A name stands for a variable, else a parameter, else a constant (`pi`, `e`).
    ///
    /// # Errors
    /// The first thing that makes no sense, with its column.
    pub fn parse(text: &str, variables: &[&str], parameters: &BTreeMap<String, f64>) -> Result<Self, ExprError> {
        let root = parser::parse(text, variables, parameters)?;
        Ok(Self { text: text.to_string(), variables: variables.len(), root })
    }

    /// The value at `variables`, in the order in which they were named; outside the domain of a function it is NaN.
    ///
    /// # Panics
    /// If fewer values are given than variables were named.
    pub fn eval<D: Real>(&self, variables: &[D]) -> D {
        assert!(variables.len() >= self.variables, "{} values for {} variables", variables.len(), self.variables);
        self.root.eval(variables)
    }

    /// The derivative by the variable of this number, counted from 0.
    ///
    /// At a kink it is that of the branch taken, as the value's own: 0 for `abs`, `sign`, `step` and `pos` at 0, the first
    /// of equals for `min` and `max`; comparisons are taken as they stand. Where a slope is infinite and multiplied by 0,
    /// as in `sqrt(x^2)` at 0, it is NaN; a branch that is constant, as `pos(x)^0.5` for `x < 0`, has derivative 0.
    ///
    /// ```
    /// use signorini_study::expr::Expression;
    ///
    /// let gap = Expression::parse("pos(x - 0.25)^3", &["x"], &Default::default()).unwrap();
    /// assert_eq!(gap.derivative(0).eval(&[0.75]), 0.75);
    /// ```
    #[must_use]
    pub fn derivative(&self, variable: usize) -> Self {
        let root = derivative::derivative(&self.root, variable);
        Self { text: format!("derivative {variable} of {}", self.text), variables: self.variables, root }
    }

    /// The text that was parsed; of a derivative, the text of the expression that it belongs to, named as such.
    pub fn text(&self) -> &str {
        &self.text
    }
}
