//! Newton's iteration on one equation with one unknown: x + x³ = load.

use super::*;

/// The equation, with a record of what the iteration did.
struct Cubic {
    x: f64,
    load: f64,
    slope: f64,
    improvement: f64,
    /// Iterates at which matrices were made.
    matrices: Vec<f64>,
    undone: usize,
}

impl Cubic {
    fn value(&self) -> f64 {
        self.x + self.x.powi(3) - self.load
    }
}

impl Equations for Cubic {
    fn residual(&mut self, _: &mut Counts) -> Residual {
        Residual { size: self.value().abs(), largest_term: self.load.abs() }
    }

    fn at_rounding(&self, _: f64) -> bool {
        false
    }

    fn factorize(&mut self) -> std::result::Result<(), SingularAt> {
        self.matrices.push(self.x);
        self.slope = 1.0 + 3.0 * self.x.powi(2);
        Ok(())
    }

    fn improve(&mut self) {
        self.improvement = self.value() / self.slope;
        self.x -= self.improvement;
    }

    fn undo(&mut self) {
        self.undone += 1;
        self.x += self.improvement;
    }
}

/// Solves from `x` for `load` and returns the equation; `slope` carries the last matrix from call to call.
fn solve(newton: &mut Newton, slope: &mut f64, x: f64, load: f64) -> Cubic {
    let mut equation = Cubic { x, load, slope: *slope, improvement: 0.0, matrices: Vec::new(), undone: 0 };
    let mut counts = Counts::default();
    newton.solve(&mut equation, &mut counts).unwrap();
    assert!(equation.value().abs() <= 1e-12 * load);
    assert_eq!((counts.factorizations, counts.tangent_calls), (equation.matrices.len(), equation.matrices.len()));
    assert_eq!(counts.newton_iterations, counts.solves);
    *slope = equation.slope;
    equation
}

/// A matrix is reused where the residual shrinks fast with it.
#[test]
fn a_good_matrix_is_kept() {
    let (mut newton, mut slope) = (Newton::new(1e-12), f64::NAN);
    assert_eq!(solve(&mut newton, &mut slope, 0.0, 1e-6).matrices, [0.0]);
    assert!(solve(&mut newton, &mut slope, 1e-6, 2e-6).matrices.is_empty());
    newton.forget();
    assert_eq!(solve(&mut newton, &mut slope, 2e-6, 3e-6).matrices, [2e-6]);
    let mut always = Newton::with_new_matrices(1e-12);
    solve(&mut always, &mut slope, 0.0, 1e-6);
    // The second iteration makes one as well.
    assert_eq!(solve(&mut always, &mut slope, 1e-6, 2e-6).matrices.len(), 2);
}

/// A reused matrix of x = 0 throws the iterate from 10 to −490. It goes back, and the next matrix is made where it was,
/// after which it proceeds as plain Newton. The next nine steps begin with a matrix of their own, the tenth with that
/// of the step before.
#[test]
fn a_bad_matrix_is_taken_back() {
    let (mut newton, mut slope) = (Newton::new(1e-12), f64::NAN);
    solve(&mut newton, &mut slope, 0.0, 1e-6);
    let reused = solve(&mut newton, &mut slope, 10.0, 510.0);
    assert_eq!(reused.undone, 1);
    assert!((reused.matrices[0] - 10.0).abs() <= 1e-12, "{:?}", reused.matrices);
    let plain = solve(&mut Newton::new(1e-12), &mut 0.0, 10.0, 510.0);
    assert_eq!(plain.undone, 0);
    assert_eq!(reused.matrices.len(), plain.matrices.len());
    assert!((reused.x - plain.x).abs() <= 1e-12);

    let x = reused.x;
    for step in 1..=10 {
        let small = solve(&mut newton, &mut slope, x, 510.0 * (1.0 + 1e-6));
        assert_eq!(small.matrices.len(), usize::from(step < 10), "step {step}");
    }
}
