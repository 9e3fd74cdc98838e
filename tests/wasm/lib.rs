//! Built-in scenes, run in WebAssembly without a browser: `compare.mjs` calls [`run`] and reads the text at [`text`].

use std::cell::RefCell;

use ancf::model::{Method, Scene};

/// Scenes of both elements, with and without heat, pins and statics; shortened where they are long. The method, and the end in s.
const SCENES: [(&str, Method, f64); 5] = [
    ("pendulum-flexible", Method::GeneralizedAlpha, 0.1),
    ("pendulum-2d", Method::GaussAdaptive, 0.01),
    ("scissors-3-thermal", Method::EnergyMomentum, 0.05),
    ("free-rod-heated", Method::GeneralizedAlpha, 0.01),
    ("cantilever", Method::Static, 1.0),
];

thread_local! { static TEXT: RefCell<String> = const { RefCell::new(String::new()) }; }

/// Runs scene number `n`, and gives the length of the text: its JSON in the first line, its rows as CSV in the others, or `error: ` and
/// the reason. 0 where there is no such scene.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn run(n: usize) -> usize {
    let text = SCENES.get(n).map_or(String::new(), |(name, method, end)| match rows(name, *method, *end) {
        Ok(text) => text,
        Err(reason) => format!("error: {name}: {reason}"),
    });
    let length = text.len();
    TEXT.set(text);
    length
}

/// Where the text begins.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

fn rows(name: &str, method: Method, end: f64) -> Result<String, Box<dyn std::error::Error>> {
    let mut scene = Scene::builtin(name).ok_or("there is no such scene")?;
    (scene.time.method, scene.time.end) = (method, end);
    let mut csv = Vec::new();
    ancf::run::run(&scene)?.trajectory.write_csv(&mut csv)?;
    let json: String = scene.to_text().split_whitespace().collect::<Vec<_>>().join(" ");
    Ok(format!("{json}\n{}", String::from_utf8(csv)?))
}
