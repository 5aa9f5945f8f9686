//! The case file as the user writes it: every key optional that has a default.
//!
//! Quantities are text with a unit. The same structure is read from TOML and JSON, and printed as
//! a JSON schema by [`schema`].

use std::path::{Path, PathBuf};

use asperity_core::hardness::Hardness;
use asperity_core::quantity::{
    Angle, AngularSpeed, Area, Density, Length, Mass, Pressure, Ratio, SpecificHeat, Temperature,
    ThermalConductivity, Torque,
};
use asperity_ehl_regime::inlet_flow::{CentralFilm, Lay};
use asperity_ehl_regime::{FilmLaw, ThermalLaw};
use asperity_gear::{AmountDirection, LoadLaw, PathOfContact, Plane};
use asperity_ns_film::FluidModel;
use asperity_oil::{LubricantInput, PressureLaw};
use asperity_profile_io::read::{
    Abscissa, Columns, DecimalSign, Encoding, Gaps, LengthUnit, Separator, TraceLine, Uneven,
};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use schemars::JsonSchema;
use serde::de::value::{SeqAccessDeserializer, StrDeserializer};
use serde::de::{IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::bulk_input::BulkInput;
use super::calibration::CalibrationInput;
use super::flank_place::{FlankPlaceInput, TraceStart};
use super::gear_input::{EndReliefInput, GearFlankInput};
use super::gearbox_input::GearboxInput;
use super::law_names::{FilmFrictionLaw, FullFilmName, LoadShareName};
use super::micropitting_input::MicropittingInput;
use super::trace_list::TraceList;
use asperity_mixed_film::SpotSpeed;

/// A case: gears, steel, oil, operation, two measured flanks, and the model to use.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseInput {
    /// Title of the case, shown in every output.
    pub title: Option<String>,
    /// Reading of the model: `corrected` (default) or `paper`.
    pub formulation: Option<Formulation>,
    /// The gear pair.
    pub gears: GearsInput,
    /// Steel of the pinion, and of the wheel unless `material.wheel` is given.
    #[serde(default)]
    pub material: MaterialInput,
    /// Operating conditions: torque, speed, temperature.
    pub operation: OperationInput,
    /// The oil.
    pub lubricant: LubricantInput,
    /// The measured flanks and their preparation.
    pub surface: SurfaceInput,
    /// Choices of the model.
    #[serde(default)]
    pub model: ModelInput,
    /// Parameters calibrated on a rig, as `asperity calibrate` writes them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationInput>,
    /// Losses of the gearbox beside that of the mesh, stated by the user; nothing is added that is not named here.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxInput>,
    /// Specific film of the micropitting rating, with what the measured flanks show beside it; computed where given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub micropitting: Option<MicropittingInput>,
    /// Reach of the default axes of `asperity map`; a run leaves it aside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<MapInput>,
    /// The vehicle of a cycle given by its speed, for `asperity cycle`; a run leaves it aside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<VehicleInput>,
}

/// Reading of the 2022 model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Formulation {
    /// Dimensionally and physically consistent.
    #[default]
    Corrected,
    /// The paper's reading, only its misprints corrected.
    Paper,
}

/// One value for both gears, or one each: `"50 mm"` or `["35 mm", "32 mm"]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OneOrTwo<T> {
    /// `[pinion, wheel]`.
    Two([T; 2]),
    /// The same for both.
    One(T),
}

impl<T: Copy> OneOrTwo<T> {
    /// The values of pinion and wheel.
    pub fn both(self) -> [T; 2] {
        match self {
            Self::Two(both) => both,
            Self::One(one) => [one, one],
        }
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for OneOrTwo<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OneOrTwoVisitor(std::marker::PhantomData))
    }
}

