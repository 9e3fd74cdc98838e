//! A picture of the main job.

/// A picture with its file name and a caption.
pub struct Picture {
    pub file: &'static str,
    /// What it shows, in words.
    pub caption: &'static str,
    pub svg: String,
}
