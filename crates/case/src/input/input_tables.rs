//! Tables of the case file: gears, steel, operation, flanks.

use std::path::{Path, PathBuf};

use asperity_core::decimals;
use asperity_core::hardness::Hardness;
use asperity_core::quantity::{
    Angle, AngularSpeed, Area, Density, Length, Mass, Pressure, Ratio, SpecificHeat, Temperature,
    TemperatureDifference, ThermalConductivity, Torque,
};
use asperity_gear::{AmountDirection, Gear, Plane};
use asperity_profile_io::read::{
    Abscissa, Columns, DecimalSign, Encoding, Gaps, LengthUnit, Separator, TraceLine, TraceRange,
    Uneven,
};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;

use super::bulk_input::BulkInput;
use super::contact_name::ContactName;
use super::finish::FinishName;
use super::flank_place::{FlankPlaceInput, TraceStart};
use super::gear_input::{EndReliefInput, GearFlankInput};
use super::one_or_two::OneOrTwo;
use super::rows::{OPEN, ratio, table};
use super::running_in_input::RunningInEntry;
use super::trace_list::{TraceEntry, TraceInput, TraceList};

/// Whether no key of a table is stated.
pub(crate) fn is_unstated<T: Default + PartialEq>(table: &T) -> bool {
    *table == T::default()
}

/// The table, if a key of it is stated.
pub(crate) fn stated<T: Default + PartialEq + Clone>(table: &T) -> Option<T> {
    (!is_unstated(table)).then(|| table.clone())
}

table! {
    /// The gear pair; names as in ISO 21771.
    #[derive(Default)]
    GearsInput;

    /// Numbers of teeth z, pinion then wheel; negative for a ring gear: `[24, -75]`.
    teeth: [i32; 2] = "" usual [10.0, 300.0] possible [3.0, 5000.0];
    /// Normal module m_n; the transverse one with `module_plane = "transverse"`.
    module: Length = "mm" usual [0.3, 40.0] possible [0.02, 200.0];
    /// Plane in which the module is measured; default `normal`.
    module_plane: Option<Plane>;
    /// Helix angle β; default 0 deg.
    helix: Option<Angle> = "deg" usual [-45.0, 45.0] possible OPEN;
    /// Normal pressure angle α_n; default 20 deg.
    pressure_angle: Option<Angle> = "deg" usual [14.0, 30.0] possible OPEN;
    /// Face width b, one value for both gears or `[pinion, wheel]`.
    face_width: OneOrTwo<Length> = "mm" usual [1.0, 1000.0] possible [0.01, 10_000.0];
    /// Profile shift coefficients x, pinion then wheel; default `[0, 0]`. A positive one brings the teeth of a ring gear towards its
    /// axis. With only `centre_distance`, its sum of the shifts,
    /// divided for equal specific sliding at both ends of contact (W445).
    profile_shift: Option<[f64; 2]> = "" usual [-1.5, 1.5] possible OPEN;
    /// Working centre distance a; derived from the profile shifts when not given.
    centre_distance: Option<Length> = "mm" usual [5.0, 5000.0] possible [0.1, 50_000.0];
    /// Tip diameters d_a, pinion then wheel; derived from the addendum when not given.
    tip_diameter: Option<[Length; 2]> = "mm" usual [3.0, 5000.0] possible [0.1, 50_000.0];
    /// Addendum h_a*, in modules; default 1.
    addendum: Option<f64> = "" usual [0.6, 1.6] possible OPEN;
    /// Flanks, tip and root of the pinion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pinion: Option<GearFlankInput> => table;
    /// Flanks, tip and root of the wheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    wheel: Option<GearFlankInput> => table;
    /// Relief of both ends of the face, of pinion and wheel together; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    end_relief: Option<EndReliefInput> => table;
    /// Pitch deviations of successive pairs of teeth; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pitch_deviations: Option<Vec<Length>> = "um" per module usual [-30.0, 30.0] possible [-1000.0, 1000.0];
    /// Direction in which the amounts of all modifications are measured: `transverse` (along the base
    /// tangent, as on inspection charts, default) or `normal` to the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    amounts: Option<AmountDirection>;
    /// Tolerance of the amounts of tip relief, used for the interval of the loss factor; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    relief_tolerance: Option<Length> = "um" per module usual [0.1, 20.0] possible [0.001, 500.0];

    => {
        "face_width": "face width over the pitch diameter of the pinion (by teeth, module, helix)", GearsInput::width_ratios,
            "" usual [0.12, 2.5] possible [0.002, 100.0];
    }
}

