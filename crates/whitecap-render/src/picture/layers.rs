//! What a picture shows, beside its light: depth, positions, normals, masks.
//!
//! One sample a pixel, at its centre, and no mean of several: a mean of two depths is the depth of nothing. Depth and
//! positions are those of the depth buffer that the technique draws into, so every technique has them. Objects are drawn
//! before the water: what is nearer after it is water.

use super::supersampled::LIGHT;
use super::{Attachments, PictureRequest, Pictures, SetUp, Stage, submit};
use crate::TargetFormat;
use crate::gpu::{checked, read_texture};
use crate::{Gpu, RenderError, View, Water};
use glam::{DMat4, DVec3, DVec4, Mat4};
use whitecap_scene::Scene;

/// What they are drawn into: on the mesh of a still.
pub(super) const TARGET: TargetFormat = TargetFormat { sample_shading: true, ..LIGHT };

/// Origins of positions lie at multiples of this, metres: 32 bits then place what is near to a tenth of a millimetre.
const ORIGIN_STEP_M: f64 = 1024.0;

/// What a pixel's centre shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// Nothing but sky.
    Sky,
    /// Water.
    Water,
    /// An object, in or over the water.
    Object,
}

/// What techniques know of a surface that draw in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Shading {
    /// Unit normals in the world's axes; of water that of the slopes which the pixel resolves. 0 where there is sky.
    pub normal: Vec<[f32; 3]>,
    /// How much of the pixel's luminance is the sun, reflected by water: 0 to 1.
    pub glint: Vec<f32>,
}

/// What each pixel's centre shows, and where it is; rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct AuxPicture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// What positions are relative to, in the world: the world's own origin for eyes within 512 m of it to each side, and
    /// a multiple of 1,024 m east and south beyond.
    pub origin_m: DVec3,
    /// What is seen.
    pub shows: Vec<Shows>,
    /// Distance from the plane through the eye across the view, metres; infinite where there is sky.
    pub depth_m: Vec<f32>,
    /// Distance from the eye along the ray, metres; infinite where there is sky.
    pub distance_m: Vec<f32>,
    /// Positions (x east, y up, z south) from the origin, metres; 0 where there is sky. They are those of the picture,
    /// whose sea falls with the Earth's curvature, where the scene has one.
    pub position_m: Vec<[f32; 3]>,
    /// Where the technique has it.
    pub shading: Option<Shading>,
    /// The view's axes (x right, y up, looking along −z) from positions.
    pub view_from_position: Mat4,
    /// Clip space from positions.
    pub clip_from_position: Mat4,
}

/// Renders what `scene` shows beside its light, as its camera sees it. `progress` hears of each stage as it begins.
///
/// # Errors
///
/// As [`super::render_picture`].
pub fn render_aux(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    progress: &mut dyn FnMut(Stage),
) -> Result<AuxPicture, RenderError> {
    Pictures::new(gpu, scene, request).aux(progress)
}

impl Pictures<'_> {
    /// As [`render_aux`]. `progress` hears of each stage that there is something to do in.
    ///
    /// # Errors
    ///
    /// As [`super::render_picture`].
    pub fn aux(&mut self, progress: &mut dyn FnMut(Stage)) -> Result<AuxPicture, RenderError> {
        self.expects_aux = true;
        let (gpu, view, time_s) = (self.gpu, self.view(), self.request.time_s);
        let set_up = self.set_up(&TARGET, progress);
        let result = set_up.and_then(|set_up| draw(gpu, set_up, view, time_s, progress));
        self.unless_lost(result)
    }
}

fn draw(
    gpu: &Gpu,
    set_up: &mut SetUp,
    view: View,
    time_s: f64,
    progress: &mut dyn FnMut(Stage),
) -> Result<AuxPicture, RenderError> {
    let SetUp { water, attachments, aux, .. } = set_up;
    let aux = *aux;
    progress(Stage::Draw);
    checked(&gpu.device, "the frame", || {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        water.prepare(&gpu.device, &gpu.queue, &mut encoder, &[view], time_s)?;
        submit(gpu, encoder)
    })?;
    let frame = Frame { gpu, water, attachments };
    let objects = frame.pass(true, |pass| {
        if !(aux && water.draw_objects_aux(pass, 0)) {
            water.draw_objects(pass, 0);
        }
    });
    objects?;
    let objects = if water.has_objects() { frame.depths()? } else { Vec::new() };
    let mut has_aux = false;
    frame.pass(false, |pass| {
        has_aux = aux && water.draw_surface_aux(pass, 0);
        if !has_aux {
            water.draw_surface(pass, 0);
        }
    })?;
    let all = frame.depths()?;
    let shading = if has_aux { Some(frame.shading()?) } else { None };
    progress(Stage::ReadBack);
    gpu.check()?;
    Ok(AuxPicture::of(&view, &objects, &all, shading))
}

