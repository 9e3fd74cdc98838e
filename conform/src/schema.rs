//! JSON Schemas of the lines to and from a program, and of the report. They are derived from the types that write and read them.

use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use crate::protocol::{AnswerLine, Question};
use crate::report::Report;

/// Returns the schemas of this crate with their file names in `schema/`: questions, answers and the report.
pub fn schemas() -> [(&'static str, Schema); 3] {
    let (writes, reads) = (SchemaSettings::for_serialize, SchemaSettings::for_deserialize);
    [
        ("question.schema.json", schema::<Question>(writes, "urn:ancf:question:1", "Question of `ancf conform`")),
        ("answer.schema.json", schema::<AnswerLine>(reads, "urn:ancf:answer:1", "Answer to `ancf conform`")),
        ("report.schema.json", schema::<Report>(writes, "urn:ancf:report:1", "Report of `ancf conform`")),
    ]
}

fn schema<T: JsonSchema>(contract: fn(SchemaSettings) -> SchemaSettings, id: &str, title: &str) -> Schema {
    let settings = contract(SchemaSettings::draft2020_12()).with_transform(RecursiveTransform(tidy));
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("$id".into(), id.into());
    schema.insert("title".into(), title.into());
    schema
}

/// Joins the lines of descriptions, removes formats of Rust such as `uint`, and gives properties of an enum's variant its description.
fn tidy(schema: &mut Schema) {
    schema.remove("format");
    let Some(description) = schema.get("description").and_then(Value::as_str).map(|text| text.replace('\n', " "))
    else {
        return;
    };
    schema.insert("description".into(), description.clone().into());
    for property in
        schema.get_mut("properties").and_then(Value::as_object_mut).into_iter().flat_map(|all| all.values_mut())
    {
        if let Value::Object(property) = property {
            property.entry("description").or_insert_with(|| description.clone().into());
        }
    }
}