impl GearsInput {
    /// Face widths over the pitch diameter of the pinion.
    fn width_ratios(&self) -> Vec<f64> {
        let across = match self.module_plane {
            Some(Plane::Transverse) => 1.0,
            _ => self.helix.unwrap_or_default().si().cos(),
        };
        let diameter = f64::from(self.teeth[0]) * self.module.si() / across;
        let widths = self.face_width.both().into_iter();
        widths
            .flat_map(|width| ratio(Some(width.si()), Some(diameter)))
            .collect()
    }
}

table! {
    /// Elastic and thermal constants; all have the values of case-hardened steel by default.
    #[derive(Default)]
    BodyInput;

    /// Name of a steel in the library (`asperity list steels` lists them); the other keys override its values.
    /// `powder-metal` needs `density`, from which its constants follow.
    #[serde(skip_serializing_if = "Option::is_none")]
    steel: Option<String>;
    /// Hardness of the flanks, from which `flow_pressure` and `elastic_limit` follow; default that of `steel`.
    #[serde(skip_serializing_if = "Option::is_none")]
    hardness: Option<Hardness> = "HV" usual [100.0, 1200.0] possible OPEN;
    /// Young's modulus E.
    young: Option<Pressure> = "GPa" usual [50.0, 500.0] possible [1.0, 1500.0];
    /// Poisson's ratio ν.
    poisson: Option<f64> = "" usual [0.2, 0.42] possible OPEN;
    /// Elastic limit in tension.
    elastic_limit: Option<Pressure> = "MPa" usual [150.0, 4000.0] possible [1.0, 30_000.0];
    /// Pressure at which asperities yield (indentation hardness); default 7 GPa.
    flow_pressure: Option<Pressure> = "GPa" usual [0.3, 20.0] possible [1e-3, 150.0];
    /// Density.
    density: Option<Density> = "kg/m3" usual [2500.0, 9000.0] possible [100.0, 25_000.0];
    /// Thermal conductivity.
    conductivity: Option<ThermalConductivity> = "W/(m K)" usual [0.2, 120.0] possible [0.01, 3000.0];
    /// Specific heat capacity.
    heat_capacity: Option<SpecificHeat> = "J/(kg K)" usual [300.0, 2000.0] possible [50.0, 10_000.0];
}

table! {
    /// Steel of both gears.
    #[derive(Default)]
    MaterialInput;

    /// The pinion; also the wheel unless given, and the sun if the steel is that of all meshes.
    #[serde(default)]
    pinion: BodyInput => table;
    /// Steel of the wheel, where it differs.
    wheel: Option<BodyInput> => table;
    /// The sun; also planets and ring unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    sun: Option<BodyInput>;
    /// The planets, where they differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    planet: Option<BodyInput>;
    /// The ring, where it differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    ring: Option<BodyInput>;
}

