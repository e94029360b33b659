//! Settings of a sea drawn from spectra and moved by a Fourier transform.

use std::f64::consts::TAU;

use glam::DVec2;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::{self, CascadeBudget, SpectralSea, SpectralSeaParameters, Water};
use whitecap_waves::spectrum::{Profile, WaveSpectrum};
use whitecap_waves::statistics::significant_height_m;

use super::cascade::{self, CASCADES, Cascade};
use super::system::{self, SYSTEMS, System, metres};
use super::{SeaModel, SeaSurface, fitting};
use crate::error::SceneError;
use crate::key::{Count, Flag, OneOf, PowerOfTwo, Real, optional, or, required, table, words};
use crate::reader::TableReader;
use crate::registry::Registered;

pub(super) const REGISTERED: Registered<SeaModel> = Registered {
    word: "spectral",
    summary: "waves drawn from spectra and transformed on periodic tiles (Tessendorf)",
    keys: SpectralSettings::keys,
    read: |table| SpectralSettings::read_checked(table).map(SeaModel::Spectral),
};

words! {
    /// How the waves' amplitudes are drawn.
    pub enum Amplitudes {
        /// Every wave has the amplitude that its spectrum says; only phases are random.
        Deterministic = "deterministic",
        /// Amplitudes are random too, as in nature: the significant height varies from seed to seed.
        Gaussian = "gaussian",
    }
}

table! {
    /// A sea drawn from spectra: the table `[sea]` with `model = "spectral"`.
    pub struct SpectralSettings {
        /// The depth of the water: waves longer than twice of it feel the bottom.
        depth_m: Option<f64> = optional(Real { unit: "m", min: 0.1, max: 12_000.0 }, "deeper than any wave feels");
        /// Whether surface tension quickens the waves below 10 cm.
        surface_tension: bool = or(Flag, false);
        /// The speed of a uniform current, which carries the waves with it.
        current_mps: f64 = or(Real { unit: "m/s", min: 0.0, max: 15.0 }, 0.0);
        /// The bearing that the current runs towards, clockwise from north: as currents are named.
        current_toward_deg: f64 = or(Real { unit: "deg", min: 0.0, max: 360.0 }, 0.0);
        /// After what time the motion repeats without a seam.
        loop_s: Option<f64> = optional(Real { unit: "s", min: 1.0, max: 1e6 }, "never");
        /// The most tiles that share the spectrum out among them, each with the waves that are too short for the one
        /// before.
        cascades: Option<u32> = optional(Count { min: 1, max: 8 }, "as many as the technique draws");
        /// The side of the largest tile; one that holds less than two waves of a system's peak is warned of.
        tile_size_m: Option<f64> =
            optional(Real { unit: "m", min: 1.0, max: 100_000.0 }, "eight wavelengths of the longest peak");
        /// How many samples each tile has along a side.
        resolution: Option<u32> = optional(PowerOfTwo { min: 16, max: 2048 }, "the technique's");
        /// The shortest wave that the tiles should reach down to, as far as their number and resolution allow.
        shortest_wave_m: Option<f64> =
            optional(SHORTEST, "0.1 m, or 0.0045 of the camera's height if that is more; shorter where that leaves less than 99.6 % of the energy or 99.5 % of a system's");
        /// The tiles themselves, `[[sea.cascade]]`, in place of the four keys above.
        cascade: Option<Vec<Cascade>> = optional(CASCADES, "chosen by the spectrum");
        /// How far crests are drawn together: 0 leaves them round, 1 is what linear theory says.
        choppiness: f64 = or(Real { unit: "", min: 0.0, max: 3.0 }, 1.0);
        /// How the waves' amplitudes are drawn.
        amplitudes: Amplitudes = or(OneOf::<Amplitudes>::WORDS, Amplitudes::Deterministic);
        /// The wave systems, `[[sea.system]]`; their variances add.
        system: Vec<System> = required(SYSTEMS);
    }
}

/// How many tiles a technique draws, and how it draws them where the scene does not say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tiling {
    /// The most tiles.
    pub cascades: u32,
    /// Samples along a side.
    pub resolution: u32,
    /// The shortest wave that its view shows.
    pub shortest_wave_m: f64,
    /// How many tiles of a plan, the longest, are sewn from patches, which do not repeat.
    pub sewn: usize,
}

