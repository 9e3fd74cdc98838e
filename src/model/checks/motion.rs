//! Check of the initial motion: compatible with the supports.

use crate::model::check::{Check, finite, require};
use crate::model::choice::Method;
use crate::model::scene::Scene;

/// Largest velocity of a held point relative to the fastest point: rounding.
const REST_TOLERANCE: f64 = 1e-9;

/// Checks that the motion is finite and that the supports allow it.
pub(in crate::model) fn check_motion(scene: &Scene) -> Check {
    let Some(motion) = &scene.motion else { return Ok(()) };
    for (axis, (velocity, about)) in motion.velocity.iter().zip(&motion.about).enumerate() {
        finite(format_args!("motion.velocity[{axis}]"), *velocity)?;
        finite(format_args!("motion.about[{axis}]"), *about)?;
    }
    finite("motion.omega", motion.omega)?;
    let allowed = "nothing with the method \"static\", where nothing moves";
    require(scene.time.method != Method::Static, "motion", "given", allowed)?;
    let speed = |point: [f64; 2]| {
        let [x, y] = motion.at(point);
        x.hypot(y)
    };
    let fastest = scene.points.values().map(|point| speed(*point)).fold(0.0, f64::max);
    require(fastest.is_finite(), "motion", "given", "velocities that are finite numbers")?;
    for (i, support) in scene.supports.iter().enumerate() {
        let Some(point) = scene.position(&support.point) else { continue };
        let [x, y] = motion.at(point);
        for direction in support.held() {
            let along = x * direction[0] + y * direction[1];
            let allowed = format_args!(
                "a motion that leaves `{}` where supports[{i}] holds it; here it moves at {along:e} m/s along {direction:?}",
                support.point
            );
            require(along.abs() <= REST_TOLERANCE * fastest, "motion", format_args!("{motion:?}"), allowed)?;
        }
        if support.clamp.is_some() {
            let allowed = format_args!("0, as supports[{i}] clamps a rod at `{}`", support.point);
            require(motion.omega == 0.0, "motion.omega", format_args!("{:?}", motion.omega), allowed)?;
        }
    }
    Ok(())
}
