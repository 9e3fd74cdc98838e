//! Bad input: exit code 2, a message with file, key, value and what is allowed, and no output.
//!
//! Each case changes one place of a scene that runs, and goes through the binary.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::LazyLock;

use jsonschema::Validator;

/// A scene that runs; every case makes one change to it.
const GOOD: &str = r#"{
  "schema": "ancf-scene/1",
  "title": "one heated rod",
  "material": {"E": 2e8, "nu": 0.3, "rho": 7750.0, "alpha": 2.5e-5},
  "section": {"height": 0.02, "width": 0.03},
  "points": {"o": [0.0, 0.0], "apex": [0.5, 0.0]},
  "rods": [{"name": "rod", "from": "o", "to": "apex", "elements": 2}],
  "supports": [{"point": "o", "fix": ["x"]}],
  "gravity": [0.0, -9.8],
  "temperature": {"model": "2d", "start": "relaxed", "history": [[0.0, 20.0], [1.0, 25.0]]},
  "time": {"end": 0.002, "step": 1e-3, "method": "generalized-alpha", "rho_inf": 0.8, "newton_tolerance": 1e-9},
  "output": {"interval": 0.002, "energy": true},
  "probes": [{"name": "tip", "point": "apex", "of": ["position"]}]
}
"#;

/// Two rods like an X with everything that structures have; a base for changes like [`GOOD`].
const CROSS: &str = r#"{
  "schema": "ancf-scene/1",
  "notes": ["two rods", "one pin"],
  "material": {"E": 2e8, "nu": 0.3, "rho": 7750.0, "alpha": 2.5e-5},
  "section": {"height": 0.02, "width": 0.03},
  "points": {"p": [0.0, 0.0], "q": [2.0, 2.0], "r": [0.0, 2.0], "s": [2.0, 0.0]},
  "rods": [{"name": "up", "from": "p", "to": "q", "pivot": "m"},
    {"name": "down", "from": "r", "to": "s", "pivot": "m",
     "material": {"E": 3e8, "nu": 0.1, "rho": 2700.0, "alpha": -5e-5}, "section": {"height": 0.01, "width": 0.04},
     "temperature": {"model": "1d", "start": "sudden", "history": [[0.0, 20.0], [1.5, -30.0]]}}],
  "supports": [{"point": "p", "fix": ["x", "y"], "clamp": "up"}, {"point": "s", "slide": [3.0, 4.0]}],
  "forces": [{"point": "m", "force": [1.5, -2.5], "history": [[0.0, 0.0], [0.1, 1.0]]}],
  "temperature": {"history": [[0.0, 40.0]]},
  "constraints": "multipliers",
  "time": {"end": 0.002, "step": 1e-3, "method": "generalized-alpha"},
  "probes": [{"name": "pin", "point": "m", "rod": "up", "of": ["reaction"]},
    {"name": "foot", "point": "p", "of": ["reaction"]},
    {"name": "bend", "rod": "down", "at": 0.25, "of": ["deflection"]}]
}
"#;

/// A cantilever in equilibrium; a base for changes like [`GOOD`].
const STILL: &str = r#"{
  "schema": "ancf-scene/1",
  "material": {"E": 2e8, "nu": 0.3, "rho": 7750.0, "alpha": 2.5e-5},
  "section": {"height": 0.02, "width": 0.03},
  "points": {"o": [0.0, 0.0], "a": [1.0, 0.0]},
  "rods": [{"name": "rod", "from": "o", "to": "a"}],
  "supports": [{"point": "o", "fix": ["x", "y"], "clamp": "rod"}],
  "forces": [{"point": "a", "force": [0.0, -0.5]}],
  "temperature": {"history": [[0.0, 20.0]]},
  "time": {"method": "static"},
  "probes": [{"name": "tip", "point": "a", "of": ["position"]}]
}
"#;

/// A rod that is over after two rows, between which steps of 0.7 ms do not fit; a base for changes like [`GOOD`].
const ADAPTIVE: &str = r#"{
  "schema": "ancf-scene/1",
  "material": {"E": 2e8, "nu": 0.3, "rho": 7750.0},
  "section": {"height": 0.02, "width": 0.03},
  "points": {"o": [0.0, 0.0], "a": [1.0, 0.0]},
  "rods": [{"name": "rod", "from": "o", "to": "a", "elements": 1}],
  "time": {"end": 0.002, "step": 0.0007, "method": "gauss-adaptive", "tolerance": 1e-6},
  "gravity": [0.0, -9.8], "output": {"energy": false, "interval": 0.001},
  "probes": [{"name": "tip", "point": "a", "of": ["position"]}]
}
"#;

/// Runs `text` as the file `case.json` and returns what the binary said; the output folder is `out` in `folder`.
fn run(folder: &Path, text: &[u8]) -> Output {
    let file = folder.join("case.json");
    fs::write(&file, text).unwrap();
    let binary = env!("CARGO_BIN_EXE_ancf");
    Command::new(binary).arg("run").arg(&file).arg("--out").arg(folder.join("out")).output().unwrap()
}

/// `text` is refused with a message that holds every one of `parts`, and leaves no output.
fn refused_text(text: &[u8], parts: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let output = run(folder.path(), text);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.starts_with("error: ") && message.lines().count() == 1, "{message}");
    for part in parts.iter().chain(&["case.json"]) {
        assert!(message.contains(part), "no {part:?} in: {message}");
    }
    assert!(!folder.path().join("out").exists(), "there is output beside: {message}");
    assert!(output.stdout.is_empty());
    if let Ok(scene) = serde_json::from_slice(text)
        && OF_SHAPE.iter().any(|words| message.contains(words))
        // Statics does without an end: the method decides.
        && !message.contains("`time.end` is missing")
    {
        assert!(!SCHEMA.is_valid(&scene), "the schema takes what is refused: {message}");
    }
}

/// Words of refusals for a shape, which `schema/scene.schema.json` has to refuse, too; what a value means beside others no schema tells.
const OF_SHAPE: [&str; 6] = [
    "is an unknown key",
    "is missing; allowed: a value here, the key is required",
    "; allowed: a list of two numbers, [a, b]",
    "; allowed: a list, […]",
    "; allowed: an object, {…}",
    "; allowed: `",
];

