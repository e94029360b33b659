//! The reference lists exactly what the readers accept, and every range in it is the one that is checked.

#![allow(clippy::unwrap_used, reason = "a helper of tests may fail as a test may")]

use std::collections::BTreeSet;

use proptest::prelude::*;
use toml::{Table, Value};
use whitecap_scene::reference::{Accepts, KeyDoc, WhenAbsent, differences, markdown, reference};
use whitecap_scene::{Scene, SceneError, named, sea, sky, technique};

/// A scene of one wave system, which every technique that draws spectra can draw.
const PLAIN: &str = "meshuggah";

/// The plain scene drawn by `technique`, with that technique's own sea and settings.
fn scene_drawn_by(technique: &str) -> Table {
    let scene = whitecap_scene::open(PLAIN).unwrap();
    let drawn_by = scene.technique.word();
    let mut scene: Table = scene.to_toml().unwrap().parse().unwrap();
    if technique != drawn_by {
        scene.insert("technique".to_owned(), technique.into());
        scene.remove(drawn_by);
        // A technique that draws the same kind of sea keeps its waves, and chooses its tiles.
        let same = technique::that_draw("spectral").any(|word| word == technique);
        let waves = scene["sea"].get("system").filter(|_| same).cloned();
        scene.insert(
            "sea".to_owned(),
            Table::from_iter(waves.map(|waves| ("system".to_owned(), waves))).into(),
        );
        scene.insert(technique.to_owned(), Table::new().into());
    }
    scene
}

/// The technique that draws the sea of this model.
fn drawn_with(model: &str) -> &'static str {
    let draws = |word: &str| {
        let toml = scene_drawn_by(word).to_string();
        Scene::from_toml(&toml, word).unwrap().technique.sea_models().contains(&model)
    };
    technique::ALL.iter().map(|technique| technique.word).find(|word| draws(word)).unwrap()
}

/// A scene in which the table of `doc` is there with the kind that has the key.
fn scene_with_table_of(doc: &KeyDoc) -> Table {
    let mut scene = match (doc.table.as_str(), doc.only_with) {
        ("sea", Some((_, model))) => scene_drawn_by(drawn_with(model)),
        ("sea.wave[]", _) => scene_drawn_by(drawn_with("sines")),
        ("picture", _) => {
            let linear = |word: &&str| {
                Scene::from_toml(&scene_drawn_by(word).to_string(), "any")
                    .is_ok_and(|scene| scene.technique.is_scene_linear())
            };
            scene_drawn_by(technique::ALL.iter().map(|technique| technique.word).find(linear).unwrap())
        }
        // Without it, the default technique draws.
        ("", _) => whitecap_scene::open(named::DEFAULT).unwrap().to_toml().unwrap().parse().unwrap(),
        (table, _) if technique::ALL.iter().any(|technique| technique.word == table) => scene_drawn_by(table),
        _ => whitecap_scene::open(PLAIN).unwrap().to_toml().unwrap().parse().unwrap(),
    };
    if doc.table == "sea.wave[]" {
        let wave = || -> Table {
            "height = 1.0\nspeed_turns_per_s = 0.2\ndirection_per_uv = [0.5, 0.1]".parse().unwrap()
        };
        let sea = scene["sea"].as_table_mut().unwrap();
        sea.insert("wave".to_owned(), (0..4).map(|_| wave()).collect::<Vec<_>>().into());
    }
    if doc.table == "sea.cascade[]" {
        let sea = scene["sea"].as_table_mut().unwrap();
        for planned in ["cascades", "tile_size_m", "resolution", "shortest_wave_m"] {
            sea.remove(planned);
        }
        sea.insert("cascade".to_owned(), vec!["tile_size_m = 150.0".parse::<Table>().unwrap()].into());
    }
    if doc.table == "picture" {
        scene.insert("picture".to_owned(), Table::new().into());
    }
    if doc.table == "object[]" {
        let mut object = Table::new();
        if doc.key != "file" {
            object.insert("mesh".to_owned(), "duck".into());
        }
        scene.insert("object".to_owned(), vec![object].into());
    }
    if let Some((tag, word)) = doc.only_with {
        let table = table_of(doc, &mut scene);
        if table.get(tag).and_then(Value::as_str) != Some(word) {
            table.clear();
            table.insert(tag.to_owned(), word.into());
        }
        if doc.table == "sea.system[]" && tag == "spectrum" {
            say_how_high(doc.key, table_of(doc, &mut scene));
        }
        for other in reference().filter(|other| other.table == doc.table && other.only_with == doc.only_with)
        {
            if other.when_absent == WhenAbsent::Refused && !table_of(doc, &mut scene).contains_key(other.key)
            {
                let value = values(&other.accepts).remove(0);
                table_of(doc, &mut scene).insert(other.key.to_owned(), value);
            }
        }
    }
    scene
}

