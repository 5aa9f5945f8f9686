//! Settings of a calibration, and of a design of measurements for one.

use asperity::case::{CalibratedName, Case, LoadedCase};
use asperity_core::Fault;
use asperity_core::quantity::{AngularSpeed, Ratio};
use asperity_report::{Nodes, StudySettings, Watch, Work, settings};

use crate::design::{Design, Limits, plan, simulated};
use crate::error;
use crate::files::RigFiles;
use crate::identifiability::rounded;
use crate::result::Calibration;
use crate::rig_table::Reach;

settings! {
    /// Settings of a calibration.
    pub struct CalibrationSettings {
        /// Hold a parameter at the value of the case instead of fitting it; repeat for several
        [value_name = "PARAMETER"] hold: Vec<CalibratedName>,
        /// Largest torque of the rig at the pinion in N m [default: the largest of the table; of a design map.torque_max of
        /// the case, or its torque]
        [long = "torque-max", value_name = "N_M"] torque_max_nm: Option<f64>,
        /// Largest speed of the rig at the pinion in 1/min [default: the largest of the table; of a design map.speed_max of
        /// the case, or its speed]
        [long = "speed-max", value_name = "RPM"] speed_max_rpm: Option<f64>,
        /// Oil temperatures of the rig in °C: a..b:n or a list [default: lowest, middle and highest of the table; of a design
        /// 40,65,90, extended to the temperature of the case]
        [value_name = "AXIS"] temperature: Option<Nodes>,
    }
}

impl CalibrationSettings {
    /// Reach of the rig.
    ///
    /// # Errors
    /// When a limit is not positive, or the temperatures are not an axis.
    pub fn reach(&self) -> Result<Reach, Fault> {
        let limits = [
            ("torque_max_nm", self.torque_max_nm),
            ("speed_max_rpm", self.speed_max_rpm),
        ];
        for (name, value) in limits {
            if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
                return Err(error::limit(name, value, "must be positive"));
            }
        }
        Ok(Reach {
            torque_max_nm: self.torque_max_nm,
            speed_max_rpm: self.speed_max_rpm,
            temperatures_c: nodes("temperature", self.temperature.as_ref())?,
        })
    }
}

impl StudySettings for CalibrationSettings {
    type Input = RigFiles;
    type Found = Calibration;
    const COMMAND: &'static str = "calibrate";
    const FOLDER: &'static str = "calibration";
    const ABOUT: &'static str =
        "Boundary friction, boundary layer and film traction from losses measured on a rig";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[
            ("rig", "rig.csv"),
            ("case", "case.toml"),
            ("output", "results/rig"),
        ],
        &[
            ("rig", "rig.csv"),
            ("case", "case.toml"),
            ("hold", "boundary-layer"),
        ],
    ];
    const METHOD: &'static str = "The table has one row per measured point: torque_nm, speed_rpm, temperature_c, loss_w (or \
        torque_loss_nm), sigma_w, includes (mesh or mesh+bearings), and where known assembly, run, order, flank_state, case. The \
        result says what the points can identify. calibration.toml in it holds the table [calibration] for the case.";
    const STEPS: &'static str = "evaluations";

    fn work(&self, _: &RigFiles) -> Result<Option<Work>, Fault> {
        self.reach()?;
        Ok(None)
    }

    fn run(&self, mut rig: RigFiles, watch: &Watch<'_>) -> Result<Calibration, Fault> {
        rig.table.reach = self.reach()?;
        rig.calibrate(&self.hold, watch)
    }
}

settings! {
    /// Settings of a design of measurements.
    pub struct DesignSettings {
        /// Torques to choose from in N m, or with a final % in percent of the torque of the case: a..b:n, a..b:n:log or a list
        /// [default: a third of the largest, and the largest]
        [value_name = "AXIS", conflicts_with = "torque_max_nm"] torque: Option<Nodes>,
        /// Speeds to choose from in 1/min, or in % of the speed of the case [default: 8 speeds from a fiftieth of the largest up to it]
        [value_name = "AXIS", conflicts_with = "speed_max_rpm"] speed: Option<Nodes>,
        /// Measuring time in hours, without heating
        [value_name = "H"] hours: f64 = 8,
        /// Minutes per point
        [long = "minutes", value_name = "MIN"] minutes_per_point: f64 = 15,
        /// Standard deviation of a point relative to its loss
        [value_name = "SHARE"] sigma: Ratio = "3 %",
        /// Number of assemblies; each measures all points
        [value_name = "N"] assemblies: usize = 2,
        /// Also write simulated.csv: losses at these points, simulated with the case and random errors of this seed, to
        /// test a calibration
        [value_name = "SEED"] simulate: Option<u64>,
        ..rig: CalibrationSettings,
    }
}