table! {
    /// Torque, speed, temperature.
    #[derive(Copy, Default)]
    OperationInput;

    /// Torque at the pinion; negative when the wheel drives.
    torque: Torque = "N m" usual [0.01, 1e6] possible [1e-9, 1e8];
    /// Speed of the pinion.
    speed: AngularSpeed = "1/min" usual [1.0, 60_000.0] possible [1e-6, 1e6];
    /// Bulk temperature of the flanks, one value or `[pinion, wheel]`: film and friction are computed at the mean of
    /// both. A case states this or `oil_temperature`.
    #[serde(skip_serializing_if = "Option::is_none")]
    bulk_temperature: Option<OneOrTwo<Temperature>> = "°C" usual [-30.0, 160.0] possible [-100.0, 400.0];
    /// Temperature of the oil that is supplied to the mesh. The bulk temperature of the flanks then follows from the loss
    /// by `operation.bulk.law`, which must be stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    oil_temperature: Option<Temperature> = "°C" usual [-30.0, 160.0] possible [-100.0, 400.0];
    /// Standard deviation of the stated temperature, of oil or flanks, by its measurement; 3 K for an oil sump without a probe
    /// in the jet. Without it the temperature is taken as exact.
    #[serde(skip_serializing_if = "Option::is_none")]
    temperature_deviation: Option<TemperatureDifference> = "K" usual [0.2, 15.0] possible [0.01, 30.0];
    /// Law of the bulk temperature that follows from the loss, with `oil_temperature`.
    #[serde(skip_serializing_if = "Option::is_none")]
    bulk: Option<BulkInput> => table;
    /// Runs the flanks in before the loss is computed: `true` at the torque of the operation until their roughness no longer
    /// changes, or a table `{ torque = "302 N m", engagements = 1e3 }` with their own torque, at the pinion or input shaft, and the
    /// engagements of a tooth of the pinion, 1 to 1e10; both keys are optional. The result has both losses, of the flanks as
    /// measured and run in. Default: `false`.
    #[serde(skip_serializing_if = "Option::is_none")]
    running_in: Option<RunningInEntry> => table;

    => {
        "bulk_temperature": "difference of the flanks", OperationInput::difference, "K" usual [-80.0, 80.0] possible [-500.0, 500.0];
    }
}

/// Paths of the keys that state a temperature, and the keys that each of them replaces if it is set.
pub(crate) const TEMPERATURE_KEYS: [(&str, &[&str]); 2] = [
    ("operation.bulk_temperature", &["oil_temperature", "bulk"]),
    ("operation.oil_temperature", &["bulk_temperature"]),
];

impl OperationInput {
    /// The temperature of the pinion above that of the wheel \[K\].
    fn difference(&self) -> Vec<f64> {
        let stated = self.bulk_temperature.into_iter();
        let of_both = stated.map(OneOrTwo::both);
        of_both
            .map(|[pinion, wheel]| (pinion - wheel).si())
            .collect()
    }

    /// The temperature that the case states: the mean of the flanks, or the temperature of the oil if the bulk temperature
    /// follows from the loss; `None` if it states none.
    #[must_use]
    pub fn stated_temperature(&self) -> Option<Temperature> {
        let mean = |stated: OneOrTwo<Temperature>| {
            let [pinion, wheel] = stated.both();
            Temperature::from_si(0.5 * (pinion.si() + wheel.si()))
        };
        let of_flanks = self.bulk_temperature.map(mean);
        of_flanks.or(self.oil_temperature)
    }

    /// Torque, speed and temperature in words.
    ///
    /// ```
    /// use asperity_case::case::OperationInput;
    /// use asperity_core::quantity::{AngularSpeed, Temperature, Torque};
    /// let speed = AngularSpeed::from_si(100.0 * std::f64::consts::PI);
    /// let hot = Temperature::from_celsius(90.0);
    /// let stated = OperationInput::new(Torque::from_si(145.0), speed, hot);
    /// assert_eq!(stated.in_words(), "145.0 N m, 3000 1/min, flanks at 90 °C");
    /// let mut of_oil = stated.clone();
    /// (of_oil.bulk_temperature, of_oil.oil_temperature) = (None, Some(hot));
    /// assert_eq!(of_oil.in_words(), "145.0 N m, 3000 1/min, oil at 90 °C");
    /// ```
    #[must_use]
    pub fn in_words(&self) -> String {
        // The temperature of the flanks follows from the loss if the case states the temperature of the oil.
        let of_oil = self.oil_temperature.is_some() || self.bulk.is_some();
        let body = if of_oil { "oil" } else { "flanks" };
        let temperature = match self.stated_temperature() {
            Some(temperature) => format!("{body} at {} °C", decimals(temperature.celsius(), 0)),
            None => "flanks at their equilibrium temperature".to_owned(),
        };
        format!(
            "{} N m, {} 1/min, {temperature}",
            decimals(self.torque.si(), 1),
            decimals(self.speed.si() * 30.0 / std::f64::consts::PI, 0),
        )
    }

