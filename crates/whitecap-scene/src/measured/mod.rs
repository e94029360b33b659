//! Seas that somebody measured or calculated, in the files that their makers publish.
//!
//! | format | directions |
//! |---|---|
//! | NDBC real-time spectral wave data, `.data_spec` | first moments, in `.swdir .swdir2 .swr1 .swr2` of the same name beside it; without them, none |
//! | NDBC historical spectral wave density | none |
//! | WAVEWATCH III point output of spectra | a table |
//! | SWAN standard spectral file, version 1 | a table, or mean and spread |
//!
//! Files are told apart by their first line. A single value that is missing counts as no energy and is kept in mind as such; a record
//! without any value is kept as [`Energy::Missing`]. A record that a file repeats counts once; one that it has twice with
//! different values is an error. Memory is set aside for what a file holds, not for what
//! its header claims.

mod error;
mod ndbc;
mod quadrature;
mod records;
mod sea;
mod select;
mod swan;
mod text;
mod time;
mod ww3;

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use error::{MeasuredError, MeasuredProblem};
pub use sea::{Directions, Energy, Format, MeasuredSea, Part, Place};
pub use select::{Selection, When, passed_over, select};
pub use time::Time;

use records::Records;
use text::Text;

use crate::named;

/// The longest file that is read, bytes: a year of a buoy has three million.
pub const MAX_FILE_BYTES: u64 = 64 << 20;

/// Reads every record of a file, and of the files of directions beside it; `named:…` is a file that comes with the library.
///
/// # Errors
///
/// If the file cannot be read, is of another format, is damaged, or is longer than [`MAX_FILE_BYTES`].
pub fn load(path: &Path) -> Result<Vec<MeasuredSea>, MeasuredError> {
    let name = path.display().to_string();
    if let Some(known) = named::file(path) {
        let bytes =
            known.ok_or_else(|| MeasuredProblem::NoNamed { accepted: named::files() }.in_file(&name))?;
        return from_bytes(bytes, &name);
    }
    let bytes = bytes_of(path)?;
    if !ndbc::is_real_time(first_line(&bytes)) {
        return from_bytes(&bytes, &name);
    }
    let beside = ndbc::COMPANIONS.map(|extension| path.with_extension(extension));
    if !beside.iter().any(|path| path.exists()) {
        return from_bytes(&bytes, &name);
    }
    if let Some(missing) = beside.iter().find(|path| !path.exists()) {
        let missing = missing.file_name().unwrap_or_default().to_string_lossy().into_owned();
        return Err(MeasuredProblem::NoCompanion { missing }.in_file(name));
    }
    let mut read = Vec::new();
    for path in &beside {
        read.push((bytes_of(path)?, path.display().to_string()));
    }
    let part =
        |i: usize| read.get(i).map_or((&[][..], ""), |(bytes, name)| (bytes.as_slice(), name.as_str()));
    ndbc::read_real_time(&bytes, &name, Some([part(0), part(1), part(2), part(3)]))
}

/// Reads every record of the bytes of a file; `name` is what errors call it.
///
/// # Errors
///
/// As [`load`].
pub fn from_bytes(bytes: &[u8], name: &str) -> Result<Vec<MeasuredSea>, MeasuredError> {
    check_length(bytes.len() as u64, name)?;
    let first_line = first_line(bytes);
    if ndbc::is_real_time(first_line) {
        ndbc::read_real_time(bytes, name, None)
    } else if ndbc::names_directions(first_line) {
        Err(MeasuredProblem::DirectionsAlone.in_file(name))
    } else if ndbc::is_history(first_line) {
        ndbc::read_history(bytes, name)
    } else if ww3::is_ww3(first_line) {
        ww3::read(bytes, name)
    } else if swan::is_swan(first_line) {
        swan::read(bytes, name)
    } else {
        Err(MeasuredProblem::UnknownFormat.in_file(name))
    }
}

/// Reads NDBC real-time densities with their directions: the bytes of `.swdir`, `.swdir2`, `.swr1` and
/// `.swr2`.
///
/// # Errors
///
/// As [`load`].
pub fn from_bytes_with_directions(
    bytes: &[u8],
    directions: [&[u8]; 4],
    name: &str,
) -> Result<Vec<MeasuredSea>, MeasuredError> {
    check_length(bytes.len() as u64, name)?;
    if !ndbc::is_real_time(first_line(bytes)) {
        return Err(MeasuredProblem::UnknownFormat.in_file(name));
    }
    let [mean, principal, r1, r2] = directions;
    for bytes in directions {
        check_length(bytes.len() as u64, name)?;
    }
    let [mean_name, principal_name, r1_name, r2_name] =
        ndbc::COMPANIONS.map(|extension| format!("{name} (.{extension})"));
    let named = [(mean, &*mean_name), (principal, &*principal_name), (r1, &*r1_name), (r2, &*r2_name)];
    ndbc::read_real_time(bytes, name, Some(named))
}

/// The first line that is not blank, if it is text.
fn first_line(bytes: &[u8]) -> &str {
    const LONGEST: usize = 1 << 16;
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes).trim_ascii_start();
    let end = bytes.iter().take(LONGEST).position(|byte| *byte == b'\n').unwrap_or(bytes.len().min(LONGEST));
    // The later part may be of whatever encoding; what is recognised stands at the beginning.
    match std::str::from_utf8(&bytes[..end]) {
        Ok(line) => line,
        Err(error) => std::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default(),
    }
}

fn check_length(bytes: u64, name: &str) -> Result<(), MeasuredError> {
    if bytes > MAX_FILE_BYTES { Err(MeasuredProblem::FileTooLong { bytes }.in_file(name)) } else { Ok(()) }
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, MeasuredError> {
    let name = path.display();
    let unreadable = |error| MeasuredProblem::Unreadable(error).in_file(&name);
    // Before it is opened: opening a pipe that nobody writes to would wait for ever.
    let about = std::fs::metadata(path).map_err(unreadable)?;
    if about.is_dir() {
        return Err(MeasuredProblem::Folder.in_file(&name));
    }
    if !about.is_file() {
        return Err(MeasuredProblem::NoFile.in_file(&name));
    }
    check_length(about.len(), &name.to_string())?;
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes))
        .map_err(unreadable)?;
    check_length(bytes.len() as u64, &name.to_string())?;
    Ok(bytes)
}
