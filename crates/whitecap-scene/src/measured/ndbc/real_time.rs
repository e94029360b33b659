//! Real-time spectral wave data: a value and its frequency in turn, newest record first; directions in four
//! more files of the same form.

use std::collections::BTreeMap;
use std::sync::Arc;

use whitecap_waves::spectrum::tabulated::DirectionalMoments;

use super::super::sea::toward_rad;
use super::super::{Energy, Format, MeasuredError, MeasuredProblem, MeasuredSea, Records, Text, Time};
use super::{BEARING, Column, DENSITY, RATIO, SEPARATION, energy, missing, place, time};

/// The extensions of the files of directions: α₁, α₂ (degrees that waves come from), r₁, r₂.
pub(in super::super) const COMPANIONS: [&str; 4] = ["swdir", "swdir2", "swr1", "swr2"];

/// Whether a file with this first line is one of densities.
pub(in super::super) fn is_real_time(first_line: &str) -> bool {
    first_line.trim_start().starts_with('#') && first_line.contains("spec_1")
}

/// Whether a file with this first line is one of directions.
pub(in super::super) fn names_directions(first_line: &str) -> bool {
    let names = ["alpha1_1", "alpha2_1", "r1_1", "r2_1"];
    first_line.trim_start().starts_with('#') && names.iter().any(|name| first_line.contains(name))
}

/// A line: its time, frequencies, and values where they are not missing.
struct Row {
    time: Time,
    frequencies_hz: Vec<f64>,
    values: Vec<Option<f64>>,
}

/// Reads every record, with its directions from the bytes of the four [`COMPANIONS`] if there are any.
pub(in super::super) fn read(
    bytes: &[u8],
    name: &str,
    companions: Option<[(&[u8], &str); 4]>,
) -> Result<Vec<MeasuredSea>, MeasuredError> {
    let mut text = Text::new(bytes, name)?;
    let directions = companions.map(read_companions).transpose()?;
    let place = Arc::new(place(name));
    let mut frequencies_hz: Arc<[f64]> = Arc::new([]);
    let (mut records, mut bands) = (Records::default(), Bands::default());
    while let Some(row) = row(&mut text, &DENSITY)? {
        text.points(Some(&row.frequencies_hz.len().to_string()), "frequencies", 2)?;
        text.ascending(&row.frequencies_hz)?;
        bands.note(&row.frequencies_hz, &text);
        if *row.frequencies_hz != *frequencies_hz {
            frequencies_hz = row.frequencies_hz.into();
        }
        let mut energy = energy(&row.values);
        if let (Energy::Omnidirectional { density }, Some(directions)) = (&mut energy, &directions) {
            let moments: Vec<_> = frequencies_hz.iter().map(|hz| directions.moments(row.time, *hz)).collect();
            let density = std::mem::take(density);
            energy = match moments.iter().any(Option::is_some) {
                true => Energy::Moments { density, moments },
                false => Energy::Undirected { density, lacking: directions.lacking(row.time) },
            };
        }
        let sea = MeasuredSea {
            source: Format::NdbcRealTime,
            place: Arc::clone(&place),
            time: Some(row.time),
            frequencies_hz: Arc::clone(&frequencies_hz),
            energy,
            missing: missing(&row.values),
        };
        records.push(&text, text.line(), sea)?;
    }
    bands.whole()?;
    records.all(&text)
}

/// The bands that lines of a file have, each with an error at the first line of them. A buoy that gets another instrument
/// has other bands from then on; a line with the first of another's bands and no more was cut short.
#[derive(Default)]
struct Bands(BTreeMap<Vec<u64>, MeasuredError>);

impl Bands {
    fn note(&mut self, frequencies_hz: &[f64], text: &Text<'_>) {
        // The bits of positive numbers are in the numbers' order.
        let bits: Vec<u64> = frequencies_hz.iter().map(|hz| hz.to_bits()).collect();
        let bands = bits.len();
        let cut_short = || text.error(MeasuredProblem::CutShort { bands, whole: 0 });
        self.0.entry(bits).or_insert_with(cut_short);
    }

