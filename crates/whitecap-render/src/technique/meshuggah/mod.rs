//! Carsten Wenzel's ocean from "Meshuggah" (2002).
//!
//! A statistical FFT sea (Tessendorf) on one tile, repeated into a mesh; a bump map made of the same
//! normals every frame and tiled many times over it; the reflected view vector into an environment map;
//! two colours of water by angle; the Fresnel term of Jensen and Goliáš times an exposure up to 4.
//!
//! What the text leaves open or cannot do, and what we do (docs/meshuggah.md has the whole list):
//! - its mesh ends; ours is joined by an apron that reaches the horizon;
//! - far away the waves pass from the mesh into the normal map, whose mips keep the variance of slope
//!   that they average away; reflection, Fresnel and colour use it. Near the viewer nothing is changed;
//! - the world is right-handed and the bump map holds half floats.

mod gpu;
pub mod normals;

use super::{Build, Frame, Technique, wrong_sea};
use crate::RenderError;
use crate::geometry::TiledGrid;
use crate::surface::{TileMaps, Vertices};
use crate::uniforms::ViewSlots;
use crate::view::View;
use glam::{DVec2, DVec3};
use gpu::{GpuMeshuggah, Pipeline, WATER_COLORS, water_colors};
use whitecap_scene::technique as settings;

/// The apron reaches this far, metres: beyond the horizon of a viewer at 100 km.
const REACH_M: f64 = 2.0e6;

/// Of the mesh's half width: where the waves begin to pass from geometry into normals, and where they
/// have. The rest is a margin for horizontal displacement and for the mesh's steps.
const FADE_START: f64 = 0.35;
const FADE_END: f64 = 0.92;

pub(super) struct Meshuggah {
    settings: settings::Meshuggah,
    daylight: f32,
    maps: TileMaps,
    slots: ViewSlots<GpuMeshuggah>,
    pipeline: Pipeline,
}

impl Meshuggah {
    pub(super) fn new(build: &Build<'_>, settings: &settings::Meshuggah) -> Result<Meshuggah, RenderError> {
        // The scene's reader lets one tile through.
        let tiles = build.scene.sea.build(build.scene.seed)?.into_tiles();
        let Some(model) = tiles.and_then(|tiles| tiles.into_iter().next()) else {
            return Err(wrong_sea(build));
        };
        let vertices = Vertices::OnSamples { repeats: settings.tile_repeats };
        let maps = TileMaps::new(build.device, build.queue, build.backend, model, vertices)?;
        let cells = maps.mesh_samples() as u32 * settings.tile_repeats;
        let grid = TiledGrid::new(cells, (REACH_M / maps.cell_m()) as f32);
        let slots = ViewSlots::new(build.device, "meshuggah");
        let colors = water_colors(settings, build.irradiance, build.toward_sun.y.max(0.0));
        debug_assert_eq!(colors.len(), WATER_COLORS);
        let pipeline = Pipeline::new(build, &grid, &maps, &slots, &colors);
        Ok(Meshuggah { settings: settings.clone(), daylight: build.daylight, maps, slots, pipeline })
    }

    fn uniforms(&self, view: &View) -> GpuMeshuggah {
        let (maps, settings) = (&self.maps, &self.settings);
        let cell_m = maps.cell_m();
        let tile_m = maps.tile_size_m();
        let mesh_m = tile_m * f64::from(settings.tile_repeats);
        let bump_m = mesh_m / settings.bump_repeats;

        // The mesh moves in whole cells, so that its vertices stay on the tile's samples.
        let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
        let cell = maps.nearest_cell(eye);
        let centre = cell.as_dvec2() * cell_m;
        let centre_from_eye = DVec3::new(centre.x - eye.x, -view.eye_m.y, centre.y - eye.y);
        let samples = maps.mesh_samples() as i64;
        // Texel centres are half a texel in, but samples lie on corners: shift the maps to meet them.
        let half_texel = 0.5 / maps.resolution() as f64;
        let uv = |size_m: f64| ((centre / size_m).fract_gl() + half_texel).as_vec2().to_array();
        let per_m = |size_m: f64| (maps.resolution() as f64 / size_m) as f32;

        let half_width = 0.5 * mesh_m;
        GpuMeshuggah {
            centre_from_eye: centre_from_eye.as_vec3().to_array(),
            cell_m: cell_m as f32,
            centre_cell: [cell.x.rem_euclid(samples) as i32, cell.y.rem_euclid(samples) as i32],
            mesh_samples: samples as i32,
            earth_radius_m: (settings.curvature_radius_km * 1000.0) as f32,
            centre_tile_uv: uv(tile_m),
            centre_bump_uv: uv(bump_m),
            tiles_per_m: (1.0 / tile_m) as f32,
            bumps_per_m: (1.0 / bump_m) as f32,
            fade_start_m: (FADE_START * half_width) as f32,
            fade_end_m: (FADE_END * half_width) as f32,
            deep_color: settings.deep_color.map(|c| c as f32 * self.daylight),
            exposure: settings.exposure as f32,
            grazing_color: settings.grazing_color.map(|c| c as f32 * self.daylight),
            options: gpu::options(settings),
            texels_per_m: [per_m(bump_m), per_m(tile_m)],
            visibility_m: (settings.visibility_km * 1000.0) as f32,
            padding: 0,
        }
    }
}

impl Technique for Meshuggah {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        self.maps.update(frame.queue, frame.encoder, frame.time_s);
        frame.end_of_pass("sea");
        for (i, view) in frame.views.iter().enumerate() {
            self.slots.write(frame.queue, i, &self.uniforms(view));
        }
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.pipeline.draw(pass, ViewSlots::<GpuMeshuggah>::offset(view));
    }
}

#[cfg(test)]
mod tests;
