//! A wave system that somebody measured: [`crate::measured`] reads the file itself.

use std::borrow::Cow;
use std::path::PathBuf;

use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::tabulated;
use whitecap_waves::spectrum::{Profile, WaveSpectrum};
use whitecap_waves::statistics::significant_height_m;

use super::asked::HEIGHT;
use super::spreading::AnySpreading;
use super::warnings;
use crate::error::SceneError;
use crate::key::{Count, File, Flag, Moment, Name, OneOf, Real, optional, or, required, table, words};
use crate::measured::{self, Directions, Energy, MeasuredProblem, MeasuredSea, Part, Selection, Time, When};
use crate::reader::TableReader;

/// A greater share of the energy than this with directions that contradict each other, or with none, is worth a warning.
const MISDIRECTED: f64 = 0.01;

words! {
    /// How directions are made from the moments that a buoy measures.
    pub enum DirectionMethod {
        /// Maximum entropy (Lygre and Krogstad, 1986): has exactly the moments that were measured.
        MaximumEntropy = "mem",
        /// Longuet-Higgins's (1963) weighted Fourier sum: smoother, and broader than what was measured.
        LonguetHiggins = "longuet-higgins",
    }
}

table! {
    /// A measured or forecast sea: a table `[[sea.system]]` with `measured` in place of `spectrum`.
    pub struct MeasuredSystem {
        /// The file of spectra: NDBC real-time (`.data_spec`, with its files of directions beside it) or historical density, WAVEWATCH III point output, or a SWAN spectral file. `named:buoy.spec` comes with whitecap.
        measured: PathBuf = required(File);
        /// The time of the record, which must be in the file.
        time: Option<Time> = optional(Moment, "the newest record that has waves, and directions if any has");
        /// The record, counted back from the newest, which is 0. Not beside `time`.
        record: Option<u32> = optional(Count { min: 0, max: 1_048_575 }, "see `time`");
        /// The place in a file of several: its name, or its number from 1.
        place: Option<String> = optional(Name, "the first place");
        /// Whether waves go on beyond the file's last frequency, as f⁻⁵: a buoy's record ends at waves of some metres, and without
        /// shorter ones the water looks like glass.
        tail: bool = or(Flag, false);
        /// How directions are made from moments; for NDBC files with directions and SWAN files of means.
        direction_method: Option<DirectionMethod> = optional(OneOf::<DirectionMethod>::WORDS, "`\"mem\"`");
        /// The bearing that the waves of a file without directions come from, clockwise from north; such a file needs it.
        from_deg: Option<f64> = optional(Real { unit: "deg", min: 0.0, max: 360.0 }, "as the file says");
        /// How narrow the waves of a file without directions run: the s of cos^2s of half the angle, where 1000 is a spread of 2.6°.
        cos2s: Option<f64> = optional(AnySpreading::EXPONENT, "10 for a file without directions");
    }
}