/// Implemented by hand, so that an error in a single value is described in the words of its type.
struct OneOrTwoVisitor<T>(std::marker::PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for OneOrTwoVisitor<T> {
    type Value = OneOrTwo<T>;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one value, or two as [pinion, wheel]")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
        T::deserialize(text.into_deserializer()).map(OneOrTwo::One)
    }

    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Self::Value, E> {
        T::deserialize(number.into_deserializer()).map(OneOrTwo::One)
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Self::Value, E> {
        T::deserialize(number.into_deserializer()).map(OneOrTwo::One)
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Self::Value, E> {
        T::deserialize(number.into_deserializer()).map(OneOrTwo::One)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Self::Value, A::Error> {
        Deserialize::deserialize(SeqAccessDeserializer::new(sequence)).map(OneOrTwo::Two)
    }
}

/// The gear pair; names as in ISO 21771.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearsInput {
    /// Numbers of teeth z, pinion then wheel; negative for a ring gear: `[24, -75]`.
    pub teeth: [i32; 2],
    /// Module m.
    pub module: Length,
    /// Plane in which the module is measured; default `normal`.
    pub module_plane: Option<Plane>,
    /// Helix angle β; default 0 deg.
    pub helix: Option<Angle>,
    /// Normal pressure angle α_n; default 20 deg.
    pub pressure_angle: Option<Angle>,
    /// Face width b, one value for both gears or `[pinion, wheel]`.
    pub face_width: OneOrTwo<Length>,
    /// Profile shift coefficients x, pinion then wheel; default `[0, 0]`.
    pub profile_shift: Option<[f64; 2]>,
    /// Working centre distance a; derived from the profile shifts when not given.
    pub centre_distance: Option<Length>,
    /// Tip diameters d_a, pinion then wheel; derived from the addendum when not given.
    pub tip_diameter: Option<[Length; 2]>,
    /// Addendum h_a*, in modules; default 1.
    pub addendum: Option<f64>,
    /// Flanks, tip and root of the pinion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pinion: Option<GearFlankInput>,
    /// Flanks, tip and root of the wheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<GearFlankInput>,
    /// Relief of both ends of the face, of pinion and wheel together; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_relief: Option<EndReliefInput>,
    /// Pitch deviations of successive pairs of teeth; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_deviations: Option<Vec<Length>>,
    /// Direction in which the amounts of all modifications are measured: `transverse` (along the base
    /// tangent, as on inspection charts, default) or `normal` to the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amounts: Option<AmountDirection>,
    /// Tolerance of the amounts of tip relief, used for the band of the loss factor; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relief_tolerance: Option<Length>,
}

/// Elastic and thermal constants; all have the values of case-hardened steel by default.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BodyInput {
    /// Name of a steel in the library (`asperity steels` lists them); the other keys override its values.
    /// `powder-metal` needs `density`, from which its constants follow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steel: Option<String>,
    /// Hardness of the flanks, from which `flow_pressure` and `elastic_limit` follow; default that of `steel`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness: Option<Hardness>,
    /// Young's modulus E.
    pub young: Option<Pressure>,
    /// Poisson's ratio ν.
    pub poisson: Option<f64>,
    /// Elastic limit in tension.
    pub elastic_limit: Option<Pressure>,
    /// Pressure at which asperities yield (indentation hardness); default 7 GPa.
    pub flow_pressure: Option<Pressure>,
    /// Density.
    pub density: Option<Density>,
    /// Thermal conductivity.
    pub conductivity: Option<ThermalConductivity>,
    /// Specific heat capacity.
    pub heat_capacity: Option<SpecificHeat>,
}

/// Steel of both gears.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialInput {
    /// The pinion; also the wheel unless given.
    #[serde(default)]
    pub pinion: BodyInput,
    /// Steel of the wheel, where it differs.
    pub wheel: Option<BodyInput>,
}

/// Torque, speed, temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OperationInput {
    /// Torque at the pinion; negative when the wheel drives.
    pub torque: Torque,
    /// Speed of the pinion.
    pub speed: AngularSpeed,
    /// Bulk temperature of the flanks; with `bulk` the temperature of the oil, from which that follows.
    pub temperature: Temperature,
    /// Bulk temperature from the loss; default: as given by `temperature`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bulk: Option<BulkInput>,
}

