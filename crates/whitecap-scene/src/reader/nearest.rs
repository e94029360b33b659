//! "Did you mean …?"

/// The least likeness (Jaro–Winkler, 0 to 1) at which a word is worth suggesting.
const LIKENESS: f64 = 0.8;

/// `did you mean "meshuggah"? `, with the space after it, or nothing if no accepted word comes near.
pub(crate) fn did_you_mean(found: &str, accepted: &[&str]) -> String {
    // Comparing costs the product of the lengths; nobody mistypes a word into a thousand characters.
    if found.len() > 100 {
        return String::new();
    }
    let found = found.to_lowercase();
    // A name may be given with more in front than the file wants: "five-sample-01-blinn-phong".
    let tails = || found.match_indices('-').map(|(at, _)| &found[at + 1..]).filter(|tail| tail.len() > 3);
    let like = |word: &&&str| {
        let whole = strsim::jaro_winkler(&found, word);
        tails().map(|tail| strsim::jaro_winkler(tail, word)).fold(whole, f64::max)
    };
    accepted
        .iter()
        .filter(|word| like(word) >= LIKENESS)
        .max_by(|a, b| like(a).total_cmp(&like(b)))
        .map(|word| format!("did you mean \"{word}\"? "))
        .unwrap_or_default()
}

/// `"one", "two" or "three"`.
pub(crate) fn quoted_choice(words: &[&str]) -> String {
    match words {
        [several @ .., last] if !several.is_empty() => format!("{} or \"{last}\"", quoted_list(several)),
        words => quoted_list(words),
    }
}

/// `"one", "two"`.
pub(crate) fn quoted_list(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}
