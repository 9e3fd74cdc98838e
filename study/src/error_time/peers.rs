//! Another program's runs of our scenes, as `python -m oracle.peers` writes them, and their distances from our reference.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::Serialize;

use super::benchmark::Benchmark;
use super::benchmarks::{BENCHMARKS, scene_names};
use super::point::{Point, Status};
use super::reference::Reference;
use super::samples::Samples;
use super::timing::Timing;
use crate::error::{Error, Result};
use crate::escape;
use ancf::integrators::Counts;

/// The command that writes the file.
pub const COMMAND: &str = "python -m oracle.peers";

/// The required columns, in any order; others are ignored.
pub const COLUMNS: &str = "scene,program,version,element,method,elements,step,newton_tolerance,modified_newton,linear_solver,status,reason,\
                           runs,time_median_s,time_min_s,time_max_s,steps,newton_iterations,jacobians,probe,t,x,y";

/// A row of the file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Peer {
    /// Our benchmark of the scene.
    #[serde(skip)]
    pub benchmark: &'static Benchmark,
    /// Everything but the errors.
    pub point: Point,
    /// Options of the program: Newton's tolerance, linear solver.
    pub options: String,
    /// Positions at our sample times; `None` if it failed.
    pub samples: Option<Samples>,
}

/// A line of the file, for errors that name it.
struct Line<'a> {
    file: &'a str,
    number: u64,
    fields: BTreeMap<&'static str, String>,
}

/// Reads a file.
///
/// # Errors
/// [`Error::Read`]; [`Error::Table`] with line, column, value and what is allowed.
pub fn read(path: &Path) -> Result<Vec<Peer>> {
    let text = fs::read_to_string(path).map_err(|source| Error::Read { path: path.into(), source })?;
    parse(&path.display().to_string(), &text)
}

/// Parses the text of a file.
///
/// # Errors
/// [`Error::Table`].
pub fn parse(file: &str, text: &str) -> Result<Vec<Peer>> {
    let refuse = |line, column: &str, value: String, allowed| Error::Table {
        file: file.into(),
        line,
        column: column.into(),
        value,
        allowed,
    };
    let malformed = |error: csv::Error| {
        let line = error.position().map_or(1, csv::Position::line);
        let allowed =
            format!("a line of comma-separated fields, as many as the heading has, in UTF-8; {COMMAND} writes them");
        refuse(line, "line", format!("malformed ({error})"), allowed)
    };
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let heading = reader.headers().map_err(malformed)?.clone();
    let place = |name| {
        let place = heading.iter().position(|column| column == name).map(|place| (name, place));
        place.ok_or_else(|| refuse(1, name, "missing".into(), format!("a heading with {COLUMNS}")))
    };
    let places = COLUMNS.split(',').map(place).collect::<Result<Vec<_>>>()?;
    let mut peers = Vec::new();
    for record in reader.records() {
        let record = record.map_err(malformed)?;
        let number = record.position().map_or(0, csv::Position::line);
        // Pictures are XML, which allows no control characters.
        let fields = places.iter().map(|&(name, place)| (name, escape::line(record.get(place).unwrap_or_default())));
        peers.push(Line { file, number, fields: fields.collect() }.peer()?);
    }
    Ok(peers)
}

