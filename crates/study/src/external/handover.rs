//! A level as files.

use super::answer::{DISPLACEMENT, UNKNOWNS};
use super::matrix_market::{write_basis, write_columns, write_symmetric};
use super::problem::{Body, Constraint, Pair, Part, Problem, SCHEMA, Support};
use crate::msh;
use crate::record::to_json;
use crate::store::{StoreError, write_atomic};
use signorini_contact::basis::NodeSupports;
use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::Discrete;
use signorini_contact::problem::Support as Condition;
use signorini_contact::zone::{ConstraintKind, ContactPair};
use signorini_contact::{Body as Which, Vec2};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Everything that another program needs to solve a level.
pub struct Handover<'a> {
    /// Level, 0 the coarsest.
    pub level: usize,
    /// Its cells.
    pub cells: usize,
    /// Its mesh.
    pub mesh: &'a Mesh,
    /// Materials of the two bodies.
    pub materials: &'a [Material; 2],
    /// The condition on each part of the mesh.
    pub conditions: &'a [Condition],
    /// What each node may do.
    pub supports: &'a NodeSupports,
    /// The discrete problem.
    pub discrete: &'a Discrete,
}

/// Names of the bodies in the files.
const BODIES: [&str; 2] = ["first", "second"];

impl Handover<'_> {
    /// Writes all files into a folder, in place of those of an earlier run.
    pub(super) fn write(&self, folder: &Path) -> Result<(), StoreError> {
        let refused = |source: io::Error| StoreError::Io { path: folder.to_path_buf(), source };
        fs::create_dir_all(folder).map_err(refused)?;
        for old in [DISPLACEMENT, UNKNOWNS] {
            crate::store::remove_if_present(&folder.join(old))?;
        }
        write_atomic(&folder.join("mesh.msh"), msh::write(self.mesh, BODIES))?;
        let path = folder.join("problem.json");
        let text = to_json(&self.problem()).map_err(|source| StoreError::Content { path: path.clone(), source })?;
        write_atomic(&path, text)?;
        self.write_matrices(folder).map_err(refused)
    }

    /// Read by nobody before the command runs, so written in place.
    fn write_matrices(&self, folder: &Path) -> io::Result<()> {
        let Discrete { basis, qp, .. } = self.discrete;
        let file = |name: &str, write: &dyn Fn(&mut BufWriter<File>) -> io::Result<()>| {
            let mut to = BufWriter::new(File::create(folder.join(name))?);
            write(&mut to)?;
            to.flush()
        };
        file("K.mtx", &|to| write_symmetric(&qp.matrix, to))?;
        file("f.mtx", &|to| write_columns(&[&qp.load], to))?;
        file("upper.mtx", &|to| write_columns(&[self.upper()], to))?;
        file("T.mtx", &|to| write_basis(basis, to))?;
        let offset: Vec<f64> = (0..basis.nodes()).flat_map(|i| [basis.offset(i).x, basis.offset(i).y]).collect();
        file("u_D.mtx", &|to| write_columns(&[&offset], to))?;
        if qp.kernel.is_empty() {
            return match fs::remove_file(folder.join("N.mtx")) {
                Err(e) if e.kind() != io::ErrorKind::NotFound => Err(e),
                _ => Ok(()),
            };
        }
        file("N.mtx", &|to| write_columns(&qp.kernel, to))
    }

    fn upper(&self) -> Vec<f64> {
        let mut upper = vec![f64::INFINITY; self.discrete.qp.matrix.dimension()];
        self.discrete.qp.bounds.iter().for_each(|b| upper[b.dof as usize] = b.upper);
        upper
    }

    fn problem(&self) -> Problem {
        let part = |(k, p): (usize, &signorini_contact::mesh::PartName)| Part {
            name: p.name.clone(),
            body: BODIES[p.body.index()].into(),
            curve: k + 3,
            condition: name_of(self.conditions[k]).into(),
        };
        Problem {
            schema: SCHEMA,
            level: self.level,
            cells: self.cells,
            bodies: Which::BOTH.map(|which| self.body(which)),
            boundary: self.mesh.parts.iter().enumerate().map(part).collect(),
            curved: !self.mesh.curved.sides.is_empty(),
            supports: self.supports(),
            nodal_load: self.discrete.load.iter().map(components).collect(),
            pairs: self.discrete.zone.pairs.iter().map(pair).collect(),
            dofs: self.discrete.dofs(),
            free_motions: self.discrete.qp.kernel.len(),
        }
    }

    fn body(&self, which: Which) -> Body {
        let material = &self.materials[which.index()];
        let lame = material.lame_constants();
        Body {
            name: BODIES[which.index()].into(),
            surface: which.index() + 1,
            contact_curve: which.index() + 1,
            hooke: *material.matrix(),
            lambda: lame.map(|l| l.lambda),
            mu: lame.map(|l| l.mu),
        }
    }

    fn supports(&self) -> Vec<Support> {
        let held = self.supports.held().filter(|(_, s)| s.free.len() < 2);
        let support = |(node, s): (u32, &signorini_contact::basis::NodeSupport)| Support {
            node: node as usize + 1,
            free: s.free.iter().map(components).collect(),
            displacement: components(&s.offset),
        };
        held.map(support).collect()
    }
}

fn components(v: &Vec2) -> [f64; 2] {
    [v.x, v.y]
}

fn name_of(condition: Condition) -> &'static str {
    match condition {
        Condition::Fixed => "fixed",
        Condition::Sliding => "sliding",
        Condition::Traction => "traction",
        Condition::Free => "free",
    }
}

fn pair(pair: &ContactPair) -> Pair {
    let constraint = |c: &signorini_contact::zone::Constraint| Constraint {
        normal: components(&c.normal),
        gap: c.gap,
        mass: c.mass,
        bilateral: c.kind == ConstraintKind::Bilateral,
    };
    Pair {
        first: pair.first as usize + 1,
        second: pair.second as usize + 1,
        constraints: pair.constraints.iter().map(constraint).collect(),
    }
}
