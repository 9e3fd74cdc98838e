//! JSON Schemas of the project's files, from the types that read and write them.

use schemars::generate::{Contract, SchemaSettings};
use schemars::transform::RecursiveTransform;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

use crate::model::Scene;

/// File name in `schema/` and JSON Schema of scene files.
pub fn scene() -> (&'static str, Schema) {
    let schema = schema::<Scene>(SchemaSettings::for_deserialize, "urn:ancf:scene:1", "Scene of `ancf run`");
    ("scene.schema.json", schema)
}

/// JSON Schema of a type, as it is read ([`SchemaSettings::for_deserialize`]) or written ([`SchemaSettings::for_serialize`]).
pub fn schema<T: JsonSchema>(contract: fn(SchemaSettings) -> SchemaSettings, id: &str, title: &str) -> Schema {
    let mut settings = contract(SchemaSettings::draft2020_12()).with_transform(RecursiveTransform(tidy));
    if settings.contract == Contract::Deserialize {
        settings = settings.with_transform(RecursiveTransform(without_null));
    }
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("$id".into(), id.into());
    schema.insert("title".into(), title.into());
    schema
}

/// Text of a description: the first paragraph of a doc comment, in one line and without the targets of links.
fn plain(comment: &str) -> String {
    let paragraph = comment.split("\n\n").next().unwrap_or_default().replace('\n', " ");
    let (mut text, mut rest) = (String::new(), paragraph.as_str());
    while let Some((before, link)) = rest.split_once("[`") {
        let Some((name, after)) = link.split_once("`]") else { break };
        text += &format!("{before}`{name}`");
        rest = after.strip_prefix('(').and_then(|target| target.split_once(')')).map_or(after, |(_, after)| after);
    }
    text + rest
}

/// Makes descriptions plain, removes formats of Rust such as `uint`, and gives properties of an enum's variant its description.
fn tidy(schema: &mut Schema) {
    schema.remove("format");
    let Some(description) = schema.get("description").and_then(Value::as_str).map(plain) else { return };
    schema.insert("description".into(), description.clone().into());
    for property in
        schema.get_mut("properties").and_then(Value::as_object_mut).into_iter().flat_map(|all| all.values_mut())
    {
        if let Value::Object(property) = property {
            property.entry("description").or_insert_with(|| description.clone().into());
        }
    }
}

/// Takes `null` away: what may be left out of a file is left out, and not `null`.
fn without_null(schema: &mut Schema) {
    if schema.get("default").is_some_and(Value::is_null) {
        schema.remove("default");
    }
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|kind| kind != "null");
        if let [kind] = &types[..] {
            let kind = kind.clone();
            schema.insert("type".into(), kind);
        }
    }
    let Some(Value::Array(choices)) = schema.get_mut("anyOf") else { return };
    choices.retain(|choice| choice["type"] != "null");
    if let [Value::Object(only)] = &choices[..] {
        let only = only.clone();
        schema.remove("anyOf");
        for (key, value) in only {
            schema.ensure_object().entry(key).or_insert(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn descriptions_are_plain() {
        assert_eq!(plain("Step\nof [`Time`](super::Time), s.\n\n```\nlet x = 1;\n```"), "Step of `Time`, s.");
        assert_eq!(plain("Like [`Rod`]; a [pair, \\[a, b\\]]"), "Like `Rod`; a [pair, \\[a, b\\]]");
    }
}
