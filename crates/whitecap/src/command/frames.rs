//! Which frames of a sequence, when each is, and what its file is called.

use super::options::{MAX_TIME_S, whole_number};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The most frames of a sequence: half a day at 24 a second.
pub(super) const MOST: u64 = 1_000_000;

/// The frames from `from` on, without `to`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Frames {
    pub(super) from: u64,
    /// Above `from`.
    pub(super) to: u64,
}

impl Frames {
    pub(super) fn count(self) -> u64 {
        self.to - self.from
    }

    pub(super) fn numbers(self) -> Range<u64> {
        self.from..self.to
    }
}

/// Reads `A..B`.
pub(super) fn parse_frames(text: &str) -> Result<Frames, String> {
    let accepted = "accepted: A..B, the frames from A to the one before B, such as 0..240";
    let (from, to) = text
        .split_once("..")
        .and_then(|(from, to)| Some((whole_number::<u64>(from)?, whole_number::<u64>(to)?)))
        .ok_or_else(|| accepted.to_owned())?;
    match to.checked_sub(from) {
        None => Err(format!("the last comes before the first; {accepted}")),
        Some(0) => Err(format!("no frame: {to} itself is not one of them; {accepted}")),
        Some(count) if count > MOST || to > u64::from(u32::MAX) => {
            Err(format!("{count} frames; accepted: up to {MOST}, numbered up to {}", u32::MAX))
        }
        Some(_) => Ok(Frames { from, to }),
    }
}

/// Frames a second, as a fraction: 24/1, 30000/1001.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rate {
    pub(super) frames: f64,
    pub(super) seconds: f64,
}

impl Rate {
    /// Seconds from frame 0 to frame `number`.
    pub(super) fn time_s(self, number: u64) -> f64 {
        number as f64 * self.seconds / self.frames
    }
}

impl std::fmt::Display for Rate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.seconds == 1.0 {
            write!(f, "{}", self.frames)
        } else {
            write!(f, "{}/{}", self.frames, self.seconds)
        }
    }
}

/// Reads a number, or a fraction of two.
pub(super) fn parse_rate(text: &str) -> Result<Rate, String> {
    let number = |text: &str| text.parse::<f64>().ok().filter(|number| (1e-3..=1e6).contains(number));
    let (frames, seconds) = text.split_once('/').unwrap_or((text, "1"));
    number(frames)
        .zip(number(seconds))
        .map(|(frames, seconds)| Rate { frames, seconds })
        .filter(|rate| (1e-3..=1e4).contains(&(rate.frames / rate.seconds)))
        .ok_or_else(|| "accepted: frames a second from 0.001 to 10000, such as 24 or 30000/1001".to_owned())
}

/// The `index`-th of `count` parts, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Chunk {
    index: u64,
    count: u64,
}

impl Chunk {
    /// Its part of `frames`, in a row: parts differ by a frame at most. None where there are fewer frames than parts.
    pub(super) fn of(self, frames: Frames) -> Option<Frames> {
        let border = |i: u64| {
            frames.from + (u128::from(frames.count()) * u128::from(i) / u128::from(self.count)) as u64
        };
        let (from, to) = (border(self.index - 1), border(self.index));
        (from < to).then_some(Frames { from, to })
    }
}

/// Reads `I/N`.
pub(super) fn parse_chunk(text: &str) -> Result<Chunk, String> {
    let accepted = "accepted: I/N, the I-th of N parts, such as 2/5";
    let number = |digits: &str| whole_number(digits).filter(|number| (1..=MOST).contains(number));
    let (index, count) = text
        .split_once('/')
        .and_then(|(index, count)| Some((number(index)?, number(count)?)))
        .ok_or_else(|| accepted.to_owned())?;
    if index > count {
        return Err(format!("there are {count} parts; {accepted}"));
    }
    Ok(Chunk { index, count })
}

/// A path whose name has a counter: `frame.%04d.png`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pattern {
    folder: PathBuf,
    before: String,
    digits: usize,
    after: String,
}

