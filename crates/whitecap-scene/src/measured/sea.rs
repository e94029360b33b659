//! One record of a measured sea, whatever format it came in, and the spectrum that it makes.

use std::borrow::Cow;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;
use std::sync::Arc;

use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::spectrum::tabulated::{
    DirectionMethod, DirectionalMoments, Tabulated, TabulatedParameters, cos2s_distribution, even_directions,
    sampled,
};

use super::{MeasuredProblem, Time, quadrature};

/// How many directions a spectrum gets that is made from moments: every 2°.
const DIRECTIONS: usize = 180;

/// The exponent of cos^{2s}(θ/2) for a file without directions: Goda and Suzuki (1975) for wind waves.
pub(crate) const DEFAULT_COS2S: f64 = 10.0;

/// What writing r₁ and r₂ in hundredths moves |c₂ − c₁²| and 1 − r₁² apart by, near r₁ = r₂ = 1.
const ROUNDED: f64 = 0.025;

/// Where a tail ends, and its frequencies as multiples of each other.
const TAIL_END_HZ: f64 = 10.0;
const TAIL_STEP: f64 = 1.05;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// NDBC real-time spectral wave data: `.data_spec`, and `.swdir .swdir2 .swr1 .swr2` beside it.
    NdbcRealTime,
    /// NDBC historical spectral wave density: one file for a year.
    NdbcHistory,
    /// WAVEWATCH III point output of spectra.
    WaveWatch3,
    /// SWAN standard spectral file, version 1.
    Swan,
}

/// Where a record was taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Which of the file's places it is, from 1.
    pub number: usize,
    /// Its name, if the file has names.
    pub name: Option<String>,
    /// Where it is, as the file says: longitude and latitude in degrees, or x and y in metres.
    pub coordinates: Option<[f64; 2]>,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.name, self.coordinates) {
            (Some(name), _) => write!(f, "{name:?}"),
            (None, Some([x, y])) => write!(f, "\"{}\" at ({x}, {y})", self.number),
            (None, None) => write!(f, "\"{}\"", self.number),
        }
    }
}

/// One record: the waves of one place at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredSea {
    /// What the file is.
    pub source: Format,
    /// Where it was taken.
    pub place: Arc<Place>,
    /// When, if the file says so.
    pub time: Option<Time>,
    /// The frequencies in Hz, ascending.
    pub frequencies_hz: Arc<[f64]>,
    /// The waves.
    pub energy: Energy,
    /// Which frequencies have a value missing; it counts as no energy.
    pub missing: Vec<usize>,
}

/// What a record says of the waves.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Energy {
    /// Nothing: every value is missing.
    Missing,
    /// That there are none.
    Calm,
    /// How much energy each frequency has, but not its direction.
    Omnidirectional {
        /// S(f) in m²/Hz for each frequency.
        density: Vec<f64>,
    },
    /// How much energy each frequency has; its directions should be in files beside it, but are not.
    Undirected {
        /// S(f) in m²/Hz for each frequency.
        density: Vec<f64>,
        /// The file that has nothing of this time, or all of them.
        lacking: Arc<str>,
    },
    /// The energy of each frequency and the first moments of its directions.
    Moments {
        /// S(f) in m²/Hz for each frequency.
        density: Vec<f64>,
        /// The directions of each frequency, where they are known; at least one is.
        moments: Vec<Option<DirectionalMoments>>,
    },
    /// The energy of each frequency and direction.
    Directional {
        /// The directions of travel in radians from east towards south.
        toward_rad: Arc<[f64]>,
        /// E(f, θ) in m²/(Hz rad): for each frequency its directions.
        density: Vec<f64>,
    },
}

/// Some of a record's frequencies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    /// How many.
    pub frequencies: usize,
    /// How many of the whole record have energy and moments of directions.
    pub directed: usize,
    /// Their share of the record's variance, 0 to 1.
    pub share: f64,
}

/// What the scene says of directions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Directions {
    /// How directions are made from moments; `None` for maximum entropy.
    pub method: Option<DirectionMethod>,
    /// The bearing in degrees that the waves of a file without directions come from.
    pub from_deg: Option<f64>,
    /// Their spreading, the s of cos^{2s}(θ/2); `None` for 10.
    pub cos2s: Option<f64>,
}

impl MeasuredSea {
    /// m0 in m² by the sum that the format's makers take themselves: Hs is 4√m0 of it. 0 without waves.
    ///
    /// NDBC takes each value for the whole of its band. WAVEWATCH III takes the trapezoidal rule in
    /// frequency and equal steps in direction, SWAN equal steps of direction and of the logarithm of
    /// frequency, without its tail.
    pub fn variance_m2(&self) -> f64 {
        self.density_m2phz().iter().zip(&self.widths_hz()).map(|(s, width)| s * width).sum()
    }

    /// What the format's makers take each frequency to stand for.
    fn widths_hz(&self) -> Vec<f64> {
        match self.source {
            Format::NdbcRealTime | Format::NdbcHistory => quadrature::bands(&self.frequencies_hz),
            Format::WaveWatch3 => quadrature::trapezoids(&self.frequencies_hz),
            Format::Swan => quadrature::log_bands(&self.frequencies_hz),
        }
    }

