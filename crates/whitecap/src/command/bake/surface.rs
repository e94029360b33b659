//! A scene's sea, frame by frame: its maps.

use super::format::Bounds;
use super::map::{Map, Raster};
use crate::command::series::Grid;
use crate::failure::Failure;
use anyhow::anyhow;
use glam::DVec2;
use whitecap_scene::Scene;
use whitecap_scene::sea::SeaSurface;
use whitecap_waves::dispersion::Dispersion;
use whitecap_waves::model::spectral::foam::{DECAY_S, Foam, FoamParameters};
use whitecap_waves::model::spectral::{Band, SpectralSea};
use whitecap_waves::model::{Surface, TileFields, WaveModel};
use whitecap_waves::query::Snapshot;
use whitecap_waves::statistics::{SeaStatistics, significant_height_m};

/// Deviations from calm to either side for which a PNG has room.
const DEVIATIONS: f64 = 8.0;

/// The sea of a scene.
pub(super) struct Sea {
    sea: SpectralSea,
    snapshot: Option<Snapshot>,
    foam: Option<Foam>,
    fields: TileFields,
    statistics: SeaStatistics,
}

/// Where a map is of.
#[derive(Clone, Debug)]
pub(super) enum Place {
    /// One tile alone, by its number.
    Cascade(usize),
    /// All of them over a rectangle.
    Area(Area),
}

/// Samples on a rectangle.
#[derive(Clone, Debug)]
pub(super) struct Area {
    pub(super) size: [usize; 2],
    pub(super) rests_m: Vec<DVec2>,
}

impl Area {
    pub(super) fn of(grid: Grid) -> Area {
        let rests_m = grid.places().map(DVec2::from).collect();
        Area { size: [grid.x_m.count as usize, grid.z_m.count as usize], rests_m }
    }
}

impl Sea {
    pub(super) fn of(scene: &Scene, maps: &[Map], has_area: bool) -> Result<Sea, Failure> {
        let sea = match scene.sea.build(scene.seed)? {
            SeaSurface::Spectral(sea) => sea,
            _ => {
                return Err(Failure::Input(anyhow!(
                    "the technique {} has no sea of spectra to bake, but one of model \"{}\"; bake a scene of spectral-ocean or \
                     meshuggah",
                    scene.technique.word(),
                    scene.sea.model.word()
                )));
            }
        };
        let problem = |error| Failure::Machine(anyhow::Error::from(error));
        let foam = if maps.contains(&Map::Foam) {
            let parameters = FoamParameters { wind_speed_mps: scene.sea.wind_speed_mps(), decay_s: DECAY_S };
            Foam::new(&sea, parameters).map_err(problem)?
        } else {
            None
        };
        let spectra = scene.sea.spectra()?;
        let dispersion: Dispersion = sea.parameters().water.dispersion;
        let statistics = SeaStatistics::of(&spectra, dispersion, Band::WHOLE).map_err(problem)?;
        let snapshot = (has_area || maps.contains(&Map::Velocity)).then(|| Snapshot::new(&sea));
        Ok(Sea { sea: *sea, snapshot, foam, fields: TileFields::default(), statistics })
    }

    pub(super) fn sea(&self) -> &SpectralSea {
        &self.sea
    }

    pub(super) fn foam(&self) -> Option<&Foam> {
        self.foam.as_ref()
    }

    pub(super) fn significant_height_m(&self) -> f64 {
        significant_height_m(self.sea.variance_m2())
    }

    /// What fits into a PNG: eight standard deviations.
    pub(super) fn bounds(&self, map: Map) -> Bounds {
        let evenly = |deviation: f64| {
            let most = (DEVIATIONS * deviation).max(1e-6);
            Bounds { black: -most, white: most }
        };
        let choppiness = self.sea.parameters().choppiness.abs().max(1.0);
        match map {
            Map::Displacement => evenly(choppiness * self.sea.variance_m2().sqrt()),
            Map::Normal => Bounds { black: -1.0, white: 1.0 },
            Map::Slope => evenly(self.statistics.slope.total().sqrt()),
            Map::Jacobian => {
                let Bounds { black, white } = evenly(choppiness * self.statistics.slope.total().sqrt());
                Bounds { black: 1.0 + black, white: 1.0 + white }
            }
            Map::Foam => Bounds { black: 0.0, white: 1.0 },
            Map::Velocity => evenly(choppiness * self.statistics.moments.m2.sqrt()),
        }
    }

