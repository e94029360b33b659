//! The window's events, and a frame after the other.

use crate::ViewError;
use crate::actions::{self, Action};
use crate::camera::Rig;
use crate::clock::Clock;
use crate::document::Document;
use crate::host::Host;
use crate::link::{Link, LinkError};
use crate::panel::{self, Told, Wishes};
use crate::stage::Stage;
use crate::window::Canvas;
use std::collections::VecDeque;
use std::path::Path;
use std::time::{Duration, SystemTime};
use web_time::Instant;
use whitecap_render::View;
use winit::application::ApplicationHandler;
use winit::event::{ElementState, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::keyboard::{KeyCode, ModifiersState, PhysicalKey};
use winit::window::{Fullscreen, WindowId};

/// How often the scene's file is looked at.
const WATCH: Duration = Duration::from_millis(300);

/// Radians that a drag over the window's height turns by, in angles of view; and a second of an arrow key.
const TURN_PER_S: f64 = 0.8;

/// Frames on the panel's graph.
const FRAMES: usize = 120;

/// Everything that lives as long as the window does.
pub(crate) struct App {
    pub(crate) host: Host,
    pub(crate) document: Document,
    pub(crate) rig: Rig,
    pub(crate) clock: Clock,
    pub(crate) shown: Option<Shown>,
    held: Vec<Action>,
    modifiers: ModifiersState,
    /// Where the mouse was, while it turns the view.
    dragged: Option<(f64, f64)>,
    pointer: (f64, f64),
    pub(crate) has_panel: bool,
    has_help: bool,
    pub(crate) error: Option<String>,
    pub(crate) news: Option<String>,
    /// The scene's file as it was read, and when it was last looked at.
    read: Option<SystemTime>,
    watched: Instant,
    last_frame: Instant,
    frames_ms: VecDeque<f32>,
    /// Something has changed that is not drawn yet. Beside that, a frame comes where time or the camera moves.
    is_stale: bool,
    pub(crate) failed: Option<ViewError>,
}

/// What comes to the viewer from outside of its window.
pub(crate) enum Asked {
    /// The device that was being opened.
    Opened(Box<Result<Canvas, ViewError>>),
    /// The view of a link.
    #[cfg_attr(not(target_arch = "wasm32"), expect(dead_code, reason = "windows have no address"))]
    Link(String),
}

/// What needs a window.
pub(crate) struct Shown {
    pub(crate) canvas: Canvas,
    stage: Stage,
    input: egui_winit::State,
    painter: egui_wgpu::Renderer,
}

impl App {
    pub(crate) fn new(host: Host, document: Document, clock: Clock) -> App {
        App {
            rig: Rig::of(&document.scene().camera),
            read: document.path().and_then(modified),
            host,
            document,
            clock,
            shown: None,
            held: Vec::new(),
            modifiers: ModifiersState::empty(),
            dragged: None,
            pointer: (0.0, 0.0),
            has_panel: true,
            has_help: false,
            error: None,
            news: None,
            watched: Instant::now(),
            last_frame: Instant::now(),
            frames_ms: VecDeque::with_capacity(FRAMES),
            is_stale: true,
            failed: None,
        }
    }

    fn open_window(&mut self, event_loop: &ActiveEventLoop) -> Result<(), ViewError> {
        let attributes = self.host.attributes().with_title(title(&self.document));
        let window =
            event_loop.create_window(attributes).map_err(|error| ViewError::Window(error.to_string()))?;
        let display = event_loop.owned_display_handle();
        self.host.open(Canvas::new(display, window, self.host.adapter()));
        Ok(())
    }

    /// Begins to draw on a device that has been opened.
    fn show_on(&self, canvas: Canvas) -> Result<Shown, ViewError> {
        let mut stage = Stage::new(canvas.gpu.clone(), canvas.format());
        stage.show(self.document.scene())?;
        let context = egui::Context::default();
        #[cfg(target_arch = "wasm32")]
        context.set_fonts(crate::fonts::definitions(self.host.fonts()));
        let side = canvas.gpu.device.limits().max_texture_dimension_2d as usize;
        let input = egui_winit::State::new(
            context,
            egui::ViewportId::ROOT,
            &*canvas.window,
            Some(canvas.window.scale_factor() as f32),
            canvas.window.theme(),
            Some(side),
        );
        let painter = egui_wgpu::Renderer::new(&canvas.gpu.device, canvas.format(), Default::default());
        Ok(Shown { canvas, stage, input, painter })
    }

    /// Builds the water of the scene as it is now. What was drawn goes on if it cannot be.
    fn rebuild(&mut self) {
        let Some(shown) = &mut self.shown else { return };
        shown.canvas.window.set_title(&title(&self.document));
        match shown.stage.show(self.document.scene()) {
            Ok(()) => self.error = None,
            Err(error) => self.error = Some(error.to_string()),
        }
    }

    /// Another scene, from its own camera.
    fn open(&mut self, scene: &str) {
        match Document::open(scene) {
            Ok(document) => {
                self.read = document.path().and_then(modified);
                self.rig = Rig::of(&document.scene().camera);
                self.document = document;
                self.rebuild();
            }
            Err(error) => self.error = Some(error.to_string()),
        }
    }

    /// The view of a link. If it shows none, the last one stays.
    pub(crate) fn follow(&mut self, fragment: &str) -> Result<(), LinkError> {
        let link = Link::parse(fragment)?;
        let (document, camera) = link.document()?;
        let is_other =
            document.origin() != self.document.origin() || document.changes() != self.document.changes();
        self.rig = Rig::of(&camera);
        self.clock = Clock::from(link.time_s.unwrap_or(0.0));
        if link.is_paused {
            self.clock.toggle_pause();
        }
        self.error = None;
        if is_other {
            self.document = document;
            self.rebuild();
        }
        Ok(())
    }

    /// The view as a link, unless it is of a file.
    pub(crate) fn link(&self) -> Option<Link> {
        let has_moved = self.rig != Rig::of(&self.document.scene().camera);
        self.document.path().is_none().then(|| Link {
            scene: Some(self.document.origin().to_owned()),
            time_s: Some(self.clock.time_s()),
            is_paused: self.clock.is_paused(),
            camera: has_moved.then(|| self.rig.camera()),
            settings: self.document.changes(),
        })
    }

    /// Reads the scene's file again if it has changed.
    fn watch(&mut self) {
        if self.watched.elapsed() < WATCH {
            return;
        }
        self.watched = Instant::now();
        let Some(now) = self.document.path().and_then(modified) else { return };
        if self.read == Some(now) {
            return;
        }
        self.read = Some(now);
        self.is_stale = true;
        match self.document.reload() {
            Ok(()) => {
                self.rebuild();
                self.news = Some("read again".to_owned());
            }
            Err(error) => self.error = Some(error.to_string()),
        }
    }

    fn act(&mut self, action: Action) {
        match action {
            Action::CameraMode => self.rig.change_mode(),
            Action::ResetCamera => self.rig = Rig::of(&self.document.scene().camera),
            Action::Pause => self.clock.toggle_pause(),
            Action::Step => self.clock.step(),
            Action::Slower => self.clock.change_speed(-1),
            Action::Faster => self.clock.change_speed(1),
            Action::ResetTime => self.clock.reset(),
            Action::Panel => self.has_panel = !self.has_panel,
            Action::Help => self.has_help = !self.has_help,
            Action::Save => self.save(),
            Action::Undo => {
                if self.document.undo() {
                    self.rebuild();
                }
            }
            Action::Screenshot => self.screenshot(),
            Action::FullScreen => {
                if let Some(shown) = &self.shown {
                    let window = &shown.canvas.window;
                    let other = window.fullscreen().is_none().then_some(Fullscreen::Borderless(None));
                    window.set_fullscreen(other);
                }
            }
            // Held, not pressed.
            Action::Forward
            | Action::Back
            | Action::Left
            | Action::Right
            | Action::Up
            | Action::Down
            | Action::TurnLeft
            | Action::TurnRight
            | Action::LookUp
            | Action::LookDown => {}
        }
    }

    /// Saves the scene beside its file, or in the current folder, under a name that is free.
    fn save(&mut self) {
        let stem = self.stem();
        let written = self
            .document
            .text(self.rig.camera())
            .map_err(|error| error.to_string())
            .and_then(|text| self.host.write_new(&stem, "toml", text.as_bytes()));
        self.tell(written);
    }

    /// The picture that `whitecap render` makes of this view.
    fn screenshot(&mut self) {
        let stem = self.stem();
        let Some(shown) = &self.shown else { return };
        let mut scene = self.document.scene().clone();
        scene.camera = self.rig.camera();
        let canvas = &shown.canvas;
        let written =
            self.host.write_picture(&stem, &canvas.gpu, &scene, canvas.size_px(), self.clock.time_s());
        self.tell(written);
    }

    /// What files of this scene are called, without number and extension.
    fn stem(&self) -> String {
        Path::new(self.document.origin()).file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    fn tell(&mut self, written: Result<String, String>) {
        match written {
            Ok(name) => self.news = Some(format!("wrote {name}")),
            Err(error) => self.error = Some(error),
        }
    }

    /// The command that renders this view, once it is saved.
    fn command(&self) -> String {
        let [width, height] = self.shown.as_ref().map_or([1280, 720], |shown| shown.canvas.size_px());
        let scene = self.document.origin();
        format!("whitecap render {scene:?} --time {} --size {width}x{height}", self.clock.time_s())
    }

    fn fulfil(&mut self, wishes: Wishes) {
        self.is_stale |= wishes != Wishes::default();
        if wishes.changed {
            self.rebuild();
        }
        if let Some(scene) = &wishes.open {
            self.open(scene);
        }
        if wishes.copy_command {
            self.copy(self.command());
        }
        if wishes.copy_link
            && let Some(link) = self.link()
        {
            self.copy(self.host.address(&link));
        }
        for action in wishes.actions {
            self.act(action);
        }
    }

    /// Puts a text on the clipboard and shows it.
    fn copy(&mut self, text: String) {
        if let Some(shown) = &mut self.shown {
            self.host.copy(&mut shown.input, &text);
        }
        self.news = Some(text);
    }

    /// Moves the camera by the keys that are down.
    fn move_camera(&mut self, seconds: f64) {
        let axis = |plus, minus| {
            let is_held = |action| f64::from(u8::from(self.held.contains(&action)));
            is_held(plus) - is_held(minus)
        };
        let haste = match (self.modifiers.shift_key(), self.modifiers.alt_key()) {
            (true, false) => 10.0,
            (false, true) => 0.1,
            _ => 1.0,
        };
        let (right, up) = (axis(Action::Right, Action::Left), axis(Action::Up, Action::Down));
        let forward = axis(Action::Forward, Action::Back);
        let turn = (axis(Action::TurnRight, Action::TurnLeft), axis(Action::LookUp, Action::LookDown));
        if (right, up, forward) != (0.0, 0.0, 0.0) {
            self.rig.go(right, up, forward, haste, seconds);
        }
        if turn != (0.0, 0.0) {
            self.rig.turn(turn.0 * TURN_PER_S * seconds, turn.1 * TURN_PER_S * seconds);
        }
    }

    fn frame(&mut self) {
        let now = Instant::now();
        let seconds = now.duration_since(self.last_frame).as_secs_f64();
        self.last_frame = now;
        self.is_stale = false;
        self.clock.pass(seconds);
        self.move_camera(seconds.min(0.25));
        if self.frames_ms.len() == FRAMES {
            self.frames_ms.pop_front();
        }
        self.frames_ms.push_back(1e3 * seconds as f32);
        let wishes = self.draw();
        self.fulfil(wishes);
        #[cfg(target_arch = "wasm32")]
        self.report();
    }

    fn draw(&mut self) -> Wishes {
        let mut wishes = Wishes::default();
        let Some(shown) = &mut self.shown else { return wishes };
        if shown.canvas.is_empty() {
            return wishes;
        }
        let Some(texture) = shown.canvas.next() else {
            self.is_stale = true;
            return wishes;
        };
        let size_px = shown.canvas.size_px();
        let gpu = shown.canvas.gpu.clone();
        let target = texture.texture.create_view(&Default::default());
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let view = View::of_camera(&self.rig.camera(), size_px);
        if let Err(error) = shown.stage.draw(&mut encoder, &target, &view, self.clock.time_s()) {
            self.error = Some(error.to_string());
        }

        let input = shown.input.take_egui_input(&shown.canvas.window);
        let context = shown.input.egui_ctx().clone();
        let told = Told {
            adapter: gpu.adapter.to_string(),
            frames_ms: self.frames_ms.make_contiguous(),
            error: self.error.as_deref(),
            news: self.news.as_deref(),
        };
        let mut output = context.run_ui(input, |ui| {
            if self.host.wants_water_alone() {
                return;
            }
            if self.has_panel {
                wishes = panel::show(ui, &mut self.document, &self.rig, &self.clock, &told);
            } else if let Some(error) = told.error {
                panel::notice(ui, error);
            }
            if self.has_help {
                panel::help(ui);
            }
        });
        let panel = output.viewport_output.get(&egui::ViewportId::ROOT);
        self.is_stale |= panel.is_some_and(|panel| panel.repaint_delay.is_zero());
        self.host.speak(&output.platform_output);
        shown.input.handle_platform_output(&shown.canvas.window, output.platform_output);
        let screen = egui_wgpu::ScreenDescriptor {
            size_in_pixels: size_px,
            pixels_per_point: output.pixels_per_point,
        };
        let shapes = context.tessellate(output.shapes, output.pixels_per_point);
        let painter = &mut shown.painter;
        for (id, deltas) in output.textures_delta.set.drain() {
            for delta in deltas {
                painter.update_texture(&gpu.device, &gpu.queue, id, &delta);
            }
        }
        let mut buffers = painter.update_buffers(&gpu.device, &gpu.queue, &mut encoder, &shapes, &screen);
        {
            let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("panel"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                })],
                ..Default::default()
            });
            painter.render(&mut pass.forget_lifetime(), &shapes, &screen);
        }
        buffers.push(encoder.finish());
        gpu.queue.submit(buffers);
        shown.canvas.window.pre_present_notify();
        gpu.queue.present(texture);
        self.host.presented();
        for id in output.textures_delta.free.drain() {
            painter.free_texture(&id);
        }
        if let Err(error) = gpu.check() {
            self.error = Some(error.to_string());
        }
        wishes
    }

    fn key(&mut self, code: KeyCode, state: ElementState, is_repeat: bool) {
        let with_ctrl = self.modifiers.control_key() || self.modifiers.super_key();
        let name = format!("{code:?}");
        match state {
            ElementState::Pressed => {
                let Some(action) = actions::find(&name, with_ctrl) else { return };
                if !self.held.contains(&action) {
                    self.held.push(action);
                }
                if !is_repeat {
                    self.act(action);
                }
            }
            // Whatever was held by this key, with Ctrl or without.
            ElementState::Released => {
                let released = [false, true].map(|with_ctrl| actions::find(&name, with_ctrl));
                self.held.retain(|held| !released.contains(&Some(*held)));
            }
        }
    }

    fn drag_to(&mut self, x: f64, y: f64) {
        self.pointer = (x, y);
        let Some((from_x, from_y)) = self.dragged else { return };
        self.dragged = Some((x, y));
        let Some(shown) = &self.shown else { return };
        let height = f64::from(shown.canvas.size_px()[1]);
        let per_pixel = self.rig.camera().vertical_fov_deg.to_radians() / height;
        // The water is taken along.
        self.rig.turn((from_x - x) * per_pixel, (y - from_y) * per_pixel);
    }
}