/// Reach of the default axes of a map.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapInput {
    /// Largest torque at the pinion; default that of the operation.
    pub torque_max: Option<Torque>,
    /// Largest speed of the pinion; default that of the operation.
    pub speed_max: Option<AngularSpeed>,
}

/// A vehicle whose speed over time makes torque and speed of the pinion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VehicleInput {
    /// Mass with its load.
    pub mass: Mass,
    /// Rolling radius of the wheels.
    pub wheel_radius: Length,
    /// Turns of the pinion for one turn of the wheels.
    pub ratio: f64,
    /// Drag coefficient times frontal area, c_d A.
    pub drag_area: Area,
    /// Coefficient of the rolling resistance of the tyres.
    pub rolling_resistance: f64,
    /// Mass with that of everything that turns, over the mass; default 1.04.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia_factor: Option<f64>,
    /// Grade of the road where the cycle does not tell, rise over distance; default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grade: Option<Ratio>,
}

/// The other flanks of the teeth, which carry the load when the torque is negative.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CoastInput {
    /// Trace of the pinion's coast flank.
    pub pinion: FlankInput,
    /// Trace of the wheel's coast flank; default: the pinion's coast flank, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<FlankInput>,
}

/// The two flanks and how their traces are prepared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SurfaceInput {
    /// Trace of the pinion's flank.
    pub pinion: FlankInput,
    /// Trace of the wheel's flank; default: the pinion's trace, mirrored.
    pub wheel: Option<FlankInput>,
    /// Form removed from each trace; default `level` (a straight line).
    pub form: Option<Form>,
    /// Cut-off λc that separates waviness from roughness; default as the file states, else 0.25 mm, usual on
    /// gear flanks; "0 mm" keeps the waviness.
    pub cutoff: Option<Length>,
    /// Cut-off λs below which detail counts as noise; default as the file states, else 2.5 um; "0 um" for
    /// none.
    pub noise_cutoff: Option<Length>,
    /// Treatment of the ends of a trace in filtering; default `cut`.
    pub ends: Option<Ends>,
    /// Spikes of up to six points farther than this number of robust standard deviations from the running median are
    /// replaced by straight lines before form removal; usual 6, default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outliers: Option<f64>,
    /// The coast flanks, where they are not as the others: they take the place of both at a negative torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coast: Option<CoastInput>,
}

impl SurfaceInput {
    /// The flanks that carry the load at `torque`, pinion and wheel, and the table that they stand in.
    pub(super) fn loaded(&self, torque: Torque) -> (&FlankInput, Option<&FlankInput>, Side) {
        match &self.coast {
            Some(coast) if torque.si() < 0.0 => (&coast.pinion, coast.wheel.as_ref(), Side::Coast),
            _ => (&self.pinion, self.wheel.as_ref(), Side::Drive),
        }
    }
}

/// Side of the teeth that carries the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// That of `surface.pinion` and `surface.wheel`.
    Drive,
    /// That of `surface.coast`.
    Coast,
}

