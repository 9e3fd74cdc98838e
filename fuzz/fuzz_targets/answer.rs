//! Lines of a program under test: each is an answer, a message or a fault, and an answer's value has its shape or is a fault.

#![no_main]

use ancf_conform::{Answer, AnswerLine, read_answer, read_numbers};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|lines: &str| {
    for line in lines.lines() {
        let Ok(AnswerLine::Answer { answer: Answer::Value(value), .. }) = read_answer(line) else { continue };
        for shape in [&[][..], &[2], &[2, 14], &[14, 14], &[3, 2, 14]] {
            if let Ok(numbers) = read_numbers(&value, shape) {
                assert_eq!(numbers.len(), shape.iter().product::<usize>());
                assert!(numbers.iter().all(|number| number.is_finite()));
            }
        }
    }
});
