//! Choices that a scene file makes by a word.

use super::json::words::words;

words! {
    /// Version of the scene file format.
    pub enum Schema {
        /// First version.
        V1 = "ancf-scene/1",
    }
}

words! {
    /// Direction held by a support.
    pub enum Direction {
        /// Along the global x axis.
        X = "x",
        /// Along the global y axis.
        Y = "y",
    }
}

words! {
    /// Element type of a rod.
    #[derive(Default)]
    pub enum Element {
        /// Element of the paper: shear deformable, 14 coordinates.
        #[default]
        Ancf = "ancf",
        /// Euler–Bernoulli element that the paper compares with ([`equations::cable`](crate::equations::cable)): no
        /// shear, axial heat, 8 coordinates.
        EulerBernoulli = "euler-bernoulli",
    }
}

words! {
    /// Form of the paper's element where the paper has an error.
    #[derive(Default)]
    pub enum Form {
        /// Consistent form: the energy is the same in every frame.
        #[default]
        Consistent = "consistent",
        /// Shear counted once, as printed (E3): inclined rods lose stiffness. For comparison, and slow.
        PrintedShear = "printed-shear",
    }
}

words! {
    /// Where Poisson's terms act.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum Poisson {
        /// In the whole section: the paper's element, which locks for ν ≠ 0.
        #[default]
        Full = "full",
        /// On the rod's axis only ([`equations::axis`](crate::equations::axis)): cures the locking. The rod stays one in
        /// plane strain: a slender one deflects by 1 − ν² of what a strut with free sides does (`"law": "uniaxial"`).
        Axis = "axis",
    }
}

words! {
    /// Law between stress and strain of the paper's element.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum Law {
        /// Plane strain, equation (16): a rod that is held across the plane, as a strip of a wide plate is.
        #[default]
        PlaneStrain = "plane-strain",
        /// Uniaxial stress ([`equations::uniaxial`](crate::equations::uniaxial)): a strut with free sides. E along and
        /// across, G = E/2(1+ν) in shear, no Poisson contraction; does not lock.
        Uniaxial = "uniaxial",
    }
}

words! {
    /// Strains caused by heat.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum ThermalModel {
        /// Along and across the rod: ε_T = αΔT I, equation (8). Euler–Bernoulli elements have no section to heat
        /// across; by the law "uniaxial" heat across changes the section's height alone.
        #[default]
        TwoD = "2d",
        /// Along the rod only: ε_T = αΔT t⊗t with the rod's initial direction t.
        OneD = "1d",
        /// Across the rod only: ε_T = αΔT n⊗n with n across the rod's initial direction, what "2d" adds to "1d". It
        /// thickens the section, which changes inertia and stiffness in bending. Not for Euler–Bernoulli elements.
        Transverse = "transverse",
        /// No strain: the history is ignored.
        None = "none",
    }
}

words! {
    /// State of the structure under the heat of t = 0.
    #[derive(Default)]
    pub enum Start {
        /// Unstretched at t = 0: thermal stress appears at once.
        #[default]
        Sudden = "sudden",
        /// At the stress-free stretch: √(1 + 2αΔT(0)), or 1 + αΔT(0) for Euler–Bernoulli elements.
        Relaxed = "relaxed",
    }
}

words! {
    /// Time-stepping method, or statics.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum Method {
        /// Chung and Hulbert's generalized-α with the spectral radius ρ∞.
        #[default]
        GeneralizedAlpha = "generalized-alpha",
        /// Energy–momentum rule: mid-point rule with the step-averaged stress; conserves energy exactly.
        EnergyMomentum = "energy-momentum",
        /// Velocity Verlet; the largest frequency limits the step.
        Explicit = "explicit",
        /// Gauss collocation with two stages: implicit, fourth order.
        Gauss = "gauss",
        /// Runge–Kutta–Nyström method of Dormand, El-Mikkawy and Prince: explicit, fourth order.
        Nystrom = "nystrom",
        /// Gauss collocation with adaptive steps: as long as `tolerance` allows.
        GaussAdaptive = "gauss-adaptive",
        /// Runge–Kutta–Nyström with adaptive steps: as long as `tolerance` allows.
        NystromAdaptive = "nystrom-adaptive",
        /// Statics: equilibrium under loads and heat that grow from zero to their full size.
        Static = "static",
    }
}

words! {
    /// What statics steps along.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum LoadPath {
        /// Load factor: it grows to 1 in equal steps. Ends in an error at a limit point, where a structure snaps through.
        #[default]
        Load = "load",
        /// Length of the path of equilibria (Riks 1979): the load factor is a result, the column `load`, and may fall.
        ArcLength = "arc-length",
    }
}

impl ThermalModel {
    /// Strains along and across a rod of what would be `strain` = αΔT in a free body.
    pub fn strains(self, strain: f64) -> [f64; 2] {
        match self {
            ThermalModel::TwoD => [strain, strain],
            ThermalModel::OneD => [strain, 0.0],
            ThermalModel::Transverse => [0.0, strain],
            ThermalModel::None => [0.0; 2],
        }
    }
}

impl Direction {
    /// Unit vector of the direction.
    pub(crate) fn unit(self) -> [f64; 2] {
        match self {
            Direction::X => [1.0, 0.0],
            Direction::Y => [0.0, 1.0],
        }
    }
}

impl Method {
    /// Whether the method is explicit: accelerations follow from the equation of motion without solving a system with
    /// the stiffness.
    pub fn is_explicit(self) -> bool {
        matches!(self, Method::Explicit | Method::Nystrom | Method::NystromAdaptive)
    }

    /// Whether the method chooses its steps by an error estimate.
    pub fn is_adaptive(self) -> bool {
        matches!(self, Method::GaussAdaptive | Method::NystromAdaptive)
    }
}

words! {
    /// How pins and supports are enforced.
    #[derive(Default)]
    #[non_exhaustive]
    pub enum Constraints {
        /// Pinned points share coordinates and held coordinates are removed; there are no multipliers.
        #[default]
        Condensed = "condensed",
        /// Equation (23): every rod has its own coordinates, and Lagrange multipliers enforce the constraints.
        Multipliers = "multipliers",
    }
}

words! {
    /// Quantity that a probe records.
    #[non_exhaustive]
    pub enum Quantity {
        /// Position, m.
        Position = "position",
        /// Velocity, m/s.
        Velocity = "velocity",
        /// Acceleration from the equation of motion, m/s². After a sudden load its instantaneous value does not
        /// converge with the mesh.
        Acceleration = "acceleration",
        /// Reaction, N: force of the supports on the structure. On one rod: the force of all others at the point (rods,
        /// supports, point forces), without its weight. An instantaneous value converges no better than an
        /// acceleration.
        Reaction = "reaction",
        /// Deflection, m: distance of a rod's axis from the chord through its ends, positive to the left of from → to.
        Deflection = "deflection",
    }
}

impl Quantity {
    /// Endings of its column names.
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

/// Whether a value is the default, which a scene file may leave out.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}
