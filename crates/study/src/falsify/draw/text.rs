//! The draw as a study file.

use super::traces::{Place as Along, TraceLines};
use super::{Draw, Faces, Law, Mesh, Place, Pushed, Solution};
use std::fmt::Write;

const FREE: &str = "traction";

impl Draw {
    /// The study, called `id`; `remarks` stand above it as comments.
    pub fn text(&self, id: &str, remarks: &[String]) -> String {
        let mut out: String = remarks.iter().map(|r| format!("# {r}\n")).collect();
        out += &head(self, id);
        match &self.place {
            Place::Line { width, heights, split } => line(&mut out, self, *width, *heights, *split),
            Place::Arc => arc(&mut out, self),
            Place::Graph(faces) => graph(&mut out, self, faces),
            Place::Polyline(pushed) => polyline(&mut out, self, pushed),
        }
        out + &family(self.mesh) + &levels(&self.levels)
    }
}

fn head(draw: &Draw, id: &str) -> String {
    let about = draw.target.about();
    let claim = match about.claim {
        Some(claim) => format!("claim = \"{claim}\"\n"),
        None => String::new(),
    };
    let parameters = match &draw.solution {
        Solution::BuiltIn(_, values) => values.iter().map(|(name, x)| format!("{name} = {x}\n")).collect(),
        _ => String::new(),
    };
    let own = match about.claim {
        Some(_) => String::new(),
        None => "\n[own_claim]\nstatement = \"½A(e,e) ≤ a + b + c\"\nkind = \"inequality\"\nnorm = \"ledger\"\n\
                 hypotheses = [\"K and K_h closed and convex\"]\nsources = [\"Remark 1.3\"]\n"
            .into(),
    };
    let shape = match &draw.place {
        Place::Graph(Faces::Shape(shape)) => format!("gap = {shape}\n"),
        _ => String::new(),
    };
    format!(
        "id = \"{id}\"\ntitle = \"A scene drawn at random for {}\"\n{claim}\
         question = \"Does the claim hold on a scene that nobody chose?\"\n\
         setup = \"{}.\"\nrefuted_by = \"A rate below the bound, or an inequality of the proof that is broken.\"\n{own}\
         \n[gates]\n{}reason = \"the theorem bounds no constant: how large it gets is what the search reports\"\n\
         \n[parameters]\n{parameters}{shape}",
        about.id,
        draw.words(),
        gates(draw),
    )
}

/// No ceiling; of `b/h²` half the bound that its proof gives, which the default spread doubles.
fn gates(draw: &Draw) -> String {
    let (Solution::Traces(traces), super::Target::ManySwitches, Place::Line { width, .. }) =
        (&draw.solution, draw.target, &draw.place)
    else {
        return "ceiling = \"none\"\n".into();
    };
    let [stress, slope] = traces.bounds(draw.unit(), *width);
    // b ≤ N h² ‖T_n‖_∞ |[u]_n|_{1,∞}
    let bound = 0.5 * traces.switches.len() as f64 * stress * slope;
    format!("ceiling = \"none\"\nconstant = {bound}\n")
}

fn family(mesh: Mesh) -> String {
    let fields = match mesh {
        Mesh::Structured => "name = \"structured\"".into(),
        Mesh::CrissCross => "name = \"criss-cross\"".into(),
        Mesh::UnionJack => "name = \"union-jack\"".into(),
        Mesh::Perturbed(seed, amount) => format!("name = \"perturbed\"\nseed = {seed}\namount = {amount}"),
        Mesh::Refined(seed, amount) => format!("name = \"refined\"\nseed = {seed}\namount = {amount}"),
        Mesh::RefinedDelaunay(seed) => format!("name = \"refined\"\ncoarse = \"delaunay\"\nseed = {seed}"),
        Mesh::Delaunay(seed) => format!("name = \"delaunay\"\nseed = {seed}"),
    };
    format!("\n[family]\n{fields}\n")
}

fn levels(cells: &[usize]) -> String {
    format!("\n[levels]\nquick = {cells:?}\nfull = {cells:?}\n")
}

fn material(law: &Law) -> String {
    format!("material = {{ young = {}, poisson = {} }}\n", law.young, law.poisson)
}

fn body(out: &mut String, name: &str, law: &Law, shape: &str) {
    let _ = write!(out, "\n[[body]]\nname = \"{name}\"\n{}{shape}", material(law));
}

