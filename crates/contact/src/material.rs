//! Hooke's law in the plane, `τ_ij = c_ijkl ε_kl`, and its positivity (2.7).

use crate::Error;
use nalgebra::{Matrix3, SymmetricEigen};

/// A symmetric tensor of the plane by its components `11, 22, 12`.
pub type Sym2 = [f64; 3];

/// Which two-dimensional reduction an isotropic or orthotropic law comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// Plane strain: no strain across the plane.
    Strain,
    /// Plane stress: no stress across the plane.
    Stress,
}

/// The Lamé constants of an isotropic law in plane strain form, `τ = λ tr ε I + 2μ ε`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lame {
    /// `λ`; for plane stress the reduced `2λμ/(λ+2μ)`.
    pub lambda: f64,
    /// Shear modulus `μ`.
    pub mu: f64,
}

/// Elastic constants of one body: `(τ_11, τ_22, τ_12) = C (ε_11, ε_22, 2ε_12)`, units of stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    c: [[f64; 3]; 3],
    lame: Option<Lame>,
    /// `τ_33 = across · (τ_11, τ_22)`.
    across: [f64; 2],
}

impl Material {
    /// Any law by its symmetric matrix `C`, which says nothing of the stress across the plane: it counts as none. Refused unless `c_ijkl e_ij e_kl ≥ c0 e_ij e_ij` with `c0 > 0` (2.7).
    pub fn general(c: [[f64; 3]; 3]) -> Result<Self, Error> {
        Self::checked(c, None)
    }

    /// Isotropic, by `λ` and `μ` of plane strain.
    pub fn lame(lambda: f64, mu: f64) -> Result<Self, Error> {
        let normal = lambda + 2.0 * mu;
        let law =
            Self::checked([[normal, lambda, 0.0], [lambda, normal, 0.0], [0.0, 0.0, mu]], Some(Lame { lambda, mu }))?;
        // plane strain: ε_33 = 0 leaves τ_33 = λ (ε_11 + ε_22) = λ / 2(λ+μ) (τ_11 + τ_22)
        Ok(Self { across: [lambda / (2.0 * (lambda + mu)); 2], ..law })
    }

    /// Isotropic, by Young's modulus `E > 0` and Poisson's ratio `−1 < ν < ½`.
    pub fn isotropic(young: f64, poisson: f64, plane: Plane) -> Result<Self, Error> {
        if !(young > 0.0 && young.is_finite()) {
            return Err(Error::Material(format!("Young's modulus E = {young} must be positive and finite")));
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(Error::Material(format!(
                "Poisson's ratio ν = {poisson} must satisfy −1 < ν < 1/2; at ν = 1/2 the material is incompressible \
                 and a displacement method has no energy to minimise"
            )));
        }
        let mu = young / (2.0 * (1.0 + poisson));
        let lambda = match plane {
            Plane::Strain => young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
            Plane::Stress => young * poisson / (1.0 - poisson * poisson),
        };
        let law = Self::lame(lambda, mu)?;
        Ok(if plane == Plane::Stress { Self { across: [0.0; 2], ..law } } else { law })
    }

    /// Orthotropic along the axes: moduli `E_1, E_2, E_3`, ratios `ν_12, ν_13, ν_23` (`ν_ij/E_i = ν_ji/E_j`), shear modulus
    /// `G_12`. Plane stress ignores `E_3, ν_13, ν_23`.
    pub fn orthotropic(moduli: [f64; 3], ratios: [f64; 3], shear: f64, plane: Plane) -> Result<Self, Error> {
        let [e1, e2, e3] = moduli;
        let [n12, n13, n23] = ratios;
        // Compliance ε_1 = S_11 τ_1 + S_12 τ_2; plane strain eliminates τ_3 through ε_3 = 0.
        let (mut s11, mut s22, mut s12) = (1.0 / e1, 1.0 / e2, -n12 / e1);
        if plane == Plane::Strain {
            s11 -= n13 * n13 / e1 / e1 * e3;
            s22 -= n23 * n23 / e2 / e2 * e3;
            s12 -= n13 / e1 * (n23 / e2) * e3;
        }
        let det = s11 * s22 - s12 * s12;
        let law = Self::checked([[s22 / det, -s12 / det, 0.0], [-s12 / det, s11 / det, 0.0], [0.0, 0.0, shear]], None)?;
        // plane strain: 0 = ε_33 = τ_33/E_3 − ν_13 τ_11/E_1 − ν_23 τ_22/E_2
        let across = if plane == Plane::Strain { [n13 * e3 / e1, n23 * e3 / e2] } else { [0.0; 2] };
        Ok(Self { across, ..law })
    }

