//! Settings of the studies of oils.

use asperity::LoadedCase;
use asperity::tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_core::quantity::{Force, Length, Ratio, Speed, Temperature, Time};
use asperity_core::{Code, DomainError, Fault};
use asperity_report::{Input, Nodes, Setting, StudySettings, Watch, Work, settings};

use super::error::of_table;
use super::fit::PointErrors;
use super::problem::Zero;
use super::{
    FitSettings, Machine, OilBase, OilFit, OilPlan, PlanSettings, Probe, Readings, Stribeck,
    TractionCurves, TractionRange,
};
use crate::files::table_text;

/// An oil whose traction is predicted.
#[derive(Debug, Clone)]
pub struct OfOil(pub OilBase);

/// An oil to measure, and the case whose loss the measurements are to narrow.
#[derive(Debug, Clone)]
pub struct OilOfCase {
    /// The oil.
    pub oil: OilBase,
    /// The case.
    pub case: Option<LoadedCase>,
    /// Whether the oil is of the case.
    pub is_of_case: bool,
}

impl OilOfCase {
    /// `oil`, which is of the case `of` if it is of one, and the case whose loss is to be narrowed: `case`, or else `of`.
    #[must_use]
    pub fn new(oil: OilBase, of: Option<LoadedCase>, case: Option<LoadedCase>) -> Self {
        let is_of_case = match (&of, &case) {
            (Some(of), Some(case)) => of.case.input == case.case.input,
            (of, _) => of.is_some(),
        };
        let case = case.or(of);
        Self {
            oil,
            case,
            is_of_case,
        }
    }
}

/// Curves of a machine, measured with an oil.
#[derive(Debug, Clone)]
pub struct MeasuredOil {
    /// The curves.
    pub curves: Vec<Curves>,
    /// The oil.
    pub oil: OilBase,
}

/// Table or text export of curves.
#[derive(Debug, Clone)]
pub struct Curves {
    /// Name of the file, or another one.
    pub name: String,
    /// Text.
    pub text: String,
}

impl Curves {
    /// The curves in a file.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn open(file: &std::path::Path) -> Result<Self, Fault> {
        Ok(Self {
            name: file.display().to_string(),
            text: table_text(file).map_err(of_table)?,
        })
    }
}

fn oil(about: &'static str) -> Setting {
    Setting::new("oil", "Oil", about, None)
}

impl Input for OfOil {
    fn described() -> Vec<Setting> {
        vec![oil("The oil")]
    }

    fn title(&self) -> String {
        TractionCurves::title_of(&self.0)
    }
}

impl Input for OilOfCase {
    fn described() -> Vec<Setting> {
        let about =
            "The case whose loss is to be narrowed [default: the case of the oil if it is of one]";
        let case = Setting::new("case", "Option<Case>", about, None);
        vec![oil("The oil"), case]
    }

    fn title(&self) -> String {
        OilPlan::title_of(&self.oil)
    }
}

impl Input for MeasuredOil {
    fn described() -> Vec<Setting> {
        let about = "One or several files, frames or columns, with the columns of the command";
        let curves = Setting::new("curves", "Vec<Curves>", about, None);
        vec![curves, oil("The oil, for viscosity and family")]
    }

    fn title(&self) -> String {
        OilFit::title_of(&self.oil)
    }
}

settings! {
    /// Specimens of a machine.
    pub struct Specimens {
        /// Root mean square roughness of both specimens together
        rq: Length = "15 nm",
        /// Radius of the ball, unless a row states it
        ball_radius: Length = "9.525 mm",
        /// Radius of the second body, unless a row states it [default: a flat disc]
        second_radius: Option<Length>,
    }
}

impl Specimens {
    /// The machine of these specimens.
    ///
    /// # Errors
    /// When a length is not positive.
    pub fn machine(&self) -> Result<Machine, Fault> {
        Ok(Machine::ball_on_disc(
            self.ball_radius,
            self.second_radius,
            self.rq,
        )?)
    }
}

settings! {
    /// Priors of the constants and errors of the points.
    pub struct PriorSettings {
        /// Leave the constants to the points, with wide priors instead of the family
        wide: bool,
        /// Zeros of the friction
        zero: Zero = "curve",
        /// Standard deviation of points without sigma, relative to the friction
        point_sd: Ratio = "1.5 %",
        /// Least standard deviation of the friction coefficient of such points
        point_floor: f64 = 0.0003,
    }
}

