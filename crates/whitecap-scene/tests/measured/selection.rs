//! Which record of a file is meant, and what to say if there is none.

use whitecap_scene::measured::{Directions, Energy, Selection, Time, When, passed_over, select};
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
    let calm = |text: &str| {
        let seas = read(text);
        let found = select(&seas, &Selection::default()).unwrap();
        passed_over(&seas, found).map(|sea| (sea.time.unwrap().to_string(), sea.energy.clone()))
    };
    assert_eq!(calm(SWAN), Some(("2016-10-12T00:00:00Z".to_owned(), Energy::Calm)));
    assert_eq!(calm(WW3), None);
    let calm = chosen("YYYY MM DD hh .1 .2\n2000 01 01 00 0 0\n2000 01 01 01 MM MM\n", None, When::Newest);
    assert_eq!(calm.unwrap_err(), "2 records are without waves: every value is missing or 0");
    let calm = chosen("YYYY MM DD hh .1 .2\n2000 01 01 00 0 0\n", None, When::Newest);
    assert_eq!(calm.unwrap_err(), "the only record is without waves: every value is missing or 0");
}

/// A set of files whose directions come later, or not at all, for some hours.
#[test]
fn the_newest_with_waves_and_directions() {
    let newest =
        |hour: usize| format!("#\n2020 06 08 04 50 9.999 {hour}.00 (0.100) 4.000 (0.110) 2.000 (0.120)\n");
    let text = DATA_SPEC.to_owned() + &newest(1);
    let directions = DIRECTIONS.map(str::as_bytes);
    let seas = from_bytes_with_directions(text.as_bytes(), directions, "44097.data_spec").unwrap();
    let label = |sea: &MeasuredSea| sea.time.unwrap().to_string();
    let found = select(&seas, &Selection::default()).unwrap();
    assert_eq!(label(found), "2020-06-08T03:50:00Z");
    assert_eq!(passed_over(&seas, found).map(label).as_deref(), Some("2020-06-08T04:50:00Z"));
    // Who asks for the hour itself hears which file lacks it, and may say the direction.
    let when = When::At(Time::parse("2020-06-08T04:50").unwrap());
    let asked = select(&seas, &Selection { when, ..Selection::default() }).unwrap();
    assert_eq!(passed_over(&seas, asked), None);
    let nothing = Directions::default();
    assert_eq!(
        asked.spectrum(&nothing, &Dispersion::DEEP).unwrap_err().to_string(),
        "no directions of 2020-06-08T04:50:00Z in 44097.data_spec (.swdir); accepted: another time, or from_deg for \
         this one"
    );
    asked.spectrum(&Directions { from_deg: Some(9.0), ..nothing }, &Dispersion::DEEP).unwrap();
    // One file of four is enough to lack it, by its absence or by missing values alone.
    for (index, extension) in ["swdir", "swdir2", "swr1", "swr2"].into_iter().enumerate() {
        for lacking in
            [DIRECTIONS[index].to_owned(), format!("{}2020 06 08 04 50 999 (0.110)\n", DIRECTIONS[index])]
        {
            let whole = DIRECTIONS.map(|file| format!("{file}2020 06 08 04 50 0.5 (0.110)\n"));
            let mut files = whole.each_ref().map(|file| file.as_bytes());
            files[index] = lacking.as_bytes();
            let seas = from_bytes_with_directions(text.as_bytes(), files, "x").unwrap();
            let found = select(&seas, &Selection::default()).unwrap();
            let lacking = passed_over(&seas, found).and_then(MeasuredSea::lacking_directions);
            assert_eq!(lacking, Some(format!("x (.{extension})").as_str()));
        }
    }
    // Where no hour has directions, the newest is meant and says why it cannot be drawn.
    let early = DIRECTIONS.map(|file| file.replace("2020", "2019"));
    let seas = from_bytes_with_directions(text.as_bytes(), early.each_ref().map(|file| file.as_bytes()), "x")
        .unwrap();
    assert_eq!(label(select(&seas, &Selection::default()).unwrap()), "2020-06-08T04:50:00Z");
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

/// Records without times count in the order of the file: its last is the newest.
#[test]
fn without_times_the_last_is_the_newest() {
    let mut seas: Vec<_> = read(DATA_SPEC).into_iter().take(2).collect();
    seas.iter_mut().for_each(|sea| sea.time = None);
    let chosen = |when| select(&seas, &Selection { when, ..Selection::default() }).unwrap();
    assert!(std::ptr::eq(chosen(When::Newest), &seas[1]));
    assert!(std::ptr::eq(chosen(When::Back(1)), &seas[0]));
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
