//! Fields as VTK's unstructured grids, which ParaView reads.
//!
//! The bodies are one grid: linear triangles, and quadratic ones where a side is curved, with three more points each (the middles of
//! the sides, on the curve where there is one), which follow the nodes. The contact zone is another grid, of line segments
//! between the nodes of `Ω'`. Numbers are stored as base64, bit for bit. Vectors have a third component, zero, as VTK wants them.

use super::arrays::Array;
use super::npy::bodies as body_numbers;
use super::packed::base64;
use super::{Arc, Fields};

/// VTK's numbers of its cell types.
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;
const QUADRATIC_TRIANGLE: u8 = 22;

/// Both bodies: `displacement` at the points; `body` (1 or 2), `area`, `strain` and `stress` (`11, 22, 12`) and `von_mises` on the cells.
pub fn bodies(f: &Fields) -> String {
    let mut grid = Grid::new(f);
    for t in 0..f.triangles.len() {
        grid.triangle(f, t);
    }
    let points = [Array::new("displacement", &grid.displacement)];
    let cells = [
        Array::new("body", &body_numbers(f)),
        Array::new("area", &f.areas),
        Array::new("strain", &f.strain),
        Array::new("stress", &f.stress),
        Array::new("von_mises", &f.von_mises),
    ];
    grid.text(&points, &cells)
}

/// The contact zone: `s`, `pressure`, `gap`, `normal`, `status` (0 open, 1 in contact, 2 tied, 3 held by supports) and the
/// displacements of both bodies at its points.
pub fn zone(f: &Fields) -> String {
    let zone = &f.zone;
    let of = |list: &[[f64; 2]], body: usize| -> Vec<[f64; 3]> {
        zone.nodes.iter().map(|n| in_space(list[n[body] as usize])).collect()
    };
    let mut grid = Grid { points: of(&f.nodes, 0), ..Default::default() };
    zone.sides.iter().for_each(|side| grid.cell(LINE, side));
    let normal: Vec<[f64; 3]> = zone.normal.iter().map(|n| in_space(*n)).collect();
    let points = [
        Array::new("s", &zone.s),
        Array::new("pressure", &zone.pressure),
        Array::new("gap", &zone.gap),
        Array::new("status", &zone.status),
        Array::new("normal", &normal),
        Array::new("displacement", &of(&f.displacement, 0)),
        Array::new("displacement_second", &of(&f.displacement, 1)),
    ];
    grid.text(&points, &[])
}

fn in_space([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Points and cells, as they are collected.
#[derive(Default)]
struct Grid {
    points: Vec<[f64; 3]>,
    displacement: Vec<[f64; 3]>,
    connectivity: Vec<i64>,
    offsets: Vec<i64>,
    types: Vec<u8>,
}

impl Grid {
    /// The nodes, and no cell.
    fn new(f: &Fields) -> Self {
        let all = |list: &[[f64; 2]]| list.iter().map(|x| in_space(*x)).collect();
        Self { points: all(&f.nodes), displacement: all(&f.displacement), ..Default::default() }
    }

    fn cell(&mut self, kind: u8, points: &[u32]) {
        self.connectivity.extend(points.iter().map(|i| i64::from(*i)));
        self.offsets.push(self.connectivity.len() as i64);
        self.types.push(kind);
    }

    fn triangle(&mut self, f: &Fields, t: usize) {
        let corners = f.triangles[t];
        let Some(arc) = f.arc(t) else { return self.cell(TRIANGLE, &corners) };
        let middles = [0, 1, 2].map(|k| self.middle(f, corners, k, arc));
        self.cell(QUADRATIC_TRIANGLE, &[corners, middles].concat());
    }

    /// The middle of the side from corner `k` to the next, as a point of its own.
    fn middle(&mut self, f: &Fields, corners: [u32; 3], k: usize, arc: &Arc) -> u32 {
        let [a, b] = [k, (k + 1) % 3].map(|i| corners[i] as usize);
        let half = |list: &[[f64; 2]]| in_space([0, 1].map(|i| 0.5 * (list[a][i] + list[b][i])));
        let on_arc = (usize::from(arc.apex) + 1) % 3 == k;
        let centre = arc.points.len() / 2;
        let (x, u) = if on_arc {
            (in_space(arc.points[centre]), in_space(arc.displacement[centre]))
        } else {
            (half(&f.nodes), half(&f.displacement))
        };
        self.points.push(x);
        self.displacement.push(u);
        self.points.len() as u32 - 1
    }

    fn text(&self, points: &[Array], cells: &[Array]) -> String {
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
            self.points.len(),
            self.types.len()
        );
        let shape = [
            Array::new("connectivity", &self.connectivity),
            Array::new("offsets", &self.offsets),
            Array::new("types", &self.types),
        ];
        section(&mut text, "Points", &[Array::new("Points", &self.points)]);
        section(&mut text, "Cells", &shape);
        section(&mut text, "PointData", points);
        section(&mut text, "CellData", cells);
        text.push_str("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        text
    }
}

fn section(text: &mut String, name: &str, arrays: &[Array]) {
    text.push_str(&format!("<{name}>\n"));
    arrays.iter().for_each(|a| data_array(text, a));
    text.push_str(&format!("</{name}>\n"));
}

/// The number of bytes, then the bytes, together as base64.
fn data_array(text: &mut String, array: &Array) {
    let mut bytes = (array.bytes.len() as u64).to_le_bytes().to_vec();
    bytes.extend(&array.bytes);
    // readers give an array that announces one component a second axis
    let components = match array.components {
        1 => String::new(),
        several => format!(" NumberOfComponents=\"{several}\""),
    };
    let (kind, name, text_of) = (array.vtk, array.name, base64(&bytes));
    text.push_str(&format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\"{components} format=\"binary\">\n{text_of}\n</DataArray>\n"
    ));
}
