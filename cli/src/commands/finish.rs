//! A case on the traces of a finish.

use std::io::ErrorKind;
use std::path::PathBuf;

use asperity::case::CaseInput;
use asperity_storage::regular_file;

use crate::args::FinishArg;
use crate::failure::Failure;

/// Rejects finishes with equal names.
pub fn check_names(finishes: &[FinishArg]) -> Result<(), Failure> {
    for (index, finish) in finishes.iter().enumerate() {
        let before = &finishes[..index];
        if before.iter().any(|other| other.name == finish.name) {
            let name = &finish.name;
            let message = format!("--finish {name}: two finishes have this name; rename one");
            return Err(Failure::new("E205", message));
        }
    }
    Ok(())
}

/// Traces of a finish by absolute path.
pub struct Traces {
    pinion: PathBuf,
    wheel: Option<PathBuf>,
}

impl Traces {
    /// The traces that `finish` names.
    pub fn of(finish: &FinishArg) -> Result<Self, Failure> {
        let name = &finish.name;
        let whole = |file: &PathBuf| {
            // Reported here, because the case does not name this file.
            if let Err(error) = regular_file(file) {
                let reason = match error.kind() {
                    ErrorKind::NotFound => "there is no such file".to_owned(),
                    _ => error.to_string(),
                };
                let message = format!("{}: {reason} (named by --finish {name})", file.display());
                return Err(Failure::new("E103", message));
            }
            std::path::absolute(file)
                .map_err(|error| Failure::new("E103", format!("{}: {error}", file.display())))
        };
        Ok(Self {
            pinion: whole(&finish.pinion)?,
            wheel: finish.wheel.as_ref().map(whole).transpose()?,
        })
    }

    /// Replaces the traces of the case; a single trace is used for both flanks, mirrored for the wheel.
    pub fn put_into(&self, input: &mut CaseInput) {
        input
            .surface
            .put_traces(&self.pinion, self.wheel.as_deref());
    }
}
