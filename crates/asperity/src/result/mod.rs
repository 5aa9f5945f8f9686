//! Result of a run: plain data, units in the names, written as JSON and read back equal.

mod contact_view;
pub mod film_constants;
mod flank_record;
mod full_film;
pub mod gear_report;
pub mod gearbox;
mod load_report;
pub mod loss_band;
mod micropitting_report;
mod outside_input;
pub mod ridges;
mod run_in;
mod scan_comparison;
mod trace_pairs;

use std::borrow::Cow;

use asperity_core::Profile;
pub use asperity_ehl_regime::Regime;
use asperity_gear::{GearPair, LoadMap};
use asperity_oil::LubricantState;
use serde::{Deserialize, Serialize};

pub use asperity_case::case::BulkReport;
use asperity_case::case::{CaseInput, DefaultUsed};
use asperity_case::formulation::FormulationChoice;
use asperity_case::message::Warning;
pub use asperity_profile_io::read::ReadingRecord;
pub use contact_view::ContactView;
pub use film_constants::FilmConstant;
pub use flank_record::FlankRecord;
pub use full_film::FullFilmRow;
pub use gearbox::{GearboxPart, GearboxReport, Scope};
pub use load_report::{LoadReport, LoadRow};
pub use loss_band::*;
pub use micropitting_report::{MicropittingCell, MicropittingReport};
pub use outside_input::OutsideInput;
pub use ridges::Ridges;
pub use run_in::{FlankHeights, RunInStep};
pub use scan_comparison::{GapRow, ScanComparison, ScanLoss};
pub use trace_pairs::{ToothTrace, TracePairs};

pub use asperity_core::SCHEMA_VERSION;

/// The result of a run, without the fields of single positions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RunResult {
    /// Version of this structure.
    pub schema_version: u32,
    /// The program and its version.
    pub program: String,
    /// The case's title.
    pub title: String,
    /// Name of the case file, without its folder; `None` of a case that was not read from a file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case_file: Option<String>,
    /// Name of the mesh, of a gear train.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mesh: Option<String>,
    /// The formulation of the model.
    pub formulation: FormulationChoice,
    /// Efficiency and losses.
    pub summary: Summary,
    /// Published friction laws, each applied whole.
    pub published_laws: Vec<PublishedLawRow>,
    /// Load over the teeth.
    pub load: LoadReport,
    /// One row per mesh position.
    pub path: Vec<PositionRow>,
    /// The points A to E of the path under the mean load over the face, solved as the positions of the path are, and
    /// part of no mean. Left out are points without load and points whose contact the traces do not resolve or are too
    /// short for.
    pub points: Vec<PointRow>,
    /// Reference solutions that load share or full film rest on; none with other laws.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub records: Vec<RecordRow>,
    /// Uncertainty of the loss; absent where the run was made without, or the model has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty: Option<Uncertainty>,
    /// The bulk temperature found from the loss; absent where it is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bulk: Option<BulkReport>,
    /// Loss and efficiency of the gearbox, if the case states its other parts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// The micropitting rating, if the case requests it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub micropitting: Option<MicropittingReport>,
    /// Plastic work of the first engagement.
    pub running_in: RunningIn,
    /// The mesh with flanks that have run in, if the case requests it; all else is of the flanks as measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_in: Option<RunInFlanks>,
    /// The ridges that cost most; `None` if they were not requested, or the loss has no gradient.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ridges: Option<Ridges>,
    /// Why the ridges that cost most cannot be found, if they were sought.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_ridges: Option<String>,
    /// Comparison of patches of the scans with rows of them; `None` without patches or without pictures.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scans: Option<ScanComparison>,
    /// Why patches of the scans cannot be compared with rows of them, if it was tried.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_scans: Option<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The flanks as read and prepared, each by its first trace.
    pub flanks: [FlankRecord; 2],
    /// All pairs of several traces; absent where each flank has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pairs: Option<TracePairs>,
    /// Derived gear geometry.
    pub gears: GearPair,
    /// The oil at the temperature of the flanks.
    pub lubricant: LubricantState,
    /// Constants of film friction by the family of the oil, each with its band, source and how sure it is.
    pub film_constants: Vec<FilmConstant>,
    /// The case as read.
    #[serde(
        serialize_with = "CaseInput::store",
        deserialize_with = "CaseInput::stored"
    )]
    pub inputs: CaseInput,
    /// Every default that was used.
    pub defaults: Vec<DefaultUsed>,
    /// Tags of the equations used, with their titles and keys of their sources.
    pub equations: Vec<EquationUse>,
    /// The sources.
    pub references: Vec<CitedSource>,
}