fn boundary(out: &mut String, body: &str, name: &str, along: &str, condition: &str) {
    let _ = write!(
        out,
        "\n[[boundary]]\nbody = \"{body}\"\nname = \"{name}\"\nalong = {along}\ncondition = \"{condition}\"\n"
    );
}

fn exact(out: &mut String, draw: &Draw, lemma: &str, along: Option<Along>) {
    match (&draw.solution, along) {
        (Solution::BuiltIn(name, _), _) => {
            let _ = write!(out, "\n[exact]\nbuiltin = \"{name}\"\n");
        }
        (Solution::Traces(traces), Some(along)) => {
            write_traces(out, lemma, &traces.lines(&along));
        }
        _ => {}
    }
}

fn line(out: &mut String, draw: &Draw, width: f64, [up, down]: [f64; 2], split: Option<f64>) {
    // both bodies have the same cells along the zone, nearly square ones
    let columns = (width / up.min(down)).round().max(1.0);
    let shape = |height: f64, low: f64, high: f64| match split {
        None => {
            let rows = (columns * height / width).round().max(1.0);
            format!("rectangle = [[0, {low}], [{width}, {high}]]\ndivisions = [{columns}, {rows}]\n")
        }
        Some(x) => format!(
            "blocks = [\n    {{ corners = [[0, {low}], [{x}, {low}], [{x}, {high}], [0, {high}]], divisions = [1, 2] }},\n    \
             {{ corners = [[{x}, {low}], [{width}, {low}], [{width}, {high}], [{x}, {high}]], divisions = [1, 2] }},\n]\n"
        ),
    };
    body(out, "upper", &draw.laws[0], &shape(up, 0.0, up));
    body(out, "lower", &draw.laws[1], &shape(down, -down, 0.0));
    boundary(out, "upper", "top", &format!("[[0, {up}], [{width}, {up}]]"), "fixed");
    boundary(out, "upper", "left", &format!("[[0, 0], [0, {up}]]"), FREE);
    boundary(out, "upper", "right", &format!("[[{width}, 0], [{width}, {up}]]"), FREE);
    boundary(out, "lower", "bottom", &format!("[[0, -{down}], [{width}, -{down}]]"), "fixed");
    boundary(out, "lower", "left", &format!("[[0, -{down}], [0, 0]]"), FREE);
    boundary(out, "lower", "right", &format!("[[{width}, -{down}], [{width}, 0]]"), FREE);
    let _ = write!(out, "\n[contact]\nalong = [[0, 0], [{width}, 0]]\n");
    let along = Along {
        name: "x",
        from: 0.0,
        to: width,
        // w' − w'' = g
        across: [
            |common, gap, share, _| format!("{common} + {share}*({gap})"),
            |common, gap, _, rest| format!("{common} - {rest}*({gap})"),
        ],
        unit: draw.unit(),
    };
    let lemma = format!("lemma = \"line\"\ncutoff = [\"{up} - y\", \"{down} + y\"]\n");
    exact(out, draw, &lemma, Some(along));
}

const DIAGONAL: &str = "0.7071067811865476";

