//! Axes and surfaces of the rods over time for ParaView: a collection (PVD) for each, and a file (VTU) for each instant.

use std::fmt::Write as _;
use std::io::{self, Write};

use ancf::model::Scene;
use ancf::run::AxisPoint;
use vtkio::IOBuffer;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataArray, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};

use crate::frames::{Frame, Frames};

/// What is written of the rods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A line along each rod.
    Axis,
    /// Each rod as a strip of its height, divided along its axis.
    Surface,
}

impl Part {
    /// All parts.
    pub const ALL: [Part; 2] = [Part::Axis, Part::Surface];

    /// Name of the collection, to be opened in ParaView.
    pub fn collection(self) -> &'static str {
        match self {
            Part::Axis => "axis.pvd",
            Part::Surface => "surface.pvd",
        }
    }

    /// Beginning and end of the names of the files of instants, with a number between them.
    pub const fn series(self) -> (&'static str, &'static str) {
        match self {
            Part::Axis => ("axis.", ".vtu"),
            Part::Surface => ("surface.", ".vtu"),
        }
    }

    /// Name of the file of an instant.
    pub fn file(self, instant: usize) -> String {
        let (begin, end) = self.series();
        format!("{begin}{instant:05}{end}")
    }

    /// Text of the collection.
    pub fn collection_text(self, frames: &Frames) -> String {
        let mut text = String::from("<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n");
        for (n, frame) in frames.list.iter().enumerate() {
            let file = self.file(n);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "    <DataSet timestep=\"{:?}\" part=\"0\" file=\"{file}\"/>", frame.t);
        }
        text + "  </Collection>\n</VTKFile>\n"
    }

    /// Writes the file of an instant; `id` is that of the run's table.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn write(self, out: &mut dyn Write, id: &str, scene: &Scene, frame: &Frame) -> io::Result<()> {
        writeln!(out, "<!-- run {id} -->")?;
        let file = Vtk {
            version: Version::new_xml(1, 0),
            title: String::new(),
            byte_order: ByteOrder::LittleEndian,
            file_path: None,
            data: DataSet::inline(self.grid(scene, frame)),
        };
        file.write_xml(&mut *out).map_err(io::Error::other)?;
        writeln!(out)
    }

    fn grid(self, scene: &Scene, frame: &Frame) -> UnstructuredGridPiece {
        let (mut cells, mut types, mut rods) = (Vec::new(), Vec::new(), Vec::new());
        let mut points = Vec::new();
        for (n, (rod, axis)) in scene.rods.iter().zip(&frame.rods).enumerate() {
            let first = points.len() as u64;
            let count = axis.len() as u64;
            match self {
                Part::Axis => {
                    points.extend(axis.iter().map(|point| (point, 0.0)));
                    cells.push((first..first + count).collect());
                    types.push(CellType::PolyLine);
                    rods.push(n as u32);
                }
                Part::Surface => {
                    let half = 0.5 * scene.section(rod).height;
                    points.extend(axis.iter().flat_map(|point| [(point, -half), (point, half)]));
                    let corners = |k: u64| [0, 2, 3, 1].map(|corner| first + 2 * k + corner).to_vec();
                    cells.extend((0..count - 1).map(corners));
                    types.extend((0..count - 1).map(|_| CellType::Quad));
                    rods.extend((0..count - 1).map(|_| n as u32));
                }
            }
        }
        let of = |name: &str, read: fn(&AxisPoint) -> f64| {
            let values: Vec<f64> = points.iter().map(|(point, _)| read(point)).collect();
            Attribute::DataArray(DataArray::scalars(name, 1).with_vec(values))
        };
        let point = vec![
            of("temperature change (K)", |point| point.temperature),
            of("axial strain", |point| point.strain),
            of("elastic axial strain", |point| point.strain - point.thermal_strain),
            of("curvature (1/m)", |point| point.curvature),
        ];
        let cell = vec![Attribute::DataArray(DataArray::scalars("rod", 1).with_vec(rods))];
        let place = |(point, y): &(&AxisPoint, f64)| {
            let [x, own] = [0, 1].map(|axis| point.position[axis] + y * point.director[axis]);
            [x, own, 0.0]
        };
        UnstructuredGridPiece {
            points: IOBuffer::F64(points.iter().flat_map(place).collect()),
            cells: Cells { cell_verts: vertex_numbers(&cells), types },
            data: Attributes { point, cell },
        }
    }
}

/// Points of the cells, one after another, and where each of them ends.
fn vertex_numbers(cells: &[Vec<u64>]) -> VertexNumbers {
    let ends = cells.iter().scan(0, |end, cell| {
        *end += cell.len() as u64;
        Some(*end)
    });
    VertexNumbers::XML { connectivity: cells.concat(), offsets: ends.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_in_order() {
        assert_eq!(Part::ALL.map(|part| part.file(7)), ["axis.00007.vtu", "surface.00007.vtu"]);
    }
}
