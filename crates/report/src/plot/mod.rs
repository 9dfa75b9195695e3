//! Pictures of a record: [`rates()`], [`ledger()`] and [`parts()`] build a [`Chart`], pure data; [`png()`] and [`svg()`] draw it.
//! [`pressure()`] builds a [`ZoneChart`] of the contact zone, for [`zone_png()`] and [`zone_svg()`].
//! [`mesh()`] and [`deformed()`] build a [`BodyChart`] of the fields of a level, for [`body_png()`] and [`body_svg()`].
//! A [`PanelChart`] puts two log–log panels side by side, for [`panel_png()`] and [`panel_svg()`].

mod annotate;
mod axis;
mod body_chart;
mod body_draw;
mod canvas;
mod chart;
mod deformed;
mod draw;
mod encode;
mod frame;
mod ledger;
mod linear;
mod mesh;
mod outline;
mod panel_chart;
mod panel_draw;
mod parts;
mod place;
mod pressure;
mod rates;
mod triangle;
mod vector;
pub mod viridis;
mod zone_chart;
mod zone_draw;

pub use body_chart::{Area, Bar, BodyChart, Label, Stroke, XY};
pub use chart::{Band, Chart, Colour, Curve, Guide, Mark, MarkKind, Shape, Slope, Weight};
pub use deformed::deformed;
pub use encode::{HEIGHT, WIDTH, body_png, body_svg, panel_png, panel_svg, png, svg, zone_png, zone_svg};
pub use ledger::ledger;
pub use mesh::mesh;
pub use panel_chart::{Panel, PanelChart, Series, Style};
pub use parts::parts;
pub use pressure::{percent, pressure, pressure_of_level};
pub use rates::rates;
pub use zone_chart::{Trace, ZoneChart};
