//! Reader of REXS in JSON.

use crate::error;
use std::collections::BTreeMap;

use asperity_core::Fault;
use serde_json::{Map, Value};

use crate::model::{Attribute, Component, LoadCase, Model, Relation};

type Object = Map<String, Value>;

/// Reads a REXS model from JSON.
pub fn read(model: &str) -> Result<Model, Fault> {
    let value: Value = serde_json::from_str(model)
        .map_err(|error| error::malformed(&format!("line {}", error.line()), &error.to_string()))?;
    let model = value
        .get("model")
        .and_then(Value::as_object)
        .ok_or_else(|| malformed("model", "is missing"))?;
    let program = ["applicationId", "applicationVersion"].map(|key| text(model.get(key)));
    let relations = list(model, "model", "relations")?;
    let spectrum = model.get("load_spectrum").and_then(Value::as_object);
    let load_cases = match spectrum {
        Some(spectrum) => list(spectrum, "model.load_spectrum", "load_cases")?
            .iter()
            .enumerate()
            .map(|(k, case)| {
                let place = format!("model.load_spectrum.load_cases[{k}]");
                let case = object(case, &place)?;
                Ok(LoadCase {
                    id: text(case.get("id")),
                    components: components(case, &place)?,
                })
            })
            .collect::<Result<_, Fault>>()?,
        None => Vec::new(),
    };
    Ok(Model {
        version: text(model.get("version")),
        program: program.join(" ").trim().to_owned(),
        components: components(model, "model")?,
        relations: relations
            .iter()
            .enumerate()
            .map(|(k, value)| relation(value, &format!("model.relations[{k}]")))
            .collect::<Result<_, _>>()?,
        load_cases,
    })
}

fn relation(value: &Value, place: &str) -> Result<Relation, Fault> {
    let relation = object(value, place)?;
    let role = |value: &Value| -> Result<(String, String), Fault> {
        let role = object(value, &format!("{place}.refs"))?;
        Ok((text(role.get("role")), text(role.get("id"))))
    };
    let roles = list(relation, place, "refs")?;
    Ok(Relation {
        id: text(relation.get("id")),
        kind: text(relation.get("type")),
        roles: roles.iter().map(role).collect::<Result<_, _>>()?,
    })
}

fn components(of: &Object, place: &str) -> Result<BTreeMap<String, Component>, Fault> {
    let mut components = BTreeMap::new();
    for (k, value) in list(of, place, "components")?.iter().enumerate() {
        let component = component(value, &format!("{place}.components[{k}]"))?;
        let id = component.id.clone();
        if components.insert(id.clone(), component).is_some() {
            return Err(error::twice(&id));
        }
    }
    Ok(components)
}

fn component(value: &Value, place: &str) -> Result<Component, Fault> {
    let component = object(value, place)?;
    let mut attributes = BTreeMap::new();
    for value in list(component, place, "attributes")? {
        let attribute = object(value, &format!("{place}.attributes"))?;
        // The key of the value is the name of its type.
        let types = ["floating_point", "integer", "string", "enum", "boolean"];
        let value = types.iter().find_map(|key| attribute.get(*key));
        attributes.insert(
            text(attribute.get("id")),
            Attribute {
                unit: text(attribute.get("unit")),
                text: text(value),
                ..Attribute::default()
            },
        );
    }
    Ok(Component {
        id: text(component.get("id")),
        kind: text(component.get("type")),
        name: text(component.get("name")),
        attributes,
    })
}

fn object<'a>(value: &'a Value, place: &str) -> Result<&'a Object, Fault> {
    value
        .as_object()
        .ok_or_else(|| malformed(place, "is not an object"))
}

/// The list `key`; empty if it is missing.
fn list<'a>(of: &'a Object, place: &str, key: &str) -> Result<&'a [Value], Fault> {
    match of.get(key) {
        None | Some(Value::Null) => Ok(&[]),
        Some(Value::Array(list)) => Ok(list),
        Some(_) => Err(malformed(&format!("{place}.{key}"), "is not a list")),
    }
}

fn text(value: Option<&Value>) -> String {
    match value {
        Some(Value::String(text)) => text.clone(),
        Some(value @ (Value::Number(_) | Value::Bool(_))) => value.to_string(),
        _ => String::new(),
    }
}

fn malformed(place: &str, what: &str) -> Fault {
    error::malformed(place, what)
}
