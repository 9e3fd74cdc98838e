//! Output files of a run: data with every digit, so that its numbers read back to the same `f64`, and a page to look at.

use std::path::PathBuf;

use ancf::error::Error;
use ancf::model::Scene;
use ancf::run::Run;
use ancf_study::files::{Files, Series};

use crate::error::Result;
use crate::frames::Frames;
use crate::options::Options;
use crate::page::page_text;
use crate::shapes::write_shapes;
use crate::summary::{Summary, line, write_summary};
use crate::vtk::Part;

/// Table of a run, and of one that failed.
const TABLES: [&str; 2] = ["trajectory.csv", "trajectory.partial.csv"];

/// Files that a run may write; those that it does not write are removed with the earlier run's files.
pub const FILES: [&str; 7] =
    [TABLES[0], TABLES[1], "summary.json", "shapes.json", "report.html", "axis.pvd", "surface.pvd"];

/// Numbered files that a run may write.
pub const NUMBERED: [Series; 2] = [Part::Axis.series(), Part::Surface.series()];

/// Output of a run of a scene, with the frames that its files need.
#[derive(Debug)]
pub struct Output<'a> {
    scene: &'a Scene,
    /// Frames of the page, and of files for ParaView where there are no shapes.
    seen: Option<Frames>,
    shapes: Option<Frames>,
    options: Options<'a>,
}

/// What was written of a run.
pub struct Written {
    pub paths: Vec<PathBuf>,
    /// The summary in one line.
    pub line: String,
}

impl<'a> Output<'a> {
    /// Output of a run that has not begun. Files for ParaView have the instants and points of `output.shapes` where the scene asks for them,
    /// otherwise those of the page.
    pub fn new(scene: &'a Scene, options: Options<'a>) -> Output<'a> {
        let shapes = Frames::for_shapes(scene);
        let seen = (options.page || (options.vtk && shapes.is_none())).then(|| Frames::for_page(scene));
        Output { scene, seen, shapes, options }
    }

    /// Frames to be taken while the run goes on.
    pub fn frames(&mut self) -> impl Iterator<Item = &mut Frames> {
        self.seen.iter_mut().chain(&mut self.shapes)
    }

    /// Writes all files of the run; `error` ended the run.
    ///
    /// # Errors
    /// [`Error::Write`](ancf_study::error::Error::Write); the earlier files are untouched then.
    pub fn write(&self, mut files: Files, run: &Run, error: Option<&Error>, wall_seconds: f64) -> Result<Written> {
        let scene = self.scene;
        files.write_table(TABLES[usize::from(error.is_some())], |out| run.trajectory.write_csv(out))?;
        let id = files.run_id();
        let summary = Summary::of(&id, scene, self.options.set, run, error, wall_seconds);
        files.write("summary.json", |out| write_summary(out, &summary))?;
        if let Some(shapes) = &self.shapes {
            files.write("shapes.json", |out| write_shapes(out, &id, scene, shapes))?;
        }
        if let Some(frames) = self.seen.as_ref().filter(|_| self.options.page) {
            files.write_text("report.html", page_text(&summary, scene, &run.trajectory, frames))?;
        }
        if let Some(frames) = self.shapes.as_ref().or(self.seen.as_ref()).filter(|_| self.options.vtk) {
            for part in Part::ALL {
                files.write_text(part.collection(), part.collection_text(frames))?;
                for (n, frame) in frames.list.iter().enumerate() {
                    files.write(&part.file(n), |out| part.write(out, &id, scene, frame))?;
                }
            }
        }
        let line = line(&summary);
        Ok(Written { paths: files.publish()?, line })
    }
}
