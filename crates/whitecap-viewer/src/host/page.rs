//! A canvas on a page.

use crate::ViewError;
use crate::app::{App, Asked};
use crate::clock::Clock;
use crate::document::Document;
use crate::link::Link;
use crate::window::Canvas;
use std::cell::{Cell, RefCell};
use std::future::Future;
use std::time::Duration;
use web_time::Instant;
use whitecap_render::Gpu;
use whitecap_scene::Scene;
use winit::event_loop::{EventLoop, EventLoopProxy};
use winit::platform::web::{EventLoopExtWebSys as _, WindowAttributesExtWebSys as _};
use winit::window::{Window, WindowAttributes};

/// What a page does for the viewer on it.
pub trait Page {
    /// The first picture has been drawn.
    fn first_picture(&self);
    /// The view is this link's now: the address's fragment, without `#`.
    fn at(&self, fragment: &str);
    /// What is wrong, to be shown beside the water; empty once nothing is.
    fn wrong(&self, sentence: &str);
    /// What was done.
    fn done(&self, sentence: &str);
    /// What control of the panel has the focus or was used, for those who do not see it.
    fn speak(&self, words: &str);
    /// The viewer cannot go on.
    fn failed(&self, sentence: &str);
    /// Offers a file.
    fn save(&self, name: &str, bytes: &[u8]);
    /// Offers the canvas's picture as a file, which it has until this returns.
    fn save_canvas(&self, name: &str);
    /// Puts a text on the clipboard.
    fn copy(&self, text: &str);
    /// The address of the page with this fragment.
    fn address(&self, fragment: &str) -> String;
}

/// What a page asks of a viewer.
pub struct Remote(EventLoopProxy<Asked>);

impl Remote {
    /// Shows the view of a link. If it shows none, the page hears why, and the last view stays.
    pub fn follow(&self, fragment: &str) {
        // Without a loop the page has been told that the viewer ended.
        let _ = self.0.send_event(Asked::Link(fragment.to_owned()));
    }
}

/// Begins to show the view of a link on a canvas, with the panel's letters from these fonts, and returns at once.
///
/// # Errors
///
/// If the page does not let events come. What is wrong later, the page hears.
pub fn view_on(
    canvas: web_sys::HtmlCanvasElement,
    page: Box<dyn Page>,
    fragment: &str,
    fonts: &'static [&'static [u8]],
) -> Result<Remote, ViewError> {
    let event_loop =
        EventLoop::with_user_event().build().map_err(|error| ViewError::Window(error.to_string()))?;
    let events = event_loop.create_proxy();
    let host = Host {
        canvas,
        page,
        fonts,
        events: events.clone(),
        said: RefCell::default(),
        reported: Cell::new(None),
        files: Cell::new(0),
        picture: RefCell::default(),
        has_shown: Cell::new(false),
    };
    let document = Document::named(whitecap_scene::named::DEFAULT)?;
    let mut app = App::new(host, document, Clock::from(0.0));
    if let Err(error) = app.follow(fragment) {
        app.error = Some(error.to_string());
    }
    event_loop.spawn_app(app);
    Ok(Remote(events))
}

/// How often the address follows a view that moves: browsers refuse more.
const REPORT: Duration = Duration::from_millis(700);

pub(crate) struct Host {
    canvas: web_sys::HtmlCanvasElement,
    page: Box<dyn Page>,
    fonts: &'static [&'static [u8]],
    events: EventLoopProxy<Asked>,
    /// What the page heard last.
    said: RefCell<Said>,
    reported: Cell<Option<Instant>>,
    /// Files that were saved.
    files: Cell<u32>,
    /// What the canvas's picture shall be called, once it has been drawn without the panel.
    picture: RefCell<Option<String>>,
    has_shown: Cell<bool>,
}

#[derive(Default)]
struct Said {
    link: String,
    wrong: String,
    done: String,
}

impl Host {
    pub(crate) fn adapter(&self) -> Option<String> {
        None
    }

    /// The panel's, the first for letters, those after it for what it lacks.
    pub(crate) fn fonts(&self) -> &'static [&'static [u8]] {
        self.fonts
    }

    pub(crate) fn attributes(&self) -> WindowAttributes {
        // The page says which keys and gestures are the browser's.
        Window::default_attributes().with_canvas(Some(self.canvas.clone())).with_prevent_default(false)
    }

    pub(crate) fn open(&self, canvas: impl Future<Output = Result<Canvas, ViewError>> + 'static) {
        let events = self.events.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let _ = events.send_event(Asked::Opened(Box::new(canvas.await)));
        });
    }

    pub(crate) fn write_new(&self, stem: &str, extension: &str, bytes: &[u8]) -> Result<String, String> {
        let name = self.new_name(stem, extension);
        self.page.save(&name, bytes);
        Ok(name)
    }

    fn new_name(&self, stem: &str, extension: &str) -> String {
        self.files.set(self.files.get() + 1);
        format!("{stem}-{:03}.{extension}", self.files.get())
    }

    /// A browser does not wait for its device, so the picture is that of the canvas.
    pub(crate) fn write_picture(
        &self,
        stem: &str,
        _: &Gpu,
        _: &Scene,
        _: [u32; 2],
        _: f64,
    ) -> Result<String, String> {
        let name = self.new_name(stem, "png");
        *self.picture.borrow_mut() = Some(name.clone());
        Ok(name)
    }

    pub(crate) fn copy(&self, _: &mut egui_winit::State, text: &str) {
        self.page.copy(text);
    }

    pub(crate) fn address(&self, link: &Link) -> String {
        self.page.address(&link.to_string())
    }

    pub(crate) fn address_changed(&self) {
        // It says what is seen again, whatever became of the link.
        self.said.borrow_mut().link.clear();
        self.reported.set(None);
    }

    pub(crate) fn wants_water_alone(&self) -> bool {
        self.picture.borrow().is_some()
    }

    pub(crate) fn speak(&self, output: &egui::PlatformOutput) {
        let words = output.events_description();
        if !words.is_empty() {
            self.page.speak(&words);
        }
    }

    pub(crate) fn presented(&self) {
        if let Some(name) = self.picture.borrow_mut().take() {
            self.page.save_canvas(&name);
        }
        if !self.has_shown.replace(true) {
            self.page.first_picture();
        }
    }

    pub(crate) fn failed(&self, error: &ViewError) {
        self.page.failed(&error.to_string());
    }
}

impl App {
    /// Tells the page what has changed since it heard last.
    pub(crate) fn report(&self) {
        let host = &self.host;
        let mut said = host.said.borrow_mut();
        let wrong = self.error.as_deref().unwrap_or_default();
        if said.wrong != wrong {
            wrong.clone_into(&mut said.wrong);
            host.page.wrong(wrong);
        }
        let done = self.news.as_deref().unwrap_or_default();
        if said.done != done {
            done.clone_into(&mut said.done);
            host.page.done(done);
        }
        if host.reported.get().is_some_and(|reported| reported.elapsed() < REPORT) {
            return;
        }
        let link = self.link().map(|link| link.to_string()).unwrap_or_default();
        if said.link != link {
            host.reported.set(Some(Instant::now()));
            host.page.at(&link);
            said.link = link;
        }
    }
}