impl RunResult {
    /// 5 and 95 % quantiles of [`PositionRow::loss_w_per_m`] in each row of the path \[W/m\], the sliding loss as drawn, the
    /// rolling loss of the run; `None` without an uncertainty.
    #[must_use]
    pub fn path_loss_quantiles(&self) -> Option<Vec<[f64; 2]>> {
        let sliding = &self.uncertainty.as_ref()?.path_sliding_w_per_m;
        let rows = self.path.iter().zip(sliding);
        (sliding.len() == self.path.len()).then(|| {
            rows.map(|(row, ends)| ends.map(|end| end + row.rolling_w_per_m))
                .collect()
        })
    }
}

/// Efficiency and losses of the mesh, mean over the offsets of the traces. Losses, efficiencies and friction coefficients are those at
/// the median of the draws, everything else is of the run with every constant at its median.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Summary {
    /// Scope of the result. All numbers here are of the mesh, except those named `gearbox`.
    pub scope: Scope,
    /// Efficiency of the gearbox, where that is the scope.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox_efficiency: Option<f64>,
    /// Losses of mesh and gearbox together \[W\], where that is the scope.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox_loss_w: Option<f64>,
    /// η = 1 − ΣP/(M₁ω₁).
    pub efficiency: f64,
    /// Standard deviation of η over the offsets; absent with one offset.
    pub efficiency_deviation: Option<f64>,
    /// Number of offsets.
    pub offsets: usize,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// Torque out of the mesh \[N m\].
    pub torque_out_nm: f64,
    /// All losses \[W\]: the median of the draws, to which the parts are scaled; without draws the loss of the run.
    pub loss_w: f64,
    /// All losses of the run with every constant at its median \[W\]; `None` without draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// Sliding loss \[W\].
    pub sliding_w: f64,
    /// Part of the sliding loss in the film \[W\].
    pub film_w: f64,
    /// Part of the sliding loss in touching asperities that are lubricated \[W\].
    pub lubricated_asperity_w: f64,
    /// Part of the sliding loss in the boundary layer of touching asperities \[W\].
    pub boundary_w: f64,
    /// Rolling loss, hysteresis of the steel included \[W\].
    pub rolling_w: f64,
    /// Deformation loss of pinion and wheel by plastic displacement \[W\], where the formulation counts it.
    pub deformation_w: [f64; 2],
    /// Power of elastic and plastic displacement in contact \[W\], of which only the plastic part is lost.
    pub deformation_in_contact_w: [f64; 2],
    /// Part of the rolling loss by hysteresis of the steel \[W\].
    pub hysteresis_w: f64,
    /// Elastic work put into the flanks and given back, except for hysteresis \[W\]; not a loss.
    pub elastic_cycling_w: f64,
    /// Share of the load on touching asperities, mean over mesh time.
    pub asperity_share: f64,
    /// Its standard error, where it is recorded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub asperity_share_standard_error: Option<f64>,
    /// What the records leave uncertain of the sliding loss, where they give the friction.
    #[serde(skip)]
    pub recorded_friction: Option<RecordedFriction>,
    /// Share of the load on their boundary layer, mean over mesh time.
    pub boundary_share: f64,
    /// Friction coefficient that explains the loss with the local loss factor.
    pub mu_equivalent: f64,
    /// Loss factor of Ohlendorf.
    pub loss_factor_ohlendorf: f64,
    /// Loss factor of the load over the flanks.
    pub loss_factor_local: f64,
    /// Share of the path (by mesh time) in mixed or boundary lubrication.
    pub mixed_share: f64,
    /// Lubrication regime: full film if no part of the path is mixed, boundary if the boundary layer makes more than half
    /// of the sliding loss.
    pub regime: Regime,
    /// Mesh positions computed.
    pub positions: usize,
    /// Largest relative load error of a contact solution.
    pub worst_load_error: f64,
    /// Largest certified duality gap of a contact solution.
    pub worst_duality_gap: f64,
}

