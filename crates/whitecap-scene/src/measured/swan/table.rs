//! The table of one place at one time.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use whitecap_waves::spectrum::tabulated::DirectionalMoments;

use super::super::{Energy, MeasuredError, Text};
use super::header::{Header, Quantity};
use super::{expect, first};

/// Reads the table that comes next: the line that it begins in, what it holds, and the frequencies that have exception
/// values.
pub(super) fn read(
    text: &mut Text<'_>,
    header: &Header,
) -> Result<(usize, Energy, Vec<usize>), MeasuredError> {
    const WANTED: [&str; 2] = ["LOCATION, ZERO or NODATA", "FACTOR, ZERO or NODATA"];
    let wanted = WANTED[usize::from(header.toward_rad.is_some())];
    let line = expect(text, wanted)?;
    let begins = text.line();
    let (energy, missing) = match (first(line), &header.toward_rad) {
        ("ZERO", _) => (Energy::Calm, Vec::new()),
        ("NODATA", _) => (Energy::Missing, Vec::new()),
        ("FACTOR", Some(toward_rad)) => directional(text, header, toward_rad)?,
        ("LOCATION", None) => means(text, header)?,
        _ => return Err(text.unexpected(line, wanted)),
    };
    Ok((begins, energy, missing))
}

fn directional(
    text: &mut Text<'_>,
    header: &Header,
    toward_rad: &Arc<[f64]>,
) -> Result<(Energy, Vec<usize>), MeasuredError> {
    let scale = text.first_number("the factor")?;
    let count = header.frequencies_hz.len() * toward_rad.len();
    let [(Quantity::Density { factor }, exception)] = header.quantities[..] else {
        return Ok((Energy::Missing, Vec::new())); // the header lets nothing else through
    };
    let (read, exceptions) = (Cell::new(0), RefCell::new(Vec::new()));
    let density = text.numbers_that(count, "densities, as integers", |text, value| {
        let i = read.replace(read.get() + 1);
        if is_exception(value, exception) {
            exceptions.borrow_mut().push(i / toward_rad.len());
            return Ok(0.0);
        }
        check(text, value * scale * factor)
    })?;
    let mut missing = exceptions.into_inner();
    if missing.len() == count {
        return Ok((Energy::Missing, Vec::new()));
    }
    missing.dedup();
    if density.iter().all(|value| *value == 0.0) {
        return Ok((Energy::Calm, missing));
    }
    Ok((Energy::Directional { toward_rad: Arc::clone(toward_rad), density }, missing))
}

/// A line for each frequency, a column for each quantity.
fn means(text: &mut Text<'_>, header: &Header) -> Result<(Energy, Vec<usize>), MeasuredError> {
    let (mut density, mut moments, mut missing) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..header.frequencies_hz.len() {
        let row = text.numbers(header.quantities.len(), "the quantities of a frequency")?;
        let (mut of_row, mut mean, mut spread_deg) = (None, None, None);
        for (value, (quantity, exception)) in row.into_iter().zip(&header.quantities) {
            if is_exception(value, *exception) {
                continue;
            }
            match quantity {
                Quantity::Density { factor } => {
                    of_row = Some(check(text, value * factor)?);
                }
                Quantity::Mean(bearing) => mean = Some(bearing.toward_rad(value)),
                Quantity::Spread if !(0.0..=WIDEST_DEG).contains(&value) => {
                    return Err(text.unexpected(&value.to_string(), "a spread from 0 to 81.1°"));
                }
                Quantity::Spread => spread_deg = Some(value),
                Quantity::Other => {}
            }
        }
        if of_row.is_none() {
            missing.push(i);
        }
        density.push(of_row.unwrap_or(0.0));
        moments.push(mean.zip(spread_deg).map(|(mean, spread_deg)| moments_of(mean, spread_deg)));
    }
    let energy = if missing.len() == density.len() {
        Energy::Missing
    } else if density.iter().all(|value| *value == 0.0) {
        Energy::Calm
    } else if moments.iter().all(Option::is_none) {
        Energy::Omnidirectional { density }
    } else {
        Energy::Moments { density, moments }
    };
    Ok((energy, missing))
}

/// The spread of waves that run alike in all directions is √2 rad, and no other is wider; with digits to spare.
const WIDEST_DEG: f64 = 81.1;

/// The moments of cos^{2s} with this spread σ: r₁ = 1 − σ²/2 (Kuik, van Vledder and Holthuijsen, 1988), s =
/// r₁/(1 − r₁).
fn moments_of(mean_toward_rad: f64, spread_deg: f64) -> DirectionalMoments {
    let spread = spread_deg.to_radians();
    let r1 = (1.0 - 0.5 * spread * spread).clamp(0.0, DirectionalMoments::LARGEST_R1);
    DirectionalMoments::of_cos2s(r1 / (1.0 - r1), mean_toward_rad)
}

fn is_exception(value: f64, exception: f64) -> bool {
    (value - exception).abs() <= 1e-6 * exception.abs()
}

fn check(text: &Text<'_>, density: f64) -> Result<f64, MeasuredError> {
    if (0.0..=1e7).contains(&density) {
        return Ok(density);
    }
    Err(text.unexpected(&density.to_string(), "a density from 0 to 10000000 m²/(Hz rad)"))
}
