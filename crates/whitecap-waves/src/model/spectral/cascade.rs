//! Sharing out a sea's waves among tiles.
//!
//! Symbols as in the [module above](super).

use super::band::Band;
use crate::spectrum::{Profile, WaveSpectrum};
use std::f64::consts::TAU;

/// One tile of a sea, and the waves that it carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cascade {
    /// L in metres.
    pub tile_size_m: f64,
    /// N.
    pub resolution: usize,
    /// Its wave numbers.
    pub band: Band,
}

/// One tile of a sea, and what is asked of its band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CascadeRequest {
    /// L in metres.
    pub tile_size_m: f64,
    /// N.
    pub resolution: usize,
    /// The longest of its waves in metres; `None` for those that are too short for the tiles before it.
    pub longest_wave_m: Option<f64>,
    /// Where its waves end, in metres; `None` for those of four samples, or for where the next tile's are asked to begin.
    pub shortest_wave_m: Option<f64>,
}

/// What a plan of cascades has to keep to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CascadeBudget {
    /// The side of the first tile in metres; `None` for eight wavelengths of the longest peak.
    pub tile_size_m: Option<f64>,
    /// The shortest wave that is wanted, in metres: what a viewer can still see, or a hull feel.
    pub shortest_wave_m: f64,
    /// The most tiles, 1 to 8.
    pub cascades: usize,
    /// N of each tile.
    pub resolution: usize,
}

/// How many of the longest system's wavelengths the first tile holds: enough that its peak is drawn by dozens of
/// waves, in many directions.
const PEAK_WAVELENGTHS: f64 = 8.0;

/// A system of a smaller share of the energy does not decide how large the first tile is.
const LEAST_SHARE: f64 = 1e-3;

/// Waves are at least so many samples long, on every tile that has a finer one beneath it, so that a surface between
/// the samples is smooth.
const SAMPLES_PER_WAVE: f64 = 4.0;

/// A tile holds at least so many of its longest waves: with fewer, one sees them repeat.
const LEAST_WAVES: f64 = 6.0;

impl Cascade {
    /// The most tiles of a sea.
    pub const MOST: usize = 8;

    /// One tile that carries all waves of its lattice.
    pub fn whole(tile_size_m: f64, resolution: usize) -> Self {
        Self { tile_size_m, resolution, band: Band::WHOLE }
    }

    /// The tiles of these lengths in metres and resolutions, the longest first, each with the waves that are too
    /// short for the ones before it. A wave is at least four samples long, but for those of a lone tile, which
    /// carries its whole lattice.
    pub fn split(tiles: &[(f64, usize)]) -> Vec<Self> {
        let request = |&(tile_size_m, resolution): &(f64, usize)| CascadeRequest {
            tile_size_m,
            resolution,
            longest_wave_m: None,
            shortest_wave_m: None,
        };
        Self::of_requests(&tiles.iter().map(request).collect::<Vec<_>>())
    }

    /// The same with bands that are given in part, or all. What is given is taken as it is: it may leave waves out, and carry
    /// others twice.
    pub fn of_requests(requests: &[CascadeRequest]) -> Vec<Self> {
        let mut requests = requests.to_vec();
        requests.sort_by(|a, b| b.tile_size_m.total_cmp(&a.tile_size_m));
        let mut ended = 0.0;
        let cascade = |(index, request): (usize, &CascadeRequest)| {
            let &CascadeRequest { tile_size_m, resolution, longest_wave_m, shortest_wave_m } = request;
            let from = longest_wave_m.map_or(ended, |wave_m| TAU / wave_m);
            let smooth = || match requests.len() {
                1 => f64::INFINITY,
                _ => TAU * resolution as f64 / (SAMPLES_PER_WAVE * tile_size_m),
            };
            let next = requests.get(index + 1).and_then(|next| next.longest_wave_m);
            let by_itself = || smooth().min(next.map_or(f64::INFINITY, |wave_m| TAU / wave_m)).max(from);
            let to = shortest_wave_m.map_or_else(by_itself, |wave_m| TAU / wave_m);
            ended = to;
            Self { tile_size_m, resolution, band: Band { from, to } }
        };
        requests.iter().enumerate().map(cascade).collect()
    }