impl PriorSettings {
    /// Errors of the points that state none.
    ///
    /// # Errors
    /// When they are not between 0 and 1.
    pub fn errors(&self) -> Result<PointErrors, Fault> {
        let errors = PointErrors {
            relative: self.point_sd.value(),
            floor: self.point_floor,
        };
        for (name, value) in [("point_sd", errors.relative), ("point_floor", errors.floor)] {
            let rule = "must be positive and below 1";
            DomainError::require(value > 0.0 && value < 1.0, name, value, "-", rule)?;
        }
        Ok(errors)
    }
}

settings! {
    /// Settings of predicted traction.
    pub struct TractionSettings {
        /// Load
        load: Force = "30 N",
        /// Mean speed of the curves over the slide-to-roll ratio
        speed: Speed = "2 m/s",
        /// Slide-to-roll ratio of the curves over the speed
        slide_to_roll: Ratio = "5 %",
        /// Temperatures of the oil bath in °C: a..b:n or a list
        [value_name = "AXIS"] temperature: Nodes = "40,80,120",
        /// Boundary friction to which the dashed guide of the chart leads [default: the value of the model]
        boundary_friction: Option<f64>,
        ..specimens: Specimens,
    }
}

impl StudySettings for TractionSettings {
    type Input = OfOil;
    type Found = TractionCurves;
    const COMMAND: &'static str = "oil traction";
    const FUNCTION: &'static str = "oil_traction";
    const FOLDER: &'static str = "traction";
    const ABOUT: &'static str =
        "Traction of the film between ball and disc, over slide-to-roll ratio and speed";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("oil", "m100")],
        &[
            ("oil", "case.toml"),
            ("load", "20 N"),
            ("speed", "1 m/s"),
            ("temperature", "40,80,120"),
        ],
    ];
    const METHOD: &'static str = "Predicted where the film is at least three times as thick as the roughness. The specimens are of \
        through-hardened steel (21 W/(m K)). The tables have the columns of a measured traction curve.";
    const STEPS: &'static str = "";

    fn work(&self, _: &OfOil) -> Result<Option<Work>, Fault> {
        Ok(None)
    }

    fn run(&self, OfOil(oil): OfOil, _: &Watch<'_>) -> Result<TractionCurves, Fault> {
        let boundary_friction = self.boundary_friction.unwrap_or(BOUNDARY_FRICTION);
        let is_valid = boundary_friction > 0.0 && boundary_friction < 1.0;
        let (name, rule) = ("boundary_friction", "must lie between 0 and 1");
        DomainError::require(is_valid, name, boundary_friction, "-", rule)?;
        let temperatures = self.temperature.nodes("temperature")?;
        let range = TractionRange {
            machine: self.specimens.machine()?,
            load: self.load,
            mean_speed: self.speed,
            slide_to_roll: self.slide_to_roll.value(),
            temperatures: temperatures
                .into_iter()
                .map(Temperature::from_celsius)
                .collect(),
            boundary_friction,
        };
        TractionCurves::new(&oil, &range)
    }
}

settings! {
    /// Settings of a fit of constants.
    pub struct OilFitSettings {
        /// Probe of the temperature in a text export
        temperature_column: Probe = "lube",
        /// Accept constants of no known oil
        force: bool,
        ..specimens: Specimens,
        ..priors: PriorSettings,
    }
}

