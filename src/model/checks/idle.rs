//! Refuses settings without effect: a run that ignores what a file says is a silent surprise.

use crate::model::check::{Check, Refusal};
use crate::model::choice::Method;
use crate::model::method_settings::{SETTINGS, Setting};
use crate::model::scene::Scene;
use crate::model::time::Time;

/// Refuses settings that the method ignores: those other than their default, and those that `is_given` finds in a file.
pub fn check_idle(scene: &Scene, is_given: impl Fn(&str) -> bool) -> Check {
    let (method, default) = (scene.time.method, Time::until(scene.time.end));
    for Setting { key, is_used, users, value, .. } in SETTINGS {
        let own = value(&scene.time);
        if !is_used(method) && (own != value(&default) || is_given(key)) {
            return idle(key, own, method, users);
        }
    }
    let key = "output.energy";
    if method == Method::Static && (!scene.output.energy || is_given(key)) {
        let users = "in statics slowly growing loads supply exactly the stored energy";
        return idle(key, scene.output.energy.to_string(), method, users);
    }
    let interval = scene.output.shapes.as_ref().and_then(|shapes| shapes.interval);
    if let (Method::Static, Some(interval)) = (method, interval) {
        let users = "in statics each load step has a shape";
        return idle("output.shapes.interval", format!("{interval:?}"), method, users);
    }
    Ok(())
}

fn idle(key: &str, value: String, method: Method, users: &str) -> Check {
    let allowed = format!("nothing with the method \"{method}\", which has no use for it: {users}");
    Err(Refusal { key: key.into(), value, allowed })
}
