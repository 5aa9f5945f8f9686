//! Errors of a film or a regime.

use asperity_core::{Code, Fault};

asperity_core::fault_error! {
    /// Errors of film thickness and regime.
    RegimeError
}

impl RegimeError {
    /// A film law, by its name in a case file, needs an input, by its field name, that was not given.
    pub(crate) fn missing_input(law: &'static str, input: &'static str) -> Self {
        Fault::new(Code::E205, format!("the film law {law} needs {input}")).into()
    }
}
