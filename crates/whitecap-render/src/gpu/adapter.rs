//! Which adapter to open, and how to name it to people and programs.

use super::RenderError;

/// An adapter in words, for people and for JSON.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct AdapterDescription {
    /// The device's name, as its driver gives it.
    pub name: String,
    /// `vulkan`, `metal`, `dx12` or `gl`.
    pub backend: String,
    /// `discrete-gpu`, `integrated-gpu`, `virtual-gpu`, `cpu` or `other`.
    pub device_type: String,
    /// The driver and its version.
    pub driver: String,
    /// Whether the adapter can do all that WebGPU asks for.
    pub webgpu_compliant: bool,
}

impl AdapterDescription {
    fn of(adapter: &wgpu::Adapter) -> Self {
        let info = adapter.get_info();
        let device_type = match info.device_type {
            wgpu::DeviceType::DiscreteGpu => "discrete-gpu",
            wgpu::DeviceType::IntegratedGpu => "integrated-gpu",
            wgpu::DeviceType::VirtualGpu => "virtual-gpu",
            wgpu::DeviceType::Cpu => "cpu",
            wgpu::DeviceType::Other => "other",
        };
        AdapterDescription {
            name: info.name,
            backend: info.backend.to_str().to_owned(),
            device_type: device_type.to_owned(),
            driver: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
            webgpu_compliant: adapter.get_downlevel_capabilities().is_webgpu_compliant(),
        }
    }

    /// Whether a processor does the drawing.
    pub fn is_software(&self) -> bool {
        self.device_type == "cpu"
    }

    fn matches(&self, wanted: &str) -> bool {
        let wanted = wanted.to_lowercase();
        [&self.name, &self.backend, &self.driver].iter().any(|s| s.to_lowercase().contains(&wanted))
    }

    /// Lower is better.
    fn rank(&self) -> u8 {
        match self.device_type.as_str() {
            "discrete-gpu" => 0,
            "integrated-gpu" => 1,
            "virtual-gpu" => 2,
            "other" => 3,
            _ => 4,
        }
    }
}

impl std::fmt::Display for AdapterDescription {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({}, {}, {})", self.name, self.backend, self.device_type, self.driver)
    }
}

/// Every adapter of the machine, the one that [`super::Gpu::open`] takes by default first.
pub fn list_adapters() -> Vec<AdapterDescription> {
    BACKENDS.iter().flat_map(|backends| enumerate(*backends)).map(|(_, description)| description).collect()
}

/// OpenGL is asked last and only where the others have nothing to offer: looking for it loads a second
/// driver and takes as long as the first.
const BACKENDS: [wgpu::Backends; 2] = [wgpu::Backends::PRIMARY, wgpu::Backends::GL];

pub(super) fn choose(wanted: Option<&str>) -> Result<(wgpu::Adapter, AdapterDescription), RenderError> {
    let mut seen = Vec::new();
    for backends in BACKENDS {
        for (adapter, description) in enumerate(backends) {
            if wanted.is_none_or(|wanted| description.matches(wanted)) {
                return Ok((adapter, description));
            }
            seen.push(format!("\"{}\" ({})", description.name, description.backend));
        }
    }
    match wanted {
        Some(wanted) if !seen.is_empty() => {
            Err(RenderError::NoSuchAdapter { wanted: wanted.to_owned(), available: seen.join(", ") })
        }
        _ => Err(RenderError::NoAdapter { looked_for: "Vulkan, Metal, Direct3D 12, OpenGL".into() }),
    }
}

/// WebGPU's default limits, so that what runs here runs in a browser, but pictures and meshes as large
/// as the adapter takes; on OpenGL, what the driver offers.
pub(super) fn limits(adapter: &wgpu::Adapter) -> wgpu::Limits {
    let own = adapter.limits();
    if !adapter.get_downlevel_capabilities().is_webgpu_compliant() {
        return own;
    }
    wgpu::Limits {
        max_texture_dimension_2d: own.max_texture_dimension_2d,
        max_buffer_size: own.max_buffer_size,
        ..wgpu::Limits::default()
    }
}

/// The adapters of some backends, the best first.
fn enumerate(backends: wgpu::Backends) -> Vec<(wgpu::Adapter, AdapterDescription)> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = wgpu::Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let mut found: Vec<_> = adapters
        .into_iter()
        .map(|adapter| {
            let description = AdapterDescription::of(&adapter);
            (adapter, description)
        })
        .collect();
    found.sort_by_key(|(_, description)| description.rank());
    found
}
