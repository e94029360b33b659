//! Why a measured sea could not be read.

use std::fmt;
use std::io;

use super::MAX_FILE_BYTES;

/// A measured sea that cannot be used, and why. It prints as one line that begins with the file and the line.
#[derive(Debug, thiserror::Error)]
pub struct MeasuredError {
    /// The file, or what stands for it.
    pub file: String,
    /// The line of the file, from 1, where there is one to name.
    pub line: Option<usize>,
    /// What is wrong with it.
    #[source]
    pub problem: MeasuredProblem,
}

impl fmt::Display for MeasuredError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, problem } = self;
        match line {
            Some(line) => write!(f, "{file}:{line}: {problem}"),
            None => write!(f, "{file}: {problem}"),
        }
    }
}

/// What is wrong with a measured sea.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeasuredProblem {
    /// The file system refused.
    #[error("cannot be read: {0}")]
    Unreadable(#[source] io::Error),

    /// There is no file of this name in the library.
    #[error("no such file comes with whitecap; accepted: {accepted}, or a path")]
    NoNamed {
        /// The names that there are.
        accepted: String,
    },

    /// It is a folder.
    #[error("this is a folder; accepted: a file of wave spectra")]
    Folder,

    /// It is a pipe, a socket or a device.
    #[error("no ordinary file; accepted: a file of wave spectra")]
    NoFile,

    /// The file has too many bytes.
    #[error("{bytes} bytes long; accepted: up to {MAX_FILE_BYTES}")]
    FileTooLong {
        /// How many.
        bytes: u64,
    },

    /// It is not text.
    #[error("not UTF-8 text; accepted: {FORMATS}")]
    NotText,

    /// It begins like none of the formats.
    #[error("no known format, by its first line; accepted: {FORMATS}")]
    UnknownFormat,

    /// It is one of the files of directions beside the file of densities.
    #[error(
        "directions without energy; accepted: the .data_spec file, with .swdir .swdir2 .swr1 .swr2 beside it"
    )]
    DirectionsAlone,

    /// Some of the four files of directions are there, but not all.
    #[error("needs {missing} beside it; accepted: all of .swdir .swdir2 .swr1 .swr2, or none of them")]
    NoCompanion {
        /// The file that is missing.
        missing: String,
    },

    /// Something else than what must stand there.
    #[error("found {found}; accepted: {accepted}")]
    Unexpected {
        /// What stands there, shortened.
        found: String,
        /// What may stand there.
        accepted: &'static str,
    },

    /// The file ends too soon.
    #[error("the file ends; wanted: {wanted}")]
    EndsEarly {
        /// What should come next.
        wanted: &'static str,
    },

    /// A record that ends before others of its file do.
    #[error("{bands} frequencies, the first of another record's {whole}; accepted: the record as a whole")]
    CutShort {
        /// How many frequencies it has.
        bands: usize,
        /// How many the other has.
        whole: usize,
    },

    /// The same time twice, with different values.
    #[error(
        "{record}, which line {first} has with other values; accepted: each time and place once, or the same again"
    )]
    Twice {
        /// What the line has again.
        record: String,
        /// The line that has it first.
        first: usize,
    },

    /// The waves are higher than any.
    #[error("{height_m:.1} m of significant height; accepted: up to {most_m} m")]
    TooHigh {
        /// The record's own significant height, metres.
        height_m: f64,
        /// The most that a sea may have, metres.
        most_m: f64,
    },

    /// There is too much of something.
    #[error("{count} {what}; accepted: {least} to {most}")]
    Count {
        /// What there is too much or too little of.
        what: &'static str,
        /// How many there are.
        count: u64,
        /// How few may be.
        least: u64,
        /// How many may be.
        most: u64,
    },

    /// It holds no record at all.
    #[error("no record; accepted: at least one spectrum")]
    NoRecord,

    /// There is no record of that time.
    #[error("no record of {asked}; there are {count} from {first} to {last}")]
    NoSuchTime {
        /// The time asked for.
        asked: String,
        /// How many records the place has.
        count: usize,
        /// The oldest.
        first: String,
        /// The newest.
        last: String,
    },

    /// There are not so many records.
    #[error("no record {asked}; accepted: 0, the newest, to {}", count.saturating_sub(1))]
    NoSuchRecord {
        /// The record asked for.
        asked: usize,
        /// How many there are.
        count: usize,
    },

    /// There is no such place.
    #[error("no place {asked:?}; accepted: {accepted}")]
    NoSuchPlace {
        /// The place asked for.
        asked: String,
        /// The places that there are.
        accepted: String,
    },

    /// The record, or every record, holds no energy.
    #[error("{which} without waves: {why}")]
    NoWaves {
        /// Which record.
        which: String,
        /// What it holds instead.
        why: &'static str,
    },

    /// The file says nothing of directions and the scene must.
    #[error("no directions in the file; needs from_deg, the bearing that the waves come from")]
    NoDirections,

    /// The files of directions lack this record's.
    #[error("no directions of {time} in {lacking}; accepted: another time, or from_deg for this one")]
    NoDirectionsThen {
        /// The file without them.
        lacking: String,
        /// The record's time.
        time: String,
    },

    /// The file says it, so the scene must not.
    #[error("the file has its own directions; accepted: no {key}")]
    HasDirections {
        /// The key that is too much.
        key: &'static str,
    },

    /// A method for directions, where there is nothing to apply it to.
    #[error("no directions in the file; accepted: no direction_method")]
    NoMoments,

    /// The numbers of the record make no spectrum.
    #[error("{0}")]
    NoSpectrum(#[source] whitecap_waves::ParameterError),
}

/// The formats, for messages.
const FORMATS: &str =
    "NDBC real-time or historical spectral density, WAVEWATCH III point spectra, or a SWAN spectral file";

impl MeasuredProblem {
    pub(super) fn in_file(self, file: impl fmt::Display) -> MeasuredError {
        MeasuredError { file: file.to_string(), line: None, problem: self }
    }

    pub(super) fn unexpected(found: &str, accepted: &'static str) -> Self {
        Self::Unexpected { found: quoted(found), accepted }
    }
}

/// A piece of a file as a quotation on one line, not too long.
pub(super) fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("{:?}…", &text[..cut]),
        None => format!("{text:?}"),
    }
}
