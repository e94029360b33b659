//! A view as the fragment of an address: `#scene=meshuggah&t=12.5&eye=0,40,0`.
//!
//! It names the scene, the moment, and what differs from the scene as it comes: the camera, settings by their keys. Whoever
//! opens it sees the same. It is read as hostile text: what it says is checked as a scene file is, or refused in one sentence.

use crate::document::Document;
use whitecap_scene::{Camera, SceneError};

/// The longest fragment that is read, bytes: a hundred settings, and what browsers carry.
const LONGEST: usize = 16 << 10;

/// The times that a link may say, s: those of `whitecap render --time`.
const TIMES_S: std::ops::RangeInclusive<f64> = -1e6..=1e6;

/// Why a link is not followed.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// More than anybody shares.
    #[error("the link is longer than {LONGEST} characters")]
    TooLong,
    /// A part of it is not what it should be.
    #[error("the link says {found:?}; accepted: {accepted}")]
    Word {
        /// What stands there.
        found: String,
        /// What may stand there.
        accepted: &'static str,
    },
    /// What it says is no scene.
    #[error("the link's scene cannot be shown: {0}")]
    Scene(#[from] SceneError),
}

/// A view that can be shared.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// A named scene; without one the default.
    pub scene: Option<String>,
    /// The scene's time, s.
    pub time_s: Option<f64>,
    /// Whether time stands still there.
    pub is_paused: bool,
    /// The camera, if it is not the scene's.
    pub camera: Option<Camera>,
    /// Settings that are not the scene's, by key; without a value the key is left out.
    pub settings: Vec<(String, Option<toml::Value>)>,
}

impl Link {
    /// Reads the fragment of an address, with its `#` or without.
    ///
    /// # Errors
    ///
    /// If a part of it means nothing. Whether scene and settings can be shown is for [`Link::document`] to say.
    pub fn parse(fragment: &str) -> Result<Link, LinkError> {
        if fragment.len() > LONGEST {
            return Err(LinkError::TooLong);
        }
        let mut link = Link::default();
        let (mut eye, mut at, mut fov) = (None, None, None);
        for part in fragment.trim_start_matches('#').split('&').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once('=').unwrap_or((part, ""));
            let (name, value) = (decoded(name), decoded(value));
            let refuse = |accepted| LinkError::Word { found: format!("{name}={value}"), accepted };
            match name.as_str() {
                "scene" => link.scene = Some(value),
                "t" => {
                    let time_s = value.parse().ok().filter(|time_s| TIMES_S.contains(time_s));
                    link.time_s = Some(time_s.ok_or_else(|| refuse("t=SECONDS, from -1000000 to 1000000"))?);
                }
                "paused" => link.is_paused = true,
                "eye" => eye = Some(point(&value).ok_or_else(|| refuse("eye=X,Y,Z in metres"))?),
                "at" => at = Some(point(&value).ok_or_else(|| refuse("at=X,Y,Z in metres"))?),
                "fov" => fov = Some(value.parse::<f64>().map_err(|_| refuse("fov=DEGREES"))?),
                _ => link.settings.push((name, setting(&value))),
            }
        }
        link.camera = match (eye, at, fov) {
            (None, None, None) => None,
            (Some(position_m), Some(look_at_m), Some(vertical_fov_deg)) => {
                Some(Camera { position_m, look_at_m, vertical_fov_deg })
            }
            _ => {
                let found = "a part of a camera".to_owned();
                return Err(LinkError::Word { found, accepted: "eye, at and fov together" });
            }
        };
        Ok(link)
    }

    /// The scene that it shows, with its settings, and the camera.
    ///
    /// # Errors
    ///
    /// If there is no such scene, or the checker refuses a setting or the camera.
    pub fn document(&self) -> Result<(Document, Camera), LinkError> {
        let name = self.scene.as_deref().unwrap_or(whitecap_scene::named::DEFAULT);
        let mut document = Document::named(name)?;
        document.change(&self.settings)?;
        let camera = self.camera.clone().unwrap_or_else(|| document.scene().camera.clone());
        // As a file that had this camera would be checked.
        document.text(camera.clone())?;
        Ok((document, camera))
    }
}

impl std::fmt::Display for Link {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "scene={}", encoded(self.scene.as_deref().unwrap_or(whitecap_scene::named::DEFAULT)))?;
        if let Some(time_s) = self.time_s {
            write!(f, "&t={}", rounded(time_s, 1e3))?;
        }
        if self.is_paused {
            f.write_str("&paused")?;
        }
        if let Some(camera) = &self.camera {
            let point =
                |[x, y, z]: [f64; 3]| [x, y, z].map(|metres| rounded(metres, 1e3).to_string()).join(",");
            let fov_deg = rounded(camera.vertical_fov_deg, 1e3);
            write!(f, "&eye={}&at={}&fov={fov_deg}", point(camera.position_m), point(camera.look_at_m))?;
        }
        for (key, value) in &self.settings {
            let value = match value {
                Some(toml::Value::String(word)) => encoded(word),
                Some(value) => encoded(&value.to_string()),
                None => String::new(),
            };
            write!(f, "&{}={value}", encoded(key))?;
        }
        Ok(())
    }
}

/// To so many parts of one: links need not say atoms.
fn rounded(number: f64, parts: f64) -> f64 {
    (number * parts).round() / parts + 0.0
}

