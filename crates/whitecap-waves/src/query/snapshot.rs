//! A spectral sea at one moment, ready for any number of questions.
//!
//! For each tile the waves are transformed onto a grid on which the shortest of them has four samples or more, as
//! coefficients of a spline. The error of such a grid follows from the spectrum, and grids are made finer until it is
//! small enough. A question then costs a few dozen products for each tile, however many waves there are.

use super::{QueryError, check, inverse};
use crate::model::spectral::evolve::{Column, evolve_column, evolve_velocity_column};
use crate::model::spectral::{Patch, Patchwork, SpectralSea, SpectralTile};
use crate::model::{Surface, SurfacePoint, WaveModel, spectral::sample::Sums};
use crate::spline::{self, Taps, error_variance, jet, value};
use crate::statistics::significant_height_m;
use crate::transform::{Complex, InverseReal2d, for_each_run, thread_count};
use glam::{DVec2, DVec3, Vec4};

/// A [`SpectralSea`] at one moment.
///
/// ```
/// # use whitecap_waves::{model::spectral::*, spectrum::phillips::*, direction::toward_from_nautical};
/// # use glam::DVec2;
/// # let spectrum = Phillips::new(PhillipsParameters {
/// #     wind_speed_mps: 10.0, toward: toward_from_nautical(270.0), significant_height_m: Some(2.5),
/// #     opposing_energy: 0.0, small_wave_cutoff_m: 0.0,
/// # })?;
/// use whitecap_waves::query::Snapshot;
///
/// let budget = CascadeBudget { tile_size_m: None, shortest_wave_m: 1.0, cascades: 2, resolution: 64 };
/// let sea = SpectralSea::new(
///     SpectralSeaParameters {
///         cascades: Cascade::plan(&[spectrum], budget),
///         choppiness: 1.0,
///         water: Water::STILL,
///         seed: 7,
///         amplitudes: Amplitudes::Deterministic,
///     },
///     &[spectrum],
/// )?;
/// let mut snapshot = Snapshot::new(&sea);
/// snapshot.take(&sea, 12.5)?;
/// let buoy = snapshot.query(&[DVec2::new(3.0, -40.0)])?[0];
/// println!("{:.3} m high, rising at {:.2} m/s", buoy.displacement_m.y, buoy.velocity_mps.y);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Snapshot {
    tiles: Vec<TileSnapshot>,
    /// What the grids were chosen for.
    sides_for: Vec<Key>,
    current_mps: DVec2,
    time_s: Option<f64>,
}

impl Snapshot {
    /// The memory for a snapshot of `sea`, which is calm until one is [taken](Self::take).
    pub fn new(sea: &SpectralSea) -> Self {
        Self {
            tiles: sea
                .tiles()
                .iter()
                .zip(sides(sea))
                .map(|(tile, side)| TileSnapshot::new(tile, side))
                .collect(),
            sides_for: sea.tiles().iter().map(key).collect(),
            current_mps: sea.parameters().water.current_mps,
            time_s: None,
        }
    }

    /// Brings it to `time_s`. Allocates nothing when it was made for this sea, and makes room otherwise.
    ///
    /// # Errors
    ///
    /// If the time is not finite.
    pub fn take(&mut self, sea: &SpectralSea, time_s: f64) -> Result<(), QueryError> {
        check(&[], time_s)?;
        if !self.sides_for.iter().copied().eq(sea.tiles().iter().map(key)) {
            *self = Self::new(sea);
        }
        for (index, (snapshot, tile)) in self.tiles.iter_mut().zip(sea.tiles()).enumerate() {
            snapshot.take(tile, time_s);
            snapshot.patchwork = sea.patchwork(index);
        }
        self.current_mps = sea.parameters().water.current_mps;
        self.time_s = Some(time_s);
        Ok(())
    }

    /// The moment that it was brought to; `None` before the first.
    pub fn time_s(&self) -> Option<f64> {
        self.time_s
    }

    /// The water over each place (`.x` east, `.y` south, metres), in their order: where it is, relative to where it
    /// rests, with normal, slopes and velocity. The place is the rest point plus the displacement.
    ///
    /// # Errors
    ///
    /// If a place is not finite.
    pub fn query(&self, places_m: &[DVec2]) -> Result<Vec<SurfacePoint>, QueryError> {
        check(places_m, 0.0)?;
        #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
        {
            use rayon::prelude::*;
            Ok(places_m.par_iter().with_min_len(256).map(|place| self.over(*place)).collect())
        }
        #[cfg(not(all(feature = "parallel", not(target_arch = "wasm32"))))]
        Ok(places_m.iter().map(|place| self.over(*place)).collect())
    }

