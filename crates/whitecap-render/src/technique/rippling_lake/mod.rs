//! ATI's lake of 2002.

use super::{Build, Frame, Technique};
use crate::RenderError;
use whitecap_scene::technique as settings;

pub(super) struct RipplingLake;

impl RipplingLake {
    pub(super) fn new(
        _build: &Build<'_>,
        _settings: &settings::RipplingLake,
    ) -> Result<RipplingLake, RenderError> {
        Ok(RipplingLake)
    }
}

impl Technique for RipplingLake {
    fn prepare(&mut self, _frame: &mut Frame<'_>) -> Result<(), RenderError> {
        Ok(())
    }

    fn draw(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) {}
}
