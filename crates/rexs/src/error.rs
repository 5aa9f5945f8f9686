//! Errors of REXS files.

use asperity_core::{Code, Fault};

/// Neither XML nor JSON nor zip.
pub(crate) fn not_rexs() -> Fault {
    Fault::new(
        Code::E132,
        "not a REXS file: it is neither XML nor JSON nor a zip of either",
    )
}

/// The file or its unpacked content is too large.
pub(crate) fn too_large(most_mib: u64) -> Fault {
    Fault::new(Code::E132, format!("the content exceeds {most_mib} MiB"))
}

/// The zip cannot be read, or holds no REXS file, or several.
pub(crate) fn zip(what: &str) -> Fault {
    Fault::new(Code::E132, format!("the zip {what}"))
}

/// The XML or JSON is malformed, or not a REXS model.
pub(crate) fn malformed(place: &str, what: &str) -> Fault {
    Fault::new(Code::E132, format!("{place}: {what}"))
}

/// Unknown version.
pub(crate) fn version(what: &str) -> Fault {
    Fault::new(
        Code::E132,
        format!("REXS version {what:?} is not known; 1.0 to 2.0 are"),
    )
}

/// Two components have the same number.
pub(crate) fn twice(id: &str) -> Fault {
    Fault::new(Code::E132, format!("component {id} occurs twice"))
}

/// A relation refers to a missing component, or lacks a role.
pub(crate) fn relation(relation: &str, kind: &str, what: &str) -> Fault {
    Fault::new(Code::E132, format!("relation {relation} ({kind}): {what}"))
}

/// A required attribute is missing.
pub(crate) fn missing(component: &str, attribute: &'static str) -> Fault {
    Fault::new(
        Code::E132,
        format!("{component}: attribute {attribute} is missing"),
    )
}

/// An attribute is not a number, or not plausible.
pub(crate) fn value(component: &str, attribute: &str, text: &str, expected: &'static str) -> Fault {
    Fault::new(
        Code::E132,
        format!("{component}: attribute {attribute} is {text:?}, {expected}"),
    )
}

/// An attribute has an unexpected unit.
pub(crate) fn unit(component: &str, attribute: &str, unit: &str, expected: &'static str) -> Fault {
    Fault::new(
        Code::E132,
        format!("{component}: attribute {attribute} is in {unit:?}, expected {expected}"),
    )
}

/// The stage does not exist.
pub(crate) fn no_stage(wanted: usize, count: usize) -> Fault {
    let message = match count {
        0 => "the file has no stage of gears; export the gear unit with its stages, and parts of other files in it".to_owned(),
        _ => format!("there is no stage {wanted}; the file has {count}"),
    };
    Fault::new(Code::E133, message)
}

/// The gears of the stage are not cylindrical.
pub(crate) fn not_cylindrical(stage: usize, kind: &str) -> Fault {
    Fault::new(
        Code::E133,
        format!("stage {stage} is a {kind}: only cylindrical gears can be modelled"),
    )
}

/// The load case does not exist.
pub(crate) fn no_load_case(wanted: usize, count: usize) -> Fault {
    Fault::new(
        Code::E133,
        format!("there is no load case {wanted}; the file has {count}"),
    )
}
