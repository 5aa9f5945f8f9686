//! Tables of one mesh position: fields along the contact, subsurface stress, steps of the solution.

use crate::error;
use std::path::Path;

use asperity::result::{PositionFields, PositionRow, SubsurfaceFields};
use asperity_core::Fault;
use asperity_core::numerics::range;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use asperity_table::own::{OwnFault, finite};

use super::csv_table::{check_field, read};
use super::patch::PatchTable;
use crate::thin::{BINS, thin};
use crate::units::{MEGA, MICRO};

/// Table of the steps of the solutions of all positions.
pub(crate) const CONVERGENCE: &str = "convergence.csv";

/// Table of the contact of a patch.
pub(crate) const PATCH: &str = "patch.csv";

/// Row of `surface.csv`: fields along the contact, with the pressure of the smooth dry contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SurfaceRow {
    /// Distance from the middle of the contact \[µm\].
    pub x_um: f64,
    /// Height of the pinion's flank before contact \[µm\].
    pub height_pinion_um: f64,
    /// Height of the wheel's flank before contact \[µm\].
    pub height_wheel_um: f64,
    /// Displacement of the pinion in contact \[µm\].
    pub displacement_pinion_um: f64,
    /// Displacement of the wheel in contact \[µm\].
    pub displacement_wheel_um: f64,
    /// Plastic displacement of the pinion \[µm\].
    pub plastic_pinion_um: f64,
    /// Plastic displacement of the wheel \[µm\].
    pub plastic_wheel_um: f64,
    /// Gap in contact \[µm\].
    pub gap_um: f64,
    /// Pressure of touching asperities \[MPa\].
    pub pressure_solid_mpa: f64,
    /// Pressure in the film \[MPa\].
    pub pressure_fluid_mpa: f64,
    /// Shear stress on the surface \[MPa\].
    pub shear_mpa: f64,
    /// Pressure of the smooth dry contact \[MPa\].
    pub pressure_hertz_mpa: f64,
}

/// Row of `subsurface.csv`: stress at a point below the surface, six digits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SubsurfaceRow {
    /// Distance from the middle of the contact \[µm\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub x_um: f64,
    /// Depth \[µm\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub depth_um: f64,
    /// Normal stress along the surface \[MPa\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub sigma_xx_mpa: f64,
    /// Normal stress into the surface \[MPa\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub sigma_zz_mpa: f64,
    /// Shear stress \[MPa\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub tau_xz_mpa: f64,
    /// Von Mises stress \[MPa\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub von_mises_mpa: f64,
    /// Von Mises stress beyond the elastic limit, else 0 \[MPa\].
    #[serde(serialize_with = "six_digits", deserialize_with = "number")]
    pub plastic_stress_mpa: f64,
}

/// Six digits: the fields are large and serve for display.
fn six_digits<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if value.is_finite() {
        serializer.collect_str(&format_args!("{value:.5e}"))
    } else {
        serializer.serialize_f64(*value)
    }
}

/// A number, or a number as text.
fn number<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Either {
        Number(f64),
        Text(String),
    }
    match Either::deserialize(deserializer)? {
        Either::Number(value) => Ok(value),
        Either::Text(text) => text.parse().map_err(serde::de::Error::custom),
    }
}

/// `value` with the digits of the table.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Row of `convergence.csv`: a step of the solution of a position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ConvergenceRow {
    /// Number of the position from A.
    pub position: usize,
    /// Number of the step.
    pub step: usize,
    /// Approach of the bodies from first touch \[µm\].
    pub approach_um: f64,
    /// Load on the asperities \[N/mm\].
    pub load_solid_n_per_mm: f64,
    /// Load on the film \[N/mm\].
    pub load_fluid_n_per_mm: f64,
    /// |F − F_target|/F_target.
    pub load_error: f64,
}

/// Rows of `convergence.csv` for one position.
pub fn convergence(fields: &PositionFields) -> Vec<ConvergenceRow> {
    let rows = fields.history.iter().map(|row| ConvergenceRow {
        position: fields.position,
        step: row.step,
        approach_um: row.approach * MICRO,
        load_solid_n_per_mm: row.load_solid * 1e-3,
        load_fluid_n_per_mm: row.load_fluid * 1e-3,
        load_error: row.load_error,
    });
    rows.collect()
}