impl Summary {
    /// All losses of the run with every constant at its median \[W\], drawn or not.
    #[must_use]
    pub fn at_medians_w(&self) -> f64 {
        self.loss_at_medians_w.unwrap_or(self.loss_w)
    }

    /// Lubrication regime in words.
    #[must_use]
    pub fn regime_words(&self) -> &'static str {
        self.regime.words(self.asperity_share)
    }
}

/// A published friction law applied whole: its coefficient times the load, instead of film and asperities.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PublishedLawRow {
    /// Name as in the case file.
    pub law: String,
    /// Whether its coefficient includes asperity friction.
    pub includes_asperities: bool,
    /// Whether the law excludes the rolling loss, which is then taken from this result.
    pub excludes_rolling: bool,
    /// Data it was fitted to.
    pub fitted_to: String,
    /// Whether every input lies inside what it was fitted to.
    pub inside_its_range: bool,
    /// Distinct inputs outside that range.
    pub outside: Vec<String>,
    /// Loss and efficiency, or why there are none.
    #[serde(flatten)]
    pub outcome: PublishedOutcome,
}

/// Loss by a published friction law.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum PublishedOutcome {
    /// Loss and efficiency of the mesh.
    Applied {
        /// All losses \[W\].
        loss_w: f64,
        /// Sliding loss \[W\].
        sliding_w: f64,
        /// Mesh efficiency.
        efficiency: f64,
    },
    /// Reason why the law cannot be used here.
    Refused(String),
}

