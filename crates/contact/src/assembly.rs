//! The stiffness matrix in the changed basis and the nodal loads.
//!
//! Every row is gathered from the elements around its node, so rows are independent: parallel, without locks, and the
//! same to the last bit for any number of threads. `O(N)` time; element blocks are computed once per row, not stored.

use crate::basis::{Basis, Slot};
use crate::data::{Data, Support};
use crate::element::{gradients, hats, linear_strain, stiffness_block};
use crate::geometry::Vec2;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::mesh::side::SideView;
use crate::quadrature::Cubature;
use crate::sparse::BlockMatrix;
use crate::{Error, Point};
use rayon::prelude::*;

/// The triangles around each node: those of node `i` are `list[start[i]..start[i+1]]`, each with the node's corner.
pub struct Surroundings {
    start: Vec<usize>,
    list: Vec<(u32, u8)>,
}

impl Surroundings {
    /// Lists the triangles around every node by counting. `O(N)`.
    pub fn new(mesh: &Mesh) -> Self {
        let mut start = vec![0usize; mesh.points.len() + 1];
        mesh.triangles.iter().flatten().for_each(|&i| start[i as usize + 1] += 1);
        (0..mesh.points.len()).for_each(|i| start[i + 1] += start[i]);
        let mut next = start.clone();
        let mut list = vec![(0, 0); 3 * mesh.triangles.len()];
        for (t, corners) in mesh.triangles.iter().enumerate() {
            for (corner, &i) in corners.iter().enumerate() {
                list[next[i as usize]] = (t as u32, corner as u8);
                next[i as usize] += 1;
            }
        }
        Self { start, list }
    }

    fn of(&self, node: usize) -> &[(u32, u8)] {
        &self.list[self.start[node]..self.start[node + 1]]
    }
}

/// `Tᵀ A T`; a fixed component keeps nothing but a diagonal entry, the largest of the others, so that no unit enters the matrix.
pub fn stiffness(mesh: &Mesh, materials: &[Material; 2], basis: &Basis) -> BlockMatrix {
    let around = Surroundings::new(mesh);
    let partner = partners(basis);
    let row = |slot: usize| gather_row(mesh, materials, basis, &around, partner[slot], slot);
    let rows: Vec<Vec<(u32, [f64; 4])>> = (0..basis.nodes()).into_par_iter().with_min_len(256).map(row).collect();
    let mut matrix = BlockMatrix { row_start: Vec::with_capacity(rows.len() + 1), ..Default::default() };
    let entries = rows.iter().map(Vec::len).sum();
    matrix.columns.reserve_exact(entries);
    matrix.blocks.reserve_exact(entries);
    matrix.row_start.push(0);
    for row in rows {
        for (column, block) in row {
            matrix.columns.push(column);
            matrix.blocks.push(block);
        }
        matrix.row_start.push(matrix.columns.len());
    }
    fill_fixed(&mut matrix, basis);
    matrix
}

/// The diagonal entries of the fixed components.
fn fill_fixed(matrix: &mut BlockMatrix, basis: &Basis) {
    let diagonal = |i: usize| matrix.diagonal_block(i / 2)[3 * (i % 2)];
    let free = (0..basis.fixed.len()).filter(|&i| !basis.fixed[i]);
    let largest = free.map(diagonal).fold(0.0, f64::max);
    let entry = if largest > 0.0 { largest } else { 1.0 };
    for row in 0..matrix.rows() {
        let stored = matrix.row_start[row]..matrix.row_start[row + 1];
        let Some(k) = stored.into_iter().find(|&k| matrix.columns[k] as usize == row) else { continue };
        for i in (0..2).filter(|i| basis.fixed[2 * row + i]) {
            matrix.blocks[k][3 * i] = entry;
        }
    }
}

/// For each slot, the nodes whose displacement depends on it: itself, and its partner in a pair.
fn partners(basis: &Basis) -> Vec<Option<u32>> {
    let mut partner = vec![None; basis.nodes()];
    for node in 0..basis.nodes() {
        if let ([(a, _), (b, _)], 2) = basis.slots(node) {
            partner[node] = Some(if a as usize == node { b } else { a });
        }
    }
    partner
}

