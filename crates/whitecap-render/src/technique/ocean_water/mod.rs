//! "Rendering Ocean Water" by John Isidoro, Alex Vlachos and Chris Brennan of ATI (*Direct3D ShaderX*, 2002), to the
//! letter of its vertex and pixel shader.
//!
//! A sum of four sines by Taylor series raises a plane and tilts its tangent frame; two bump maps scroll across each
//! other; the reflected view vector looks into an 8-bit sky, squared; a 1-D gradient gives the water's colour; green to
//! the eighth power sparkles. One pass, one draw.
//!
//! What the text leaves open, and what we do (docs/ocean-water.md has the whole list):
//! - its plane has no size; ours follows the viewer, is refined by N-patches, and ends at the horizon. Waves are
//!   calmed, by the text's own damping, before the mesh gets too coarse for them;
//! - its artwork is not printed: bump map and gradient are made from settings, the sky is the scene's;
//! - its shores were painted: ours follow from the ground under the water.

mod artwork;
mod damping;
mod gpu;
mod mesh;
mod sky_map;

use super::{Build, Frame, Technique, wrong_sea};
use crate::RenderError;
use crate::surface::GpuSines;
use crate::uniforms::ViewSlots;
use crate::view::View;
use damping::Damping;
use glam::{DVec2, DVec3};
use gpu::{Artwork, GpuOceanWater, Pipeline};
use mesh::Mesh;
use whitecap_scene::mesh::Ground;
use whitecap_scene::sea::SeaSurface;
use whitecap_scene::technique as settings;
use whitecap_waves::model::sines::SumOfSines;
use whitecap_waves::optics::classics::bump_coordinates;

/// Where triangles are dear, and where they are not.
const REFINEMENT_ON_A_PROCESSOR: u32 = 3;
const REFINEMENT_ON_A_GRAPHICS_CARD: u32 = 8;

pub(super) struct OceanWater {
    settings: settings::OceanWater,
    sines: SumOfSines,
    ground: Option<Ground>,
    mesh: Mesh,
    slots: ViewSlots<GpuOceanWater>,
    pipeline: Pipeline,
}

impl OceanWater {
    pub(super) fn new(build: &Build<'_>, settings: &settings::OceanWater) -> Result<OceanWater, RenderError> {
        let SeaSurface::Sines(sines) = build.scene.sea.build(build.scene.seed)? else {
            return Err(wrong_sea(build));
        };
        let refinement = settings.refinement.unwrap_or(if build.is_software() {
            REFINEMENT_ON_A_PROCESSOR
        } else {
            REFINEMENT_ON_A_GRAPHICS_CARD
        });
        let mesh = Mesh::new(settings, refinement);
        let ground = build.objects.ground();
        let dim = |[r, g, b, a]: [u8; 4]| {
            let [r, g, b] = [r, g, b].map(|c| (f32::from(c) * build.daylight + 0.5) as u8);
            [r, g, b, a]
        };
        let artwork = Artwork {
            bump_levels: artwork::bump_levels(settings, build.scene.seed)?,
            gradient: artwork::gradient(settings).into_iter().map(dim).collect(),
            sky: sky_map::sky_map(build),
        };
        let slots = ViewSlots::new(build.device, "ocean-water");
        let pipeline = Pipeline::new(build, &mesh.drawn, &slots, &artwork);
        Ok(OceanWater { settings: settings.clone(), sines, ground, mesh, slots, pipeline })
    }

    /// Phases and scrolls are reduced here, in f64 and at the mesh's centre: the shader sees small numbers
    /// wherever the viewer is and whatever the time.
    fn uniforms(&self, view: &View, time_s: f64) -> GpuOceanWater {
        let settings = &self.settings;
        let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
        let centre = self.mesh.centre_m(eye);
        let uv = self.sines.uv(centre);
        let [u0, v0] = settings.first_scroll_per_s;
        let [u1, v1] = settings.second_scroll_per_s;
        let [first, swapped] =
            bump_coordinates((uv * settings.bump_repeats).fract_gl(), time_s, [u0, v0, u1, v1]);
        let mended_tangent = settings.tangent == settings::Tangent::Mended;
        GpuOceanWater {
            sines: GpuSines {
                mended_tangent: f32::from(u8::from(mended_tangent)),
                ..GpuSines::new(&self.sines, uv, time_s)
            },
            // The shader swaps the second pair itself, after it has added the vertex's place.
            centre_bump_uv: [first.x, first.y, swapped.y, swapped.x].map(|c| c as f32),
            centre_from_eye: DVec3::new(centre.x - eye.x, -view.eye_m.y, centre.y - eye.y)
                .as_vec3()
                .to_array(),
            glow: match settings.highlights {
                settings::Highlights::GreenPower => 0.0,
                settings::Highlights::GlowMap => 1.0,
            },
            highlight_color: settings.highlight_color.map(|c| c as f32),
            bumps_per_m: (settings.bump_repeats / self.sines.parameters().uv_size_m) as f32,
        }
    }

    /// v5.x of the coarse grid's vertices as `view` sees them.
    fn coarse_damping(&self, view: &View) -> Vec<f32> {
        let eye = DVec2::new(view.eye_m.x, view.eye_m.z);
        let centre = self.mesh.centre_m(eye);
        let damping = Damping {
            ground: self.ground.as_ref(),
            shore_depth_m: self.settings.shore_depth_m,
            half_m: f64::from(self.mesh.half_m),
            eye,
            eye_height_m: view.eye_m.y,
        };
        self.mesh.coarse.iter().map(|place| damping.at(centre + place.as_dvec2())).collect()
    }
}

impl Technique for OceanWater {
    fn prepare(&mut self, frame: &mut Frame<'_>) -> Result<(), RenderError> {
        for (i, view) in frame.views.iter().enumerate() {
            self.slots.write(frame.queue, i, &self.uniforms(view, frame.time_s));
            let damping = self.mesh.drawn_damping(&self.coarse_damping(view));
            self.pipeline.write_damping(frame.device, frame.queue, i, &damping);
        }
        frame.end_of_pass("sea");
        Ok(())
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        self.pipeline.draw(pass, view);
    }
}

#[cfg(test)]
mod tests;