/// Gives a wave system the one key that says how high its waves are, where `key` itself does not.
fn say_how_high(key: &str, system: &mut Table) {
    let ways = ["wind_speed_mps", "significant_height_m", "sea_state", "beaufort"];
    for way in ways {
        system.remove(way);
    }
    match key {
        _ if ways.contains(&key) => {}
        "fetch_km" => {
            system.insert("wind_speed_mps".to_owned(), 6.0.into());
        }
        _ => {
            system.insert("significant_height_m".to_owned(), 1.0.into());
        }
    }
}

fn table_of<'a>(doc: &KeyDoc, scene: &'a mut Table) -> &'a mut Table {
    match doc.table.as_str() {
        "" => scene,
        "sea.system[]" => scene["sea"]["system"][0].as_table_mut().unwrap(),
        "sea.cascade[]" => scene["sea"]["cascade"][0].as_table_mut().unwrap(),
        "sea.wave[]" => scene["sea"]["wave"][0].as_table_mut().unwrap(),
        "object[]" => scene["object"][0].as_table_mut().unwrap(),
        name => scene[name].as_table_mut().unwrap(),
    }
}

fn read_with(doc: &KeyDoc, value: Value) -> Result<Scene, SceneError> {
    let mut scene = scene_with_table_of(doc);
    table_of(doc, &mut scene).insert(doc.key.to_owned(), value);
    Scene::from_toml(&scene.to_string(), "any")
}

/// Some accepted values, with those at the bounds.
fn values(accepts: &Accepts) -> Vec<Value> {
    let integer = |n: u64| Value::Integer(n as i64);
    let array = |triple: [f64; 3]| Value::from(triple.to_vec());
    match accepts {
        Accepts::Real { min, max, .. } => vec![(*min).into(), (*max).into()],
        Accepts::Integer { min, max } => vec![integer(*min), integer(*max)],
        Accepts::Integers(integers) => integers.iter().map(|n| integer(u64::from(*n))).collect(),
        Accepts::Words(words) => words.iter().map(|word| Value::from(*word)).collect(),
        Accepts::WordsOrTable { words, key, min, max } => {
            let number = |number: f64| Table::from_iter([((*key).to_owned(), number.into())]).into();
            words.iter().map(|word| Value::from(*word)).chain([number(*min), number(*max)]).collect()
        }
        Accepts::Colour { min, max, .. } => vec![array([*min; 3]), array([*max; 3])],
        Accepts::Pair { min, max, .. } => vec![vec![*min, *max].into(), vec![*max, *min].into()],
        Accepts::Flag => vec![false.into(), true.into()],
        Accepts::Point { min, max } => vec![array(*min), array(*max)],
        Accepts::File => vec!["sky.exr".into()],
        Accepts::Name => vec!["44097".into(), "a b".into()],
        Accepts::Time => vec!["2022-09-12T06:00:00Z".into(), "2024-02-29T23:59".into()],
        _ => vec![],
    }
}

/// The triple with this value in place of one.
fn with(mut triple: [f64; 3], i: usize, value: f64) -> Value {
    triple[i] = value;
    triple.to_vec().into()
}

