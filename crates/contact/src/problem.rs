//! A contact problem on a mesh: from bodies and loads to the bound-constrained problem, and back to displacements.

mod levels;
mod slide;

pub use slide::SlideCondition;

use crate::basis::{Basis, BoundOrigin, NodeSupport, NodeSupports};
pub use crate::data::{Data, Support, Unloaded};
use crate::geometry::{Vec2, cross, tangent_of};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::qp::{self, BoundQp};
use crate::quadrature::Cubature;
use crate::solver::{self, QpSolution};
use crate::zone::{ContactPair, Zone};
use crate::{Error, assembly, norm, rigid};
use std::collections::BTreeSet;

/// Two bodies in contact, discretised on a mesh.
pub struct Problem<'a> {
    /// The triangulation.
    pub mesh: &'a Mesh,
    /// Elastic constants of `Ω'` and `Ω''`.
    pub materials: [Material; 2],
    /// The condition on each of the mesh's parts.
    pub supports: &'a [Support],
    /// Loads and data.
    pub data: &'a dyn Data,
    /// The quadrature of the loads.
    pub cubature: &'a Cubature,
}

/// The discrete problem: the quadratic problem and the way back to displacements.
pub struct Discrete {
    /// The change of basis.
    pub basis: Basis,
    /// Contact pairs and constraints.
    pub zone: Zone,
    /// The bound-constrained problem.
    pub qp: BoundQp,
    /// Where each bound of the problem comes from.
    pub origins: Vec<BoundOrigin>,
    /// Nodal loads `f(φ_i)` in the components of the plane.
    pub load: Vec<Vec2>,
    /// Remarks: nearly dependent normals, conditions that pin a free slide.
    pub warnings: Vec<String>,
}

/// A discrete solution `u_h` with its contact forces.
pub struct Solution {
    /// Nodal displacements.
    pub displacement: Vec<Vec2>,
    /// The multiplier of each constraint of each pair (zero where the constraint was dropped), a force; negative only where
    /// a bilateral constraint is in tension.
    pub contact_forces: Vec<Vec<f64>>,
    /// `L(u_h)`.
    pub energy: f64,
    /// `A(u_h, u_h)`.
    pub strain_energy: f64,
    /// The solver's own answer.
    pub raw: QpSolution,
}