    /// Brings to `time_s` what maps are taken from.
    pub(super) fn go_to(&mut self, time_s: f64) -> Result<(), Failure> {
        if let Some(snapshot) = &mut self.snapshot {
            snapshot.take(&self.sea, time_s).map_err(|error| Failure::Machine(error.into()))?;
        }
        if let Some(foam) = &mut self.foam {
            foam.evaluate(time_s);
        }
        Ok(())
    }

    /// The maps of a place at the moment that was [gone to](Self::go_to), in the order that they are asked for.
    pub(super) fn rasters(
        &mut self,
        place: &Place,
        maps: &[Map],
        time_s: f64,
    ) -> Result<Vec<Raster>, Failure> {
        match place {
            Place::Cascade(index) => Ok(self.of_cascade(*index, maps, time_s)),
            Place::Area(area) => self.of_area(area, maps),
        }
    }

    fn of_cascade(&mut self, index: usize, maps: &[Map], time_s: f64) -> Vec<Raster> {
        let Some(tile) = self.sea.tiles_mut().get_mut(index) else { return Vec::new() };
        tile.evaluate(time_s, &mut self.fields);
        let fields = &self.fields;
        let n = fields.resolution();
        let size = [n, n];
        let spacing_m = tile.tile_size_m() / n as f64;
        let raster = |map: &Map| match map {
            Map::Displacement => Raster::new(size, |i| fields.displacement(i)),
            Map::Normal => Raster::new(size, |i| fields.normal(i)),
            Map::Slope => Raster::new(size, |i| [fields.slope_x[i], fields.slope_z[i]]),
            Map::Jacobian => Raster::new(size, |i| [fields.jacobian(i)]),
            Map::Foam => {
                let of_tile = |foam: &Foam| foam.tiles().iter().position(|tile| tile.index() == index);
                let found = self.foam.as_ref().and_then(|foam| Some((foam, of_tile(foam)?)));
                match found {
                    Some((foam, at)) => {
                        let (field, n) = (foam.tiles()[at].field(), foam.resolution());
                        Raster::new([n, n], |i| [field[i]])
                    }
                    // Adds nothing to the others.
                    None => Raster::new(size, |_| [0.0]),
                }
            }
            Map::Velocity => {
                let rest_m = |i: usize| spacing_m * DVec2::new((i % n) as f64, (i / n) as f64);
                let rests_m: Vec<DVec2> = (0..n * n).map(rest_m).collect();
                let snapshot = self.snapshot.as_ref();
                let velocities =
                    snapshot.map(|snapshot| snapshot.velocities_of_tile(index, &rests_m)).unwrap_or_default();
                Raster::new(size, |i| velocities[i].as_vec3().to_array())
            }
        };
        maps.iter().map(raster).collect()
    }

    fn of_area(&self, area: &Area, maps: &[Map]) -> Result<Vec<Raster>, Failure> {
        let Some(snapshot) = &self.snapshot else { return Ok(Vec::new()) };
        let points = snapshot.at_rest(&area.rests_m).map_err(|error| Failure::Input(error.into()))?;
        let raster = |map: &Map| match map {
            Map::Displacement => Raster::new(area.size, |i| points[i].displacement_m.as_vec3().to_array()),
            Map::Normal => Raster::new(area.size, |i| points[i].normal.as_vec3().to_array()),
            Map::Slope => Raster::new(area.size, |i| points[i].slope.as_vec2().to_array()),
            Map::Jacobian => Raster::new(area.size, |i| [points[i].jacobian as f32]),
            Map::Foam => {
                let cover = |i: usize| self.foam.as_ref().map_or(0.0, |foam| foam.cover_at(area.rests_m[i]));
                Raster::new(area.size, |i| [cover(i) as f32])
            }
            Map::Velocity => Raster::new(area.size, |i| points[i].velocity_mps.as_vec3().to_array()),
        };
        Ok(maps.iter().map(raster).collect())
    }
}
