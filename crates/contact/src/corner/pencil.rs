//! The quadratic eigenvalue problem in `θ`: `(M_0 + λ G − λ² M_2) U = 0`.
//!
//! ```text
//! M_0 = ∫ B_0ᵀ C B_0,   G = ∫ (B_0ᵀ C B_1 − B_1ᵀ C B_0),   M_2 = ∫ B_1ᵀ C B_1
//! ```

use super::{Face, FaceOf, Wedge};
use crate::material::Material;
use crate::quadrature::GAUSS_8;
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, Par};
use nalgebra::{Complex, DMatrix, Matrix3};
use std::f64::consts::FRAC_PI_2;

/// Degree of the polynomials on an element: the Gauss rule with 8 points integrates their products exactly.
const DEGREE: usize = 7;

/// Nodes of an element.
const NODES: usize = DEGREE + 1;

/// The components `U_r, U_θ` of the nodes of a wedge as unknowns; `None` where the face fixes them.
type Unknowns = Vec<[Option<usize>; 2]>;

/// The assembled problem.
pub(super) struct Pencil {
    m0: DMatrix<f64>,
    g: DMatrix<f64>,
    m2: DMatrix<f64>,
    unknowns: Vec<Unknowns>,
}

impl Pencil {
    pub(super) fn new(wedges: &[Wedge], contacts: &[[FaceOf; 2]]) -> Self {
        let (unknowns, size) = number(wedges, contacts);
        let zero = || DMatrix::zeros(size, size);
        let mut pencil = Self { m0: zero(), g: zero(), m2: zero(), unknowns: Vec::new() };
        for (wedge, unknowns) in wedges.iter().zip(&unknowns) {
            let (count, width) = elements(wedge);
            for element in 0..count {
                let nodes = &unknowns[element * DEGREE..=(element + 1) * DEGREE];
                pencil.add(&wedge.material, wedge.from + element as f64 * width, width, nodes);
            }
        }
        Self { unknowns, ..pencil }
    }

    /// Adds the element of width `width` that starts at the angle `start`.
    fn add(&mut self, material: &Material, start: f64, width: f64, nodes: &[[Option<usize>; 2]]) {
        for (s, weight) in GAUSS_8 {
            let c = polar(material, start + s * width) * (weight * width);
            let hats = lagrange(s);
            // columns of B_0 and B_1: strains e_rr, e_θθ, 2e_rθ of the unit values of U_r and U_θ at each node
            let columns: Vec<(usize, [f64; 3], [f64; 3])> = nodes
                .iter()
                .zip(hats)
                .flat_map(|(unknown, (value, slope))| {
                    let slope = slope / width;
                    let radial = unknown[0].map(|i| (i, [0.0, value, slope], [value, 0.0, 0.0]));
                    let angular = unknown[1].map(|i| (i, [0.0, slope, -value], [0.0, 0.0, value]));
                    [radial, angular]
                })
                .flatten()
                .collect();
            for &(i, b0_i, b1_i) in &columns {
                for &(j, b0_j, b1_j) in &columns {
                    self.m0[(i, j)] += product(&b0_i, &c, &b0_j);
                    self.g[(i, j)] += product(&b0_i, &c, &b1_j) - product(&b1_i, &c, &b0_j);
                    self.m2[(i, j)] += product(&b1_i, &c, &b1_j);
                }
            }
        }
    }

    /// All `λ`: the eigenvalues of the companion matrix of `λ² U = M_2⁻¹ (M_0 + λ G) U`.
    pub(super) fn eigenvalues(&self) -> Vec<Complex<f64>> {
        let n = self.m0.nrows();
        // M_2 is positive definite with C: its strains are e_rr = U_r and 2e_rθ = U_θ
        let Some(factor) = self.m2.clone().cholesky() else { return Vec::new() };
        let (below, beside) = (factor.solve(&self.m0), factor.solve(&self.g));
        let companion = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, _) => f64::from(u8::from(j == i + n)),
            (false, true) => below[(i - n, j)],
            (false, false) => beside[(i - n, j - n)],
        });
        all_eigenvalues(&companion)
    }
}

/// The eigenvalues of a square matrix; none if the iteration does not end. One thread, so that the bytes never depend on their number.
fn all_eigenvalues(matrix: &Mat<f64>) -> Vec<Complex<f64>> {
    let n = matrix.nrows();
    let (mut re, mut im) = (Diag::zeros(n), Diag::zeros(n));
    let none = ComputeEigenvectors::No;
    let scratch = evd_scratch::<f64>(n, none, none, Par::Seq, Default::default());
    let mut memory = MemBuffer::new(scratch);
    let stack = MemStack::new(&mut memory);
    // faer, since nalgebra's iteration has no limit and did go on for ever on a random scene
    let ended =
        evd_real(matrix.as_ref(), re.as_mut(), im.as_mut(), None, None, Par::Seq, stack, Default::default()).is_ok();
    let values = re.column_vector().iter().zip(im.column_vector().iter());
    values.filter(|_| ended).map(|(re, im)| Complex::new(*re, *im)).collect()
}

