//! Berglund's shader of five samples.

use super::{Build, Frame, Technique};
use crate::RenderError;
use whitecap_scene::technique as settings;

pub(super) struct FiveSample;

impl FiveSample {
    pub(super) fn new(
        _build: &Build<'_>,
        _settings: &settings::FiveSample,
    ) -> Result<FiveSample, RenderError> {
        Ok(FiveSample)
    }
}

impl Technique for FiveSample {
    fn prepare(&mut self, _frame: &mut Frame<'_>) -> Result<(), RenderError> {
        Ok(())
    }

    fn draw(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) {}
}
