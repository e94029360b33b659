//! A text file line by line, with the line's number for errors.

use super::{MeasuredError, MeasuredProblem};

/// The most frequencies, and the most directions, of a table.
const MOST_POINTS: usize = 1000;

/// The lines of a file, from where the reader is.
#[derive(Clone)]
pub(super) struct Text<'a> {
    name: &'a str,
    rest: std::str::Lines<'a>,
    /// The number of the last line that was read.
    line: usize,
}

impl<'a> Text<'a> {
    pub(super) fn new(bytes: &'a [u8], name: &'a str) -> Result<Self, MeasuredError> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let line = 1 + bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
            MeasuredError { file: name.to_owned(), line: Some(line), problem: MeasuredProblem::NotText }
        })?;
        Ok(Self { name, rest: text.trim_start_matches('\u{feff}').lines(), line: 0 })
    }

    /// The next line that is not blank.
    pub(super) fn next(&mut self) -> Option<&'a str> {
        for line in self.rest.by_ref() {
            self.line += 1;
            if !line.trim().is_empty() {
                return Some(line);
            }
        }
        None
    }

    /// The next line that is not blank, or an error that says what should be there.
    pub(super) fn expect(&mut self, wanted: &'static str) -> Result<&'a str, MeasuredError> {
        let line = self.next();
        line.ok_or_else(|| self.error(MeasuredProblem::EndsEarly { wanted }))
    }

    /// An error about the line that was read last.
    pub(super) fn error(&self, problem: MeasuredProblem) -> MeasuredError {
        self.error_at(self.line(), problem)
    }

    /// An error about a line that was read before.
    pub(super) fn error_at(&self, line: usize, problem: MeasuredProblem) -> MeasuredError {
        MeasuredError { file: self.name.to_owned(), line: Some(line), problem }
    }

    /// The number of the line that was read last, from 1.
    pub(super) fn line(&self) -> usize {
        self.line.max(1)
    }

    pub(super) fn unexpected(&self, found: &str, accepted: &'static str) -> MeasuredError {
        self.error(MeasuredProblem::unexpected(found.trim(), accepted))
    }

    /// A finite number, in any form that Fortran writes.
    pub(super) fn number(&self, word: &str, accepted: &'static str) -> Result<f64, MeasuredError> {
        number(word).ok_or_else(|| self.unexpected(word, accepted))
    }

    /// The first word of the next line as a number.
    pub(super) fn first_number(&mut self, accepted: &'static str) -> Result<f64, MeasuredError> {
        let line = self.expect(accepted)?;
        self.number(line.split_whitespace().next().unwrap_or_default(), accepted)
    }

    /// How many points a side of a table has.
    pub(super) fn points(
        &self,
        word: Option<&str>,
        what: &'static str,
        least: usize,
    ) -> Result<usize, MeasuredError> {
        let word = word.unwrap_or_default();
        let count: u64 = word.parse().map_err(|_| self.unexpected(word, "a count"))?;
        let (least, most) = (least as u64, MOST_POINTS as u64);
        if (least..=most).contains(&count) {
            Ok(count as usize)
        } else {
            Err(self.error(MeasuredProblem::Count { what, count, least, most }))
        }
    }

    /// As many numbers as that, from as many lines as it takes; the last must end with the last number.
    pub(super) fn numbers(&mut self, count: usize, wanted: &'static str) -> Result<Vec<f64>, MeasuredError> {
        self.numbers_that(count, wanted, |_, number| Ok(number))
    }

    /// The same, each checked or changed while its line is the last that was read.
    pub(super) fn numbers_that(
        &mut self,
        count: usize,
        wanted: &'static str,
        each: impl Fn(&Self, f64) -> Result<f64, MeasuredError>,
    ) -> Result<Vec<f64>, MeasuredError> {
        // What is set aside is no more than what the file has: the vector grows with it.
        let mut numbers = Vec::new();
        while numbers.len() < count {
            let line = self.expect(wanted)?;
            for word in line.split_whitespace() {
                if numbers.len() == count {
                    return Err(self.unexpected(word, "the end of the line, for there are enough numbers"));
                }
                numbers.push(each(self, self.number(word, wanted)?)?);
            }
        }
        Ok(numbers)
    }

    /// Checks that frequencies in Hz ascend and are of waves: from 60 km to less than a millimetre, what the sea is made of.
    pub(super) fn ascending(&self, frequencies_hz: &[f64]) -> Result<(), MeasuredError> {
        let mut below = 0.0;
        for &hz in frequencies_hz {
            if !(0.005..=50.0).contains(&hz) || hz <= below {
                return Err(self.unexpected(&hz.to_string(), "frequencies from 0.005 to 50 Hz, ascending"));
            }
            below = hz;
        }
        Ok(())
    }

    /// Checks that no two directions, in radians, are the same.
    pub(super) fn distinct(&self, toward_rad: &[f64]) -> Result<(), MeasuredError> {
        let mut turned: Vec<_> =
            toward_rad.iter().map(|toward| toward.rem_euclid(std::f64::consts::TAU)).collect();
        turned.sort_by(f64::total_cmp);
        let closing = turned.first().map(|first| first + std::f64::consts::TAU);
        turned.extend(closing);
        if turned.windows(2).any(|pair| pair[1] - pair[0] < 1e-5) {
            return Err(self.unexpected("a direction twice", "different directions"));
        }
        Ok(())
    }
}

/// A finite number as Fortran writes it: with `D` for `E`, or without either where the exponent has three
/// digits.
pub(super) fn number(word: &str) -> Option<f64> {
    let parse = |word: &str| word.parse::<f64>().ok().filter(|number| number.is_finite());
    // "inf" and "nan" parse, and are not finite; nothing else of letters does.
    if let Some(number) = parse(word) {
        return Some(number);
    }
    if let Some((mantissa, exponent)) = word.split_once(['d', 'D']) {
        return parse(&format!("{mantissa}e{exponent}"));
    }
    let sign = word.char_indices().skip(1).find(|(_, c)| matches!(c, '+' | '-'))?.0;
    parse(&format!("{}e{}", &word[..sign], &word[sign..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_fortran_writes_them() {
        for (word, expected) in
            [("0.261E-17", 0.261e-17), ("-.5", -0.5), ("1.", 1.0), ("0.1D+02", 10.0), ("0.26-102", 0.26e-102)]
        {
            assert_eq!(number(word), Some(expected), "{word}");
        }
        for word in ["", "NaN", "inf", "-Infinity", "*****", "1e999", "-", "+-", "é-1", "0x1", "1e5d", "MM"]
        {
            assert_eq!(number(word), None, "{word}");
        }
    }
}