/// Some values just outside, and some far.
fn outside(accepts: &Accepts) -> Vec<Value> {
    match accepts {
        Accepts::Real { min, max, .. } => {
            [min.next_down(), max.next_up(), f64::NAN, f64::INFINITY, -f64::INFINITY]
                .map(Value::from)
                .to_vec()
        }
        Accepts::Integer { min, max } => {
            vec![(-1).into(), (*min as i64 - 1).into(), (*max as i64).wrapping_add(1).into()]
        }
        Accepts::Integers(_) => vec![0.into(), 63.into(), i64::MAX.into()],
        Accepts::Words(_) => vec!["".into(), "Word".into()],
        Accepts::WordsOrTable { key, max, .. } => {
            let number = |key: &str| Table::from_iter([(key.to_owned(), max.next_up().into())]).into();
            vec!["".into(), "Word".into(), number(key), number("other")]
        }
        Accepts::Colour { min, max, .. } => {
            let odd = [max.next_up(), min.next_down(), f64::NAN, f64::INFINITY];
            odd.into_iter().enumerate().map(|(i, value)| with([*min; 3], i % 3, value)).collect()
        }
        Accepts::Pair { min, max, .. } => {
            vec![vec![*min, max.next_up()].into(), vec![*min].into(), vec![*min; 3].into()]
        }
        Accepts::Flag => vec![1.into(), "true".into()],
        Accepts::Point { min, max } => {
            let odd = |i: usize| [max[i].next_up(), min[i].next_down(), f64::NAN, f64::INFINITY, 1e9, -1e9];
            (0..3).flat_map(|i| odd(i).map(|value| with(*max, i, value))).collect()
        }
        Accepts::File => vec!["".into(), "a\0b".into()],
        Accepts::Name => vec!["".into()],
        Accepts::Time => vec!["".into(), "2023-02-29T00:00:00Z".into(), "2022-09-12".into()],
        _ => vec![],
    }
}

/// Whether the error is about the value of this very key.
fn is_about(error: &SceneError, doc: &KeyDoc) -> bool {
    let table = doc.table.replace("[]", "[0]");
    let key = if table.is_empty() { doc.key.to_owned() } else { format!("{table}.{}", doc.key) };
    error.key().is_some_and(|found| found.starts_with(&key)) && !error.problem().contains("for this sea")
}

#[test]
fn every_documented_value_is_accepted() {
    for doc in reference() {
        for value in values(&doc.accepts) {
            // Other checks may refuse the whole: waves that no longer fit their tile, another kind's keys.
            if let Err(error) = read_with(&doc, value) {
                let fits = ["samples a side", "less than", "not a sea that", "more tiles than"]
                    .iter()
                    .any(|words| error.problem().contains(words));
                assert!(fits || !is_about(&error, &doc), "{error}");
                assert!(!error.problem().starts_with("unknown key"), "{error}");
            }
        }
    }
}

#[test]
fn every_other_value_is_refused() {
    for doc in reference() {
        let wrong_type = if doc.accepts == Accepts::Flag { Value::from("yes") } else { true.into() };
        for value in outside(&doc.accepts).into_iter().chain([wrong_type, Table::new().into()]) {
            let error = read_with(&doc, value).unwrap_err();
            assert!(is_about(&error, &doc), "{error}");
        }
    }
}

#[test]
fn defaults_are_what_is_read_without_the_key() {
    for doc in reference() {
        let WhenAbsent::Default(default) = &doc.when_absent else { continue };
        // It needs a depth, and scenes have deep water.
        if doc.only_with == Some(("spectrum", "tma")) {
            continue;
        }
        let mut scene = scene_with_table_of(&doc);
        table_of(&doc, &mut scene).remove(doc.key);
        let without = Scene::from_toml(&scene.to_string(), "without").unwrap();
        let default: Table = format!("it = {default}").parse().unwrap();
        assert_eq!(read_with(&doc, default["it"].clone()).unwrap(), without, "{}.{}", doc.table, doc.key);
    }
}