    /// The water that rests at each place, in their order: what a map of displacement holds.
    ///
    /// # Errors
    ///
    /// If a place is not finite.
    pub fn at_rest(&self, rests_m: &[DVec2]) -> Result<Vec<SurfacePoint>, QueryError> {
        check(rests_m, 0.0)?;
        let at_rest = |rest_m: &DVec2| {
            let mut sums = self.shape(*rest_m);
            sums.velocity = self.tiles.iter().map(|tile| tile.velocity(*rest_m)).sum();
            sums.surface(self.current_mps)
        };
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            Ok(rests_m.par_iter().with_min_len(256).map(at_rest).collect())
        }
        #[cfg(not(feature = "parallel"))]
        Ok(rests_m.iter().map(at_rest).collect())
    }

    /// How the water moves that rests at each place of a tile alone, as it repeats, m/s, without the current. Of a tile that is not there nothing.
    pub fn velocities_of_tile(&self, tile: usize, rests_m: &[DVec2]) -> Vec<DVec3> {
        let Some(tile) = self.tiles.get(tile) else { return Vec::new() };
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            rests_m.par_iter().with_min_len(256).map(|rest_m| tile.velocity_of_tile(*rest_m)).collect()
        }
        #[cfg(not(feature = "parallel"))]
        rests_m.iter().map(|rest_m| tile.velocity_of_tile(*rest_m)).collect()
    }

    /// The water over one place, upright.
    fn over(&self, place_m: DVec2) -> SurfacePoint {
        let (rest_m, mut sums) = inverse::rest_under(place_m, |rest_m| self.shape(rest_m));
        sums.velocity = self.tiles.iter().map(|tile| tile.velocity(rest_m)).sum();
        sums.surface(self.current_mps)
    }

    fn shape(&self, rest_m: DVec2) -> Sums {
        let mut sums = Sums::default();
        for tile in &self.tiles {
            sums += tile.shape(rest_m);
        }
        sums
    }
}

/// One tile at one moment.
struct TileSnapshot {
    size_m: f64,
    /// N of the tile.
    resolution: usize,
    /// Samples along a side here, M.
    side: usize,
    /// Coefficients of (Dx, h, Dz, –), index `iz * side + ix`.
    shape: Vec<Vec4>,
    /// Coefficients of the water's velocity in the same order, without the current.
    motion: Vec<Vec4>,
    /// For each lattice number from 0: what makes a wave's amplitude its coefficient.
    filter: Vec<f32>,
    evolved: Vec<f32>,
    planes: [Vec<f32>; 3],
    transform: InverseReal2d,
    /// Where the tile does not repeat.
    patchwork: Option<Patchwork>,
}

impl TileSnapshot {
    fn new(tile: &SpectralTile, side: usize) -> Self {
        let resolution = tile.resolution();
        Self {
            size_m: tile.tile_size_m(),
            resolution,
            side,
            shape: vec![Vec4::ZERO; side * side],
            motion: vec![Vec4::ZERO; side * side],
            filter: spline::factors(resolution / 2, side),
            evolved: vec![0.0; resolution / 2 * Column::len(resolution)],
            planes: std::array::from_fn(|_| vec![0.0; side * side]),
            transform: InverseReal2d::new(side).expect("a power of two from 16 to 4096"),
            patchwork: None,
        }
    }

    fn take(&mut self, tile: &SpectralTile, time_s: f64) {
        self.transform_all(tile, time_s, false);
        gather(&self.planes, &mut self.shape, self.side);
        self.transform_all(tile, time_s, true);
        gather(&self.planes, &mut self.motion, self.side);
    }