    /// States another temperature by the name that the case uses; two flanks retain their difference.
    pub fn set_temperature(&mut self, temperature: Temperature) {
        match (self.bulk_temperature, self.oil_temperature) {
            (Some(OneOrTwo::Two([pinion, wheel])), _) if pinion != wheel => {
                let half = 0.5 * (wheel - pinion).si();
                let flanks =
                    [-half, half].map(|part| Temperature::from_si(temperature.si() + part));
                self.bulk_temperature = Some(OneOrTwo::Two(flanks));
            }
            (None, Some(_)) => self.oil_temperature = Some(temperature),
            _ => self.bulk_temperature = Some(OneOrTwo::One(temperature)),
        }
    }

    /// States the bulk temperature of the flanks, which no law determines then.
    pub fn set_bulk_temperature(&mut self, bulk: Temperature) {
        self.bulk_temperature = Some(OneOrTwo::One(bulk));
        self.oil_temperature = None;
        self.bulk = None;
    }

    /// States the load of a mesh in a train; the torque of its running-in keeps its ratio to that of the operation.
    pub(crate) fn set_load(&mut self, torque: Torque, speed: AngularSpeed) {
        let ratio = torque.si() / self.torque.si();
        if let Some(RunningInEntry::Stated(stated)) = &mut self.running_in {
            stated.torque = stated.torque.map(|torque| torque * ratio);
        }
        (self.torque, self.speed) = (torque, speed);
    }

    /// Path of the key that states the temperature.
    pub(crate) fn temperature_key(&self) -> &'static str {
        let [(bulk, _), (oil, _)] = TEMPERATURE_KEYS;
        match (self.bulk_temperature, self.oil_temperature) {
            (None, Some(_)) => oil,
            _ => bulk,
        }
    }
}

table! {
    /// Ranges of the default axes of a map.
    #[derive(Copy, Default)]
    MapInput;

    /// Largest torque at the pinion or input shaft; default that of the operation.
    torque_max: Option<Torque> = "N m" usual [0.01, 1e6] possible [1e-9, 1e8];
    /// Largest speed of the pinion or input shaft; default that of the operation.
    speed_max: Option<AngularSpeed> = "1/min" usual [1.0, 60_000.0] possible [1e-6, 1e6];
}

table! {
    /// A vehicle whose speed over time makes torque and speed of the pinion or input shaft.
    #[derive(Copy)]
    VehicleInput;

    /// Mass with its load.
    mass: Mass = "kg" usual [50.0, 60_000.0] possible [1.0, 1e6];
    /// Rolling radius of the wheels.
    wheel_radius: Length = "m" usual [0.1, 1.2] possible [0.01, 10.0];
    /// Turns of the pinion or input shaft for one turn of the wheels.
    ratio: f64 = "" usual [0.5, 100.0] possible [0.001, 10_000.0];
    /// Drag coefficient times frontal area, c_d A.
    drag_area: Area = "m2" usual [0.05, 12.0] possible [0.001, 100.0];
    /// Coefficient of the rolling resistance of the tyres.
    rolling_resistance: f64 = "" usual [0.001, 0.05] possible [1e-5, 0.5];
    /// Mass plus the inertia of the rotating parts, over the mass; default 1.04.
    #[serde(skip_serializing_if = "Option::is_none")]
    inertia_factor: Option<f64> = "" usual [1.0, 1.6] possible [0.5, 10.0];
    /// Grade of the road if the cycle does not state it, rise over distance forwards; default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    grade: Option<Ratio> = "%" usual [-30.0, 30.0] possible [-100.0, 100.0];
}