    /// Tiles for a sea of these systems: the first holds eight wavelengths of the longest peak, and as few more as
    /// the budget allows reach down to its shortest wave, or to that of the systems; fewer waves where the budget does not reach so far.
    ///
    /// Lengths are in a ratio that has no small whole multiple, so that the sum of tiles shows no repeat.
    pub fn plan<S: WaveSpectrum>(systems: &[S], budget: CascadeBudget) -> Vec<Self> {
        let profiles: Vec<Profile> = systems.iter().map(Profile::of).collect();
        let first = budget.tile_size_m.unwrap_or_else(|| by_the_peak(systems, &profiles));
        let n = budget.resolution;
        let waves_per_tile = n as f64 / SAMPLES_PER_WAVE;
        // Below the shortest wave that there is, a tile would be empty.
        let shortest_m = budget.shortest_wave_m.max(TAU / Profile::sum(&profiles).last_wave_number());
        let span = (first / (waves_per_tile * shortest_m)).max(1.0);
        let most = (waves_per_tile / LEAST_WAVES).max(1.5);
        let wanted = 1 + (span.ln() / most.ln()).ceil() as usize;
        let count = wanted.clamp(1, budget.cascades.clamp(1, Self::MOST));
        if count == 1 {
            return vec![Self::whole(first, n)];
        }
        // The golden ratio's hundredth keeps a whole ratio off whole numbers.
        let ratio = span.powf(1.0 / (count - 1) as f64).clamp(1.5, most) * 0.993_819_66;
        let tiles: Vec<_> = (0..count).map(|i| (first / ratio.powi(i as i32), n)).collect();
        Self::split(&tiles)
    }
}

