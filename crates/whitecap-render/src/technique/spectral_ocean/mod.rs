//! Our own ocean: a calibrated sea of several tiles, to the horizon.
//!
//! Each tile of a [`SpectralSea`](whitecap_waves::model::spectral::SpectralSea) is a set of [`TileMaps`]. Vertices of
//! nested rings ([`NestedGrid`]) move by the sum of the tiles' displacements; pixels see the sum of their slopes, and
//! what neither resolves is roughness, by direction (`Roughness`). Breaking waves leave foam ([`FoamMaps`]). Under the
//! surface light scatters once. All of it is linear light of the scene; the tone map comes last.
//!
//! docs/spectral-ocean.md tells the passes and the limits.

mod features;
mod gpu;
mod roughness;
mod visible;

use super::{Build, Frame, Technique, wrong_sea};
use crate::RenderError;
use crate::environment::{Light, SUN_RADIUS_RAD};
use crate::geometry::NestedGrid;
use crate::shader_lib::{GpuPatchwork, GpuWaterLight};
use crate::surface::{FoamMaps, TileMaps, Vertices};
use crate::uniforms::ViewSlots;
use crate::view::View;
pub use features::Feature;
use glam::{DVec2, DVec3, Vec3};
use gpu::{GpuCascade, GpuSpectralOcean, GpuWaters, MAX_CASCADES, MAX_LEVELS, Pipeline};
use roughness::Roughness;
use visible::Wedge;
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::technique as settings;
use whitecap_waves::model::spectral::Patchwork;
use whitecap_waves::model::spectral::foam::{DECAY_S, Foam, FoamParameters};
use whitecap_waves::model::{Surface, WaveModel};
use whitecap_waves::optics::water_body::{Daylight, WaterLight};

/// The apron reaches this far, metres: beyond the horizon of a viewer at 100 km.
const REACH_M: f64 = 2.0e6;

/// The finest cell that is ever drawn, metres.
const FINEST_CELL_M: f64 = 0.0625;

/// Waves of a tile leave the mesh from where its cells are half as long as the shortest of them to where they are three
/// times as long. Slopes do not leave: they are the pixel stage's.
const FADE_START_WAVES: f64 = 0.5;
const FADE_END_WAVES: f64 = 3.0;

/// A bottom that no light comes back from, metres.
const BOTTOMLESS_M: f64 = 1e4;

/// The shortest wave of a tile, in its samples.
const SAMPLES_PER_WAVE: f64 = 4.0;

/// What water is moved sideways by, in significant heights: along as much as up, eight standard deviations.
const SWAY: f64 = 2.0;

/// Of the last level's half width: there the last waves have left the mesh.
const FADE_LIMIT: f64 = 0.9;

pub(super) struct SpectralOcean {
    settings: settings::SpectralOcean,
    tiles: Vec<TileMaps>,
    /// Of the first tiles, those that are sewn.
    patchworks: Vec<Patchwork>,
    grid: NestedGrid,
    levels: u32,
    significant_height_m: f64,
    roughness: Roughness,
    foam: FoamMaps,
    slots: ViewSlots<GpuSpectralOcean>,
    pipeline: Pipeline,
    /// The parts of the mesh that each view sees.
    seen: Vec<Vec<std::ops::Range<u32>>>,
}

