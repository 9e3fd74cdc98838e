//! What shows a run: `report.html`, `shapes.json`, files for ParaView.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ancf::model::{Element, Method, Scene, Shapes};
use ancf::run::Simulation;
use serde_json::Value;
use vtkio::model::{Attribute, CellType, DataSet, UnstructuredGridPiece, VertexNumbers, Vtk};

fn ancf(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ancf")).args(arguments).current_dir(folder).output().unwrap()
}

/// Output folder of a run of a scene.
fn run(folder: &Path, scene: &Scene, options: &[&str]) -> std::path::PathBuf {
    fs::write(folder.join("mine.json"), scene.to_text()).unwrap();
    let output = ancf(folder, &[&["run", "mine.json"], options].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder.join("out")
}

fn entries(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names.collect();
    names.sort();
    names
}

fn json(file: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap()
}

/// Data of a page.
fn data(out: &Path) -> Value {
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    let (_, rest) = page.split_once("id=\"data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// A scissor-like element of few steps, heated, with rods of both elements.
fn scissor() -> Scene {
    let mut scene = Scene::builtin("scissors-3-thermal").unwrap();
    (scene.time.end, scene.output.interval) = (0.02, Some(0.005));
    scene.rods[1].element = Element::EulerBernoulli;
    scene
}

/// Simulation at the end of a scene.
fn at_the_end(scene: &Scene) -> Simulation {
    let mut simulation = Simulation::new(scene).unwrap();
    simulation.finish().unwrap();
    simulation
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn shapes_hold_the_axes_at_their_instants() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = scissor();
    scene.output.shapes = Some(Shapes { interval: Some(0.004), points: 5 });
    let out = run(folder.path(), &scene, &["--no-report"]);
    assert_eq!(entries(&out), ["shapes.json", "summary.json", "trajectory.csv"]);
    let shapes = json(&out.join("shapes.json"));
    assert_eq!(shapes["run"], json(&out.join("summary.json"))["run"]);
    let times = numbers(&shapes["t"]);
    assert_eq!(times.len(), 6);
    assert!(times.iter().enumerate().all(|(n, t)| (t - 0.004 * n as f64).abs() < 1e-12), "{times:?}");

    let end = at_the_end(&scene);
    for (rod, shape) in scene.rods.iter().zip(shapes["rods"].as_array().unwrap()) {
        let at = [0.0, 0.25, 0.5, 0.75, 1.0];
        assert_eq!((&shape["name"], numbers(&shape["at"])), (&Value::from(rod.name.clone()), at.to_vec()));
        let axis = end.axis(&rod.name, &at).unwrap();
        for (key, expected) in [
            ("x", axis.iter().map(|point| point.position[0]).collect::<Vec<_>>()),
            ("y", axis.iter().map(|point| point.position[1]).collect()),
            ("director_y", axis.iter().map(|point| point.director[1]).collect()),
            ("strain", axis.iter().map(|point| point.strain).collect()),
            ("curvature", axis.iter().map(|point| point.curvature).collect()),
        ] {
            assert_eq!(numbers(&shape[key][5]), expected, "{} {key}", rod.name);
        }
        let heat = numbers(&shape["temperature"]);
        assert!((heat[5] - 12.0).abs() < 1e-9 && heat[0] == 0.0, "{heat:?}");
    }
}

#[test]
fn a_page_shows_what_the_run_computed() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = scissor();
    scene.title = "</script><script>alert('&')</script> {{data}}".into();
    scene.notes = vec!["a <b> note".into()];
    let out = run(folder.path(), &scene, &[]);
    assert_eq!(entries(&out), ["report.html", "summary.json", "trajectory.csv"]);
    let (page, id) =
        (fs::read_to_string(out.join("report.html")).unwrap(), json(&out.join("summary.json"))["run"].clone());
    let id = id.as_str().unwrap();
    assert!(page.starts_with(&format!("<!DOCTYPE html>\n<!-- run {id} -->\n")), "{}", &page[..80]);
    // Data and the page's own scripts, and nothing of the scene's texts.
    assert_eq!((page.matches("<script").count(), page.matches("</script>").count()), (2, 2));
    assert!(!page.contains("alert('&')</script>"), "a title is a program");
    assert_eq!(page.matches("ancf-scene/1").count(), 1, "a title is a place to be filled in");
    let data = data(&out);
    assert_eq!(
        (&data["summary"]["run"], &data["summary"]["scene"]["title"]),
        (&id.into(), &scene.title.clone().into())
    );

    // The positions at the end, from whole numbers of the quantum.
    let (end, motion) = (at_the_end(&scene), &data["motion"]);
    let quantum = motion["quantum"].as_f64().unwrap();
    let frames = motion["t"].as_array().unwrap().len();
    assert_eq!((frames, motion["t"][frames - 1].as_f64()), (81, Some(0.02)));
    for (rod, shown) in scene.rods.iter().zip(motion["rods"].as_array().unwrap()) {
        let at = numbers(&shown["at"]);
        let axis = end.axis(&rod.name, &at).unwrap();
        let [from, to] = [&rod.from, &rod.to].map(|name| scene.points[name]);
        for (n, point) in axis.iter().enumerate() {
            for (k, key) in ["x", "y"].into_iter().enumerate() {
                let counted = shown[key][(frames - 1) * at.len() + n].as_f64().unwrap() * quantum;
                let drawn = from[k] + at[n] * (to[k] - from[k]) + counted;
                assert!((drawn - point.position[k]).abs() < 0.51 * quantum, "{} {key}: {drawn}", rod.name);
            }
        }
        let strain =
            shown["elastic"][frames * at.len() - 1].as_f64().unwrap() * motion["elastic_quantum"].as_f64().unwrap();
        let last = axis.last().unwrap();
        assert!(
            (strain - (last.strain - last.thermal_strain)).abs() < 0.51 * motion["elastic_quantum"].as_f64().unwrap()
        );
    }
    let names: Vec<String> =
        data["charts"].as_array().unwrap().iter().map(|chart| format!("{} {}", chart["name"], chart["of"])).collect();
    let probed = ["position", "velocity", "acceleration"].map(|of| format!("\"a4\" \"{of}\""));
    assert_eq!(names[..3], probed);
    assert_eq!(names[6..], ["\"energies\" \"\"", "\"energy balance\" \"\""]);
}

#[test]
fn a_long_run_has_a_small_page() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = Scene::builtin("pendulum-flexible").unwrap().method(Method::Explicit, 2e-5).until(0.4);
    scene.rods[0].elements = 2;
    scene.output.interval = None;
    let out = run(folder.path(), &scene, &[]);
    assert_eq!(fs::read_to_string(out.join("trajectory.csv")).unwrap().lines().count(), 20_002);
    assert!(fs::metadata(out.join("report.html")).unwrap().len() < 400_000);
    let data = data(&out);
    assert_eq!(data["rows_each"], 34);
    let lines = data["charts"][0]["lines"].as_array().unwrap();
    assert!(
        lines.iter().all(|line| line["values"].as_array().unwrap().len() == data["rows"].as_array().unwrap().len())
    );
}

#[test]
fn a_run_that_fails_shows_its_motion_until_then_and_no_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    let scene = Scene::builtin("pendulum-2d").unwrap().method(Method::EnergyMomentum, 0.01);
    fs::write(folder.path().join("mine.json"), scene.to_text()).unwrap();
    let out = folder.path().join("out");
    for (options, page) in [(&["run", "mine.json"][..], true), (&["run", "mine.json", "--no-report"], false)] {
        assert_eq!(ancf(folder.path(), options).status.code(), Some(1));
        assert_eq!(out.join("report.html").exists(), page);
    }
    ancf(folder.path(), &["run", "mine.json"]);
    let data = data(&out);
    assert_eq!(data["summary"]["status"], "failed");
    let last = data["summary"]["last_good_time"].as_f64().unwrap();
    let times = numbers(&data["motion"]["t"]);
    assert!(last > 0.0 && times.len() > 2 && times.last() == Some(&last), "{times:?}, {last}");
}

