//! The run of a case, with what it holds and what it draws.

use crate::contacts::Contacts;
use crate::pipeline::{self, KeptFields, Progress};
use crate::result::{Losses, Outcome};
use crate::uncertainty::{self, Predictive};
use asperity_case::case::LoadedCase;
use asperity_case::error::Error;

/// A run of a case, built by its options.
///
/// ```
/// use asperity::pipeline::KeptFields;
/// use asperity::{Run, case};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// let run = Run::new(&case);
/// assert_eq!(run.fields(&KeptFields::Highest).execute()?.fields.len(), 1);
/// assert_eq!(run.fields(&KeptFields::All).execute()?.fields.len(), 4);
/// assert_eq!(run.losses()?.summary, run.execute()?.result.summary);
/// # Ok::<(), asperity::Error>(())
/// ```
#[derive(Clone, Copy)]
#[must_use = "a run does nothing until it is executed"]
pub struct Run<'a> {
    case: &'a LoadedCase,
    pictures: Option<&'a KeptFields>,
    band: bool,
    progress: Progress<'a>,
}

impl<'a> Run<'a> {
    /// A run with pictures of every position, the fields of all of them, and without the uncertainty of the loss.
    pub fn new(case: &'a LoadedCase) -> Self {
        Self {
            case,
            pictures: Some(&KeptFields::All),
            band: false,
            progress: &|_, _| {},
        }
    }

    /// Holds the fields of the positions `kept` only: with the stress below the surface they are a megabyte each.
    pub fn fields(self, kept: &'a KeptFields) -> Self {
        Self {
            pictures: Some(kept),
            ..self
        }
    }

    /// Computes no pictures of contacts: no fields, no views, no stress below the surface.
    pub fn without_pictures(self) -> Self {
        Self {
            pictures: None,
            ..self
        }
    }

    /// Computes the uncertainty of the loss, if `band` is set and the model of the case has one. It costs no further
    /// contact.
    pub fn band(self, band: bool) -> Self {
        Self { band, ..self }
    }

    /// Calls `progress` with (done, total) after each step.
    pub fn progress(self, progress: Progress<'a>) -> Self {
        Self { progress, ..self }
    }

    /// Runs the case. The same input gives the same result to the last digit on any number of threads of one type of
    /// processor; transforms round differently with and without AVX2, which moves losses by some 1e-8 of their value.
    ///
    /// # Errors
    /// When a position has no solution; the first one along the path is named.
    pub fn execute(self) -> Result<Outcome, Error> {
        Ok(self.drawn(self.band)?.0)
    }

    /// Runs the case with the uncertainty of its loss, and returns its draws, which
    /// [`difference`](crate::uncertainty::difference) compares; none of a case without an uncertainty.
    ///
    /// # Errors
    /// As [`execute`](Self::execute).
    pub fn draw(self) -> Result<(Outcome, Option<Predictive>), Error> {
        let (outcome, drawn, _) = self.drawn(true)?;
        Ok((outcome, drawn))
    }

    /// The same with the solved contacts, by which [`losses_with`](crate::pipeline::losses_with) computes the loss of the case with
    /// other constants.
    ///
    /// # Errors
    /// As [`execute`](Self::execute).
    pub fn draw_with_contacts(self) -> Result<(Outcome, Option<Predictive>, Contacts), Error> {
        self.drawn(self.band)
    }

    fn drawn(self, band: bool) -> Result<(Outcome, Option<Predictive>, Contacts), Error> {
        let kept = (self.pictures, band);
        let mut found = Vec::new();
        let (outcome, drawn) =
            uncertainty::run_and_draw(self.case, kept, &mut found, self.progress)?;
        // A run adds its contacts to those that it knows.
        let contacts = match found.pop() {
            Some(contacts) => contacts,
            None => pipeline::contacts(self.case)?,
        };
        Ok((outcome, drawn, contacts))
    }

    /// Losses only, equal to the losses of [`execute`](Self::execute) to the last digit.
    ///
    /// # Errors
    /// As [`execute`](Self::execute).
    pub fn losses(self) -> Result<Losses, Error> {
        pipeline::losses_of(self.case, None, self.progress)
    }
}
