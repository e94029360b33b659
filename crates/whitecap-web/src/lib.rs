//! The viewer for `web/page.js`: what the page calls, and what it is called for.
#![cfg(target_arch = "wasm32")]

use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::HtmlCanvasElement;
use whitecap_viewer::{Page, Remote};

#[wasm_bindgen]
extern "C" {
    /// The object in `web/page.js` that stands for the page.
    pub type JsPage;

    #[wasm_bindgen(method, js_name = firstPicture)]
    fn first_picture(this: &JsPage);
    #[wasm_bindgen(method)]
    fn at(this: &JsPage, fragment: &str);
    #[wasm_bindgen(method)]
    fn wrong(this: &JsPage, sentence: &str);
    #[wasm_bindgen(method)]
    fn done(this: &JsPage, sentence: &str);
    #[wasm_bindgen(method)]
    fn speak(this: &JsPage, words: &str);
    #[wasm_bindgen(method)]
    fn failed(this: &JsPage, sentence: &str);
    #[wasm_bindgen(method)]
    fn save(this: &JsPage, name: &str, bytes: &[u8]);
    #[wasm_bindgen(method, js_name = saveCanvas)]
    fn save_canvas(this: &JsPage, name: &str);
    #[wasm_bindgen(method)]
    fn copy(this: &JsPage, text: &str);
    #[wasm_bindgen(method)]
    fn address(this: &JsPage, fragment: &str) -> String;
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = console, js_name = error)]
    fn log_error(text: &str);
}

/// The page as the viewer knows it.
struct OnPage(JsPage);

impl Page for OnPage {
    fn first_picture(&self) {
        self.0.first_picture();
    }

    fn at(&self, fragment: &str) {
        self.0.at(fragment);
    }

    fn wrong(&self, sentence: &str) {
        self.0.wrong(sentence);
    }

    fn done(&self, sentence: &str) {
        self.0.done(sentence);
    }

    fn speak(&self, words: &str) {
        self.0.speak(words);
    }

    fn failed(&self, sentence: &str) {
        self.0.failed(sentence);
    }

    fn save(&self, name: &str, bytes: &[u8]) {
        self.0.save(name, bytes);
    }

    fn save_canvas(&self, name: &str) {
        self.0.save_canvas(name);
    }

    fn copy(&self, text: &str) {
        self.0.copy(text);
    }

    fn address(&self, fragment: &str) -> String {
        self.0.address(fragment)
    }
}

/// Made by build.rs.
const FONTS: &[&[u8]] = &[
    include_bytes!(concat!(env!("OUT_DIR"), "/letters.ttf")),
    include_bytes!(concat!(env!("OUT_DIR"), "/signs.ttf")),
];

/// The viewer on a canvas.
#[wasm_bindgen]
pub struct Viewer(Remote);

#[wasm_bindgen]
impl Viewer {
    /// Shows the view of `fragment` on `canvas`; `page` hears of everything.
    #[wasm_bindgen(constructor)]
    pub fn new(canvas: HtmlCanvasElement, page: JsPage, fragment: &str) -> Result<Viewer, String> {
        // What is left of a fault that stops the module; the page shows that it has stopped.
        std::panic::set_hook(Box::new(|fault| log_error(&fault.to_string())));
        let remote = whitecap_viewer::view_on(canvas, Box::new(OnPage(page)), fragment, FONTS);
        remote.map(Viewer).map_err(|error| error.to_string())
    }

    /// Shows the view of another link.
    pub fn follow(&self, fragment: &str) {
        self.0.follow(fragment);
    }
}
