//! A simulation from code: every wrong name, time or value is an error, and no error is followed by a result.

use ancf::error::{Error, Result};
use ancf::integrators::{Counts, Integrator, State};
use ancf::internals::integrators::integrator;
use ancf::internals::model::Plan;
use ancf::internals::structure::Structure;
use ancf::model::{Material, Method, Probe, Quantity, Rod, Scene, Section, Support};
use ancf::run::Simulation;

fn pendulum(method: Method, step: f64, end: f64) -> Scene {
    let mut scene = Scene::new(Material::new(2e8, 0.0, 7750.0), Section::new(0.02, 0.02))
        .point("pivot", [0.0, 0.0])
        .point("tip", [1.0, 0.0])
        .rod(Rod::new("rod", "pivot", "tip"))
        .support(Support::pinned("pivot"))
        .gravity([0.0, -9.8])
        .method(method, step)
        .until(end);
    scene.rods[0].elements = 2;
    scene
}

fn start(method: Method, step: f64, end: f64) -> Simulation {
    Simulation::new(pendulum(method, step, end)).unwrap()
}

fn refused(result: Result<()>) -> String {
    match result {
        Err(error @ Error::NotATime { .. }) => error.to_string(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn times_that_steps_do_not_lead_to_are_refused_and_nothing_moves() {
    for method in [Method::GeneralizedAlpha, Method::EnergyMomentum, Method::Gauss, Method::GaussAdaptive] {
        let mut simulation = start(method, 0.01, 0.1);
        simulation.run_until(0.05).unwrap();
        let before = simulation.position("tip").unwrap();
        for t in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -0.01, 0.04, 0.11] {
            let message = refused(simulation.run_until(t));
            assert!(message.contains("allowed: 0.05 to 0.1 s"), "{method}, {t}: {message}");
        }
        assert_eq!((simulation.position("tip").unwrap(), simulation.time()), (before, 0.05));
    }
    let mut simulation = start(Method::EnergyMomentum, 0.01, 0.1);
    assert!(refused(simulation.run_until(0.015)).contains("allowed: 0.01 or 0.02 s"));
}

/// Sums of steps, and a step that was written with ten digits.
#[test]
fn times_that_only_rounding_moves_are_reached() {
    let mut simulation = start(Method::EnergyMomentum, 1e-3, 0.2);
    let mut t = 0.0;
    for _ in 0..20 {
        t += 0.01;
        simulation.run_until(t).unwrap();
    }
    assert_eq!(simulation.steps_done(), 200);
    let mut thirds = start(Method::EnergyMomentum, 0.003_333_333_333, 0.01);
    thirds.run_until(0.01).unwrap();
    assert_eq!(thirds.steps_done(), 3);
    assert!(!thirds.step().unwrap());
}

/// An adaptive method stops between two rows, and goes on to the next one.
#[test]
fn adaptive_methods_stop_at_any_time() {
    let mut simulation = start(Method::GaussAdaptive, 0.02, 0.1);
    simulation.run_until(0.033).unwrap();
    assert_eq!((simulation.time(), simulation.steps_done(), simulation.rows().count()), (0.033, 1, 2));
    simulation.step().unwrap();
    assert!((simulation.time() - 0.04).abs() < 1e-15);
    let run = simulation.finish().unwrap();
    let whole = ancf::run::run(pendulum(Method::GaussAdaptive, 0.02, 0.1)).unwrap().trajectory.rows;
    let end = |rows: &ancf::run::Rows| rows.last().unwrap()[0];
    assert_eq!((run.trajectory.rows.len(), end(&run.trajectory.rows)), (whole.len(), end(&whole)));
}

/// A fixed-step method refuses any end but that of its next step; the state is then unchanged.
#[test]
fn fixed_steps_refuse_a_time_that_is_not_their_next() {
    for method in [Method::GeneralizedAlpha, Method::EnergyMomentum, Method::Explicit, Method::Gauss, Method::Nystrom] {
        let scene = pendulum(method, 1e-5, 0.1);
        let structure = Structure::new(&scene).unwrap();
        let (mut state, mut counts) = (State::at_start(&structure), Counts::default());
        let mut method_of_scene = integrator(&scene, &Plan::of(&scene), &structure, &state, &mut counts).unwrap();
        for t in [2e-5, 0.5e-5, 0.0, -1e-5, f64::INFINITY, f64::NAN] {
            let result = method_of_scene.step(&structure, &mut state, t, &mut counts);
            assert!(matches!(result, Err(Error::NotATime { .. })), "{method}, {t}: {result:?}");
            assert_eq!((state.t, state.step, &state.u), (0.0, 0, structure.start()));
        }
        method_of_scene.step(&structure, &mut state, 1e-5, &mut counts).unwrap();
        assert_eq!((state.t, state.step), (1e-5, 1));
    }
}

#[test]
fn wrong_names_and_places_are_errors() {
    let mut simulation = start(Method::EnergyMomentum, 0.01, 0.1);
    let message = |error: Error| error.to_string();
    assert_eq!(message(simulation.position("tipp").unwrap_err()), "there is no point `tipp`; nearest: `tip`");
    assert_eq!(message(simulation.velocity("xyz").unwrap_err()), "there is no point `xyz`");
    assert_eq!(message(simulation.nodal_coordinates("rot").unwrap_err()), "there is no rod `rot`; nearest: `rod`");
    for result in [simulation.acceleration("typo"), simulation.reaction("typo")] {
        assert!(matches!(result, Err(Error::Unknown { what: "point", .. })));
    }
    for at in [-0.1, 1.1, f64::NAN] {
        assert!(matches!(simulation.deflection("rod", at), Err(Error::Scene { .. })), "{at}");
    }
    assert!(matches!(simulation.deflection("typo", 0.5), Err(Error::Unknown { what: "rod", .. })));
    assert!(
        matches!(Simulation::new(pendulum(Method::EnergyMomentum, 0.0, 0.1)), Err(Error::Scene { key, .. }) if key == "time.step")
    );
    for step in [0.0, -1.0, f64::NAN, 1e-300] {
        assert_eq!(pendulum(Method::EnergyMomentum, step, 0.1).steps(), 0, "{step}");
    }
}

#[test]
fn what_is_read_is_the_state_of_now() {
    let scene = pendulum(Method::EnergyMomentum, 1e-3, 0.1).probe(Probe::point(
        "pin",
        "pivot",
        &[Quantity::Acceleration, Quantity::Reaction],
    ));
    let mut simulation = Simulation::new(scene).unwrap();
    simulation.run_until(0.1).unwrap();
    let counts = simulation.counts();
    let row = simulation.rows().last().unwrap()[1..5].to_vec();
    let read = [simulation.acceleration("pivot").unwrap(), simulation.reaction("pivot").unwrap()].concat();
    assert_eq!(read, row);
    assert_eq!(simulation.counts(), counts);
    let energy = simulation.energy();
    assert!((energy.kinetic + energy.strain + energy.potential).abs() < 1e-6 * energy.kinetic, "{energy:?}");
    let coordinates = simulation.nodal_coordinates("rod").unwrap();
    assert_eq!(coordinates.len(), 12);
    assert_eq!(coordinates[10], simulation.position("tip").unwrap());
    assert_eq!(simulation.rows().next().unwrap().len(), simulation.columns().len());
}

/// Integrator that does with the state what its function says.
struct Strange(fn(&mut State, f64));

impl Integrator for Strange {
    fn step(&mut self, _: &Structure, state: &mut State, t_1: f64, _: &mut Counts) -> Result<()> {
        (self.0)(state, t_1);
        Ok(())
    }
}

#[test]
fn an_integrator_that_does_not_move_on_is_an_error_and_ends_the_simulation() {
    let faults: [fn(&mut State, f64); 4] = [
        |_, _| (),
        |state, t| state.advance(2.0 * t),
        |state, _| state.advance(f64::NAN),
        |state, t| state.advance(-t),
    ];
    for fault in faults {
        let model = pendulum(Method::EnergyMomentum, 0.01, 0.1).build().unwrap();
        let mut simulation = Simulation::with_integrator(model, |_, _, _| Ok(Box::new(Strange(fault)))).unwrap();
        assert!(matches!(simulation.step(), Err(Error::NotATime { .. })));
        assert!(matches!(simulation.step(), Err(Error::HasFailed { .. })));
        assert!(matches!(simulation.finish(), Err(Error::HasFailed { .. })));
    }
    let adaptive = pendulum(Method::GaussAdaptive, 0.01, 0.1).build().unwrap();
    let made = Simulation::with_integrator(adaptive, |_, _, _| Ok(Box::new(Strange(State::advance))));
    assert!(matches!(made, Err(Error::Scene { key, .. }) if key == "time.method"));
}

#[test]
fn load_factors_of_statics_are_no_seconds() {
    let mut scene = Scene::builtin("cantilever").unwrap();
    scene.time.load_steps = 10;
    let mut simulation = Simulation::new(scene).unwrap();
    let message = refused(simulation.run_until(0.25));
    assert_eq!(message, "no step ends at 0.25 of the load; allowed: 0.2 or 0.3");
    simulation.run_until(0.3).unwrap();
    assert_eq!((simulation.steps_done(), simulation.time()), (3, 0.3));
}
