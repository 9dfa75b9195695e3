//! Headings of columns in the mathematics of a paper.

use super::tex;
use crate::table::Column;

/// A column of rates between successive levels, the *experimental order of convergence*.
const RATE: &str = "_rate";

/// By the key of the column; others have the words of their heading.
const FORMULAS: [(&str, &str); 22] = [
    ("h", "$h$"),
    ("strain", "$|u-u_h|$"),
    ("energy", r"$\sqrt{A(e,e)}$"),
    ("h1", r"$\|u-u_h\|_1$"),
    ("l2", r"$\|u-u_h\|_0$"),
    ("pressure_l2", r"$\|p-p_h\|_0$"),
    ("pressure_dual", r"$\|p-p_h\|_{-1/2}$"),
    ("penetration_l2", r"$\|([u_h]_n)_+\|_0$"),
    ("contact_set", r"$|C\,\triangle\,C_h|$"),
    ("energy_gap", "$L(u_h)-L(u)$"),
    ("interpolation", r"$\sqrt{A(u-u_I,u-u_I)}$"),
    ("boundary_l2", r"$\|u-u_I\|_{0,\partial\Omega}$"),
    ("constant", "$c$"),
    ("constant_off", "$c-1$"),
    ("half_width", "$a_h/a-1$"),
    ("peak_pressure", r"$\max p_h/p_0-1$"),
    ("force", r"$\sum\lambda/P-1$"),
    ("formula", "formula"),
    ("solution_h1", r"$\|u_h\|_1$"),
    ("b_over_h2", "$b/h^2$"),
    ("dofs", "dofs"),
    ("observed", r"observed [95\,\%]"),
];

/// The heading of a column in LaTeX.
pub(super) fn heading(column: &Column) -> String {
    if column.key.ends_with(RATE) {
        return "EOC".into();
    }
    let formula = FORMULAS.iter().find(|(key, _)| *key == column.key);
    formula.map_or_else(|| tex(&column.heading), |(_, formula)| (*formula).into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::norm::NORMS;

    #[test]
    fn every_quantity_has_a_formula() {
        for quantity in NORMS {
            assert!(FORMULAS.iter().any(|(key, _)| *key == quantity.key), "{}", quantity.key);
        }
    }
}