table! {
    /// The flanks that carry the load at a negative torque.
    CoastInput;

    /// Trace of the pinion's coast flank.
    pinion: FlankInput => table;
    /// Trace of the wheel's coast flank; default: the pinion's coast flank, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    wheel: Option<FlankInput> => table;
}

table! {
    /// The two flanks and how their traces are prepared.
    #[derive(Default)]
    SurfaceInput;

    /// Trace of the pinion's flank; of the sun's, if the flanks are those of all meshes.
    #[serde(default, skip_serializing_if = "is_unstated")]
    pinion: FlankInput => table;
    /// Trace of the wheel's flank; default: the pinion's trace, mirrored.
    wheel: Option<FlankInput> => table;
    /// Trace of the sun's flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    sun: Option<FlankInput>;
    /// Trace of a planet's flank, for both of its meshes; default: the sun's trace, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    planet: Option<FlankInput>;
    /// Trace of the ring's flank; default: the planet's trace, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    ring: Option<FlankInput>;
    /// Finish of flanks without a file: `ground` or `superfinished`; default by Ra, `ground` above 0.15 um and
    /// `superfinished` below 0.08 um, half of the surrogates each between.
    #[serde(skip_serializing_if = "Option::is_none")]
    finish: Option<FinishName>;
    /// Contact of the flanks: `lines`, each trace as ridges without an end along the lead; or `patch`, scans with all of their
    /// rows; with one scan, the surface of the other flank is generated from its trace with its `model.lay`. Default `lines`; of a scan without
    /// `row` or `line` `patch`, if the lay of one flank is above 1/6.
    #[serde(skip_serializing_if = "Option::is_none")]
    contact: Option<ContactName>;
    /// Form removed from each trace; default `level` (a straight line).
    form: Option<Form>;
    /// Cut-off λc that separates waviness from roughness; default as the file states, else 0.25 mm, usual on
    /// gear flanks; "0 mm" keeps the waviness.
    cutoff: Option<Length> = "mm" usual [0.08, 2.5] possible [0.001, 100.0];
    /// Cut-off λs below which detail counts as noise; default as the file states, else 2.5 um; "0 um" for
    /// none. State the cut-off of the instrument next to Ra of a flank without a file: else 2.5 to 25 um is assumed.
    noise_cutoff: Option<Length> = "um" usual [0.25, 25.0] possible [0.001, 1000.0];
    /// Treatment of the ends of a trace in filtering; default `cut`.
    ends: Option<Ends>;
    /// Spikes of up to six points farther than this number of robust standard deviations from the running median are
    /// replaced by straight lines before form removal; usual 6, default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    outliers: Option<f64> = "" usual [3.0, 20.0] possible [0.1, 1000.0];
    /// The coast flanks, if they differ: they replace both flanks at a negative torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    coast: Option<CoastInput> => table;

    => {
        "noise_cutoff": "noise cut-off over the cut-off", |surface| over(surface.noise_cutoff, surface.cutoff),
            "" usual [0.001, 0.125] possible OPEN;
    }
}

/// Ratio of two lengths that are stated.
fn over(above: Option<Length>, below: Option<Length>) -> Vec<f64> {
    ratio(above.map(Length::si), below.map(Length::si))
}

impl SurfaceInput {
    /// The side of the teeth that carries the load at `torque`: coast, if the case states its flanks.
    pub(crate) fn loaded_side(&self, torque: Torque) -> Side {
        match &self.coast {
            Some(_) if torque.si() < 0.0 => Side::Coast,
            _ => Side::Drive,
        }
    }

