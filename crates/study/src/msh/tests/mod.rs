//! Files of Gmsh: both forms, malformed ones, the way there and back, bodies and zones out of them.

use super::Msh;
use crate::family::build_level;
use crate::sample;
use crate::study::Case;
use signorini_contact::mesh::Mesh;

mod encode;
mod malformed;
mod mangled;
mod matched;
mod round_trip;
mod twins;

const DOVETAIL: &[u8] = include_bytes!("../../../../../studies/meshes/dovetail.msh");
const PIN: &[u8] = include_bytes!("../../../../../studies/meshes/pin.msh");

fn dovetail() -> Msh {
    Msh::read(DOVETAIL).unwrap()
}

/// The coarsest mesh of a case with `n` cells per unit.
fn meshed(case: &Case, n: usize) -> Mesh {
    let domain = case.scene().unwrap().domain();
    build_level(&case.family, &domain, &[n], 0).unwrap_or_else(|e| panic!("{e}")).hierarchy.finest().clone()
}

/// Two squares of `n × n` cells as a file, bodies `upper` and `lower`.
fn squares(n: usize) -> String {
    super::write(&meshed(&sample::case("two-squares", "two-squares"), n), ["upper", "lower"])
}
