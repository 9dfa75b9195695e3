//! A chart as PNG bytes or as SVG text.

use super::body_chart::BodyChart;
use super::body_draw;
use super::canvas::Canvas;
use super::chart::Chart;
use super::draw::{Drawn, draw};
use super::panel_chart::PanelChart;
use super::panel_draw;
use super::vector::{DOTS, Vector};
use super::zone_chart::ZoneChart;
use super::zone_draw;
use crate::error::ReportError;
use plotters::prelude::BitMapBackend;

/// Width of a picture in pixels.
pub const WIDTH: u32 = 1200;
/// Height of a picture in pixels.
pub const HEIGHT: u32 = 900;
/// The bitmap is drawn this many times finer and averaged, which smooths every edge.
const FINER: u32 = 2;

/// The chart as a PNG of [`WIDTH`] × [`HEIGHT`] pixels.
///
/// # Errors
/// [`ReportError::Picture`] if drawing or encoding fails.
pub fn png(chart: &Chart) -> Result<Vec<u8>, ReportError> {
    bitmap(|canvas| draw(chart, canvas))
}

/// The picture of a contact zone, as [`png()`].
///
/// # Errors
/// As [`png()`].
pub fn zone_png(chart: &ZoneChart) -> Result<Vec<u8>, ReportError> {
    bitmap(|canvas| zone_draw::draw(chart, canvas))
}

/// The picture of two bodies, as [`png()`].
///
/// # Errors
/// As [`png()`].
pub fn body_png(chart: &BodyChart) -> Result<Vec<u8>, ReportError> {
    bitmap(|canvas| body_draw::draw(chart, canvas))
}

/// The picture of two bodies, as [`svg`].
///
/// # Errors
/// As [`svg`].
pub fn body_svg(chart: &BodyChart) -> Result<String, ReportError> {
    vector(&chart.title, |canvas| body_draw::draw(chart, canvas))
}

/// Two panels side by side, as [`svg`].
///
/// # Errors
/// As [`svg`].
pub fn panel_svg(chart: &PanelChart) -> Result<String, ReportError> {
    vector(&chart.title, |canvas| panel_draw::draw(chart, canvas))
}

/// Two panels side by side, as [`png()`].
///
/// # Errors
/// As [`png()`].
pub fn panel_png(chart: &PanelChart) -> Result<Vec<u8>, ReportError> {
    bitmap(|canvas| panel_draw::draw(chart, canvas))
}

fn bitmap(paint: impl Fn(&Canvas<BitMapBackend>) -> Drawn) -> Result<Vec<u8>, ReportError> {
    let (width, height) = (WIDTH * FINER, HEIGHT * FINER);
    let mut dots = vec![255_u8; (width * height * 3) as usize];
    {
        let backend = BitMapBackend::with_buffer(&mut dots, (width, height));
        let canvas = Canvas::new(backend, f64::from(FINER))?;
        paint(&canvas)?;
        canvas.finish()?;
    }
    encode(&averaged(&dots)).map_err(|e| ReportError::Picture(e.to_string()))
}

/// The chart as SVG, by itself or inside a page: see [`Colour::PALETTE`](super::Colour::PALETTE) for its classes.
/// Text is text, in the font of the bitmap where the viewer has it.
///
/// # Errors
/// [`ReportError::Picture`] if drawing fails.
pub fn svg(chart: &Chart) -> Result<String, ReportError> {
    vector(&chart.title, |canvas| draw(chart, canvas))
}

/// The picture of a contact zone, as [`svg`].
///
/// # Errors
/// As [`svg`].
pub fn zone_svg(chart: &ZoneChart) -> Result<String, ReportError> {
    vector(&chart.title, |canvas| zone_draw::draw(chart, canvas))
}

fn vector(words: &str, paint: impl Fn(&Canvas<Vector>) -> Drawn) -> Result<String, ReportError> {
    let mut text = String::new();
    {
        let canvas = Canvas::new(Vector::new(&mut text, (WIDTH, HEIGHT), words), f64::from(DOTS))?;
        paint(&canvas)?;
        canvas.finish()?;
    }
    Ok(text)
}

/// Mean of each block of `FINER × FINER` dots.
fn averaged(dots: &[u8]) -> Vec<u8> {
    let (pixel, row) = (3 * FINER as usize, 3 * (WIDTH * FINER) as usize);
    let mut pixels = Vec::with_capacity((WIDTH * HEIGHT * 3) as usize);
    for rows in dots.chunks_exact(row * FINER as usize) {
        for left in (0..row).step_by(pixel) {
            let mut sums = [0_u32; 3];
            for line in rows.chunks_exact(row) {
                for dot in line[left..left + pixel].chunks_exact(3) {
                    (0..3).for_each(|channel| sums[channel] += u32::from(dot[channel]));
                }
            }
            pixels.extend(sums.map(|sum| (sum / (FINER * FINER)) as u8));
        }
    }
    pixels
}

fn encode(pixels: &[u8]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH, HEIGHT);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Default);
    encoder.set_filter(png::FilterType::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}