#[test]
fn the_readers_accept_no_other_keys() {
    for doc in reference() {
        let mut scene = scene_with_table_of(&doc);
        let table = table_of(&doc, &mut scene);
        table.insert("zzz".to_owned(), 1.into());
        let measured = table.contains_key("measured");
        let kind = |other: &KeyDoc| match other.only_with {
            // `measured` stands in place of `spectrum`.
            None => !(measured && other.key == "spectrum"),
            Some((tag, word)) => table.get(tag).and_then(Value::as_str) == Some(word),
        };
        let mut documented: BTreeSet<_> = reference()
            .filter(|other| other.table == doc.table && kind(other))
            .map(|other| other.key.to_owned())
            .collect();
        if doc.table.is_empty() {
            let tables = reference().filter(|other| !other.table.is_empty() && !other.table.contains('.'));
            documented.extend(tables.map(|other| other.table.trim_end_matches("[]").to_owned()));
        }
        let error = Scene::from_toml(&scene.to_string(), "any").unwrap_err();
        let accepted = error.problem().split("accepted here: ").nth(1).unwrap().split(", ");
        assert_eq!(accepted.map(str::to_owned).collect::<BTreeSet<_>>(), documented, "{}", doc.table);
    }
}

#[test]
fn every_key_says_what_it_is() {
    for KeyDoc { table, key, doc, .. } in reference() {
        assert!(doc.ends_with('.') && doc.len() > 10, "{table}.{key}: {doc:?}");
    }
}

#[test]
fn the_markdown_has_a_row_for_every_key() {
    let text = markdown();
    assert_eq!(text.lines().filter(|line| line.starts_with("| `")).count(), reference().count());
    assert!(text.contains("\n## `[[sea.system]]` with `spectrum = \"phillips\"`\n"), "{text}");
    assert!(
        text.contains("| `wind_speed_mps` | a number: 0.1 to 50 m/s | said in another way | The mean wind"),
        "{text}"
    );
}

#[test]
fn words_are_unique() {
    fn check(words: Vec<&str>) {
        assert_eq!(words.iter().collect::<BTreeSet<_>>().len(), words.len(), "{words:?}");
    }
    check(technique::ALL.iter().map(|it| it.word).collect());
    check(sea::MODELS.iter().map(|it| it.word).collect());
    check(sea::system::SPECTRA.iter().map(|it| it.word).collect());
    check(sky::ALL.iter().map(|it| it.word).collect());
    check(named::ALL.iter().map(|it| it.name).collect());
    // A technique's table stands beside these.
    for technique in technique::ALL {
        assert!(
            !["technique", "seed", "sea", "sky", "camera", "picture", "object"].contains(&technique.word)
        );
    }
}

/// A random accepted value.
fn any_value(accepts: &Accepts) -> BoxedStrategy<Value> {
    let between = |min: f64, max: f64| (0.0..=1.0).prop_map(move |part| min + (max - min) * part);
    match accepts {
        Accepts::Real { min, max, .. } => between(*min, *max).prop_map(Value::from).boxed(),
        Accepts::Integer { min, max } => {
            (*min..=*max).prop_map(|integer| Value::Integer(integer as i64)).boxed()
        }
        Accepts::Colour { min, max, .. } => {
            prop::collection::vec(between(*min, *max), 3).prop_map(Value::from).boxed()
        }
        Accepts::Pair { min, max, .. } => {
            prop::collection::vec(between(*min, *max), 2).prop_map(Value::from).boxed()
        }
        Accepts::Point { min: [a, b, c], max: [x, y, z] } => {
            (between(*a, *x), between(*b, *y), between(*c, *z))
                .prop_map(|(x, y, z)| vec![x, y, z].into())
                .boxed()
        }
        accepts => match values(accepts) {
            values if values.is_empty() => Just(Value::Boolean(false)).boxed(),
            values => prop::sample::select(values).boxed(),
        },
    }
}

proptest! {
    #[test]
    fn what_is_read_is_written_and_read_again(
        (doc, value) in prop::sample::select(reference().collect::<Vec<_>>())
            .prop_flat_map(|doc| { let value = any_value(&doc.accepts); (Just(doc), value) })
    ) {
        if let Ok(scene) = read_with(&doc, value) {
            let text = scene.to_toml().unwrap();
            prop_assert_eq!(Scene::from_toml(&text, "again").unwrap(), scene);
        }
    }
}