static SCHEMA: LazyLock<Validator> = LazyLock::new(|| {
    let (_, schema) = ancf_cli::schemas().into_iter().find(|(name, _)| *name == "scene.schema.json").unwrap();
    jsonschema::draft202012::new(schema.as_value()).unwrap()
});

/// [`GOOD`] with `from`, which it holds once, replaced by `to`.
fn changed(from: &str, to: &str) -> String {
    changed_in(GOOD, from, to)
}

/// `base` with `from`, which it holds once, replaced by `to`.
fn changed_in(base: &str, from: &str, to: &str) -> String {
    assert_eq!(base.matches(from).count(), 1, "{from:?}");
    base.replace(from, to)
}

/// Tests of one changed place each: what it was => what it is; line, key and value as they are quoted; what is allowed.
/// The scene that is changed is [`GOOD`], or the one named first.
macro_rules! refused {
    ($($name:ident: $from:literal => $to:literal; $line:literal, $key_and_value:literal; $allowed:literal)+) => {
        refused! { in GOOD; $($name: $from => $to; $line, $key_and_value; $allowed)+ }
    };
    (in $base:ident; $($name:ident: $from:literal => $to:literal; $line:literal, $key_and_value:literal; $allowed:literal)+) => {
        $(
            #[test]
            fn $name() {
                let line = concat!("case.json:", $line, ":");
                let key_and_value = concat!(": ", $key_and_value, "; allowed: ");
                refused_text(changed_in($base, $from, $to).as_bytes(), &[line, key_and_value, $allowed]);
            }
        )+
    };
}

#[test]
fn the_unchanged_scene_runs() {
    let folder = tempfile::tempdir().unwrap();
    let output = run(folder.path(), GOOD.as_bytes());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(folder.path().join("out/summary.json").exists());
}

// Keys.
refused! {
    name_like_a_formula: r#""name": "tip""# => r#""name": "=1+1""#; 13, "`probes[0].name` is \"=1+1\""; "does not begin with = + - @"
    unknown_key: r#""nu": 0.3"# => r#""nue": 0.3"#; 4, "`material.nue` is an unknown key (value 0.3)"; "`E`, `nu`, `rho`, `alpha`; nearest: `nu`"
    unknown_key_in_other_case: r#""E": 2e8"# => r#""e": 2e8"#; 4, "`material.e` is an unknown key (value 2e8)"; "nearest: `E`"
    unknown_key_at_the_top: r#""gravity""# => r#""gravitation""#; 9, "`gravitation` is an unknown key (value [0.0, -9.8])"; "nearest: `gravity`"
    unknown_key_in_a_list: r#""elements": 2"# => r#""elments": 2"#; 7, "`rods[0].elments` is an unknown key (value 2)"; "nearest: `elements`"
    missing_key: r#""nu": 0.3, "# => ""; 4, "`material.nu` is missing"; "required"
    key_given_twice_at_the_top: r#""time": {"# => r#""temperature": {"#; 10, "`temperature` is given twice"; "each key once"
    missing_section: "  \"section\": {\"height\": 0.02, \"width\": 0.03},\n" => ""; 1, "`section` is missing"; "required"
    missing_alpha_of_a_heated_scene: r#", "alpha": 2.5e-5"# => ""; 4, "`material.alpha` is missing"; "a number; `temperature` needs it"
    duplicate_key: r#""nu": 0.3"# => r#""E": 0.3"#; 4, "`material.E` is given twice"; "each key once"
    duplicate_point: r#""apex": [0.5, 0.0]"# => r#""o": [0.5, 0.0]"#; 6, "`points.o` is given twice"; "each key once"
    another_version: "ancf-scene/1" => "ancf-scene/2"; 2, "`schema` is \"ancf-scene/2\""; "`ancf-scene/1`"
}

// Types, and what JSON is not.
refused! {
    text_for_a_number: r#""E": 2e8"# => r#""E": "soft""#; 4, "`material.E` is \"soft\""; "a number"
    number_for_a_text: r#""name": "rod""# => r#""name": 7"#; 7, "`rods[0].name` is 7"; "a string"
    list_for_an_object: r#"{"height": 0.02, "width": 0.03}"# => "[0.02, 0.03]"; 5, "`section` is [0.02, 0.03]"; "an object"
    list_for_an_object_in_a_list: r#"[{"point": "o", "fix": ["x"]}]"# => r#"[["o", ["x"]]]"#; 8, "`supports[0]` is [\"o\", [\"x\"]]"; "an object"
    object_for_a_list: r#"["x"]"# => r#"{"x": true}"#; 8, "`supports[0].fix` is {\"x\": true}"; "a list"
    null_for_an_object: r#"{"interval": 0.002, "energy": true}"# => "null"; 12, "`output` is null"; "an object"
    null_for_a_number: r#""interval": 0.002"# => r#""interval": null"#; 12, "`output.interval` is null"; "a number"
    number_for_a_switch: r#""energy": true"# => r#""energy": 1"#; 12, "`output.energy` is 1"; "a boolean"
    fraction_for_a_count: r#""elements": 2"# => r#""elements": 2.5"#; 7, "`rods[0].elements` is 2.5"; "a whole number"
    negative_count: r#""elements": 2"# => r#""elements": -2"#; 7, "`rods[0].elements` is -2"; "a whole number, not negative"
    list_for_the_points: r#"{"o": [0.0, 0.0], "apex": [0.5, 0.0]}"# => "[[0.0, 0.0], [0.5, 0.0]]"; 6, "`points` is [[0.0, 0.0], [0.5, 0.0]]"; "an object, {\"name\": [x, y], …}"
    key_that_begins_like_another: r#""o": [0.0, 0.0], "apex": [0.5, 0.0]"# => r#""ap": [0.0, 0.0], "apex": [0.5, "x"]"#; 6, "`points.apex[1]` is \"x\""; "a number"
    point_with_one_coordinate: "[0.5, 0.0]" => "[0.5]"; 6, "`points.apex` is [0.5]"; "two numbers"
    point_with_three_coordinates: "[0.5, 0.0]" => "[0.5, 0.0, 0.0]"; 6, "`points.apex` is [0.5, 0.0, 0.0]"; "two numbers"
    path_in_motion: r#""generalized-alpha""# => r#""generalized-alpha", "path": "arc-length""#; 11, "`time.path` is \"arc-length\""; "only \"static\" follows one"
    unknown_word: r#""generalized-alpha""# => r#""rk4""#; 11, "`time.method` is \"rk4\""; "`generalized-alpha`, `energy-momentum`, `explicit`, `gauss`, `nystrom`, `gauss-adaptive`, `nystrom-adaptive`, `static`"
    number_for_a_word: r#""generalized-alpha""# => "4"; 11, "`time.method` is 4"; "`generalized-alpha`, `energy-momentum`, `explicit`"
    object_for_a_word: r#""2d""# => r#"{"2d": null}"#; 10, "`temperature.model` is {\"2d\": null}"; "`2d`, `1d`, `transverse`, `none`"
    nan: r#""nu": 0.3"# => r#""nu": NaN"#; 4, "`material.nu` is NaN"; "numbers are finite"
    nan_in_a_list: "[0.5, 0.0]" => "[0.5, NaN]"; 6, "`points.apex[1]` is NaN"; "numbers are finite"
    infinity: r#""end": 0.002"# => r#""end": Infinity"#; 11, "`time.end` is Infinity"; "numbers are finite"
    negative_infinity: "-9.8" => "-Infinity"; 9, "`gravity[1]` is -Infinity"; "numbers are finite"
    number_out_of_range: r#""rho": 7750.0"# => r#""rho": 1e999"#; 4, "`material.rho` is 1e999"; "numbers are finite"
    missing_comma: r#"0.3, "rho""# => r#"0.3 "rho""#; 4, "`material` is not JSON here"; "JSON (expected `,` or `}`)"
    more_behind_the_end: "[\"position\"]}]\n}" => "[\"position\"]}]\n} x"; 14, "`scene` is not JSON here"; "JSON (trailing characters)"
}

