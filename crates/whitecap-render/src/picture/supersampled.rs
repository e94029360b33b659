//! Stills of many samples a pixel, in linear light.
//!
//! The whole view is drawn once for each sample, shifted by less than two pixels, and the mean is taken of light, not of
//! what a display shows of it (Haeberli and Akeley 1990, "The Accumulation Buffer"). What waves and maps are filtered
//! to is half a pixel, however many samples there are, so brightness and softness do not depend on their number.

use super::filter::{MAX_SAMPLES, sample_offsets_px};
use super::{Attachments, Picture, PictureRequest, Pictures, SetUp, Stage, read_picture, submit};
use crate::gpu::{checked, read_texture};
use crate::pass::{MeanPass, develop};
use crate::{Gpu, RenderError, TargetFormat, View, Water};
use whitecap_scene::{Scene, Sky};

/// Light of all brightness; one sample a pixel at a time.
pub(super) const LIGHT: TargetFormat = TargetFormat {
    color: wgpu::TextureFormat::Rgba32Float,
    depth: wgpu::TextureFormat::Depth32Float,
    depth_compare: wgpu::CompareFunction::Greater,
    sample_count: 1,
    sample_shading: false,
};

/// What it becomes.
const DEVELOPED: TargetFormat = TargetFormat { color: wgpu::TextureFormat::Rgba8Unorm, ..LIGHT };

/// Views that are prepared together: the sea is brought to its time once for all of them.
const VIEWS: usize = 8;

/// How light is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightUnit {
    /// Radiance of the scene in kcd/m²: luminance is 0.2126 R + 0.7152 G + 0.0722 B.
    KilocandelaPerSquareMetre,
    /// What the scene's panorama holds, whatever its file measures in.
    Panorama,
    /// The linear light of a display, 0 to 1 (white), for techniques that work on display values.
    DisplayWhite,
}

impl LightUnit {
    /// What pictures of `scene` are measured in.
    fn of(scene: &Scene) -> LightUnit {
        match scene.sky {
            _ if !scene.technique.is_scene_linear() => LightUnit::DisplayWhite,
            Sky::Atmosphere(_) => LightUnit::KilocandelaPerSquareMetre,
            _ => LightUnit::Panorama,
        }
    }
}

/// A picture of linear light with Rec. 709 primaries, rows from the top, without exposure, tone map and dither.
#[derive(Clone, Debug, PartialEq)]
pub struct LightPicture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Red, green and blue of each pixel.
    pub rgb: Vec<[f32; 3]>,
    /// What they are measured in.
    pub unit: LightUnit,
    /// What light of 1 becomes in the linear light of a picture whose white is 1, before the tone map.
    pub exposure: f32,
}

/// Renders `scene` as its camera sees it, `samples` times a pixel (1 to [`MAX_SAMPLES`]), each of them a whole drawing.
/// `progress` hears of each stage as it begins, and how many samples have been drawn.
///
/// # Errors
///
/// As [`super::render_picture`], and [`RenderError::LimitExceeded`] for another number of samples.
pub fn render_supersampled(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    samples: u32,
    progress: &mut dyn FnMut(Stage, u32),
) -> Result<Picture, RenderError> {
    Pictures::new(gpu, scene, request).supersampled(samples, progress)
}

/// As [`render_supersampled`], with the light itself in place of a picture of it.
///
/// # Errors
///
/// As [`render_supersampled`].
pub fn render_light(
    gpu: &Gpu,
    scene: &Scene,
    request: &PictureRequest,
    samples: u32,
    progress: &mut dyn FnMut(Stage, u32),
) -> Result<LightPicture, RenderError> {
    Pictures::new(gpu, scene, request).light(samples, progress)
}

impl Pictures<'_> {
    /// As [`render_supersampled`]. `progress` hears of each stage that there is something to do in.
    ///
    /// # Errors
    ///
    /// As [`render_supersampled`].
    pub fn supersampled(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(Stage, u32),
    ) -> Result<Picture, RenderError> {
        let gpu = self.gpu;
        let result = Still::draw(self, samples, progress).and_then(|still| {
            progress(Stage::ReadBack, samples);
            still.develop(gpu)
        });
        self.unless_lost(result)
    }

    /// As [`render_light`]. `progress` hears of each stage that there is something to do in.
    ///
    /// # Errors
    ///
    /// As [`render_supersampled`].
    pub fn light(
        &mut self,
        samples: u32,
        progress: &mut dyn FnMut(Stage, u32),
    ) -> Result<LightPicture, RenderError> {
        let gpu = self.gpu;
        let result = Still::draw(self, samples, progress).and_then(|still| {
            progress(Stage::ReadBack, samples);
            still.read(gpu)
        });
        self.unless_lost(result)
    }
}