    /// An error if a line was cut short.
    fn whole(self) -> Result<(), MeasuredError> {
        let mut shorter: Option<(Vec<u64>, MeasuredError)> = None;
        // What begins another comes right before it, or before one that begins so too.
        for (bits, error) in self.0 {
            match shorter {
                Some((begins, mut error)) if bits.starts_with(&begins) => {
                    if let MeasuredProblem::CutShort { whole, .. } = &mut error.problem {
                        *whole = bits.len();
                    }
                    return Err(error);
                }
                _ => shorter = Some((bits, error)),
            }
        }
        Ok(())
    }
}

/// What a file of directions has of every time: the line, and the values by frequencies in units of 10⁻⁴ Hz.
type Companion = BTreeMap<Time, (usize, BTreeMap<u32, f64>)>;

/// α₁, α₂, r₁ and r₂.
struct Companions {
    files: [Companion; 4],
    names: [Arc<str>; 4],
}

impl Companions {
    fn moments(&self, time: Time, hz: f64) -> Option<DirectionalMoments> {
        let [mean_deg, principal_deg, r1, r2] =
            self.files.each_ref().map(|file| file.get(&time)?.1.get(&key(hz)).copied());
        Some(DirectionalMoments {
            r1: r1?,
            mean_toward_rad: toward_rad(mean_deg?),
            r2: r2?,
            principal_toward_rad: toward_rad(principal_deg?),
        })
    }

    /// The first of the files without a value of this time, or where all have some, but none of the same frequency,
    /// all of them.
    fn lacking(&self, time: Time) -> Arc<str> {
        let is_empty = |file: &Companion| file.get(&time).is_none_or(|(_, values)| values.is_empty());
        match self.files.iter().position(is_empty) {
            Some(index) => Arc::clone(&self.names[index]),
            None => "the four files together".into(),
        }
    }
}

fn key(hz: f64) -> u32 {
    (hz * 1e4).round() as u32
}

fn read_companions(files: [(&[u8], &str); 4]) -> Result<Companions, MeasuredError> {
    let mut read: [Companion; 4] = Default::default();
    for (i, ((bytes, name), times)) in files.into_iter().zip(&mut read).enumerate() {
        let column = if i < 2 { BEARING } else { RATIO };
        let (mut text, mut bands) = (Text::new(bytes, name)?, Bands::default());
        while let Some(row) = row(&mut text, &column)? {
            bands.note(&row.frequencies_hz, &text);
            text.ascending(&row.frequencies_hz)?;
            let pairs = row.frequencies_hz.into_iter().zip(row.values);
            let values = pairs.filter_map(|(hz, value)| Some((key(hz), value?))).collect();
            match times.get(&row.time) {
                Some((first, known)) if *known != values => {
                    let record = format!("the directions of {}", row.time);
                    return Err(text.error(MeasuredProblem::Twice { record, first: *first }));
                }
                Some(_) => {}
                None => {
                    times.insert(row.time, (text.line(), values));
                }
            }
        }
        bands.whole()?;
    }
    Ok(Companions { files: read, names: files.map(|(_, name)| name.into()) })
}

/// The next line that is no comment.
fn row(text: &mut Text<'_>, column: &Column) -> Result<Option<Row>, MeasuredError> {
    let line = loop {
        match text.next() {
            Some(line) if line.trim_start().starts_with('#') => {}
            Some(line) => break line,
            None => return Ok(None),
        }
    };
    let mut words = line.split_whitespace();
    let time = time(text, &mut words, true)?;
    let mut words: Vec<_> = words.collect();
    // The separation frequency between swell and wind sea, in files of densities.
    if words.len() % 2 == 1 {
        SEPARATION.read(text, words.remove(0))?;
    }
    let mut row = Row { time, frequencies_hz: Vec::new(), values: Vec::new() };
    for pair in words.chunks_exact(2) {
        const FREQUENCY: &str = "a frequency in brackets after each value";
        let inside = pair[1].strip_prefix('(').and_then(|word| word.strip_suffix(')'));
        let inside = inside.ok_or_else(|| text.unexpected(pair[1], FREQUENCY))?;
        row.values.push(column.read(text, pair[0])?);
        row.frequencies_hz.push(text.number(inside, FREQUENCY)?);
    }
    Ok(Some(row))
}