// Values.
refused! {
    zero_modulus: r#""E": 2e8"# => r#""E": 0"#; 4, "`material.E` is 0"; "over 0"
    negative_modulus: r#""E": 2e8"# => r#""E": -2.0e8"#; 4, "`material.E` is -2.0e8"; "over 0"
    zero_density: r#""rho": 7750.0"# => r#""rho": 0.0"#; 4, "`material.rho` is 0.0"; "over 0"
    nu_of_one_half: r#""nu": 0.3"# => r#""nu": 0.5"#; 4, "`material.nu` is 0.5"; "between -1 and 0.5"
    nu_of_minus_one: r#""nu": 0.3"# => r#""nu": -1"#; 4, "`material.nu` is -1"; "between -1 and 0.5"
    zero_height: r#""height": 0.02"# => r#""height": 0"#; 5, "`section.height` is 0"; "over 0"
    negative_width: r#""width": 0.03"# => r#""width": -0.03"#; 5, "`section.width` is -0.03"; "over 0"
    cold_beyond_the_strain_measure: "[1.0, 25.0]" => "[1.0, -20000.0]"; 10, "`temperature.history[1][1]` is -20000.0"; "dT over -2.000000e4 K, where 1 + 2 alpha dT stays positive"
    heat_beyond_the_strain_measure: r#""alpha": 2.5e-5"# => r#""alpha": -0.025"#; 10, "`temperature.history[0][1]` is 20.0"; "dT under 2.000000e1 K, where 1 + 2 alpha dT stays positive"
    history_backwards: "[1.0, 25.0]" => "[0.0, 25.0]"; 10, "`temperature.history[1][0]` is 0.0"; "a time after the 0.0 s before it"
    empty_history: "[[0.0, 20.0], [1.0, 25.0]]" => "[]"; 10, "`temperature.history` is []"; "at least one pair [t, dT]"
    relaxed_start_of_a_rod_held_twice: r#"[{"point": "o", "fix": ["x"]}]"# => r#"[{"point": "o", "fix": ["x"]}, {"point": "apex", "fix": ["x"]}]"#; 10, "`temperature.start` is \"relaxed\""; "points held 2"
    relaxed_start_of_pinned_rods: r#""elements": 2}"# => r#""elements": 2}, {"name": "two", "from": "o", "to": "apex"}"#; 10, "`temperature.start` is \"relaxed\""; "rods 2"
    zero_step: r#""step": 1e-3"# => r#""step": 0.0"#; 11, "`time.step` is 0.0"; "over 0"
    negative_step: r#""step": 1e-3"# => r#""step": -1e-3"#; 11, "`time.step` is -1e-3"; "over 0"
    too_many_steps: r#""step": 1e-3"# => r#""step": 1e-12"#; 11, "`time.step` is 1e-12"; "at least 2.000000000e-12 s"
    zero_end: r#""end": 0.002"# => r#""end": 0"#; 11, "`time.end` is 0"; "over 0"
    end_not_a_whole_number_of_steps: r#""end": 0.002"# => r#""end": 0.0025"#; 11, "`time.end` is 0.0025"; "a whole number of steps of `time.step` = 0.001 s, not 2.500000; a step of 0.0008333333333333334 s divides it"
    proposed_step_fits_the_rows_too: r#""end": 0.002, "step": 1e-3"# => r#""end": 0.01, "step": 0.0007"#; 11, "`time.end` is 0.01"; "a step of 0.0006666666666666666 s divides it"
    end_before_the_first_step: r#""end": 0.002"# => r#""end": 0.0004"#; 11, "`time.end` is 0.0004"; "a step of 0.0004 s divides it"
    interval_not_a_whole_number_of_steps: r#""interval": 0.002"# => r#""interval": 0.0015"#; 12, "`output.interval` is 0.0015"; "a whole number of steps"
    negative_interval: r#""interval": 0.002"# => r#""interval": -0.002"#; 12, "`output.interval` is -0.002"; "over 0"
    rho_inf_over_one: "0.8" => "1.1"; 11, "`time.rho_inf` is 1.1"; "from 0 to 1"
    negative_rho_inf: "0.8" => "-0.1"; 11, "`time.rho_inf` is -0.1"; "from 0 to 1"
    idle_tolerance: r#""rho_inf": 0.8"# => r#""tolerance": 1e-6"#; 11, "`time.tolerance` is 1e-6"; "nothing with the method \"generalized-alpha\", which has no use for it: \"gauss-adaptive\" and \"nystrom-adaptive\" choose their steps by it"
    zero_tolerance: "1e-9" => "0.0"; 11, "`time.newton_tolerance` is 0.0"; "over 0"
    coarse_tolerance: "1e-9" => "0.1"; 11, "`time.newton_tolerance` is 0.1"; "not over 1e-2"
}

