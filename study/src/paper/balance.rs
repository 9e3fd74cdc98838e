//! The energy balance of a run of the scissors.

use serde::Serialize;

use super::scissors::ScissorsRun;

/// Energy balance of a run.
#[derive(Serialize)]
pub struct Balance {
    pub model: &'static str,
    /// Largest imbalance, and energy put in at the end, J.
    pub largest: f64,
    pub input: f64,
    /// Largest ratio of the two.
    pub bound: f64,
}

/// Bound of the imbalance over the energy put in.
const BALANCE: f64 = 1e-8;

impl Balance {
    pub fn of(model: &'static str, run: &ScissorsRun) -> Balance {
        let [largest, input] = run.energy_balance();
        Balance { model, largest, input, bound: BALANCE }
    }

    /// Whether the balance is within its bound; a NaN is not.
    pub fn holds(&self) -> bool {
        self.largest <= self.bound * self.input
    }
}

impl std::fmt::Display for Balance {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Balance { model, largest, input, bound } = self;
        write!(f, "{model}: energy balance {largest:.1e} J of {input:.1} J put in, bound {bound:.0e} of it")
    }
}