/// Row `slot` of `TᵀAT`: `Σ T_i,slotᵀ k_ij T_j,s` over the elements around the nodes `i` that depend on the slot.
fn gather_row(
    mesh: &Mesh,
    materials: &[Material; 2],
    basis: &Basis,
    around: &Surroundings,
    partner: Option<u32>,
    slot: usize,
) -> Vec<(u32, [f64; 4])> {
    let mut row: Vec<(u32, [f64; 4])> = Vec::with_capacity(8);
    for node in std::iter::once(slot).chain(partner.map(|p| p as usize)) {
        let left = block_of_slot(basis, node, slot);
        for &(t, corner) in around.of(node) {
            let t = t as usize;
            let blocks = element_row(mesh, &materials[mesh.body(t).index()], t, corner as usize);
            for (block, &j) in blocks.iter().zip(&mesh.triangles[t]) {
                let left_block = transposed_product(&left, block);
                let (slots, n) = basis.slots(j as usize);
                for (column, right) in &slots[..n] {
                    add_block(&mut row, *column, &product(&left_block, right));
                }
            }
        }
    }
    row.sort_unstable_by_key(|(column, _)| *column);
    row.iter_mut().for_each(|(column, block)| fix_components(basis, slot, *column as usize, block));
    row
}

/// The blocks `k_ij` of triangle `t` for `i = corner` and its three corners `j`.
fn element_row(mesh: &Mesh, material: &Material, t: usize, corner: usize) -> [[f64; 4]; 3] {
    if let Some(curved) = mesh.curved_triangle(t) {
        return curved.stiffness_row(material, corner);
    }
    let (g, area) = gradients(mesh.corners(t));
    [0, 1, 2].map(|k| stiffness_block(material, area, g[corner], g[k]))
}

fn block_of_slot(basis: &Basis, node: usize, slot: usize) -> [f64; 4] {
    let (slots, n) = basis.slots(node);
    let of_slot = |s: &&Slot| s.0 as usize == slot;
    slots[..n].iter().find(of_slot).map_or([0.0; 4], |s| s.1)
}

fn add_block(row: &mut Vec<(u32, [f64; 4])>, column: u32, block: &[f64; 4]) {
    match row.iter_mut().find(|(c, _)| *c == column) {
        Some((_, sum)) => (0..4).for_each(|k| sum[k] += block[k]),
        None => row.push((column, *block)),
    }
}

/// Zero where the row's or the column's component is fixed.
fn fix_components(basis: &Basis, row: usize, column: usize, block: &mut [f64; 4]) {
    for (entry, value) in block.iter_mut().enumerate() {
        let (i, j) = (2 * row + entry / 2, 2 * column + entry % 2);
        if basis.fixed[i] || basis.fixed[j] {
            *value = 0.0;
        }
    }
}

pub(crate) fn product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    [a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]]
}

fn transposed_product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    product(&[a[0], a[2], a[1], a[3]], b)
}

/// The nodal loads `f(φ_i)`: body forces and tractions by quadrature. A load that is not a number is refused, with its place.
pub fn loads(mesh: &Mesh, supports: &[Support], data: &dyn Data, cubature: &Cubature) -> Result<Vec<Vec2>, Error> {
    let mut nodal = vec![Vec2::zeros(); mesh.points.len()];
    let body_loads: Vec<Option<[Vec2; 3]>> = (0..mesh.triangles.len())
        .into_par_iter()
        .with_min_len(64)
        .map(|t| element_load(mesh, data, cubature, t))
        .collect();
    for (t, load) in body_loads.iter().enumerate() {
        let Some(load) = load else { continue };
        check_load(load, || format!("body force in triangle {t} around {}", place(&mesh.corners(t))))?;
        mesh.triangles[t].iter().zip(load).for_each(|(&i, l)| nodal[i as usize] += l);
    }
    for side in mesh.sides.iter().filter(|s| supports[s.part as usize] == Support::Traction) {
        let view = mesh.boundary_view(side);
        let load = side_load(&view, data, side.part as usize, cubature);
        let name = &mesh.parts[side.part as usize].name;
        let corners = side.nodes.map(|i| mesh.points[i as usize]);
        check_load(&load, || format!("traction on part '{name}' near {}", place(&corners)))?;
        view.nodes.iter().zip(&load).for_each(|(&i, l)| nodal[i as usize] += l);
    }
    Ok(nodal)
}

