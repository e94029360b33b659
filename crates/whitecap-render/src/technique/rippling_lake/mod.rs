//! ATI's lake: "Rippling Reflective and Refractive Water" (Vlachos, Isidoro and Oat, in *Direct3D ShaderX*, 2002).
//!
//! The scene is rendered twice into small maps: mirrored in the water's level without what lies under it, and as
//! it is without what lies over it. The water is a grid that four sines raise; each pixel reads both maps at its
//! own place on the screen, moved by the mean of two scrolling bump maps, and adds a Fresnel-weighted reflection,
//! a tinted refraction and a highlight.
//!
//! What the text leaves open or has wrong, and what we do (docs/rippling-lake.md has the whole list):
//! - the altered projection is the one that its prose means; its listing lost a number and would lose the divide;
//! - the light is the sun and infinitely far away;
//! - the prose swaps coordinates that the listing does not: `swap_uv`.

mod bump;
mod gpu;

use super::{Build, Frame, Technique, wrong_sea};
use crate::RenderError;
use crate::geometry::SquareGrid;
use crate::gpu::resources::rgba8_map;
use crate::pass::{PlanarPass, PlanarSettings};
use crate::surface::GpuSines;
use crate::uniforms::{Role, ViewSlots};
use crate::view::View;
use glam::{DVec2, DVec3, Mat4, Vec4};
use gpu::{GpuLake, GpuLakeConstants, Pipeline};
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::technique as settings;
use whitecap_waves::model::sines::SumOfSines;

pub(super) struct RipplingLake {
    settings: settings::RipplingLake,
    sines: SumOfSines,
    reflection: PlanarPass,
    refraction: PlanarPass,
    slots: ViewSlots<GpuLake>,
    pipeline: Pipeline,
}

impl RipplingLake {
    pub(super) fn new(
        build: &Build<'_>,
        settings: &settings::RipplingLake,
    ) -> Result<RipplingLake, RenderError> {
        let SeaSurface::Sines(sines) = build.scene.sea.build(build.scene.seed)? else {
            return Err(wrong_sea(build));
        };
        let size_px = map_size(build.device, settings)?;
        let [r, g, b] = settings.deep_color;
        let map = |role, sky, background, margin_m| {
            PlanarPass::new(build, PlanarSettings { role, size_px, sky, background, margin_m })
        };
        let levels = bump::bump_map(build.scene.seed, settings.bump_resolution, settings.bump_slope)?;
        let bump = rgba8_map(build.device, build.queue, "bump map", settings.bump_resolution, &levels);
        Ok(RipplingLake {
            settings: settings.clone(),
            sines,
            // Without a margin: a flat bottom just under water would stand up as a false shore in the mirror.
            reflection: map(Role::Mirror, true, [0.0, 0.0, 0.0, 1.0], 0.0),
            refraction: map(Role::Refraction, false, [r, g, b, 1.0], settings.refraction_margin_m as f32),
            slots: ViewSlots::new(build.device, "rippling lake"),
            pipeline: Pipeline::new(build, &SquareGrid::new(settings.cells), bump),
        })
    }

    fn uniforms(&self, view: &View, time_s: f64) -> GpuLake {
        let settings = &self.settings;
        let centre = DVec2::from(settings.centre_m);
        let uv = self.sines.uv(centre);
        let [map_x, map_y, map_w] = altered_projection(view.clip_from_eye_world());
        // uv·c26 + fract(t·c24) but for whole repeats, which no wrapped map shows.
        let scrolled = |tiling: [f64; 2], scroll: [f64; 2]| {
            let tiled = uv * DVec2::from(tiling);
            let moved = time_s * DVec2::from(scroll);
            (tiled.fract_gl() + moved.fract_gl()).as_vec2()
        };
        let first = scrolled(settings.bump_tiling_0, settings.bump_scroll_0);
        let second = scrolled(settings.bump_tiling_1, settings.bump_scroll_1);
        let [u0, v0] = settings.bump_tiling_0.map(|tiling| tiling as f32);
        let [u1, v1] = settings.bump_tiling_1.map(|tiling| tiling as f32);
        GpuLake {
            sines: GpuSines::new(&self.sines, uv, time_s),
            constants: GpuLakeConstants::new(settings),
            map_x: map_x.to_array(),
            map_y: map_y.to_array(),
            map_w: map_w.to_array(),
            centre_from_eye: (DVec3::new(centre.x, 0.0, centre.y) - view.eye_m).as_vec3().to_array(),
            size_m: settings.size_m as f32,
            bump_tiling: [u0, v0, u1, v1],
            bump_centre: [first.x, first.y, second.x, second.y],
            options: gpu::options(settings),
            padding: [0; 3],
        }
    }
}

/// The rows c20, c21 and c22, each to be multiplied with a place: .5X + .5W, −.5Y + .5W and W of the clip space's
/// rows. They take a place to the coordinates of a map that the same projection has drawn, v downwards, times w, and
/// to w itself.
///
/// The text means M · projection with M = (.5 0 0 0, 0 −.5 0 0, 0 0 0 0, .5 .5 1 0) for row vectors, so that
/// clip · M = (.5x + .5w, −.5y + .5w, w, 0). Its listing has 15 of the 16 numbers, multiplies in the opposite order,
/// and zeroes `projectionMatrix[11]`, which holds no constant but the w of every place.
fn altered_projection(clip_from_eye_world: Mat4) -> [Vec4; 3] {
    let [x, y, w] = [0, 1, 3].map(|row| clip_from_eye_world.row(row));
    [0.5 * x + 0.5 * w, -0.5 * y + 0.5 * w, w]
}

/// The maps' size, if the device has textures as large.
fn map_size(device: &wgpu::Device, settings: &settings::RipplingLake) -> Result<[u32; 2], RenderError> {
    let limit = device.limits().max_texture_dimension_2d;
    let size_px = [settings.map_width_px, settings.map_height_px];
    for (what, asked) in ["map_width_px", "map_height_px"].into_iter().zip(size_px) {
        if asked > limit {
            return Err(RenderError::LimitExceeded {
                what: what.into(),
                asked: asked.into(),
                accepted: format!("at most {limit} pixels"),
            });
        }
    }
    Ok(size_px)
}

impl Technique for RipplingLake {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        for index in 0..frame.views.len() {
            self.reflection.render(frame, index);
        }
        frame.end_of_pass("mirror map");
        for index in 0..frame.views.len() {
            self.refraction.render(frame, index);
        }
        frame.end_of_pass("refraction map");
        for (index, view) in frame.views.iter().enumerate() {
            self.slots.write(frame.queue, index, &self.uniforms(view, frame.time_s));
            let maps = [self.reflection.map(frame.device, index), self.refraction.map(frame.device, index)];
            self.pipeline.bind_maps(frame.device, &self.slots, index, maps);
        }
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.pipeline.draw(pass, view);
    }
}

#[cfg(test)]
mod tests;