/// One flank: a file with its trace, or roughness values alone.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlankInput {
    /// File of the trace, relative to the case file.
    pub file: Option<PathBuf>,
    /// Several traces in place of `file`, each of a tooth of its own: `["tooth1.csv", "tooth2.csv"]`, a pattern as
    /// `"pinion_*.csv"` whose files are taken by name, or tables with `tooth`, `y` (place across the face) and a place
    /// of their own. All pairs of teeth are computed, and the loss is their mean.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub traces: Option<TraceList>,
    /// Read the trace from its other end (flanks face each other); not with `from` or `at`, which tell it.
    pub mirrored: Option<bool>,
    /// End of the flank at which the trace begins: `root` (default where the trace is placed) or `tip`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<TraceStart>,
    /// A point of the trace whose place on the flank is known: `{ diameter = "49 mm", x = "0.5 mm" }`. Files over
    /// roll lengths or roll angles need none. With both flanks placed, every contact takes the windows that meet there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<FlankPlaceInput>,
    /// Unit of the positions, if the file does not state it.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights, if the file does not state it.
    pub z_unit: Option<LengthUnit>,
    /// Spacing of the points, if the file does not state it.
    pub dx: Option<Length>,
    /// Columns of position and height, counted from 1: `{ x = 1, z = 2 }`, or `{ z = 1 }`.
    pub columns: Option<Columns>,
    /// Decimal sign: `point` or `comma`.
    pub decimal: Option<DecimalSign>,
    /// Column separator.
    pub separator: Option<Separator>,
    /// Text encoding.
    pub encoding: Option<Encoding>,
    /// Missing points: `refuse` (default) or `interpolate`.
    pub gaps: Option<Gaps>,
    /// Number of the profile in a file that holds several (a row of a surface), counted from 1.
    pub row: Option<usize>,
    /// Trace taken from a surface: `row` (default) or `column`, with their number in `row`, or `mean` of all rows
    /// or `mean-column` of all columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<TraceLine>,
    /// Meaning of the positions: `distance`, `roll-length`, `roll-degrees`, `roll-radians`; default as stated
    /// in the header.
    pub abscissa: Option<Abscissa>,
    /// Base radius for positions that are roll lengths or roll angles; default that of the gear.
    pub base_radius: Option<Length>,
    /// Unevenly spaced positions: `refuse` (default) or `resample`.
    pub uneven: Option<Uneven>,
    /// Rq of a flank without a file; the rough contact is then not computed.
    pub rq: Option<Length>,
    /// Ra of a flank without a file; default Rq·√(2/π), as for a Gaussian surface. If given alone, Rq follows
    /// from it.
    pub ra: Option<Length>,
    /// Rz of a flank without a file; default 6·Rq. If given alone, Rq follows from it.
    pub rz: Option<Length>,
    /// Rpk of a flank without a file.
    pub rpk: Option<Length>,
    /// Mean tip radius of the asperities of a flank without a file.
    pub asperity_radius: Option<Length>,
}

impl FlankInput {
    /// The keys of a wheel that runs on the pinion's trace: facing it, at a place of its own that is not known.
    #[must_use]
    pub fn for_wheel(&self) -> Self {
        let told = self.at.is_some() || self.from.is_some();
        Self {
            mirrored: (!told).then(|| !self.mirrored.unwrap_or(false)),
            from: told.then(|| self.from.unwrap_or_default()),
            at: None,
            ..self.clone()
        }
    }

    /// The same keys on another file: how files are read holds, values of a flank without a file do not.
    fn on_file(&self, file: &Path) -> Self {
        Self {
            file: Some(file.to_owned()),
            traces: None,
            rq: None,
            ra: None,
            rz: None,
            rpk: None,
            asperity_radius: None,
            ..self.clone()
        }
    }
}

impl SurfaceInput {
    /// Puts the traces of another finish in place; a single one serves both flanks, mirrored for the wheel.
    pub fn put_traces(&mut self, pinion: &Path, wheel: Option<&Path>) {
        let of_wheel = self.wheel.clone();
        let of_wheel = of_wheel.unwrap_or_else(|| self.pinion.for_wheel());
        self.pinion = self.pinion.on_file(pinion);
        self.wheel = wheel.map(|file| of_wheel.on_file(file));
    }
}