/// Tables of one mesh position.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactTables {
    /// Number of the position from A.
    pub position: usize,
    /// Fields along the contact.
    pub surface: Vec<SurfaceRow>,
    /// Stress below the surface, by depth; empty if it was not computed.
    pub subsurface: Vec<SubsurfaceRow>,
    /// Steps of the solution; empty if no contact was solved.
    pub convergence: Vec<ConvergenceRow>,
    /// The contact over an extent along the lead; `None` of a line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub patch: Option<PatchTable>,
}

impl ContactTables {
    /// Makes the tables of `fields`, whose position has the row `at` of the path.
    pub fn new(fields: &PositionFields, at: &PositionRow) -> Self {
        let below = fields.subsurface.as_ref();
        Self {
            position: fields.position,
            surface: surface(fields, at),
            subsurface: below.map_or(Vec::new(), |below| subsurface(&fields.x, below, at)),
            convergence: convergence(fields),
            patch: PatchTable::from_fields(fields),
        }
    }

    /// Names of the tables of `position` in a result folder.
    pub(crate) fn files(folder: &Path, position: usize) -> Vec<String> {
        let place = folder_of(position);
        let names = ["surface.csv", "subsurface.csv", PATCH].map(|name| format!("{place}/{name}"));
        let names = names.into_iter().chain([CONVERGENCE.to_owned()]);
        names.filter(|name| folder.join(name).exists()).collect()
    }

    /// Reads the tables of `position` in a result folder; `None` if its fields were not stored.
    ///
    /// # Errors
    /// When a table is damaged.
    pub fn read(folder: &Path, position: usize) -> Result<Option<Self>, Fault> {
        let place = folder.join(folder_of(position));
        let file = place.join("surface.csv");
        if !file.exists() {
            return Ok(None);
        }
        let below = place.join("subsurface.csv");
        let steps = folder.join(CONVERGENCE);
        let mut convergence = if steps.exists() {
            read::<ConvergenceRow>(&steps)?
        } else {
            Vec::new()
        };
        convergence.retain(|row| row.position == position);
        let patch = place.join(PATCH);
        let patch = if patch.exists() {
            Some(PatchTable::read(&patch)?)
        } else {
            None
        };
        let subsurface = if below.exists() {
            read(&below)?
        } else {
            Vec::new()
        };
        let tables = Self {
            position,
            surface: read(&file)?,
            subsurface,
            convergence,
            patch,
        };
        match tables.check() {
            Ok(()) => Ok(Some(tables)),
            Err(reason) => Err(error::bad_table(&below, reason)),
        }
    }

    /// Whether the stress below the surface is a field of finite numbers, and the patch a rectangle.
    pub(crate) fn check(&self) -> Result<(), OwnFault> {
        self.patch.as_ref().map_or(Ok(()), PatchTable::check)?;
        finite(&self.subsurface)?;
        check_field(&self.subsurface, |row| [row.x_um, row.depth_um])
    }
}

/// Range of a page to either side of a contact and below it, in Hertz half-widths.
pub(crate) const NEAR: f64 = 1.6;

/// Coordinate of `x_um` for thinning: the range of the page has most of the bins.
fn across(x_um: f64, at: &PositionRow) -> f64 {
    /// Density of bins outside of this range, relative to within.
    const BESIDE: f64 = 0.1;
    let x = x_um / at.half_width_um;
    let near = x.clamp(-NEAR, NEAR);
    near + BESIDE * (x - near)
}

impl SurfaceRow {
    /// Height of the wheel's flank in the pinion's frame before contact, up to a constant \[µm\]: x²/(2R) − z₂ with the
    /// relative radius R of `at`.
    pub(crate) fn wheel_facing_um(&self, at: &PositionRow) -> f64 {
        0.5 * self.x_um.powi(2) / (1e3 * at.radius_mm) - self.height_wheel_um
    }

    /// Height of the pinion's flank under load, up to a constant \[µm\].
    pub(crate) fn pinion_pressed_um(&self) -> f64 {
        self.height_pinion_um - self.displacement_pinion_um
    }

