//! Errors of film computations.

use asperity_core::{Code, Fault, number};

asperity_core::fault_error! {
    /// Errors of the film pressure.
    FilmError
}

impl FilmError {
    /// Too few points along the film.
    pub(crate) fn too_few_points(points: usize, least: usize) -> Self {
        let text = format!("{points} points are too few for a film: give at least {least}");
        Fault::new(Code::E209, text).into()
    }

    /// An array does not have one value per point: `got` values where `need` are needed.
    pub(crate) fn wrong_length(name: &'static str, need: usize, got: usize) -> Self {
        let text = format!("{name} has {got} values where {need} are needed");
        Fault::new(Code::E209, text).into()
    }

    /// The value \[m\] of an array at `index` violates a rule.
    pub(crate) fn bad_element(
        name: &'static str,
        index: usize,
        value: f64,
        rule: &'static str,
    ) -> Self {
        let text = format!("{name}[{index}] = {} m: {rule}", number(value));
        Fault::new(Code::E209, text).into()
    }
}
