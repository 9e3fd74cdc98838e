//! JSON Schemas of the lines to and from a program, and of the report. They are derived from the types that write and read them.

use ancf::internals::schema::schema;
use schemars::Schema;
use schemars::generate::SchemaSettings;

use crate::protocol::{AnswerLine, Question};
use crate::report::Report;
use crate::trajectory::Outcome;

/// Returns the schemas of this crate with their file names in `schema/`: questions, answers, the report, and that on a motion.
pub fn schemas() -> [(&'static str, Schema); 4] {
    let (writes, reads) = (SchemaSettings::for_serialize, SchemaSettings::for_deserialize);
    [
        ("question.schema.json", schema::<Question>(writes, "urn:ancf:question:1", "Question of `ancf conform`")),
        ("answer.schema.json", schema::<AnswerLine>(reads, "urn:ancf:answer:1", "Answer to `ancf conform`")),
        ("report.schema.json", schema::<Report>(writes, "urn:ancf:report:1", "Report of `ancf conform`")),
        (
            "trajectory-report.schema.json",
            schema::<Outcome>(writes, "urn:ancf:trajectory-report:1", "Report of `ancf conform --trajectory`"),
        ),
    ]
}