impl Pattern {
    /// Reads the one counter of a file's name, `%d` or `%04d` with up to 9 digits; `%%` is a per cent sign.
    pub(super) fn parse(path: &Path) -> Result<Pattern, String> {
        const ACCEPTED: &str = "accepted: one counter in the file's name, such as frame.%04d.png";
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.ok_or_else(|| format!("the file's name is not text; {ACCEPTED}"))?;
        if folder.to_string_lossy().contains('%') && counters(&folder.to_string_lossy()) > 0 {
            return Err(format!("a counter in the folder's name; {ACCEPTED}"));
        }
        match counters(name) {
            1 => {}
            0 => return Err(format!("no counter; {ACCEPTED}")),
            count => return Err(format!("{count} counters; {ACCEPTED}")),
        }
        let (mut before, mut after, mut digits) = (String::new(), String::new(), None);
        let mut rest = name;
        while let Some(at) = rest.find('%') {
            let text = if digits.is_none() { &mut before } else { &mut after };
            text.push_str(&rest[..at]);
            rest = &rest[at + 1..];
            if let Some(escaped) = rest.strip_prefix('%') {
                text.push('%');
                rest = escaped;
            } else if let Some((width, length)) = counter(rest) {
                digits = Some(width);
                rest = &rest[length..];
            } else {
                return Err(format!("% begins no counter; {ACCEPTED}, and %% for a per cent sign"));
            }
        }
        after.push_str(rest);
        let digits = digits.ok_or_else(|| format!("no counter; {ACCEPTED}"))?;
        Ok(Pattern { folder, before, digits, after })
    }

    /// Files in `folder` called `before`, a number of at least `digits` digits, and `after`.
    pub(super) fn new(folder: &Path, before: &str, digits: usize, after: &str) -> Result<Pattern, String> {
        // Programs that count frames themselves take a per cent sign in a folder for their counter.
        if folder.to_string_lossy().contains('%') {
            return Err(format!(
                "{} has a per cent sign in its name; accepted: one without",
                folder.display()
            ));
        }
        let (before, after) = (before.to_owned(), after.to_owned());
        Ok(Pattern { folder: folder.to_owned(), before, digits, after })
    }

    /// The path with its counter, as other programs take it.
    pub(super) fn counted(&self) -> PathBuf {
        self.folder.join(format!("{}%0{}d{}", self.before, self.digits, self.after))
    }

    pub(super) fn folder(&self) -> &Path {
        if self.folder == Path::new("") { Path::new(".") } else { &self.folder }
    }

    pub(super) fn path(&self, number: u64) -> PathBuf {
        let Pattern { before, digits, after, .. } = self;
        self.folder.join(format!("{before}{number:0digits$}{after}"))
    }
}

/// A counter after its `%`: how many digits it has at least, and how long it is.
fn counter(text: &str) -> Option<(usize, usize)> {
    let end = text.find(|c: char| !c.is_ascii_digit())?;
    if !text[end..].starts_with('d') {
        return None;
    }
    let width = match &text[..end] {
        "" => 1,
        digits => digits.strip_prefix('0')?.parse().ok().filter(|width| (1..=9).contains(width))?,
    };
    Some((width, end + 1))
}

fn counters(name: &str) -> usize {
    let mut count = 0;
    let mut rest = name;
    while let Some(at) = rest.find('%') {
        rest = &rest[at + 1..];
        match rest.strip_prefix('%') {
            Some(escaped) => rest = escaped,
            None => count += usize::from(counter(rest).is_some()),
        }
    }
    count
}

