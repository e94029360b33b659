//! Files that are wrong: the message names the line, what was found and what is accepted.

use std::path::Path;

use whitecap_scene::measured::{from_bytes, from_bytes_with_directions, load};

use super::*;

/// The message about a good file with one thing changed.
#[track_caller]
fn refuses(text: &str, found: &str, instead: &str, message: &str) {
    assert!(text.contains(found), "{found} is not in the file");
    let said = problem(&text.replacen(found, instead, 1));
    assert!(said.starts_with(message), "{said}");
}

#[test]
fn no_such_format() {
    for text in
        ["", "\n\n", "hello\n", "# a comment\n", "technique = \"meshuggah\"\n", "YYYY MM DD hh WVHT DPD\n"]
    {
        assert!(
            problem(text).starts_with("file: no known format, by its first line; accepted: NDBC"),
            "{text}"
        );
    }
    let error = from_bytes(b"YYYY MM DD hh .1 .2\n2000 01 01 00 \xff\n", "file").unwrap_err().to_string();
    assert!(error.starts_with("file:2: not UTF-8 text"), "{error}");
    assert!(from_bytes(&[0xff; 100], "file").is_err());
}

#[test]
fn no_such_file() {
    let folder = tempfile::tempdir().unwrap();
    let said = |path: &Path| load(path).unwrap_err().to_string();
    assert!(said(folder.path()).ends_with("this is a folder; accepted: a file of wave spectra"));
    assert!(said(&folder.path().join("no.spec")).contains("no.spec: cannot be read: "));
    // A hole of a file, so that nothing is written.
    let long = folder.path().join("long.spec");
    std::fs::File::create(&long).unwrap().set_len((64 << 20) + 1).unwrap();
    assert!(said(&long).ends_with("67108865 bytes long; accepted: up to 67108864"));
    #[cfg(unix)]
    assert!(said(Path::new("/dev/zero")).ends_with("no ordinary file; accepted: a file of wave spectra"));
}

#[test]
fn ndbc_real_time() {
    let refuses = |found, instead, message| refuses(DATA_SPEC, found, instead, message);
    refuses("0.110", "0.100", "file:2: found \"0.1\"; accepted: frequencies from 0.005 to 50 Hz, ascending");
    refuses("0.110", "0.095", "file:2: found \"0.095\"; accepted: frequencies");
    refuses("0.110", "nan", "file:2: found \"nan\"; accepted: a frequency in brackets");
    refuses("(0.110)", "0.110", "file:2: found \"0.110\"; accepted: a frequency in brackets");
    refuses(
        "4.000",
        "-4.000",
        "file:2: found \"-4\"; accepted: a density from 0 to 1000000 m²/Hz, or MM or 999",
    );
    refuses("4.000", "NaN", "file:2: found \"NaN\"; accepted: a density");
    refuses("4.000", "1e7", "file:2: found \"10000000\"; accepted: a density");
    refuses("06 08 03", "13 08 03", "file:2: found \"[2020, 13, 8, 3, 50, 0]\"; accepted: a time");
    refuses("06 08 03", "06 x 03", "file:2: found \"x\"; accepted: a time");
    refuses("(0.110) 2.000 (0.120)\n", "", "file:2: found");
    let header = DATA_SPEC.lines().next().unwrap();
    assert_eq!(problem(header), "file:1: no record; accepted: at least one spectrum");
    let one = format!("{header}\n2020 06 08 03 50 0.2 1.0 (0.1)\n");
    assert_eq!(problem(&one), "file:2: 1 frequencies; accepted: 2 to 1000");
}

