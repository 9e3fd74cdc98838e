//! Named points, and the nodes of rods there.

/// A named point of the scene.
#[derive(Clone, Debug)]
pub struct Point {
    pub start: [f64; 2],
    /// Its node in each of the rods that meet there, in the scene's order.
    pub nodes: Vec<Node>,
}

/// A rod's node at a point: places in the rod's chain of its position and of the slope that turns with the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub rod: usize,
    pub position: usize,
    pub slope: usize,
}
