//! What a probe's column holds, by the ending of its name.

/// Column of a probe in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading<'a> {
    /// Name of the probe.
    pub probe: &'a str,
    /// Component: "x", "y", or nothing.
    pub component: &'static str,
    /// Quantity in words.
    pub quantity: &'static str,
    /// Unit of the quantity.
    pub unit: &'static str,
}

impl Reading<'_> {
    /// Reading of a probe's column.
    pub fn of(column: &str) -> Reading<'_> {
        let (probe, ending) = column.rsplit_once('.').unwrap_or((column, ""));
        let (component, quantity, unit) = match ending {
            "x" => ("x", "position", "m"),
            "y" => ("y", "position", "m"),
            "vx" => ("x", "velocity", "m/s"),
            "vy" => ("y", "velocity", "m/s"),
            "ax" => ("x", "acceleration", "m/s²"),
            "ay" => ("y", "acceleration", "m/s²"),
            "rx" => ("x", "reaction", "N"),
            "ry" => ("y", "reaction", "N"),
            _ => ("", "deflection", "m"),
        };
        Reading { probe, component, quantity, unit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_the_columns() {
        let columns = ["tip.x", "tip.y", "tip.vx", "tip.vy", "tip.ax", "tip.ay", "tip.rx", "tip.ry", "rod.w"];
        let units = columns.map(|column| Reading::of(column).unit);
        assert_eq!(units, ["m", "m", "m/s", "m/s", "m/s²", "m/s²", "N", "N", "m"]);
        assert_eq!(Reading::of("left.tip.vx").probe, "left.tip");
    }
}