impl SpectralOcean {
    pub(super) fn new(
        build: &Build<'_>,
        settings: &settings::SpectralOcean,
    ) -> Result<SpectralOcean, RenderError> {
        // The scene's reader lets no other sea through, and no more tiles.
        let sea = match build.scene.sea.build(build.scene.seed)? {
            SeaSurface::Spectral(sea) if (1..=MAX_CASCADES).contains(&sea.tiles().len()) => sea,
            _ => return Err(wrong_sea(build)),
        };
        let Some(light) = build.light else {
            return Err(RenderError::Unsupported { what: "an environment of display values".into() });
        };
        let significant_height_m = whitecap_waves::statistics::significant_height_m(sea.variance_m2());
        let roughness = Roughness::of(build.scene, &sea)?;
        let wind_speed_mps = build.scene.sea.wind_speed_mps();
        let foam = Foam::new(&sea, FoamParameters { wind_speed_mps, decay_s: DECAY_S })
            .map_err(|error| RenderError::Internal { description: error.to_string() })?;
        let foam = FoamMaps::new(build.device, build.queue, foam)?;
        let maps_of = |model| {
            let model: Box<dyn WaveModel> = Box::new(model);
            TileMaps::new(build.device, build.queue, build.backend, model, Vertices::Anywhere)
        };
        let patchworks = (0..sea.tiles().len()).map_while(|tile| sea.patchwork(tile)).collect::<Vec<_>>();
        let tiles = sea.into_tiles().into_iter().map(maps_of).collect::<Result<Vec<_>, _>>()?;

        let (cells, levels) = mesh_size(build.is_software(), build.shared.target.sample_shading);
        let grid = mesh(cells, levels);
        let slots = ViewSlots::new(build.device, "spectral ocean");
        let waters = waters(build, settings, light, &roughness);
        let pipeline = Pipeline::new(build, &grid, &tiles, patchworks.len(), &foam, &waters, &slots);
        Ok(SpectralOcean {
            settings: settings.clone(),
            roughness,
            foam,
            significant_height_m,
            tiles,
            patchworks,
            grid,
            levels,
            slots,
            pipeline,
            seen: Vec::new(),
        })
    }

    /// The first level's cell for an eye so high: the finest lattice that its distance still asks for. Powers of two
    /// share their vertices, and the waves that a coarser one cannot carry have left the mesh at that distance.
    fn cell_m(&self, eye_height_m: f64) -> f64 {
        let wanted = self.cell_per_m() * eye_height_m.abs();
        wanted.max(FINEST_CELL_M).log2().floor().exp2()
    }

    /// No cell is wider than this share of its distance from the eye.
    fn cell_per_m(&self) -> f64 {
        2.0 / f64::from(self.grid.half_cells())
    }

    fn uniforms(&self, view: &View) -> GpuSpectralOcean {
        let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
        let cell_m = self.cell_m(view.eye_m.y);
        let mut level_origins = [[0.0; 4]; MAX_LEVELS / 2];
        for level in 0..self.levels as usize {
            // Each level moves in whole cells of its own, so that its vertices stay on its lattice.
            let cell_m = cell_m * (level as f64).exp2();
            let origin = (eye / cell_m).round() * cell_m - eye;
            let at = 2 * (level % 2);
            level_origins[level / 2][at..at + 2].copy_from_slice(&origin.as_vec2().to_array());
        }
        let half_width_m = cell_m * f64::from(self.grid.half_cells()) * f64::from(self.levels - 1).exp2();
        let mut cascades = [GpuCascade::default(); MAX_CASCADES];
        let tiles = self.tiles.iter().zip(&self.roughness.tiles).enumerate();
        for (cascade, (tile, (maps, shape))) in cascades.iter_mut().zip(tiles) {
            let shortest_m = SAMPLES_PER_WAVE * maps.tile_size_m() / maps.resolution() as f64;
            let fade_end_m = (FADE_END_WAVES * shortest_m / self.cell_per_m()).min(FADE_LIMIT * half_width_m);
            let fade_start_m = (FADE_START_WAVES * shortest_m / self.cell_per_m()).min(0.5 * fade_end_m);
            *cascade = GpuCascade {
                eye_in_tile: (eye / maps.tile_size_m()).fract_gl().as_vec2().to_array(),
                tiles_per_m: (1.0 / maps.tile_size_m()) as f32,
                samples: maps.mesh_samples() as f32,
                fade_start_m: fade_start_m as f32,
                fade_end_m: fade_end_m as f32,
                half_texel: (0.5 / maps.resolution() as f64) as f32,
                padding: 0,
                slope_shape: shape.to_array(),
                end: 0,
                patchwork: GpuPatchwork::new(self.patchworks.get(tile).copied(), eye),
            };
        }
        GpuSpectralOcean {
            level_origins,
            cascades,
            cell_m: cell_m as f32,
            eye_height_m: view.eye_m.y as f32,
            earth_radius_m: (self.settings.curvature_radius_km * 1000.0) as f32,
            cascade_count: self.tiles.len() as u32,
            foam: self.foam.uniforms(eye),
        }
    }
}