/// One mesh position; values that vary with the offset are means over the offsets.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PositionRow {
    /// Number of the position from A.
    pub position: usize,
    /// Coordinate along the line of action from T1 \[mm\].
    pub s_mm: f64,
    /// 0 at A, 1 at E.
    pub path_fraction: f64,
    /// Weight of the position in the cycle mean: the loaded contact line that it represents \[m\].
    pub weight_m: f64,
    /// Line load \[N/mm\].
    pub line_load_n_per_mm: f64,
    /// Line load with which the row makes its sliding loss \[N/mm\]: the line load of the cell which the row represents,
    /// weighted with the sliding speed, over the sliding speed of the row. `mu` times it times the sliding speed is
    /// `sliding_w_per_m`.
    pub sliding_load_n_per_mm: f64,
    /// Share of the whole tooth force that a line of contact over the full face carries here.
    pub load_share: f64,
    /// Relative radius of curvature \[mm\].
    pub radius_mm: f64,
    /// Surface speed of the pinion \[m/s\].
    pub u1_m_per_s: f64,
    /// Surface speed of the wheel \[m/s\].
    pub u2_m_per_s: f64,
    /// Sliding speed \[m/s\].
    pub sliding_m_per_s: f64,
    /// Entrainment speed \[m/s\].
    pub entrainment_m_per_s: f64,
    /// Slide-to-roll ratio.
    pub slide_to_roll: f64,
    /// Hertz half width \[µm\].
    pub half_width_um: f64,
    /// Hertz pressure \[MPa\].
    pub hertz_pressure_mpa: f64,
    /// Thermal reduction of the film.
    pub thermal_reduction: f64,
    /// Central film with thermal reduction \[µm\].
    pub film_central_um: f64,
    /// Minimum film with thermal reduction \[µm\].
    pub film_minimum_um: f64,
    /// Λ*, median over the offsets; absent when the peaks of the flanks are not known.
    pub lambda_star: Option<f64>,
    /// Minimum film over composite Rq; absent when both flanks are flat.
    pub film_ratio: Option<f64>,
    /// Share of the offsets whose asperities carry 2 % of the load and more; with `formulation = "paper"`, Λ* < 1.
    pub mixed_share: f64,
    /// Full film if no offset is mixed; boundary if the boundary layer makes more than half of the friction.
    pub regime: Regime,
    /// Share of the load the film carries; asperities carry the rest, φ.
    pub film_share: f64,
    /// Standard error of that share, where it is recorded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film_share_standard_error: Option<f64>,
    /// Share β of the asperities' load on the boundary layer; absent where nothing touches.
    pub boundary_of_asperities: Option<f64>,
    /// Share φβ of the load on the boundary layer.
    pub boundary_share: f64,
    /// Mean gap of the rough flanks \[µm\], of load shares that solve the contact.
    pub mean_gap_um: Option<f64>,
    /// Roughness σ_d that the contact leaves over the central film of mass flow, mean over the offsets, of load shares that
    /// solve the contact.
    pub roughness_over_film: Option<f64>,
    /// Elastohydrodynamic solution of the full film, if the case requests it and an offset has a full film.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_film: Option<FullFilmRow>,
    /// Friction coefficient in the film.
    pub mu_film: f64,
    /// Friction coefficient of the whole contact.
    pub mu: f64,
    /// Flash temperature \[K\].
    pub flash_k: f64,
    /// The largest flash temperature of an offset \[K\].
    pub flash_max_k: f64,
    /// Sliding loss per metre of contact line, mean over that length \[W/m\].
    pub sliding_w_per_m: f64,
    /// Standard deviation of the sliding loss over the offsets \[W/m\]; absent with one offset.
    pub sliding_deviation_w_per_m: Option<f64>,
    /// Standard error of the sliding loss over pairs of several teeth \[W/m\]; `None` with one trace for each flank.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sliding_standard_error_w_per_m: Option<f64>,
    /// Degrees of freedom of that.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sliding_error_freedom: Option<f64>,
    /// Zone of the face that the position represents, from 0, where the traces differ across it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face_zone: Option<usize>,
    /// Its part in the film \[W/m\].
    pub film_w_per_m: f64,
    /// Its part in lubricated asperities \[W/m\].
    pub lubricated_asperity_w_per_m: f64,
    /// Its part in the boundary layer \[W/m\].
    pub boundary_w_per_m: f64,
    /// Rolling loss per metre of contact line, hysteresis included \[W/m\].
    pub rolling_w_per_m: f64,
    /// Share of the window in solid contact (mixed offsets).
    pub contact_fraction: Option<f64>,
    /// Largest total pressure of fluid and solids \[MPa\] (mixed offsets).
    pub p_max_mpa: Option<f64>,
    /// Plastic work of the first engagement per metre \[J/m\] (mixed offsets).
    pub plastic_work_j_per_m: Option<f64>,
    /// Largest von Mises stress below the surface at the first offset \[MPa\].
    pub von_mises_max_mpa: Option<f64>,
    /// Its depth \[µm\].
    pub von_mises_depth_um: Option<f64>,
    /// Greatest depth at which the von Mises stress exceeds the elastic limit at the first offset \[µm\]; 0 if it does
    /// so nowhere.
    pub yield_depth_um: Option<f64>,
    /// Share in which it does so, of the section as wide as the Hertz contact and half as deep.
    pub yield_share: Option<f64>,
    /// Iterations of the contact solver, summed over the offsets.
    pub iterations: usize,
    /// Largest relative load error of a contact solution.
    pub load_error: f64,
}

impl PositionRow {
    /// Loss of sliding and rolling per metre of contact line \[W/m\].
    #[must_use]
    pub fn loss_w_per_m(&self) -> f64 {
        self.film_w_per_m
            + self.boundary_w_per_m
            + self.lubricated_asperity_w_per_m
            + self.rolling_w_per_m
    }
}

/// A named point of the path of contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PointRow {
    /// A, B, C, D or E.
    pub point: Cow<'static, str>,
    /// Property that holds there.
    #[serde(flatten)]
    pub row: PositionRow,
}