    /// All values in charts.
    fn drawn(&self, at: &PositionRow) -> [f64; 11] {
        let (facing, pressed) = (self.wheel_facing_um(at), self.pinion_pressed_um());
        [
            self.height_pinion_um,
            facing,
            facing - self.height_pinion_um,
            pressed,
            pressed + self.gap_um,
            self.gap_um,
            self.plastic_pinion_um,
            self.plastic_wheel_um,
            self.pressure_solid_mpa,
            self.pressure_fluid_mpa,
            self.pressure_hertz_mpa,
        ]
    }
}

/// Name of the folder of a position.
pub fn folder_of(position: usize) -> String {
    format!("position_{position:02}")
}

impl ContactTables {
    /// The tables thinned for display: points along the contact with the extremes of every drawn curve, the stress
    /// near the contact.
    #[must_use]
    pub fn thinned(&self, at: &PositionRow) -> Self {
        let near = NEAR * at.half_width_um;
        let kept = |cell: &&SubsurfaceRow| cell.x_um.abs() <= near && cell.depth_um <= near;
        Self {
            position: self.position,
            surface: thin(
                &self.surface,
                BINS,
                |row| across(row.x_um, at),
                |row| row.drawn(at),
            ),
            subsurface: self.subsurface.iter().filter(kept).copied().collect(),
            convergence: self.convergence.clone(),
            patch: (self.patch.as_ref()).map(|patch| patch.thinned(near)),
        }
    }
}

fn surface(fields: &PositionFields, at: &PositionRow) -> Vec<SurfaceRow> {
    let hertz = |x_um: f64| {
        let inside = 1.0 - (x_um / at.half_width_um).powi(2);
        at.hertz_pressure_mpa * inside.max(0.0).sqrt()
    };
    let rows = (0..fields.x.len()).map(|i| SurfaceRow {
        x_um: fields.x[i] * MICRO,
        height_pinion_um: fields.height_pinion[i] * MICRO,
        height_wheel_um: fields.height_wheel[i] * MICRO,
        displacement_pinion_um: fields.displacement_pinion[i] * MICRO,
        displacement_wheel_um: fields.displacement_wheel[i] * MICRO,
        plastic_pinion_um: fields.plastic_pinion[i] * MICRO,
        plastic_wheel_um: fields.plastic_wheel[i] * MICRO,
        gap_um: fields.gap[i] * MICRO,
        pressure_solid_mpa: fields.pressure_solid[i] * MEGA,
        pressure_fluid_mpa: fields.pressure_fluid[i] * MEGA,
        shear_mpa: fields.shear[i] * MEGA,
        pressure_hertz_mpa: hertz(fields.x[i] * MICRO),
    });
    rows.collect()
}

/// Number of bins of `subsurface.csv` across the contact.
const SUBSURFACE_BINS: usize = 90;

/// Stress below the surface at all depths, for the positions where the highest or the lowest von Mises stress over the
/// depth is an extreme of its bin.
fn subsurface(x: &[f64], below: &SubsurfaceFields, at: &PositionRow) -> Vec<SubsurfaceRow> {
    let count = x.len();
    let levels = 0..below.depths.len();
    let extremes = |i: &usize| {
        let stresses = levels
            .clone()
            .map(|level| below.von_mises[level * count + i]);
        range(stresses)
    };
    let points: Vec<usize> = (0..count).collect();
    let coordinate = |i: &usize| across(x[*i] * MICRO, at);
    let columns = thin(&points, SUBSURFACE_BINS, coordinate, extremes);
    let rows = below.depths.iter().enumerate().flat_map(|(level, &depth)| {
        columns.iter().map(move |&i| {
            let at = level * count + i;
            SubsurfaceRow {
                x_um: rounded(x[i] * MICRO),
                depth_um: rounded(depth * MICRO),
                sigma_xx_mpa: rounded(below.sigma_xx[at] * MEGA),
                sigma_zz_mpa: rounded(below.sigma_zz[at] * MEGA),
                tau_xz_mpa: rounded(below.tau_xz[at] * MEGA),
                von_mises_mpa: rounded(below.von_mises[at] * MEGA),
                plastic_stress_mpa: rounded(below.plastic_stress[at] * MEGA),
            }
        })
    });
    rows.collect()
}
