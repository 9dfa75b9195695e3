//! Pictures of a record: [`rates()`], [`ledger()`] and [`parts()`] build a [`Chart`], pure data; [`png()`] and [`svg()`] draw it.
//! [`pressure()`] builds a [`ZoneChart`] of the contact zone, for [`zone_png()`] and [`zone_svg()`].
//! A [`PanelChart`] puts two log–log panels side by side, for [`panel_png()`].

mod annotate;
mod axis;
mod canvas;
mod chart;
mod draw;
mod encode;
mod frame;
mod ledger;
mod linear;
mod panel_chart;
mod panel_draw;
mod parts;
mod place;
mod pressure;
mod rates;
mod triangle;
mod zone_chart;
mod zone_draw;

pub use chart::{Band, Chart, Colour, Curve, Guide, Mark, MarkKind, Shape, Slope, Weight};
pub use encode::{HEIGHT, WIDTH, panel_png, png, svg, zone_png, zone_svg};
pub use ledger::ledger;
pub use panel_chart::{Panel, PanelChart, Series, Style};
pub use parts::parts;
pub use pressure::{percent, pressure};
pub use rates::rates;
pub use zone_chart::{Trace, ZoneChart};
