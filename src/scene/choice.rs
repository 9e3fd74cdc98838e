//! What a scene file chooses by a word.

use super::words::words;

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
    /// Which strains heat causes.
    #[derive(Default)]
    pub enum ThermalModel {
        /// Along the rod and across it: ε_T = αΔT I, equation (8).
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
        /// The structure is at the stress-free stretch √(1 + 2αΔT(0)).
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
    }
}

words! {
    /// What a probe records.
    pub enum Quantity {
        /// Position, m.
        Position = "position",
        /// Velocity, m/s.
        Velocity = "velocity",
        /// Acceleration, m/s².
        Acceleration = "acceleration",
    }
}

impl Quantity {
    /// How the names of its two columns end.
    pub fn suffixes(self) -> [&'static str; 2] {
        match self {
            Quantity::Position => ["x", "y"],
            Quantity::Velocity => ["vx", "vy"],
            Quantity::Acceleration => ["ax", "ay"],
        }
    }
}
