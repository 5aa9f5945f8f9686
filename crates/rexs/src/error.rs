//! Errors of REXS files.

/// Refusal of a REXS file, or of a stage in it.
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
    /// The XML or JSON is not well formed, or not that of a REXS model.
    #[error("{place}: {what}")]
    Malformed {
        /// Line, or path of the key.
        place: String,
        /// Fault found there.
        what: String,
    },
    /// A version that is not known.
    #[error("REXS version {0:?} is not known; 1.0 to 2.0 are")]
    Version(String),
    /// Two components of the same number.
    #[error("component {id} occurs twice")]
    Twice {
        /// Number of the component.
        id: String,
    },
    /// A relation names a component that the file does not hold, or leaves out a role.
    #[error("relation {relation} ({kind}): {what}")]
    Relation {
        /// Number of the relation.
        relation: String,
        /// Its type.
        kind: String,
        /// Fault of the relation.
        what: String,
    },
    /// An attribute that a case needs is missing.
    #[error("{component}: attribute {attribute} is missing")]
    Missing {
        /// Type, number and name of the component.
        component: String,
        /// Attribute.
        attribute: &'static str,
    },
    /// An attribute is no number, or no sensible one.
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
    /// An attribute has a unit that is not its own.
    #[error("{component}: attribute {attribute} is in {unit:?}, expected {expected}")]
    Unit {
        /// Type, number and name of the component.
        component: String,
        /// Attribute.
        attribute: String,
        /// Unit of the file.
        unit: String,
        /// Units that are read.
        expected: &'static str,
    },
    /// Both gears of a stage disagree.
    #[error("stage {stage}: {what}")]
    Contradiction {
        /// Number of the stage.
        stage: usize,
        /// Contradiction found.
        what: String,
    },
    /// There is no such stage.
    #[error("there is no stage {wanted}; the file has {count}")]
    NoStage {
        /// Stage asked for.
        wanted: usize,
        /// Stages there are.
        count: usize,
    },
    /// The stage is no pair of cylindrical gears.
    #[error("stage {stage} is a {kind}: only cylindrical gears can be modelled")]
    NotCylindrical {
        /// Number of the stage.
        stage: usize,
        /// Type of the stage or of its gear.
        kind: String,
    },
    /// There is no such load case.
    #[error("there is no load case {wanted}; the file has {count}")]
    NoLoadCase {
        /// Load case asked for.
        wanted: usize,
        /// Load cases there are.
        count: usize,
    },
}
