//! What is simulated: a scene, and where a mistake departs from it.

use ancf::model::{Scene, Start};

/// A scene with the departures that a scene file has no words for. Without them it is the paper's.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Rods, supports, loads and heat. Method and step are ignored.
    pub scene: Scene,
    /// The elements' law.
    pub law: Law,
    /// Factors of the thermal strain along and across the rod.
    pub heat: [f64; 2],
    /// Time over which all heat grows linearly to its history, s; 0 for none.
    pub ramp: f64,
    /// The elements' mass.
    pub mass: Mass,
    /// How the blocks of neighbouring elements are put together in the mass.
    pub mass_blocks: Blocks,
    /// How they are put together in the elastic force.
    pub force_blocks: Blocks,
    /// How they are put together in the weight.
    pub weight_blocks: Blocks,
    /// Weight, by node.
    pub weight: Weight,
    /// Point at which rods are joined otherwise than by a pin.
    pub joint: Option<(String, Joint)>,
    /// Point where the whole vector r_y is held (r_x of a cable).
    pub held_section: Option<String>,
    /// Damping force per mass and velocity, 1/s.
    pub mass_damping: f64,
    /// Kelvin and Voigt's time of retardation of the paper's element, s.
    pub retardation: f64,
    /// Stiffness of springs in place of fixed supports, N/m.
    pub support_springs: Option<f64>,
    /// Time by which loads and heat lag behind, s.
    pub delay: f64,
    /// Stretch of the start; 1 for the scene's own.
    pub start_at_rest: StartStretch,
}

/// Factors of parts of the law.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    /// Stiffness along the rod.
    pub along: f64,
    /// Stiffness across it.
    pub across: f64,
    /// Shear stiffness.
    pub shear: f64,
    /// Coupling λ of both directions.
    pub coupling: f64,
    /// Distance of fibres from the axis; its square is that of the second moment of area.
    pub depth: f64,
    /// That distance in the mass.
    pub depth_of_mass: f64,
    /// E3: the shear of the *global* axes counted once.
    pub printed_shear: bool,
    /// Strains linear in the displacement, in the initial axes.
    pub linear: bool,
    /// Gauss points along and across.
    pub points: [usize; 2],
}

/// The elements' mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mass {
    /// (7).
    Consistent,
    /// Diagonal of (7), scaled so that positions carry the rod's mass.
    ScaledDiagonal,
    /// Diagonal of (7) as it is.
    Diagonal,
}

/// Assembly at the nodes that neighbouring elements share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blocks {
    /// Added up.
    Added,
    /// The last element's replaces the others'.
    Last,
    /// The first element's is kept.
    First,
    /// The last element's is added twice.
    Twice,
    /// One element is left out, by its number in the rod.
    Without(usize),
}

/// Distribution of the weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Weight {
    /// That of the shape functions.
    Consistent,
    /// Half of each element's on each of its ends.
    HalfOnEnds,
    /// All of a rod's weight at its last point.
    AtTheEnd,
}

/// Joint of rods at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Joint {
    /// None.
    Open,
    /// Only the coordinate x is equal.
    OnlyX,
    /// Only the coordinate y is equal.
    OnlyY,
    /// The sections keep their angle as well.
    Welded,
}

/// Initial stretch of a relaxed start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartStretch {
    /// Free of stress.
    Scene,
    /// Free of stress along the rod; not stretched across.
    AlongOnly,
}

impl Blocks {
    /// Factor of an element's entry `n` of `size`. The first and the last four are shared with the neighbours.
    pub fn share(self, element: usize, elements: usize, n: usize, size: usize) -> f64 {
        let with_last = element > 0 && n < 4;
        let with_next = element + 1 < elements && n + 4 >= size;
        match self {
            Blocks::Last if with_next => 0.0,
            Blocks::First if with_last => 0.0,
            Blocks::Twice if with_last => 2.0,
            Blocks::Without(left_out) if left_out == element => 0.0,
            _ => 1.0,
        }
    }

    /// Factor of an entry of an element's matrix: blocks between different nodes are shared with nobody.
    pub fn share_of_matrix(self, element: usize, elements: usize, [i, j]: [usize; 2], size: usize) -> f64 {
        let same_node = i < 4 && j < 4 || i + 4 >= size && j + 4 >= size;
        let left_out = self == Blocks::Without(element);
        if same_node || left_out { self.share(element, elements, i, size) } else { 1.0 }
    }
}

impl Law {
    /// The paper's.
    pub const PAPER: Law = Law {
        along: 1.0,
        across: 1.0,
        shear: 1.0,
        coupling: 1.0,
        depth: 1.0,
        depth_of_mass: 1.0,
        printed_shear: false,
        linear: false,
        points: [5, 3],
    };
}

impl Setup {
    /// Whether heat acts at once at t = 0, which excites waves that take short steps.
    pub fn is_suddenly_heated(&self) -> bool {
        let mut heats = self.scene.rods.iter().filter_map(|rod| self.scene.heat(rod));
        self.ramp == 0.0 && heats.any(|heat| heat.start == Start::Sudden && heat.at(0.0) != 0.0)
    }

    /// A scene as it is.
    pub fn of(scene: Scene) -> Setup {
        Setup {
            scene,
            law: Law::PAPER,
            heat: [1.0; 2],
            ramp: 0.0,
            mass: Mass::Consistent,
            mass_blocks: Blocks::Added,
            force_blocks: Blocks::Added,
            weight_blocks: Blocks::Added,
            weight: Weight::Consistent,
            joint: None,
            held_section: None,
            mass_damping: 0.0,
            retardation: 0.0,
            support_springs: None,
            delay: 0.0,
            start_at_rest: StartStretch::Scene,
        }
    }
}