impl Pencil {
    /// `−σ_θθ` of the mode of a real simple `λ` on each closed ray, up to a common factor: from the null vector of
    /// `M_0 + λ G − λ² M_2`.
    pub(super) fn pressures(
        &self,
        lambda: Complex<f64>,
        wedges: &[Wedge],
        contacts: &[[FaceOf; 2]],
    ) -> Option<Vec<f64>> {
        if lambda.im != 0.0 || contacts.is_empty() {
            return None;
        }
        let l = lambda.re;
        let svd = (&self.m0 + &self.g * l - &self.m2 * (l * l)).try_svd(false, true, f64::EPSILON, SVD_STEPS)?;
        let values = &svd.singular_values;
        let n = values.len();
        // sorted, largest first: a second one near zero is a second mode
        if n < 2 || values[n - 2] < SEVERAL * values[0] {
            return None;
        }
        let v_t = svd.v_t?;
        let value = |unknown: Option<usize>| unknown.map_or(0.0, |i| v_t[(n - 1, i)]);
        let pressure = |(w, end): FaceOf| {
            let (count, width) = elements(&wedges[w]);
            let first = end * (count - 1) * DEGREE;
            let hats = lagrange(end as f64);
            let mut strain = [0.0; 3];
            for (unknown, (hat, slope)) in self.unknowns[w][first..=first + DEGREE].iter().zip(hats) {
                let [radial, angular] = unknown.map(value);
                // e_rr = λ U_r, e_θθ = U_θ' + U_r, 2e_rθ = U_r' + (λ − 1) U_θ
                strain[0] += l * hat * radial;
                strain[1] += slope / width * angular + hat * radial;
                strain[2] += slope / width * radial + (l - 1.0) * hat * angular;
            }
            let c = polar(&wedges[w].material, [wedges[w].from, wedges[w].to][end]);
            -(0..3).map(|j| c[(1, j)] * strain[j]).sum::<f64>()
        };
        Some(contacts.iter().map(|pair| pressure(pair[0])).collect())
    }
}

/// Steps of a singular value decomposition, at most: without a limit it may go on for ever.
const SVD_STEPS: usize = 1000;

/// A second singular value below this share of the largest belongs to a second mode.
const SEVERAL: f64 = 1e-9;

/// How many elements a wedge has, at most a right angle wide each, and how wide they are.
fn elements(wedge: &Wedge) -> (usize, f64) {
    let count = (wedge.angle() / FRAC_PI_2 - 1e-9).ceil().max(1.0);
    (count as usize, wedge.angle() / count)
}

/// Numbers the unknowns of all wedges; the two `U_θ` on a closed contact ray are one.
fn number(wedges: &[Wedge], contacts: &[[FaceOf; 2]]) -> (Vec<Unknowns>, usize) {
    let mut next = 0;
    let mut take = || {
        next += 1;
        next - 1
    };
    let mut all: Vec<Unknowns> = Vec::with_capacity(wedges.len());
    for (w, wedge) in wedges.iter().enumerate() {
        let last = elements(wedge).0 * DEGREE;
        let mut unknowns = Unknowns::with_capacity(last + 1);
        for node in 0..=last {
            let end = if node == 0 { Some(0) } else { (node == last).then_some(1) };
            let face = end.map(|e| wedge.faces[e]);
            let partner = end.and_then(|e| contacts.iter().find(|pair| pair[1] == (w, e)).map(|pair| pair[0]));
            let radial = (face != Some(Face::Clamped)).then(&mut take);
            let angular = match (face, partner) {
                (Some(Face::Clamped | Face::Sliding), _) => None,
                (_, Some((other, e))) => {
                    let theirs = &all[other];
                    theirs[e * (theirs.len() - 1)][1]
                }
                _ => Some(take()),
            };
            unknowns.push([radial, angular]);
        }
        all.push(unknowns);
    }
    (all, next)
}

/// `C` for the components `rr, θθ, rθ` at the angle `θ`.
fn polar(material: &Material, theta: f64) -> Matrix3<f64> {
    let (s, c) = theta.sin_cos();
    let to_cartesian = |e: [f64; 3]| {
        [
            c * c * e[0] + s * s * e[1] - 2.0 * s * c * e[2],
            s * s * e[0] + c * c * e[1] + 2.0 * s * c * e[2],
            s * c * (e[0] - e[1]) + (c * c - s * s) * e[2],
        ]
    };
    let to_polar = |t: [f64; 3]| {
        [
            c * c * t[0] + s * s * t[1] + 2.0 * s * c * t[2],
            s * s * t[0] + c * c * t[1] - 2.0 * s * c * t[2],
            s * c * (t[1] - t[0]) + (c * c - s * s) * t[2],
        ]
    };
    // unit strains e_rr, e_θθ, 2e_rθ
    let columns =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]].map(|e| to_polar(material.stress(to_cartesian(e))));
    Matrix3::from_fn(|i, j| columns[j][i])
}

fn product(a: &[f64; 3], c: &Matrix3<f64>, b: &[f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * (0..3).map(|j| c[(i, j)] * b[j]).sum::<f64>()).sum()
}

/// Values and slopes at `s ∈ [0, 1]` of the Lagrange polynomials of the Chebyshev–Lobatto nodes.
fn lagrange(s: f64) -> [(f64, f64); NODES] {
    let node = |k: usize| 0.5 - 0.5 * (std::f64::consts::PI * k as f64 / DEGREE as f64).cos();
    std::array::from_fn(|k| {
        let others = || (0..NODES).filter(move |&i| i != k);
        let factor = |i: usize| (s - node(i)) / (node(k) - node(i));
        let value = others().map(factor).product();
        let slope =
            others().map(|i| others().filter(|&j| j != i).map(factor).product::<f64>() / (node(k) - node(i))).sum();
        (value, slope)
    })
}