    /// The flanks of pinion and wheel on a side of the teeth.
    pub(crate) fn of_side(&self, side: Side) -> (&FlankInput, Option<&FlankInput>) {
        match (&self.coast, side) {
            (Some(coast), Side::Coast) => (&coast.pinion, coast.wheel.as_ref()),
            _ => (&self.pinion, self.wheel.as_ref()),
        }
    }
}

/// Side of the teeth that carries the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// The flanks of `surface.pinion` and `surface.wheel`.
    Drive,
    /// The flanks of `surface.coast`.
    Coast,
}

table! {
    /// One flank: a file with its trace, or only roughness values.
    #[derive(Default)]
    FlankInput;

    /// File of the trace, relative to the case file.
    file: Option<PathBuf>;
    /// Several traces instead of `file`, each of a tooth of its own: `["tooth1.csv", "tooth2.csv"]`, a pattern as
    /// `"pinion_*.csv"` whose files are taken by name, or tables with `tooth`, `y` (place across the face) and a place
    /// of their own. All pairs of teeth are computed, and the loss is their mean.
    #[serde(skip_serializing_if = "Option::is_none")]
    traces: Option<TraceList> => table;
    /// Measured traces of one finish instead of `file`, as a list or pattern: as many flanks are generated like them as there are
    /// traces, each of a tooth of its own, so that the loss has the scatter of generated flanks.
    #[serde(skip_serializing_if = "Option::is_none")]
    like: Option<TraceList> => table;
    /// Traces of the places of `like` after a test, in the same order; flanks are then made of pieces of both. Traces after several
    /// stages of a test state their `engagements`: `[{ file = "run1_*.csv", engagements = 1e4 }, ...]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    after: Option<TraceList> => table;
    /// State of the generated flanks from before the test, 0, to `after` it, 1, which is the default; heights are lost in proportion.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<f64> = "" usual [0.0, 1.0] possible [0.0, 1.0];
    /// Engagements of a tooth after which the flanks are generated, instead of `state`; default the last stage. Heights are
    /// lost in proportion to engagements between two stages of `after`.
    #[serde(skip_serializing_if = "Option::is_none")]
    engagements: Option<f64> = "" usual [0.0, 1e10] possible [0.0, 1e15];
    /// Seed of the flanks that are generated like others; default 1. Pinion and wheel differ with equal seeds, meshes of a train
    /// do not.
    #[serde(skip_serializing_if = "Option::is_none")]
    seed: Option<u32> = "" usual [0.0, 1e6] possible [0.0, 4.3e9];
    /// Read the trace from its other end (flanks face each other); not with `from` or `at`, which tell it.
    mirrored: Option<bool>;
    /// End of the flank at which the trace begins: `root` (default where the trace is placed) or `tip`.
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<TraceStart>;
    /// A point of the trace whose place on the flank is known: `{ diameter = "49 mm", x = "0.5 mm" }`. Files over
    /// roll lengths or roll angles need none. With both flanks placed, every contact takes the windows that meet there.
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<FlankPlaceInput> => table;
    /// Unit of the positions, if the file does not state it.
    x_unit: Option<LengthUnit>;
    /// Unit of the heights, if the file does not state it.
    z_unit: Option<LengthUnit>;
    /// Spacing of the points, if the file does not state it.
    dx: Option<Length> = "um" usual [0.01, 10.0] possible [1e-5, 1000.0];
    /// Spacing of the rows of a surface, if the file does not state it.
    #[serde(skip_serializing_if = "Option::is_none")]
    dy: Option<Length> = "um" usual [0.01, 1000.0] possible [1e-5, 1e5];
    /// Columns of position and height, counted from 1: `{ x = 1, z = 2 }`, or `{ z = 1 }`.
    columns: Option<Columns> = "" usual [1.0, 100.0] possible [1.0, 1e5];
    /// Decimal sign: `point` or `comma`.
    decimal: Option<DecimalSign>;
    /// Column separator.
    separator: Option<Separator>;
    /// Text encoding.
    encoding: Option<Encoding>;
    /// Missing points: `refuse` or `interpolate`; default `refuse`, of a scan without `row`, `line` or `rows` `interpolate`.
    gaps: Option<Gaps>;
    /// Number of the profile in a file that holds several (a row of a surface), counted from 1.
    row: Option<usize> = "" usual [1.0, 10_000.0] possible [1.0, 1e7];
    /// Number of rows of the surface in `file` that are taken as traces, spread evenly, each a tooth of its own; fewer if they make
    /// more than 64 pairs with those of the other flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    rows: Option<usize> = "" usual [1.0, 1000.0] possible [1.0, 1e6];
    /// Trace taken from a surface: `row` (default) or `column`, with their number in `row`, or `mean` of all rows
    /// or `mean-column` of all columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<TraceLine>;
    /// Meaning of the positions: `distance`, `roll-length`, `roll-degrees`, `roll-radians`; default as stated
    /// in the header.
    abscissa: Option<Abscissa>;
    /// Base radius for positions that are roll lengths or roll angles; default that of the gear.
    base_radius: Option<Length> = "mm" usual [1.0, 2500.0] possible [0.05, 25_000.0];
    /// Unevenly spaced positions: `refuse` (default) or `resample`.
    uneven: Option<Uneven>;
    /// Part of the trace that is used, by distances from its first point: `"1.2 mm .. 6.4 mm"`; default all. It is cut before
    /// anything else is done, and `x` of `at` still counts from the first point of the whole trace.
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<TraceRange> = "mm" usual [0.001, 100.0] possible [1e-5, 10_000.0];
    /// Whether the values of the file grow into the material (depths, a replica), so that the heights are their negatives;
    /// default: only if the file names them depths.
    invert: Option<bool>;
    /// Finish of a flank without a file: `ground` or `superfinished`; default `surface.finish`.
    #[serde(skip_serializing_if = "Option::is_none")]
    finish: Option<FinishName>;
    /// Rq of a flank without a file. Surrogate flanks of its finish with the stated values are generated and solved,
    /// unless a law of `model.load_share` takes the values themselves.
    rq: Option<Length> = "um" usual [0.01, 5.0] possible [0.0, 200.0];
    /// Ra of a flank without a file, to which its surrogates are scaled; for a law that takes the values, Rq·√(2/π) by
    /// default.
    ra: Option<Length> = "um" usual [0.01, 4.0] possible [0.0, 200.0];
    /// Rz of a flank without a file; next to Ra it selects the surrogates with the nearest Rz/Ra. For a law that takes
    /// the values, 6·Rq by default.
    rz: Option<Length> = "um" usual [0.05, 40.0] possible [0.0, 2000.0];
    /// Rpk of a flank without a file; next to Ra it selects the surrogates with the nearest Rpk/Ra.
    rpk: Option<Length> = "um" usual [0.005, 10.0] possible [0.0, 500.0];
    /// Mean tip radius of the asperities of a flank without a file, for `load_share = "lambda-star"`.
    asperity_radius: Option<Length> = "um" usual [0.5, 10_000.0] possible [1e-3, 1e7];

    => {
        "ra": "Ra over Rq", |flank| over(flank.ra, flank.rq), "" usual [0.5, 1.0] possible [0.05, 1.1];
        "rz": "Rz over Rq", |flank| over(flank.rz, flank.rq), "" usual [2.0, 25.0] possible [1.0, 250.0];
        "rz": "Rz over Ra", |flank| over(flank.rz, flank.ra), "" usual [2.0, 30.0] possible [1.0, 300.0];
        "rpk": "Rpk over Rz", |flank| over(flank.rpk, flank.rz), "" usual [0.002, 0.6] possible [0.0, 1.0];
        "rpk": "Rpk over Ra", |flank| over(flank.rpk, flank.ra), "" usual [0.02, 6.0] possible [0.0, 300.0];
        "rpk": "Rpk over Rq", |flank| over(flank.rpk, flank.rq), "" usual [0.02, 5.0] possible [0.0, 1e12];
    }
}

