//! The chart as PNG: shapes at twice the size and averaged, letters from the fonts that come with the program.

use super::{Area, Drawn};
use crate::png;
use crate::sheet::Sheet;
use anyhow::anyhow;
use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::iso_8859_1::{FONT_8X13, FONT_9X15, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::text::{Baseline, Text};
use image::{Rgba, RgbaImage};
use plotters::prelude::{BitMapBackend, DrawingBackend, IntoDrawingArea};
use plotters::style::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind};
use whitecap_render::picture::Picture;

/// Units of the layout for a pixel, along a side.
const SHARPNESS: u32 = 2;

/// Draws by `draw` on an area of `size` units and encodes it, half as large, as PNG.
pub(super) fn draw<'b>(
    size: (u32, u32),
    draw: impl FnOnce(&Area<Bitmap<'_>>) -> Drawn<Bitmap<'b>>,
) -> anyhow::Result<Vec<u8>> {
    let mut rgb8 = vec![255; (size.0 * size.1 * 3) as usize];
    let mut letters = Vec::new();
    let shapes = BitMapBackend::with_buffer(&mut rgb8, size);
    let area = Bitmap { shapes, letters: &mut letters }.into_drawing_area();
    draw(&area).map_err(|error| anyhow!("{error}"))?;
    area.present().map_err(|error| anyhow!("{error}"))?;
    drop(area);
    let mut picture = averaged(&rgb8, size);
    letters.iter().for_each(|line| line.draw(&mut picture));
    let (width, height) = picture.dimensions();
    Ok(png::encode(&Picture { width, height, rgba8: picture.into_raw() })?)
}

/// Each pixel is the mean of the units under it.
fn averaged(rgb8: &[u8], (width, height): (u32, u32)) -> RgbaImage {
    RgbaImage::from_fn(width / SHARPNESS, height / SHARPNESS, |x, y| {
        let mean = |channel: u32| {
            let under = (0..SHARPNESS * SHARPNESS)
                .map(|i| (SHARPNESS * x + i % SHARPNESS, SHARPNESS * y + i / SHARPNESS));
            let sum: u32 =
                under.map(|(x, y)| u32::from(rgb8[((y * width + x) * 3 + channel) as usize])).sum();
            (sum / (SHARPNESS * SHARPNESS)) as u8
        };
        Rgba([mean(0), mean(1), mean(2), 255])
    })
}

/// plotters' own bitmap for shapes; what is written waits for the finished picture.
pub(super) struct Bitmap<'a> {
    shapes: BitMapBackend<'a>,
    letters: &'a mut Vec<Line>,
}

/// A line of text, in pixels of the picture.
struct Line {
    text: String,
    font: &'static MonoFont<'static>,
    color: Rgb888,
    left_top: Point,
}

impl Line {
    fn draw(&self, picture: &mut RgbaImage) {
        let style = MonoTextStyle::new(self.font, self.color);
        let text = Text::with_baseline(&self.text, self.left_top, style, Baseline::Top);
        let Ok(_) = text.draw(&mut Sheet(picture));
    }
}

/// The largest font that is no higher than a text should be, in units of the layout.
fn font(size: f64) -> &'static MonoFont<'static> {
    match size {
        size if size >= 44.0 => &FONT_10X20,
        size if size >= 36.0 => &FONT_9X15,
        _ => &FONT_8X13,
    }
}

type Failed<'a> = DrawingErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>;

impl<'a> DrawingBackend for Bitmap<'a> {
    type ErrorType = <BitMapBackend<'a> as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.shapes.get_size()
    }

    fn ensure_prepared(&mut self) -> Result<(), Failed<'a>> {
        self.shapes.ensure_prepared()
    }

    fn present(&mut self) -> Result<(), Failed<'a>> {
        self.shapes.present()
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Result<(), Failed<'a>> {
        self.shapes.draw_pixel(point, color)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), Failed<'a>> {
        self.shapes.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Result<(), Failed<'a>> {
        self.shapes.draw_rect(upper_left, bottom_right, style, fill)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        pos: BackendCoord,
    ) -> Result<(), Failed<'a>> {
        let font = font(style.size());
        let (width, height) = self.estimate_text_size(text, style)?;
        let left = match style.anchor().h_pos {
            HPos::Left => 0,
            HPos::Center => width as i32 / 2,
            HPos::Right => width as i32,
        };
        let top = match style.anchor().v_pos {
            VPos::Top => 0,
            VPos::Center => height as i32 / 2,
            VPos::Bottom => height as i32,
        };
        let (r, g, b) = style.color().rgb;
        let sharpness = SHARPNESS as i32;
        let left_top = Point::new((pos.0 - left) / sharpness, (pos.1 - top) / sharpness);
        self.letters.push(Line { text: text.to_owned(), font, color: Rgb888::new(r, g, b), left_top });
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), Failed<'a>> {
        let size = font(style.size()).character_size;
        Ok((SHARPNESS * size.width * text.chars().count() as u32, SHARPNESS * size.height))
    }
}
