//! The known name that a misspelt one is most like.

/// How much of a name is compared when the nearest known one is looked for, in characters.
const COMPARED: usize = 64;

/// Likeness under which a known name is no suggestion: with more than half of the letters others, it is another name and not a misspelt
/// one.
const ALIKE: f64 = 0.5;

/// The known name that is most like `name`, whatever the case of its letters; `None` where none is like it.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let prepare = |name: &str| name.chars().take(COMPARED).collect::<String>().to_lowercase();
    let name = prepare(name);
    let likeness = |other: &str| strsim::normalized_damerau_levenshtein(&name, &prepare(other));
    let known = known.into_iter().map(|other| (likeness(other), other)).filter(|(likeness, _)| *likeness >= ALIKE);
    known.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, other)| other)
}

/// The nearest name in words that follow what is allowed; empty where none is like it.
pub fn or_nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or(String::new(), |nearest| format!("; nearest: `{nearest}`"))
}