fn nodes(name: &str, stated: Option<&Nodes>) -> Result<Option<Vec<f64>>, Fault> {
    stated.map(|stated| stated.nodes(name)).transpose()
}

impl DesignSettings {
    /// Limits of the rig with the gears of `case`.
    ///
    /// # Errors
    /// As [`CalibrationSettings::reach`], and when torques or speeds are not an axis.
    pub fn limits(&self, case: &Case) -> Result<Limits, Fault> {
        /// Default number of speeds.
        const SPEEDS: usize = 8;
        /// Lowest default speed relative to the highest.
        const SLOWEST: f64 = 0.02;
        /// Ends of the default range of oil temperatures \[°C\].
        const TEMPERATURES: [f64; 2] = [40.0, 90.0];
        let reach = self.rig.reach()?;
        let map = case.input.map.unwrap_or_default();
        let torque = map.torque_max.unwrap_or(case.torque).si();
        let torque = reach
            .torque_max_nm
            .map_or(torque, |most| most.copysign(case.torque.si()));
        let rpm = |speed: AngularSpeed| speed.si() * 30.0 / std::f64::consts::PI;
        let speed = rpm(map.speed_max.unwrap_or(case.speed));
        let speed = reach.speed_max_rpm.unwrap_or(speed);
        let even = |k: usize| {
            if k + 1 == SPEEDS {
                speed
            } else {
                rounded(speed * SLOWEST.powf(1.0 - k as f64 / (SPEEDS - 1) as f64))
            }
        };
        let at = case.stated_temperature.celsius();
        let [cold, hot] = [at.min(TEMPERATURES[0]), at.max(TEMPERATURES[1])];
        Ok(Limits {
            torques_nm: Nodes::of_case(self.torque.as_ref(), "torque", case.torque.si())?
                .unwrap_or_else(|| vec![rounded(torque / 3.0), torque]),
            speeds_rpm: Nodes::of_case(self.speed.as_ref(), "speed", rpm(case.speed))?
                .unwrap_or_else(|| (0..SPEEDS).map(even).collect()),
            temperatures_c: reach
                .temperatures_c
                .unwrap_or_else(|| vec![cold, (0.5 * (cold + hot)).round(), hot]),
            hours: self.hours,
            minutes_per_point: self.minutes_per_point,
            sigma: self.sigma.value(),
            assemblies: self.assemblies,
        })
    }
}

impl StudySettings for DesignSettings {
    type Input = LoadedCase;
    type Found = Design;
    const COMMAND: &'static str = "design";
    const ABOUT: &'static str =
        "Points of a rig whose losses determine the calibrated constants best";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[&[
        ("case", "case.toml"),
        ("hours", "8"),
        ("torque_max_nm", "180"),
        ("speed_max_rpm", "3000"),
    ]];
    const METHOD: &'static str = "Points within the limits are chosen that narrow the constants most, the gears and flanks of the case \
        being on the rig. design.csv in the result is the table to fill in for asperity calibrate.";
    const STEPS: &'static str = "evaluations";

    fn work(&self, case: &LoadedCase) -> Result<Option<Work>, Fault> {
        // The contacts of every torque.
        let torques = self.limits(&case.case)?.torques_nm.len();
        Ok(Some(Work::new(vec![case.clone()], torques)))
    }

    fn run(&self, case: LoadedCase, watch: &Watch<'_>) -> Result<Design, Fault> {
        let limits = self.limits(&case.case)?;
        let mut found = plan(&case, &limits, &self.rig.hold, watch.progress)?;
        let losses = self.simulate.map(|seed| simulated(&case, &found, seed));
        found.simulated_w = losses.transpose()?;
        Ok(found)
    }
}