    fn checked(c: [[f64; 3]; 3], lame: Option<Lame>) -> Result<Self, Error> {
        let largest = c.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            if (c[i][j] - c[j][i]).abs() > 1e-12 * largest {
                return Err(Error::Material(format!(
                    "C is not symmetric: C[{i}][{j}] = {} but C[{j}][{i}] = {}",
                    c[i][j], c[j][i]
                )));
            }
        }
        let c0 = smallest_modulus(&c);
        if c0.is_nan() || c0 <= 1e-14 * largest || !largest.is_finite() {
            return Err(Error::Material(format!(
                "c_ijkl is not positive: its smallest modulus c0 = {c0:.3e} must be positive (2.7); C = {c:?}"
            )));
        }
        Ok(Self { c, lame, across: [0.0; 2] })
    }

    /// The matrix `C`, acting on `(ε_11, ε_22, 2ε_12)`.
    #[inline]
    pub fn matrix(&self) -> &[[f64; 3]; 3] {
        &self.c
    }

    /// The Lamé constants, if the law was given as isotropic.
    pub fn lame_constants(&self) -> Option<Lame> {
        self.lame
    }

    /// `c0` of (2.7): the smallest ratio of `c_ijkl e_ij e_kl` to `e_ij e_ij`.
    pub fn smallest_modulus(&self) -> f64 {
        smallest_modulus(&self.c)
    }

    /// `τ = c ε` for the strain components `ε_11, ε_22, ε_12`.
    #[inline]
    pub fn stress(&self, strain: Sym2) -> Sym2 {
        let e = [strain[0], strain[1], 2.0 * strain[2]];
        self.c.map(|c| c[0] * e[0] + c[1] * e[1] + c[2] * e[2])
    }

    /// `τ_33`, the stress across the plane: that of plane strain, or zero in plane stress and of a law given by its matrix.
    pub fn stress_across(&self, stress: Sym2) -> f64 {
        self.across[0] * stress[0] + self.across[1] * stress[1]
    }

    /// The stress of von Mises, `√(½[(τ_11−τ_22)² + (τ_22−τ_33)² + (τ_33−τ_11)²] + 3τ_12²)`, in units of stress.
    pub fn von_mises(&self, stress: Sym2) -> f64 {
        let ([a, b, shear], c) = (stress, self.stress_across(stress));
        (0.5 * ((a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2)) + 3.0 * shear * shear).sqrt()
    }
}

/// `a_ij b_ij` of two symmetric tensors.
#[inline]
pub fn contract(a: Sym2, b: Sym2) -> f64 {
    a[0] * b[0] + a[1] * b[1] + 2.0 * a[2] * b[2]
}

/// The strain `ε_ij = ½(∂_j u_i + ∂_i u_j)` of a displacement gradient `gradient[i][j] = ∂_j u_i`.
#[inline]
pub fn strain(gradient: [[f64; 2]; 2]) -> Sym2 {
    [gradient[0][0], gradient[1][1], 0.5 * (gradient[0][1] + gradient[1][0])]
}

