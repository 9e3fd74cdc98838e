//! What a scene file chooses by a word.

use super::json::words::words;

words! {
    /// Version of the scene file's format.
    pub enum Schema {
        /// The first.
        V1 = "ancf-scene/1",
    }
}

words! {
    /// A direction that a support holds.
    pub enum Direction {
        /// Along the global x axis.
        X = "x",
        /// Along the global y axis.
        Y = "y",
    }
}

words! {
    /// Which element a rod is made of.
    #[derive(Default)]
    pub enum Element {
        /// The paper's: shear deformable, 14 coordinates.
        #[default]
        Ancf = "ancf",
        /// The paper's competitor ([`equations::cable`](crate::equations::cable)): no shear, axial heat, 8 coordinates.
        EulerBernoulli = "euler-bernoulli",
    }
}

words! {
    /// Which form of the paper's element, where the paper is wrong.
    #[derive(Default)]
    pub enum Form {
        /// The energy that is the same in every frame.
        #[default]
        Consistent = "consistent",
        /// The shear counted once, as printed (E3): inclined rods lose stiffness. To compare, and slow.
        PrintedShear = "printed-shear",
    }
}

words! {
    /// Where Poisson's terms act.
    #[derive(Default)]
    pub enum Poisson {
        /// Across the whole section: the paper's element, which locks where ν is not 0.
        #[default]
        Full = "full",
        /// On the rod's axis only ([`equations::axis`](crate::equations::axis)): the cure.
        Axis = "axis",
    }
}

words! {
    /// Which strains heat causes.
    #[derive(Default)]
    pub enum ThermalModel {
        /// Along the rod and across it: ε_T = αΔT I, equation (8). Euler–Bernoulli elements have no section to heat across.
        #[default]
        TwoD = "2d",
        /// Along the rod only: ε_T = αΔT t⊗t with the rod's initial direction t.
        OneD = "1d",
        /// None: the history is ignored.
        None = "none",
    }
}

words! {
    /// How the heat of t = 0 meets the structure.
    #[derive(Default)]
    pub enum Start {
        /// The structure is unstretched at t = 0, so that its thermal stress is there at once.
        #[default]
        Sudden = "sudden",
        /// The structure is at the stress-free stretch: √(1 + 2αΔT(0)), of Euler–Bernoulli elements 1 + αΔT(0).
        Relaxed = "relaxed",
    }
}

words! {
    /// Time-stepping method.
    #[derive(Default)]
    pub enum Method {
        /// Chung and Hulbert's generalized-α with the spectral radius ρ∞.
        #[default]
        GeneralizedAlpha = "generalized-alpha",
        /// Mid-point rule with the step-averaged stress; keeps the energy exactly.
        EnergyMomentum = "energy-momentum",
        /// Velocity Verlet; its step is limited by the largest frequency.
        Explicit = "explicit",
        /// Gauss collocation with two stages: implicit, of order four.
        Gauss = "gauss",
        /// Dormand, El-Mikkawy and Prince's Runge–Kutta–Nyström method: explicit, of order four.
        Nystrom = "nystrom",
        /// The same as "gauss", with steps as long as `tolerance` allows.
        GaussAdaptive = "gauss-adaptive",
        /// The same as "nystrom", with steps as long as `tolerance` allows.
        NystromAdaptive = "nystrom-adaptive",
        /// No motion: equilibrium as loads and heat grow from nothing to their full size.
        Static = "static",
    }
}

impl Method {
    /// Whether accelerations come from the equation of motion alone, without a system of equations in the stiffness.
    pub fn is_explicit(self) -> bool {
        matches!(self, Method::Explicit | Method::Nystrom | Method::NystromAdaptive)
    }

    /// Whether it chooses its own steps.
    pub fn is_adaptive(self) -> bool {
        matches!(self, Method::GaussAdaptive | Method::NystromAdaptive)
    }
}

words! {
    /// How pins and supports are kept.
    #[derive(Default)]
    pub enum Constraints {
        /// Pinned points share their coordinates, and held ones have none: there are no multipliers.
        #[default]
        Condensed = "condensed",
        /// Equation (23): every rod has its own coordinates, and Lagrange's multipliers keep the constraints.
        Multipliers = "multipliers",
    }
}

words! {
    /// What a probe records.
    pub enum Quantity {
        /// Position, m.
        Position = "position",
        /// Velocity, m/s.
        Velocity = "velocity",
        /// Acceleration from the equation of motion, m/s². After a sudden load its value at an instant does not converge with
        /// the mesh.
        Acceleration = "acceleration",
        /// Force of a support on the structure, or all that acts on one rod at the point but its weight (other rods, supports
        /// and point forces), N. At an instant it converges no better than an acceleration.
        Reaction = "reaction",
        /// Distance of a rod's axis from the chord through its ends, m, positive to the left of from → to.
        Deflection = "deflection",
    }
}

impl Quantity {
    /// How the names of its columns end.
    pub(crate) fn suffixes(self) -> &'static [&'static str] {
        match self {
            Quantity::Position => &["x", "y"],
            Quantity::Velocity => &["vx", "vy"],
            Quantity::Acceleration => &["ax", "ay"],
            Quantity::Reaction => &["rx", "ry"],
            Quantity::Deflection => &["w"],
        }
    }
}

/// Whether a value is the one that a scene file may leave out.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
