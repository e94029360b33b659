//! Berglund's ocean shader: five scrolling samples of one normal map, emission against reflection.
//!
//! The source is a work log of some days, with the final shader and its parameters. The final shader is here to the
//! letter; the stages before it, which the log tells of in words, are variants, so that the log can be retraced
//! picture by picture. What the author left for later (depth fog, reflected geometry, waves that meet land) are
//! settings that are off by default. docs/five-sample.md has the whole list.

mod gpu;
mod later;
mod maps;
mod plane;
mod stage;

use super::{Build, Frame, Technique, wrong_sea};
use crate::RenderError;
use crate::uniforms::ViewSlots;
use crate::view::View;
use glam::{DVec2, Vec3};
use gpu::{GpuFiveSample, Pipeline};
use later::Later;
use plane::Spacing;
use stage::{Absorption, EARLY_LAYERS, Form, LAYERS, Layer};
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::technique as settings;

/// Just above the horizon: what the whole surface reflects at some of the stages.
const JUST_ABOVE_HORIZON: f32 = 0.93;

pub(super) struct FiveSample {
    settings: settings::FiveSample,
    form: Form,
    spacing: Spacing,
    daylight: f32,
    toward_sun: Vec3,
    slots: ViewSlots<GpuFiveSample>,
    pipeline: Pipeline,
    later: Option<Later>,
}

impl FiveSample {
    pub(super) fn new(build: &Build<'_>, settings: &settings::FiveSample) -> Result<FiveSample, RenderError> {
        let SeaSurface::Calm(_) = build.scene.sea.build(build.scene.seed)? else {
            return Err(wrong_sea(build));
        };
        let form = stage::form(settings.variant);
        let spacing = if form.is_coarse { plane::COARSE } else { plane::GRIDDED };
        let map = form.map.levels(build.scene.seed, settings.wave_strength)?;
        let colors = [settings.zenith_color, settings.middle_color, settings.horizon_color];
        let sky = maps::sky_gradient(colors, f64::from(build.daylight));
        let has_later = settings.has_later() && form.stage.is_none();
        let later = has_later.then(|| Later::new(build, settings)).transpose()?;
        let slots = ViewSlots::new(build.device, "five-sample");
        let pipeline = Pipeline::new(build, &form, spacing, &slots, &map, &sky, later.as_ref());
        let toward_sun =
            if form.is_sun_broken { stage::broken_sun(build.toward_sun) } else { build.toward_sun };
        Ok(FiveSample {
            settings: settings.clone(),
            form,
            spacing,
            daylight: build.daylight,
            toward_sun,
            slots,
            pipeline,
            later,
        })
    }

    fn uniforms(&self, view: &View, time_s: f64) -> GpuFiveSample {
        let settings = &self.settings;
        let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
        // In whole cells, so that what vertices calculate does not swim.
        let centre = (eye / self.spacing.cell_m).round() * self.spacing.cell_m - eye;
        let layers = if self.form.stage.is_some() { &EARLY_LAYERS } else { &LAYERS };
        let dimmed = |color: [f64; 3]| color.map(|c| c as f32 * self.daylight);
        let (ground_from_eye, ground_points_per_m) =
            self.later.as_ref().map_or(([0.0; 2], [1.0; 2]), |later| later.ground_from(eye));
        let mut uniforms = GpuFiveSample {
            centre_from_eye: [centre.x as f32, -view.eye_m.y as f32, centre.y as f32],
            exponent: settings.exponent as f32,
            toward_sun: self.toward_sun.to_array(),
            sun_brightness: settings.sun_brightness as f32 * self.daylight,
            layers: layers.map(|layer| layer_uniform(&layer, eye, settings.uv_size_m, time_s)),
            emission: dimmed(settings.emission),
            layer_count: 5,
            reflection: settings.reflection.map(|r| r as f32),
            options: options(settings),
            ground_from_eye,
            ground_points_per_m,
            extinction_per_m: settings.extinction_per_m.map(|k| k as f32),
            distortion: settings.distortion as f32,
            shore_depth_m: settings.shore_depth_m as f32,
            swash_height_m: settings.swash_height_m as f32,
            swash_turns: (time_s / settings.swash_period_s).rem_euclid(1.0) as f32,
            daylight: self.daylight,
            ..Default::default()
        };
        if let Some(stage) = &self.form.stage {
            uniforms.options = (uniforms.options & gpu::SUN_DISC) | stage.options();
            uniforms.layer_count = stage.layer_count;
            // A sun brighter than white came with the last form.
            uniforms.sun_brightness = self.daylight;
            uniforms.reflection = [stage.sky_share; 3];
            uniforms.diffuse_color = stage.diffuse_color.map(|c| c * self.daylight);
            uniforms.ambient = stage.ambient;
            uniforms.diffuse = stage.diffuse;
            uniforms.sky_address = JUST_ABOVE_HORIZON;
            if let Absorption::Broken { near, far } | Absorption::Fresnel { near, far } = stage.absorption {
                (uniforms.near_absorption, uniforms.far_absorption) = (near, far);
            }
        }
        uniforms
    }
}

/// A layer as the shader reads it. Only the part of its coordinate that the repeating map shows is kept, at 64 bits,
/// so that neither a far place nor a late time costs precision.
fn layer_uniform(layer: &Layer, eye_m: DVec2, uv_size_m: f64, time_s: f64) -> [f32; 4] {
    let per_m = layer.scale / uv_size_m;
    let across_per_m = if layer.is_turned { per_m } else { 0.0 };
    let place =
        DVec2::new(per_m * eye_m.x + across_per_m * eye_m.y, per_m * eye_m.y - across_per_m * eye_m.x);
    let scrolled = DVec2::from(layer.seconds_per_tile.map(|seconds| (time_s / seconds).rem_euclid(1.0)));
    let origin = (place.fract_gl() + scrolled).fract_gl();
    [origin.x as f32, origin.y as f32, per_m as f32, across_per_m as f32]
}

/// The bits of what the settings switch on.
fn options(settings: &settings::FiveSample) -> u32 {
    let bit = |is_on: bool, bit: u32| if is_on { bit } else { 0 };
    bit(settings.depth_fog, gpu::DEPTH_FOG)
        | bit(settings.reflected_geometry, gpu::REFLECTED_GEOMETRY)
        | bit(settings.waves_meet_land, gpu::WAVES_MEET_LAND)
        | bit(settings.sun_disc, gpu::SUN_DISC)
}

impl Technique for FiveSample {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        if let Some(later) = &mut self.later {
            later.prepare(frame);
        }
        for (i, view) in frame.views.iter().enumerate() {
            self.slots.write(frame.queue, i, &self.uniforms(view, frame.time_s));
        }
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        if let Some(later) = &self.later {
            later.bind(pass, view);
        }
        self.pipeline.draw(pass, ViewSlots::<GpuFiveSample>::offset(view));
    }

    fn draw_sky(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) -> bool {
        self.pipeline.draw_dome(pass, ViewSlots::<GpuFiveSample>::offset(view));
        true
    }
}

#[cfg(test)]
mod tests;