fn point(text: &str) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.parse().ok()).collect();
    numbers?.try_into().ok()
}

/// A value as TOML writes it; what is none is a word.
fn setting(text: &str) -> Option<toml::Value> {
    if text.is_empty() {
        return None;
    }
    let table = format!("value = {text}").parse::<toml::Table>().ok().filter(|table| table.len() == 1);
    let value = table.and_then(|mut table| table.remove("value"));
    Some(value.unwrap_or_else(|| toml::Value::String(text.to_owned())))
}

/// With `%` and hexadecimal digits for all that could mean something in an address.
fn encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len());
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'[' | b']' | b',' => {
                encoded.push(char::from(byte));
            }
            _ => encoded += &format!("%{byte:02X}"),
        }
    }
    encoded
}

/// The other way. A `%` without digits stays; what is no UTF-8 becomes �.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        let digit = |place: usize| after.get(place).and_then(|&digit| char::from(digit).to_digit(16));
        match (byte, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((16 * high + low) as u8);
                rest = &after[2..];
            }
            _ => {
                bytes.push(byte);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use toml::Value;

    #[test]
    fn a_link_gives_the_view_that_it_was_made_of() {
        let link = Link {
            scene: Some("spectral-ocean-storm".into()),
            time_s: Some(12.5),
            is_paused: true,
            camera: Some(Camera {
                position_m: [1.5, 9.0, -2.0],
                look_at_m: [100.0, 0.0, 0.25],
                vertical_fov_deg: 50.0,
            }),
            settings: vec![
                ("sea.system[0].wind_speed_mps".into(), Some(Value::Float(14.0))),
                ("sky.sun_azimuth_deg".into(), Some(Value::Float(200.5))),
            ],
        };
        let text = link.to_string();
        assert_eq!(
            text,
            "scene=spectral-ocean-storm&t=12.5&paused&eye=1.5,9,-2&at=100,0,0.25&fov=50\
             &sea.system[0].wind_speed_mps=14.0&sky.sun_azimuth_deg=200.5"
        );
        assert_eq!(Link::parse(&format!("#{text}")).unwrap(), link);
        let (document, camera) = link.document().unwrap();
        assert_eq!(Some(camera), link.camera);
        assert_eq!(document.changes(), link.settings);
    }

    #[test]
    fn an_empty_link_is_the_default_scene() {
        for fragment in ["", "#", "#&&"] {
            let link = Link::parse(fragment).unwrap();
            assert_eq!(link, Link::default());
            assert_eq!(link.document().unwrap().0.origin(), whitecap_scene::named::DEFAULT);
        }
    }

    #[test]
    fn every_named_scene_has_a_link_and_another_technique_is_a_setting() {
        for named in whitecap_scene::named::ALL {
            let link = Link::parse(&format!("scene={}", named.name)).unwrap();
            assert!(link.document().unwrap().0.changes().is_empty(), "{}", named.name);
        }
        let link = Link::parse("scene=meshuggah&technique=five-sample").unwrap();
        match link.document() {
            Ok((document, _)) => assert_eq!(document.scene().technique.word(), "five-sample"),
            Err(error) => assert!(error.to_string().contains("accepted"), "{error}"),
        }
    }

    #[test]
    fn nonsense_is_refused_in_a_sentence() {
        for (fragment, says) in [
            ("t=soon", "t=SECONDS"),
            ("t=NaN", "t=SECONDS"),
            ("t=1e99", "t=SECONDS"),
            ("eye=1,2", "eye=X,Y,Z"),
            ("eye=1,2,3", "eye, at and fov together"),
            ("fov=wide", "fov=DEGREES"),
            ("eye=1,2,3&at=NaN,0,0&fov=40", "camera"),
            ("eye=1,2,3&at=9,0,0&fov=4000", "accepted"),
            ("scene=nothing", "no such scene"),
            ("scene=..%2F..%2Fetc%2Fpasswd", "no such scene"),
            ("scene=%FF%00%zz", "no such scene"),
            ("seed=-1", "seed"),
            ("no.such.key=1", "no"),
            ("sea.system[7].gamma=3", "sea.system[7]"),
            ("sea.system[0]=3", "unknown key"),
            ("sea.system[x].gamma=3", "sea.system[x]"),
            (".=.", "no key"),
            ("sea=1%0Aseed%20%3D%202", "sea"),
            ("object=[]&sky.file=a.exr", "sky"),
        ] {
            let error = match Link::parse(fragment).map(|link| link.document()) {
                Err(error) | Ok(Err(error)) => error.to_string(),
                Ok(Ok(_)) => panic!("{fragment} is accepted"),
            };
            assert!(error.contains(says), "{fragment}: {error}");
            assert_eq!(error.lines().count(), 1, "{fragment}: {error}");
        }
        assert!(matches!(Link::parse(&"a".repeat(1 << 20)), Err(LinkError::TooLong)));
    }

    #[test]
    fn words_come_back_as_they_were() {
        for word in ["", "a b&c=d", "100 %", "Wellenhöhe ♒", "a%2", "%"] {
            assert_eq!(decoded(&encoded(word)), word);
        }
        assert_eq!(decoded("%zz%4"), "%zz%4");
    }
}