impl StudySettings for OilFitSettings {
    type Input = MeasuredOil;
    type Found = OilFit;
    const COMMAND: &'static str = "oil fit";
    const FUNCTION: &'static str = "oil_fit";
    const FOLDER: &'static str = "oil";
    const ABOUT: &'static str =
        "Constants of an oil from measured traction curves of ball and disc, with their intervals";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("curves", "curves.csv"), ("oil", "m100")],
        &[
            ("curves", "mtm.txt"),
            ("oil", "case.toml"),
            ("temperature_column", "pot"),
            ("output", "results/my-oil"),
        ],
    ];
    const METHOD: &'static str = "A table has the columns load_n, mean_speed_m_s, slide_roll_percent (200 is pure sliding), temperature_c \
        and traction, and where known sigma, group, set_temperature_c, film_nm and the specimens; a text export of a PCS machine is read \
        as it is. oil.toml in the result is the oil file that a case names by lubricant.oil_file.";
    const STEPS: &'static str = "";

    fn work(&self, _: &MeasuredOil) -> Result<Option<Work>, Fault> {
        Ok(None)
    }

    fn run(&self, given: MeasuredOil, _: &Watch<'_>) -> Result<OilFit, Fault> {
        let machine = self.specimens.machine()?;
        let settings = FitSettings {
            is_wide: self.priors.wide,
            zero: self.priors.zero,
            errors: self.priors.errors()?,
            is_forced: self.force,
        };
        let mut readings = Readings::default();
        for Curves { name, text } in &given.curves {
            readings.append(Readings::read(
                name,
                text,
                &machine,
                self.temperature_column,
            )?);
        }
        OilFit::new(&given.oil, readings, settings)
    }
}

settings! {
    /// Settings of a plan of measurements.
    pub struct OilPlanSettings {
        /// Write simulated.csv with simulated friction of the standard plan, with this seed
        [value_name = "SEED"] simulate: Option<u64>,
        ..specimens: Specimens,
        ..priors: PriorSettings,
    }
}

impl OilPlanSettings {
    /// The settings as the computation takes them.
    ///
    /// # Errors
    /// When a setting has no sense.
    pub fn plan(&self) -> Result<PlanSettings, Fault> {
        Ok(PlanSettings {
            machine: self.specimens.machine()?,
            is_wide: self.priors.wide,
            zero: self.priors.zero,
            errors: self.priors.errors()?,
            simulate: self.simulate,
        })
    }
}

settings! {
    /// Settings of an evaluation of Stribeck curves.
    pub struct StribeckSettings {
        /// Time of rubbing before each file, 0 s for new specimens, unless a row states it
        [value_delimiter = ','] rubbing: Vec<Time>,
        /// Probe of the temperature in a text export
        temperature_column: Probe = "lube",
        ..specimens: Specimens,
    }
}

impl StudySettings for StribeckSettings {
    type Input = MeasuredOil;
    type Found = Stribeck;
    const COMMAND: &'static str = "oil stribeck";
    const FUNCTION: &'static str = "stribeck";
    const FOLDER: &'static str = "stribeck";
    const ABOUT: &'static str =
        "Boundary friction from Stribeck curves of ball and disc, with its interval";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("curves", "stribeck.csv"), ("oil", "m100")],
        &[
            ("curves", "new.txt"),
            ("curves", "rubbed.txt"),
            ("rubbing", "0 s,2 h"),
            ("oil", "case.toml"),
        ],
    ];
    const METHOD: &'static str = "The files have the columns of a traction curve, and rubbing_s, the time for which the specimens have \
        rubbed before. Points with a film of at most a fifth of the roughness count. How much of the load of gears the layer carries \
        does not follow from them: model.inner_boundary is drawn.";
    const STEPS: &'static str = "";

    fn title(given: &MeasuredOil) -> String {
        Stribeck::title_of(&given.oil)
    }

    fn work(&self, given: &MeasuredOil) -> Result<Option<Work>, Fault> {
        if !self.rubbing.is_empty() && self.rubbing.len() != given.curves.len() {
            let rule = "rubbing: takes one time for each file";
            return Err(Fault::new(Code::E205, rule));
        }
        let rule = "must not be negative";
        for time in &self.rubbing {
            DomainError::require(time.si() >= 0.0, "rubbing", time.si(), "s", rule)?;
        }
        Ok(None)
    }

    fn run(&self, given: MeasuredOil, _: &Watch<'_>) -> Result<Stribeck, Fault> {
        self.work(&given)?;
        let machine = self.specimens.machine()?;
        let mut all = Readings::default();
        for (k, Curves { name, text }) in given.curves.iter().enumerate() {
            let mut readings = Readings::read(name, text, &machine, self.temperature_column)?;
            let stated = self.rubbing.get(k).map(|time| time.si());
            for reading in &mut readings.all {
                reading.rubbing_s = reading.rubbing_s.or(stated);
            }
            all.append(readings);
        }
        Stribeck::new(&given.oil, all)
    }
}
