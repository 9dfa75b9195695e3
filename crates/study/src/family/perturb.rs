//! Irregular meshes: nodes moved and diagonals turned at random, angles guarded.

use super::random::Random;
use signorini_contact::geometry::SharedCurve;
use signorini_contact::mesh::quality::largest_cotangent;
use signorini_contact::mesh::{Mesh, Triangulation};
use signorini_contact::{Point, Vec2};

/// cot 20°, a literal because trigonometry differs between machines in the last bit.
const COT_20: f64 = 2.747_477_419_454_621_6;

/// How often a move is halved before it is given up.
const HALVINGS: usize = 30;

/// The bound on angles that irregular meshes keep: 20°, or half of the regular mesh's smallest angle where that is less.
#[derive(Clone, Copy, Debug)]
pub(super) struct Guard {
    /// The largest cotangent allowed.
    cotangent: f64,
}

impl Guard {
    /// The guard that belongs to the regular triangulations of both bodies.
    pub fn of(bodies: &[Triangulation; 2]) -> Self {
        let cotangents = bodies.iter().flat_map(|b| b.triangles.iter().map(|&t| cotangent(b, t)));
        let worst = cotangents.fold(0.0, f64::max);
        // cot ϑ/2 = cot ϑ + √(1 + cot² ϑ)
        Self { cotangent: COT_20.max(worst + (1.0 + worst * worst).sqrt()) }
    }

    fn allows(self, cotangent: f64) -> bool {
        cotangent <= self.cotangent
    }
}

fn cotangent(mesh: &Triangulation, triangle: [u32; 3]) -> f64 {
    largest_cotangent(triangle.map(|i| mesh.points[i as usize]))
}

/// Turns the diagonals of a structured triangulation, each with equal chances, where the guard allows it.
pub(super) fn turn_diagonals(mesh: &mut Triangulation, guard: Guard, random: &mut Random) {
    // Triangles come in pairs (a, b, c), (a, c, d), one pair for each cell.
    for cell in 0..mesh.triangles.len() / 2 {
        let ([a, b, c], [_, _, d]) = (mesh.triangles[2 * cell], mesh.triangles[2 * cell + 1]);
        let turned = [[a, b, d], [b, c, d]];
        let allowed = turned.iter().all(|&t| guard.allows(cotangent(mesh, t)));
        if random.coin() && allowed {
            mesh.triangles[2 * cell..2 * cell + 2].copy_from_slice(&turned);
        }
    }
}

/// Moves each node by at most `amount` times the shortest side at it: inner nodes in any direction, boundary and contact nodes
/// along their straight line or curve, both nodes of a contact pair together (across a gap, by the same `η`). Nodes at the
/// `fixed` points on the boundary stay: every corner of a body must be among them, and every end of a part.
///
/// Nodes move one after the other; a move that the guard forbids is halved until it is allowed.
pub(super) fn perturb(mesh: &mut Mesh, fixed: &[Point], amount: f64, guard: Guard, random: &mut Random) {
    let freedoms = freedoms(mesh, fixed);
    let around = Around::new(mesh);
    let partners = partners(mesh);
    let sizes = shortest_sides(mesh);
    for node in 0..mesh.points.len() {
        let [x, y] = random.in_disc();
        let partner = partners[node].map_or(node, |p| p as usize);
        // The second of a pair moved together with the first.
        if partner < node || freedoms[partner] == Freedom::None {
            continue;
        }
        let size = amount * sizes[node].min(sizes[partner]);
        let moves = match freedoms[node] {
            Freedom::Inner => Moves::Straight(size * Vec2::new(x, y)),
            Freedom::Along(direction) => Moves::Straight(size * x * direction),
            Freedom::On(curve) => {
                let [a, b] = [node, partner].map(|i| curve_of(&freedoms[i], curve));
                Moves::curved(mesh, [node, partner], [a, b], size * x)
            }
            Freedom::None => continue,
        };
        move_guarded(mesh, &around, [node, partner], &moves, guard);
    }
    follow_curves(mesh);
}

fn curve_of(freedom: &Freedom, otherwise: usize) -> usize {
    if let Freedom::On(curve) = freedom { *curve } else { otherwise }
}

/// How a node and its partner move.
enum Moves {
    /// Both by the same vector.
    Straight(Vec2),
    /// Each on a curve: the curve, where it starts and by how much its parameter changes.
    Curved([(SharedCurve, f64, f64); 2]),
}

impl Moves {
    /// By about `length` along the curves. Partners keep the same place or, across a gap, the same `η`, of which the
    /// parameters are affine functions over the same interval.
    fn curved(mesh: &Mesh, nodes: [usize; 2], curves: [usize; 2], length: f64) -> Self {
        let curves = curves.map(|k| mesh.curved.curves[k].clone());
        let start = [0, 1].map(|k| curves[k].foot(mesh.points[nodes[k]]));
        let direction = [0, 1].map(|k| curves[k].derivatives(start[k])[0]);
        let step = length / direction[0].norm();
        let opposite = if direction[0].dot(&direction[1]) < 0.0 { -step } else { step };
        let [first, second] = curves;
        Self::Curved([(first, start[0], step), (second, start[1], opposite)])
    }

    /// The places after a share of the move.
    fn places(&self, start: [Point; 2], share: f64) -> [Point; 2] {
        match self {
            Self::Straight(shift) => start.map(|x| x + share * shift),
            Self::Curved(both) => both.each_ref().map(|(c, s, step)| c.point((s + share * step).clamp(0.0, 1.0))),
        }
    }
}

