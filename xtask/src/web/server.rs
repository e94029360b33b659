//! A server of one folder, for this machine alone.

use crate::process;
use anyhow::{Context, Result};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// The port that is served by default; the next that is free if it is taken.
pub(super) const PORT: u16 = 8080;

/// Ports that are tried.
const TRIES: u16 = 20;

/// The longest request that is read, bytes.
const LONGEST: u64 = 16 << 10;

/// A browser that says nothing for so long is left.
const PATIENCE: Duration = Duration::from_secs(10);

pub(super) struct Server {
    listener: TcpListener,
    folder: PathBuf,
}

impl Server {
    /// Serves `folder` at a free port from `port` on; 0 takes any.
    pub(super) fn open(folder: &Path, port: u16) -> Result<Server> {
        let ports = port..=if port == 0 { 0 } else { port.saturating_add(TRIES) };
        let mut listener = Err(std::io::ErrorKind::AddrInUse.into());
        for port in ports {
            listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port));
            if listener.is_ok() {
                break;
            }
        }
        let listener = listener.context("no port of this machine can be served")?;
        Ok(Server { listener, folder: folder.to_owned() })
    }

    /// Where a browser finds it. `localhost` counts as safe, as WebGPU wants it.
    pub(super) fn address(&self) -> String {
        let port = self.listener.local_addr().map_or(PORT, |address| address.port());
        format!("http://localhost:{port}/")
    }

    /// Serves until the program ends.
    pub(super) fn serve(&self) {
        for stream in self.listener.incoming().flatten() {
            let folder = self.folder.clone();
            std::thread::spawn(move || {
                // Whoever asked may have gone.
                let _ = answer(&stream, &folder);
            });
        }
    }

    /// Serves beside what the program does.
    pub(super) fn serve_aside(self) {
        std::thread::spawn(move || self.serve());
    }
}

/// Answers one request; browsers open a connection for each.
fn answer(stream: &TcpStream, folder: &Path) -> std::io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    let mut head = BufReader::new(stream.take(LONGEST));
    let mut request = String::new();
    head.read_line(&mut request)?;
    let mut line = String::new();
    while head.read_line(&mut line)? > 2 {
        line.clear();
    }
    let (status, kind, body) = match file_of(&request, folder) {
        Some(path) => match std::fs::read(&path) {
            Ok(bytes) => ("200 OK", kind_of(&path), bytes),
            Err(_) => ("404 Not Found", "text/plain", b"There is no such file.\n".to_vec()),
        },
        None => ("400 Bad Request", "text/plain", b"Ask for a file by GET.\n".to_vec()),
    };
    let mut stream = stream;
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nCache-Control: no-cache\r\n\
         Connection: close\r\n\r\n",
        body.len()
    )?;
    stream.write_all(&body)?;
    if status != "200 OK" {
        process::complain(&format!("{status}: {}", request.trim().escape_default()));
    }
    Ok(())
}

/// The file that a request's first line asks for. No path leads out of the folder.
fn file_of(request: &str, folder: &Path) -> Option<PathBuf> {
    let path = request.strip_prefix("GET /")?.split([' ', '?', '#']).next()?;
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    path.components().all(|part| matches!(part, Component::Normal(_))).then(|| folder.join(path))
}

fn kind_of(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        Some("png") => "image/png",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_request_finds_its_file_and_none_outside() {
        let folder = Path::new("/page");
        let found = |request: &str| file_of(request, folder);
        assert_eq!(found("GET / HTTP/1.1\r\n"), Some("/page/index.html".into()));
        assert_eq!(found("GET /pictures/a.png?x=1 HTTP/1.1\r\n"), Some("/page/pictures/a.png".into()));
        for refused in ["GET /../secret HTTP/1.1", "GET //etc/passwd HTTP/1.1", "POST / HTTP/1.1", "", "GET"]
        {
            assert_eq!(found(refused), None, "{refused}");
        }
    }

    #[test]
    fn files_come_with_their_kind_and_what_is_not_there_is_said() {
        let folder = std::env::temp_dir().join(format!("whitecap-server-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("a.wasm"), [0, 1, 2]).unwrap();
        let server = Server::open(&folder, 0).unwrap();
        let address = server.listener.local_addr().unwrap();
        server.serve_aside();
        let ask = |path: &str| {
            let mut stream = TcpStream::connect(address).unwrap();
            write!(stream, "GET /{path} HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
            let mut answer = Vec::new();
            stream.read_to_end(&mut answer).unwrap();
            answer
        };
        let module = ask("a.wasm");
        let head = String::from_utf8_lossy(&module);
        assert!(head.starts_with("HTTP/1.1 200 OK\r\n") && head.contains("application/wasm"), "{head}");
        assert!(module.ends_with(&[0, 1, 2]));
        assert!(ask("b.wasm").starts_with(b"HTTP/1.1 404"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
