//! Elastic constants of a study file.

use super::error::{Fault, refuse};
use super::fixed::Fixed;
use super::raw::{PlaneName, RawMaterial, RawOrthotropic};
use super::spanned::Spanned;
use signorini_contact::Material;
use signorini_contact::material::Plane;

const FORMS: &str = "give exactly one of `lame = [λ, μ]`, `young` with `poisson`, `orthotropic`, `matrix`";

/// The material of a table with exactly one of the four forms.
pub fn material(raw: &Spanned<RawMaterial>) -> Result<Material, Fault> {
    let span = raw.span();
    let m = raw.get_ref();
    let forms =
        [m.lame.is_some(), m.young.is_some() || m.poisson.is_some(), m.orthotropic.is_some(), m.matrix.is_some()];
    let given = forms.iter().filter(|f| **f).count();
    if given != 1 {
        return refuse(span, format!("material: {given} laws where there must be 1"), FORMS);
    }
    if m.plane.is_some() && (m.lame.is_some() || m.matrix.is_some()) {
        let message = "material: `plane` says nothing here, since `lame` and `matrix` are already laws of the plane";
        return refuse(m.plane.as_ref().map_or(span, Spanned::span), message, "leave `plane` out");
    }
    let plane = m.plane.as_ref().map_or(Plane::Strain, |p| plane(*p.get_ref()));
    if let Some(Fixed([lambda, mu])) = m.lame {
        return checked(Material::lame(lambda.0, mu.0), raw, "choose μ > 0 and λ + μ > 0");
    }
    if let Some(c) = m.matrix {
        return checked(
            Material::general(c.0.map(|r| r.0.map(|x| x.0))),
            raw,
            "give a symmetric, positive definite matrix",
        );
    }
    match &m.orthotropic {
        Some(o) => checked(orthotropic(o, plane), raw, "choose positive moduli and smaller ratios"),
        None => isotropic(raw, plane),
    }
}

fn plane(name: PlaneName) -> Plane {
    match name {
        PlaneName::Strain => Plane::Strain,
        PlaneName::Stress => Plane::Stress,
    }
}

fn checked(
    law: Result<Material, signorini_contact::Error>,
    raw: &Spanned<RawMaterial>,
    next: &str,
) -> Result<Material, Fault> {
    law.map_err(|e| Fault::new(raw.span(), e.to_string(), next))
}

fn orthotropic(o: &RawOrthotropic, plane: Plane) -> Result<Material, signorini_contact::Error> {
    Material::orthotropic(o.moduli.0.map(|x| x.0), o.ratios.0.map(|x| x.0), o.shear.0, plane)
}

fn isotropic(raw: &Spanned<RawMaterial>, plane: Plane) -> Result<Material, Fault> {
    let m = raw.get_ref();
    let (Some(young), Some(poisson)) = (&m.young, &m.poisson) else {
        return refuse(raw.span(), "material: `young` and `poisson` belong together", "give the one that is missing");
    };
    let (e, nu) = (young.get_ref().0, poisson.get_ref().0);
    let culprit = if e > 0.0 { poisson.span() } else { young.span() };
    Material::isotropic(e, nu, plane)
        .map_err(|error| Fault::new(culprit, error.to_string(), "choose E > 0 and −1 < ν < 1/2"))
}
