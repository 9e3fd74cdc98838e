//! Named points, and the rods' nodes there.

/// Named point of the scene.
#[derive(Clone, Debug)]
pub struct Point {
    pub initial: [f64; 2],
    /// Nodes of the rods that meet there, in the scene's order.
    pub nodes: Vec<Node>,
}

/// Node of a rod at a point: indices in the rod's chain of its position, and of the slope that turns with the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub rod: usize,
    pub position: usize,
    pub slope: usize,
}
