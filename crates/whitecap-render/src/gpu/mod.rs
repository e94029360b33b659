//! A device to draw on without a window: adapter choice, errors, read-back.
//!
//! Embedders bring their own device and need nothing from here but [`RenderError`] and [`checked`].

mod adapter;
mod error;
#[cfg(not(target_arch = "wasm32"))]
pub mod for_tests;
mod read_back;
pub(crate) mod resources;

pub use adapter::AdapterDescription;
#[cfg(not(target_arch = "wasm32"))]
pub use adapter::list_adapters;
pub use error::{RenderError, checked};
pub use read_back::{read_buffer, read_level, read_texture};

use std::sync::{Arc, OnceLock};

/// An opened adapter with its device and queue.
///
/// Uncaptured errors never abort the process: the first one is kept and handed out by [`Gpu::check`].
pub struct Gpu {
    /// What was opened.
    pub adapter: AdapterDescription,
    /// The device, with WebGPU's default limits raised to the adapter's for buffer and texture sizes.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    fault: Arc<OnceLock<RenderError>>,
}

impl Gpu {
    /// Opens the best adapter, or the best whose name, backend or driver contains `wanted`
    /// (ignoring case).
    ///
    /// "Best" is Vulkan, Metal and Direct3D 12 before OpenGL, then real GPUs before software.
    ///
    /// # Errors
    ///
    /// [`RenderError::NoAdapter`] when the machine has none, [`RenderError::NoSuchAdapter`] when none
    /// matches `wanted`, [`RenderError::Device`] when the driver refuses a device.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn open(wanted: Option<&str>) -> Result<Gpu, RenderError> {
        pollster::block_on(async {
            let (adapter, description) = adapter::choose(wanted).await?;
            Gpu::of(&adapter, description).await
        })
    }

    /// Opens one of `instance`'s adapters that can show on `surface`, the best, or the best whose name, backend or driver
    /// contains `wanted`, and gives the adapter itself too. In a browser it takes its time; elsewhere it never waits.
    ///
    /// # Errors
    ///
    /// [`RenderError::NoAdapter`] or [`RenderError::NoAdapterInBrowser`] when there is none,
    /// [`RenderError::NoSuchAdapter`] when none matches `wanted`, [`RenderError::Device`] when the driver refuses a device.
    pub async fn open_showing(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
        wanted: Option<&str>,
    ) -> Result<(Gpu, wgpu::Adapter), RenderError> {
        let (adapter, description) = adapter::choose_showing(instance, surface, wanted).await?;
        Ok((Gpu::of(&adapter, description).await?, adapter))
    }

    async fn of(adapter: &wgpu::Adapter, description: AdapterDescription) -> Result<Gpu, RenderError> {
        let limits = adapter::limits(adapter);
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("whitecap"),
            required_features: wgpu::Features::empty(),
            required_limits: limits,
            ..Default::default()
        });
        let (device, queue) = request
            .await
            .map_err(|e| RenderError::Device { adapter: description.name.clone(), reason: e.to_string() })?;

        let fault = Arc::new(OnceLock::new());
        let lost = Arc::clone(&fault);
        device.set_device_lost_callback(move |reason, message| {
            let _ = lost.set(RenderError::DeviceLost { reason: format!("{reason:?}: {message}") });
        });
        let uncaptured = Arc::clone(&fault);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            let _ = uncaptured.set(RenderError::from(error));
        }));
        Ok(Gpu { adapter: description, device, queue, fault })
    }

    /// The first error that no scope caught, a lost device among them.
    ///
    /// # Errors
    ///
    /// That error.
    pub fn check(&self) -> Result<(), RenderError> {
        // The news of a lost device comes with the next poll.
        let _ = self.device.poll(wgpu::PollType::Poll);
        self.fault.get().cloned().map_or(Ok(()), Err)
    }
}