/// Cells a side and levels of the mesh, which reach 2 km from an eye at the water. A processor that draws shades whole blocks of
/// pixels for every triangle that touches them: there frames have a coarser mesh than stills.
fn mesh_size(is_software: bool, is_still: bool) -> (u32, u32) {
    match (is_software, is_still) {
        (true, false) => (64, 11),
        (true, true) => (128, 10),
        (false, _) => (256, 10),
    }
}

fn mesh(cells: u32, levels: u32) -> NestedGrid {
    let last_cell_m = FINEST_CELL_M * f64::from(levels - 1).exp2();
    NestedGrid::new(cells, levels, (REACH_M / last_cell_m) as f32)
}

/// The light in the water and on it.
fn waters(
    build: &Build<'_>,
    settings: &settings::SpectralOcean,
    light: &Light,
    roughness: &Roughness,
) -> GpuWaters {
    let sun_klx = light.sun.map_or(Vec3::ZERO, |sun| sun.illuminance_klx);
    let daylight = Daylight {
        sun_irradiance: sun_klx.as_dvec3().to_array(),
        toward_sun: light.sun.map_or(DVec3::Y, |sun| sun.toward.as_dvec3()),
        sky_irradiance: light.sky_illuminance_klx.as_dvec3().to_array(),
    };
    let light_below = WaterLight::new(
        &settings.optics(),
        &daylight,
        settings.bottom_albedo,
        roughness.crest_wavenumber_per_m,
    );
    GpuWaters {
        light: GpuWaterLight::from(&light_below),
        slopes_beyond: roughness.beyond.to_array(),
        slopes_whole: roughness.whole.to_array(),
        gap: 0,
        depth_m: build.scene.sea.depth_m().unwrap_or(BOTTOMLESS_M) as f32,
        sun_klx: sun_klx.to_array(),
        padding: 0,
        sky_klx: light.sky_illuminance_klx.to_array(),
        sun_radius_rad: light.sun.map_or(SUN_RADIUS_RAD, |sun| sun.radius_rad),
        toward_sun: daylight.toward_sun.as_vec3().to_array(),
        end: 0,
    }
}

impl Technique for SpectralOcean {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        for maps in &mut self.tiles {
            maps.update(frame.queue, frame.encoder, frame.time_s);
        }
        frame.end_of_pass("sea");
        self.foam.update(frame.queue, frame.time_s);
        frame.end_of_pass("foam");
        self.seen.clear();
        for (i, view) in frame.views.iter().enumerate() {
            let uniforms = self.uniforms(view);
            self.slots.write(frame.queue, i, &uniforms);
            let wedge = Wedge::of(view.clip_from_eye_world());
            self.seen.push(wedge.visible(
                &self.grid,
                f64::from(uniforms.cell_m),
                SWAY * self.significant_height_m,
            ));
        }
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let Some(seen) = self.seen.get(view) else { return };
        self.pipeline.draw(pass, ViewSlots::<GpuSpectralOcean>::offset(view), seen);
    }

    fn draw_aux(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) -> bool {
        let Some(seen) = self.seen.get(view) else { return false };
        self.pipeline.draw_aux(pass, ViewSlots::<GpuSpectralOcean>::offset(view), seen)
    }
}

#[cfg(test)]
mod tests;
