//! Places from a CSV file or from standard input, read as they come.

use super::super::options::{MAX_FAR, Place, within};
use super::places::CHUNK;
use crate::failure::Failure;
use anyhow::anyhow;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

/// The most places that are kept in memory, 160 MB of them.
const MAX_HELD: usize = 10_000_000;

/// The longest line, bytes: a hundred times what a place needs, so that a file without line breaks ends soon.
const MAX_LINE: u64 = 1 << 16;

/// The first line that says where x_m and z_m stand.
const COLUMNS: [&str; 2] = ["x_m", "z_m"];

/// A CSV file of places.
pub(super) struct Points {
    /// What errors call the file.
    name: String,
    lines: BufReader<Box<dyn Read>>,
    /// How many lines were read.
    line: u64,
    /// Where x_m and z_m stand, by a first line that names them; `None` for two columns and nothing else.
    columns: Option<[usize; 2]>,
    started: bool,
    /// Whether any line had a place.
    found: bool,
}

impl Points {
    /// Opens the file `path`, or standard input for "-".
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Self::new("standard input".to_owned(), Box::new(io::stdin())));
        }
        let name = path.display().to_string();
        let refused = |problem: String| Failure::Input(anyhow!("{name}: {problem}"));
        let file = File::open(path).map_err(|error| refused(format!("cannot be read: {error}")))?;
        if file.metadata().is_ok_and(|found| found.is_dir()) {
            return Err(refused("is a folder; accepted: a CSV file of places".to_owned()));
        }
        Ok(Self::new(name, Box::new(file)))
    }

    fn new(name: String, input: Box<dyn Read>) -> Self {
        let lines = BufReader::with_capacity(MAX_LINE as usize, input);
        Self { name, lines, line: 0, columns: None, started: false, found: false }
    }

    /// Puts the next places into `chunk`: up to [`CHUNK`], and no more than can be had without waiting for
    /// whoever writes them, but for the first. False at the end.
    pub(super) fn read_chunk(&mut self, chunk: &mut Vec<Place>) -> Result<bool, Failure> {
        chunk.clear();
        while chunk.len() < CHUNK && (chunk.is_empty() || self.lines.buffer().contains(&b'\n')) {
            match self.read_place()? {
                Some(place) => chunk.push(place),
                None => break,
            }
        }
        Ok(!chunk.is_empty())
    }

    /// All places, at most `limit` of them and as many as memory is kept for.
    pub(super) fn read_all(mut self, limit: u64) -> Result<Vec<Place>, Failure> {
        let limit = usize::try_from(limit).unwrap_or(MAX_HELD).min(MAX_HELD);
        let mut places = Vec::new();
        while let Some(place) = self.read_place()? {
            if places.len() == limit {
                return Err(self.refused(&format!("more places than {limit}, the most for these moments")));
            }
            places.push(place);
        }
        Ok(places)
    }

    /// The place of the next line that has one.
    fn read_place(&mut self) -> Result<Option<Place>, Failure> {
        while let Some(line) = self.read_line()? {
            let line = line.trim();
            if line.is_empty() {
                continue;
            }
            let fields: Vec<&str> = line.split(',').map(str::trim).collect();
            if !std::mem::replace(&mut self.started, true)
                && fields.iter().any(|field| COLUMNS.contains(field))
            {
                self.columns = Some(self.find_columns(&fields)?);
                continue;
            }
            self.found = true;
            return self.place(&fields).map(Some);
        }
        match self.found {
            true => Ok(None),
            false => {
                Err(Failure::Input(anyhow!("{}: no place; accepted: at least one line x_m,z_m", self.name)))
            }
        }
    }

    fn find_columns(&self, names: &[&str]) -> Result<[usize; 2], Failure> {
        let place = |column: &str| {
            let missing = || self.refused(&format!("no column is called {column}; accepted: x_m and z_m"));
            names.iter().position(|&name| name == column).ok_or_else(missing)
        };
        Ok([place(COLUMNS[0])?, place(COLUMNS[1])?])
    }

    fn place(&self, fields: &[&str]) -> Result<Place, Failure> {
        if self.columns.is_none() && fields.len() > 2 {
            return Err(self.refused(&format!(
                "{} columns; accepted: two, x_m and z_m, or a first line that names them",
                fields.len()
            )));
        }
        let [x, z] = self.columns.unwrap_or([0, 1]);
        let number = |index: usize, name: &str| {
            let column = format!("column {} ({name})", index + 1);
            let Some(&text) = fields.get(index) else {
                return Err(self.refused(&format!("{column} is missing")));
            };
            within(text, MAX_FAR).ok_or_else(|| {
                self.refused(&format!("{column} is {text:?}; accepted: metres from -{MAX_FAR} to {MAX_FAR}"))
            })
        };
        Ok([number(x, COLUMNS[0])?, number(z, COLUMNS[1])?])
    }

    fn read_line(&mut self) -> Result<Option<String>, Failure> {
        let mut bytes = Vec::new();
        let unreadable = |error| Failure::Machine(anyhow!("{}: cannot be read: {error}", self.name));
        let mut limited = (&mut self.lines).take(MAX_LINE);
        limited.read_until(b'\n', &mut bytes).map_err(unreadable)?;
        if bytes.is_empty() {
            return Ok(None);
        }
        self.line += 1;
        if bytes.len() as u64 == MAX_LINE && !bytes.ends_with(b"\n") {
            return Err(self.refused(&format!("is longer than {MAX_LINE} bytes")));
        }
        // A mark of the byte order, as some spreadsheets write it.
        let text =
            if self.line == 1 { bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes) } else { &bytes };
        match std::str::from_utf8(text) {
            Ok(text) => Ok(Some(text.to_owned())),
            Err(_) => Err(self.refused("is not text in UTF-8")),
        }
    }

    fn refused(&self, problem: &str) -> Failure {
        Failure::Input(anyhow!("{}, line {}: {problem}", self.name, self.line))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{any, proptest};

    fn read(text: &[u8]) -> Result<Vec<Place>, String> {
        let points = Points::new("p.csv".to_owned(), Box::new(io::Cursor::new(text.to_vec())));
        points.read_all(1000).map_err(|failure| failure.sentence().unwrap())
    }

    #[test]
    fn two_columns_or_any_with_names() {
        let expected = vec![[1.0, -2.5], [3e2, 4.0]];
        for text in [
            "1,-2.5\n3e2,4\n",
            "x_m,z_m\n1,-2.5\n3e2,4",
            " x_m , z_m \r\n 1 , -2.5 \r\n\r\n300,4\r\n\n",
            "\u{feff}x_m,z_m\n1,-2.5\n3e2,4\n",
            "name,z_m,more,x_m\nbuoy,-2.5,NaN,1\nship,4,,3e2\n",
        ] {
            assert_eq!(read(text.as_bytes()).unwrap(), expected, "{text:?}");
        }
        for text in ["", "\n \n", "x_m,z_m\n", "\u{feff}"] {
            assert_eq!(
                read(text.as_bytes()).unwrap_err(),
                "p.csv: no place; accepted: at least one line x_m,z_m",
                "{text:?}"
            );
        }
    }

    #[test]
    fn what_is_no_place_is_refused_with_its_line() {
        for (text, expected) in [
            ("1,2\n3\n", "line 2: column 2 (z_m) is missing"),
            (
                "1,2\n\n3,NaN\n",
                "line 3: column 2 (z_m) is \"NaN\"; accepted: metres from -10000000 to 10000000",
            ),
            ("inf,2\n", "line 1: column 1 (x_m) is \"inf\""),
            ("x_m,z_m\n1,2\n1,2\n10000001,0\n", "line 4: column 1 (x_m) is \"10000001\""),
            ("1,2,3\n", "line 1: 3 columns; accepted: two"),
            ("x_m,y_m\n1,2\n", "line 1: no column is called z_m"),
            ("a,x_m,z_m\nq,1\n", "line 2: column 3 (z_m) is missing"),
            ("1;2\n", "line 1: column 1 (x_m) is \"1;2\""),
            ("1,2\nx_m,z_m\n", "line 2: column 1 (x_m) is \"x_m\""),
            (",\n", "line 1: column 1 (x_m) is \"\""),
        ] {
            let message = read(text.as_bytes()).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
        assert!(read(b"1,2\n\xff\xfe,1\n").unwrap_err().contains("line 2: is not text"));
        assert!(read(&[b'1'; 100_000]).unwrap_err().contains("line 1: is longer than 65536 bytes"));
        assert!(
            read("1,2\n".repeat(1001).as_bytes()).unwrap_err().contains("line 1001: more places than 1000")
        );
    }

    proptest! {
        /// Whatever the bytes: places within their range, or a sentence that begins with the file.
        #[test]
        fn any_bytes_are_places_or_a_sentence(bytes in vec(any::<u8>(), 0..300)) {
            is_places_or_a_sentence(&bytes);
        }

        /// The same of what looks like places.
        #[test]
        fn any_rows_are_places_or_a_sentence(
            text in "(\u{feff})?(x_m,z_m|a,z_m,x_m|x_m)?\n?([-+0-9.eE,; NaInf\"]{0,20}\r?\n){0,8}",
        ) {
            is_places_or_a_sentence(text.as_bytes());
        }
    }

    fn is_places_or_a_sentence(bytes: &[u8]) {
        match read(bytes) {
            Ok(places) => {
                assert!(!places.is_empty());
                assert!(places.iter().flatten().all(|metres| metres.abs() <= 1e7), "{places:?}");
            }
            Err(sentence) => {
                assert!(sentence.starts_with("p.csv") && !sentence.contains('\n'), "{sentence}");
            }
        }
    }

    /// A source that hands out one line at a time, as somebody who waits for each answer does.
    struct Slow(Vec<&'static [u8]>);

    impl Read for Slow {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let line = if self.0.is_empty() { &b""[..] } else { self.0.remove(0) };
            buffer[..line.len()].copy_from_slice(line);
            Ok(line.len())
        }
    }

    #[test]
    fn what_has_come_is_answered_before_more_is_waited_for() {
        let slow = Slow(vec![b"1,2\n", b"3,4\n5,6\n7,", b"8\n"]);
        let mut points = Points::new("pipe".to_owned(), Box::new(slow));
        let mut chunk = Vec::new();
        for expected in [vec![[1.0, 2.0]], vec![[3.0, 4.0], [5.0, 6.0]], vec![[7.0, 8.0]]] {
            assert!(points.read_chunk(&mut chunk).unwrap());
            assert_eq!(chunk, expected);
        }
        assert!(!points.read_chunk(&mut chunk).unwrap());
    }
}
