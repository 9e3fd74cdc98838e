//! Check of histories: values over strictly increasing times.

use std::fmt::Display;

use crate::model::check::{Check, finite, require};

/// Refuses a history of pairs [t, value] whose times do not increase.
pub(in crate::model) fn check_history(key: impl Display, history: &[[f64; 2]]) -> Check {
    for (i, &[time, value]) in history.iter().enumerate() {
        finite(format_args!("{key}[{i}][0]"), time)?;
        finite(format_args!("{key}[{i}][1]"), value)?;
    }
    for (i, pair) in history.windows(2).enumerate() {
        if let [[before, _], [time, _]] = pair {
            let allowed = format_args!("a time after the {before:?} s before it");
            require(time > before, format_args!("{key}[{}][0]", i + 1), format_args!("{time:?}"), allowed)?;
        }
    }
    Ok(())
}