/// Cut short anywhere, a record never passes for a lower sea while another of the file is whole.
#[test]
fn ndbc_real_time_cut_short() {
    refuses(
        DATA_SPEC,
        "4.000 (0.110) 2.000 (0.120)\n",
        "4.000 (0.110)\n",
        "file:2: 2 frequencies, the first of another record's 3; accepted: the record as a whole",
    );
    // The oldest ends the file.
    let ended = DATA_SPEC.trim_end().strip_suffix(" 0.000 (0.120)").unwrap();
    assert!(problem(ended).starts_with("file:5: 2 frequencies, the first"), "{}", problem(ended));
    let line = DATA_SPEC.lines().nth(1).unwrap();
    for end in 1..line.len() {
        let cut = DATA_SPEC.replacen(line, &line[..end], 1);
        let message = problem(&cut);
        assert!(message.starts_with("file:2: "), "{}: {message}", &line[..end]);
    }
    // A file of directions: a whole hour, and the first half of another.
    let mut directions = DIRECTIONS.map(str::to_owned);
    directions[2].push_str("2020 06 08 02 50 0.80 (0.100) 0.80 (0.110)\n");
    let files = directions.each_ref().map(|file| file.as_bytes());
    let said = from_bytes_with_directions(DATA_SPEC.as_bytes(), files, "x").unwrap_err().to_string();
    assert!(said.starts_with("x (.swr1):3: 2 frequencies, the first of another record's 3"), "{said}");
    // Another instrument, with bands of its own.
    let other = format!("{DATA_SPEC}2020 06 07 23 50 0.2 1.0 (0.095) 1.0 (0.115)\n");
    assert_eq!(read(&other).len(), 5);
}

#[test]
fn ndbc_history() {
    let refuses = |found, instead, message| refuses(HISTORY, found, instead, message);
    refuses(".100", ".090", "file:1: found \"0.09\"; accepted: frequencies");
    refuses(".100", "x", "file:1: found \"x\"; accepted: a header");
    refuses("3.00", "-3.00", "file:2: found \"-3\"; accepted: a density");
    refuses("3.00", "", "file:2: found \"2 values\"; accepted: as many values as the header has frequencies");
    refuses("1.50", "1.50 1.50", "file:2: found \"4 values\"");
    refuses("2000 01 01 00", "2000 02 30 00", "file:2: found \"[2000, 2, 30");
    let many: String = (1..=1001).map(|i| format!(" .{i:04}")).collect();
    assert_eq!(problem(&format!("YYYY MM DD hh{many}\n")), "file:1: 1001 frequencies; accepted: 2 to 1000");
    assert_eq!(problem("YYYY MM DD hh .1 .2\n"), "file:1: no record; accepted: at least one spectrum");
}

#[test]
fn ww3() {
    let refuses = |found, instead, message| refuses(WW3, found, instead, message);
    refuses("3     4     2", "3     4", "file:1: found \"'points\"; accepted: a count of points");
    refuses("3     4     2", "3     4     0", "file:1: no record");
    refuses(
        "3     4     2",
        "30000000000     4     2",
        "file:1: 30000000000 frequencies; accepted: 2 to 1000",
    );
    refuses("3     4     2", "3     2     2", "file:1: 2 directions; accepted: 3 to 1000");
    refuses("3     4     2", "3     5     2", "file:5: found \"20220912\"; accepted: directions in radians");
    refuses("3     4     2", "2     4     2", "file:4: found");
    refuses("3     4     2", "3     4     3", "file:12: found \"20220912 070000\"; accepted: a point");
    refuses("0.150E+00", "0.250E+00", "file:3: found \"0.2\"; accepted: frequencies");
    refuses("0.000E+00", "0.785E+00", "file:4: found \"a direction twice\"; accepted: different directions");
    refuses("0.000E+00", "*********", "file:4: found \"*********\"; accepted: directions in radians");
    for outside in ["0.900E+02", "-.785E+00", "0.630E+01"] {
        refuses("0.471E+01", outside, "file:4: found \"");
    }
    let degrees = "file:4: found \"45\"; accepted: directions in radians, from 0 to 2π";
    refuses("0.785E+00  0.000E+00  0.471E+01  0.314E+01", "45.0  0.0  270.0  180.0", degrees);
    refuses("20220912 060000", "20220932 060000", "file:5: found \"20220932 060000\"; accepted: a time");
    refuses("'first     '", "'first      ", "file:6: found");
    refuses("0.300E+01", "-.300E+01", "file:10: found \"-3\"; accepted: a density from 0");
    refuses("0.300E+01", "-.100E-02", "file:10: found \"-0.001\"; accepted: a density from 0");
    refuses("0.300E+01", "NaN", "file:10: found \"NaN\"; accepted: densities");
    let half = &WW3[..WW3.rfind("'buoy").unwrap()];
    assert!(problem(half).contains("the file ends; wanted: a point"));
}

