//! A triangulation of a domain bounded by an ellipse, with the arcs of its curved triangles.

use super::ellipse::Ellipse;
use signorini_contact::Point;
use signorini_contact::mesh::fnv1a;
use signorini_contact::mesh::quality::largest_cotangent;

/// A triangulation. Triangles on the curve have the arc between their two nodes there as a side.
#[derive(Clone, Debug)]
pub struct DomainMesh {
    /// The nodes.
    pub points: Vec<Point>,
    /// Corners, counterclockwise.
    pub triangles: Vec<[u32; 3]>,
    /// The sides on the curve, counterclockwise around it.
    pub boundary: Vec<BoundarySide>,
    /// The curve.
    pub ellipse: Ellipse,
}

/// Size and regularity, measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// The largest distance of two points of a triangle.
    pub h: f64,
    /// The smallest angle of triangles with straight sides, in degrees; 0 of intervals, which have none.
    pub min_angle: f64,
    /// The longest over the shortest side or chord, `β`.
    pub side_ratio: f64,
}

/// The curved side of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundarySide {
    /// Its ends.
    pub nodes: [u32; 2],
    /// Their angles on the ellipse; the second is the larger.
    pub angles: [f64; 2],
    /// The triangle that it belongs to.
    pub triangle: u32,
}

impl DomainMesh {
    /// Red refinement: every triangle into four at the middles of its sides, where the middle of an arc is the point that
    /// `middle_of_arc` gives for its two angles.
    pub fn refined(&self, middle_of_arc: impl Fn([f64; 2]) -> Point) -> Self {
        let sides = self.sides();
        let mut points = self.points.clone();
        points.extend(sides.iter().map(|s| 0.5 * (self.points[s[0] as usize] + self.points[s[1] as usize])));
        let middle = |a: u32, b: u32| {
            let place = sides.binary_search(&[a.min(b), a.max(b)]).expect("every side of a triangle is listed");
            (self.points.len() + place) as u32
        };
        let mut triangles = Vec::with_capacity(4 * self.triangles.len());
        for &[a, b, c] in &self.triangles {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]);
        }
        let mut boundary = Vec::with_capacity(2 * self.boundary.len());
        for side in &self.boundary {
            let ([a, b], [from, to]) = (side.nodes, side.angles);
            let (node, angle) = (middle(a, b), self.ellipse.divide(side.angles, 0.5));
            points[node as usize] = middle_of_arc(side.angles);
            let child = |end: u32| self.child(side.triangle, end);
            boundary.push(BoundarySide { nodes: [a, node], angles: [from, angle], triangle: child(a) });
            boundary.push(BoundarySide { nodes: [node, b], angles: [angle, to], triangle: child(b) });
        }
        Self { points, triangles, boundary, ellipse: self.ellipse }
    }

    /// The number, after refinement, of the child of a triangle at one of its corners.
    fn child(&self, triangle: u32, corner: u32) -> u32 {
        let place = self.triangles[triangle as usize].iter().position(|&n| n == corner);
        4 * triangle + place.expect("a side's end is a corner of its triangle") as u32
    }

    /// Every side once, in order of its nodes.
    fn sides(&self) -> Vec<[u32; 2]> {
        let of_triangle = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
        let mut sides: Vec<[u32; 2]> = self.triangles.iter().flat_map(of_triangle).collect();
        sides.sort_unstable();
        sides.dedup();
        sides
    }

    /// The corners of a triangle.
    pub fn corners(&self, triangle: u32) -> [Point; 3] {
        self.triangles[triangle as usize].map(|i| self.points[i as usize])
    }

    /// Mesh size and regularity, measured on straight sides and chords; `h` also counts the distance of the middle of an arc
    /// from the opposite corner.
    pub fn quality(&self) -> Quality {
        let (mut longest, mut shortest, mut cotangent) = (0.0_f64, f64::INFINITY, 0.0_f64);
        for t in 0..self.triangles.len() as u32 {
            let c = self.corners(t);
            for k in 0..3 {
                let side = (c[(k + 1) % 3] - c[k]).norm();
                longest = longest.max(side);
                shortest = shortest.min(side);
            }
            cotangent = cotangent.max(largest_cotangent(c));
        }
        let far = |s: &BoundarySide| {
            let middle = self.ellipse.at(0.5 * (s.angles[0] + s.angles[1]));
            self.corners(s.triangle).iter().map(|c| (c - middle).norm()).fold(0.0, f64::max)
        };
        Quality {
            h: self.boundary.iter().map(far).fold(longest, f64::max),
            min_angle: f64::atan2(1.0, cotangent).to_degrees(),
            side_ratio: longest / shortest,
        }
    }

    /// 16 hexadecimal digits of the FNV-1a hash of nodes and triangles.
    pub fn hash(&self) -> String {
        let points = self.points.iter().flat_map(|p| [p.x, p.y]).flat_map(f64::to_le_bytes);
        let triangles = self.triangles.iter().flatten().flat_map(|i| i.to_le_bytes());
        format!("{:016x}", fnv1a(&points.chain(triangles).collect::<Vec<u8>>()))
    }
}
