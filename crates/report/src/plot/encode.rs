//! A chart as PNG bytes or as SVG text.

use super::body_chart::BodyChart;
use super::body_draw;
use super::canvas::Canvas;
use super::chart::Chart;
use super::draw::{Drawn, draw};
use super::panel_chart::PanelChart;
use super::panel_draw;
use super::vector::{DOTS, Vector, annotate};
use super::zone_chart::ZoneChart;
use super::zone_draw;
use crate::error::ReportError;
use plotters::prelude::BitMapBackend;
use std::io::Write;

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
    bitmap(Deflate::Small, |canvas| draw(chart, canvas))
}

/// The picture of a contact zone, as [`png()`].
///
/// # Errors
/// As [`png()`].
pub fn zone_png(chart: &ZoneChart) -> Result<Vec<u8>, ReportError> {
    bitmap(Deflate::Small, |canvas| zone_draw::draw(chart, canvas))
}

/// The picture of two bodies, as [`png()`].
///
/// # Errors
/// As [`png()`].
pub fn body_png(chart: &BodyChart) -> Result<Vec<u8>, ReportError> {
    bitmap(Deflate::Fast, |canvas| body_draw::draw(chart, canvas))
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
    bitmap(Deflate::Small, |canvas| panel_draw::draw(chart, canvas))
}

/// How a PNG is compressed.
#[derive(Clone, Copy, PartialEq)]
enum Deflate {
    /// Small files: charts, which are mostly white.
    Small,
    /// Thirty times as fast and twice as large: pictures with thousands of triangles, of which a run draws many.
    Fast,
}

fn bitmap(deflate: Deflate, paint: impl Fn(&Canvas<BitMapBackend>) -> Drawn) -> Result<Vec<u8>, ReportError> {
    let (width, height) = (WIDTH * FINER, HEIGHT * FINER);
    let mut dots = vec![255_u8; (width * height * 3) as usize];
    {
        let backend = BitMapBackend::with_buffer(&mut dots, (width, height));
        let canvas = Canvas::new(backend, f64::from(FINER))?;
        paint(&canvas)?;
        canvas.finish()?;
    }
    encode(&averaged(&dots), deflate).map_err(|e| ReportError::Picture(e.to_string()))
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
    let notes;
    {
        let canvas = Canvas::new(Vector::new(&mut text, (WIDTH, HEIGHT), words), f64::from(DOTS))?;
        paint(&canvas)?;
        notes = canvas.notes();
        canvas.finish()?;
    }
    annotate(&mut text, &notes);
    Ok(text)
}

/// Mean of each block of `FINER × FINER` dots. Most of a chart is paper: two rows that repeat those above repeat their means.
fn averaged(dots: &[u8]) -> Vec<u8> {
    let (row, out) = (3 * (WIDTH * FINER) as usize, 3 * WIDTH as usize);
    let mut pixels: Vec<u8> = Vec::with_capacity(out * HEIGHT as usize);
    let mut above: Option<&[u8]> = None;
    for rows in dots.chunks_exact(row * FINER as usize) {
        if above == Some(rows) {
            pixels.extend_from_within(pixels.len() - out..);
        } else {
            let (upper, lower) = rows.split_at(row);
            pixels.extend(upper.chunks_exact(6).zip(lower.chunks_exact(6)).flat_map(mean_of_four));
        }
        above = Some(rows);
    }
    pixels
}

/// Means over two dots of one row and the two below them, channel by channel, rounded down.
fn mean_of_four((upper, lower): (&[u8], &[u8])) -> [u8; 3] {
    let sum = |k: usize| u16::from(upper[k]) + u16::from(lower[k]);
    [0, 1, 2].map(|channel| ((sum(channel) + sum(channel + 3)) / 4) as u8)
}

fn encode(pixels: &[u8], deflate: Deflate) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, WIDTH, HEIGHT);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(if deflate == Deflate::Small { png::FilterType::NoFilter } else { png::FilterType::Paeth });
    let mut writer = encoder.write_header()?;
    if deflate == Deflate::Small {
        // for a stream `Fast` is a level of deflate, for a whole image another method, for filtered pixels
        let mut stream = writer.stream_writer()?;
        stream.write_all(pixels).map_err(png::EncodingError::IoError)?;
        stream.finish()?;
    } else {
        writer.write_image_data(pixels)?;
    }
    writer.finish()?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows that repeat, rows that do not, and sums that do not divide by four.
    #[test]
    fn pixels_are_means_of_four_dots() {
        let (width, height) = ((WIDTH * FINER) as usize, (HEIGHT * FINER) as usize);
        let shade = |x: usize, y: usize, channel: usize| match y {
            0..100 => 255,
            _ => ((7 * x + 13 * (y / 6) + 5 * channel) % 251) as u8,
        };
        let dots: Vec<u8> = (0..height)
            .flat_map(|y| (0..width).flat_map(move |x| [0, 1, 2].map(|channel| shade(x, y, channel))))
            .collect();
        let pixels = averaged(&dots);
        assert_eq!(pixels.len(), (WIDTH * HEIGHT * 3) as usize);
        for (x, y) in [(0, 0), (599, 49), (17, 50), (18, 51), (1199, 52), (600, 53), (1199, 899)] {
            for channel in 0..3 {
                let block = [(0, 0), (1, 0), (0, 1), (1, 1)];
                let sum: u32 = block.iter().map(|(i, j)| u32::from(shade(2 * x + i, 2 * y + j, channel))).sum();
                let pixel = pixels[3 * (y * WIDTH as usize + x) + channel];
                assert_eq!(u32::from(pixel), sum / 4, "pixel {x}, {y}, channel {channel}");
            }
        }
    }
}
