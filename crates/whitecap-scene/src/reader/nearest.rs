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
    let like = |word: &&&str| strsim::jaro_winkler(&found, word);
    accepted
        .iter()
        .filter(|word| like(word) >= LIKENESS)
        .max_by(|a, b| like(a).total_cmp(&like(b)))
        .map(|word| format!("did you mean \"{word}\"? "))
        .unwrap_or_default()
}

/// `"one", "two"`.
pub(crate) fn quoted_list(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ")
}