#[test]
fn static_runs_play_over_the_load() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = Scene::builtin("scissor-static").unwrap();
    scene.output.shapes = Some(Shapes::default());
    let out = run(folder.path(), &scene, &["--vtk"]);
    let shapes = json(&out.join("shapes.json"));
    assert_eq!(numbers(&shapes["load"]).len(), 11);
    assert_eq!(numbers(&data(&out)["motion"]["load"]), numbers(&shapes["load"]));
    scene.output.shapes = Some(Shapes { interval: Some(0.1), points: 17 });
    let error = scene.build().unwrap_err().to_string();
    assert!(
        error.contains("`output.shapes.interval` is 0.1") && error.contains("each load step has a shape"),
        "{error}"
    );
}

/// Grid of a file for ParaView.
fn grid(file: &Path) -> UnstructuredGridPiece {
    let bytes = fs::read(file).unwrap();
    let Vtk { data: DataSet::UnstructuredGrid { pieces, .. }, .. } = Vtk::parse_xml(&bytes[..]).unwrap() else {
        panic!("{} holds no grid", file.display());
    };
    pieces[0].load_piece_data(None).unwrap()
}

fn values(attributes: &[Attribute], name: &str) -> Vec<f64> {
    let found = attributes.iter().find(|attribute| attribute.name() == name);
    let Some(Attribute::DataArray(array)) = found else { panic!("no data `{name}`") };
    array.data.cast_into().unwrap()
}