impl Line<'_> {
    fn peer(&self) -> Result<Peer> {
        let known = BENCHMARKS.iter().find(|benchmark| benchmark.scene == self.text("scene"));
        let benchmark =
            known.ok_or_else(|| self.refuse("scene", &format!("a scene of the study: {}", scene_names())))?;
        // The other program may name the point or the probe.
        let point = benchmark.point()?;
        if ![benchmark.probe, &point].contains(&self.text("probe")) {
            return Err(self.refuse("probe", &format!("the study's: {}, at the point {point}", benchmark.probe)));
        }
        let failed = match self.text("status") {
            "ok" => false,
            "failed" => true,
            _ => return Err(self.refuse("status", "ok, failed")),
        };
        for column in ["program", "element", "method"] {
            if self.text(column).is_empty() {
                return Err(self.refuse(column, "a name"));
            }
        }
        let [tolerance, modified, solver] =
            ["newton_tolerance", "modified_newton", "linear_solver"].map(|c| self.text(c));
        let has_iteration = !tolerance.is_empty();
        let newton = format!("Newton tolerance {tolerance}, modified Newton {modified}, ");
        let options = if has_iteration { newton + solver } else { solver.into() };
        let (time, samples) =
            if failed { (None, None) } else { (Some(self.timing()?), Some(self.samples(benchmark)?)) };
        let counts = Counts {
            steps: self.count("steps")?.unwrap_or(0),
            newton_iterations: self.count("newton_iterations")?.unwrap_or(0),
            tangent_calls: self.count("jacobians")?.unwrap_or(0),
            ..Counts::default()
        };
        let point = Point {
            program: format!("{} {}", self.text("program"), self.text("version")).trim().into(),
            scene: benchmark.scene.into(),
            element: self.text("element").into(),
            method: self.text("method").into(),
            explicit: !has_iteration,
            elements: self.positive_count("elements")?,
            step: Some(self.positive("step")?),
            newton_tolerance: has_iteration.then(|| self.positive("newton_tolerance")).transpose()?,
            reference_uncertainty: f64::NAN,
            time,
            counts,
            status: if failed { Status::Failed } else { Status::Ok },
            reason: self.text("reason").into(),
            ..Point::default()
        };
        Ok(Peer { benchmark, point, options, samples })
    }

    fn timing(&self) -> Result<Timing> {
        let [median, min, max] = ["time_median_s", "time_min_s", "time_max_s"].map(|column| self.positive(column));
        let (median, min, max) = (median?, min?, max?);
        if !(min <= median && median <= max) {
            return Err(
                self.refuse("time_median_s", &format!("a time between the least, {min}, and the largest, {max}"))
            );
        }
        Ok(Timing { runs: self.positive_count("runs")?, median, min, max })
    }

    /// The positions at our sample times.
    fn samples(&self, benchmark: &Benchmark) -> Result<Samples> {
        let [t, x, y] = ["t", "x", "y"].map(|column| self.list(column));
        let (t, x, y) = (t?, x?, y?);
        for (column, list) in [("x", &x), ("y", &y)] {
            if list.len() != t.len() {
                return Err(self.refuse(column, &format!("as many numbers as `t` has, {}", t.len())));
            }
        }
        let mut position = Vec::new();
        for time in benchmark.times() {
            let near = t.iter().position(|sample| (sample - time).abs() <= 1e-9 * time);
            let place = near.ok_or_else(|| self.refuse("t", &format!("the study's times: {:?}", benchmark.times())))?;
            position.push([x[place], y[place]]);
        }
        Ok(Samples { position, ..Samples::default() })
    }

    fn text(&self, column: &str) -> &str {
        self.fields.get(column).map_or("", String::as_str)
    }

    fn positive(&self, column: &str) -> Result<f64> {
        let number = self.text(column).parse().ok().filter(|x: &f64| x.is_finite() && *x > 0.0);
        number.ok_or_else(|| self.refuse(column, "a number over 0"))
    }

    fn positive_count(&self, column: &str) -> Result<usize> {
        let allowed = "a whole number over 0";
        self.count(column)?.filter(|count| *count > 0).ok_or_else(|| self.refuse(column, allowed))
    }

    /// A count; `None` if the program does not count.
    fn count(&self, column: &str) -> Result<Option<usize>> {
        let count =
            |text: &str| text.parse().map_err(|_| self.refuse(column, "a whole number, not negative, or nothing"));
        Some(self.text(column)).filter(|text| !text.is_empty()).map(count).transpose()
    }

    fn list(&self, column: &str) -> Result<Vec<f64>> {
        let number = |text: &str| text.parse().ok().filter(|x: &f64| x.is_finite());
        let list: Option<Vec<f64>> = self.text(column).split_whitespace().map(number).collect();
        list.filter(|list| !list.is_empty())
            .ok_or_else(|| self.refuse(column, "finite numbers with spaces between them"))
    }

    fn refuse(&self, column: &str, allowed: &str) -> Error {
        let value = match self.text(column) {
            "" => "empty".into(),
            text => format!("`{text}`"),
        };
        Error::Table {
            file: self.file.into(),
            line: self.number,
            column: column.into(),
            value,
            allowed: allowed.into(),
        }
    }
}

impl Peer {
    /// The row with its errors, from the reference of our Euler–Bernoulli element: its theory is the same, and so is its limit.
    pub fn compared(mut self, reference: &Reference) -> Peer {
        self.point.reference_uncertainty = reference.converged.uncertainty;
        if let Some(samples) = &self.samples {
            self.point.compare(samples, 0.0, reference, None);
        }
        self
    }
}
