//! The run of a case, with what it holds and what it draws: the only way to compute one.

use std::borrow::Cow;

use crate::contacts::Contacts;
use crate::evidence::{CurvePlan, Effort, Evidence};
use crate::pipeline::{self, Kept, Options, Progress};
use crate::train::{self, Outcome, TrainLosses};
use asperity_case::case::OperatingCase;
use asperity_case::case::train::Train;
use asperity_case::error::Error;
use asperity_case::message::Warning;

/// A run of a gear train, or of a pair of gears, which is a train of one mesh; built by its options.
///
/// ```
/// use asperity::pipeline::Kept;
/// use asperity::{Run, case};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(4));
/// })?;
/// let found = Run::new(&case).interval(true).pictures(Kept::Highest).execute()?.into_only()?;
/// let loss = found.result.uncertainty.ok_or("the default model has an interval")?.loss;
/// assert!(loss.quantiles_w[0] < found.result.summary.loss_w);
/// assert_eq!(found.fields.len(), 1);
///
/// // Another temperature by the contacts of the first run: film laws only.
/// let contacts = Run::new(&case).contacts()?;
/// let cooler = case.with_key("operation.bulk_temperature", "70 °C")?;
/// let losses = Run::new(&cooler).known(&contacts).losses()?.into_only()?;
/// assert_eq!(losses.summary, Run::new(&cooler).execute()?.into_only()?.result.summary);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
#[must_use = "a run does nothing until it is executed"]
pub struct Run<'a> {
    train: Cow<'a, Train>,
    options: Options<'a>,
    plan: Option<&'a CurvePlan<'a>>,
}

impl<'a> Run<'a> {
    /// A run with pictures of every position, the fields of all of them, and without the interval of the loss.
    pub fn new(case: impl Into<Cow<'a, Train>>) -> Self {
        Self {
            train: case.into(),
            options: Options::default(),
            plan: None,
        }
    }

    /// Holds the fields of the positions `kept` only: with the stress below the surface they are a megabyte each.
    pub fn pictures(mut self, kept: Kept) -> Self {
        self.options.kept = kept;
        self
    }

    /// Computes the interval of the loss, if `interval` is set and the model of the case has one. It costs no further contact.
    pub fn interval(mut self, interval: bool) -> Self {
        self.options.interval = interval;
        self
    }

    /// Names the measurements that would narrow the interval, among them the traction curves that `plan` has for the oil.
    pub fn evidence(mut self, plan: &'a CurvePlan<'a>) -> Self {
        self.plan = Some(plan);
        self
    }

    /// Uses contacts that were computed before. Those of this case, at any oil, speed and temperature, are not computed again; of others
    /// the windows under the same load are shared. Losses equal those without to the last digit.
    pub fn known(mut self, contacts: impl IntoIterator<Item = &'a Contacts>) -> Self {
        self.options.known.extend(contacts);
        self
    }

    /// Takes the first equilibrium of the bulk temperature of each mesh, and does not look for a hotter one.
    pub fn coldest(mut self) -> Self {
        self.options.seeks_hotter = false;
        self
    }

    /// Calls `progress` with (done, total) after each step.
    pub fn progress(mut self, progress: Progress<'a>) -> Self {
        self.options.progress = progress;
        self
    }

    /// Runs the case. The same input gives the same result to the last digit on any number of threads of one type of
    /// processor; transforms round differently with and without AVX2, which moves losses by some 1e-8 of their value.
    ///
    /// # Errors
    /// When a position has no solution; the first one along the path is named. When losses that are passed on do not settle.
    pub fn execute(self) -> Result<Outcome, Error> {
        let mut outcome = train::run(&self.train, &self.options)?;
        if let Some(plan) = self.plan
            && let Some(evidence) = Evidence::from_outcome(&outcome, &Effort::usual(), plan)?
        {
            outcome.put_evidence(evidence.rows);
        }
        Ok(outcome)
    }

    /// Losses only, equal to the losses of [`execute`](Self::execute) to the last digit.
    ///
    /// # Errors
    /// As [`execute`](Self::execute).
    pub fn losses(self) -> Result<TrainLosses, Error> {
        train::losses(&self.train, &self.options)
    }

    /// The rough contacts of each mesh at every position and offset: they depend on neither oil, speed nor temperature.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for a contact.
    pub fn contacts(self) -> Result<Vec<Contacts>, Error> {
        train::contacts(&self.train, &self.options.known)
    }

    /// The train at the oil temperature and the torques that its losses cause.
    ///
    /// # Errors
    /// When a mesh has no solution, or temperature or torques do not settle.
    pub fn settled(self) -> Result<Train, Error> {
        train::settled(&self.train)
    }

    /// The case of the only mesh at its bulk temperature, stated or in equilibrium with its loss.
    ///
    /// ```
    /// use asperity::{Run, case};
    /// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    /// let case = case::load_with(file, &|input| {
    ///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    /// })?;
    /// assert!(Run::new(&case).operating_case()?.bulk_report().is_none());
    /// let unknown = case.with(|input| {
    ///     let _ = input.set("operation.oil_temperature", "90 °C");
    ///     let _ = input.set("operation.bulk", r#"{ law = "iso", lubrication = "jet" }"#);
    /// })?;
    /// let settled = Run::new(&unknown).operating_case()?;
    /// let bulk = settled.bulk_report().ok_or("it is computed")?;
    /// assert!(bulk.bulk_c > bulk.oil_c + 5.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the case has several meshes, a position has no solution, or the temperature does not settle.
    pub fn operating_case(self) -> Result<OperatingCase, Error> {
        pipeline::settled(self.train.only_mesh()?, &self.options)
    }

    /// Checks all that a run checks before it solves a contact, and returns the warnings that need no solution: a warning that
    /// not all meshes have names its mesh. The parts of the gearbox are checked at the torques of a train whose meshes lose nothing.
    ///
    /// Checked are the table of the gearbox, the mesh positions with their smooth films, the place of the traces, and at the
    /// first offset of each pair of teeth the windows in contact. Reference solutions are not computed, and a bulk temperature that follows
    /// from the loss is not sought.
    ///
    /// # Errors
    /// The error with which a run ends.
    ///
    /// ```
    /// use asperity::{Run, case};
    /// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    /// Run::new(&case::load(file, None)?).check()?;
    /// // A window that is longer than the traces.
    /// let long = case::load_with(file, &|input| input.model.window = Some(40.0))?;
    /// assert_eq!(Run::new(&long).check().unwrap_err().code(), "E122");
    /// # Ok::<(), asperity::Error>(())
    /// ```
    pub fn check(self) -> Result<Vec<Warning>, Error> {
        train::check(&self.train)
    }
}
