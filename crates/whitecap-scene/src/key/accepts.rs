//! What a key accepts, as data: errors and documents print it, a panel makes sliders and menus of it.

use std::fmt;

use crate::reader::quoted_list;

/// The values that a key accepts. It prints as errors and documents say it: `0.1 to 50 m/s`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Accepts {
    /// A number; bounds included.
    Real {
        /// The least.
        min: f64,
        /// The greatest.
        max: f64,
        /// The unit of both, such as `m/s`; empty for a pure number.
        unit: &'static str,
    },
    /// An integer; bounds included.
    Integer {
        /// The least.
        min: u64,
        /// The greatest.
        max: u64,
    },
    /// One of these integers.
    Integers(Vec<u32>),
    /// One of these words.
    Words(Vec<&'static str>),
    /// One of these words, or a table with one number: `{ key = number }`.
    WordsOrTable {
        /// The words.
        words: Vec<&'static str>,
        /// The key of the table.
        key: &'static str,
        /// The least of its number.
        min: f64,
        /// The greatest of its number.
        max: f64,
    },
    /// Red, green and blue, each within the bounds.
    Colour {
        /// The least of each.
        min: f64,
        /// The greatest of each.
        max: f64,
        /// The unit of each; empty for a pure number.
        unit: &'static str,
    },
    /// Two numbers, each within the bounds.
    Pair {
        /// The least of each.
        min: f64,
        /// The greatest of each.
        max: f64,
        /// The unit of each; empty for pure numbers.
        unit: &'static str,
    },
    /// `true` or `false`.
    Flag,
    /// A place `[x, y, z]` in metres: x east, y up, z south.
    Point {
        /// The least of each axis.
        min: [f64; 3],
        /// The greatest of each axis.
        max: [f64; 3],
    },
    /// The path of a file, relative to the scene file's folder.
    File,
    /// A name in the words of another file.
    Name,
    /// A moment, such as `2022-09-12T06:00:00Z`.
    Time,
    /// A number of tables of the same name, `[[like.this]]`.
    Tables {
        /// Their name.
        name: &'static str,
        /// The fewest.
        min: usize,
        /// The most; the largest number for as many as a file holds.
        max: usize,
    },
}

impl Accepts {
    /// The type of value, with its article: "a number", "an array of 3 numbers".
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::Real { .. } => "a number",
            Self::Integer { .. } | Self::Integers(_) => "an integer",
            Self::Words(_) | Self::File | Self::Name | Self::Time => "a string",
            Self::Colour { .. } | Self::Point { .. } => "an array of 3 numbers",
            Self::Pair { .. } => "an array of 2 numbers",
            Self::WordsOrTable { .. } => "a string or a table",
            Self::Flag => "a boolean",
            Self::Tables { .. } => "an array of tables",
        }
    }

    /// The unit of the value; empty if it has none.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Real { unit, .. } | Self::Colour { unit, .. } | Self::Pair { unit, .. } => unit,
            Self::Point { .. } => "m",
            _ => "",
        }
    }
}

impl fmt::Display for Accepts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = if self.unit().is_empty() { String::new() } else { format!(" {}", self.unit()) };
        match self {
            Self::Real { min, max, .. } => write!(f, "{min} to {max}{unit}"),
            Self::Integer { min, max } => write!(f, "{min} to {max}"),
            Self::Integers(integers) => {
                f.write_str(&integers.iter().map(u32::to_string).collect::<Vec<_>>().join(", "))
            }
            Self::Words(words) => f.write_str(&quoted_list(words)),
            Self::WordsOrTable { words, key, min, max } => {
                write!(f, "{}, {{ {key} = {min} to {max} }}", quoted_list(words))
            }
            Self::Colour { min, max, .. } => write!(f, "[red, green, blue], each {min} to {max}{unit}"),
            Self::Pair { min, max, .. } => write!(f, "[first, second], each {min} to {max}{unit}"),
            Self::Flag => f.write_str("true, false"),
            Self::Point { min: [x, y, z], max: [to_x, to_y, to_z] } => {
                write!(f, "[x, y, z], x {x} to {to_x}, y {y} to {to_y}, z {z} to {to_z}{unit}")
            }
            Self::File => f.write_str("the path of a file, relative to the scene file"),
            Self::Name => f.write_str("a name"),
            Self::Time => f.write_str("a time such as 2022-09-12T06:00:00Z"),
            Self::Tables { name, min, max } if min == max => write!(f, "{min} tables [[{name}]]"),
            Self::Tables { name, min, max: usize::MAX } => write!(f, "{min} or more tables [[{name}]]"),
            Self::Tables { name, min, max } => write!(f, "{min} to {max} tables [[{name}]]"),
        }
    }
}