/// A record of transient mixed lubrication at one place of the path; means with standard errors from the means
/// of its half-widths of travel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RecordRow {
    /// Place on the path, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// Hertz pressure \[MPa\].
    pub hertz_pressure_mpa: f64,
    /// Slide-to-roll ratio.
    pub slide_to_roll: f64,
    /// Central film of smooth flanks \[µm\].
    pub smooth_film_um: f64,
    /// Roughness that is left in the contact over that film.
    pub roughness_over_film: f64,
    /// Share of the load on films below 20 nm.
    pub solid_share: f64,
    /// Its standard error.
    pub solid_share_standard_error: f64,
    /// Share of the load on films below 50 nm.
    pub share_below_50_nm: f64,
    /// Mean gap of the flanks \[µm\].
    pub mean_gap_um: f64,
    /// Its standard error \[µm\].
    pub mean_gap_standard_error_um: f64,
    /// Isothermal friction coefficient, film and boundary layer, with whole boundary friction on contact nodes.
    pub friction: f64,
    /// Its standard error.
    pub friction_standard_error: f64,
    /// Isothermal friction coefficient with the weight of the solved load share, e^(−h/h_b), on the boundary
    /// friction.
    pub graded_friction: f64,
    /// Isothermal friction coefficient with the whole boundary friction on films below 20 nm.
    pub stepped_friction: f64,
    /// Mean of the largest pressure \[MPa\].
    pub mean_p_max_mpa: f64,
    /// Largest pressure of all times \[MPa\].
    pub p_max_mpa: f64,
    /// Travel in half-widths.
    pub travel_half_widths: f64,
    /// Time steps.
    pub steps: usize,
    /// Steps repeated at half their length.
    pub steps_cut: usize,
    /// Steps with a node held in contact.
    pub loose_steps: usize,
    /// Largest load error of a step.
    pub load_error: f64,
}

/// What reference solutions leave uncertain of a sliding loss.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RecordedFriction {
    /// Standard error of ln of the sliding loss by the finite travel of the records.
    pub standard_error: f64,
    /// Sliding loss with the whole boundary friction on films below 20 nm, over that with a boundary friction that falls with the
    /// film; the run has the mean of the two.
    pub stepped: f64,
    /// Windows that pass through the contacts of all records together, each as wide as a contact averages over.
    pub windows: f64,
}

/// Plastic work of the first engagement, which decays as the flanks run in and is in no loss.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RunningIn {
    /// Plastic work per tooth engagement \[J\].
    pub energy_per_engagement_j: f64,
    /// The same as a power at the first pass \[W\]; it decays to nothing.
    pub first_pass_w: f64,
}

/// The mesh with flanks that have run in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RunInFlanks {
    /// Torque at the pinion while they ran in \[N m\].
    pub torque_nm: f64,
    /// Efficiency and losses of the run-in flanks.
    pub summary: Summary,
    /// Plastic work that an engagement still does.
    pub running_in: RunningIn,
    /// Roughness of the flanks as measured.
    pub measured: FlankHeights,
    /// Roughness of the run-in flanks.
    pub run_in: FlankHeights,
    /// Each doubling of the engagements.
    pub steps: Vec<RunInStep>,
    /// Whether the last doubling changed the Rq of both flanks together by less than 0.5 %.
    pub is_settled: bool,
}

/// An equation the result rests on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct EquationUse {
    /// Tag as in the sources.
    pub tag: Cow<'static, str>,
    /// Title.
    pub title: Cow<'static, str>,
    /// Keys of its sources.
    pub references: Vec<Cow<'static, str>>,
}

/// Publication that an equation of the result comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CitedSource {
    /// Short key, `author_year`.
    pub key: Cow<'static, str>,
    /// Authors, title, place, year.
    pub text: Cow<'static, str>,
}

impl From<crate::equations::Reference> for CitedSource {
    fn from(reference: crate::equations::Reference) -> Self {
        Self {
            key: reference.key.into(),
            text: reference.text.into(),
        }
    }
}

/// Fields along the contact at one position, of its first offset.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PositionFields {
    /// Number of the position from A.
    pub position: usize,
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Heights of the pinion's flank before contact \[m\].
    pub height_pinion: Vec<f64>,
    /// Heights of the wheel's flank before contact \[m\].
    pub height_wheel: Vec<f64>,
    /// Elastic and plastic displacement of the pinion in contact \[m\].
    pub displacement_pinion: Vec<f64>,
    /// Elastic and plastic displacement of the wheel in contact \[m\].
    pub displacement_wheel: Vec<f64>,
    /// Plastic displacement of the pinion, which stays after contact \[m\].
    pub plastic_pinion: Vec<f64>,
    /// Plastic displacement of the wheel, which stays after contact \[m\].
    pub plastic_wheel: Vec<f64>,
    /// Gap in contact \[m\].
    pub gap: Vec<f64>,
    /// Pressure of touching asperities \[Pa\].
    pub pressure_solid: Vec<f64>,
    /// Pressure in the film \[Pa\].
    pub pressure_fluid: Vec<f64>,
    /// Shear stress on the surface \[Pa\].
    pub shear: Vec<f64>,
    /// Stress below the surface, where it was computed.
    pub subsurface: Option<SubsurfaceFields>,
    /// History of the approach to the solution.
    pub history: Vec<HistoryRow>,
    /// The contact over an extent along the lead, where patches are in contact; the other fields are of its middle row.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub patch: Option<PatchFields>,
}

