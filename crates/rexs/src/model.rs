//! Components, relations and load cases of a REXS file.

use std::collections::BTreeMap;

use crate::error::RexsError;
use crate::units::{Unit, UnitError, converted};

/// An attribute of a component, as written.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Attribute {
    /// Unit as written in the file.
    pub unit: String,
    /// Value; empty for an array or a matrix.
    pub text: String,
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

    /// An attribute in the unit of the case; `None` if it is missing or empty.
    pub(crate) fn number(
        &self,
        attribute: &'static str,
        unit: Unit,
    ) -> Result<Option<f64>, RexsError> {
        let stated = self.attributes.get(attribute);
        let Some(stated) = stated.filter(|stated| !stated.text.is_empty()) else {
            return Ok(None);
        };
        let value = converted(&stated.text, &stated.unit, unit);
        value.map(Some).map_err(|error| match error {
            UnitError::Number => self.refused(attribute, "which is not a finite number"),
            UnitError::Unit(expected) => RexsError::Unit {
                component: self.label(),
                attribute: attribute.to_owned(),
                unit: stated.unit.clone(),
                expected,
            },
        })
    }

    /// A required attribute in the unit of the case.
    pub(crate) fn required(&self, attribute: &'static str, unit: Unit) -> Result<f64, RexsError> {
        self.number(attribute, unit)?
            .ok_or_else(|| RexsError::Missing {
                component: self.label(),
                attribute,
            })
    }

    /// Error for the value of an attribute.
    pub(crate) fn refused(&self, attribute: &'static str, expected: &'static str) -> RexsError {
        let text = self.attributes.get(attribute);
        RexsError::Value {
            component: self.label(),
            attribute: attribute.to_owned(),
            text: text.map_or_else(String::new, |attribute| attribute.text.clone()),
            expected,
        }
    }
}

impl Relation {
    /// Number of the component in a role.
    pub(crate) fn role(&self, role: &str) -> Option<&str> {
        let component = self.roles.iter().find(|(name, _)| name == role);
        component.map(|(_, id)| id.as_str())
    }

    fn refused(&self, what: String) -> RexsError {
        RexsError::Relation {
            relation: self.id.clone(),
            kind: self.kind.clone(),
            what,
        }
    }
}

impl Model {
    /// The component in a role of a relation.
    pub(crate) fn in_role(&self, relation: &Relation, role: &str) -> Result<&Component, RexsError> {
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

    /// The component of type `kind` that `origin` refers to.
    pub(crate) fn referenced(&self, origin: &Component, kind: &str) -> Option<&Component> {
        self.related("reference")
            .filter(|relation| relation.role("origin") == Some(&origin.id))
            .filter_map(|relation| self.components.get(relation.role("referenced")?))
            .find(|component| component.kind == kind)
    }
}
