//! The methods of the study, one line each.

use ancf::model::Method;

/// How a method is made more accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refinement {
    /// Half the step.
    Steps,
    /// A tenth of `time.tolerance`, starting with this one, m; a tenth of the interval is the largest step.
    Tolerance(f64),
    /// Twice the load steps.
    LoadSteps,
}

/// A method, with Newton's tolerance and the way it is refined.
#[derive(Debug, PartialEq)]
pub struct Technique {
    /// The method.
    pub method: Method,
    /// Newton's tolerance.
    pub newton_tolerance: f64,
    /// How it is made more accurate.
    pub refinement: Refinement,
    /// Whether the largest frequency limits its step; it starts at that limit.
    pub explicit: bool,
    /// Its order.
    pub order: i32,
}

/// An implicit method of fixed steps.
const fn implicit(method: Method, newton_tolerance: f64, order: i32) -> Technique {
    Technique { method, newton_tolerance, refinement: Refinement::Steps, explicit: false, order }
}

/// Newton's tolerance of methods without an iteration: any.
const NO_NEWTON: f64 = 1e-10;

/// All methods. Generalized-α has one tolerance of Newton's iteration for coarse results and one for fine ones.
pub const TECHNIQUES: [Technique; 9] = [
    implicit(Method::GeneralizedAlpha, 1e-3, 2),
    implicit(Method::GeneralizedAlpha, 1e-5, 2),
    implicit(Method::EnergyMomentum, 1e-4, 2),
    implicit(Method::Gauss, 1e-5, 4),
    Technique { refinement: Refinement::Tolerance(1e-2), ..implicit(Method::GaussAdaptive, 1e-5, 4) },
    Technique { explicit: true, ..implicit(Method::Explicit, NO_NEWTON, 2) },
    Technique { explicit: true, ..implicit(Method::Nystrom, NO_NEWTON, 4) },
    Technique {
        explicit: true,
        refinement: Refinement::Tolerance(1e-3),
        ..implicit(Method::NystromAdaptive, NO_NEWTON, 4)
    },
    Technique { refinement: Refinement::LoadSteps, ..implicit(Method::Static, 1e-10, 0) },
];

impl Technique {
    /// The technique of a method.
    pub fn of(method: Method) -> Option<&'static Technique> {
        TECHNIQUES.iter().find(|technique| technique.method == method)
    }

    /// The first technique of each method.
    pub fn of_each_method() -> impl Iterator<Item = &'static Technique> + Clone {
        TECHNIQUES.iter().filter(|technique| Technique::of(technique.method) == Some(*technique))
    }

    /// Whether it is statics.
    pub fn is_static(&self) -> bool {
        self.refinement == Refinement::LoadSteps
    }
}
