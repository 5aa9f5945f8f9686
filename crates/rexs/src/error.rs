//! Errors of REXS files.

use asperity_core::Code;

/// Error of a REXS file or of a stage in it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RexsError {
    /// Neither XML nor JSON nor zip.
    #[error("not a REXS file: it is neither XML nor JSON nor a zip of either")]
    NotRexs,
    /// The file or its unpacked content is too large.
    #[error("the content exceeds {most_mib} MiB")]
    TooLarge {
        /// Limit in MiB.
        most_mib: u64,
    },
    /// The zip cannot be read, or holds no REXS file, or several.
    #[error("the zip {0}")]
    Zip(String),
    /// The XML or JSON is malformed, or not a REXS model.
    #[error("{place}: {what}")]
    Malformed {
        /// Line, or path of the key.
        place: String,
        /// Description of the fault.
        what: String,
    },
    /// Unknown version.
    #[error("REXS version {0:?} is not known; 1.0 to 2.0 are")]
    Version(String),
    /// Two components have the same number.
    #[error("component {id} occurs twice")]
    Twice {
        /// Number of the component.
        id: String,
    },
    /// A relation refers to a missing component, or lacks a role.
    #[error("relation {relation} ({kind}): {what}")]
    Relation {
        /// Number of the relation.
        relation: String,
        /// Its type.
        kind: String,
        /// Fault of the relation.
        what: String,
    },
    /// A required attribute is missing.
    #[error("{component}: attribute {attribute} is missing")]
    Missing {
        /// Type, number and name of the component.
        component: String,
        /// Attribute.
        attribute: &'static str,
    },
    /// An attribute is not a number, or not plausible.
    #[error("{component}: attribute {attribute} is {text:?}, {expected}")]
    Value {
        /// Type, number and name of the component.
        component: String,
        /// Attribute.
        attribute: String,
        /// Its text.
        text: String,
        /// Expected value.
        expected: &'static str,
    },
    /// An attribute has an unexpected unit.
    #[error("{component}: attribute {attribute} is in {unit:?}, expected {expected}")]
    Unit {
        /// Type, number and name of the component.
        component: String,
        /// Attribute.
        attribute: String,
        /// Unit of the file.
        unit: String,
        /// Expected unit.
        expected: &'static str,
    },
    /// The gears of a stage contradict each other.
    #[error("stage {stage}: {what}")]
    Contradiction {
        /// Number of the stage.
        stage: usize,
        /// Description of the contradiction.
        what: String,
    },
    /// The stage does not exist.
    #[error("{}", match count {
        0 => "the file has no stage of gears; export the gear unit with its stages, and parts of other files in it".to_owned(),
        _ => format!("there is no stage {wanted}; the file has {count}"),
    })]
    NoStage {
        /// Requested stage.
        wanted: usize,
        /// Number of stages.
        count: usize,
    },
    /// The gears of the stage are not cylindrical.
    #[error("stage {stage} is a {kind}: only cylindrical gears can be modelled")]
    NotCylindrical {
        /// Number of the stage.
        stage: usize,
        /// Type of the stage or of its gear.
        kind: String,
    },
    /// The load case does not exist.
    #[error("there is no load case {wanted}; the file has {count}")]
    NoLoadCase {
        /// Requested load case.
        wanted: usize,
        /// Number of load cases.
        count: usize,
    },
}

impl RexsError {
    /// Stable code.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::NoStage { .. } | Self::NoLoadCase { .. } | Self::NotCylindrical { .. } => {
                Code::E133
            }
            _ => Code::E132,
        }
    }
}