#[test]
fn defaults_spelled_out_are_no_differences() {
    for technique in technique::ALL {
        let mut scene = scene_drawn_by(technique.word);
        let drawn = Scene::from_toml(&scene.to_string(), "any").unwrap();
        let model = drawn.sea.model.word();
        for doc in reference() {
            let in_use = doc.table == technique.word
                || (doc.table == "sea" && doc.only_with == Some(("model", model)));
            match &doc.when_absent {
                WhenAbsent::Default(default) if in_use => {
                    let value: Table = format!("value = {default}").parse().unwrap();
                    table_of(&doc, &mut scene).insert(doc.key.to_owned(), value["value"].clone());
                }
                WhenAbsent::Means(_) if in_use => {
                    table_of(&doc, &mut scene).remove(doc.key);
                }
                _ => {}
            }
        }
        let scene = Scene::from_toml(&scene.to_string(), "any").unwrap();
        assert_eq!(differences(&scene), [], "{}", technique.word);
    }
}

/// Every setting of every technique and of its sea, each by itself.
#[test]
fn a_setting_that_is_changed_is_the_one_difference() {
    let of_a_technique = |doc: &KeyDoc| technique::ALL.iter().any(|technique| technique.word == doc.table);
    let settings = reference()
        .filter(|doc| of_a_technique(doc) || (doc.table == "sea" && doc.only_with.is_some()))
        .filter(|doc| doc.when_absent != WhenAbsent::Refused);
    let mut seen = 0;
    for doc in settings {
        let before = differences(&Scene::from_toml(&scene_with_table_of(&doc).to_string(), "any").unwrap());
        let key = format!("{}.{}", doc.table, doc.key);
        for value in values(&doc.accepts) {
            let said = value.to_string();
            let is_default = doc.when_absent == WhenAbsent::Default(said.clone());
            // Some values at the bounds contradict other settings; another of the key's values does not.
            let Ok(scene) = read_with(&doc, value) else { continue };
            let found = differences(&scene);
            let of_key: Vec<_> = found.iter().filter(|difference| difference.key == key).collect();
            if is_default {
                assert!(of_key.is_empty(), "{key} = {said}: {of_key:?}");
            } else {
                let [difference] = of_key.as_slice() else { panic!("{key} = {said}: {of_key:?}") };
                assert_eq!(difference.value, said, "{key}");
                assert!(!difference.default.is_empty());
                seen += 1;
            }
            let others = |all: &[whitecap_scene::reference::Difference]| {
                all.iter().filter(|d| d.key != key).cloned().collect::<Vec<_>>()
            };
            assert_eq!(others(&found), others(&before), "{key} = {said} changed other settings");
        }
    }
    assert!(seen > 20, "{seen} differences");
}

#[test]
fn keys_of_other_tables_and_required_ones_are_no_differences() {
    let mut scene = whitecap_scene::open("meshuggah").unwrap();
    let before = differences(&scene);
    assert!(
        before.iter().any(|d| d.key == "meshuggah.visibility_km" && d.value == "12.0" && d.default == "25.0")
    );
    assert!(
        before.iter().all(|d| d.key.starts_with("meshuggah.") || d.key.starts_with("sea.")),
        "{before:?}"
    );
    scene.seed += 1;
    scene.camera.vertical_fov_deg = 30.0;
    assert_eq!(differences(&scene), before);
}

#[test]
fn every_technique_says_what_it_follows() {
    for technique in technique::ALL {
        let scene = Scene::from_toml(&scene_drawn_by(technique.word).to_string(), "any").unwrap();
        assert!(scene.technique.source().len() > 20, "{}", technique.word);
        assert!(scene.technique.differs().iter().all(|note| note.ends_with('.')), "{}", technique.word);
        for model in scene.technique.sea_models() {
            assert!(technique::that_draw(model).any(|word| word == technique.word), "{model}");
        }
    }
    assert_eq!(technique::that_draw("spectral").collect::<Vec<_>>(), ["meshuggah", "spectral-ocean"]);
    assert_eq!(technique::that_draw("tea").count(), 0);
}
