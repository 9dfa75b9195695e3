//! Stress, loads and contact quantities of an exact displacement.

use super::{Exact, Jet2};
use signorini_contact::geometry::LinePoint;
use signorini_contact::material::{Sym2, strain};
use signorini_contact::{Body, Material, Point, Vec2};

/// `τ` at a point of `body`, whose material is `material`; components `11, 22, 12`.
pub fn stress(exact: &dyn Exact, material: &Material, body: Body, x: Point) -> Sym2 {
    material.stress(strain(exact.jet(body, x).gradient))
}

/// The body force `F = −div τ`, force per area.
pub fn body_force(exact: &dyn Exact, material: &Material, body: Body, x: Point) -> Vec2 {
    body_force_of(&exact.jet2(body, x), material)
}

/// The body force `F = −div τ` of a jet that is known already.
pub fn body_force_of(jet: &Jet2, material: &Material) -> Vec2 {
    let h = &jet.hessian;
    // ∂_k τ = C ∂_k ε
    let derivative = |k: usize| material.stress(strain([0, 1].map(|i| [h[i][0][k], h[i][1][k]])));
    let (d1, d2) = (derivative(0), derivative(1));
    // F_1 = −(∂_1 τ_11 + ∂_2 τ_12), F_2 = −(∂_1 τ_12 + ∂_2 τ_22)
    Vec2::new(-(d1[0] + d2[2]), -(d1[2] + d2[1]))
}

/// The traction `τ n` on a line with unit normal `n`, force per length. With a longer `n`, force per that length.
pub fn traction(exact: &dyn Exact, material: &Material, body: Body, x: Point, n: Vec2) -> Vec2 {
    apply(stress(exact, material, body, x), n)
}

/// The contact stress `T_n = n·τ'n` of `Ω'`, whose outward unit normal is `n`; pressing is negative.
pub fn contact_stress(exact: &dyn Exact, material: &Material, x: Point, n: Vec2) -> f64 {
    n.dot(&traction(exact, material, Body::First, x, n))
}

/// The jump `n·(u' − u'')`; the gap is its negative.
pub fn jump(exact: &dyn Exact, x: Point, n: Vec2) -> f64 {
    n.dot(&(exact.value(Body::First, x) - exact.value(Body::Second, x)))
}

/// The contact force of `Ω'` along the normal of the constraint, per unit of the zone's measure `μ`; pressing is negative.
/// In P1 it is `T_n`, in P2 `T_ξ = −T'_ξ/cos α'`. `material` is that of `Ω'`.
pub fn contact_stress_at(exact: &dyn Exact, material: &Material, point: &LinePoint) -> f64 {
    point.normal.dot(&traction(exact, material, Body::First, point.at[0], point.conormals[0]))
}

/// The jump `n·(u' − u'')`, each displacement at its own body's point; what remains of the gap is `point.gap` less the jump.
pub fn jump_at(exact: &dyn Exact, point: &LinePoint) -> f64 {
    let [first, second] = point.at;
    point.normal.dot(&(exact.value(Body::First, first) - exact.value(Body::Second, second)))
}

/// `τ n`.
pub(super) fn apply(t: Sym2, n: Vec2) -> Vec2 {
    Vec2::new(t[0] * n.x + t[2] * n.y, t[2] * n.x + t[1] * n.y)
}