impl FlankInput {
    /// The keys of a wheel with the trace of the pinion: reversed, at an unknown place.
    #[must_use]
    pub fn for_wheel(&self) -> Self {
        let is_placed = self.at.is_some() || self.from.is_some();
        Self {
            mirrored: (!is_placed).then(|| !self.mirrored.unwrap_or(false)),
            from: is_placed.then(|| self.from.unwrap_or_default()),
            at: None,
            ..self.clone()
        }
    }

    /// The keys of this flank for another file: the settings of the reader stay, roughness values are removed, and so is the
    /// range, which is that of one trace, unless the file is the same.
    fn on_file(&self, file: &Path) -> Self {
        // The other file may be named by its full path.
        let is_same = self.file.as_ref().is_some_and(|own| file.ends_with(own));
        Self {
            file: Some(file.to_owned()),
            traces: None,
            like: None,
            after: None,
            state: None,
            engagements: None,
            seed: None,
            finish: None,
            rq: None,
            ra: None,
            rz: None,
            rpk: None,
            asperity_radius: None,
            range: self.range.filter(|_| is_same),
            ..self.clone()
        }
    }
}

impl FlankInput {
    /// The keys of a flank of traces in memory, which no reader has to read.
    fn on_traces(&self, mut traces: Vec<TraceInput>) -> Self {
        let is_placed = traces.iter().all(|trace| trace.at.is_some());
        let of_flank = Self {
            mirrored: self.mirrored.filter(|_| !is_placed),
            from: self.from.filter(|_| !is_placed),
            ..Self::default()
        };
        match (traces.pop(), traces.is_empty()) {
            (Some(only), true) => Self {
                file: Some(only.file),
                from: only.from.or(of_flank.from),
                at: only.at,
                ..of_flank
            },
            (last, _) => {
                traces.extend(last);
                let entries = traces.into_iter().map(TraceEntry::Table);
                Self {
                    traces: Some(TraceList::List(entries.collect())),
                    ..of_flank
                }
            }
        }
    }
}

