//! Errors of exports.

use asperity_core::number;
use asperity_core::remedy::{Remedy, Setting};
use asperity_core::{Code, Fault};

use crate::map::Map;

/// A point has no result.
pub(crate) fn holes(map: &Map) -> Fault {
    let holes = map.holes().unwrap_or_default();
    Fault::new(Code::E205, format!("nothing is exported: {holes}"))
}

/// Two files would have one name.
pub(crate) fn same_file(finishes: [&str; 2], name: &str) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "finishes {:?} and {:?} would both be exported as {name}: a name of a file has only letters, digits, - and _, and capitals count as small letters. Change one of the names",
            finishes[0], finishes[1]
        ),
    )
}

/// The format needs torques of both signs.
pub(crate) fn one_sign(format: &'static str) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{format} needs torques of both signs, from beyond the smallest to beyond the largest"
        ),
    )
}

/// The format needs more than one node along both axes.
pub(crate) fn too_small(format: &'static str) -> Fault {
    Fault::new(
        Code::E205,
        format!("{format} needs at least two torques and two speeds"),
    )
}

/// The format needs the ratio of input and output speed.
pub(crate) fn no_ratio(format: &'static str) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{format} needs the ratio of input and output speed, and several shafts of the train are outputs"
        ),
    )
}

/// The loss torque rises faster than the torque.
pub(crate) fn slope(format: &'static str, torque_nm: f64, speed_rpm: f64) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{format} cannot hold this map: near {torque_nm} N m and {speed_rpm} 1/min the loss torque rises faster than the torque",
            torque_nm = number(torque_nm),
            speed_rpm = number(speed_rpm)
        ),
    )
}

/// The format needs a cycle as weight.
pub(crate) fn no_cycle(format: &'static str) -> Fault {
    Fault::new(
        Code::E205,
        format!("{format} takes one number, weighted by a cycle, and no cycle was given"),
    )
    .with(Remedy::state(Setting::Key("cycle")))
}

/// The pinion never drives in the cycle.
pub(crate) fn no_drive(format: &'static str) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{format} takes the efficiency while the input drives, and in this cycle it never does"
        ),
    )
}

/// The cycle is partly outside of the map.
pub(crate) fn uncovered(format: &'static str, source: crate::cycle::Uncovered) -> Fault {
    Fault::new(
        Code::E205,
        format!("{format} takes one number, weighted by a cycle: {source}"),
    )
}

/// A file cannot be made.
pub(crate) fn unwritten(reason: impl std::fmt::Display) -> Fault {
    Fault::new(Code::E205, format!("cannot be written: {reason}"))
}
