//! One of the tiles of a spectral sea: a table `[[sea.cascade]]`.

use std::f64::consts::TAU;

use whitecap_waves::model::spectral::{self, Band, CascadeRequest};
use whitecap_waves::spectrum::Profile;

use crate::error::SceneError;
use crate::key::{Key, PowerOfTwo, Real, Tables, optional, or, required, table};
use crate::reader::TableReader;

table! {
    /// A tile: a table `[[sea.cascade]]`. Each carries the waves that are too short for the next larger one.
    pub struct Cascade {
        /// The side of the square after which its waves repeat.
        tile_size_m: f64 = required(Real { unit: "m", min: 1.0, max: 100_000.0 });
        /// How many samples it has along a side.
        resolution: u32 = or(PowerOfTwo { min: 16, max: 2048 }, 256);
        /// The longest of its waves, at most as long as its side.
        longest_wave_m: Option<f64> = optional(WAVE, "where those of the next larger tile end");
        /// Where its waves end, at two samples or more.
        shortest_wave_m: Option<f64> =
            optional(WAVE, "four samples, or where those of the next smaller tile are said to begin; two samples of a lone tile");
    }
}

const WAVE: Real = Real { unit: "m", min: 0.001, max: 100_000.0 };

/// Ends that are written in metres meet to rounding.
const ROUNDED: f64 = 1e-5;

/// The keys of a cascade.
pub(crate) const KEYS: fn() -> Vec<Key> = Cascade::keys;

/// One to eight tiles.
pub(super) const CASCADES: Tables<Cascade> =
    Tables { name: "sea.cascade", min: 1, max: 8, read: Cascade::read_checked };

impl Cascade {
    fn read_checked(table: &TableReader<'_>) -> Result<Self, SceneError> {
        let tile = Self::read(table)?;
        let Band { from, to } = Band::of_tile(tile.tile_size_m, tile.resolution as usize);
        for (key, wave_m) in
            [("longest_wave_m", tile.longest_wave_m), ("shortest_wave_m", tile.shortest_wave_m)]
        {
            // To rounding: the ends themselves are held.
            let is_held = |wave_m: f64| TAU / wave_m >= 0.999_999 * from && TAU / wave_m <= 1.000_001 * to;
            if wave_m.is_some_and(|wave_m| !is_held(wave_m)) {
                let problem = format!(
                    "not held by this tile; {} m with {} samples a side hold waves from {} to {0} m",
                    tile.tile_size_m,
                    tile.resolution,
                    metres(TAU / to),
                );
                return Err(table.error(Some(key), problem));
            }
        }
        if let (Some(longest_m), Some(shortest_m)) = (tile.longest_wave_m, tile.shortest_wave_m)
            && longest_m <= shortest_m
        {
            let problem = format!("less than longest_wave_m is accepted, {longest_m} m");
            return Err(table.error(Some("shortest_wave_m"), problem));
        }
        Ok(tile)
    }

    fn request(&self) -> CascadeRequest {
        CascadeRequest {
            tile_size_m: self.tile_size_m,
            resolution: self.resolution as usize,
            longest_wave_m: self.longest_wave_m,
            shortest_wave_m: self.shortest_wave_m,
        }
    }
}

/// The tiles of these tables, the largest first.
pub(super) fn tiles(tables: &[Cascade]) -> Vec<spectral::Cascade> {
    spectral::Cascade::of_requests(&tables.iter().map(Cascade::request).collect::<Vec<_>>())
}

/// The numbers of the tables in the order of their tiles.
pub(super) fn order(tables: &[Cascade]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..tables.len()).collect();
    order.sort_by(|&a, &b| tables[b].tile_size_m.total_cmp(&tables[a].tile_size_m));
    order
}

/// Why bands do not share waves out: two tables carry the same ones, or one has none left.
pub(super) fn overlap(tables: &[Cascade]) -> Option<String> {
    if tables.iter().all(|tile| tile.longest_wave_m.is_none() && tile.shortest_wave_m.is_none()) {
        return None;
    }
    let (tiles, order) = (tiles(tables), order(tables));
    let waves = |Band { from, to }: Band| format!("{} to {} m", metres(TAU / to), metres(TAU / from));
    for (i, tile) in tiles.iter().enumerate() {
        for (j, other) in tiles.iter().enumerate().skip(i + 1) {
            let Band { from, to } = tile.band;
            let both = Band { from: from.max(other.band.from), to: to.min(other.band.to) };
            if both.from < both.to * (1.0 - ROUNDED) {
                return Some(format!(
                    "sea.cascade[{}] and sea.cascade[{}] both carry waves from {}, whose energy would count twice; accepted: \
                     bands apart, by longest_wave_m and shortest_wave_m",
                    order[i],
                    order[j],
                    waves(both)
                ));
            }
        }
        if tile.band.from >= tile.band.to {
            return Some(format!(
                "sea.cascade[{}] has no waves left from {} m down, where the tiles before it end; accepted: bands apart, by \
                 longest_wave_m and shortest_wave_m",
                order[i],
                metres(TAU / tile.band.from)
            ));
        }
    }
    None
}

