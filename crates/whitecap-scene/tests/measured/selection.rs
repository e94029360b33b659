//! Which record of a file is meant, and what to say if there is none.

use whitecap_scene::measured::{Directions, Selection, Time, When, select};
use whitecap_waves::dispersion::Dispersion;

use super::*;

fn chosen(text: &str, place: Option<&str>, when: When) -> Result<String, String> {
    let seas = read(text);
    let selection = Selection { place: place.map(str::to_owned), when };
    let label = |sea: &MeasuredSea| format!("{} {}", sea.place.number, sea.time.unwrap());
    select(&seas, &selection).map(label).map_err(|problem| problem.to_string())
}

fn at(text: &str) -> When {
    When::At(Time::parse(text).unwrap())
}

#[test]
fn the_newest_with_waves_of_the_first_place() {
    assert_eq!(chosen(DATA_SPEC, None, When::Newest).unwrap(), "1 2020-06-08T03:50:00Z");
    assert_eq!(chosen(HISTORY, None, When::Newest).unwrap(), "1 2000-01-01T01:00:00Z");
    assert_eq!(chosen(WW3, None, When::Newest).unwrap(), "1 2022-09-12T07:00:00Z");
    // The newest has none.
    assert_eq!(chosen(WW3, Some("buoy 2"), When::Newest).unwrap(), "2 2022-09-12T06:00:00Z");
    assert_eq!(chosen(SWAN, None, When::Newest).unwrap(), "1 2016-10-11T00:00:00Z");
    let calm = chosen("YYYY MM DD hh .1 .2\n2000 01 01 00 0 0\n2000 01 01 01 MM MM\n", None, When::Newest);
    assert_eq!(calm.unwrap_err(), "2 records are without waves: every value is missing or 0");
}

#[test]
fn by_time() {
    assert_eq!(chosen(DATA_SPEC, None, at("2020-06-08T02:50")).unwrap(), "1 2020-06-08T02:50:00Z");
    assert_eq!(
        chosen(DATA_SPEC, None, at("2020-06-08T02:51")).unwrap_err(),
        "no record of 2020-06-08T02:51:00Z; there are 4 from 2020-06-08T00:50:00Z to 2020-06-08T03:50:00Z"
    );
}

#[test]
fn by_number_back_from_the_newest() {
    assert_eq!(chosen(HISTORY, None, When::Back(1)).unwrap(), "1 2000-01-01T00:00:00Z");
    assert_eq!(chosen(DATA_SPEC, None, When::Back(1)).unwrap(), "1 2020-06-08T02:50:00Z");
    assert_eq!(
        chosen(DATA_SPEC, None, When::Back(4)).unwrap_err(),
        "no record 4; accepted: 0, the newest, to 3"
    );
}

#[test]
fn by_place() {
    assert_eq!(chosen(WW3, Some("2"), at("2022-09-12T06:00")).unwrap(), "2 2022-09-12T06:00:00Z");
    assert_eq!(chosen(SWAN, Some("2"), When::Newest).unwrap(), "2 2016-10-12T00:00:00Z");
    assert_eq!(
        chosen(WW3, Some("x"), When::Newest).unwrap_err(),
        "no place \"x\"; accepted: \"first\", \"buoy 2\""
    );
    assert_eq!(
        chosen(SWAN, Some("3"), When::Newest).unwrap_err(),
        "no place \"3\"; accepted: \"1\" at (174.672501, -38.173599), \"2\" at (175, -39)"
    );
}

#[test]
fn directions_are_said_once() {
    let said = |sea: &MeasuredSea, directions: Directions| {
        sea.spectrum(&directions, &Dispersion::DEEP).unwrap_err().to_string()
    };
    let nothing = Directions::default();
    let from = Directions { from_deg: Some(10.0), ..nothing };
    let spread = Directions { cos2s: Some(10.0), ..nothing };
    let method = Directions { method: Some(Default::default()), ..nothing };
    let none = "no directions in the file; needs from_deg, the bearing that the waves come from";
    assert_eq!(said(&read(DATA_SPEC)[0], nothing), none);
    assert_eq!(said(&read(HISTORY)[0], spread), none);
    let both = Directions { method: method.method, ..from };
    assert_eq!(said(&read(HISTORY)[0], both), "no directions in the file; accepted: no direction_method");
    for sea in [&with_directions()[0], &read(WW3)[0], &read(SWAN)[0]] {
        assert_eq!(said(sea, from), "the file has its own directions; accepted: no from_deg");
        assert_eq!(said(sea, spread), "the file has its own directions; accepted: no cos2s");
    }
    assert_eq!(said(&read(WW3)[0], method), "the file has its own directions; accepted: no direction_method");
    assert_eq!(
        said(&read(DATA_SPEC)[2], from),
        "the record of 2020-06-08T01:50:00Z is without waves: every value is missing"
    );
    assert_eq!(
        said(&read(DATA_SPEC)[3], from),
        "the record of 2020-06-08T00:50:00Z is without waves: every value is 0"
    );
}
