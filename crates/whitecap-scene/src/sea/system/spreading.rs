//! The key `spreading`: a law by its word, or cos²ˢ with its exponent.

use whitecap_waves::spreading;

use crate::error::SceneError;
use crate::key::{Accepts, Kind, Real, Words, read_word, required, words};
use crate::reader::ValueReader;

words! {
    /// A law for the spread of directions that has no number of its own.
    pub enum SpreadingLaw {
        /// cos² about the mean direction, the same for all waves.
        Cos2 = "cos2",
        /// Mitsuyasu's.
        Mitsuyasu = "mitsuyasu",
        /// Hasselmann's.
        Hasselmann = "hasselmann",
        /// Donelan's, continued by Banner.
        DonelanBanner = "donelan-banner",
        /// Elfouhaily's, down wind.
        Elfouhaily = "elfouhaily",
    }
}

/// How the directions of a wave system are spread.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum Spreading {
    /// By this law.
    Law(SpreadingLaw),
    /// cos²ˢ of half the angle from the mean direction.
    Cos2s {
        /// s, 0 to 1000: 0 is all directions alike, 1000 a spread of 2.6°.
        cos2s: f64,
    },
}

impl From<Spreading> for spreading::Spreading {
    fn from(spreading: Spreading) -> Self {
        match spreading {
            Spreading::Cos2s { cos2s } => Self::Cos2s { exponent: cos2s },
            Spreading::Law(SpreadingLaw::Cos2) => Self::CosSquared,
            Spreading::Law(SpreadingLaw::Mitsuyasu) => Self::Mitsuyasu,
            Spreading::Law(SpreadingLaw::Hasselmann) => Self::Hasselmann,
            Spreading::Law(SpreadingLaw::DonelanBanner) => Self::DonelanBanner,
            Spreading::Law(SpreadingLaw::Elfouhaily) => Self::Elfouhaily,
        }
    }
}

/// What `spreading` accepts.
pub(super) struct AnySpreading;

impl AnySpreading {
    /// s, of whatever spectrum: at 1000 directions spread by 2.6°, less than any swell's.
    pub(super) const EXPONENT: Real = Real { unit: "", min: 0.0, max: 1000.0 };

    fn words() -> Vec<&'static str> {
        SpreadingLaw::WORDS.iter().map(|word| word.word).collect()
    }
}

impl Kind for AnySpreading {
    type Value = Spreading;

    fn accepts(&self) -> Accepts {
        let Real { min, max, .. } = Self::EXPONENT;
        Accepts::WordsOrTable { words: Self::words(), key: "cos2s", min, max }
    }

    fn read(&self, value: &ValueReader<'_>) -> Result<Spreading, SceneError> {
        if value.string().is_some() {
            let found = read_word(value, "spreading", &Self::words())?;
            return Ok(Spreading::Law(SpreadingLaw::WORDS[found].value));
        }
        let accepts = self.accepts();
        let table = value
            .table()
            .map_err(|_| value.wrong_type(&format!("{}; accepted: {accepts}", accepts.type_name())))?;
        table.only(["cos2s"])?;
        Ok(Spreading::Cos2s { cos2s: table.read("cos2s", &required(Self::EXPONENT))? })
    }
}