#[test]
fn swan() {
    let refuses = |found, instead, message| refuses(SWAN, found, instead, message);
    refuses("SWAN   1", "SWAN   2", "file:1: found");
    refuses(
        "     1                                  time",
        "     2                                  time",
        "file:4: found",
    );
    refuses("2                                  number of loc", "x", "file:6: found \"x");
    refuses("2                                  number of loc", "90000000000 ", "file:9: found");
    refuses(
        "3                                  number of f",
        "2 ",
        "file:13: found \"0.1250\"; accepted: TIME, LONLAT",
    );
    refuses(
        "3                                  number of f",
        "4 ",
        "file:14: found \"NDIR\"; accepted: frequencies",
    );
    refuses("    0.1250", "    0.0125", "file:13: found \"0.0125\"; accepted: frequencies");
    refuses("    90.0", "   360.0", "file:19: found \"a direction twice\"");
    refuses("VaDens", "AcDens", "file:22: found \"AcDens\"; accepted: VaDens or EnDens");
    refuses("20161011.0", "20161011 0", "file:25: found");
    refuses("1.0E-03", "-1.0E-03", "file:29: found \"-");
    refuses("1.0E-03", "1.0E+300", "file:29: found \"");
    refuses("0  -99   20", "0  -98   20", "file:29: found \"-5");
    refuses("0  -99   20    0", "0  -99   20", "file:31: found \"NODATA\"; accepted: densities, as integers");
    refuses("NODATA", "NOTHING", "file:31: found \"NOTHING\"; accepted: FACTOR, ZERO or NODATA");
    refuses("LONLAT", "LATLON", "file:5: found");
    refuses("QUANT", "NDIR", "file:21: 1 directions; accepted: 3 to 1000");
    let half = &SWAN[..SWAN.rfind("FACTOR").unwrap()];
    assert!(problem(half).contains("the file ends; wanted: FACTOR, ZERO or NODATA"));
    assert!(problem(&SWAN[..SWAN.find("QUANT").unwrap()]).contains("the file ends; wanted: QUANT"));
}

/// What is quoted is short and stays on the line.
#[test]
fn messages_are_one_short_line() {
    let said = problem(&HISTORY.replacen("3.00", &"é\u{1}".repeat(5000), 1));
    assert!(said.len() < 400 && !said.contains('\n') && !said.contains('\u{1}'), "{said}");
}

/// The same place and time once more: with other values it is refused, and with the same it counts once.
#[test]
fn a_record_twice() {
    let twice = |text: &str, record: &str, other: [&str; 2]| {
        assert_eq!(read(&format!("{text}{record}")).len(), read(text).len(), "{text}");
        problem(&format!("{text}{}", record.replacen(other[0], other[1], 1)))
    };
    const INSTEAD: &str = "has with other values; accepted: each time and place once, or the same again";
    assert_eq!(
        twice(DATA_SPEC, DATA_SPEC.lines().nth(1).unwrap(), ["4.000", "4.001"]),
        format!("file:6: the record of 2020-06-08T03:50:00Z at place \"file\", which line 2 {INSTEAD}")
    );
    // A value that is missing once, or a frequency.
    for other in [["4.000", "MM"], [" 2.000 (0.120)", " 2.000 (0.125)"]] {
        let said = twice(DATA_SPEC, DATA_SPEC.lines().nth(1).unwrap(), other);
        assert!(said.starts_with("file:6: the record of 2020-06-08T03:50:00Z"), "{said}");
    }
    assert_eq!(
        twice(HISTORY, HISTORY.lines().nth(1).unwrap(), ["3.00", "3.01"]),
        format!("file:4: the record of 2000-01-01T00:00:00Z at place \"file\", which line 2 {INSTEAD}")
    );
    let start = |text: &str, key: &str| text.find(key).unwrap();
    let (first, second) = (start(WW3, "20220912 060000"), start(WW3, "20220912 070000"));
    assert_eq!(
        twice(WW3, &WW3[first..second], ["0.300E+01", "0.301E+01"]),
        format!("file:23: the record of 2022-09-12T06:00:00Z at place \"buoy 2\", which line 9 {INSTEAD}")
    );
    let (first, second) = (start(SWAN, "20161011"), start(SWAN, "20161012"));
    let said = twice(SWAN, &SWAN[first..second], ["0  -99   20", "0  -99   21"]);
    let place = "\"1\" at (174.672501, -38.173599)";
    assert_eq!(
        said,
        format!("file:40: the record of 2016-10-11T00:00:00Z at place {place}, which line 26 {INSTEAD}")
    );
    let said = twice(SWAN, &SWAN[first..second], ["NODATA", "ZERO"]);
    assert!(said.starts_with("file:45: ") && said.contains("\"2\" at (175, -39), which line 31"), "{said}");
}

