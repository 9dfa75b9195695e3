//! How curved sides and the contact zone are discretised.

use super::error::{Fault, refuse};
use super::raw::{ElementName, GeometryName, NormalsName, RawDiscretisation};
use super::spanned::Spanned;
use crate::study::{Discretisation, Normals};
use signorini_contact::ContactLine;
use signorini_contact::element::CurvedElement;

/// The paper's own: exact sides and true normals; linear functions in the physical coordinates where the bodies touch,
/// Zlámal's map across a gap.
pub fn discretisation(
    raw: Option<&Spanned<RawDiscretisation>>,
    contact: &ContactLine,
) -> Result<Discretisation, Fault> {
    let across_gap = contact.direction().is_some();
    let by_default = if across_gap { ElementName::Isoparametric } else { ElementName::Physical };
    let Some(raw) = raw else {
        return Ok(Discretisation { element: element(by_default, 0.0), ..Default::default() });
    };
    let r = raw.get_ref();
    let name = r.element.unwrap_or(by_default);
    let skew = r.skew.as_ref().map_or(0.0, |s| s.get_ref().0);
    if let Some(s) = r.skew.as_ref().filter(|_| name != ElementName::Isoparametric || skew.abs() >= 1.0) {
        let message = format!("skew = {skew} needs isoparametric elements and must lie between -1 and 1");
        return refuse(s.span(), message, "0 is the paper's parameter; 0.3 is a visible departure from it");
    }
    let normals = r.normals.unwrap_or(NormalsName::True);
    if across_gap && normals != NormalsName::True {
        return refuse(raw.span(), "`normals` across a gap, where one direction is given", "leave it out");
    }
    Ok(Discretisation {
        element: element(name, skew),
        chords: r.geometry == Some(GeometryName::Chords),
        normals: match normals {
            NormalsName::True => Normals::True,
            NormalsName::Averaged => Normals::Averaged,
            NormalsName::Chord => Normals::Chord,
        },
    })
}

fn element(name: ElementName, skew: f64) -> CurvedElement {
    match name {
        ElementName::Physical => CurvedElement::Physical,
        ElementName::Isoparametric => CurvedElement::Isoparametric { skew },
    }
}
