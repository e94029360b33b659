//! What a SWAN file says before its tables.

use std::sync::Arc;

use super::super::sea::toward_rad;
use super::super::text::number;
use super::super::{MeasuredError, Place, Text};
use super::{expect, first};

/// The sea's density in kg/m³ that SWAN multiplies by where it writes energy instead of variance: its
/// default.
const SEA_DENSITY: f64 = 1025.0;

/// How directions are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bearing {
    /// `NDIR`: degrees clockwise from north that waves come from.
    Nautical,
    /// `CDIR`: degrees anticlockwise from the x-axis, which is east, that waves go to.
    Cartesian,
}

impl Bearing {
    /// The direction of travel in radians from east towards south.
    pub(super) fn toward_rad(self, degrees: f64) -> f64 {
        match self {
            Self::Nautical => toward_rad(degrees),
            Self::Cartesian => -(degrees % 360.0).to_radians(),
        }
    }
}

/// A column of the tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Quantity {
    /// Density, and what makes variance in m²/Hz (and per radian, not degree, where there are directions) of
    /// it.
    Density { factor: f64 },
    /// The mean direction.
    Mean(Bearing),
    /// The directional spread in degrees.
    Spread,
    /// Something that is not needed.
    Other,
}

/// What stands for all tables.
pub(super) struct Header {
    pub(super) has_times: bool,
    pub(super) places: Vec<Arc<Place>>,
    pub(super) frequencies_hz: Arc<[f64]>,
    /// `None` for a file of means and spreads.
    pub(super) toward_rad: Option<Arc<[f64]>>,
    /// The columns, with the values that stand for nothing.
    pub(super) quantities: Vec<(Quantity, f64)>,
}

/// Whether a file with this first line is of the format.
pub(in super::super) fn is_swan(first_line: &str) -> bool {
    first(first_line) == "SWAN"
}

impl Header {
    pub(super) fn read(text: &mut Text<'_>) -> Result<Self, MeasuredError> {
        let title = expect(text, "SWAN 1")?;
        if !title.split_whitespace().take(2).eq(["SWAN", "1"]) {
            return Err(text.unexpected(title, "SWAN 1: version 1 of the format"));
        }
        let mut header = Self {
            has_times: false,
            places: Vec::new(),
            frequencies_hz: Arc::new([]),
            toward_rad: None,
            quantities: Vec::new(),
        };
        loop {
            let line = expect(text, "QUANT")?;
            match first(line) {
                "TIME" => {
                    let line = expect(text, TIME_CODING)?;
                    if first(line) != "1" {
                        return Err(text.unexpected(line, TIME_CODING));
                    }
                    header.has_times = true;
                }
                "LONLAT" | "LOCATIONS" => header.places = places(text)?,
                "AFREQ" | "RFREQ" => {
                    let frequencies_hz = column(text, "frequencies", 2)?;
                    text.ascending(&frequencies_hz)?;
                    header.frequencies_hz = frequencies_hz.into();
                }
                word @ ("NDIR" | "CDIR") => {
                    let bearing = if word == "NDIR" { Bearing::Nautical } else { Bearing::Cartesian };
                    let degrees = column(text, "directions", 3)?;
                    let toward_rad: Arc<[f64]> =
                        degrees.into_iter().map(|degrees| bearing.toward_rad(degrees)).collect();
                    text.distinct(&toward_rad)?;
                    header.toward_rad = Some(toward_rad);
                }
                "QUANT" => {
                    header.quantities = quantities(text, header.toward_rad.is_some())?;
                    break;
                }
                _ => return Err(text.unexpected(line, SECTIONS)),
            }
        }
        if header.places.is_empty() {
            return Err(text.unexpected("QUANT", "LONLAT or LOCATIONS before it"));
        }
        if header.frequencies_hz.is_empty() {
            return Err(text.unexpected("QUANT", "AFREQ or RFREQ before it"));
        }
        Ok(header)
    }
}

/// A count, and as many numbers, each on a line of its own.
fn column(text: &mut Text<'_>, what: &'static str, least: usize) -> Result<Vec<f64>, MeasuredError> {
    let line = expect(text, what)?;
    let count = text.points(Some(first(line)), what, least)?;
    (0..count).map(|_| text.first_number(what)).collect()
}

fn places(text: &mut Text<'_>) -> Result<Vec<Arc<Place>>, MeasuredError> {
    let line = expect(text, "the number of locations")?;
    let word = first(line);
    let count: usize = word.parse().map_err(|_| text.unexpected(word, "a count of locations"))?;
    let mut places = Vec::new();
    // As many as the file has lines: a count that lies ends the file, not the memory.
    for index in 1..=count {
        let line = expect(text, "a location: x and y")?;
        let mut words = line.split_whitespace().map(number);
        let (Some(Some(x)), Some(Some(y))) = (words.next(), words.next()) else {
            return Err(text.unexpected(line, "a location: x and y"));
        };
        places.push(Arc::new(Place { number: index, name: None, coordinates: Some([x, y]) }));
    }
    Ok(places)
}

fn quantities(text: &mut Text<'_>, has_directions: bool) -> Result<Vec<(Quantity, f64)>, MeasuredError> {
    let line = expect(text, "the number of quantities")?;
    let word = first(line);
    let count: usize = word.parse().map_err(|_| text.unexpected(word, "a count of quantities"))?;
    if count > 100 || (has_directions && count != 1) {
        return Err(text.unexpected(word, "one quantity with directions, some without"));
    }
    let per_radian = if has_directions { 1.0_f64.to_degrees() } else { 1.0 };
    let weight = SEA_DENSITY * whitecap_waves::GRAVITY_MPS2;
    let mut quantities = Vec::new();
    for _ in 0..count {
        let name = first(expect(text, QUANTITY)?).to_owned();
        let quantity = match name.as_str() {
            "VaDens" => Quantity::Density { factor: per_radian },
            "EnDens" => Quantity::Density { factor: per_radian / weight },
            "NDIR" => Quantity::Mean(Bearing::Nautical),
            "CDIR" => Quantity::Mean(Bearing::Cartesian),
            name if name.starts_with("DSPR") => Quantity::Spread,
            _ => Quantity::Other,
        };
        if has_directions && !matches!(quantity, Quantity::Density { .. }) {
            return Err(text.unexpected(&name, "VaDens or EnDens"));
        }
        let unit = first(expect(text, "a unit")?).to_owned();
        let degrees = unit.starts_with("degr");
        if matches!(quantity, Quantity::Mean(_) | Quantity::Spread) && !degrees {
            return Err(text.unexpected(&unit, "degr"));
        }
        let exception = text.first_number("the exception value")?;
        quantities.push((quantity, exception));
    }
    if !quantities.iter().any(|(quantity, _)| matches!(quantity, Quantity::Density { .. })) {
        return Err(text.unexpected("no density", "VaDens or EnDens among the quantities"));
    }
    Ok(quantities)
}

const TIME_CODING: &str = "time coding option 1: yyyymmdd.hhmmss";

const SECTIONS: &str = "TIME, LONLAT, LOCATIONS, AFREQ, RFREQ, NDIR, CDIR or QUANT";

const QUANTITY: &str = "a quantity: VaDens, EnDens, NDIR, CDIR, DSPRDEGR";