impl Problem<'_> {
    /// Assembles, and refuses what has no solution: a load that pushes a free body away, contradicting supports.
    pub fn discretise(&self) -> Result<Discrete, Error> {
        self.discretise_with(assembly::loads(self.mesh, self.supports, self.data, self.cubature)?)
    }

    /// The same with nodal loads `f(φ_i)` that were integrated elsewhere.
    pub fn discretise_with(&self, load: Vec<Vec2>) -> Result<Discrete, Error> {
        self.discretise_zone(load, Zone::new(self.mesh))
    }

    /// The same with constraints that were chosen elsewhere, for zones built otherwise than by [`Zone::new`]. Its pairs must
    /// be pairs of this mesh, each with one or two constraints, and its sides the mesh's contact sides.
    pub fn discretise_zone(&self, load: Vec<Vec2>, zone: Zone) -> Result<Discrete, Error> {
        self.refuse_non_finite(&load)?;
        self.refuse_bad_gaps(&zone)?;
        self.mesh.check_curved()?;
        let nodes = self.node_supports()?;
        let mut basis = Basis::new(&nodes);
        let mut tied = Vec::with_capacity(zone.pairs.len());
        for (i, pair) in zone.pairs.iter().enumerate() {
            tied.extend(basis.tie(i, pair, [nodes.of(pair.first), nodes.of(pair.second)])?);
        }
        tied.sort_by_key(|(bound, _)| bound.dof);
        let balance = rigid::balance(self.mesh, &nodes, &zone, &load)?;
        let mut qp = BoundQp {
            load: self.net_load(&basis, &load),
            bounds: tied.iter().map(|(bound, _)| *bound).collect(),
            kernel: balance.kernel.iter().map(|y| basis.coordinates(y)).collect(),
            conditions: balance.kernel.iter().map(|y| mean_condition(self.mesh, &basis, y)).collect(),
            ..Default::default()
        };
        drop(balance.kernel);
        // Last, when all temporaries are gone: it is the largest piece.
        qp.matrix = assembly::stiffness(self.mesh, &self.materials, &basis);
        qp::remove_imbalance(&mut qp);
        let warnings = zone.warnings.iter().cloned().chain(balance.remarks).collect();
        Ok(Discrete { basis, zone, qp, origins: tied.into_iter().map(|(_, o)| o).collect(), load, warnings })
    }

    /// `Tᵀ(f − A u_D)`.
    fn net_load(&self, basis: &Basis, load: &[Vec2]) -> Vec<f64> {
        let Some(offsets) = basis.offsets() else { return basis.force(load) };
        let mut net = assembly::internal_forces(self.mesh, &self.materials, &offsets);
        net.iter_mut().zip(load).for_each(|(r, f)| *r = f - *r);
        basis.force(&net)
    }

    /// Assembles and solves.
    pub fn solve(&self, settings: &solver::Settings) -> Result<(Discrete, Solution), Error> {
        let discrete = self.discretise()?;
        let raw = solver::solve(&discrete.qp, settings);
        let solution = discrete.recover(self.mesh, &self.materials, raw);
        Ok((discrete, solution))
    }

    fn refuse_non_finite(&self, load: &[Vec2]) -> Result<(), Error> {
        match load.iter().position(|f| !(f.x.is_finite() && f.y.is_finite())) {
            None => Ok(()),
            Some(i) => Err(Error::Load(format!(
                "the nodal load at ({}, {}) is ({}, {}), which is no number; check the loads around that point",
                self.mesh.points[i].x, self.mesh.points[i].y, load[i].x, load[i].y
            ))),
        }
    }

    fn refuse_bad_gaps(&self, zone: &Zone) -> Result<(), Error> {
        let gap_of = |pair: &ContactPair| pair.constraints.iter().map(|c| c.gap).find(|g| !g.is_finite());
        match zone.pairs.iter().find_map(|p| Some((p.first, gap_of(p)?))) {
            None => Ok(()),
            Some((node, gap)) => Err(Error::Load(format!(
                "the initial gap at ({}, {}) is {gap}, which is no length; check its expression there",
                self.mesh.points[node as usize].x, self.mesh.points[node as usize].y
            ))),
        }
    }

    /// Differences of prescribed displacements below this are rounding: of the data, or of the coordinates they are computed
    /// from.
    fn rounding_of_data(&self) -> f64 {
        let mut largest = 0.0_f64;
        self.each_side_end(Support::Fixed, |node, _, part| {
            largest = largest.max(self.data.displacement(part, self.mesh.points[node as usize]).norm());
        });
        let extent = self.mesh.points.iter().map(|x| x.norm()).fold(0.0, f64::max);
        1e-10 * largest + 1e-14 * extent
    }

    /// What each node may do, from the parts that its sides belong to.
    ///
    /// # Errors
    /// [`Error::Boundary`] where parts that meet contradict one another, [`Error::Load`] for data that are no number.
    pub fn node_supports(&self) -> Result<NodeSupports, Error> {
        let mut nodes = NodeSupports::new(self.mesh.points.len());
        self.each_side_end(Support::Sliding, |node, normal, _| slide(nodes.of_mut(node), normal));
        let mut fixed = BTreeSet::new();
        let mut clash = None;
        let rounding = self.rounding_of_data();
        self.each_side_end(Support::Fixed, |node, _, part| {
            let offset = self.data.displacement(part, self.mesh.points[node as usize]);
            let support = nodes.of_mut(node);
            if !fixed.insert(node) && (offset - support.offset).norm() > rounding {
                clash.get_or_insert((node, offset, support.offset));
            }
            *support = NodeSupport { free: Vec::new(), offset };
        });
        if let Some((node, a, b)) = clash {
            let x = self.mesh.points[node as usize];
            return Err(Error::Boundary(format!(
                "node {node} at ({}, {}) is prescribed ({}, {}) by one fixed part and ({}, {}) by another; make the data agree there",
                x.x, x.y, a.x, a.y, b.x, b.y
            )));
        }
        let bad = nodes.held().find(|(_, s)| !(s.offset.x.is_finite() && s.offset.y.is_finite()));
        if let Some((node, support)) = bad {
            let x = self.mesh.points[node as usize];
            return Err(Error::Load(format!(
                "the prescribed displacement at ({}, {}) is ({}, {}), which is no number; check its expression there",
                x.x, x.y, support.offset.x, support.offset.y
            )));
        }
        Ok(nodes)
    }

    /// Visits both ends of every side whose part has this support: node, outward normal, part.
    fn each_side_end(&self, support: Support, mut visit: impl FnMut(u32, Vec2, usize)) {
        for side in self.mesh.sides.iter().filter(|s| self.supports[s.part as usize] == support) {
            let piece = self.mesh.boundary_view(side).piece;
            for (node, t) in side.nodes.into_iter().zip([0.0, 1.0]) {
                visit(node, piece.normal(t), side.part as usize);
            }
        }
    }
}