/// Of a sea's energy what the bands that are said leave out: the waves, and which keys do.
pub(super) struct Gap {
    /// The wave numbers in rad/m.
    pub(super) band: Band,
    /// "`sea.cascade[1].longest_wave_m` = …", to hold them.
    pub(super) remedy: String,
}

/// The waves that are in no band, or in that of a tile which cannot hold them, between the largest tile's longest and the
/// smallest one's shortest.
pub(super) fn gaps(tables: &[Cascade]) -> Vec<Gap> {
    let (tiles, order) = (tiles(tables), order(tables));
    let lattice = |tile: &spectral::Cascade| Band::of_tile(tile.tile_size_m, tile.resolution);
    let (Some(first), Some(last)) = (tiles.first(), tiles.last()) else { return Vec::new() };
    let mut gaps = Vec::new();
    let mut add = |from: f64, to: f64, remedy: String| {
        if from < to * (1.0 - ROUNDED) {
            gaps.push(Gap { band: Band { from, to }, remedy });
        }
    };
    let say = |index: usize, key: &str, wave_m: f64| {
        format!("sea.cascade[{}].{key} = {} holds them", order[index], metres(wave_m))
    };
    if tables[order[0]].longest_wave_m.is_some() {
        add(lattice(first).from, first.band.from, say(0, "longest_wave_m", first.tile_size_m));
    }
    for (i, pair) in tiles.windows(2).enumerate() {
        let end = pair[0].band.to.min(lattice(&pair[0]).to);
        let begin = pair[1].band.from.max(lattice(&pair[1]).from);
        // The smaller tile reaches up to its length, the larger one down to two samples.
        let remedy = if lattice(&pair[1]).from <= end {
            say(i + 1, "longest_wave_m", TAU / end)
        } else if lattice(&pair[0]).to >= begin {
            say(i, "shortest_wave_m", TAU / begin)
        } else {
            "one more [[sea.cascade]] between the two holds them".to_owned()
        };
        add(end, begin, remedy);
    }
    if tables[order[tiles.len() - 1]].shortest_wave_m.is_some() {
        let smooth = last.band.to.max(0.5 * lattice(last).to);
        add(last.band.to, smooth, say(tiles.len() - 1, "shortest_wave_m", TAU / smooth));
    }
    gaps
}

/// The gap that has the most of a system's energy, where it has more than the tiles are too small or too coarse for.
pub(super) fn widest_gap(tables: &[Cascade], profile: &Profile) -> Option<String> {
    let energy_m2 = |gap: &Gap| profile.variance_m2(gap.band);
    let gap = gaps(tables).into_iter().max_by(|a, b| energy_m2(a).total_cmp(&energy_m2(b)))?;
    let tiles = tiles(tables);
    let lattice = |tile: &spectral::Cascade| Band::of_tile(tile.tile_size_m, tile.resolution);
    let (first, last) = (tiles.first()?, tiles.last()?);
    let too_long = Band { from: 0.0, to: lattice(first).from };
    let too_short = Band { from: last.band.to.max(0.5 * lattice(last).to), to: f64::INFINITY };
    let elsewhere_m2 = profile.variance_m2(too_long).max(profile.variance_m2(too_short));
    (energy_m2(&gap) > elsewhere_m2).then(|| {
        let Band { from, to } = gap.band;
        format!(
            "waves from {} to {} m are in no band, {:.1} % of its energy; {}",
            metres(TAU / to),
            metres(TAU / from),
            100.0 * energy_m2(&gap) / profile.variance_m2(Band::WHOLE),
            gap.remedy
        )
    })
}

/// Six digits, so that who writes what is said leaves no gap that counts.
fn metres(wave_m: f64) -> String {
    let decimals = (5.0 - wave_m.max(1e-9).log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{wave_m:.decimals$}");
    if decimals == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
}
