//! Where a spectral sea is worked out.

use super::compute;
use crate::RenderError;
use std::any::Any;
use whitecap_waves::model::WaveModel;
use whitecap_waves::model::spectral::SpectralTile;

/// Who evolves, transforms and maps a spectral sea. Both draw the same sea, to within rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Backend {
    /// The processor, which then uploads the maps: faster where a processor draws as well.
    Cpu,
    /// Compute passes on the device: nothing but the time is uploaded.
    Gpu,
}

impl Backend {
    /// All of them.
    pub const ALL: [Backend; 2] = [Backend::Cpu, Backend::Gpu];

    /// As options and reports call it.
    pub fn word(self) -> &'static str {
        match self {
            Backend::Cpu => "cpu",
            Backend::Gpu => "gpu",
        }
    }

    /// The faster one on `device` for a tile of `resolution` samples a side: the device itself unless a processor
    /// plays its part, or unless it lacks what the passes need.
    pub fn auto(device: &wgpu::Device, resolution: usize) -> Backend {
        let software = device.adapter_info().device_type == wgpu::DeviceType::Cpu;
        if software || compute::missing(device, resolution).is_some() { Backend::Cpu } else { Backend::Gpu }
    }
}

/// The tile whose waves the device shall evolve; `None` where the processor does the work. `wanted` leaves the
/// choice to [`Backend::auto`] if it is `None`.
///
/// # Errors
///
/// [`RenderError::Unsupported`] if the GPU is asked for a model that has no spectrum, or if the device lacks what
/// it takes.
pub(super) fn evolved_on_device<'m>(
    wanted: Option<Backend>,
    device: &wgpu::Device,
    model: &'m dyn WaveModel,
) -> Result<Option<&'m SpectralTile>, RenderError> {
    let refuse = |what: String| Err(RenderError::Unsupported { what });
    let model: &dyn Any = model;
    let Some(tile) = model.downcast_ref::<SpectralTile>() else {
        return match wanted {
            Some(Backend::Gpu) => refuse("passes for a sea without a spectrum (backend cpu has them)".into()),
            _ => Ok(None),
        };
    };
    match wanted.unwrap_or_else(|| Backend::auto(device, tile.resolution())) {
        Backend::Cpu => Ok(None),
        Backend::Gpu => match compute::missing(device, tile.resolution()) {
            Some(what) => refuse(what.into()),
            None => Ok(Some(tile)),
        },
    }
}
