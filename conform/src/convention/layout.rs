//! Layout of the nodal coordinates: order of the vectors, order of the components, and slopes.

use super::components::Components;
use super::order;
use super::slopes::Slope;

/// Names of the element's nodal vectors in the order of (4).
pub(super) const ELEMENT: [&str; 7] = ["r_i", "r_y_i", "r_j", "r_x_j", "r_y_j", "r_k", "r_y_k"];
/// Names of the cable's nodal vectors in the order of `cable.json`.
pub(super) const CABLE: [&str; 4] = ["r_i", "r_x_i", "r_k", "r_x_k"];

/// Layout of a program's nodal coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Names of the vectors in the order of the fixtures.
    pub(super) names: &'static [&'static str],
    /// Index in the program's e → index in the fixtures'.
    pub(super) order: Vec<usize>,
    /// Place of x and y.
    pub(super) components: Components,
    /// What r_x and r_y are multiplied by.
    pub(super) slopes: [Slope; 2],
}

impl Layout {
    pub(super) fn of_the_element() -> Layout {
        Layout::of(&ELEMENT)
    }

    pub(super) fn of_the_cable() -> Layout {
        Layout::of(&CABLE)
    }

    fn of(names: &'static [&'static str]) -> Layout {
        let order = (0..names.len()).collect();
        Layout { names, order, components: Components::default(), slopes: Default::default() }
    }

    /// Whether it is that of the fixtures.
    pub(super) fn is_usual(&self) -> bool {
        *self == Layout::of(self.names)
    }

    /// Factor of the fixtures' vector `k` in the program's e.
    pub(super) fn factor(&self, k: usize, l: f64, h: f64) -> f64 {
        let [along, across] = self.slopes;
        match self.names.get(k) {
            Some(name) if name.starts_with("r_x") => along.factor(l, h),
            Some(name) if name.starts_with("r_y") => across.factor(l, h),
            _ => 1.0,
        }
    }

    /// Words for what differs from the fixtures, by key of `hello`.
    pub(super) fn differences(&self) -> Vec<(&'static str, String)> {
        let usual = Layout::of(self.names);
        let is_cable = self.names.len() == CABLE.len();
        let mut all = Vec::new();
        if self.order != usual.order {
            let (name, of) = if is_cable { ("cable_order", " of the cable") } else { ("order", "") };
            all.push((name, format!("order of the nodal vectors{of}: {}", order::words(&self.order, self.names))));
        }
        let of = if is_cable { ", cable" } else { "" };
        if self.components != usual.components {
            all.push(("components", format!("all x, then all y in e{of}")));
        }
        if self.slopes != usual.slopes {
            let [along, across] = self.slopes;
            let words = match (along, across) {
                (Slope::HalfLength, Slope::HalfHeight) => "slopes by ξ and η from −1 to 1: ",
                (Slope::Length, _) => "slopes by ξ from 0 to 1: ",
                _ => "slopes by another parameter: ",
            };
            let term = |slope: Slope, name: &str| match slope {
                Slope::One => name.to_string(),
                slope => format!("{} {name}", slope.name()),
            };
            let terms = if is_cable {
                term(along, "r_x")
            } else {
                format!("{} and {}", term(along, "r_x"), term(across, "r_y"))
            };
            all.push(("slopes", format!("{words}{terms} in e{of}")));
        }
        all
    }
}