fn smallest_modulus(c: &[[f64; 3]; 3]) -> f64 {
    // In the basis (e_11, e_22, √2 e_12) the product e_ij e_ij is the Euclidean one.
    let r = f64::sqrt(2.0);
    let scale = [1.0, 1.0, r];
    let m = Matrix3::from_fn(|i, j| c[i][j] * scale[i] * scale[j]);
    if m.iter().any(|x| !x.is_finite()) {
        return f64::NAN;
    }
    SymmetricEigen::new(m).eigenvalues.min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn isotropic_laws_agree_and_their_smallest_modulus_is_two_mu() {
        let m = Material::isotropic(2.6, 0.3, Plane::Strain).unwrap();
        let l = m.lame_constants().unwrap();
        assert!((l.mu - 1.0).abs() < 1e-15 && (l.lambda - 1.5).abs() < 1e-14);
        assert!((m.smallest_modulus() - 2.0).abs() < 1e-14);
        let stress = Material::isotropic(2.6, 0.3, Plane::Stress).unwrap();
        // Plane stress: a uniaxial stress E e strains sideways by −ν e.
        let t = stress.stress([1.0, -0.3, 0.0]);
        assert!((t[0] - 2.6).abs() < 1e-14 && t[1].abs() < 1e-14, "{t:?}");
    }

    #[test]
    fn an_isotropic_law_is_a_special_orthotropic_one() {
        for plane in [Plane::Strain, Plane::Stress] {
            let iso = Material::isotropic(2.6, 0.3, plane).unwrap();
            let ortho = Material::orthotropic([2.6; 3], [0.3; 3], 1.0, plane).unwrap();
            for (a, b) in iso.matrix().iter().flatten().zip(ortho.matrix().iter().flatten()) {
                assert!((a - b).abs() < 1e-14, "{plane:?}: {a} {b}");
            }
        }
    }

    /// Textbook values: uniaxial stress has its own size, pure shear √3 times it; in plane strain a uniaxial stress `s` is
    /// accompanied by `τ_33 = ν s`, so `s √(1 − ν + ν²)`.
    #[test]
    fn von_mises_of_uniaxial_stress_and_of_shear_in_both_planes() {
        let nu = 0.3;
        for (plane, uniaxial) in [(Plane::Stress, 1.0), (Plane::Strain, f64::sqrt(1.0 - nu + nu * nu))] {
            let laws = [
                Material::isotropic(2.6, nu, plane).unwrap(),
                Material::orthotropic([2.6; 3], [nu; 3], 1.0, plane).unwrap(),
            ];
            for law in laws {
                assert!((law.von_mises([2.0, 0.0, 0.0]) - 2.0 * uniaxial).abs() < 1e-14, "{plane:?}");
                assert!((law.von_mises([0.0, 2.0, 0.0]) - 2.0 * uniaxial).abs() < 1e-14, "{plane:?}");
                assert!((law.von_mises([0.0, 0.0, 2.0]) - 2.0 * f64::sqrt(3.0)).abs() < 1e-14, "{plane:?}");
            }
        }
    }

    /// The strain across the plane vanishes: `E_3 ε_33 = τ_33 − E_3 (ν_13 τ_11/E_1 + ν_23 τ_22/E_2)`.
    #[test]
    fn plane_strain_of_an_orthotropic_law_holds_the_strain_across() {
        let law = Material::orthotropic([1.0, 2.0, 4.0], [0.2, 0.1, 0.15], 0.7, Plane::Strain).unwrap();
        let stress = [0.3, -0.8, 0.1];
        let strain = law.stress_across(stress) / 4.0 - 0.1 * stress[0] / 1.0 - 0.15 * stress[1] / 2.0;
        assert!(strain.abs() < 1e-16, "{strain}");
    }

    #[test]
    fn laws_that_break_2_7_are_refused() {
        assert!(Material::isotropic(1.0, 0.5, Plane::Strain).is_err());
        assert!(Material::isotropic(-1.0, 0.3, Plane::Strain).is_err());
        assert!(Material::lame(-1.0, 1.0).is_err(), "λ + μ = 0 is not positive");
        assert!(Material::general([[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
        assert!(Material::general([[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]]).is_err());
        assert!(Material::general([[1.0, 0.0, f64::NAN], [0.0, 1.0, 0.0], [f64::NAN, 0.0, 1.0]]).is_err());
    }
}