/// A frame that is drawn in parts.
struct Frame<'a> {
    gpu: &'a Gpu,
    water: &'a Water,
    attachments: &'a Attachments,
}

impl Frame<'_> {
    fn pass(&self, first: bool, draw: impl FnOnce(&mut wgpu::RenderPass<'_>)) -> Result<(), RenderError> {
        checked(&self.gpu.device, "the frame", || {
            let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
            draw(&mut self.attachments.begin(&mut encoder, &LIGHT, first));
            submit(self.gpu, encoder)
        })
    }

    fn depths(&self) -> Result<Vec<f32>, RenderError> {
        Ok(bytemuck::pod_collect_to_vec(&self.read(&self.attachments.depth)?))
    }

    fn colors(&self) -> Result<Vec<[f32; 4]>, RenderError> {
        Ok(bytemuck::pod_collect_to_vec(&self.read(&self.attachments.resolved)?))
    }

    fn read(&self, texture: &wgpu::Texture) -> Result<Vec<u8>, RenderError> {
        checked(&self.gpu.device, "the picture's read-back", || {
            read_texture(&self.gpu.device, &self.gpu.queue, texture)
        })
    }

    /// What has been drawn, against the light that the picture has there.
    fn shading(&self) -> Result<Shading, RenderError> {
        let drawn = self.colors()?;
        self.pass(true, |pass| self.water.draw(pass, 0))?;
        let light = self.colors()?;
        let glint = drawn.iter().zip(&light).map(|(drawn, [r, g, b, _])| {
            let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
            if luminance > 0.0 { (drawn[3] / luminance).clamp(0.0, 1.0) } else { 0.0 }
        });
        let glint = glint.collect();
        Ok(Shading { normal: drawn.iter().map(|&[x, y, z, _]| [x, y, z]).collect(), glint })
    }
}

impl AuxPicture {
    /// `objects` is the depth of objects alone, empty where there are none, `all` that of water, too.
    fn of(view: &View, objects: &[f32], all: &[f32], shading: Option<Shading>) -> AuxPicture {
        let [width, height] = view.size_px;
        let origin_m = (view.eye_m / ORIGIN_STEP_M).round() * ORIGIN_STEP_M * DVec3::new(1.0, 0.0, 1.0);
        let far_depth = LIGHT.far_depth();
        let view_from_clip = view.clip_from_view.as_dmat4().inverse();
        let world_from_view = view.view_from_world.as_dquat().inverse();
        let mut picture = AuxPicture {
            width,
            height,
            origin_m,
            shows: Vec::with_capacity(all.len()),
            depth_m: Vec::with_capacity(all.len()),
            distance_m: Vec::with_capacity(all.len()),
            position_m: Vec::with_capacity(all.len()),
            shading,
            view_from_position: (DMat4::from_quat(view.view_from_world.as_dquat())
                * DMat4::from_translation(origin_m - view.eye_m))
            .as_mat4(),
            clip_from_position: Mat4::IDENTITY,
        };
        picture.clip_from_position = view.clip_from_view * picture.view_from_position;
        let eye_m = view.eye_m - origin_m;
        for (i, &depth) in all.iter().enumerate() {
            if depth == far_depth {
                picture.push(Shows::Sky, f64::INFINITY, f64::INFINITY, DVec3::ZERO);
                continue;
            }
            let shows = if objects.get(i) == Some(&depth) { Shows::Object } else { Shows::Water };
            let (x, y) = (i as u32 % width.max(1), i as u32 / width.max(1));
            let clip = DVec4::new(
                (f64::from(x) + 0.5) / f64::from(width) * 2.0 - 1.0,
                1.0 - (f64::from(y) + 0.5) / f64::from(height) * 2.0,
                f64::from(depth),
                1.0,
            );
            let from_eye = view_from_clip * clip;
            let from_eye = from_eye.truncate() / from_eye.w;
            let position = eye_m + world_from_view * from_eye;
            picture.push(shows, -from_eye.z, from_eye.length(), position);
        }
        picture
    }

    fn push(&mut self, shows: Shows, depth_m: f64, distance_m: f64, position_m: DVec3) {
        self.shows.push(shows);
        self.depth_m.push(depth_m as f32);
        self.distance_m.push(distance_m as f32);
        self.position_m.push(position_m.as_vec3().to_array());
    }
}
