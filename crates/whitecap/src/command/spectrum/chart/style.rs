//! Colours and letters.

use plotters::prelude::{Color, RGBColor, TextStyle};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontDesc, FontFamily, FontStyle};

pub(super) const PAPER: RGBColor = RGBColor(255, 255, 255);
pub(super) const INK: RGBColor = RGBColor(28, 39, 51);
pub(super) const FAINT: RGBColor = RGBColor(102, 115, 128);
pub(super) const GRID: RGBColor = RGBColor(224, 230, 236);
pub(super) const THEORY: RGBColor = RGBColor(20, 98, 168);
pub(super) const SURFACE: RGBColor = RGBColor(214, 92, 32);

/// Heights of letters, in units of the layout.
pub(super) const TITLE: f64 = 50.0;
pub(super) const HEADING: f64 = 38.0;
pub(super) const LABEL: f64 = 32.0;

/// Which side of a text is at its place; the middle of its height always is.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Left,
    Middle,
}

pub(super) fn written(height: f64, color: RGBColor, anchor: Anchor) -> TextStyle<'static> {
    let side = match anchor {
        Anchor::Left => HPos::Left,
        Anchor::Middle => HPos::Center,
    };
    let font = FontDesc::new(FontFamily::SansSerif, height, FontStyle::Normal);
    TextStyle { font, color: color.to_backend_color(), pos: Pos::new(side, VPos::Center) }
}

/// From nothing (0) to most (1): white over sea blue to night, darkening evenly.
pub(super) fn heat(share: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 6] = [
        [255.0, 255.0, 255.0],
        [205.0, 228.0, 240.0],
        [126.0, 188.0, 218.0],
        [48.0, 133.0, 189.0],
        [14.0, 78.0, 148.0],
        [8.0, 29.0, 80.0],
    ];
    let place = share.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let below = (place as usize).min(STOPS.len() - 2);
    let mix = |i: usize| {
        let (low, high) = (STOPS[below][i], STOPS[below + 1][i]);
        (low + (high - low) * (place - below as f64)).round() as u8
    };
    RGBColor(mix(0), mix(1), mix(2))
}