fn arc(out: &mut String, draw: &Draw) {
    *out += "\n[[curve]]\nname = \"arc\"\ncircle = { centre = [0, 0], radius = 1, from = 0, to = 90 }\n";
    let inside = "blocks = [{ corners = [[0.5, 0], [1, 0], [0, 1], [0, 0.5]], divisions = [1, 2], curves = [\"\", \"arc\", \"\", \"\"] }]\n";
    let outside = format!(
        "blocks = [\n    {{ corners = [[1, 0], [2, 0], [2, 2], [{DIAGONAL}, {DIAGONAL}]], divisions = [2, 1], curves = [\"\", \"\", \"\", \"arc\"] }},\n    \
         {{ corners = [[{DIAGONAL}, {DIAGONAL}], [2, 2], [0, 2], [0, 1]], divisions = [2, 1], curves = [\"\", \"\", \"\", \"arc\"] }},\n]\n"
    );
    body(out, "inside", &draw.laws[0], inside);
    body(out, "outside", &draw.laws[1], &outside);
    boundary(out, "inside", "cut", "[[0.5, 0], [0, 0.5]]", "fixed");
    boundary(out, "inside", "bottom", "[[0.5, 0], [1, 0]]", FREE);
    boundary(out, "inside", "left", "[[0, 1], [0, 0.5]]", FREE);
    boundary(out, "outside", "outer", "[[2, 0], [2, 2], [0, 2]]", "fixed");
    boundary(out, "outside", "bottom", "[[1, 0], [2, 0]]", FREE);
    boundary(out, "outside", "left", "[[0, 2], [0, 1]]", FREE);
    *out += "\n[contact]\nalong = [[1, 0], [0, 1]]\ncurves = [\"arc\"]\n";
    let along = Along {
        name: "theta",
        from: 0.0,
        to: std::f64::consts::FRAC_PI_2,
        // w'' − w' = g
        across: [
            |common, gap, share, _| format!("{common} - {share}*({gap})"),
            |common, gap, _, rest| format!("{common} + {rest}*({gap})"),
        ],
        unit: draw.unit(),
    };
    let lemma = "lemma = \"arc\"\ncentre = [0, 0]\nradius = 1\ncutoff = [\"x + y - 0.5\", \"(2 - x)*(2 - y)\"]\n";
    exact(out, draw, lemma, Some(along));
}

/// `ε`, `f'`, `f''` as expressions of `eta`, and `f'`, `f''` at `∓1`.
fn faces(faces: &Faces) -> ([String; 3], [[f64; 2]; 2]) {
    let text = |words: &str| words.to_owned();
    match faces {
        Faces::Shape(0) => (["", "eta^2/4 + eta^3/20", "-3*eta^2/20"].map(text), [[0.2, 0.3], [-0.15, -0.15]]),
        Faces::Shape(1) => {
            (["", "3/20 - eta^2/10 - eta^3/20", "-3/20 + eta^2/10"].map(text), [[0.1, 0.0], [-0.05, -0.05]])
        }
        Faces::Shape(_) => (
            ["", "1/10 + eta^2/8 + eta^3/10", "-1/10 + eta^2/8 - eta^3/20"].map(text),
            [[0.125, 0.325], [0.075, -0.025]],
        ),
        Faces::Cubic([e0, e2, e3, t1, t2]) => {
            let gap = format!("{e0} + {e2}*eta^2 + {e3}*eta^3");
            let second = format!("{t1}*eta + {t2}*eta^2");
            // decimals with three digits add up to decimals with six
            let exact = |x: f64| (x * 1e6).round() / 1e6;
            let at = [[t2 - t1, t2 + t1], [e0 + e2 - e3, e0 + e2 + e3]];
            let ends = [[0, 1].map(|k| exact(at[0][k] + at[1][k])), at[0].map(exact)];
            ([gap.clone(), format!("{gap} + {second}"), second], ends)
        }
    }
}

fn graph(out: &mut String, draw: &Draw, shape: &Faces) {
    let ([gap, right, left], [[r0, r1], [l0, l1]]) = faces(shape);
    let _ = write!(out, "\n[[curve]]\nname = \"right face\"\ngraph = {{ xi = \"{right}\", from = 1, to = -1 }}\n");
    let _ = write!(out, "\n[[curve]]\nname = \"left face\"\ngraph = {{ xi = \"{left}\", from = -1, to = 1 }}\n");
    let first = format!(
        "blocks = [{{ corners = [[{r0}, -1], [2, -1], [2, 1], [{r1}, 1]], divisions = [2, 2], curves = [\"\", \"\", \"\", \"right face\"] }}]\n"
    );
    let second = format!(
        "blocks = [{{ corners = [[-2, -1], [{l0}, -1], [{l1}, 1], [-2, 1]], divisions = [2, 2], curves = [\"\", \"left face\", \"\", \"\"] }}]\n"
    );
    body(out, "right", &draw.laws[0], &first);
    body(out, "left", &draw.laws[1], &second);
    boundary(out, "right", "far side", "[[2, -1], [2, 1]]", "fixed");
    boundary(out, "right", "bottom", &format!("[[{r0}, -1], [2, -1]]"), FREE);
    boundary(out, "right", "top", &format!("[[{r1}, 1], [2, 1]]"), FREE);
    boundary(out, "left", "far side", "[[-2, -1], [-2, 1]]", "fixed");
    boundary(out, "left", "bottom", &format!("[[-2, -1], [{l0}, -1]]"), FREE);
    boundary(out, "left", "top", &format!("[[-2, 1], [{l1}, 1]]"), FREE);
    *out += "\n[contact]\ngap = [\"right face\", \"left face\"]\n";
    let lemma = format!("lemma = \"graph\"\nf = [\"{right}\", \"{left}\"]\ncutoff = [\"2 - x\", \"2 + x\"]\n");
    let closed = |common: &str, sign: char, share: f64, gap: &str| format!("{common} {sign} {share}*({gap})");
    let along = Along {
        name: "eta",
        from: -1.0,
        to: 1.0,
        // w'' − w' = ε − g: the gap's own part is added below
        across: [
            |common, gap, share, _| format!("{common} + {share}*({gap})"),
            |common, gap, _, rest| format!("{common} - {rest}*({gap})"),
        ],
        unit: draw.unit(),
    };
    match &draw.solution {
        Solution::Traces(traces) => {
            let mut lines = traces.lines(&along);
            let rest = super::super::dice::rounded(1.0 - traces.share, 3);
            lines.w = [closed(&lines.w[0], '-', traces.share, &gap), closed(&lines.w[1], '+', rest, &gap)];
            write_traces(out, &lemma, &lines);
        }
        _ => exact(out, draw, &lemma, None),
    }
}

