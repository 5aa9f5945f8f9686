//! Reader of REXS in XML.

use crate::error;
use asperity_core::Fault;
use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::{BytesStart, Event};

use crate::model::{Attribute, Component, LoadCase, Model, Relation};

/// Elements of a model that are read, with what is in them. Others, such as the sums over a load spectrum (`accumulation`), may
/// hold components of the same numbers.
const READ: [&str; 9] = [
    "model",
    "relations",
    "relation",
    "ref",
    "components",
    "component",
    "attribute",
    "load_spectrum",
    "load_case",
];

/// Elements whose end tags have not been read yet.
#[derive(Default)]
struct Open {
    component: Option<Component>,
    attribute: Option<(String, Attribute)>,
    relation: Option<Relation>,
    load_case: Option<LoadCase>,
    /// Depth of elements inside the attribute, an array or a matrix, or inside an element that is not read.
    nested: usize,
}

/// Reads a REXS model from XML.
pub fn read(text: &str) -> Result<Model, Fault> {
    let bytes = text.as_bytes();
    let mut reader = Reader::from_str(text);
    let mut model: Option<Model> = None;
    let mut open = Open::default();
    let mut depth = 0_usize;
    loop {
        let at = usize::try_from(reader.buffer_position()).unwrap_or(bytes.len());
        let malformed_here = |what: String| malformed(bytes, at, what);
        let event = reader
            .read_event()
            .map_err(|error| malformed_here(error.to_string()))?;
        match event {
            Event::Start(element) | Event::Empty(element) if model.is_none() => {
                if element.name().as_ref() != "model" {
                    let name = element.name().as_ref().to_owned();
                    return Err(malformed_here(format!("expected <model>, not <{name}>")));
                }
                model = Some(head(&element).map_err(malformed_here)?);
                depth = 1;
            }
            Event::Start(element) => {
                depth += 1;
                open_element(&element, &mut open).map_err(malformed_here)?;
            }
            Event::Empty(element) => {
                open_element(&element, &mut open).map_err(malformed_here)?;
                let name = element.name();
                if let Some(model) = &mut model {
                    close_element(name.as_ref(), &mut open, model)?;
                }
            }
            Event::End(element) => {
                depth = depth.saturating_sub(1);
                if let Some(model) = &mut model {
                    close_element(element.name().as_ref(), &mut open, model)?;
                }
            }
            Event::Text(text) => {
                if let Some((_, attribute)) = open.attribute.as_mut().filter(|_| open.nested == 0) {
                    attribute.text.push_str(&text);
                }
            }
            // An entity such as &#252; is an event of its own.
            Event::GeneralRef(name) => {
                if let Some((_, attribute)) = open.attribute.as_mut().filter(|_| open.nested == 0)
                    && let Ok(text) = unescape(&format!("&{};", &*name))
                {
                    attribute.text.push_str(&text);
                }
            }
            Event::Eof => break,
            _ => {}
        }
    }
    let end = |what: &str| malformed(bytes, bytes.len(), what.to_owned());
    if depth > 0 {
        return Err(end("the file ends inside of an element"));
    }
    model.ok_or_else(|| end("there is no <model>"))
}

fn head(element: &BytesStart<'_>) -> Result<Model, String> {
    let program = [
        value(element, "applicationId")?,
        value(element, "applicationVersion")?,
    ];
    Ok(Model {
        version: value(element, "version")?,
        program: program.join(" ").trim().to_owned(),
        ..Model::default()
    })
}

fn open_element(element: &BytesStart<'_>, open: &mut Open) -> Result<(), String> {
    let name = element.name();
    if open.attribute.is_some() || open.nested > 0 || !READ.contains(&name.as_ref()) {
        open.nested += 1;
        return Ok(());
    }
    match name.as_ref() {
        "component" => {
            open.component = Some(Component {
                id: value(element, "id")?,
                kind: value(element, "type")?,
                name: value(element, "name")?,
                ..Component::default()
            });
        }
        "attribute" => {
            let attribute = Attribute {
                unit: value(element, "unit")?,
                ..Attribute::default()
            };
            open.attribute = Some((value(element, "id")?, attribute));
        }
        "relation" => {
            open.relation = Some(Relation {
                id: value(element, "id")?,
                kind: value(element, "type")?,
                roles: Vec::new(),
            });
        }
        "ref" => {
            let role = (value(element, "role")?, value(element, "id")?);
            if let Some(relation) = &mut open.relation {
                relation.roles.push(role);
            }
        }
        "load_case" => {
            open.load_case = Some(LoadCase {
                id: value(element, "id")?,
                ..LoadCase::default()
            });
        }
        _ => {}
    }
    Ok(())
}

fn close_element(name: &str, open: &mut Open, model: &mut Model) -> Result<(), Fault> {
    if open.nested > 0 {
        open.nested -= 1;
        return Ok(());
    }
    match name {
        "attribute" => {
            if let (Some((id, mut attribute)), Some(component)) =
                (open.attribute.take(), &mut open.component)
            {
                attribute.text = attribute.text.trim().to_owned();
                component.attributes.insert(id, attribute);
            }
        }
        "component" => {
            if let Some(component) = open.component.take() {
                let components = match &mut open.load_case {
                    Some(case) => &mut case.components,
                    None => &mut model.components,
                };
                let id = component.id.clone();
                if components.insert(id.clone(), component).is_some() {
                    return Err(error::twice(&id));
                }
            }
        }
        "relation" => model.relations.extend(open.relation.take()),
        "load_case" => model.load_cases.extend(open.load_case.take()),
        _ => {}
    }
    Ok(())
}

/// Value of an XML attribute; empty if it is missing.
fn value(element: &BytesStart<'_>, name: &str) -> Result<String, String> {
    let attribute = element
        .try_get_attribute(name)
        .map_err(|error| error.to_string())?;
    let Some(attribute) = attribute else {
        return Ok(String::new());
    };
    let text = unescape(&attribute.value).map_err(|error| error.to_string())?;
    Ok(text.into_owned())
}

fn malformed(bytes: &[u8], at: usize, what: String) -> Fault {
    let before = &bytes[..at.min(bytes.len())];
    let line = 1 + before.iter().filter(|byte| **byte == b'\n').count();
    error::malformed(&format!("line {line}"), &what)
}
