//! A spectral sea at one moment, ready for any number of questions.
//!
//! For each tile the waves are transformed onto a grid on which the shortest of them has four samples or more, as
//! coefficients of a quintic spline. The errors of such a grid follow from the spectrum, and grids are made finer until
//! they are small enough. A question then costs a few hundred products for each tile, however many waves there are.

use super::{NORMAL_BOUND_RAD, QueryError, check, inverse};
use crate::model::spectral::evolve::{Column, evolve_column, evolve_velocity_column};
use crate::model::spectral::{Patch, Patchwork, SpectralSea, SpectralTile, SpectralTileParameters};
use crate::model::{Surface, SurfacePoint, WaveModel, spectral::sample::Sums};
use crate::spline::{self, OnGrid, QUINTIC, Taps, jet, value};
use crate::statistics::significant_height_m;
use crate::transform::{Complex, InverseReal2d, for_each_run, thread_count};
use glam::{DVec2, DVec3, Vec4};
use std::f64::consts::TAU;

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
        Ok(each(places_m, |place| self.over(*place)))
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
        Ok(each(rests_m, at_rest))
    }

    /// How the water moves that rests at each place of a tile alone, as it repeats, m/s, without the current. Of a tile that is
    /// not there nothing.
    pub fn velocities_of_tile(&self, tile: usize, rests_m: &[DVec2]) -> Vec<DVec3> {
        let Some(tile) = self.tiles.get(tile) else { return Vec::new() };
        each(rests_m, |rest_m| tile.velocity_of_tile(*rest_m))
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

/// What `of` says of each place, in their order.
fn each<T: Send>(places_m: &[DVec2], of: impl Fn(&DVec2) -> T + Send + Sync) -> Vec<T> {
    #[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
    {
        use rayon::prelude::*;
        places_m.par_iter().with_min_len(256).map(of).collect()
    }
    #[cfg(not(all(feature = "parallel", not(target_arch = "wasm32"))))]
    places_m.iter().map(of).collect()
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
            filter: spline::factors(resolution / 2, side, QUINTIC),
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
        let [x, z] = self.taps(rest_m);
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
        let [x, z] = self.taps(rest_m);
        value(&self.motion, &x, &z).truncate().as_dvec3()
    }

    fn taps(&self, rest_m: DVec2) -> [Taps<QUINTIC>; 2] {
        // In tiles: whole tiles drop out in f64, however far away.
        let place = rest_m / self.size_m;
        let samples = DVec2::new(fraction(place.x), fraction(place.y)) * self.side as f64;
        Taps::<QUINTIC>::at(samples, self.side)
    }
}

/// x − ⌊x⌋, from 0 to 1, for |x| below 2⁶³. By a cast, since a call to `floor` costs as much as a row of a grid.
#[inline(always)]
fn fraction(x: f64) -> f64 {
    let toward_zero = x - x as i64 as f64;
    if toward_zero < 0.0 { toward_zero + 1.0 } else { toward_zero }
}

/// What decides the grids of a tile: size, resolution, variance, choppiness and depth.
type Key = [f64; 5];

fn key(tile: &SpectralTile) -> Key {
    let parameters = tile.parameters();
    [
        tile.tile_size_m(),
        tile.resolution() as f64,
        tile.variance_m2(),
        parameters.choppiness,
        parameters.water.dispersion.depth_m(),
    ]
}

const FINEST_SIDE: usize = 4096;

/// The samples along a side of each tile's grid: four or more to the shortest wave, and so many that the errors are
/// within the bounds of a query.
fn sides(sea: &SpectralSea) -> Vec<usize> {
    let bounds = Bounds::of(sea);
    let coarsest = |tile: &SpectralTile| (4 * tile.waves().reach).next_power_of_two().max(tile.resolution());
    let mut sides: Vec<usize> = sea.tiles().iter().map(coarsest).collect();
    let mut spent: Vec<[f64; 3]> =
        sea.tiles().iter().zip(&sides).map(|(tile, side)| bounds.spent(tile, *side)).collect();
    loop {
        let of_all = |bound: usize| spent.iter().map(|tile| tile[bound]).sum::<f64>();
        let bound = (0..3).max_by(|&a, &b| of_all(a).total_cmp(&of_all(b))).unwrap_or(0);
        let finer = (0..sides.len()).filter(|&tile| sides[tile] < FINEST_SIDE);
        let worst = finer.max_by(|&a, &b| spent[a][bound].total_cmp(&spent[b][bound]));
        let Some(worst) = worst.filter(|_| of_all(bound) > 1.0) else {
            return sides;
        };
        sides[worst] *= 2;
        spent[worst] = bounds.spent(&sea.tiles()[worst], sides[worst]);
    }
}

