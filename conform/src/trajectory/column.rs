//! What a column or key of a motion holds, by its name.

/// What a column holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    /// Times.
    Time,
    /// A component of a point's position.
    Position(String, usize),
    /// A component of a point's velocity.
    Velocity(String, usize),
    /// An energy.
    Energy(&'static str),
}

/// Name without case, quotes and unit.
fn plain(name: &str) -> String {
    let name = name.trim().trim_matches(['"', '\'']).to_lowercase();
    let end = name.find(['[', '(']).unwrap_or(name.len());
    name.get(..end).unwrap_or(&name).trim().to_string()
}

/// Meaning of a column's name; `None` if it has none here.
pub fn column(name: &str, points: &[&str]) -> Option<Column> {
    let name = plain(name);
    match name.as_str() {
        "t" | "time" | "t_s" | "time_s" | "zeit" => return Some(Column::Time),
        _ => {}
    }
    let parts: Vec<&str> = name.split(['.', '_', ' ', '-', ':', '/']).filter(|part| !part.is_empty()).collect();
    for (energy, words) in [
        ("kinetic", ["kinetic", "kin", "ekin", "t"]),
        ("strain", ["strain", "elastic", "estrain", "u"]),
        ("potential", ["potential", "pot", "epot", "v"]),
        ("input", ["input", "work", "einput", "w"]),
    ] {
        let is_energy = parts.iter().any(|part| words[..3].contains(part));
        let short = matches!(parts[..], [word] | ["energy" | "e", word] if word == words[3] && word != "t" && word != "u" && word != "v");
        if is_energy || short {
            return Some(Column::Energy(energy));
        }
    }
    let component = |word: &str| match word {
        "x" => Some((false, 0)),
        "y" => Some((false, 1)),
        "vx" | "xdot" | "dx" => Some((true, 0)),
        "vy" | "ydot" | "dy" => Some((true, 1)),
        _ => None,
    };
    let mut found = None;
    let mut velocity = false;
    let mut rest = Vec::new();
    for part in &parts {
        match component(part) {
            Some(c) if found.is_none() => found = Some(c),
            _ if matches!(*part, "v" | "vel" | "velocity" | "speed" | "dot") => velocity = true,
            _ if matches!(*part, "pos" | "position" | "r") => {}
            _ => rest.push(*part),
        }
    }
    let named = rest.join("_");
    let lower = |point: &&&str| point.to_lowercase();
    let point = match rest.is_empty() {
        // Columns without a name are those of the only point.
        true if points.len() == 1 => points.first()?.to_string(),
        true => return None,
        false => points
            .iter()
            .find(|point| lower(point) == named)
            .or_else(|| {
                // A point and its component may be written as one word, such as tipx.
                points.iter().find(|point| {
                    parts.len() == 1 && component(named.strip_prefix(&lower(point)).unwrap_or("")).is_some()
                })
            })?
            .to_string(),
    };
    let (of_velocity, n) = match found {
        Some(found) => found,
        None => component(named.strip_prefix(&point.to_lowercase())?)?,
    };
    Some(if of_velocity || velocity { Column::Velocity(point, n) } else { Column::Position(point, n) })
}

/// Decimal places of a number as text.
pub fn decimals(text: &str) -> i32 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, places)| places.len() as i32);
    places - exponent.parse::<i32>().unwrap_or(0)
}