fn write_traces(out: &mut String, lemma: &str, lines: &TraceLines) {
    let TraceLines { w, a, p, switches } = lines;
    let _ = write!(
        out,
        "\n[exact.traces]\n{lemma}w = [\"{}\", \"{}\"]\na = [\"{}\", \"{}\"]\np = \"{p}\"\n\
         switches = {switches:?}\nbreaks = {switches:?}\n",
        w[0], w[1], a[0], a[1],
    );
}

/// Tops and bottoms of the bodies along a polyline.
const TOP: f64 = 1.5;
const BOTTOM: f64 = -1.0;

fn polyline(out: &mut String, draw: &Draw, pushed: &Pushed) {
    let blocks = |upper: bool| -> String {
        let one = |p: &[[f64; 2]]| {
            let [[x0, y0], [x1, y1]] = [p[0], p[1]];
            let corners = if upper {
                format!("[[{x0}, {y0}], [{x1}, {y1}], [{x1}, {TOP}], [{x0}, {TOP}]]")
            } else {
                format!("[[{x0}, {BOTTOM}], [{x1}, {BOTTOM}], [{x1}, {y1}], [{x0}, {y0}]]")
            };
            format!("    {{ corners = {corners}, divisions = [1, 2] }},\n")
        };
        format!("blocks = [\n{}]\n", pushed.corners.windows(2).map(one).collect::<String>())
    };
    let force = |k: usize| {
        let [constant, slope] = pushed.forces[k].map(|f| super::super::dice::rounded(f * draw.unit(), 3));
        format!("force = [\"{slope}*x\", \"{constant} + {slope}*x\"]\n")
    };
    body(out, "upper", &draw.laws[0], &(blocks(true) + &force(0)));
    body(out, "lower", &draw.laws[1], &(blocks(false) + &force(1)));
    let ([first, .., last], [u, v]) = (&pushed.corners[..], pushed.top) else { return };
    boundary(out, "upper", "top", &format!("[[-1, {TOP}], [1, {TOP}]]"), "fixed");
    let _ = writeln!(out, "value = [\"{u}\", \"{v}\"]");
    boundary(out, "upper", "left", &format!("[[-1, {}], [-1, {TOP}]]", first[1]), "free");
    boundary(out, "upper", "right", &format!("[[1, {}], [1, {TOP}]]", last[1]), "free");
    boundary(out, "lower", "bottom", &format!("[[-1, {BOTTOM}], [1, {BOTTOM}]]"), "fixed");
    boundary(out, "lower", "left", &format!("[[-1, {BOTTOM}], [-1, {}]]", first[1]), "free");
    boundary(out, "lower", "right", &format!("[[1, {BOTTOM}], [1, {}]]", last[1]), "free");
    let corners: Vec<String> = pushed.corners.iter().map(|[x, y]| format!("[{x}, {y}]")).collect();
    let _ = write!(out, "\n[contact]\nalong = [{}]\n\n[reference]\nkind = \"none\"\n", corners.join(", "));
}