    /// Where the record's moments of directions are such as no distribution has, by more than the digits of a file leave open.
    pub fn contradicting_directions(&self) -> Part {
        self.part(|moments| moments.is_some_and(|moments| moments.contradiction() > ROUNDED))
    }

    /// Where there are no moments of directions although other frequencies have them: the files of directions lack them.
    pub fn lacking_moments(&self) -> Part {
        self.part(|moments| moments.is_none())
    }

    /// The frequencies with energy whose moments are such.
    fn part(&self, is_such: impl Fn(Option<DirectionalMoments>) -> bool) -> Part {
        let Energy::Moments { density, moments } = &self.energy else { return Part::default() };
        let (mut part, mut variance_m2) = (Part::default(), 0.0);
        for ((s, moments), width) in
            density.iter().zip(moments).zip(self.widths_hz()).filter(|((s, _), _)| **s > 0.0)
        {
            part.directed += usize::from(moments.is_some());
            if is_such(*moments) {
                part.frequencies += 1;
                variance_m2 += s * width;
            }
        }
        if variance_m2 > 0.0 {
            part.share = variance_m2 / self.variance_m2();
        }
        part
    }

    /// The variance in m² that waves above the last frequency have if they go on from there as f⁻⁵, as those of a wind
    /// sea do (Phillips, *J. Fluid Mech.* 4, 1958): S f/4 of the last frequency. The record does not have it.
    pub fn variance_beyond_m2(&self) -> f64 {
        let last = self.density_m2phz().last().copied().unwrap_or(0.0);
        0.25 * last * self.frequencies_hz.last().copied().unwrap_or(0.0)
    }

    /// The variance in m² that the frequencies with a missing value may have had beside what is left of them: on a line between
    /// the whole ones next to them, and above the last of those falling off as f⁻⁵. The record does not have it.
    pub fn variance_missing_m2(&self) -> f64 {
        let (density, hz) = (self.density_m2phz(), &self.frequencies_hz);
        let whole: Vec<usize> = (0..density.len()).filter(|i| !self.missing.contains(i)).collect();
        let likely = |i: usize| {
            let above = whole.partition_point(|known| *known < i);
            match (above.checked_sub(1).map(|below| whole[below]), whole.get(above)) {
                (Some(a), Some(&b)) => {
                    density[a] + (density[b] - density[a]) * (hz[i] - hz[a]) / (hz[b] - hz[a])
                }
                (Some(a), None) => density[a] * (hz[a] / hz[i]).powi(5),
                (None, _) => 0.0,
            }
        };
        let widths = self.widths_hz();
        let lost = |i: &usize| Some(widths.get(*i)? * (likely(*i) - density.get(*i)?).max(0.0));
        self.missing.iter().filter_map(lost).sum()
    }

    /// The same waves, and beyond the last frequency those that a wind sea has: they go on as f⁻⁵, in its directions, to 10 Hz,
    /// waves of 17 mm. Wave models end their own spectra so (*WAVEWATCH III* manual, section 2.3).
    pub fn with_tail(&self) -> MeasuredSea {
        let Some(&last_hz) = self.frequencies_hz.last() else { return self.clone() };
        let beyond = std::iter::successors(Some(TAIL_STEP * last_hz), |hz| Some(TAIL_STEP * hz));
        let beyond: Vec<f64> = beyond.take_while(|hz| *hz <= TAIL_END_HZ).collect();
        let shares = beyond.iter().map(|hz| (last_hz / hz).powi(5));
        let frequencies_hz = self.frequencies_hz.iter().chain(&beyond).copied().collect();
        let mut energy = self.energy.clone();
        let extend = |density: &mut Vec<f64>, columns: usize| {
            let last = density[density.len() - columns..].to_vec();
            density.extend(shares.clone().flat_map(|share| last.iter().map(move |value| share * value)));
        };
        match &mut energy {
            Energy::Missing | Energy::Calm => {}
            Energy::Omnidirectional { density } | Energy::Undirected { density, .. } => extend(density, 1),
            Energy::Moments { density, moments } => {
                extend(density, 1);
                moments.extend(shares.clone().map(|_| None));
            }
            Energy::Directional { toward_rad, density } => extend(density, toward_rad.len()),
        }
        MeasuredSea { frequencies_hz, energy, ..self.clone() }
    }

