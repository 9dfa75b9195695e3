//! Pictures of a record: [`rates()`], [`ledger()`] and [`parts()`] build a [`Chart`], pure data; [`png()`] and [`svg()`] draw it.

mod annotate;
mod axis;
mod canvas;
mod chart;
mod draw;
mod encode;
mod frame;
mod ledger;
mod parts;
mod place;
mod rates;
mod triangle;

pub use chart::{Band, Chart, Colour, Curve, Guide, Mark, MarkKind, Shape, Slope, Weight};
pub use encode::{HEIGHT, WIDTH, png, svg};
pub use ledger::ledger;
pub use parts::parts;
pub use rates::rates;
