//! What is asked of an exact solution, and the answer when it does not hold.

use signorini_contact::{Body, Point};
use std::fmt;

/// The conditions that are checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Values and derivatives are numbers.
    Finite,
    /// `n·(u' − u'') ≤ 0`.
    NoPenetration,
    /// `T'_n = T''_n`.
    Reaction,
    /// `T_n ≤ 0`, asked of each body.
    NoTension,
    /// `T_t = 0`.
    NoFriction,
    /// `T_n n·(u' − u'') = 0`.
    Complementarity,
    /// `∇u` is the gradient of `u`.
    Gradient,
    /// `∇∇u` is the gradient of `∇u`.
    Hessian,
}

/// The first condition that fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerifyError {
    /// Which condition.
    pub condition: Condition,
    /// The body, where it concerns one.
    pub body: Option<Body>,
    /// Where.
    pub at: Point,
    /// The value that breaks the condition.
    pub value: f64,
    /// The largest value allowed.
    pub bound: f64,
}

impl Condition {
    /// The quantity in words and letters, what it must be, and where to look.
    fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Finite => {
                ("value or derivative", "must be finite", "declare the point as singular, or mend the expression there")
            }
            Self::NoPenetration => (
                "jump n·(u' − u'')",
                "must not exceed 0",
                "the bodies overlap; check the sign of the gap and which body is Ω'",
            ),
            Self::NoTension => (
                "contact stress T_n",
                "must not exceed 0",
                "the bodies pull on each other; check the sign of the pressure",
            ),
            Self::Reaction => (
                "difference T'_n − T''_n",
                "must be 0",
                "both bodies need the same contact stress; check the Lamé constants of each",
            ),
            Self::NoFriction => (
                "tangential traction T_t",
                "must be 0",
                "the paper has no friction; the shear stress on the contact zone must vanish in each body",
            ),
            Self::Complementarity => {
                ("product T_n n·(u' − u'')", "must be 0", "pressure acts across an open gap; their supports overlap")
            }
            Self::Gradient => (
                "difference of ∇u and the slope of u",
                "must be 0",
                "first derivatives do not belong to the displacement; is a break line or singular point undeclared?",
            ),
            Self::Hessian => (
                "difference of ∇∇u and the slope of ∇u",
                "must be 0",
                "second derivatives do not belong to the displacement; is a break line or singular point undeclared?",
            ),
        }
    }
}

impl fmt::Display for VerifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (quantity, demand, hint) = self.condition.words();
        let body = match self.body {
            Some(Body::First) => " of Ω'",
            Some(Body::Second) => " of Ω''",
            None => "",
        };
        write!(
            f,
            "at x = ({}, {}): {quantity}{body} = {:.3e}, {demand} within {:.1e}; hint: {hint}",
            self.at.x, self.at.y, self.value, self.bound
        )
    }
}

impl std::error::Error for VerifyError {}

/// An error unless the condition holds; a NaN never makes it hold.
pub(super) fn demand(
    holds: bool,
    condition: Condition,
    body: Option<Body>,
    at: Point,
    value: f64,
    bound: f64,
) -> Result<(), VerifyError> {
    if holds {
        return Ok(());
    }
    Err(VerifyError { condition, body, at, value, bound })
}