/// Choices of the model.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModelInput {
    /// Number of cells along the path of contact, with one contact evaluated in each; default 16 (`paper`:
    /// one position).
    pub positions: Option<usize>,
    /// The single position of the `paper` formulation: 0 at A, 1 at E, or `A` … `E`; default `C`.
    pub position: Option<PathPoint>,
    /// Number of offsets along the traces at which the flanks meet; default 16 (`paper`: 1).
    pub offsets: Option<usize>,
    /// Half-width of the contact window, in Hertz half-widths; default 3.
    pub window: Option<f64>,
    /// Law of the load distribution over the teeth in contact; default `elastic` (`paper`: `mean-length`).
    pub load_distribution: Option<LoadLaw>,
    /// Correction factor C_M of the tooth stiffness, theoretical to measured; default 0.8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_factor: Option<f64>,
    /// Length over which a tooth spreads a load along its face width, in modules; default 1.55.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face_coupling: Option<f64>,
    /// Include contact of tip edges outside the path of contact; default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge_contact: Option<bool>,
    /// Friction law of the film; default `eyring` (`paper`: `xu`). `eyring`, `carreau` and `newton` describe
    /// the film alone; the others are published laws, most of which include asperity friction in their
    /// coefficient.
    pub film_friction: Option<FilmFrictionLaw>,
    /// Law of viscosity against pressure for the film friction laws `eyring`, `carreau` and `newton`; default
    /// `barus`.
    pub film_pressure_law: Option<PressureLaw>,
    /// Factor on the friction coefficient of the film (lubricant factor); default 1.
    pub friction_scale: Option<f64>,
    /// Friction coefficient of `film_friction = "constant"`.
    pub constant_friction: Option<f64>,
    /// Coefficients of Xu's law from your own calibration: a JSON file, relative to the case file.
    pub xu_coefficients: Option<PathBuf>,
    /// Lubricant factor X_L of `iso-14179-2`; default 1 (mineral oil).
    pub lubricant_factor: Option<f64>,
    /// Coefficient of boundary friction μ_b; default 0.08 (`paper`: 0.3, metal on metal).
    pub boundary_friction: Option<f64>,
    /// Thickness of the boundary layer on touching asperities; default 10 nm, which applies to λs = 2.5 um.
    pub boundary_layer: Option<Length>,
    /// Lay γ of the roughness, one value for both flanks or `[pinion, wheel]`: from 0 or `across`, ridges
    /// across the whole face width (default), to 1 or `isotropic`.
    pub lay: Option<OneOrTwo<Lay>>,
    /// Reading of the central film in film friction and load share: `mass-flow` (default) or `gap`.
    pub central_film: Option<CentralFilm>,
    /// Reading of the central film in Λ* and in printed film thicknesses: `gap` (default) or `mass-flow`
    /// (`paper`: `mass-flow`).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lambda_film: Option<CentralFilm>,
    /// Speed at which oil is carried into touching asperities: `entrainment` (default) or `half-sliding`, for
    /// the band.
    pub spot_speed: Option<SpotSpeed>,
    /// Factor on the solved asperity load share, for the band; default 1.
    pub asperity_share_factor: Option<f64>,
    /// Film thickness law; default `dowson-toyoda` (`paper`: `hamrock-dowson`).
    pub film: Option<FilmLaw>,
    /// Thermal reduction of the film and of rolling; default `gupta` (`paper`: `none`).
    pub thermal: Option<ThermalLaw>,
    /// Feed the flash temperature back into the viscosity of the friction law; default false.
    pub flash_feedback: Option<bool>,
    /// Share of the load carried by the film: `solved` (default) from the rough contact; with `lambda-star`,
    /// `zhu-hu`, `masjedi-khonsari` and `jgp` all load on asperities rubs with the boundary coefficient;
    /// `ehl` takes shares and friction from records of transient mixed lubrication, which take a minute or
    /// more.
    pub load_share: Option<LoadShareName>,
    /// Source of a film that carries the whole load: `formulas` (default), `ehl`, the steady
    /// elastohydrodynamic solution of smooth flanks, or `ehl-transient`, records with both traces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full_film: Option<FullFilmName>,
    /// The elastohydrodynamic solutions of `load_share = "ehl"` and `full_film`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ehl: Option<EhlInput>,
    /// Model of the fluid pressure across the film; default `reynolds-cross` (`paper`: `paper`).
    pub fluid_pressure: Option<FluidModel>,
    /// Clamp the roughness in Xu's law at 0.6 um; default true (`paper`: false).
    pub clamp_roughness: Option<bool>,
    /// Step by which `paper` lowers the surfaces into each other; default 80 nm.
    pub delta_step: Option<Length>,
    /// Load error at which the marching of `paper` stops; default 1 %.
    pub numerical_error: Option<Ratio>,
    /// Tolerance of the contact solver's certificate; default 1e-8.
    pub tolerance: Option<f64>,
    /// Include the plastic work of running-in in the losses; default false.
    pub include_running_in: Option<bool>,
    /// Run the flanks in, and give the losses of the run-in flanks beside those of the flanks as measured;
    /// default false.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run_in: Option<bool>,
    /// Fraction of the elastic energy lost in hysteresis, part of rolling; default 1 % (`paper`: 0).
    pub hysteresis: Option<Ratio>,
    /// Number of depths at which subsurface stress is computed; default 24.
    pub depths: Option<usize>,
}

