//! ATI's ocean of 2002.

use super::{Build, Frame, Technique};
use crate::RenderError;
use whitecap_scene::technique as settings;

pub(super) struct OceanWater;

impl OceanWater {
    pub(super) fn new(
        _build: &Build<'_>,
        _settings: &settings::OceanWater,
    ) -> Result<OceanWater, RenderError> {
        Ok(OceanWater)
    }
}

impl Technique for OceanWater {
    fn prepare(&mut self, _frame: &mut Frame<'_>) -> Result<(), RenderError> {
        Ok(())
    }

    fn draw(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) {}
}