    /// S(f) in m²/Hz of each frequency, over all directions; empty without waves.
    fn density_m2phz(&self) -> Cow<'_, [f64]> {
        match &self.energy {
            Energy::Missing | Energy::Calm => Cow::Borrowed(&[]),
            Energy::Omnidirectional { density }
            | Energy::Undirected { density, .. }
            | Energy::Moments { density, .. } => Cow::Borrowed(density),
            Energy::Directional { toward_rad, density } => {
                let step = quadrature::direction_step(toward_rad);
                let of_frequency = |row: &[f64]| row.iter().sum::<f64>() * step;
                density.chunks_exact(toward_rad.len().max(1)).map(of_frequency).collect()
            }
        }
    }

    /// The directional spectrum over water with this dispersion.
    ///
    /// A frequency whose directions are missing takes those of the nearest frequency that has them.
    ///
    /// # Errors
    ///
    /// If the record is without waves, if `directions` says what the file says, or does not say what it must.
    pub fn spectrum(
        &self,
        directions: &Directions,
        water: &Dispersion,
    ) -> Result<Tabulated, MeasuredProblem> {
        let Directions { method, from_deg, cos2s } = *directions;
        let parameters = match &self.energy {
            Energy::Missing => return Err(self.without_waves("every value is missing")),
            Energy::Calm => return Err(self.without_waves("every value is 0")),
            Energy::Omnidirectional { density } | Energy::Undirected { density, .. } => {
                let from_deg = from_deg.ok_or_else(|| self.without_directions())?;
                if method.is_some() {
                    return Err(MeasuredProblem::NoMoments);
                }
                let shape = cos2s_distribution(cos2s.unwrap_or(DEFAULT_COS2S), toward_rad(from_deg));
                let shape = sampled(shape, DIRECTIONS);
                self.spread(density, |_| shape.clone())
            }
            Energy::Moments { density, moments } => {
                has_none("from_deg", from_deg.is_some())?;
                has_none("cos2s", cos2s.is_some())?;
                let method = method.unwrap_or_default();
                let known = nearest_known(&self.frequencies_hz, moments);
                self.spread(density, |i| sampled(known[i].distribution(method), DIRECTIONS))
            }
            Energy::Directional { toward_rad, density } => {
                has_none("from_deg", from_deg.is_some())?;
                has_none("cos2s", cos2s.is_some())?;
                has_none("direction_method", method.is_some())?;
                let (toward_rad, density) = quadrature::with_closed_sector(toward_rad, density);
                TabulatedParameters { frequencies_hz: self.frequencies_hz.to_vec(), toward_rad, density }
            }
        };
        Tabulated::new(parameters, water).map_err(MeasuredProblem::NoSpectrum)
    }

    /// Whether there is anything to be seen.
    pub fn has_waves(&self) -> bool {
        !matches!(self.energy, Energy::Missing | Energy::Calm)
    }

    /// The file beside it that should have its directions and has not.
    pub fn lacking_directions(&self) -> Option<&str> {
        match &self.energy {
            Energy::Undirected { lacking, .. } => Some(lacking),
            _ => None,
        }
    }

    fn without_directions(&self) -> MeasuredProblem {
        match (self.lacking_directions(), self.time) {
            (Some(lacking), Some(time)) => {
                MeasuredProblem::NoDirectionsThen { lacking: lacking.to_owned(), time: time.to_string() }
            }
            _ => MeasuredProblem::NoDirections,
        }
    }

    fn without_waves(&self, why: &'static str) -> MeasuredProblem {
        let which = match self.time {
            Some(time) => format!("the record of {time} is"),
            None => "the record is".to_owned(),
        };
        MeasuredProblem::NoWaves { which, why }
    }

    fn spread(&self, density: &[f64], shape: impl Fn(usize) -> Vec<f64>) -> TabulatedParameters {
        let rows = density.iter().enumerate().flat_map(|(i, s)| {
            let row = if *s > 0.0 { shape(i) } else { vec![0.0; DIRECTIONS] };
            row.into_iter().map(move |d| s * d)
        });
        TabulatedParameters {
            density: rows.collect(),
            frequencies_hz: self.frequencies_hz.to_vec(),
            toward_rad: even_directions(DIRECTIONS),
        }
    }
}

fn has_none(key: &'static str, is_there: bool) -> Result<(), MeasuredProblem> {
    if is_there { Err(MeasuredProblem::HasDirections { key }) } else { Ok(()) }
}

/// The moments of each frequency, or of the nearest that has them.
fn nearest_known(frequencies_hz: &[f64], moments: &[Option<DirectionalMoments>]) -> Vec<DirectionalMoments> {
    let known: Vec<_> =
        frequencies_hz.iter().zip(moments).filter_map(|(hz, moments)| Some((*hz, (*moments)?))).collect();
    let nearest = |hz: f64| {
        let by_distance = |a: &&(f64, DirectionalMoments), b: &&(f64, DirectionalMoments)| {
            (a.0 - hz).abs().total_cmp(&(b.0 - hz).abs())
        };
        let no_direction =
            DirectionalMoments { r1: 0.0, mean_toward_rad: 0.0, r2: 0.0, principal_toward_rad: 0.0 };
        known.iter().min_by(by_distance).map_or(no_direction, |known| known.1)
    };
    frequencies_hz.iter().map(|hz| nearest(*hz)).collect()
}

/// The direction of travel, in radians from east towards south, of waves from a bearing in degrees clockwise
/// from north: from north they go south, a quarter turn from east.
pub(super) fn toward_rad(from_deg: f64) -> f64 {
    ((from_deg % 360.0).to_radians() + FRAC_PI_2) % TAU
}