/// What a query may be wrong by, in standard deviations of the error over all places.
struct Bounds {
    /// Of height and of displacement.
    place_m: f64,
    velocity_mps: f64,
    normal_rad: f64,
    /// R.m.s. of the velocity's derivatives, for who is led to water beside the place.
    shear_per_s: f64,
    /// R.m.s. of the curvature.
    bend_per_m: f64,
}

/// The largest error is about five standard deviations.
const DEVIATIONS: f64 = 6.0;

/// A miss of the displacement leads 1/J times as far to water beside the place: between crests and troughs, as the
/// r.m.s. of what is next to steep crests.
const DRAWN_APART: f64 = 2.0;

impl Bounds {
    fn of(sea: &SpectralSea) -> Self {
        let place_m = (1e-3 * significant_height_m(sea.variance_m2())).max(1e-3);
        let (mut shear, mut bend) = (0.0, 0.0);
        for tile in sea.tiles() {
            for_each_wave(tile, |wave| {
                shear += wave.energy_m2 * wave.k2 * wave.speed2;
                bend += wave.energy_m2 * wave.k2 * wave.k2 * (1.0 + wave.lean2);
            });
        }
        Self {
            place_m: place_m / DEVIATIONS,
            velocity_mps: place_m / DEVIATIONS,
            normal_rad: NORMAL_BOUND_RAD / DEVIATIONS,
            shear_per_s: shear.sqrt(),
            bend_per_m: bend.sqrt(),
        }
    }

    /// The shares of the three bounds, as variances, that a tile takes on a grid: of place, velocity and normal.
    fn spent(&self, tile: &SpectralTile, side: usize) -> [f64; 3] {
        let on_grid: Vec<OnGrid> = (0..=tile.resolution() / 2)
            .map(|q| OnGrid::new((q as f64 / side as f64).min(0.5), QUINTIC))
            .collect();
        let per_m2 = (side as f64 / tile.tile_size_m()).powi(2);
        let [mut up, mut along, mut velocity, mut slope] = [0.0; 4];
        for_each_wave(tile, |wave| {
            let [x, z] = wave.lattice.map(|number| &on_grid[number]);
            let ((lost, by_x), (_, by_z)) = (x.errors(z), z.errors(x));
            up += wave.energy_m2 * lost;
            along += wave.energy_m2 * wave.lean2 * lost;
            velocity += wave.energy_m2 * wave.speed2 * lost;
            slope += wave.energy_m2 * (1.0 + wave.lean2) * (by_x + by_z) * per_m2;
        });
        let beside_m = DRAWN_APART * along.sqrt();
        [
            up.max(along) / self.place_m.powi(2),
            (velocity + (beside_m * self.shear_per_s).powi(2)) / self.velocity_mps.powi(2),
            (slope + (beside_m * self.bend_per_m).powi(2)) / self.normal_rad.powi(2),
        ]
    }
}

/// A wave on average over time.
struct Wave {
    /// |p| and |q|.
    lattice: [usize; 2],
    k2: f64,
    /// Its part of the height's variance.
    energy_m2: f64,
    /// (λ coth kd)², the displacement's variance over the height's.
    lean2: f64,
    /// ω²(1 + coth² kd), the velocity's variance over the height's.
    speed2: f64,
}

fn for_each_wave(tile: &SpectralTile, mut visit: impl FnMut(&Wave)) {
    let n = tile.resolution();
    let spacing = TAU / tile.tile_size_m();
    let SpectralTileParameters { choppiness, water, .. } = tile.parameters();
    for p in 0..=tile.waves().reach.min(n / 2 - 1) {
        let images = if p == 0 { 1.0 } else { 2.0 };
        let column = tile.column(p);
        for q in 0..n {
            // The mean of |P cos ωt + Q sin ωt|² over time.
            let energy = 0.5 * column.amplitudes.iter().map(|part| f64::from(part[q]).powi(2)).sum::<f64>();
            if energy == 0.0 {
                continue;
            }
            let lattice = [p, q.min(n - q)];
            let k = spacing * (lattice[0] as f64).hypot(lattice[1] as f64);
            let orbit = water.dispersion.orbit_ratio(k);
            let omega = TAU * column.turns_per_s[lattice[1]];
            visit(&Wave {
                lattice,
                k2: k * k,
                energy_m2: images * energy,
                lean2: (choppiness * orbit).powi(2),
                speed2: omega * omega * (1.0 + orbit * orbit),
            });
        }
    }
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
