//! A window on a desktop.

use crate::ViewError;
use crate::app::{App, Asked};
use crate::clock::Clock;
use crate::document::Document;
use crate::link::Link;
use crate::window::Canvas;
use std::future::Future;
use std::path::{Path, PathBuf};
use whitecap_render::Gpu;
use whitecap_render::picture::{Picture, PictureRequest, render_picture};
use whitecap_scene::Scene;
use winit::dpi::PhysicalSize;
use winit::event_loop::{EventLoop, EventLoopProxy};
use winit::window::{Window, WindowAttributes};

/// What to view, and how.
#[derive(Clone, Debug)]
pub struct ViewOptions {
    /// A named scene or the path of a scene file.
    pub scene: String,
    /// Part of the name, backend or driver of the adapter.
    pub adapter: Option<String>,
    /// Width and height of the window, pixels.
    pub size_px: [u32; 2],
    /// The scene's time at the start, s.
    pub time_s: f64,
    /// Whether time stands still at the start.
    pub is_paused: bool,
    /// Writes the bytes of a picture's file (PNG): the viewer writes no format of its own.
    pub encode: fn(&Picture) -> std::io::Result<Vec<u8>>,
    /// Writes a file whole or not at all.
    pub write: fn(&Path, &[u8]) -> Result<(), String>,
}

/// Opens the window and returns when it is closed.
///
/// # Errors
///
/// If the scene cannot be read, there is no display, or no adapter can show on it. Later mistakes are shown in the window.
pub fn view(options: ViewOptions) -> Result<(), ViewError> {
    let document = Document::open(&options.scene)?;
    let event_loop = EventLoop::with_user_event()
        .build()
        .map_err(|error| ViewError::NoDisplay { reason: reason(&error) })?;
    let mut clock = Clock::from(options.time_s);
    if options.is_paused {
        clock.toggle_pause();
    }
    let host = Host { options, events: event_loop.create_proxy() };
    let mut app = App::new(host, document, clock);
    event_loop.run_app(&mut app).map_err(|error| ViewError::Window(error.to_string()))?;
    app.failed.map_or(Ok(()), Err)
}

pub(crate) struct Host {
    options: ViewOptions,
    events: EventLoopProxy<Asked>,
}

impl Host {
    /// Part of the name of the adapter that is asked for.
    pub(crate) fn adapter(&self) -> Option<String> {
        self.options.adapter.clone()
    }

    pub(crate) fn attributes(&self) -> WindowAttributes {
        let [width, height] = self.options.size_px;
        Window::default_attributes().with_inner_size(PhysicalSize::new(width, height))
    }

    /// Sends the canvas to the viewer once it is there, which is at once.
    pub(crate) fn open(&self, canvas: impl Future<Output = Result<Canvas, ViewError>>) {
        // A closed loop needs no canvas.
        let _ = self.events.send_event(Asked::Opened(Box::new(pollster::block_on(canvas))));
    }

    /// Writes a file with a number that no file has yet, and gives its name.
    pub(crate) fn write_new(&self, stem: &str, extension: &str, bytes: &[u8]) -> Result<String, String> {
        let free = (1..10_000)
            .map(|number| PathBuf::from(format!("{stem}-{number:03}.{extension}")))
            .find(|path| !path.exists());
        let path = free.ok_or("there are 10,000 files of this name already")?;
        (self.options.write)(&path, bytes)?;
        Ok(path.display().to_string())
    }

    /// Writes the picture that `whitecap render` makes of a scene.
    pub(crate) fn write_picture(
        &self,
        stem: &str,
        gpu: &Gpu,
        scene: &Scene,
        [width, height]: [u32; 2],
        time_s: f64,
    ) -> Result<String, String> {
        let request = PictureRequest { backend: None, width, height, time_s };
        let picture = render_picture(gpu, scene, &request, &mut |_| {}).map_err(|error| error.to_string())?;
        let bytes = (self.options.encode)(&picture).map_err(|error| error.to_string())?;
        self.write_new(stem, "png", &bytes)
    }

    pub(crate) fn copy(&self, input: &mut egui_winit::State, text: &str) {
        input.set_clipboard_text(text.to_owned());
    }

    /// A link as one writes it down: here its fragment, for the address of the page.
    pub(crate) fn address(&self, link: &Link) -> String {
        format!("#{link}")
    }

    /// Hears that the address has another link.
    pub(crate) fn address_changed(&self) {}

    /// Whether the next frame goes without the panel.
    pub(crate) fn wants_water_alone(&self) -> bool {
        false
    }

    /// Hears what the panel does.
    pub(crate) fn speak(&self, _: &egui::PlatformOutput) {}

    /// Hears that a frame is on its way.
    pub(crate) fn presented(&self) {}

    /// Hears that the viewer ends.
    pub(crate) fn failed(&self, _: &ViewError) {}
}

/// What the window system says, without the line of the library that says it.
fn reason(error: &winit::error::EventLoopError) -> String {
    let text = error.to_string();
    let words = text.rsplit(".rs:").next().unwrap_or(&text);
    words
        .trim_start_matches(|c: char| c.is_ascii_digit() || c == ':' || c == ' ')
        .trim_end_matches('.')
        .to_owned()
}