// Methods with steps of their own choice.
refused! {
    in ADAPTIVE;
    idle_radius: r#""tolerance": 1e-6"# => r#""rho_inf": 0.5"#; 7, "`time.rho_inf` is 0.5"; "nothing with the method \"gauss-adaptive\", which has no use for it: \"generalized-alpha\" has a spectral radius"
    idle_load_steps: r#""tolerance": 1e-6"# => r#""load_steps": 10"#; 7, "`time.load_steps` is 10"; "\"static\" has load steps"
    idle_newton_tolerance: r#""gauss-adaptive""# => r#""nystrom-adaptive", "newton_tolerance": 1e-10"#; 7, "`time.newton_tolerance` is 1e-10"; "nothing with the method \"nystrom-adaptive\", which has no use for it: implicit methods and \"static\" iterate"
    zero_tolerance_of_a_step: r#""tolerance": 1e-6"# => r#""tolerance": 0.0"#; 7, "`time.tolerance` is 0.0"; "a finite number over 0"
    negative_tolerance_of_a_step: r#""tolerance": 1e-6"# => r#""tolerance": -1e-6"#; 7, "`time.tolerance` is -1e-6"; "a finite number over 0"
    tolerance_that_is_no_number: r#""tolerance": 1e-6"# => r#""tolerance": NaN"#; 7, "`time.tolerance` is NaN"; "numbers are finite"
    null_for_a_tolerance: r#""tolerance": 1e-6"# => r#""tolerance": null"#; 7, "`time.tolerance` is null"; "a number"
    end_that_is_no_row: r#""interval": 0.001"# => r#""interval": 0.0015"#; 7, "`time.end` is 0.002"; "a whole number of steps of"
    end_that_is_no_row_of_longest_steps: r#", "interval": 0.001"# => ""; 7, "`time.end` is 0.002"; "a whole number of steps of `time.step` = 0.0007 s"
    negative_interval_of_rows: r#""interval": 0.001"# => r#""interval": -0.001"#; 8, "`output.interval` is -0.001"; "over 0"
    multipliers_with_steps_of_its_own_choice: r#"  "time""# => r#"  "constraints": "multipliers", "time""#; 7, "`constraints` is \"multipliers\""; "(here: \"gauss-adaptive\")"
}

// Names, points, rods, supports and probes.
refused! {
    unknown_point_of_a_rod: r#""to": "apex""# => r#""to": "apx""#; 7, "`rods[0].to` is \"apx\""; "nearest: `apex`"
    unknown_point_of_a_support: r#""point": "o""# => r#""point": "0""#; 8, "`supports[0].point` is \"0\""; "the name of a point in `points`"
    unknown_point_of_a_probe: r#""point": "apex""# => r#""point": "tip""#; 13, "`probes[0].point` is \"tip\""; "the name of a point in `points`"
    missing_end: r#""end": 0.002, "# => ""; 11, "`time.end` is missing"; "a value here, the key is required"
    zero_length_rod: r#"{"o": [0.0, 0.0], "apex": [0.5, 0.0]}"# => r#"{"o": [3.0, 4.0], "apex": [3.0, 4.0]}"#; 7, "`rods[0].to` is \"apex\""; "a point further from `o` than 1e-9 of their coordinates; the rod's length is 0.0 m"
    rod_to_its_own_start: r#""to": "apex""# => r#""to": "o""#; 7, "`rods[0].to` is \"o\""; "another point than `from`"
    no_elements: r#""elements": 2"# => r#""elements": 0"#; 7, "`rods[0].elements` is 0"; "a whole number from 1 to 100000"
    too_many_elements: r#""elements": 2"# => r#""elements": 100001"#; 7, "`rods[0].elements` is 100001"; "a whole number from 1 to 100000"
    no_rods: r#"[{"name": "rod", "from": "o", "to": "apex", "elements": 2}]"# => "[]"; 7, "`rods` is []"; "at least one rod"
    two_rods_of_one_name: r#""elements": 2}"# => r#""elements": 2}, {"name": "rod", "from": "o", "to": "apex"}"#; 7, "`rods[1].name` is \"rod\""; "each name once; rods[0] has this one"
    imperfection_of_a_relaxed_start: r#""title": "one heated rod""# => r#""title": "one heated rod", "imperfection": {"mode": 1, "amplitude": 1e-3}"#; 3, "`imperfection` is {\"mode\": 1, \"amplitude\": 1e-3}"; "no imperfection with \"start\": \"relaxed\""
    unused_point: r#""o": [0.0, 0.0]"# => r#""o": [0.0, 0.0], "far": [9, 9]"#; 6, "`points.far` is [9, 9]"; "only points that a rod has as its `from` or `to`"
    name_with_a_comma: r#""name": "tip""# => r#""name": "tip,x""#; 13, "`probes[0].name` is \"tip,x\""; "a name without"
    empty_name: r#""name": "rod""# => r#""name": """#; 7, "`rods[0].name` is \"\""; "a name without"
    probe_in_the_place_of_the_energies: r#""name": "tip""# => r#""name": "energy""#; 13, "`probes[0].name` is \"energy\""; "another name"
    support_without_directions: r#"["x"]"# => "[]"; 8, "`supports[0].fix` is []"; "at least one entry"
    support_with_a_direction_twice: r#"["x"]"# => r#"["x", "x"]"#; 8, "`supports[0].fix[1]` is \"x\""; "each word once"
    support_with_an_unknown_direction: r#"["x"]"# => r#"["z"]"#; 8, "`supports[0].fix[0]` is \"z\""; "`x`, `y`"
    probe_of_nothing: r#"["position"]"# => "[]"; 13, "`probes[0].of` is []"; "at least one entry"
    probe_of_one_quantity_twice: r#"["position"]"# => r#"["position", "position"]"#; 13, "`probes[0].of[1]` is \"position\""; "each word once"
    probes_of_one_name: r#"["position"]}"# => r#"["position"]}, {"name": "tip", "point": "o", "of": ["velocity"]}"#; 13, "`probes[1].name` is \"tip\""; "each name once; probes[0] has this one"
    title_in_two_lines: "one heated rod" => "one\\nrod"; 3, "`title` is \"one\\nrod\""; "a text in one line"
}

