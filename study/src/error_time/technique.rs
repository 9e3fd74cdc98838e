//! The methods of the study: a line each.

use ancf::model::Method;

/// How a method is made more accurate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// By half the step.
    Steps,
    /// By a tenth of `time.tolerance`, from the first one given, m; the sample interval is the largest step.
    Tolerances(f64),
    /// By twice the load steps.
    LoadSteps,
}

/// A method, and how it is driven.
#[derive(Debug, PartialEq)]
pub struct Technique {
    /// The method.
    pub method: Method,
    /// Where Newton's iteration ends.
    pub newton_tolerance: f64,
    /// How it is made more accurate.
    pub drive: Drive,
    /// Whether its step is limited by the largest frequency, where it begins then.
    pub explicit: bool,
    /// Its order.
    pub order: i32,
}

/// A method of Newton's tolerance `newton_tolerance`.
const fn implicit(method: Method, newton_tolerance: f64, order: i32) -> Technique {
    Technique { method, newton_tolerance, drive: Drive::Steps, explicit: false, order }
}

/// Newton's tolerance of methods that have no iteration: any.
const NO_NEWTON: f64 = 1e-10;

/// All methods. A new one is a line here, and maybe a witness of [`CASES`](super::case::CASES). Generalized-α comes with a tolerance
/// of Newton's iteration that is good for coarse results and with one for fine ones.
pub const TECHNIQUES: [Technique; 9] = [
    implicit(Method::GeneralizedAlpha, 1e-3, 2),
    implicit(Method::GeneralizedAlpha, 1e-5, 2),
    implicit(Method::EnergyMomentum, 1e-4, 2),
    implicit(Method::Gauss, 1e-5, 4),
    Technique { drive: Drive::Tolerances(1e-2), ..implicit(Method::GaussAdaptive, 1e-5, 4) },
    Technique { explicit: true, ..implicit(Method::Explicit, NO_NEWTON, 2) },
    Technique { explicit: true, ..implicit(Method::Nystrom, NO_NEWTON, 4) },
    Technique { explicit: true, drive: Drive::Tolerances(1e-3), ..implicit(Method::NystromAdaptive, NO_NEWTON, 4) },
    Technique { drive: Drive::LoadSteps, ..implicit(Method::Static, 1e-10, 0) },
];

impl Technique {
    /// The technique of a method.
    pub fn of(method: Method) -> Option<&'static Technique> {
        TECHNIQUES.iter().find(|technique| technique.method == method)
    }

    /// The first technique of each method.
    pub fn of_each_method() -> impl Iterator<Item = &'static Technique> {
        TECHNIQUES.iter().filter(|technique| Technique::of(technique.method) == Some(*technique))
    }

    /// Whether it is for slow loads.
    pub fn is_static(&self) -> bool {
        self.drive == Drive::LoadSteps
    }
}

/// Whether a method of this name is explicit; those that are not ours are none.
pub fn is_explicit(name: &str) -> bool {
    TECHNIQUES.iter().any(|technique| technique.explicit && technique.method.word() == name)
}
