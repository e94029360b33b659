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
            // Browsers may keep it to themselves.
            name: if info.name.is_empty() { "a graphics device".to_owned() } else { info.name },
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
        let about = [&self.backend, &self.device_type, &self.driver].map(String::as_str);
        let told: Vec<&str> = about.into_iter().filter(|word| !word.is_empty()).collect();
        write!(f, "{} ({})", self.name, told.join(", "))
    }
}

/// Every adapter of the machine, the one that [`super::Gpu::open`] takes by default first.
#[cfg(not(target_arch = "wasm32"))]
pub fn list_adapters() -> Vec<AdapterDescription> {
    let lists = BACKENDS.iter().flat_map(|backends| pollster::block_on(enumerate(*backends)));
    lists.map(|(_, description)| description).collect()
}

/// OpenGL is asked last and only where the others have nothing to offer: looking for it loads a second
/// driver and takes as long as the first.
const BACKENDS: [wgpu::Backends; 2] = [wgpu::Backends::PRIMARY, wgpu::Backends::GL];

/// An adapter and what it is called.
type Described = (wgpu::Adapter, AdapterDescription);

#[cfg(not(target_arch = "wasm32"))]
pub(super) async fn choose(wanted: Option<&str>) -> Result<Described, RenderError> {
    first(enumerate, wanted).await
}

/// As [`choose`], of one instance, among those that can show on `surface`.
pub(super) async fn choose_showing(
    instance: &wgpu::Instance,
    surface: &wgpu::Surface<'_>,
    wanted: Option<&str>,
) -> Result<Described, RenderError> {
    let showing = async |backends| {
        let mut found = enumerate_of(instance, backends).await;
        found.retain(|(adapter, _)| adapter.is_surface_supported(surface));
        found
    };
    first(showing, wanted).await
}

/// The first that is wanted, of lists that are made one after the other as they are needed.
async fn first(
    list: impl AsyncFn(wgpu::Backends) -> Vec<Described>,
    wanted: Option<&str>,
) -> Result<Described, RenderError> {
    let mut seen = Vec::new();
    for backends in BACKENDS {
        for (adapter, description) in list(backends).await {
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
        _ if cfg!(target_arch = "wasm32") => Err(RenderError::NoAdapterInBrowser),
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
#[cfg(not(target_arch = "wasm32"))]
async fn enumerate(backends: wgpu::Backends) -> Vec<Described> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    enumerate_of(&wgpu::Instance::new(descriptor), backends).await
}

async fn enumerate_of(instance: &wgpu::Instance, backends: wgpu::Backends) -> Vec<Described> {
    let adapters = instance.enumerate_adapters(backends).await;
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