// Rods of a structure.
refused! {
    in CROSS;
    note_in_two_lines: r#""one pin""# => r#""one\npin""#; 3, "`notes[1]` is \"one\\npin\""; "a text in one line"
    modulus_of_a_rod: "3e8" => "0.0"; 9, "`rods[1].material.E` is 0.0"; "over 0"
    poissons_ratio_of_a_rod: r#""nu": 0.1"# => r#""nu": 0.5"#; 9, "`rods[1].material.nu` is 0.5"; "between -1 and 0.5"
    density_of_a_rod: "2700.0" => "-2700.0"; 9, "`rods[1].material.rho` is -2700.0"; "over 0"
    height_of_a_rod: r#""height": 0.01"# => r#""height": 0.0"#; 9, "`rods[1].section.height` is 0.0"; "over 0"
    width_of_a_rod: r#""width": 0.04"# => r#""width": -1"#; 9, "`rods[1].section.width` is -1"; "over 0"
    unknown_key_of_a_rods_material: r#""nu": 0.1"# => r#""mu": 0.1"#; 9, "`rods[1].material.mu` is an unknown key (value 0.1)"; "nearest: `nu`"
    null_for_a_rods_section: r#"{"height": 0.01, "width": 0.04}"# => "null"; 9, "`rods[1].section` is null"; "an object"
    missing_alpha_of_a_heated_rod: r#", "alpha": -5e-5"# => ""; 9, "`rods[1].material.alpha` is missing"; "a number; `rods[1].temperature` needs it"
    missing_alpha_of_the_scene: r#", "alpha": 2.5e-5"# => ""; 4, "`material.alpha` is missing"; "a number; `temperature` needs it"
    too_hot_for_a_rods_own_alpha: "20.0]" => "10000.0]"; 10, "`rods[1].temperature.history[0][1]` is 10000.0"; "dT under 1.000000e4 K, where 1 + 2 alpha dT stays positive in the rod `down`"
    too_cold_for_the_scenes_alpha: "40.0]" => "-20000.0]"; 13, "`temperature.history[0][1]` is -20000.0"; "dT over -2.000000e4 K, where 1 + 2 alpha dT stays positive in the rod `up`"
    times_of_a_rods_heat_out_of_order: "[1.5, -30.0]" => "[0.0, -30.0]"; 10, "`rods[1].temperature.history[1][0]` is 0.0"; "a time after the 0.0 s before it"
    no_history_of_a_rods_heat: r#", "history": [[0.0, 20.0], [1.5, -30.0]]"# => ""; 10, "`rods[1].temperature.history` is []"; "at least one pair [t, dT]"
    unknown_element: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "element": "timoshenko""#; 7, "`rods[0].element` is \"timoshenko\""; "`ancf`, `euler-bernoulli`"
    number_for_an_element: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "element": 8"#; 7, "`rods[0].element` is 8"; "`ancf`, `euler-bernoulli`"
    unknown_place_of_poissons_terms: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "poisson": "none""#; 7, "`rods[0].poisson` is \"none\""; "`full`, `axis`"
    unknown_law: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "law": "plane-stress""#; 7, "`rods[0].law` is \"plane-stress\""; "`plane-strain`, `uniaxial`"
    law_of_an_element_without_a_section: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "element": "euler-bernoulli", "law": "uniaxial""#; 7, "`rods[0].law` is \"uniaxial\""; "the element \"euler-bernoulli\" is uniaxial anyway, with the stiffnesses EA and EI: leave `law` out"
    poissons_terms_of_a_law_without: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "law": "uniaxial", "poisson": "axis""#; 7, "`rods[0].poisson` is \"axis\""; "\"full\", the default, beside \"law\": \"uniaxial\", which has no Poisson's terms: leave one of the two keys out"
    imperfection_without_a_shape: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"amplitude": 1e-3}"#; 3, "`imperfection` is {\"amplitude\": 1e-3}"; "one of the two shapes: `mode` or `rod`"
    imperfection_with_two_shapes: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 1, "rod": "up", "amplitude": 1e-3}"#; 3, "`imperfection` is {\"mode\": 1, \"rod\": \"up\", \"amplitude\": 1e-3}"; "one of the two shapes: `mode` or `rod`"
    imperfection_of_no_size: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 1, "amplitude": 0}"#; 3, "`imperfection.amplitude` is 0"; "but not 0"
    imperfection_beyond_its_shape: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 1, "amplitude": 0.3}"#; 3, "`imperfection.amplitude` is 0.3"; "a number between -0.28284271247461906 and 0.28284271247461906 m, a tenth of the size, but not 0"
    imperfection_in_no_mode: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 0, "amplitude": 1e-3}"#; 3, "`imperfection.mode` is 0"; "a whole number from 1 to 50"
    imperfection_in_half_a_mode: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 1.5, "amplitude": 1e-3}"#; 3, "`imperfection.mode` is 1.5"; "a whole number"
    imperfection_of_an_unknown_rod: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"rod": "top", "amplitude": 1e-3}"#; 3, "`imperfection.rod` is \"top\""; "the name of a rod (`up`, `down`)"
    imperfection_of_a_rod_with_a_pivot: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"rod": "up", "amplitude": 1e-3}"#; 3, "`imperfection.rod` is \"up\""; "a rod without `pivot`, where others would be pulled along"
    imperfection_without_an_amplitude: r#""notes": ["two rods", "one pin"]"# => r#""notes": ["two rods", "one pin"], "imperfection": {"mode": 1}"#; 3, "`imperfection.amplitude` is missing"; "a value here, the key is required"
    poissons_terms_without_a_section: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "element": "euler-bernoulli", "poisson": "axis""#; 7, "`rods[0].poisson` is \"axis\""; "the element \"euler-bernoulli\" has no section for Poisson's terms"
    pivot_without_a_node: r#""q", "pivot": "m""# => r#""q", "pivot": "m", "element": "euler-bernoulli", "elements": 3"#; 7, "`rods[0].elements` is 3"; "an even number: the element \"euler-bernoulli\" has no node in its middle, where the pivot `m` is"
    too_hot_for_an_axial_strain: r#""material": {"E": 3e8, "nu": 0.1, "rho": 2700.0, "alpha": -5e-5}"# => r#""element": "euler-bernoulli", "material": {"E": 3e8, "nu": 0.1, "rho": 2700.0, "alpha": -0.05}"#; 10, "`rods[1].temperature.history[0][1]` is 20.0"; "dT under 2.000000e1 K, where 1 + alpha dT stays positive in the rod `down`"
    heat_across_a_rod_without_a_section: r#""material": {"E": 3e8, "nu": 0.1, "rho": 2700.0, "alpha": -5e-5}, "section": {"height": 0.01, "width": 0.04},
     "temperature": {"model": "1d""# => r#""element": "euler-bernoulli",
     "temperature": {"model": "transverse""#; 10, "`rods[1].temperature.model` is \"transverse\""; "no section that heat could strain across"
    relaxed_start_of_a_pinned_rod: r#""sudden""# => r#""relaxed""#; 10, "`rods[1].temperature.start` is \"relaxed\""; "points held 2"
    pivot_with_the_name_of_a_point: r#""s", "pivot": "m""# => r#""s", "pivot": "q""#; 8, "`rods[1].pivot` is \"q\""; "a name that no point in `points` has"
    rod_pinned_to_its_own_end: r#""q", "pivot": "m""# => r#""q", "pivot": "p""#; 7, "`rods[0].pivot` is \"p\""; "a name that no point in `points` has"
    pivot_of_one_rod: r#""s", "pivot": "m""# => r#""s", "pivot": "n""#; 7, "`rods[0].pivot` is \"m\""; "a name that at least two rods have as their `pivot`"
    pivot_without_a_name: r#""s", "pivot": "m""# => r#""s", "pivot": """#; 8, "`rods[1].pivot` is \"\""; "a name without"
    null_for_a_pivot: r#""s", "pivot": "m""# => r#""s", "pivot": null"#; 8, "`rods[1].pivot` is null"; "a string"
    pivot_at_two_places: r#""s": [2.0, 0.0]"# => r#""s": [2.0, 0.5]"#; 8, "`rods[1].pivot` is \"m\""; "rods whose middles are at one place: `up` has its middle at [1.0, 1.0], `down` at [1.0, 1.25]"
    pivot_listed_as_a_point: r#""s": [2.0, 0.0]"# => r#""s": [2.0, 0.0], "m": [1.0, 1.0]"#; 6, "`points.m` is [1.0, 1.0]"; "only points that a rod has as its `from` or `to`"
    rod_that_ends_at_a_pivot: r#""to": "s""# => r#""to": "m""#; 8, "`rods[1].to` is \"m\""; "the name of a point in `points`"
}

// Supports of a structure.
refused! {
    in CROSS;
    support_of_nothing: r#"{"point": "s", "slide": [3.0, 4.0]}"# => r#"{"point": "s"}"#; 11, "`supports[1].fix` is missing"; "at least one entry, or `slide` or `clamp` in its place"
    support_of_an_unknown_point: r#""point": "s""# => r#""point": "n""#; 11, "`supports[1].point` is \"n\""; "the name of a point in `points` or of a rod's pivot (`p`, `q`, `r`, `s`, `m`); where a point was taken away, what stands at it goes too"
    slide_along_nothing: "[3.0, 4.0]" => "[0.0, -0.0]"; 11, "`supports[1].slide` is [0.0, -0.0]"; "a direction that is not zero"
    slide_that_is_no_pair: "[3.0, 4.0]" => "[3.0]"; 11, "`supports[1].slide` is [3.0]"; "two numbers"
    clamp_of_an_unknown_rod: r#""clamp": "up""# => r#""clamp": "upp""#; 11, "`supports[0].clamp` is \"upp\""; "the name of a rod (`up`, `down`); nearest: `up`"
    clamp_of_a_rod_elsewhere: r#""clamp": "up""# => r#""clamp": "down""#; 11, "`supports[0].clamp` is \"down\""; "a rod that has `p` as its `from`, `to` or `pivot`"
    direction_held_twice: r#"{"point": "s", "slide": [3.0, 4.0]}"# => r#"{"point": "s", "fix": ["x"]}, {"point": "p", "fix": ["x"]}"#; 11, "`supports[2].fix[0]` is \"x\""; "directions that no other support holds at `p`: supports[2].fix is redundant beside supports[0].fix"
    slide_that_holds_what_is_fixed: "[3.0, 4.0]}" => r#"[0.0, 2.0]}, {"point": "s", "fix": ["x"]}"#; 11, "`supports[2].fix[0]` is \"x\""; "at `s`: supports[2].fix is redundant beside supports[1].slide"
    slide_along_what_is_fixed: "[3.0, 4.0]}" => r#"[0.0, 2.0]}, {"point": "s", "fix": ["y"]}"#; 11, "`supports[2].fix[0]` is \"y\""; "at `s`: supports[2].fix contradicts supports[1].slide"
    slide_of_a_fixed_point: "[3.0, 4.0]}" => r#"[3.0, 4.0]}, {"point": "p", "slide": [1.0, 1.0]}"#; 11, "`supports[2].slide` is [1.0, 1.0]"; "at `p`: supports[2].slide contradicts supports[0].fix"
    slide_along_an_axis_of_a_fixed_point: "[3.0, 4.0]}" => r#"[3.0, 4.0]}, {"point": "p", "slide": [0.0, 1.0]}"#; 11, "`supports[2].slide` is [0.0, 1.0]"; "at `p`: supports[2].slide contradicts supports[0].fix"
    slide_and_fix_of_one_support: r#""slide": [3.0, 4.0]"# => r#""slide": [3.0, 4.0], "fix": ["y"]"#; 11, "`supports[1].slide` is [3.0, 4.0]"; "at `s`: supports[1].slide contradicts supports[1].fix"
    slide_that_is_almost_along_an_axis: "[3.0, 4.0]}" => r#"[1e-10, 2.0]}, {"point": "s", "fix": ["x"]}"#; 11, "`supports[2].fix[0]` is \"x\""; "at `s`: supports[2].fix is redundant beside supports[1].slide"
    slide_that_is_not_quite_along_an_axis: "[3.0, 4.0]}" => r#"[1e-8, 2.0]}, {"point": "s", "fix": ["x"]}"#; 11, "`supports[2].fix[0]` is \"x\""; "at `s`: supports[2].fix contradicts supports[1].slide"
    two_slides: "[3.0, 4.0]}" => r#"[3.0, 4.0]}, {"point": "s", "slide": [4.0, -3.0]}"#; 11, "`supports[2].slide` is [4.0, -3.0]"; "at `s`: supports[2].slide contradicts supports[1].slide"
    two_slides_along_one_line: "[3.0, 4.0]}" => r#"[3.0, 4.0]}, {"point": "s", "slide": [-6e200, -8e200]}"#; 11, "`supports[2].slide` is [-6e200, -8e200]"; "at `s`: supports[2].slide is redundant beside supports[1].slide"
    two_clamps_of_a_rod: "[3.0, 4.0]}" => r#"[3.0, 4.0]}, {"point": "p", "clamp": "up"}"#; 11, "`supports[2].clamp` is \"up\""; "a rod that no other support clamps at `p`: supports[2] is redundant beside supports[0]"
}

// Forces and constraints of a structure.
refused! {
    in CROSS;
    force_at_an_unknown_point: r#""point": "m", "force""# => r#""point": "mm", "force""#; 12, "`forces[0].point` is \"mm\""; "of a rod's pivot (`p`, `q`, `r`, `s`, `m`); nearest: `m`"
    force_that_is_no_number: "1.5, -2.5" => "1.5, NaN"; 12, "`forces[0].force[1]` is NaN"; "numbers are finite"
    force_without_history_in_its_list: "[[0.0, 0.0], [0.1, 1.0]]" => "[]"; 12, "`forces[0].history` is []"; "at least one pair [t, factor]"
    null_for_a_forces_history: "[[0.0, 0.0], [0.1, 1.0]]" => "null"; 12, "`forces[0].history` is null"; "a list"
    times_of_a_force_out_of_order: "[0.1, 1.0]" => "[-0.1, 1.0]"; 12, "`forces[0].history[1][0]` is -0.1"; "a time after the 0.0 s before it"
    unknown_constraints: r#""multipliers""# => r#""penalty""#; 14, "`constraints` is \"penalty\""; "`condensed`, `multipliers`"
    multipliers_with_gauss: "generalized-alpha" => "gauss"; 14, "`constraints` is \"multipliers\""; "needs the method \"generalized-alpha\" (here: \"gauss\")"
    multipliers_with_nystrom: "generalized-alpha" => "nystrom"; 14, "`constraints` is \"multipliers\""; "needs the method \"generalized-alpha\" (here: \"nystrom\")"
    multipliers_with_another_method: "generalized-alpha" => "energy-momentum"; 14, "`constraints` is \"multipliers\""; "needs the method \"generalized-alpha\" (here: \"energy-momentum\")"
}

// Probes of a structure.
refused! {
    in CROSS;
    probe_of_neither_point_nor_rod: r#""rod": "down", "at""# => r#""at""#; 18, "`probes[2].point` is missing"; "the name of a point, or `rod` and `at` for a place on a rod"
    probe_of_a_rod_without_a_place: r#" "at": 0.25,"# => ""; 18, "`probes[2].at` is missing"; "a number from 0 to 1"
    probe_before_a_rods_start: "0.25" => "-0.25"; 18, "`probes[2].at` is -0.25"; "a number from 0 to 1"
    probe_behind_a_rods_end: "0.25" => "1.0000001"; 18, "`probes[2].at` is 1.0000001"; "a number from 0 to 1"
    probe_of_a_place_and_a_point: r#""rod": "down", "at""# => r#""point": "m", "rod": "down", "at""#; 18, "`probes[2].at` is 0.25"; "nothing beside `point`"
    probe_of_an_unknown_rod: r#""rod": "down", "at""# => r#""rod": "dawn", "at""#; 18, "`probes[2].rod` is \"dawn\""; "the name of a rod (`up`, `down`); nearest: `down`"
    position_of_a_place_on_a_rod: r#"["deflection"]"# => r#"["deflection", "position"]"#; 18, "`probes[2].of[1]` is \"position\""; "\"deflection\" on a rod; the other quantities need a `point`"
    deflection_of_a_point: r#""point": "p", "of": ["reaction"]"# => r#""point": "p", "of": ["deflection"]"#; 17, "`probes[1].of[0]` is \"deflection\""; "a deflection has `rod` and `at`, without `point`"
    reaction_of_a_free_point: r#""point": "p", "of""# => r#""point": "q", "of""#; 17, "`probes[1].of[0]` is \"reaction\""; "a point that a support holds, or with `rod` for the force of a pin on that rod"
    reaction_on_a_rod_elsewhere: r#""point": "m", "rod": "up""# => r#""point": "s", "rod": "up""#; 16, "`probes[0].rod` is \"up\""; "a rod that has `s` as its `from`, `to` or `pivot`"
    position_on_a_rod_at_a_pin: r#""rod": "up", "of": ["reaction"]"# => r#""rod": "up", "of": ["position"]"#; 16, "`probes[0].of[0]` is \"position\""; "\"reaction\" only beside `rod`"
}

// Statics.
refused! {
    in STILL;
    no_load_steps: r#""static""# => r#""static", "load_steps": 0"#; 10, "`time.load_steps` is 0"; "a whole number from 1 to 1000000"
    too_many_load_steps: r#""static""# => r#""static", "load_steps": 1000001"#; 10, "`time.load_steps` is 1000001"; "a whole number from 1 to 1000000"
    load_steps_in_parts: r#""static""# => r#""static", "load_steps": 7.5"#; 10, "`time.load_steps` is 7.5"; "a whole number"
    step_of_statics: r#""static""# => r#""static", "step": 1e-3"#; 10, "`time.step` is 1e-3"; "nothing with the method \"static\", which has no use for it: methods that move in time have a step"
    energies_of_statics: r#"  "probes""# => r#"  "output": {"energy": false}, "probes""#; 11, "`output.energy` is false"; "slowly growing loads supply exactly the stored energy"
    radius_of_statics: r#""static""# => r#""static", "rho_inf": 0.9"#; 10, "`time.rho_inf` is 0.9"; "nothing with the method \"static\", which has no use for it: \"generalized-alpha\" has a spectral radius"
    end_of_statics: r#""method""# => r#""end": 2.0, "method""#; 10, "`time.end` is 2.0"; "1, or nothing: with the method \"static\""
    force_that_starts_loaded_in_statics: "-0.5]" => r#"-0.5], "history": [[0.0, 1.0]]"#; 8, "`forces[0].history` is [[0.0, 1.0]]"; "0 at the load factor 0"
    heat_that_starts_hot_in_statics: "20.0]" => "20.0], [1.0, 30.0]"; 9, "`temperature.history` is [[0.0, 20.0], [1.0, 30.0]]"; "0 at the load factor 0"
    heat_of_a_rod_that_starts_hot_in_statics: r#""to": "a""# => r#""to": "a", "temperature": {"history": [[0, 1], [2, 3]]}"#; 6, "`rods[0].temperature.history` is [[0, 1], [2, 3]]"; "0 at the load factor 0"
    history_along_the_arc_length: "[[0.0, 20.0]]},\n  \"time\": {" => "[[0, 0], [1, 20.0]]},\n  \"time\": {\"path\": \"arc-length\", "; 9, "`temperature.history` is [[0, 0], [1, 20.0]]"; "no history with \"path\": \"arc-length\""
    unknown_path: "\"static\"" => "\"static\", \"path\": \"arc\""; 10, "`time.path` is \"arc\""; "`load`, `arc-length`"
    relaxed_start_of_statics: r#"{"history""# => r#"{"start": "relaxed", "history""#; 9, "`temperature.start` is \"relaxed\""; "heat grows from nothing, and has no start"
    interval_in_statics: r#"  "probes""# => r#"  "output": {"interval": 0.1}, "probes""#; 11, "`output.interval` is 0.1"; "every load step is a row"
    velocity_in_statics: r#"["position"]"# => r#"["position", "velocity"]"#; 11, "`probes[0].of[1]` is \"velocity\""; "with the method \"static\" nothing moves"
    acceleration_in_statics: r#"["position"]"# => r#"["acceleration"]"#; 11, "`probes[0].of[0]` is \"acceleration\""; "with the method \"static\" nothing moves"
    multipliers_in_statics: r#"  "time""# => r#"  "constraints": "multipliers", "time""#; 10, "`constraints` is \"multipliers\""; "(here: \"static\")"
}

#[test]
fn the_unchanged_structures_are_valid() {
    for text in [CROSS, STILL, ADAPTIVE] {
        ancf::model::Model::parse(text, "case.json").unwrap().into_scene();
    }
}

#[test]
fn the_schema_takes_the_unchanged_scenes() {
    for text in [GOOD, CROSS, STILL, ADAPTIVE] {
        SCHEMA.validate(&serde_json::from_str(text).unwrap()).unwrap();
    }
}

#[test]
fn places_are_lines_and_characters() {
    let place = |text: &str, place: &str| refused_text(text.as_bytes(), &[place]);
    place(&changed("2e8", "0.0"), "case.json:4:21: `material.E`");
    place("{\"title\": \"ε̇ Ä\", \"schema\": 1}", "case.json:1:29: `schema`");
    place("{\n\t\"schema\":\n  1}", "case.json:3:3: `schema`");
    place("[]", "case.json:1:1: `scene`");
}

#[test]
fn rod_that_is_short_beside_its_coordinates() {
    let text = GOOD.replace("[0.0, 0.0]", "[1e6, 0.0]").replace("[0.5, 0.0]", "[1.0000000001e6, 0.0]");
    refused_text(text.as_bytes(), &["`rods[0].to` is \"apex\"; allowed: a point further from `o`"]);
}

#[test]
fn elements_of_all_rods_count_together() {
    let second = r#""elements": 99999}, {"name": "two", "from": "o", "to": "apex", "elements": 2}"#;
    let text = changed(r#""elements": 2}"#, second);
    refused_text(
        text.as_bytes(),
        &["`rods[1].elements` is 2; allowed: a whole number from 1 to 1 (100000 in all rods)"],
    );
}

#[test]
fn more_numbers_than_the_memory_holds() {
    let text = changed("1e-3", "1e-11").replace("\"interval\": 0.002, ", "");
    refused_text(text.as_bytes(), &["`output.interval` is 1e-11; allowed: at least 1.600e-10 s"]);
}

/// 195 columns in half a million rows; the most that is allowed is only read, not run.
#[test]
fn more_load_steps_than_the_memory_holds() {
    let probe = |i| format!(r#"{{"name": "{i}", "point": "a", "of": ["position"]}}"#);
    let probes = (0..96).map(probe).collect::<Vec<_>>().join(",");
    let text = changed_in(STILL, "\"probes\": [", &format!("\"probes\": [{probes},"));
    let steps = |count| changed_in(&text, "\"static\"", &format!("\"static\", \"load_steps\": {count}"));
    refused_text(
        steps(512_821).as_bytes(),
        &["`time.load_steps` is 512821; allowed: at most 512820: 195 columns, and 1e8 numbers at most"],
    );
    ancf::model::Model::parse(&steps(512_820), "case.json").unwrap().into_scene();
}

#[test]
fn file_that_is_cut_off() {
    refused_text(&GOOD.as_bytes()[..100], &["case.json:4:", "`material", "cut off", "JSON (EOF"]);
}

#[test]
fn empty_file() {
    refused_text(b"", &["`scene` is cut off at the end of the file; allowed: JSON (EOF"]);
}

#[test]
fn file_that_is_not_text() {
    refused_text(b"\xff\xfe{}", &["cannot read", "UTF-8"]);
}

#[test]
fn file_that_is_too_large() {
    refused_text(&vec![b' '; 16 << 20], &["cut off"]);
    refused_text(&vec![b' '; (16 << 20) + 1], &["cannot read", "larger than 16777216 bytes"]);
}

#[test]
fn long_values_and_keys_are_shortened() {
    let text = changed("\"title\"", &format!("\"{}\"", "k".repeat(1 << 20)));
    refused_text(text.as_bytes(), &["kkk…` is an unknown key (value \"one heated rod\")", "`schema`, `title`"]);
}

#[test]
fn deep_nesting_does_not_overflow_the_stack() {
    let deep = "[".repeat(1_000_000);
    refused_text(deep.as_bytes(), &["`scene`"]);
    for place in ["[0.0, -9.8]", "\"one heated rod\"", "2e8", "\"2d\"", "[\"position\"]", "\"apex\": [0.5, 0.0]"] {
        refused_text(changed(place, &deep).as_bytes(), &["; allowed: "]);
        refused_text(changed(place, &"{\"a\":".repeat(1_000_000)).as_bytes(), &["; allowed: "]);
    }
}

#[test]
fn file_that_does_not_exist() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    let output = command.args(["run", "pendulum2d"]).current_dir(folder.path()).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("cannot read pendulum2d: no such file") && message.contains("`pendulum-2d`"), "{message}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}