impl MeasuredSystem {
    pub(super) fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        if table.has("spectrum") {
            return Err(table.error(Some("spectrum"), "beside measured; accepted: one of the two"));
        }
        let system = Self::read(table)?;
        if system.time.is_some() && system.record.is_some() {
            return Err(table.error(Some("record"), "beside time; accepted: one of the two"));
        }
        Ok(system)
    }

    /// Reads the file and finds the record; `table` is what errors call this system, such as `sea.system[0]`.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or has no such record.
    pub fn load(&self, table: &str) -> Result<MeasuredSea, SceneError> {
        self.chosen(table, &self.records(table)?).map(|record| self.drawn(record).into_owned())
    }

    /// The record with the tail that it is drawn with.
    fn drawn<'a>(&self, record: &'a MeasuredSea) -> Cow<'a, MeasuredSea> {
        if self.tail { Cow::Owned(record.with_tail()) } else { Cow::Borrowed(record) }
    }

    fn records(&self, table: &str) -> Result<Vec<MeasuredSea>, SceneError> {
        measured::load(&self.measured)
            .map_err(|error| SceneError::about_key(format!("{table}.measured"), error.to_string()))
    }

    fn chosen<'a>(&self, table: &str, seas: &'a [MeasuredSea]) -> Result<&'a MeasuredSea, SceneError> {
        let when = match (self.time, self.record) {
            (Some(time), _) => When::At(time),
            (None, Some(record)) => When::Back(record as usize),
            (None, None) => When::Newest,
        };
        let selection = Selection { place: self.place.clone(), when };
        measured::select(seas, &selection).map_err(|problem| self.problem(table, &problem))
    }

    /// Reads the file and makes the spectrum of its record over water with this dispersion; `table` is what errors
    /// call this system, such as `sea.system[0]`.
    ///
    /// # Errors
    ///
    /// As [`load`](Self::load), and if the record is without waves or needs other directions.
    pub fn build(&self, table: &str, water: &Dispersion) -> Result<Box<dyn WaveSpectrum>, SceneError> {
        let directions = Directions {
            method: self.direction_method.map(|method| match method {
                DirectionMethod::MaximumEntropy => tabulated::DirectionMethod::MaximumEntropy,
                DirectionMethod::LonguetHiggins => tabulated::DirectionMethod::LonguetHiggins,
            }),
            from_deg: self.from_deg,
            cos2s: self.cos2s,
        };
        let record = self.load(table)?;
        let height_m = significant_height_m(record.variance_m2());
        let spectrum = match height_m > HEIGHT.max {
            true => Err(MeasuredProblem::TooHigh { height_m, most_m: HEIGHT.max }),
            false => record.spectrum(&directions, water),
        };
        match spectrum {
            Ok(spectrum) => Ok(Box::new(spectrum)),
            Err(problem) => Err(self.problem(table, &problem)),
        }
    }

    /// The significant height of the record, by the sum that its own format prescribes; `None` if it cannot be read.
    pub(super) fn significant_height_m(&self) -> Option<f64> {
        let record = self.load("sea.system").ok()?;
        Some(significant_height_m(record.variance_m2()))
    }

    /// Where the newest record is passed over because it lacks waves or directions, where no waves have directions such as the
    /// record's or it has none, where the energy between the file's frequencies is not what the file's own sum says, as with
    /// few of them, where its frequencies end among its waves, and where the water cannot carry them.
    pub(super) fn warnings(&self, spectrum: &dyn WaveSpectrum, water: &Dispersion) -> Vec<String> {
        let table = "sea.system";
        let Ok(seas) = self.records(table) else { return Vec::new() };
        let Ok(chosen) = self.chosen(table, &seas) else { return Vec::new() };
        let drawn = self.drawn(chosen);
        let about_file = [
            self.skipped(&seas, chosen),
            self.contradicting(chosen),
            self.undirected(chosen),
            self.incomplete(chosen),
            self.resummed(&drawn, spectrum),
            self.cut_off(&drawn),
        ];
        let height_m = significant_height_m(spectrum.variance_m2());
        let peak = Profile::of(&spectrum).peak_wave_number();
        let about_waves = warnings::about_waves(height_m, peak, water, "");
        about_file.into_iter().flatten().chain(about_waves).collect()
    }

    fn skipped(&self, seas: &[MeasuredSea], chosen: &MeasuredSea) -> Option<String> {
        if self.time.is_some() || self.record.is_some() {
            return None;
        }
        let newest = measured::passed_over(seas, chosen)?;
        let of = |sea: &MeasuredSea| sea.time.map(|time| format!(" of {time}")).unwrap_or_default();
        let (newest_of, drawn_of) = (of(newest), of(chosen));
        Some(match (newest.lacking_directions(), &newest.energy) {
            (Some(lacking), _) => format!(
                "{lacking} has no directions{newest_of}, the newest record; that{drawn_of} is drawn, the newest with \
                 directions"
            ),
            (None, energy) => format!(
                "{}: the newest record{newest_of} {}; that{drawn_of} is drawn, the newest with waves",
                self.measured.display(),
                match energy {
                    Energy::Missing => "has no values, all are missing",
                    _ => "is of a calm, all values are 0",
                }
            ),
        })
    }

    fn contradicting(&self, chosen: &MeasuredSea) -> Option<String> {
        let Part { frequencies, directed: of, share } = chosen.contradicting_directions();
        (share > MISDIRECTED).then(|| {
            format!(
                "{}: {frequencies} of {of} frequencies, with {:.1} % of the energy, have directional moments r1, r2, alpha1 and \
                 alpha2 that no distribution of directions has; there r2 and alpha2 are drawn as the nearest that one has",
                self.measured.display(),
                100.0 * share
            )
        })
    }

    fn undirected(&self, chosen: &MeasuredSea) -> Option<String> {
        let Part { frequencies, share, .. } = chosen.lacking_moments();
        (share > MISDIRECTED).then(|| {
            format!(
                "{}: {frequencies} frequencies, with {:.1} % of the energy, have no directions in the four files of them; theirs are \
                 those of their neighbours",
                self.measured.display(),
                100.0 * share
            )
        })
    }

    fn incomplete(&self, chosen: &MeasuredSea) -> Option<String> {
        let (there, lost) = (chosen.variance_m2(), chosen.variance_missing_m2());
        let whole_m = significant_height_m(there + lost);
        if significant_height_m(there) >= 0.99 * whole_m {
            return None;
        }
        let ends = [chosen.missing.first(), chosen.missing.last()].map(|i| chosen.frequencies_hz.get(*i?));
        let [Some(first), Some(last)] = ends else { return None };
        let place =
            if first == last { format!("at {first} Hz") } else { format!("from {first} to {last} Hz") };
        Some(format!(
            "{}: values of {} of its {} frequencies, {place}, are missing and count as no energy: {:.2} m of \
             significant height, {whole_m:.2} m if they were like their neighbours; another time may be whole",
            self.measured.display(),
            chosen.missing.len(),
            chosen.frequencies_hz.len(),
            significant_height_m(there)
        ))
    }

    fn resummed(&self, chosen: &MeasuredSea, spectrum: &dyn WaveSpectrum) -> Option<String> {
        let own_m = significant_height_m(chosen.variance_m2());
        let drawn_m = significant_height_m(spectrum.variance_m2());
        if (drawn_m - own_m).abs() <= 0.01 * own_m {
            return None;
        }
        Some(format!(
            "{} sums to {own_m:.2} m of significant height by its own bands, and to {drawn_m:.2} m between its few \
             frequencies, which is what is drawn",
            self.measured.display()
        ))
    }

    fn cut_off(&self, chosen: &MeasuredSea) -> Option<String> {
        let (there, beyond) = (chosen.variance_m2(), chosen.variance_beyond_m2());
        let whole_m = significant_height_m(there + beyond);
        if significant_height_m(there) >= 0.99 * whole_m {
            return None;
        }
        Some(format!(
            "{} ends at {} Hz, among its waves: {:.2} m of significant height, {whole_m:.2} m if they went on as wind \
             seas do; nothing beyond the file is drawn without tail = true",
            self.measured.display(),
            chosen.frequencies_hz.last()?,
            significant_height_m(there)
        ))
    }

    /// The file's complaint, under the key that would mend it.
    fn problem(&self, table: &str, problem: &MeasuredProblem) -> SceneError {
        let key = match problem {
            MeasuredProblem::NoSuchTime { .. } => "time",
            MeasuredProblem::NoSuchRecord { .. } => "record",
            MeasuredProblem::NoSuchPlace { .. } => "place",
            MeasuredProblem::NoDirections => "from_deg",
            MeasuredProblem::NoMoments => "direction_method",
            MeasuredProblem::HasDirections { key } => key,
            MeasuredProblem::NoWaves { .. } | MeasuredProblem::NoDirectionsThen { .. }
                if self.time.is_some() =>
            {
                "time"
            }
            MeasuredProblem::NoWaves { .. } | MeasuredProblem::NoDirectionsThen { .. }
                if self.record.is_some() =>
            {
                "record"
            }
            _ => "measured",
        };
        SceneError::about_key(format!("{table}.{key}"), format!("{}: {problem}", self.measured.display()))
    }
}
