//! What is asked of an exact solution, and the answer when it does not hold.

use signorini_contact::{Body, Point};
use std::fmt;

/// The conditions that are checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Values and derivatives are numbers.
    Finite,
    /// `n·(u' − u'') ≤ 0`; across a gap `u''_ξ − u'_ξ ≤ ε`.
    NoPenetration,
    /// `T'_n = T''_n`; across a gap `−T'_ξ/cos α' = T''_ξ/cos α''`.
    Reaction,
    /// `n·(u' − u'') = 0` on a bilateral part, where tension is legitimate.
    NoOpening,
    /// `T_n ≤ 0`, asked of each body; across a gap `T_ξ ≤ 0`.
    NoTension,
    /// `T_t = 0`; across a gap `T_η = 0`.
    NoFriction,
    /// `T_n n·(u' − u'') = 0`; across a gap `T_ξ (u''_ξ − u'_ξ − ε) = 0`.
    Complementarity,
    /// `∇u` is the gradient of `u`.
    Gradient,
    /// `∇∇u` is the gradient of `∇u`.
    Hessian,
}

/// The two kinds of contact zone, which name the same conditions differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// One line that belongs to both bodies: (3.9)–(3.12), with the normal `n` of `Ω'`.
    Common,
    /// Two graphs with a gap `ε`: (3.9')–(3.12'), with the direction `ξ`, forces per unit of `η`.
    Gap,
}

/// The first condition that fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerifyError {
    /// Which condition.
    pub condition: Condition,
    /// The kind of contact zone.
    pub zone: Zone,
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
    fn words(self, zone: Zone) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::Finite => {
                ("value or derivative", "must be finite", "declare the point as singular, or mend the expression there")
            }
            Self::NoPenetration => (
                zone.either("jump n·(u' − u'')", "approach beyond the gap, u''_ξ − u'_ξ − ε"),
                "must not exceed 0",
                "the bodies overlap; check the sign of the gap and which body is Ω'",
            ),
            Self::NoOpening => (
                zone.either("jump |n·(u' − u'')| on a bilateral part", "|u''_ξ − u'_ξ − ε| on a bilateral part"),
                "must be 0",
                "the bodies part or overlap where they may not; check where the bilateral part ends",
            ),
            Self::NoTension => (
                zone.either("contact stress T_n", "contact force T_ξ"),
                "must not exceed 0",
                "the bodies pull on each other; check the sign of the pressure",
            ),
            Self::Reaction => (
                zone.either("difference T'_n − T''_n", "sum T'_ξ/cos α' + T''_ξ/cos α''"),
                "must be 0",
                "both bodies need the same contact stress; check the Lamé constants of each",
            ),
            Self::NoFriction => (
                zone.either("tangential traction T_t", "force T_η/cos α across the direction ξ"),
                "must be 0",
                zone.either(
                    "the paper has no friction; the shear stress on the contact zone must vanish in each body",
                    "the paper has no friction; the traction on each graph must have the direction ξ",
                ),
            ),
            Self::Complementarity => (
                zone.either("product T_n n·(u' − u'')", "product T_ξ (u''_ξ − u'_ξ − ε)"),
                "must be 0",
                "pressure acts across an open gap; their supports overlap",
            ),
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

impl Zone {
    /// The first words on a common line, the second across a gap.
    fn either(self, common: &'static str, gap: &'static str) -> &'static str {
        match self {
            Self::Common => common,
            Self::Gap => gap,
        }
    }
}

impl fmt::Display for VerifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (quantity, demand, hint) = self.condition.words(self.zone);
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

/// An error unless the condition holds; a NaN never makes it hold. The zone is filled in by the caller of all checks.
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
    Err(VerifyError { condition, zone: Zone::Common, body, at, value, bound })
}
