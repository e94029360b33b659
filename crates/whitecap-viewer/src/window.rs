//! The window's surface: configured for its size, and again whenever the window system wants it.

use crate::ViewError;
use std::sync::Arc;
use whitecap_render::Gpu;
use winit::dpi::PhysicalSize;
use winit::event_loop::OwnedDisplayHandle;
use winit::window::Window;

/// A window and the surface in it.
pub(crate) struct Canvas {
    pub(crate) window: Arc<Window>,
    pub(crate) gpu: Arc<Gpu>,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    /// The surface has no size: the window is minimised, or smaller than a pixel.
    is_empty: bool,
}

impl Canvas {
    /// Opens a device that can show on the window: in a browser later, elsewhere without waiting.
    pub(crate) async fn new(
        display: OwnedDisplayHandle,
        window: Window,
        adapter: Option<String>,
    ) -> Result<Canvas, ViewError> {
        let window = Arc::new(window);
        let display = Box::new(display);
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_with_display_handle(display));
        let surface = instance
            .create_surface(Arc::clone(&window))
            .map_err(|error| ViewError::Window(error.to_string()))?;
        let (gpu, adapter) = Gpu::open_showing(&instance, &surface, adapter.as_deref()).await?;
        let PhysicalSize { width, height } = window.inner_size();
        let mut config = surface
            .get_default_config(&adapter, width.max(1), height.max(1))
            .ok_or_else(|| ViewError::Window(format!("{} cannot show on this window", gpu.adapter)))?;
        // Display values as they are, which water and panel both write.
        let formats = surface.get_capabilities(&adapter).formats;
        config.format = formats.iter().copied().find(|format| !format.is_srgb()).unwrap_or(config.format);
        config.view_formats.clear();
        surface.configure(&gpu.device, &config);
        let is_empty = width == 0 || height == 0;
        Ok(Canvas { window, gpu: Arc::new(gpu), surface, config, is_empty })
    }

    /// The colour format of the surface.
    pub(crate) fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// Pixels across and down.
    pub(crate) fn size_px(&self) -> [u32; 2] {
        [self.config.width, self.config.height]
    }

    /// Whether there is nothing to draw on.
    pub(crate) fn is_empty(&self) -> bool {
        self.is_empty
    }

    pub(crate) fn resize(&mut self, size: PhysicalSize<u32>) {
        self.is_empty = size.width == 0 || size.height == 0;
        if !self.is_empty {
            let most = self.gpu.device.limits().max_texture_dimension_2d;
            (self.config.width, self.config.height) = (size.width.min(most), size.height.min(most));
            self.surface.configure(&self.gpu.device, &self.config);
        }
    }

    /// The next frame's texture, or none this time: the window is hidden or changes.
    pub(crate) fn next(&mut self) -> Option<wgpu::SurfaceTexture> {
        use wgpu::CurrentSurfaceTexture as Next;
        match self.surface.get_current_texture() {
            Next::Success(texture) => Some(texture),
            Next::Suboptimal(_) | Next::Outdated | Next::Lost => {
                self.surface.configure(&self.gpu.device, &self.config);
                None
            }
            Next::Timeout | Next::Occluded | Next::Validation => None,
        }
    }
}