    /// Fills the planes with x, up and z of the displacement, or of the velocity.
    fn transform_all(&mut self, tile: &SpectralTile, time_s: f64, velocity: bool) {
        let (n, side, waves, filter) = (self.resolution, self.side, tile.waves(), &self.filter);
        let mut workers = vec![(); thread_count(n)];
        for_each_run(&mut self.evolved, Column::len(n), &mut workers, |p, run, ()| match velocity {
            true => evolve_velocity_column(waves, p, time_s, run),
            false => evolve_column(waves, p, time_s, run),
        });
        let evolved = &self.evolved;
        type Field = fn(&Column<'_>, &mut [Complex<f32>]);
        let fields: [Field; 3] = [
            |column, out| column.displacement_x(out),
            |column, out| column.height(out),
            |column, out| column.displacement_z(out),
        ];
        for (field, plane) in fields.into_iter().zip(&mut self.planes) {
            let fill = |p: usize, out: &mut [Complex<f32>]| {
                if p > waves.reach {
                    return out.fill(Complex::default());
                }
                field(&Column::of(waves, evolved, p), &mut out[..n]);
                // Negative lattice numbers belong to the end of a longer run.
                if side > n {
                    out.copy_within(n / 2..n, side - n / 2);
                    out[n / 2..side - n / 2].fill(Complex::default());
                }
                spline::filter(filter, p, out);
            };
            self.transform.process_with(fill, plane);
        }
    }

    /// Everything but the velocity.
    fn shape(&self, rest_m: DVec2) -> Sums {
        match &self.patchwork {
            Some(patchwork) => patchwork.sums(rest_m, self.size_m, |rest_m| self.shape_of_tile(rest_m)),
            None => self.shape_of_tile(rest_m),
        }
    }

    fn velocity(&self, rest_m: DVec2) -> DVec3 {
        match &self.patchwork {
            Some(patchwork) => {
                let of_patch =
                    |patch: Patch| patch.weight * self.velocity_of_tile(rest_m + patch.shift * self.size_m);
                patchwork.patches_at(rest_m).into_iter().map(of_patch).sum()
            }
            None => self.velocity_of_tile(rest_m),
        }
    }

    fn shape_of_tile(&self, rest_m: DVec2) -> Sums {
        let (x, z) = self.taps(rest_m);
        let jet = jet(&self.shape, &x, &z);
        let per_m = self.side as f64 / self.size_m;
        let (value, by_x, by_z) =
            (jet.value.as_dvec4(), jet.by_x.as_dvec4() * per_m, jet.by_z.as_dvec4() * per_m);
        Sums {
            height: value.y,
            shift: DVec2::new(value.x, value.z),
            slope: DVec2::new(by_x.y, by_z.y),
            // The displacement is a gradient field: ∂Dx/∂z = ∂Dz/∂x.
            gradient: [by_x.x, 0.5 * (by_z.x + by_x.z), by_z.z],
            velocity: DVec3::ZERO,
        }
    }

    fn velocity_of_tile(&self, rest_m: DVec2) -> DVec3 {
        let (x, z) = self.taps(rest_m);
        value(&self.motion, &x, &z).truncate().as_dvec3()
    }

    fn taps(&self, rest_m: DVec2) -> (Taps, Taps) {
        // In tiles: whole tiles drop out in f64, however far away.
        let place = rest_m / self.size_m;
        let samples = DVec2::new(fraction(place.x), fraction(place.y)) * self.side as f64;
        (Taps::at(samples.x, self.side), Taps::at(samples.y, self.side))
    }
}

/// x − ⌊x⌋, from 0 to 1, for |x| below 2⁶³. By a cast, since a call to `floor` costs as much as a row of a grid.
#[inline(always)]
fn fraction(x: f64) -> f64 {
    let toward_zero = x - x as i64 as f64;
    if toward_zero < 0.0 { toward_zero + 1.0 } else { toward_zero }
}

/// What decides the grids of a tile: size, resolution, variance and choppiness.
type Key = (f64, usize, f64, f64);

fn key(tile: &SpectralTile) -> Key {
    (tile.tile_size_m(), tile.resolution(), tile.variance_m2(), tile.parameters().choppiness)
}

/// The largest error is about five standard deviations, and horizontal errors add a little. Those are λ times as large
/// as the height's, so beyond λ = 1 it is they that are held to the bound.
const DEVIATIONS: f64 = 6.0;

const FINEST_SIDE: usize = 4096;

/// The samples along a side of each tile's grid: four or more to the shortest wave, and so many that the error is
/// within the bound of a query.
fn sides(sea: &SpectralSea) -> Vec<usize> {
    let bound_m = (1e-3 * significant_height_m(sea.variance_m2())).max(1e-3);
    let coarsest = |tile: &SpectralTile| (4 * tile.waves().reach).next_power_of_two().max(tile.resolution());
    let mut sides: Vec<usize> = sea.tiles().iter().map(coarsest).collect();
    let mut errors: Vec<f64> =
        sea.tiles().iter().zip(&sides).map(|(tile, side)| error_variance_m2(tile, *side)).collect();
    let deviations = DEVIATIONS * sea.parameters().choppiness.abs().max(1.0);
    while errors.iter().sum::<f64>().sqrt() * deviations > bound_m {
        let worst = (0..sides.len()).max_by(|&a, &b| errors[a].total_cmp(&errors[b])).unwrap_or(0);
        if sides[worst] == FINEST_SIDE {
            break;
        }
        sides[worst] *= 2;
        errors[worst] = error_variance_m2(&sea.tiles()[worst], sides[worst]);
    }
    sides
}

/// The mean square error of a tile's height on a grid.
fn error_variance_m2(tile: &SpectralTile, side: usize) -> f64 {
    let n = tile.resolution();
    let kept: Vec<f64> =
        (0..=n / 2).map(|q| 1.0 - error_variance((q as f64 / side as f64).min(0.5))).collect();
    let mut sum = 0.0;
    for p in 0..=tile.waves().reach.min(n / 2 - 1) {
        let images = if p == 0 { 1.0 } else { 2.0 };
        let parts = tile.column(p).amplitudes;
        for q in 0..n {
            // The mean of |P cos ωt + Q sin ωt|² over time.
            let energy = 0.5 * parts.iter().map(|part| f64::from(part[q]).powi(2)).sum::<f64>();
            sum += images * energy * (1.0 - kept[p] * kept[q.min(n - q)]);
        }
    }
    sum
}

/// Three planes into one array of vectors.
fn gather([x, y, z]: &[Vec<f32>; 3], out: &mut [Vec4], side: usize) {
    for_each_run(out, side, &mut vec![(); thread_count(side)], |row, out, ()| {
        let range = row * side..(row + 1) * side;
        let planes = x[range.clone()].iter().zip(&y[range.clone()]).zip(&z[range]);
        for (out, ((x, y), z)) in out.iter_mut().zip(planes) {
            *out = Vec4::new(*x, *y, *z, 0.0);
        }
    });
}