/// The side in metres of a tile for the longest of these systems, whose profiles are given.
fn by_the_peak<S: WaveSpectrum>(systems: &[S], profiles: &[Profile]) -> f64 {
    let total: f64 = systems.iter().map(WaveSpectrum::variance_m2).sum();
    let counts =
        systems.iter().zip(profiles).filter(|(system, _)| system.variance_m2() > LEAST_SHARE * total);
    let longest = counts.map(|(_, profile)| TAU / profile.peak_wave_number()).fold(0.0, f64::max);
    // A flat sea has no peak.
    if longest > 0.0 { (PEAK_WAVELENGTHS * longest).ceil() } else { 100.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::phillips::{Phillips, PhillipsParameters};
    use glam::DVec2;

    fn wind_sea(wind_speed_mps: f64) -> Phillips {
        Phillips::new(PhillipsParameters {
            wind_speed_mps,
            toward: DVec2::X,
            significant_height_m: None,
            opposing_energy: 0.0,
            small_wave_cutoff_m: 0.0,
        })
        .unwrap()
    }

    const BUDGET: CascadeBudget =
        CascadeBudget { tile_size_m: None, shortest_wave_m: 0.05, cascades: 4, resolution: 256 };

    #[test]
    fn bands_meet_without_gap_or_overlap() {
        for cascades in [
            Cascade::split(&[(37.0, 128), (400.0, 256), (5.0, 64)]),
            Cascade::plan(&[wind_sea(10.0)], BUDGET),
            Cascade::plan(&[wind_sea(3.0), wind_sea(20.0)], BUDGET),
        ] {
            assert_eq!(cascades[0].band.from, 0.0);
            for pair in cascades.windows(2) {
                assert_eq!(pair[0].band.to, pair[1].band.from);
                assert!(pair[0].tile_size_m > pair[1].tile_size_m);
            }
            for cascade in cascades {
                let samples = TAU / cascade.band.to / (cascade.tile_size_m / cascade.resolution as f64);
                assert!((samples - 4.0).abs() < 1e-9, "{cascade:?}");
            }
        }
    }

    #[test]
    fn a_plan_reaches_from_the_peak_to_the_shortest_wave() {
        let cascades = Cascade::plan(&[wind_sea(2.0), wind_sea(15.0)], BUDGET);
        let peak = TAU / Profile::of(&wind_sea(15.0)).peak_wave_number();
        assert!((cascades[0].tile_size_m / peak / 8.0 - 1.0).abs() < 0.01);
        let shortest = TAU / cascades.last().unwrap().band.to;
        assert!((0.03..0.06).contains(&shortest), "{shortest}");
        for pair in cascades.windows(2) {
            let longest_waves = pair[1].tile_size_m * pair[1].band.from / TAU;
            assert!(longest_waves >= 6.0, "{longest_waves}");
        }
    }

    /// Four samples to a wave where nothing is given, and where it is, what is given; the next tile takes up what is left.
    #[test]
    fn bands_are_taken_as_they_are_given() {
        let request = |tile_size_m, longest_wave_m, shortest_wave_m| CascadeRequest {
            tile_size_m,
            resolution: 64,
            longest_wave_m,
            shortest_wave_m,
        };
        let waves_m = |requests: &[CascadeRequest]| {
            let of = |cascade: &Cascade| [TAU / cascade.band.from, TAU / cascade.band.to].map(|m| m as f32);
            Cascade::of_requests(requests).iter().map(of).collect::<Vec<_>>()
        };
        let (none, all) = (None, f32::INFINITY);
        assert_eq!(waves_m(&[request(160.0, none, none)]), [[all, 0.0]]);
        assert_eq!(waves_m(&[request(160.0, Some(90.0), Some(7.0))]), [[90.0, 7.0]]);
        assert_eq!(
            waves_m(&[request(32.0, none, none), request(160.0, none, Some(6.0))]),
            [[all, 6.0], [6.0, 2.0]]
        );
        assert_eq!(
            waves_m(&[request(160.0, none, none), request(32.0, Some(15.0), Some(4.0))]),
            [[all, 15.0], [15.0, 4.0]]
        );
        // A gap, which nothing fills.
        assert_eq!(
            waves_m(&[request(160.0, none, none), request(32.0, Some(8.0), none)]),
            [[all, 10.0], [8.0, 2.0]]
        );
    }

    /// A swell of a fiftieth of the height, 0.04 % of the energy, is none to size a tile by; one of a tenth, 1 %, is.
    #[test]
    fn a_swell_of_a_thousandth_of_the_energy_decides_the_first_tile() {
        let of_height = |wind_speed_mps, height_m| {
            Phillips::new(PhillipsParameters {
                wind_speed_mps,
                toward: DVec2::X,
                significant_height_m: Some(height_m),
                opposing_energy: 0.0,
                small_wave_cutoff_m: 0.0,
            })
            .unwrap()
        };
        let first = |swell_m| {
            let systems = [of_height(6.0, 1.0), of_height(18.0, swell_m)];
            let [wind_sea, swell] = systems.map(|system| TAU / Profile::of(&system).peak_wave_number());
            (Cascade::plan(&systems, BUDGET)[0].tile_size_m, 8.0 * wind_sea, 8.0 * swell)
        };
        for swell_m in [0.02, 0.03, 0.034, 0.1, 0.3, 0.45] {
            let (found, by_wind_sea, by_swell) = first(swell_m);
            let expected = if swell_m * swell_m > 1.1e-3 { by_swell } else { by_wind_sea };
            assert!((found / expected - 1.0).abs() < 0.02, "{swell_m} m: {found} instead of {expected}");
        }
    }

    #[test]
    fn a_plan_takes_no_more_tiles_than_it_needs() {
        let few = Cascade::plan(&[wind_sea(10.0)], CascadeBudget { shortest_wave_m: 4.0, ..BUDGET });
        assert_eq!(few.len(), 2);
        let one = Cascade::plan(&[wind_sea(10.0)], CascadeBudget { shortest_wave_m: 100.0, ..BUDGET });
        assert_eq!(one.len(), 1);
        let short_of_money = Cascade::plan(&[wind_sea(20.0)], CascadeBudget { cascades: 2, ..BUDGET });
        assert_eq!(short_of_money.len(), 2);
        let given = Cascade::plan(&[wind_sea(20.0)], CascadeBudget { tile_size_m: Some(77.0), ..BUDGET });
        assert_eq!(given[0].tile_size_m, 77.0);
        // A spectrum with an end: no tile beneath it.
        let cut = Phillips::new(PhillipsParameters {
            wind_speed_mps: 10.0,
            toward: DVec2::X,
            significant_height_m: None,
            opposing_energy: 0.0,
            small_wave_cutoff_m: 1.0,
        });
        let cut = cut.unwrap();
        let (ends, profile) = (Cascade::plan(&[cut], BUDGET), Profile::of(&cut));
        assert!(ends.len() < Cascade::plan(&[wind_sea(10.0)], BUDGET).len(), "{ends:?}");
        assert!(ends.iter().all(|tile| profile.variance_m2(tile.band) > 0.0), "{ends:?}");
        let flat: [Phillips; 0] = [];
        assert_eq!(Cascade::plan(&flat, BUDGET)[0].tile_size_m, 100.0);
    }
}
