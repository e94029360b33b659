//! The answers as lines of a table, of CSV or of a JSON list, written as they are found.

use super::answers::{InText, InWorld};
use crate::failure::Failure;
use std::io::{self, BufWriter, Write};

/// The columns of CSV, in the order of [`Rows::in_world`].
const COLUMNS: &str = "x_m,z_m,time_s,height_m,displacement_x_m,displacement_y_m,displacement_z_m,\
                       normal_x,normal_y,normal_z,velocity_x_mps,velocity_y_mps,velocity_z_mps";

/// What a row looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Table,
    Csv,
    Json,
}

/// A writer of rows.
pub(super) struct Rows<'a> {
    format: Format,
    out: BufWriter<&'a mut dyn Write>,
    /// What an error of `out` means.
    failure: &'a dyn Fn(io::Error) -> Failure,
    in_world: u64,
    in_text: u64,
}

impl<'a> Rows<'a> {
    pub(super) fn new(
        format: Format,
        out: &'a mut dyn Write,
        failure: &'a dyn Fn(io::Error) -> Failure,
    ) -> Self {
        Self { format, out: BufWriter::with_capacity(1 << 16, out), failure, in_world: 0, in_text: 0 }
    }

    pub(super) fn begin(&mut self) -> Result<(), Failure> {
        let begun = match self.format {
            Format::Table => Ok(()),
            Format::Csv => writeln!(self.out, "{COLUMNS}"),
            Format::Json => write!(self.out, "["),
        };
        begun.map_err(self.failure)
    }

    pub(super) fn in_world(&mut self, answer: &InWorld) -> Result<(), Failure> {
        let InWorld {
            x_m,
            z_m,
            time_s,
            height_m,
            displacement_m: [dx, dy, dz],
            normal: [nx, ny, nz],
            velocity_mps: [vx, vy, vz],
        } = answer;
        let written = match self.format {
            Format::Json => self.entry(answer),
            // `{:?}` prints the shortest digits that read back as the same number, as JSON has them.
            Format::Csv => writeln!(
                self.out,
                "{x_m:?},{z_m:?},{time_s:?},{height_m:?},{dx:?},{dy:?},{dz:?},{nx:?},{ny:?},{nz:?},{vx:?},{vy:?},\
                 {vz:?}"
            ),
            Format::Table => self.head_of_world().and_then(|()| {
                writeln!(
                    self.out,
                    "{x_m:12} {z_m:12} {time_s:10} {height_m:10.4}  {dx:10.4} {dy:10.4} {dz:10.4}  \
                     {nx:9.5} {ny:9.5} {nz:9.5}  {vx:8.3} {vy:8.3} {vz:8.3}"
                )
            }),
        };
        self.in_world += 1;
        written.map_err(self.failure)
    }

    /// A row in the units of the text, for which there is no CSV.
    pub(super) fn in_text(&mut self, answer: &InText) -> Result<(), Failure> {
        let InText { u, v, time_s, height, normal: [nx, ny, nz] } = answer;
        let written = match self.format {
            Format::Json | Format::Csv => self.entry(answer),
            Format::Table => self.head_of_text().and_then(|()| {
                writeln!(self.out, "{u:12} {v:12} {time_s:10} {height:12.5}  {nx:10.6} {ny:10.6} {nz:10.6}")
            }),
        };
        self.in_text += 1;
        written.map_err(self.failure)
    }

    /// Sees the rows out, so that a reader has them and a full disk is noticed.
    pub(super) fn flush(&mut self) -> Result<(), Failure> {
        self.out.flush().map_err(self.failure)
    }

    pub(super) fn end(&mut self) -> Result<(), Failure> {
        self.close().map_err(self.failure)
    }

    /// Makes a whole list of the rows so far, with why there are no more as its last entry. Whether it did: only
    /// a JSON list can say so.
    pub(super) fn end_early(&mut self, failure: &Failure) -> bool {
        let Some(sentence) = failure.sentence().filter(|_| self.format == Format::Json) else {
            return false;
        };
        let entry = serde_json::json!({ "error": sentence });
        self.entry(&entry)
            .and_then(|()| {
                self.in_world += 1;
                self.close()
            })
            .is_ok()
    }

    fn close(&mut self) -> io::Result<()> {
        if self.format == Format::Json {
            let end = if self.in_world + self.in_text > 0 { "\n]" } else { "]" };
            writeln!(self.out, "{end}")?;
        }
        self.out.flush()
    }

    fn entry(&mut self, answer: &impl serde::Serialize) -> io::Result<()> {
        let comma = if self.in_world + self.in_text > 0 { "," } else { "" };
        write!(self.out, "{comma}\n  ")?;
        serde_json::to_writer(&mut self.out, answer).map_err(io::Error::from)
    }

    fn head_of_world(&mut self) -> io::Result<()> {
        if self.in_world > 0 {
            return Ok(());
        }
        writeln!(
            self.out,
            "{:>12} {:>12} {:>10} {:>10}  {:^32}  {:^29}  {:^26}",
            "x, m", "z, m", "time, s", "height, m", "displacement, m", "normal", "velocity, m/s"
        )
    }

    fn head_of_text(&mut self) -> io::Result<()> {
        if self.in_text > 0 {
            return Ok(());
        }
        writeln!(self.out, "{:>12} {:>12} {:>10} {:>12}  {:^32}", "u", "v", "time, s", "height", "normal")
    }
}