#[test]
fn files_for_paraview_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = scissor();
    scene.output.shapes = Some(Shapes { interval: None, points: 5 });
    let out = run(folder.path(), &scene, &["--vtk"]);
    let files = entries(&out);
    assert_eq!(files.iter().filter(|name| name.ends_with(".vtu")).count(), 10, "{files:?}");
    let id = json(&out.join("summary.json"))["run"].as_str().unwrap().to_string();
    let end = at_the_end(&scene);
    let axes: Vec<_> =
        scene.rods.iter().map(|rod| end.axis(&rod.name, &[0.0, 0.25, 0.5, 0.75, 1.0]).unwrap()).collect();
    let all = || axes.iter().flatten();

    for (collection, part) in [("axis.pvd", "axis"), ("surface.pvd", "surface")] {
        let text = fs::read_to_string(out.join(collection)).unwrap();
        assert!(text.starts_with(&format!("<!-- run {id} -->\n")), "{text}");
        assert_eq!(text.matches("<DataSet ").count(), 5);
        assert!(text.contains(&format!("timestep=\"0.02\" part=\"0\" file=\"{part}.00004.vtu\"")), "{text}");
        assert!(
            fs::read_to_string(out.join(format!("{part}.00004.vtu"))).unwrap().contains(&format!("<!-- run {id} -->"))
        );
    }

    let axis = grid(&out.join("axis.00004.vtu"));
    let expected: Vec<f64> = all().flat_map(|point| [point.position[0], point.position[1], 0.0]).collect();
    assert_eq!(axis.points.cast_into::<f64>().unwrap(), expected);
    assert_eq!(axis.cells.types, [CellType::PolyLine; 6]);
    for (name, expected) in [
        ("temperature change (K)", all().map(|point| point.temperature).collect::<Vec<_>>()),
        ("axial strain", all().map(|point| point.strain).collect()),
        ("elastic axial strain", all().map(|point| point.strain - point.thermal_strain).collect()),
        ("curvature (1/m)", all().map(|point| point.curvature).collect()),
    ] {
        assert_eq!(values(&axis.data.point, name), expected, "{name}");
    }

    let surface = grid(&out.join("surface.00004.vtu"));
    assert_eq!(surface.cells.types, [CellType::Quad; 24]);
    assert_eq!(values(&surface.data.cell, "rod"), (0..24).map(|n| f64::from(n / 4)).collect::<Vec<_>>());
    let points = surface.points.cast_into::<f64>().unwrap();
    let corner = |n: usize| [points[3 * n], points[3 * n + 1]];
    for (n, point) in all().enumerate() {
        let [low, high] = [corner(2 * n), corner(2 * n + 1)];
        let height = (high[0] - low[0]).hypot(high[1] - low[1]);
        let thicker = point.director[0].hypot(point.director[1]);
        assert!((height - 0.02 * thicker).abs() < 1e-15, "{height}");
        assert!((0..2).all(|k| (0.5 * (low[k] + high[k]) - point.position[k]).abs() < 1e-15));
    }
    let VertexNumbers::XML { connectivity, offsets } = surface.cells.cell_verts else { panic!("no offsets") };
    // Round each quad, and not across it.
    assert_eq!((&connectivity[..4], &offsets[..2]), (&[0, 2, 3, 1][..], &[4, 8][..]));

    // A run without them takes them away.
    run(folder.path(), &scene, &[]);
    assert!(!entries(&out).iter().any(|name| name.ends_with(".vtu") || name.ends_with(".pvd")), "{:?}", entries(&out));
}

#[test]
fn shapes_that_no_file_can_hold_are_refused() {
    let with = |interval, points| {
        let mut scene = scissor();
        scene.output.shapes = Some(Shapes { interval, points });
        scene.build().map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(with(Some(0.005), 2), Ok(()));
    for (interval, points, parts) in [
        (Some(3e-4), 5, ["`output.shapes.interval` is 0.0003", "a whole number of steps"]),
        (Some(-1.0), 5, ["`output.shapes.interval` is -1.0", "over 0"]),
        (None, 1, ["`output.shapes.points` is 1", "from 2 to 10001"]),
        (Some(2.5e-4), 10_000, ["`output.shapes` is too much for a file", "longer `interval`"]),
    ] {
        let error = with(interval, points).unwrap_err();
        assert!(parts.iter().all(|part| error.contains(part)), "{error}");
    }
}
