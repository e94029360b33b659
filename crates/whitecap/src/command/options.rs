//! Arguments that several verbs take, and their rules.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use whitecap_render::surface::Backend;

/// The moments that can be asked for; beyond them, 32-bit phases on the GPU lose their meaning.
pub(super) const MAX_TIME_S: f64 = 1e6;

/// How far from the origin a place can be, in metres or in the units of a texture coordinate.
pub(super) const MAX_FAR: f64 = 1e7;

/// The largest seed that a scene file can say: TOML's integers have a sign.
pub(super) const MAX_SEED: u64 = i64::MAX as u64;

// Which adapter draws. No sentence for clap, which would take it for the verb's own.
#[derive(Debug, clap::Args)]
pub(super) struct WantedAdapter {
    /// Part of the name, backend or driver of the adapter to draw with [default: the fastest kind]
    #[arg(long = "adapter", value_name = "NAME", value_hint = clap::ValueHint::Other)]
    pub(super) name: Option<String>,
}

/// A picture's size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) width: u32,
    pub(super) height: u32,
}

pub(super) fn parse_size(text: &str) -> Result<Size, String> {
    let side = |digits: &str| whole_number(digits).filter(|&side| side > 0);
    text.split_once(['x', 'X', '×'])
        .and_then(|(width, height)| Some(Size { width: side(width)?, height: side(height)? }))
        .ok_or_else(|| "accepted: two whole numbers from 1, width and height, such as 1280x720".to_owned())
}

pub(super) fn parse_time_s(text: &str) -> Result<f64, String> {
    within(text, MAX_TIME_S)
        .ok_or_else(|| format!("accepted: seconds from -{MAX_TIME_S} to {MAX_TIME_S}, such as 3.5"))
}

/// A number of digits alone: `parse` by itself would take "+5".
pub(super) fn whole_number<T: std::str::FromStr>(digits: &str) -> Option<T> {
    let plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    digits.parse().ok().filter(|_| plain)
}

/// Two numbers that say a place.
pub(super) type Place = [f64; 2];

pub(super) fn parse_place_m(text: &str) -> Result<Place, String> {
    pair(text).ok_or_else(|| {
        format!("accepted: metres east and south, each from -{MAX_FAR} to {MAX_FAR}, such as 12.5,-3")
    })
}

pub(super) fn parse_uv(text: &str) -> Result<Place, String> {
    pair(text).ok_or_else(|| format!("accepted: u and v, each from -{MAX_FAR} to {MAX_FAR}, such as 0.3,0.7"))
}

fn pair(text: &str) -> Option<Place> {
    let (first, second) = text.split_once(',')?;
    Some([within(first, MAX_FAR)?, within(second, MAX_FAR)?])
}

pub(super) fn within(text: &str, most: f64) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.abs() <= most) // never true of a NaN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_two_whole_numbers_from_one() {
        for text in ["1280x720", "1280X720", "1280×720"] {
            assert_eq!(parse_size(text), Ok(Size { width: 1280, height: 720 }), "{text}");
        }
        let wrong = [
            "",
            "x",
            "720",
            "0x0",
            "0x720",
            "1280x0",
            "-1x5",
            "+1x5",
            "1.5x2",
            "1x2x3",
            "99999999999x1",
            "axb",
            " 1x1",
            "NaNx1",
        ];
        for text in wrong {
            assert!(parse_size(text).is_err_and(|message| message.contains("1280x720")), "{text:?}");
        }
    }

    #[test]
    fn moments_are_finite_and_within_reach() {
        for (text, time_s) in [("0", 0.0), ("-2.5", -2.5), ("1e6", 1e6), ("-1e6", -1e6)] {
            assert_eq!(parse_time_s(text), Ok(time_s));
        }
        for text in ["", "NaN", "inf", "-inf", "1000001", "-1e7", "1e999", "3 s", "noon"] {
            assert!(parse_time_s(text).is_err_and(|message| message.contains("1000000")), "{text:?}");
        }
    }

    #[test]
    fn places_are_two_numbers_within_reach() {
        for (text, place) in [
            ("0,0", [0.0, 0.0]),
            ("-3,4", [-3.0, 4.0]),
            ("1e7,-1e7", [1e7, -1e7]),
            (".5,-0.25", [0.5, -0.25]),
        ] {
            assert_eq!(parse_place_m(text), Ok(place), "{text}");
            assert_eq!(parse_uv(text), Ok(place), "{text}");
        }
        for text in
            ["", ",", "1", "1,", ",1", "1,2,3", "NaN,0", "0,inf", "1.1e7,0", "0,-1.1e7", "1; 2", "a,b"]
        {
            assert!(parse_place_m(text).is_err_and(|message| message.contains("10000000")), "{text:?}");
            assert!(parse_uv(text).is_err_and(|message| message.contains("0.3,0.7")), "{text:?}");
        }
    }
}

/// A backend of the simulation, or none for the one that suits the adapter.
#[derive(Clone, Copy, Debug)]
pub(super) struct WantedBackend(pub(super) Option<Backend>);

/// Reads `auto` or a backend's word.
pub(super) fn backend_parser() -> impl TypedValueParser<Value = WantedBackend> {
    let words = ["auto"].into_iter().chain(Backend::ALL.map(Backend::word));
    PossibleValuesParser::new(words)
        .map(|word| WantedBackend(Backend::ALL.into_iter().find(|backend| backend.word() == word)))
}
