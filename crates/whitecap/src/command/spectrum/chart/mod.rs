//! The chart: S(f), the energy by direction, and both on a compass.
//!
//! It is laid out on 2400 × 1600 units and shown on half as many pixels, so that coordinates, which plotters has
//! whole, fall on halves of pixels.

mod axes;
mod bitmap;
mod compass;
mod directions;
mod frequencies;
mod style;

use anyhow::anyhow;
use plotters::coord::Shift;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{DrawingArea, DrawingBackend, IntoDrawingArea, SVGBackend, Text};
use std::path::Path;
use style::{Anchor, INK, PAPER, TITLE, written};
use whitecap_waves::direction::nautical_from_toward;
use whitecap_waves::statistics::{PolarSpectrum, SurfaceStatistics};

/// Units of the layout.
const SIZE: (u32, u32) = (2400, 1600);
/// For the title.
const HEAD: u32 = 110;
/// For S(f) and the energy by direction.
const LEFT: u32 = 1290;

/// An area to draw on, in units of the layout.
type Area<DB> = DrawingArea<DB, Shift>;
type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

/// The form of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Svg,
    Png,
}

impl Kind {
    /// By the name's ending.
    pub(super) fn of(path: &Path) -> Self {
        let svg = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"));
        if svg { Self::Svg } else { Self::Png }
    }
}

/// What the chart shows.
pub(super) struct Figure<'a> {
    /// The scene's name.
    pub(super) title: &'a str,
    pub(super) theory: &'a PolarSpectrum,
    pub(super) surface: &'a SurfaceStatistics,
}

impl Figure<'_> {
    /// The whole file.
    pub(super) fn draw(&self, kind: Kind) -> anyhow::Result<Vec<u8>> {
        match kind {
            Kind::Png => bitmap::draw(SIZE, |area| self.draw_on(area)),
            Kind::Svg => {
                let mut text = String::new();
                let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
                self.draw_on(&area).and_then(|()| area.present()).map_err(|error| anyhow!("{error}"))?;
                drop(area);
                // The size that it is shown in; its own units stay in the view box.
                let (own, shown) = (sized(SIZE), sized((SIZE.0 / 2, SIZE.1 / 2)));
                Ok(text.replacen(&own, &shown, 1).into_bytes())
            }
        }
    }

    fn draw_on<DB: DrawingBackend>(&self, area: &Area<DB>) -> Drawn<DB> {
        area.fill(&PAPER)?;
        let (head, body) = area.split_vertically(HEAD);
        head.draw(&Text::new(self.headline(), (60, 45), written(TITLE, INK, Anchor::Left)))?;
        let (left, right) = body.split_horizontally(LEFT);
        let (above, below) = left.split_vertically((SIZE.1 - HEAD) / 2);
        frequencies::draw(self, &above)?;
        directions::draw(self, &below)?;
        compass::draw(self, &right)
    }

    fn headline(&self) -> String {
        let sea = self.theory.statistics();
        let name = self.title.rsplit(['/', '\\']).next().unwrap_or(self.title);
        let mut line = format!("{name}: Hs {:.2} m", sea.significant_height_m());
        if let Some(period_s) = sea.peak_period_s {
            line += &format!(", Tp {period_s:.1} s");
        }
        if let Some(toward) = sea.mean_toward() {
            line += &format!(", from {:.0}°", nautical_from_toward(toward));
        }
        line
    }

    /// The frequency in Hz beyond which S(f) stays below `share` of its peak.
    fn last_frequency_hz(&self, share: f64) -> f64 {
        let samples = self.theory.frequency_spectrum();
        let most = samples.iter().map(|sample| sample.1).fold(0.0, f64::max);
        samples.iter().rev().find(|sample| sample.1 > share * most).map_or(1.0, |sample| sample.0)
    }
}

fn sized((width, height): (u32, u32)) -> String {
    format!("width=\"{width}\" height=\"{height}\"")
}