impl SurfaceInput {
    /// Replaces the traces by those of another finish; a single trace is used for both flanks, mirrored for the wheel.
    pub fn put_traces(&mut self, pinion: &Path, wheel: Option<&Path>) {
        let of_wheel = self.wheel.clone();
        let of_wheel = of_wheel.unwrap_or_else(|| self.pinion.for_wheel());
        self.pinion = self.pinion.on_file(pinion);
        self.wheel = wheel.map(|file| of_wheel.on_file(file));
    }

    /// The flanks of pinion and wheel on the side that carries `torque`.
    pub fn loaded_flanks_mut(
        &mut self,
        torque: Torque,
    ) -> (&mut FlankInput, &mut Option<FlankInput>) {
        let side = self.loaded_side(torque);
        match (&mut self.coast, side) {
            (Some(coast), Side::Coast) => (&mut coast.pinion, &mut coast.wheel),
            _ => (&mut self.pinion, &mut self.wheel),
        }
    }

    /// Replaces the flank of `gear` on the side that carries `torque` by `traces` in memory, with their places; the other flank keeps
    /// its trace. A trace without a place has the direction of the flank.
    pub fn put_measured(&mut self, gear: Gear, torque: Torque, traces: Vec<TraceInput>) {
        let (pinion, wheel) = self.loaded_flanks_mut(torque);
        let of_wheel = wheel.get_or_insert_with(|| pinion.for_wheel());
        let flank = match gear {
            Gear::Pinion => pinion,
            Gear::Wheel => of_wheel,
        };
        *flank = flank.on_traces(traces);
    }
}