impl Tiling {
    /// That of tiles which are seen from close by: what ten samples of a picture taken from eye height show at the
    /// viewer's feet.
    pub const SHORTEST_WAVE_M: f64 = 0.1;

    /// Four pixels of a picture of 720 lines at 45°, straight down: 2 tan 22.5°/720 of the height to a pixel.
    const SHORTEST_OF_HEIGHT: f64 = 0.0045;

    /// The same, seen from so many metres above the sea.
    pub(crate) fn seen_from(self, height_m: f64) -> Self {
        let shortest_wave_m = Self::SHORTEST_WAVE_M.max(Self::SHORTEST_OF_HEIGHT * height_m);
        Self { shortest_wave_m, ..self }
    }

    /// What its view shows of these spectra, but no longer than leaves [`WHOLE`] of each of them and [`WHOLE_SEA`] of all.
    fn shortest_wave_of(&self, spectra: &[Box<dyn WaveSpectrum>]) -> f64 {
        let above_m = |profile: &Profile, share| TAU / profile.wave_number_below(share);
        let profiles: Vec<Profile> = spectra.iter().map(Profile::of).collect();
        let of_each = profiles.iter().map(|profile| above_m(profile, WHOLE));
        let of_all = above_m(&Profile::sum(&profiles), WHOLE_SEA);
        of_each.fold(self.shortest_wave_m.min(of_all), f64::min).max(SHORTEST.min)
    }
}

/// What `shortest_wave_m` may be.
const SHORTEST: Real = Real { unit: "m", min: 0.001, max: 1000.0 };

/// Of a system's energy, what tiles carry whatever the view.
const WHOLE: f64 = 0.995;

/// The same of all systems together. Where the last tile ends is up to 2 % short of the wave that was asked for, by the ratio of
/// tiles that is no whole number: with that, less than 0.5 % is lost.
const WHOLE_SEA: f64 = 0.996;

/// A loop that changes the period of a peak by more than this share is worth a warning.
const LOOPED: f64 = 0.05;

/// Less of a system than this on the tiles is worth a warning: its height is 1 % lower than was asked for.
pub(super) const FULL: f64 = 0.98;

/// A tile that is asked for and holds fewer waves of a system's peak is worth a warning: they have few lengths and directions,
/// and one sees them repeat.
pub(super) const LEAST_PEAK_WAVES: f64 = 2.0;

