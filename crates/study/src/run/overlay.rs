//! Two divisions of one contact zone laid over each other: contact errors against a discrete reference whose mesh does not
//! split the level's sides.
//!
//! ```text
//!   level      •-----------•-----------•------     Both are intervals of the parameter of the zone's pieces. The
//!   reference  •----•----•----•----•----•----•     common refinement is cut at the middles of the sides too, since a
//!   pieces     |----|-|--|-|--|--|-|..             node owns its half sides.
//! ```

use super::contact::{ContactErrors, ContactState, farthest};
use signorini_contact::ContactLine;
use signorini_contact::geometry::Piece;
use signorini_contact::mesh::Mesh;
use signorini_contact::mesh::side::ContactView;
use signorini_contact::quadrature::GAUSS_8;

/// Shares of a piece closer to one another than this are one: foot points carry that much rounding.
const SAME: f64 = 1e-10;

/// A discrete solution on its contact zone.
pub struct Zone<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Pressure and active ends of its contact sides.
    pub state: &'a ContactState,
}

/// A contact side as an interval of a piece of the zone.
struct Strip<'a> {
    segment: u16,
    from: f64,
    to: f64,
    view: ContactView<'a>,
    pressure: [f64; 2],
    active: [bool; 2],
}

impl Strip<'_> {
    /// The share of the side at the share `t` of the piece.
    fn share(&self, t: f64) -> f64 {
        ((t - self.from) / (self.to - self.from)).clamp(0.0, 1.0)
    }

    fn middle(&self) -> f64 {
        0.5 * (self.from + self.to)
    }

    fn pressure(&self, t: f64) -> f64 {
        let s = self.share(t);
        (1.0 - s) * self.pressure[0] + s * self.pressure[1]
    }

    /// Whether the node that owns the place `t` is active.
    fn is_active(&self, t: f64) -> bool {
        self.active[usize::from(t > self.middle())]
    }

    /// `dμ/dt`.
    fn measure(&self, t: f64) -> f64 {
        self.view.at(self.share(t)).measure / (self.to - self.from)
    }
}

/// Measures the contact zone of a level against that of the reference. Switch sides are the level's own.
pub fn against_reference(line: &ContactLine, level: &Zone, reference: &Zone) -> ContactErrors {
    let mut errors = ContactErrors {
        pressure: 0.0,
        pressure_dual: 0.0,
        contact_set: 0.0,
        switch_sides: level.state.switch_sides(),
        switch_position: farthest(
            &reference.state.switch_points(reference.mesh),
            &level.state.switch_points(level.mesh),
        ),
    };
    let (coarse, fine) = (strips(line, level), strips(line, reference));
    each_overlap(&coarse, &fine, &mut |c, f, [from, to]| {
        let (width, whole) = (to - from, c.view.measure());
        let differ = c.is_active(0.5 * (from + to)) != f.is_active(0.5 * (from + to));
        for (x, w) in GAUSS_8 {
            let t = from + x * width;
            let measure = w * width * f.measure(t);
            let square = measure * (f.pressure(t) - c.pressure(t)).powi(2);
            errors.pressure += square;
            errors.pressure_dual += whole * square;
            errors.contact_set += if differ { measure } else { 0.0 };
        }
    });
    errors.pressure = errors.pressure.sqrt();
    errors.pressure_dual = errors.pressure_dual.sqrt();
    errors
}

/// The contact sides in the order of the zone.
fn strips<'a>(line: &ContactLine, zone: &Zone<'a>) -> Vec<Strip<'a>> {
    let pieces: Vec<Piece> = line.pieces().into_iter().map(|[first, _]| first).collect();
    let strip = |k: usize| {
        let side = &zone.mesh.contact[k];
        let foot = |i: u32| pieces[usize::from(side.segment)].foot(zone.mesh.points[i as usize]);
        let [from, to] = side.first.map(foot);
        let (pressure, active) = (zone.state.pressure[k], zone.state.active[k]);
        Strip { segment: side.segment, from, to, view: zone.mesh.contact_view(k), pressure, active }
    };
    (0..zone.mesh.contact.len()).map(strip).collect()
}

/// Calls `visit(a, b, [from, to])` for every piece of the common refinement of two divisions, cut at the middles of both.
fn each_overlap<'a>(a: &[Strip<'a>], b: &[Strip<'a>], visit: &mut impl FnMut(&Strip<'a>, &Strip<'a>, [f64; 2])) {
    let mut first = 0;
    for f in b {
        let ends_before = |c: &Strip| c.segment < f.segment || (c.segment == f.segment && c.to <= f.from + SAME);
        first += a[first..].iter().take_while(|c| ends_before(c)).count();
        let begins_before = |c: &&Strip| c.segment == f.segment && c.from < f.to - SAME;
        for c in a[first..].iter().take_while(begins_before) {
            let (low, high) = (f64::max(c.from, f.from), f64::min(c.to, f.to));
            let mut cuts = vec![low, high];
            cuts.extend([c.middle(), f.middle()].into_iter().filter(|m| (low + SAME..high - SAME).contains(m)));
            cuts.sort_by(f64::total_cmp);
            cuts.windows(2).for_each(|w| visit(c, f, [w[0], w[1]]));
        }
    }
}
