//! What a case says, over what the study says.

use super::number::Finite;
use super::raw::{
    Expect, RawBody, RawBoundary, RawCase, RawContact, RawCurve, RawDiscretisation, RawExact, RawExpected, RawFamily,
    RawFormula, RawGates, RawLemma, RawLevels, RawMesh, RawReference, RawSlide, RawSolver, RawStudy,
};
use super::spanned::Spanned;
use super::splitting::RawSplitting;
use std::collections::BTreeMap;

/// The tables that make up a case. A table of the case replaces that of the study as a whole; parameters are merged.
pub struct Layer<'a> {
    pub expect: Option<Expect>,
    pub inconclusive_at_quick: Option<&'a String>,
    pub parameters: BTreeMap<String, f64>,
    pub mesh: Option<&'a RawMesh>,
    pub body: Option<&'a [Spanned<RawBody>]>,
    pub boundary: Option<&'a [RawBoundary]>,
    pub contact: Option<&'a RawContact>,
    pub slide: Option<&'a Spanned<RawSlide>>,
    pub curve: Option<&'a [Spanned<RawCurve>]>,
    pub discretisation: Option<&'a Spanned<RawDiscretisation>>,
    pub exact: Option<&'a Spanned<RawExact>>,
    pub formula: Option<&'a Spanned<RawFormula>>,
    pub lemma: Option<&'a Spanned<RawLemma>>,
    pub family: Option<&'a Spanned<RawFamily>>,
    pub levels: Option<&'a RawLevels>,
    pub reference: Option<&'a Spanned<RawReference>>,
    pub solver: Option<&'a RawSolver>,
    pub splitting: Option<&'a Spanned<RawSplitting>>,
    pub gates: Option<&'a Spanned<RawGates>>,
    pub expected: Option<&'a Spanned<RawExpected>>,
}

/// The same fields have the same names in the study and in a case.
macro_rules! layer_of {
    ($raw:expr) => {
        Layer {
            expect: $raw.expect,
            inconclusive_at_quick: $raw.inconclusive_at_quick.as_ref(),
            parameters: numbers($raw.parameters.as_ref()),
            mesh: $raw.mesh.as_ref(),
            body: $raw.body.as_deref(),
            boundary: $raw.boundary.as_deref(),
            contact: $raw.contact.as_ref(),
            slide: $raw.slide.as_ref(),
            curve: $raw.curve.as_deref(),
            discretisation: $raw.discretisation.as_ref(),
            exact: $raw.exact.as_ref(),
            formula: $raw.formula.as_ref(),
            lemma: $raw.lemma.as_ref(),
            family: $raw.family.as_ref(),
            levels: $raw.levels.as_ref(),
            reference: $raw.reference.as_ref(),
            solver: $raw.solver.as_ref(),
            splitting: $raw.splitting.as_ref(),
            gates: $raw.gates.as_ref(),
            expected: $raw.expected.as_ref(),
        }
    };
}

impl<'a> Layer<'a> {
    /// The study's defaults.
    pub fn of_study(raw: &'a RawStudy) -> Self {
        layer_of!(raw)
    }

    /// A case by itself.
    pub fn of_case(raw: &'a RawCase) -> Self {
        layer_of!(raw)
    }

    /// `self`, with what it lacks taken from `base`.
    pub fn over(self, base: Self) -> Self {
        let mut parameters = base.parameters;
        parameters.extend(self.parameters);
        Self {
            expect: self.expect.or(base.expect),
            inconclusive_at_quick: self.inconclusive_at_quick.or(base.inconclusive_at_quick),
            parameters,
            mesh: self.mesh.or(base.mesh),
            body: self.body.or(base.body),
            boundary: self.boundary.or(base.boundary),
            contact: self.contact.or(base.contact),
            slide: self.slide.or(base.slide),
            curve: self.curve.or(base.curve),
            discretisation: self.discretisation.or(base.discretisation),
            exact: self.exact.or(base.exact),
            formula: self.formula.or(base.formula),
            lemma: self.lemma.or(base.lemma),
            family: self.family.or(base.family),
            levels: self.levels.or(base.levels),
            reference: self.reference.or(base.reference),
            solver: self.solver.or(base.solver),
            splitting: self.splitting.or(base.splitting),
            gates: self.gates.or(base.gates),
            expected: self.expected.or(base.expected),
        }
    }
}

fn numbers(raw: Option<&BTreeMap<String, Finite>>) -> BTreeMap<String, f64> {
    raw.into_iter().flatten().map(|(name, x)| (name.clone(), x.0)).collect()
}
