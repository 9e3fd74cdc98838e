//! Three kinds of rod against `fixtures/references.json`: solutions that owe nothing to them.
//!
//! Source: each entry of the fixture names its own. Goal: where an element is exact it is so to rounding; where it
//! converges, error and order are those measured once, within a band; where its limit is another one than an engineer
//! expects, the difference is known. Bars are derived beside each test; measured numbers are printed (`--nocapture`).

#![allow(non_snake_case)] // The symbols of mechanics are names here.

#[path = "../common/mod.rs"]
mod common;

mod circle;
mod heat;
mod imperfection;
mod large_bending;
mod modes;
mod small_loads;
mod vibration;
