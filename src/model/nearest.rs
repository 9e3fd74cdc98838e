//! Suggestions for misspelt names.

/// Number of characters compared.
const MOST_COMPARED: usize = 64;

/// Least similarity of a suggestion. Below it more than half of the letters differ: another name, not a misspelling.
const LEAST_SIMILARITY: f64 = 0.5;

/// Known name most similar to `name`, ignoring case; `None` where none is similar.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let prepare = |name: &str| name.chars().take(MOST_COMPARED).collect::<String>().to_lowercase();
    let name = prepare(name);
    let similarity = |other: &str| strsim::normalized_damerau_levenshtein(&name, &prepare(other));
    let known = known
        .into_iter()
        .map(|other| (similarity(other), other))
        .filter(|(similarity, _)| *similarity >= LEAST_SIMILARITY);
    known.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, other)| other)
}

/// Suggestion to append to a message; empty where no known name is similar.
pub fn or_nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or(String::new(), |nearest| format!("; nearest: `{nearest}`"))
}
