//! Text of an element's state: it is refused with a reason, or every number of every equation is finite.

#![no_main]

use ancf_conform::{State, equations_text};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let Ok(state) = State::parse(text, "fuzz") else { return };
    let Ok(listing) = equations_text(&state, "fuzz") else { return };
    let is_number = |word: &&str| word.parse::<f64>().is_ok();
    assert!(listing.split_whitespace().filter(is_number).all(|word| word.parse::<f64>().unwrap().is_finite()));
});
