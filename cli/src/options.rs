//! What `ancf run` is asked for beside the run itself.

/// Options of a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Estimate the errors.
    pub estimate: bool,
    /// Write `report.html`.
    pub page: bool,
    /// Write files for ParaView.
    pub vtk: bool,
    /// Changes of the scene, for its summary.
    pub set: &'a [String],
}