impl SpectralSettings {
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let settings = Self::read_keys(table)?;
        let planned = ["cascades", "tile_size_m", "resolution", "shortest_wave_m"];
        if let (Some(_), Some(key)) = (&settings.cascade, planned.into_iter().find(|key| table.has(key))) {
            return Err(table.error(
                Some(key),
                "beside [[sea.cascade]]; accepted: one of the two, tiles one by one or a plan for them",
            ));
        }
        if let Some(problem) = settings.cascade.as_deref().and_then(cascade::overlap) {
            return Err(table.error(Some("cascade"), problem));
        }
        // Where it says what would be so without it, it does no harm.
        if settings.current_toward_deg != 0.0 && !table.has("current_mps") {
            return Err(table.error(
                Some("current_toward_deg"),
                "without current_mps; accepted: both or none of them, as a current has a speed",
            ));
        }
        Ok(settings)
    }

    /// Refuses more tiles than `technique` draws.
    pub(super) fn check(
        &self,
        table: &TableReader<'_>,
        technique: &str,
        tiling: &Tiling,
    ) -> Result<(), SceneError> {
        let (key, count) = match &self.cascade {
            Some(list) => ("cascade", list.len() as u32),
            None => ("cascades", self.cascades.unwrap_or(1)),
        };
        if count > tiling.cascades {
            return Err(table.error(
                Some(key),
                format!(
                    "more tiles than technique = \"{technique}\" draws; accepted: 1 to {}",
                    tiling.cascades
                ),
            ));
        }
        Ok(())
    }

    /// What the waves run in.
    ///
    /// # Errors
    ///
    /// If the depth is out of its range, which that of a scene file is not.
    pub fn water(&self) -> Result<Water, SceneError> {
        let dispersion = Dispersion::at_depth(self.depth_m.unwrap_or(f64::INFINITY))
            .map_err(|error| SceneError::about_key("sea.depth_m", error.to_string()))?;
        // A bearing that is gone towards, not come from.
        let toward = -whitecap_waves::direction::toward_from_nautical(self.current_toward_deg);
        Ok(Water {
            dispersion: if self.surface_tension { dispersion.with_surface_tension() } else { dispersion },
            current_mps: if self.current_mps > 0.0 { self.current_mps * toward } else { DVec2::ZERO },
            loop_s: self.loop_s,
        })
    }

    /// The spectra of the wave systems, in their order.
    ///
    /// # Errors
    ///
    /// If the settings of a system contradict each other, or the systems together are higher than a sea can be.
    pub fn spectra(&self) -> Result<Vec<Box<dyn WaveSpectrum>>, SceneError> {
        let dispersion = self.water()?.dispersion;
        let spectrum =
            |(index, system): (usize, &System)| system.build(&format!("sea.system[{index}]"), &dispersion);
        let spectra = self.system.iter().enumerate().map(spectrum).collect::<Result<Vec<_>, _>>()?;
        system::check_sum(&spectra)?;
        Ok(spectra)
    }

    /// The tiles for a sea of these spectra, drawn by a technique with this tiling.
    pub fn cascades(&self, spectra: &[Box<dyn WaveSpectrum>], tiling: &Tiling) -> Vec<spectral::Cascade> {
        match &self.cascade {
            Some(list) => cascade::tiles(list),
            None => spectral::Cascade::plan(
                spectra,
                CascadeBudget {
                    tile_size_m: self.tile_size_m,
                    shortest_wave_m: self.shortest_wave_m.unwrap_or_else(|| tiling.shortest_wave_of(spectra)),
                    cascades: self.cascades.unwrap_or(tiling.cascades) as usize,
                    resolution: self.resolution.unwrap_or(tiling.resolution) as usize,
                },
            ),
        }
    }

    /// Changes a plan to these tiles, and says how many of its keys that takes.
    pub(super) fn replan(
        &mut self,
        cascades: u32,
        resolution: u32,
        tile_size_m: Option<f64>,
        shortest_wave_m: Option<f64>,
        tiling: &Tiling,
    ) -> u64 {
        let mut changed = 0;
        if cascades != self.cascades.unwrap_or(tiling.cascades) {
            self.cascades = Some(cascades);
            changed += 1;
        }
        if resolution != self.resolution.unwrap_or(tiling.resolution) {
            self.resolution = Some(resolution);
            changed += 1;
        }
        if tile_size_m != self.tile_size_m {
            self.tile_size_m = tile_size_m;
            changed += 1;
        }
        if shortest_wave_m != self.shortest_wave_m {
            self.shortest_wave_m = shortest_wave_m;
            changed += 1;
        }
        changed
    }

    pub(super) fn build(&self, tiling: &Tiling, seed: u64) -> Result<SeaSurface, SceneError> {
        let sea = self.sea_of(&self.spectra()?, tiling, seed)?;
        Ok(SeaSurface::Spectral(Box::new(sea)))
    }

    fn sea_of(
        &self,
        spectra: &[Box<dyn WaveSpectrum>],
        tiling: &Tiling,
        seed: u64,
    ) -> Result<SpectralSea, SceneError> {
        let parameters = SpectralSeaParameters {
            cascades: self.cascades(spectra, tiling),
            choppiness: self.choppiness,
            water: self.water()?,
            seed,
            amplitudes: match self.amplitudes {
                Amplitudes::Deterministic => spectral::Amplitudes::Deterministic,
                Amplitudes::Gaussian => spectral::Amplitudes::Gaussian,
            },
        };
        let sea = SpectralSea::new(parameters, spectra)
            .map_err(|error| fitting::problem(self, spectra, tiling, &error))?;
        // Who lays the tiles out gets them as they are.
        Ok(if self.cascade.is_some() { sea } else { sea.sewn(tiling.sewn) })
    }

    /// Where the sea of these settings bends what was asked for: one sentence each.
    pub(super) fn warnings(&self, tiling: &Tiling, seed: u64) -> Result<Vec<String>, SceneError> {
        let spectra = self.spectra()?;
        let sea = &self.sea_of(&spectra, tiling, seed)?;
        let captured = sea.captured_fractions().into_iter().zip(spectra.iter().map(|spectrum| &**spectrum));
        let lost = |(index, (captured, spectrum)): (usize, (f64, &dyn WaveSpectrum))| {
            if captured >= FULL {
                return None;
            }
            let [asked_m, there_m] =
                [1.0, captured].map(|part| significant_height_m(part * spectrum.variance_m2()));
            Some(format!(
                "sea.system[{index}]: its tiles carry {:.1} % of its energy, {} m of {} m of significant height: {}",
                100.0 * captured,
                metres(there_m, 2),
                metres(asked_m, 2),
                fitting::remedy(self, &spectra, tiling, sea, &Profile::of(&spectrum)),
            ))
        };
        let dispersion = &sea.parameters().water.dispersion;
        let of_one: Vec<Vec<String>> = self
            .system
            .iter()
            .zip(&spectra)
            .map(|(system, spectrum)| system.warnings(dispersion, spectrum))
            .collect();
        let of_sum = system::warnings_of_sum(&spectra, dispersion, &of_one.concat());
        let of_sum = of_sum.into_iter().map(|warning| format!("sea.system, all together: {warning}"));
        let unusual = of_one.into_iter().enumerate().flat_map(|(index, warnings)| {
            warnings.into_iter().map(move |warning| format!("sea.system[{index}]: {warning}"))
        });
        let water = &sea.parameters().water;
        // What only loops and currents bend.
        let is_moved = self.loop_s.is_some() || self.current_mps > 0.0;
        let moved = if is_moved { spectra.as_slice() } else { &[] };
        let peaks: Vec<f64> = moved.iter().map(|spectrum| Profile::of(spectrum).peak_wave_number()).collect();
        let looped = peaks.iter().enumerate().flat_map(|(index, peak)| self.looped(index, *peak, water));
        let against = peaks.iter().zip(&self.system).enumerate().filter_map(|(index, (peak, system))| {
            self.against_the_current(index, system.requested().from_deg?, *peak, water)
        });
        Ok(unusual
            .chain(of_sum)
            .chain(captured.enumerate().filter_map(lost))
            .chain(fitting::few_waves(self, &spectra, sea))
            .chain(fitting::few_directions(self, &spectra, sea))
            .chain(looped)
            .chain(against)
            .collect())
    }

    /// Waves whose energy a current that sets against them carries back: none could have come.
    fn against_the_current(&self, index: usize, from_deg: f64, peak: f64, water: &Water) -> Option<String> {
        let angle = (self.current_toward_deg - from_deg).to_radians();
        let (against_mps, group_mps) = (self.current_mps * angle.cos(), water.dispersion.group_speed(peak));
        (against_mps > group_mps).then(|| {
            format!(
                "current_mps = {}: it sets against sea.system[{index}] with {against_mps:.1} m/s, faster than the energy of \
                 its peak runs, {group_mps:.1} m/s; no such waves come against it",
                self.current_mps
            )
        })
    }

    /// What the loop does to the waves of a system's peak and to the current that carries them: both come to whole
    /// turns, so each moves by up to half a turn to a loop.
    fn looped(&self, index: usize, peak: f64, water: &Water) -> Vec<String> {
        let Some(loop_s) = self.loop_s else { return Vec::new() };
        let period_s = TAU / water.dispersion.angular_frequency(peak);
        let mut warnings = Vec::new();
        let moved = 0.5 * period_s / loop_s;
        if moved > LOOPED {
            warnings.push(format!(
                "loop_s = {loop_s}: to close, it changes the periods of sea.system[{index}] by up to {:.0} % at the \
                 peak; loops of {:.0} s or more change them by less than {:.0} %",
                100.0 * moved,
                (0.5 * period_s / LOOPED).ceil(),
                100.0 * LOOPED
            ));
        }
        // Waves along the current, which it carries the furthest.
        let turns_per_s = peak * self.current_mps / TAU;
        let carried = turns_per_s * loop_s;
        if carried > 0.0 && 0.5 / carried > LOOPED {
            let what = match carried < 0.5 {
                true => "takes the current from".to_owned(),
                false => format!("changes the current by up to {:.0} % for", 50.0 / carried),
            };
            warnings.push(format!(
                "loop_s = {loop_s}: to close, it {what} the waves of the peak of sea.system[{index}], which current_mps \
                 = {} carries {carried:.2} of their lengths in a loop; loops of {:.0} s or more change it by less than \
                 {:.0} %",
                self.current_mps,
                (0.5 / LOOPED / turns_per_s).ceil(),
                100.0 * LOOPED
            ));
        }
        warnings
    }
}