/// Grid and length of the elastohydrodynamic solutions, and where records are kept.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EhlInput {
    /// Number of records along the path of contact; default 8. Shares and friction are interpolated between
    /// them.
    pub records: Option<usize>,
    /// Number of cells along the contact, a multiple of 64; default 512.
    pub cells: Option<usize>,
    /// Travel of a record in half-widths of the contact; default 20.
    pub travel: Option<f64>,
    /// Cache folder for records, so that none is solved twice: `user` (default), the cache folder of the user
    /// (`asperity` in `$XDG_CACHE_HOME`, `~/.cache` or `%LOCALAPPDATA%`), a folder relative to the case file,
    /// or `off`.
    pub cache: Option<String>,
}

/// A point on the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum PathPoint {
    /// One of the five points every gear book names.
    Named(NamedPoint),
    /// 0 at A (start of contact), 1 at E (end).
    Fraction(f64),
}

impl PathPoint {
    /// Fraction of `path` at the point, 0 at A and 1 at E.
    pub fn fraction_of(self, path: &PathOfContact) -> f64 {
        let s = match self {
            Self::Fraction(fraction) => return fraction,
            Self::Named(NamedPoint::A) => path.a,
            Self::Named(NamedPoint::B) => path.b,
            Self::Named(NamedPoint::C) => path.c,
            Self::Named(NamedPoint::D) => path.d,
            Self::Named(NamedPoint::E) => path.e,
        };
        (s - path.a) / (path.e - path.a)
    }
}

impl<'de> Deserialize<'de> for PathPoint {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PathPointVisitor)
    }
}

struct PathPointVisitor;

impl Visitor<'_> for PathPointVisitor {
    type Value = PathPoint;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "one of A, B, C, D, E, or a number from 0 (A) to 1 (E)")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
        let name: StrDeserializer<'_, E> = text.into_deserializer();
        NamedPoint::deserialize(name).map(PathPoint::Named)
    }

    fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number))
    }

    fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number as f64))
    }

    fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Self::Value, E> {
        Ok(PathPoint::Fraction(number as f64))
    }
}

/// Reads what the command line says: `C`, or `0.25`.
impl std::str::FromStr for PathPoint {
    type Err = serde::de::value::Error;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.parse() {
            Ok(fraction) => Ok(Self::Fraction(fraction)),
            Err(_) => Self::deserialize(text.into_deserializer()),
        }
    }
}

/// The points A to E of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum NamedPoint {
    /// Start of contact (tip of the wheel).
    A,
    /// Start of single contact.
    B,
    /// Pitch point.
    C,
    /// End of single contact.
    D,
    /// End of contact (tip of the pinion).
    E,
}

/// The JSON schema of a case file.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(CaseInput).to_value()
}