/// Samples that have been drawn.
struct Still<'a> {
    water: &'a Water,
    view: View,
    mean: MeanPass,
    unit: LightUnit,
    /// Where the light is the scene's.
    exposure: Option<f32>,
}

impl<'a> Still<'a> {
    fn draw(
        pictures: &'a mut Pictures<'_>,
        samples: u32,
        progress: &mut dyn FnMut(Stage, u32),
    ) -> Result<Still<'a>, RenderError> {
        if !(1..=MAX_SAMPLES).contains(&samples) {
            return Err(RenderError::LimitExceeded {
                what: "the number of samples a pixel".into(),
                asked: samples.into(),
                accepted: format!("1 to {MAX_SAMPLES}"),
            });
        }
        // One drawing is what a window shows; of several each stands for a part of the pixel.
        let target = TargetFormat { sample_shading: samples > 1, ..LIGHT };
        let (gpu, view, time_s) = (pictures.gpu, pictures.view(), pictures.request.time_s);
        let unit = LightUnit::of(pictures.scene);
        let SetUp { water, attachments, exposure, .. } =
            pictures.set_up(&target, &mut |stage| progress(stage, 0))?;
        let mut mean = checked(&gpu.device, "a picture of this size", || {
            Ok(MeanPass::new(&gpu.device, &gpu.queue, &attachments.resolved))
        })?;
        progress(Stage::Draw, 0);
        let mut done = 0;
        for offsets in sample_offsets_px(samples).chunks(VIEWS) {
            let views: Vec<View> = offsets.iter().map(|&offset| view.shifted(offset)).collect();
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            checked(&gpu.device, "the frame", || {
                water.prepare(&gpu.device, &gpu.queue, &mut encoder, &views, time_s)?;
                submit(gpu, encoder)
            })?;
            for shifted in 0..views.len() {
                checked(&gpu.device, "the frame", || {
                    draw_sample(gpu, water, attachments, &mut mean, shifted)
                })?;
                done += 1;
                progress(Stage::Draw, done);
            }
        }
        Ok(Still { water, view, mean, unit, exposure: *exposure })
    }

    fn develop(&self, gpu: &Gpu) -> Result<Picture, RenderError> {
        let picture = checked(&gpu.device, "the picture", || {
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            let (shared, light) = (self.water.shared(), self.mean.mean());
            let (device, queue) = (&gpu.device, &gpu.queue);
            let picture = develop(device, queue, &mut encoder, shared, &self.view, light, &DEVELOPED);
            submit(gpu, encoder)?;
            Ok(picture)
        })?;
        read_picture(gpu, &picture)
    }

    fn read(&self, gpu: &Gpu) -> Result<LightPicture, RenderError> {
        let light = self.mean.mean();
        let bytes =
            checked(&gpu.device, "the picture's read-back", || read_texture(&gpu.device, &gpu.queue, light))?;
        gpu.check()?;
        let rgb = bytes.chunks_exact(size_of::<[f32; 4]>()).map(|pixel| {
            let [r, g, b, _] = bytemuck::pod_read_unaligned(pixel);
            [r, g, b]
        });
        let exposure = self.exposure.unwrap_or(1.0);
        Ok(LightPicture {
            width: light.width(),
            height: light.height(),
            rgb: rgb.collect(),
            unit: self.unit,
            exposure,
        })
    }
}

/// Draws `water` as its view sees it, and takes that in.
fn draw_sample(
    gpu: &Gpu,
    water: &Water,
    attachments: &Attachments,
    mean: &mut MeanPass,
    view: usize,
) -> Result<(), RenderError> {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let mut pass = attachments.begin(&mut encoder, &LIGHT, true);
    water.draw(&mut pass, view);
    water.draw_sky(&mut pass, view);
    drop(pass);
    mean.take(&gpu.queue, &mut encoder);
    submit(gpu, encoder)
}
