//! JSON Schemas of all files that the program reads and writes.

use ancf::internals::schema::{scene, schema};
use schemars::Schema;
use schemars::generate::SchemaSettings;

use crate::modes::ModesFile;
use crate::shapes::ShapesFile;
use crate::summary::Summary;

/// File names in `schema/` and their JSON Schemas: scenes, summaries, shapes and modes, questions, answers and reports of `ancf conform`.
pub fn schemas() -> Vec<(&'static str, Schema)> {
    let summary = schema::<Summary>(SchemaSettings::for_serialize, "urn:ancf:summary:1", "Summary of `ancf run`");
    let shapes = schema::<ShapesFile>(SchemaSettings::for_serialize, "urn:ancf:shapes:1", "Shapes of `ancf run`");
    let modes = schema::<ModesFile>(SchemaSettings::for_serialize, "urn:ancf:modes:1", "Modes of `ancf modes`");
    let own = [scene(), ("summary.schema.json", summary), ("shapes.schema.json", shapes), ("modes.schema.json", modes)];
    own.into_iter().chain(ancf_conform::schemas()).collect()
}