/// A place that a file lists twice, by name and coordinates, has one sea.
#[test]
fn a_place_twice() {
    let again = WW3.replace("'buoy 2    '  41.00 -71.00", "'first     '  40.98-171.12");
    let said = problem(&again);
    assert!(said.starts_with("file:9: the record of 2022-09-12T06:00:00Z at place \"first\""), "{said}");
    let both = SWAN.replace("175.0 -39.0", "174.672501 -38.173599");
    let said = problem(&both);
    assert!(said.starts_with("file:31: ") && said.contains("which line 26"), "{said}");
    // Both numbers stay where they agree.
    let same = both.replace("NODATA", "FACTOR\n1.0E-03\n0 0 0 0\n0 -99 20 0\n0 0 0 0");
    let same = same.replacen("ZERO\n", "", 1);
    let same = format!("{same}FACTOR\n0.5E-03\n0 0 0 0\n0 0 20 0\n0 0 0 0\n");
    assert_eq!(read(&same).iter().map(|sea| sea.place.number).collect::<Vec<_>>(), [1, 2, 1, 2]);
}

/// Each of the four files of directions likewise.
#[test]
fn directions_twice() {
    for (index, extension) in ["swdir", "swdir2", "swr1", "swr2"].into_iter().enumerate() {
        let mut files = DIRECTIONS.map(str::to_owned);
        let line = DIRECTIONS[index].lines().nth(1).unwrap();
        let read = |files: &[String; 4]| {
            from_bytes_with_directions(
                DATA_SPEC.as_bytes(),
                files.each_ref().map(|file| file.as_bytes()),
                "x",
            )
        };
        files[index].push_str(line);
        assert_eq!(read(&files).unwrap(), read(&DIRECTIONS.map(str::to_owned)).unwrap());
        let last = line.strip_suffix(" (0.120)").unwrap().rsplit_once(' ').unwrap().1;
        let other = line.replace(&format!("{last} (0.120)"), "0.25 (0.120)");
        files[index] = format!("{}{other}", DIRECTIONS[index]);
        let said = read(&files).unwrap_err().to_string();
        let expected =
            format!("x (.{extension}):3: the directions of 2020-06-08T03:50:00Z, which line 2 has");
        assert!(said.starts_with(&expected), "{said}");
        files[index] = DIRECTIONS[index].replacen("(0.120)", "(0.110)", 1);
        let said = read(&files).unwrap_err().to_string();
        assert!(said.starts_with(&format!("x (.{extension}):2: found \"0.11\"; accepted: freq")), "{said}");
    }
}

/// All directions alike have a spread of √2 rad.
#[test]
fn swan_spreads() {
    let of = |spread: &str| {
        format!(
            "SWAN 1\nLOCATIONS\n1\n0 0\nAFREQ\n2\n.1\n.2\nQUANT\n3\nVaDens\nm2/Hz\n-99\nCDIR\ndegr\n-999\nDSPRDEGR\ndegr\n-9\n\
             LOCATION 1\n1.0 90.0 {spread}\n1.0 90.0 20.0\n"
        )
    };
    for spread in ["0.0", "81.0", "-9"] {
        assert_eq!(read(&of(spread)).len(), 1);
    }
    for spread in ["-1.0", "82.0", "720.0"] {
        let said = problem(&of(spread));
        assert!(
            said.starts_with("file:21: found \"") && said.ends_with("a spread from 0 to 81.1°"),
            "{said}"
        );
    }
}