impl App {
    fn fail(&mut self, event_loop: &ActiveEventLoop, error: ViewError) {
        self.host.failed(&error);
        self.failed = Some(error);
        event_loop.exit();
    }
}

impl ApplicationHandler<Asked> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.shown.is_some() {
            return;
        }
        if let Err(error) = self.open_window(event_loop) {
            self.fail(event_loop, error);
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, asked: Asked) {
        self.is_stale = true;
        match asked {
            Asked::Opened(canvas) => match canvas.and_then(|canvas| self.show_on(canvas)) {
                Ok(shown) => self.shown = Some(shown),
                Err(error) => self.fail(event_loop, error),
            },
            Asked::Link(fragment) => {
                if let Err(error) = self.follow(&fragment) {
                    self.error = Some(error.to_string());
                }
                self.host.address_changed();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        self.is_stale |= event != WindowEvent::RedrawRequested;
        let Some(shown) = &mut self.shown else { return };
        let is_taken = shown.input.on_window_event(&shown.canvas.window, &event).consumed;
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(size) => shown.canvas.resize(size),
            WindowEvent::RedrawRequested => self.frame(),
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            WindowEvent::Focused(false) => self.held.clear(),
            WindowEvent::DroppedFile(path) => self.open(&path.to_string_lossy()),
            WindowEvent::KeyboardInput { event, .. } => {
                // Keys that are let go of count even over the panel.
                let counts = !is_taken || event.state == ElementState::Released;
                if let PhysicalKey::Code(code) = event.physical_key
                    && counts
                {
                    self.key(code, event.state, event.repeat);
                }
            }
            WindowEvent::CursorMoved { position, .. } => self.drag_to(position.x, position.y),
            WindowEvent::MouseInput { state, button: MouseButton::Left | MouseButton::Right, .. } => {
                let begins = state == ElementState::Pressed && !is_taken;
                self.dragged = begins.then_some(self.pointer);
            }
            WindowEvent::MouseWheel { delta, .. } if !is_taken => {
                let notches = match delta {
                    MouseScrollDelta::LineDelta(_, y) => f64::from(y),
                    MouseScrollDelta::PixelDelta(by) => by.y / 50.0,
                };
                self.rig.zoom(-0.1 * notches);
            }
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        self.watch();
        #[cfg(target_arch = "wasm32")]
        self.report();
        let Some(shown) = &self.shown else { return };
        let is_still = self.clock.is_paused() && self.held.is_empty() && !self.is_stale;
        if is_still || shown.canvas.is_empty() {
            // Nothing to draw until something changes, the scene's file perhaps, or the window has a size again.
            event_loop.set_control_flow(ControlFlow::WaitUntil(Instant::now() + WATCH));
            return;
        }
        // In a browser the next frame comes when the page is drawn anew.
        let wait = if cfg!(target_arch = "wasm32") { ControlFlow::Wait } else { ControlFlow::Poll };
        event_loop.set_control_flow(wait);
        shown.canvas.window.request_redraw();
    }
}

fn title(document: &Document) -> String {
    format!("{} – whitecap", document.origin())
}

fn modified(path: &Path) -> Option<SystemTime> {
    std::fs::metadata(path).and_then(|found| found.modified()).ok()
}
