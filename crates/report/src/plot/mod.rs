//! Pictures of a record: [`rates()`] and [`ledger()`] build a [`Chart`], pure data; [`png()`] and [`svg()`] draw it.

mod annotate;
mod axis;
mod canvas;
mod chart;
mod draw;
mod encode;
mod frame;
mod ledger;
mod place;
mod rates;
mod triangle;

pub use chart::{Band, Chart, Colour, Curve, Mark, MarkKind, Shape, Slope};
pub use encode::{HEIGHT, WIDTH, png, svg};
pub use ledger::ledger;
pub use rates::rates;
