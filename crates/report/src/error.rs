//! Errors of reading and writing results. No incomplete result is left behind.

use std::path::Path;

use asperity_core::{Code, Fault, Remedy, Setting};
use asperity_roughness::RoughnessError;
use asperity_storage::{NotFinite, NotJson, StorageError};
use asperity_table::own::{OwnFault, Unwritten};

/// The result is missing or was not written by Asperity.
pub(crate) fn not_a_result(path: &Path, reason: &'static str) -> Fault {
    Fault::new(
        Code::E402,
        format!(
            "{path}: not a result of asperity run: {reason}",
            path = path.display()
        ),
    )
}

/// The folder holds the result of a gear train, which has one for each mesh.
pub(crate) fn of_train(path: &Path) -> Fault {
    Fault::new(
        Code::E402,
        format!(
            "{path}: the result of a gear train; name the folder of one of its meshes",
            path = path.display()
        ),
    )
}

/// A value of `result.json` is missing or damaged; `key` is empty for the whole.
pub(crate) fn damaged(path: &Path, key: &str, source: serde_json::Error) -> Fault {
    let at = if key.is_empty() { "" } else { ": " };
    Fault::new(
        Code::E402,
        format!(
            "{path}: not a result of asperity run: {key}{at}{source}",
            path = path.display()
        ),
    )
}

/// A table next to `result.json` is missing, damaged or belongs to another result.
pub(crate) fn bad_table(path: &Path, reason: OwnFault) -> Fault {
    Fault::new(
        Code::E402,
        format!(
            "{path}: not a table of this result: {reason}",
            path = path.display()
        ),
    )
}

/// A model choice is neither among the inputs nor among the defaults.
pub(crate) fn no_value(key: &'static str) -> Fault {
    Fault::new(
        Code::E402,
        format!("result.json: {key} is neither among the inputs nor among the defaults"),
    )
}

/// The position does not exist.
pub(crate) fn no_such_position(number: usize, count: usize) -> Fault {
    Fault::new(
        Code::E402,
        format!("position {number} is not among the {count} of the result"),
    )
    .helping("Positions are numbered from 1, as in the column position of path.csv.")
}

/// The fields of the position were not stored.
pub(crate) fn no_fields(number: usize, place: Option<&Path>) -> Fault {
    let place = place.map_or_else(String::new, |place| format!(" in {}", place.display()));
    Fault::new(
        Code::E402,
        format!("the fields of position {number} were not stored{place}"),
    )
    .with(
        Remedy::state(Setting::Key("fields")).because("with this position, and run the case again"),
    )
}

/// A trace cannot be prepared.
pub(crate) fn of_flank(error: RoughnessError) -> Fault {
    Fault::from_cause(Code::E401, error)
}

/// A value cannot be written as JSON.
pub fn of_json(error: serde_json::Error) -> Fault {
    Fault::from_cause(Code::E401, error).about("result.json")
}

/// Error of the system at `path`.
pub(crate) fn io(path: &Path) -> impl Fn(std::io::Error) -> Fault {
    let path = path.to_owned();
    move |source| StorageError::io(&path)(source).into()
}

/// Error of a table at `path`.
pub(crate) fn unwritten(path: &Path) -> impl Fn(Unwritten) -> Fault {
    let path = path.to_owned();
    move |reason| match reason {
        Unwritten::NotFinite(source) => not_finite(&path)(source),
        reason => Fault::from_cause(Code::E401, reason).about(path.display()),
    }
}

/// Error of a value that is not written as JSON at `path`.
pub(crate) fn not_json(path: &Path) -> impl Fn(NotJson) -> Fault {
    let path = path.to_owned();
    move |reason| match reason {
        NotJson::NotFinite(source) => not_finite(&path)(source),
        NotJson::Other(source) => Fault::from_cause(Code::E401, source).about(path.display()),
    }
}

/// Error of a number at `path`, which is not written.
pub(crate) fn not_finite(path: &Path) -> impl Fn(NotFinite) -> Fault {
    let path = path.to_owned();
    move |source| {
        let fault = Fault::from_cause(Code::E501, source).about("not written");
        fault.about(path.display())
    }
}
