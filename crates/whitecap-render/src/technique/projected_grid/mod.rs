//! Johanson's projected grid of 2004.

use super::{Build, Frame, Technique};
use crate::RenderError;
use whitecap_scene::technique as settings;

pub(super) struct ProjectedGrid;

impl ProjectedGrid {
    pub(super) fn new(
        _build: &Build<'_>,
        _settings: &settings::ProjectedGrid,
    ) -> Result<ProjectedGrid, RenderError> {
        Ok(ProjectedGrid)
    }
}

impl Technique for ProjectedGrid {
    fn prepare(&mut self, _frame: &mut Frame<'_>) -> Result<(), RenderError> {
        Ok(())
    }

    fn draw(&self, _pass: &mut wgpu::RenderPass<'_>, _view: usize) {}
}