fn move_guarded(mesh: &mut Mesh, around: &Around, nodes: [usize; 2], moves: &Moves, guard: Guard) {
    let start = nodes.map(|i| mesh.points[i]);
    let mut share = 1.0;
    for _ in 0..HALVINGS {
        set(mesh, nodes, moves.places(start, share));
        if nodes.iter().all(|&i| guard.allows(around.worst(mesh, i))) {
            return;
        }
        share *= 0.5;
    }
    set(mesh, nodes, start);
}

fn set(mesh: &mut Mesh, nodes: [usize; 2], places: [Point; 2]) {
    // a node that is its own partner, or partners that touch, have one place
    mesh.points[nodes[1]] = places[1];
    mesh.points[nodes[0]] = places[0];
    if mesh.direction.is_none() {
        mesh.points[nodes[1]] = places[0];
    }
}

/// Curved sides end where their nodes went.
fn follow_curves(mesh: &mut Mesh) {
    for k in 0..mesh.curved.sides.len() {
        let side = mesh.curved.sides[k];
        let curve = &mesh.curved.curves[usize::from(side.curve)];
        let corner =
            |i: u8| mesh.points[mesh.triangles[side.triangle as usize][usize::from((side.apex + i) % 3)] as usize];
        mesh.curved.sides[k].span = [curve.foot(corner(1)), curve.foot(corner(2))];
    }
}

/// The triangles at each node.
struct Around {
    start: Vec<usize>,
    triangles: Vec<u32>,
}

impl Around {
    fn new(mesh: &Mesh) -> Self {
        let mut start = vec![0; mesh.points.len() + 1];
        for &i in mesh.triangles.iter().flatten() {
            start[i as usize + 1] += 1;
        }
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        let mut next = start.clone();
        let mut triangles = vec![0; 3 * mesh.triangles.len()];
        for (t, triangle) in mesh.triangles.iter().enumerate() {
            for &i in triangle {
                triangles[next[i as usize]] = t as u32;
                next[i as usize] += 1;
            }
        }
        Self { start, triangles }
    }

    /// The largest cotangent in the triangles at a node.
    fn worst(&self, mesh: &Mesh, node: usize) -> f64 {
        let own = &self.triangles[self.start[node]..self.start[node + 1]];
        let cotangents = own.iter().map(|&t| largest_cotangent(mesh.corners(t as usize)));
        cotangents.fold(0.0, f64::max)
    }
}

/// Where a node may go.
#[derive(Clone, Copy, PartialEq)]
enum Freedom {
    Inner,
    /// Along this unit vector.
    Along(Vec2),
    /// On the curve of this number.
    On(usize),
    None,
}

/// Inner nodes are free; a boundary node that is not fixed lies between two sides of one straight line or curve, since corners
/// are fixed, and is free along it.
fn freedoms(mesh: &Mesh, fixed: &[Point]) -> Vec<Freedom> {
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); mesh.points.len()];
    let contact = mesh.contact.iter().flat_map(|c| [c.first, c.second]);
    for [a, b] in mesh.sides.iter().map(|s| s.nodes).chain(contact) {
        neighbours[a as usize].push(b);
        neighbours[b as usize].push(a);
    }
    let tolerance = 1e-10 * extent(mesh);
    let curves = curves_at(mesh);
    let freedom = |(i, beside): (usize, &Vec<u32>)| {
        let at = mesh.points[i];
        let stays = || fixed.iter().any(|f| (f - at).norm() <= tolerance);
        match beside[..] {
            [] => Freedom::Inner,
            [_, _] if curves[i].is_some() && !stays() => curves[i].map_or(Freedom::None, Freedom::On),
            [a, b] if !stays() => Freedom::Along((mesh.points[b as usize] - mesh.points[a as usize]).normalize()),
            _ => Freedom::None,
        }
    };
    neighbours.iter().enumerate().map(freedom).collect()
}

/// The curve at each node.
fn curves_at(mesh: &Mesh) -> Vec<Option<usize>> {
    let mut curves = vec![None; mesh.points.len()];
    for side in &mesh.curved.sides {
        for i in [1, 2] {
            let node = mesh.triangles[side.triangle as usize][usize::from((side.apex + i) % 3)];
            curves[node as usize] = Some(usize::from(side.curve));
        }
    }
    curves
}

/// The other node of each contact pair.
fn partners(mesh: &Mesh) -> Vec<Option<u32>> {
    let mut partners = vec![None; mesh.points.len()];
    for side in &mesh.contact {
        for (&f, &s) in side.first.iter().zip(&side.second) {
            partners[f as usize] = Some(s);
            partners[s as usize] = Some(f);
        }
    }
    partners
}

/// The length of the shortest side at each node.
fn shortest_sides(mesh: &Mesh) -> Vec<f64> {
    let mut shortest = vec![f64::INFINITY; mesh.points.len()];
    for &[a, b, c] in &mesh.triangles {
        for [i, j] in [[a, b], [b, c], [c, a]].map(|s| s.map(|i| i as usize)) {
            let length = (mesh.points[j] - mesh.points[i]).norm();
            shortest[i] = shortest[i].min(length);
            shortest[j] = shortest[j].min(length);
        }
    }
    shortest
}

fn extent(mesh: &Mesh) -> f64 {
    let from = mesh.points[0];
    mesh.points.iter().map(|p| (p - from).norm()).fold(0.0, f64::max)
}
