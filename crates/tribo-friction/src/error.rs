//! Errors of a friction coefficient or force.

use asperity_core::numerics::RootError;
use asperity_core::{Code, Fault};
use asperity_oil::LubricantError;

asperity_core::fault_error! {
    /// Errors of friction laws.
    FrictionError
}

impl FrictionError {
    /// A friction law, by its name in a case file, needs a setting, by its field name.
    pub(crate) fn missing_setting(law: &'static str, setting: &'static str) -> Self {
        let text = format!("the friction law {law} needs the setting {setting}");
        Fault::new(Code::E205, text).into()
    }

    /// Two pressure fields of different size.
    pub(crate) fn field_lengths(solid: usize, fluid: usize) -> Self {
        let text = format!(
            "{solid} solid and {fluid} fluid pressures; both must be given at the same points"
        );
        Fault::new(Code::E209, text).into()
    }

    /// A coefficient file that cannot be read; the message of the JSON reader has line and column.
    pub(crate) fn coefficient_file(error: serde_json::Error) -> Self {
        let fault = Fault::new(Code::E209, format!("coefficient file: {error}"));
        fault.caused_by(error).into()
    }

    /// An equation for `quantity` without a root.
    pub(crate) fn no_root(quantity: &'static str, source: RootError) -> Self {
        let text = format!("the {quantity} has no solution: {source}");
        Fault::new(Code::E209, text).caused_by(source).into()
    }
}

/// The oil has no state or no shear stress at a temperature of the film.
impl From<LubricantError> for FrictionError {
    fn from(error: LubricantError) -> Self {
        Fault::from_cause(Code::E209, error).into()
    }
}