/// Contact of a patch, row by row along the lead.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PatchFields {
    /// Places of the columns along rolling, 0 in the middle of the contact \[m\].
    pub x: Vec<f64>,
    /// Places of the rows along the lead \[m\].
    pub y: Vec<f64>,
    /// Pressure of touching asperities \[Pa\].
    pub pressure: Vec<f64>,
    /// Pressure in the film of each column \[Pa\].
    pub pressure_fluid: Vec<f64>,
    /// The spot of each cell, a place in `spot_losses`; `None` where the flanks stay apart.
    pub spot: Vec<Option<u32>>,
    /// Sliding loss of each spot of this patch \[W\].
    pub spot_losses: Vec<f64>,
}

/// Stress below the surface, row by row from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SubsurfaceFields {
    /// Depths \[m\].
    pub depths: Vec<f64>,
    /// Normal stress along the surface \[Pa\].
    pub sigma_xx: Vec<f64>,
    /// Normal stress into the surface \[Pa\].
    pub sigma_zz: Vec<f64>,
    /// Shear stress \[Pa\].
    pub tau_xz: Vec<f64>,
    /// Von Mises stress \[Pa\].
    pub von_mises: Vec<f64>,
    /// Von Mises stress beyond the elastic limit \[Pa\], else 0.
    pub plastic_stress: Vec<f64>,
}

/// A step on the way to the solution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HistoryRow {
    /// Number of the step.
    pub step: usize,
    /// Approach of the bodies from first touch \[m\]; negative while apart.
    pub approach: f64,
    /// Load on the asperities \[N/m\].
    pub load_solid: f64,
    /// Load on the film \[N/m\].
    pub load_fluid: f64,
    /// |F − F_target|/F_target.
    pub load_error: f64,
}

/// The mesh with all flanks at one offset of the traces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct OffsetRow {
    /// Number of the offset.
    pub offset: usize,
    /// Mesh efficiency.
    pub efficiency: f64,
    /// All losses \[W\].
    pub loss_w: f64,
    /// Sliding loss \[W\].
    pub sliding_w: f64,
    /// Rolling loss \[W\].
    pub rolling_w: f64,
}

/// Losses of a case, without fields and comparisons.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Losses {
    /// Efficiency and losses, mean over the offsets.
    pub summary: Summary,
    /// One row per mesh position; the columns of the rough contact are empty unless the losses depend on it.
    pub path: Vec<PositionRow>,
    /// Efficiency and losses at each offset, whose mean is the summary.
    pub offsets: Vec<OffsetRow>,
    /// Sampling error over all pairs of several traces; absent where each flank has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pairs: Option<PairSampling>,
    /// Running-in loss of the first pass.
    #[serde(skip)]
    pub running_in: RunningIn,
    /// Losses with flanks that have run in, if the case requests them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run_in: Option<RunInFlanks>,
    /// The bulk temperature found from the loss; absent where it is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bulk: Option<BulkReport>,
    /// Loss and efficiency of the gearbox, if the case states its other parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// Distinct inputs outside the range of a correlation or of lubricated steel.
    pub outside: Vec<OutsideInput>,
    /// Warnings, those of a whole run except for its pictures and ratings.
    pub warnings: Vec<Warning>,
    /// Equations used.
    pub equations: Vec<EquationUse>,
}

/// A run: the result and the fields of its positions.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct MeshOutcome {
    /// Summary and path.
    pub result: RunResult,
    /// Efficiency and losses at each offset, whose mean is the summary.
    pub offsets: Vec<OffsetRow>,
    /// Fields of every position, of its first offset.
    pub fields: Vec<PositionFields>,
    /// The flanks facing each other at every position whose contact was solved, whatever fields are held.
    pub views: Vec<ContactView>,
    /// Load over the flanks, point by point.
    pub load_map: LoadMap,
    /// Traces of pinion and wheel as read; absent for a flank known only by its roughness values.
    pub traces: [Option<Profile>; 2],
}
