//! The matrix against the forces of displacements, which know no pattern and no basis of their own.

use super::pattern::CHUNK;
use super::surroundings::Surroundings;
use super::{internal_forces, scatter};
use crate::element::CurvedElement;
use crate::geometry::Vec2;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::mesh::blocks::Pattern;
use crate::mesh::tests::{kinked, quarter_disc, squares};
use crate::problem::{Data, Discrete, Problem, Support};
use crate::quadrature::Cubature;
use crate::{Body, Point};

struct Given;

impl Data for Given {
    fn has_body_force(&self, body: Body) -> bool {
        body == Body::Second
    }
    fn body_force(&self, _body: Body, x: Point) -> Vec2 {
        Vec2::new(0.1 * x.y, -0.2)
    }
    fn displacement(&self, _part: usize, x: Point) -> Vec2 {
        Vec2::new(0.01 * x.x, 0.02)
    }
}

fn materials() -> [Material; 2] {
    [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()]
}

fn discrete(mesh: &Mesh, supports: &[Support]) -> Discrete {
    let cubature = Cubature::default();
    Problem { mesh, materials: materials(), supports, data: &Given, cubature: &cubature }.discretise().unwrap()
}

/// Random-looking numbers that need no generator.
fn sample(n: usize) -> Vec<f64> {
    (0..n).map(|i| (12.9898 * (i as f64 + 1.0)).sin()).collect()
}

/// `K x` is `Tᵀ A T x` in the free components, and a fixed one meets its diagonal entry alone.
fn check(mesh: &Mesh, supports: &[Support]) {
    let Discrete { basis, qp, .. } = discrete(mesh, supports);
    let fixed = &basis.fixed;
    assert!(fixed.contains(&true));
    let x: Vec<f64> = sample(qp.matrix.dimension()).iter().zip(fixed).map(|(x, f)| if *f { 0.0 } else { *x }).collect();
    let still = basis.displacement(&vec![0.0; x.len()]);
    let moved: Vec<Vec2> = basis.displacement(&x).iter().zip(&still).map(|(u, offset)| u - offset).collect();
    let expected = basis.force(&internal_forces(mesh, &materials(), &moved));
    let mut image = vec![0.0; x.len()];
    qp.matrix.apply(&x, &mut image);
    let scale = qp.matrix.norm_inf();
    for i in 0..x.len() {
        assert!((image[i] - expected[i]).abs() < 1e-13 * scale, "row {i}: {} is not {}", image[i], expected[i]);
    }
    let diagonal = |i: usize| qp.matrix.diagonal_block(i / 2)[3 * (i % 2)];
    let largest = (0..x.len()).filter(|&i| !fixed[i]).map(diagonal).fold(0.0, f64::max);
    let held: Vec<f64> = fixed.iter().map(|f| f64::from(u8::from(*f))).collect();
    qp.matrix.apply(&held, &mut image);
    for i in 0..x.len() {
        assert_eq!(image[i], if fixed[i] { largest } else { 0.0 }, "row {i} of the fixed components");
    }
    for i in 0..qp.matrix.rows() {
        assert!(qp.matrix.row(i).map(|(j, _)| j).is_sorted_by(|a, b| a < b), "the columns of row {i} ascend");
    }
}

use Support::{Fixed, Free, Sliding};

#[test]
fn the_matrix_is_what_displacements_meet_where_the_zone_has_a_corner() {
    for pattern in [Pattern::Structured, Pattern::UnionJack] {
        check(&kinked(3, pattern).build().unwrap(), &[Fixed, Sliding]);
        check(&kinked(2, pattern).build().unwrap(), &[Sliding, Fixed]);
    }
}

#[test]
fn the_matrix_is_what_displacements_meet_on_curved_elements() {
    for element in [CurvedElement::Physical, CurvedElement::Isoparametric { skew: 0.0 }] {
        check(&quarter_disc(3, element), &[Sliding, Fixed]);
    }
}

/// Several chunks of rows, the last of them not full.
#[test]
fn the_matrix_does_not_mind_where_chunks_end() {
    let mesh = squares(48, Pattern::Structured).build().unwrap();
    assert!(mesh.points.len() > CHUNK && !mesh.points.len().is_multiple_of(CHUNK));
    check(&mesh, &[Fixed, Sliding, Free, Sliding]);
}

#[test]
fn surroundings_list_every_triangle_of_a_node_in_order() {
    let mesh = kinked(2, Pattern::CrissCross).build().unwrap();
    let around = Surroundings::new(&mesh);
    for node in 0..mesh.points.len() {
        let corner = |t: usize| mesh.triangles[t].iter().position(|&i| i as usize == node).map(|k| (t, k));
        let expected: Vec<_> = (0..mesh.triangles.len()).filter_map(corner).collect();
        assert_eq!(around.of(node).collect::<Vec<_>>(), expected);
    }
}

/// More triangles than are computed at once: the sums are those of a plain loop, to the last bit.
#[test]
fn what_triangles_give_is_added_in_their_order() {
    let mesh = squares(70, Pattern::Structured).build().unwrap();
    let give = |t: usize| {
        (!t.is_multiple_of(5)).then(|| mesh.triangles[t].map(|i| Vec2::new(1.0 / (t as f64 + 0.3), i as f64)))
    };
    let range = 7..mesh.triangles.len() - 3;
    let mut expected = vec![Vec2::zeros(); mesh.points.len()];
    for t in range.clone() {
        let Some(gift) = give(t) else { continue };
        mesh.triangles[t].iter().zip(gift).for_each(|(&i, g)| expected[i as usize] += g);
    }
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut nodal = vec![Vec2::zeros(); mesh.points.len()];
        pool.install(|| scatter(&mesh, range.clone(), &mut nodal, |t| Ok::<_, ()>(give(t)))).unwrap();
        assert_eq!(nodal, expected);
    }
    let refuse = |t: usize| if t >= 20_000 || t == 17_001 { Err(t) } else { Ok(None) };
    let refused = scatter(&mesh, 0..mesh.triangles.len() * 2, &mut [], refuse);
    assert_eq!(refused, Err(17_001), "the first in the order of the triangles");
}