/// Takes the normal direction away from a node; a second, independent normal takes the rest.
fn slide(node: &mut NodeSupport, normal: Vec2) {
    let keeps = |t: &Vec2| t.dot(&normal).abs() < crate::zone::SAME_NORMAL;
    node.free = match node.free.as_slice() {
        [_, _] => vec![tangent_of(normal)],
        [t] if keeps(t) => vec![*t],
        _ => Vec::new(),
    };
}

/// `p(v) = Σ_i m_i y_i·v_i` with the lumped mass `m`: the component of `v` along the free motion `y` vanishes in the mean.
fn mean_condition(mesh: &Mesh, basis: &Basis, y: &[Vec2]) -> Vec<(u32, f64)> {
    let mut weighted = vec![Vec2::zeros(); mesh.points.len()];
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.corners(t);
        let third = cross(b - a, c - a) / 6.0;
        mesh.triangles[t].iter().for_each(|&i| weighted[i as usize] += third * y[i as usize]);
    }
    let row = basis.force(&weighted);
    row.iter().enumerate().filter(|(_, p)| **p != 0.0).map(|(i, p)| (i as u32, *p)).collect()
}

impl Discrete {
    /// Displacement components that are not fixed.
    pub fn dofs(&self) -> usize {
        self.basis.fixed.iter().filter(|f| !**f).count()
    }

    /// The multiplier of each bilateral constraint, of either sign: what the equation of its component lacks,
    /// `λ_c = (Tᵀ(f − A u_h))_c`.
    pub fn held_forces(
        &self,
        mesh: &Mesh,
        materials: &[Material; 2],
        displacement: &[Vec2],
    ) -> Vec<(BoundOrigin, f64)> {
        if self.basis.held.is_empty() {
            return Vec::new();
        }
        let internal = assembly::internal_forces(mesh, materials, displacement);
        let rest: Vec<Vec2> = self.load.iter().zip(&internal).map(|(f, r)| f - r).collect();
        let rest = self.basis.full_force(&rest);
        self.basis.held.iter().map(|h| (h.origin, rest[h.dof as usize])).collect()
    }

    /// Turns the answer of the quadratic problem into displacements, contact forces and energies.
    pub fn recover(&self, mesh: &Mesh, materials: &[Material; 2], raw: QpSolution) -> Solution {
        let displacement = self.basis.displacement(&raw.x);
        let mut contact_forces: Vec<Vec<f64>> =
            self.zone.pairs.iter().map(|p| vec![0.0; p.constraints.len()]).collect();
        for (origin, force) in self.origins.iter().zip(&raw.multipliers) {
            contact_forces[origin.pair][origin.constraint] = *force;
        }
        for (origin, force) in self.held_forces(mesh, materials, &displacement) {
            contact_forces[origin.pair][origin.constraint] = force;
        }
        // L(u_h) = ½A(u_h,u_h) − f(u_h), the quadratic part element by element from strains.
        let strain_energy = norm::of_linear(mesh, materials, &displacement).energy;
        let work: f64 = self.load.iter().zip(&displacement).map(|(f, u)| f.dot(u)).sum();
        Solution { displacement, contact_forces, energy: 0.5 * strain_energy - work, strain_energy, raw }
    }
}
