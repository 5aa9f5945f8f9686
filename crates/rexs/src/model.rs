//! Components, relations and load cases of a REXS file.

use crate::error;
use std::cell::Cell;
use std::collections::BTreeMap;

use crate::units::{Unit, UnitError, converted};
use asperity_core::Fault;

/// An attribute of a component, as written.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Attribute {
    /// Unit as written in the file.
    pub unit: String,
    /// Value; empty for an array or a matrix.
    pub text: String,
    /// Whether a case has used it.
    pub(crate) is_read: ReadMark,
}

/// Mark of an attribute that was read; it does not count in comparisons.
#[derive(Debug, Clone, Default)]
pub(crate) struct ReadMark(Cell<bool>);

impl PartialEq for ReadMark {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for ReadMark {}

impl ReadMark {
    /// Whether the attribute was read.
    pub(crate) fn is_set(&self) -> bool {
        self.0.get()
    }
}

/// A component: a gear, a shaft, a lubricant.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Component {
    /// Number in the file.
    pub id: String,
    /// Type, `cylindrical_gear`.
    pub kind: String,
    /// Name given by the exporting program.
    pub name: String,
    /// Attributes by their names.
    pub attributes: BTreeMap<String, Attribute>,
}

/// A relation between components.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Relation {
    /// Number in the file.
    pub id: String,
    /// Type, `stage`.
    pub kind: String,
    /// Roles, each with the number of its component.
    pub roles: Vec<(String, String)>,
}

/// A load case with its attributes of components.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LoadCase {
    /// Number in the file.
    pub id: String,
    /// Components by their numbers.
    pub components: BTreeMap<String, Component>,
}

/// A gearbox.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Model {
    /// Version of REXS.
    pub version: String,
    /// Program that wrote the file, with its version.
    pub program: String,
    /// Components by their numbers.
    pub components: BTreeMap<String, Component>,
    /// Relations in the order of the file.
    pub relations: Vec<Relation>,
    /// Load cases in the order of the file.
    pub load_cases: Vec<LoadCase>,
}

impl Component {
    /// Type, number and name, for messages.
    pub(crate) fn label(&self) -> String {
        match self.name.trim() {
            "" => format!("{} {}", self.kind, self.id),
            name => format!("{} {} ({name})", self.kind, self.id),
        }
    }

    /// An attribute, which is marked as read; `None` if it is missing or empty.
    fn stated(&self, attribute: &str) -> Option<&Attribute> {
        let stated = self.attributes.get(attribute)?;
        (!stated.text.is_empty()).then(|| {
            stated.is_read.0.set(true);
            stated
        })
    }

    /// Text of an attribute without its blanks; `None` if it is missing or empty.
    pub(crate) fn text(&self, attribute: &str) -> Option<&str> {
        self.stated(attribute).map(|stated| stated.text.trim())
    }

    /// The first stated one of the names that an attribute has in the versions of REXS.
    pub(crate) fn first_of(
        &self,
        attributes: &[&'static str],
        unit: Unit,
    ) -> Result<Option<(f64, &'static str)>, Fault> {
        for attribute in attributes {
            if let Some(value) = self.number(attribute, unit)? {
                return Ok(Some((value, attribute)));
            }
        }
        Ok(None)
    }

    /// An attribute in the unit of the case; `None` if it is missing or empty.
    pub(crate) fn number(&self, attribute: &'static str, unit: Unit) -> Result<Option<f64>, Fault> {
        let Some(stated) = self.stated(attribute) else {
            return Ok(None);
        };
        let value = converted(&stated.text, &stated.unit, unit);
        value.map(Some).map_err(|error| match error {
            UnitError::Number => self.refused(attribute, "which is not a finite number"),
            UnitError::Unit(expected) => {
                error::unit(&self.label(), attribute, &stated.unit, expected)
            }
        })
    }

    /// A required attribute in the unit of the case.
    pub(crate) fn required(&self, attribute: &'static str, unit: Unit) -> Result<f64, Fault> {
        self.number(attribute, unit)?
            .ok_or_else(|| error::missing(&self.label(), attribute))
    }

    /// Error for the value of an attribute.
    pub(crate) fn refused(&self, attribute: &'static str, expected: &'static str) -> Fault {
        let text = self.attributes.get(attribute);
        error::value(
            &self.label(),
            attribute,
            &text.map_or_else(String::new, |attribute| attribute.text.clone()),
            expected,
        )
    }
}

impl Relation {
    /// Number of the component in a role.
    pub(crate) fn role(&self, role: &str) -> Option<&str> {
        let component = self.roles.iter().find(|(name, _)| name == role);
        component.map(|(_, id)| id.as_str())
    }

    fn refused(&self, what: String) -> Fault {
        error::relation(&self.id, &self.kind, &what)
    }
}

impl Model {
    /// The component in a role of a relation.
    pub(crate) fn in_role(&self, relation: &Relation, role: &str) -> Result<&Component, Fault> {
        let Some(id) = relation.role(role) else {
            return Err(relation.refused(format!("role {role} is missing")));
        };
        self.components
            .get(id)
            .ok_or_else(|| relation.refused(format!("{role} is component {id}, which is missing")))
    }

    /// Components of a type, in the order of their numbers.
    pub(crate) fn of_kind<'a>(&'a self, kind: &'a str) -> impl Iterator<Item = &'a Component> {
        self.components
            .values()
            .filter(move |component| component.kind == kind)
    }

    /// Relations of a type.
    pub(crate) fn related<'a>(&'a self, kind: &'a str) -> impl Iterator<Item = &'a Relation> {
        self.relations
            .iter()
            .filter(move |relation| relation.kind == kind)
    }

    /// The components of type `kind` that `origin` refers to.
    pub(crate) fn referenced<'a>(
        &'a self,
        origin: &'a Component,
        kind: &'a str,
    ) -> impl Iterator<Item = &'a Component> {
        ["reference", "ordered_reference"]
            .into_iter()
            .flat_map(|relation| self.related(relation))
            .filter(|relation| relation.role("origin") == Some(&origin.id))
            .filter_map(|relation| self.components.get(relation.role("referenced")?))
            .filter(move |component| component.kind == kind)
    }

    /// All components with their place in the file: first of the model, then of the load cases.
    pub(crate) fn all_components(&self) -> impl Iterator<Item = (Option<&LoadCase>, &Component)> {
        let own = self.components.values().map(|component| (None, component));
        let in_cases = self.load_cases.iter().flat_map(|case| {
            let components = case.components.values();
            components.map(move |component| (Some(case), component))
        });
        own.chain(in_cases)
    }

    /// This model without marks of attributes that were read.
    pub(crate) fn unmarked(&self) -> Self {
        let model = self.clone();
        for (_, component) in model.all_components() {
            for attribute in component.attributes.values() {
                attribute.is_read.0.set(false);
            }
        }
        model
    }
}
