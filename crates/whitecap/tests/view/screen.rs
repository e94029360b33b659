//! A screen in memory, a keyboard at it, and what is to be seen.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    AtomEnum, ConfigureWindowAux, ConnectionExt, ImageFormat, InputFocus, KEY_PRESS_EVENT, KEY_RELEASE_EVENT,
    Window,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

pub(crate) const SIZE: [u16; 2] = [640, 360];

/// What a viewer may take on a busy machine with a software adapter.
const PATIENCE: Duration = Duration::from_secs(60);

/// `Xvfb`, which ends with it.
pub(crate) struct Screen {
    server: Child,
    name: String,
    connection: RustConnection,
    root: Window,
}

impl Screen {
    /// None, loudly, where there is no Xvfb; in the checks that is a failure.
    pub(crate) fn start() -> Option<Screen> {
        let [width, height] = SIZE;
        let mut command = Command::new("Xvfb");
        command.args([
            "-displayfd",
            "1",
            "-nolisten",
            "tcp",
            "-screen",
            "0",
            &format!("{width}x{height}x24"),
        ]);
        let started = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
        let Ok(mut server) = started else {
            assert!(
                std::env::var_os("WHITECAP_REQUIRE_ADAPTER").is_none(),
                "there is no Xvfb: apt-get install xvfb"
            );
            eprintln!("SKIPPED: there is no Xvfb to open a window on (apt-get install xvfb)");
            return None;
        };
        let mut number = String::new();
        BufReader::new(server.stdout.take().unwrap()).read_line(&mut number).unwrap();
        let name = format!(":{}", number.trim());
        let (connection, screen) = x11rb::connect(Some(&name)).unwrap();
        let root = connection.setup().roots[screen].root;
        Some(Screen { server, name, connection, root })
    }

    /// All pixels: blue, green, red, and a byte that means nothing.
    pub(crate) fn pixels(&self) -> Vec<[u8; 4]> {
        let [width, height] = SIZE;
        let image = self.connection.get_image(ImageFormat::Z_PIXMAP, self.root, 0, 0, width, height, !0);
        let bytes = image.unwrap().reply().unwrap().data;
        bytes.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect()
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// `whitecap view` on a screen, which ends with it.
pub(crate) struct Viewer<'s> {
    pub(crate) screen: &'s Screen,
    process: Child,
    window: Window,
}

impl<'s> Viewer<'s> {
    /// With the panel hidden, so that the water fills the screen.
    pub(crate) fn open(screen: &'s Screen, folder: &Path, arguments: &[&str]) -> Viewer<'s> {
        let [width, height] = SIZE;
        let process = Command::new(env!("CARGO_BIN_EXE_whitecap"))
            .args(["view", "--size", &format!("{width}x{height}")])
            .args(arguments)
            .current_dir(folder)
            .env("DISPLAY", &screen.name)
            .env("XDG_RUNTIME_DIR", folder)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .spawn()
            .unwrap();
        let mut viewer = Viewer { screen, process, window: 0 };
        viewer.window = viewer.wait("a window", |viewer| viewer.find());
        let connection = &screen.connection;
        connection
            .set_input_focus(InputFocus::PARENT, viewer.window, x11rb::CURRENT_TIME)
            .unwrap()
            .check()
            .unwrap();
        viewer.wait("a picture", |viewer| {
            let lit = viewer.screen.pixels().iter().filter(|pixel| pixel[..3] != [0, 0, 0]).count();
            (lit > usize::from(SIZE[0]) * usize::from(SIZE[1]) / 2).then_some(())
        });
        viewer.press("KeyP");
        viewer
    }

    fn find(&self) -> Option<Window> {
        let connection = &self.screen.connection;
        let children = connection.query_tree(self.screen.root).unwrap().reply().unwrap().children;
        children.into_iter().find(|window| {
            let name = connection.get_property(false, *window, AtomEnum::WM_NAME, AtomEnum::ANY, 0, 64);
            let name = name.ok().and_then(|name| name.reply().ok()).map(|name| name.value);
            name.is_some_and(|name| String::from_utf8_lossy(&name).contains("whitecap"))
        })
    }

    /// Waits until `seen` has something to say.
    pub(crate) fn wait<T>(&mut self, what: &str, mut seen: impl FnMut(&mut Self) -> Option<T>) -> T {
        let started = Instant::now();
        loop {
            if let Some(ended) = self.process.try_wait().unwrap() {
                panic!("the viewer ended ({ended}) before there was {what}");
            }
            if let Some(seen) = seen(self) {
                return seen;
            }
            assert!(started.elapsed() < PATIENCE, "there was no {what}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Keys by their codes on the X server's standard keyboard.
    fn fake(&self, event: u8, key: &str) {
        let code = match key {
            "KeyE" => 26,
            "KeyP" => 33,
            "KeyS" => 39,
            "KeyD" => 40,
            "Control" => 37,
            "Space" => 65,
            "Period" => 60,
            other => panic!("no code for {other}"),
        };
        let connection = &self.screen.connection;
        connection.xtest_fake_input(event, code, 0, self.screen.root, 0, 0, 0).unwrap().check().unwrap();
    }

    pub(crate) fn down(&self, key: &str) {
        self.fake(KEY_PRESS_EVENT, key);
    }

    pub(crate) fn up(&self, key: &str) {
        self.fake(KEY_RELEASE_EVENT, key);
    }

    pub(crate) fn press(&self, key: &str) {
        self.down(key);
        self.up(key);
    }

    pub(crate) fn resize(&self, width: u32, height: u32) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.screen.connection.configure_window(self.window, &size).unwrap().check().unwrap();
    }

    /// The picture once two in a row are the same.
    pub(crate) fn still(&mut self) -> Vec<[u8; 4]> {
        let mut last = Vec::new();
        self.wait("a picture that stands still", |viewer| {
            std::thread::sleep(Duration::from_millis(400));
            let now = viewer.screen.pixels();
            let stands = now == last;
            last = now;
            stands.then(|| last.clone())
        })
    }
}

impl Drop for Viewer<'_> {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