/// `∫_T F φ_k dx` for the three corners, or nothing where the body carries no force.
fn element_load(mesh: &Mesh, data: &dyn Data, cubature: &Cubature, t: usize) -> Option<[Vec2; 3]> {
    let body = mesh.body(t);
    if !data.has_body_force(body) {
        return None;
    }
    let mut load = [Vec2::zeros(); 3];
    let mut add = |x: Point, hats: &[f64; 3], w: f64| {
        let force = w * data.body_force(body, x);
        load.iter_mut().zip(hats).for_each(|(l, hat)| *l += *hat * force);
    };
    match mesh.curved_triangle(t) {
        Some(curved) => cubature.curved(&curved, &mut |p, w| add(p.x, &p.hats, w)),
        None => {
            let corners = mesh.corners(t);
            cubature.triangle(corners, &mut |x, w| add(x, &hats(corners, x), w));
        }
    }
    Some(load)
}

/// `∫ P φ_k ds` over a side for the three nodes of its triangle.
fn side_load(side: &SideView, data: &dyn Data, part: usize, cubature: &Cubature) -> [Vec2; 3] {
    let mut load = [Vec2::zeros(); 3];
    side.points(cubature, &mut |x, normal, hats, ds| {
        let traction = ds * data.traction(part, x, normal);
        (0..3).for_each(|k| load[k] += hats[k] * traction);
    });
    load
}

/// Refuses a load that is no number; `what` says whose it is.
///
/// # Errors
/// [`Error::Load`] with the value.
pub fn check_load(load: &[Vec2], what: impl Fn() -> String) -> Result<(), Error> {
    match load.iter().find(|l| !(l.x.is_finite() && l.y.is_finite())) {
        None => Ok(()),
        Some(l) => Err(Error::Load(format!(
            "{} integrates to ({}, {}), which is no number; check its expression there (a division by zero, a root or logarithm of a negative number)",
            what(),
            l.x,
            l.y
        ))),
    }
}

fn place(points: &[Point]) -> String {
    let middle = points.iter().sum::<Point>() / points.len() as f64;
    format!("({:.6}, {:.6})", middle.x, middle.y)
}

/// `A(v, φ_i)` for every node, in the components of the plane: what prescribed displacements take off the load.
pub fn internal_forces(mesh: &Mesh, materials: &[Material; 2], v: &[Vec2]) -> Vec<Vec2> {
    let mut nodal = vec![Vec2::zeros(); mesh.points.len()];
    for t in 0..mesh.triangles.len() {
        let values = mesh.triangles[t].map(|i| v[i as usize]);
        if values.iter().all(|v| *v == Vec2::zeros()) {
            continue;
        }
        if mesh.curved.of(t).is_some() {
            add_curved_forces(mesh, materials, t, values, &mut nodal);
            continue;
        }
        let (g, area) = gradients(mesh.corners(t));
        let stress = materials[mesh.body(t).index()].stress(linear_strain(&g, values));
        for (k, &i) in mesh.triangles[t].iter().enumerate() {
            // A(v, φ_k e_p) = |T| τ_pq ∂_q φ_k
            let force = Vec2::new(stress[0] * g[k].x + stress[2] * g[k].y, stress[2] * g[k].x + stress[1] * g[k].y);
            nodal[i as usize] += area * force;
        }
    }
    nodal
}

/// The same for a triangle with a curved side, `Σ_j k_ij v_j`.
fn add_curved_forces(mesh: &Mesh, materials: &[Material; 2], t: usize, values: [Vec2; 3], nodal: &mut [Vec2]) {
    for (corner, &i) in mesh.triangles[t].iter().enumerate() {
        let row = element_row(mesh, &materials[mesh.body(t).index()], t, corner);
        let times = |(b, v): (&[f64; 4], &Vec2)| Vec2::new(b[0] * v.x + b[1] * v.y, b[2] * v.x + b[3] * v.y);
        nodal[i as usize] += row.iter().zip(&values).map(times).sum::<Vec2>();
    }
}
