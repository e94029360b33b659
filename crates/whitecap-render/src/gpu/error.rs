//! What can go wrong between the scene and the picture, each with what to do about it.

use std::sync::Arc;
use whitecap_scene::panorama::PanoramaError;

/// An error of the renderer.
#[derive(Clone, Debug, thiserror::Error)]
pub enum RenderError {
    /// The machine offers no adapter at all.
    #[error(
        "no graphics adapter found (looked for {looked_for}). Install a driver; without a graphics card, \
         the software one: `sudo apt-get install libvulkan1 mesa-vulkan-drivers` on Debian and Ubuntu, \
         `sudo dnf install vulkan-loader mesa-vulkan-drivers` on Fedora, \
         `sudo pacman -S vulkan-icd-loader vulkan-swrast` on Arch"
    )]
    NoAdapter {
        /// The backends that were tried, in words.
        looked_for: String,
    },
    /// The browser knows WebGPU and gives no adapter.
    #[error(
        "this browser offers no graphics adapter: its settings or its list of unsuitable drivers keep WebGPU from this \
         machine's"
    )]
    NoAdapterInBrowser,
    /// There are adapters, but none is called that.
    #[error("no adapter matches \"{wanted}\"; there are: {available}")]
    NoSuchAdapter {
        /// What was asked for.
        wanted: String,
        /// The names there are.
        available: String,
    },
    /// The driver refused to open a device.
    #[error("adapter \"{adapter}\" refused to open: {reason}")]
    Device {
        /// The adapter's name.
        adapter: String,
        /// The driver's words.
        reason: String,
    },
    /// The device went away while working.
    #[error("the graphics device was lost ({reason}); try again, or another adapter with --adapter")]
    DeviceLost {
        /// The driver's words.
        reason: String,
    },
    /// The device has no memory left for this.
    #[error("the graphics device is out of memory for {what}; ask for a smaller picture or a coarser sea")]
    OutOfMemory {
        /// What was being made.
        what: String,
    },
    /// Asked for more than the device can hold in one object.
    #[error("{what} is {asked}; this adapter takes {accepted}")]
    LimitExceeded {
        /// The thing, in words.
        what: String,
        /// What was asked for.
        asked: u64,
        /// What the adapter takes, in words, unit included.
        accepted: String,
    },
    /// The device cannot do what the technique needs.
    #[error("this adapter lacks {what}; choose another with --adapter")]
    Unsupported {
        /// The missing ability.
        what: String,
    },
    /// wgpu rejected a call: a fault in whitecap, not in its input.
    #[error("internal error, please report it: {description}")]
    Internal {
        /// wgpu's words.
        description: String,
    },
    /// The scene's sea cannot be built.
    #[error(transparent)]
    Scene(#[from] whitecap_scene::SceneError),
    /// The scene's panorama cannot be read.
    #[error(transparent)]
    Panorama(Arc<PanoramaError>),
}

impl From<PanoramaError> for RenderError {
    fn from(error: PanoramaError) -> Self {
        RenderError::Panorama(Arc::new(error))
    }
}

impl From<wgpu::Error> for RenderError {
    fn from(error: wgpu::Error) -> Self {
        match error {
            wgpu::Error::OutOfMemory { .. } => RenderError::OutOfMemory { what: "the current frame".into() },
            wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
                RenderError::Internal { description }
            }
        }
    }
}

/// Runs `make` and turns out-of-memory and validation errors of its wgpu calls into a [`RenderError`]
/// that names `what` was being made.
///
/// A browser answers later than it can be waited for. There the errors go where uncaptured ones do: [`super::Gpu::check`]
/// has them with the next frame.
///
/// # Errors
///
/// [`RenderError::OutOfMemory`] or [`RenderError::Internal`], or what `make` itself returns.
pub fn checked<T>(
    device: &wgpu::Device,
    what: &str,
    make: impl FnOnce() -> Result<T, RenderError>,
) -> Result<T, RenderError> {
    if cfg!(target_arch = "wasm32") {
        return make();
    }
    let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let made = make();
    let memory = pollster::block_on(memory.pop());
    let validation = pollster::block_on(validation.pop());
    if memory.is_some() {
        return Err(RenderError::OutOfMemory { what: what.into() });
    }
    match validation {
        Some(error) => Err(RenderError::from(error)),
        None => made,
    }
}
