//! Errors of a film or a regime.

use asperity_core::numerics::RootError;
use asperity_core::{Code, Fault, number};

asperity_core::fault_error! {
    /// Errors of film thickness and regime.
    RegimeError
}

impl RegimeError {
    /// A film law, by its name in a case file, needs an input, by its field name, that was not given.
    pub(crate) fn missing_input(law: &'static str, input: &'static str) -> Self {
        Fault::new(Code::E205, format!("the film law {law} needs {input}")).into()
    }

    /// The flow through a patch, which after `iterations` differs by `uneven` of it between sections.
    pub(crate) fn no_flow(uneven: f64, iterations: usize) -> Self {
        let text = format!(
            "the flow through a rough patch differs by {} of it between sections after {iterations} iterations",
            number(uneven)
        );
        Fault::new(Code::E301, text).into()
    }

    /// The gap that an inlet supplies to a rough patch, without root.
    pub(crate) fn no_inlet(error: &RootError) -> Self {
        let text =
            format!("the gap that the inlet supplies to a rough patch has no solution: {error}");
        Fault::new(Code::E301, text).into()
    }
}