/// The moment of each frame must be one that can be asked for.
pub(super) fn check_times(frames: Frames, rate: Rate, start_s: f64) -> Result<(), String> {
    let last_s = start_s + rate.time_s(frames.to - 1);
    if last_s.abs() <= MAX_TIME_S {
        return Ok(());
    }
    Err(format!("frame {} is at {last_s} s; accepted: moments up to {MAX_TIME_S} s", frames.to - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_half_open_ranges() {
        assert_eq!(parse_frames("0..240"), Ok(Frames { from: 0, to: 240 }));
        assert_eq!(parse_frames("7..8").map(Frames::count), Ok(1));
        for (text, words) in [
            ("240..0", "the last comes before the first"),
            ("5..5", "no frame: 5 itself is not one"),
            ("0..1000000000", "1000000000 frames; accepted: up to 1000000"),
            ("0..18446744073709551615", "accepted: up to 1000000"),
        ] {
            assert!(parse_frames(text).is_err_and(|error| error.contains(words)), "{text}");
        }
        for text in [
            "",
            "..",
            "0..",
            "..5",
            "a..b",
            "0-5",
            "0...5",
            "-1..5",
            "+1..5",
            "0..5..9",
            "1.5..3",
            "0..99999999999999999999",
        ] {
            assert!(parse_frames(text).is_err_and(|error| error.contains("such as 0..240")), "{text:?}");
        }
    }

    #[test]
    fn rates_are_numbers_or_fractions() {
        assert_eq!(parse_rate("24").unwrap().time_s(240), 10.0);
        assert_eq!(parse_rate("30000/1001").unwrap().time_s(30000), 1001.0);
        assert_eq!(parse_rate("29.97").unwrap().to_string(), "29.97");
        assert_eq!(parse_rate("30000/1001").unwrap().to_string(), "30000/1001");
        for text in ["", "0", "-24", "NaN", "inf", "1/0", "24/", "/1", "1e9", "fast", "1/2/3"] {
            assert!(parse_rate(text).is_err(), "{text:?}");
        }
    }

    /// Parts of any number make the whole, in order and without a frame twice.
    #[test]
    fn chunks_make_the_whole() {
        for frames in [Frames { from: 0, to: 240 }, Frames { from: 17, to: 24 }, Frames { from: 3, to: 4 }] {
            for count in [1, 2, 3, 7, 100] {
                let parts: Vec<Frames> =
                    (1..=count).filter_map(|index| Chunk { index, count }.of(frames)).collect();
                let numbers: Vec<u64> = parts.iter().flat_map(|part| part.numbers()).collect();
                assert_eq!(numbers, frames.numbers().collect::<Vec<_>>());
                let counts = || parts.iter().map(|part| part.count());
                let spread = counts().max().unwrap() - counts().min().unwrap();
                assert!(spread <= 1);
            }
        }
        assert_eq!(parse_chunk("2/5"), Ok(Chunk { index: 2, count: 5 }));
        assert!(parse_chunk("5/4").is_err_and(|error| error.contains("there are 4 parts")));
        for text in ["", "0/4", "1/0", "-1/4", "1/4/2", "a/b", "1", "1.5/4", "+1/4"] {
            assert!(parse_chunk(text).is_err_and(|error| error.contains("such as 2/5")), "{text:?}");
        }
    }

    #[test]
    fn a_pattern_has_one_counter() {
        let name = |pattern: &str, number| Pattern::parse(Path::new(pattern)).unwrap().path(number);
        assert_eq!(name("out/frame.%04d.png", 12), Path::new("out/frame.0012.png"));
        assert_eq!(name("%d.exr", 12), Path::new("12.exr"));
        assert_eq!(name("sea%%%03dx.png", 4567), Path::new("sea%4567x.png"));
        for (pattern, words) in [
            ("out/sea.png", "no counter"),
            ("sea.%d.%04d.png", "2 counters"),
            ("out%03d/sea.%d.png", "in the folder's name"),
            ("sea.%x.png", "no counter"),
            ("sea.%x.%d.png", "begins no counter"),
            ("sea.%4d.png", "no counter"),
            ("sea.%012d.png", "no counter"),
            ("sea.%04", "no counter"),
            ("sea.%%04d.png", "no counter"),
        ] {
            let refused = Pattern::parse(Path::new(pattern));
            assert!(refused.as_ref().is_err_and(|error| error.contains(words)), "{pattern}: {refused:?}");
        }
    }
}
