//! Tables as CSV; every header carries its unit.

use std::path::Path;

use serde::Serialize;

use super::{MICRO, ReportError};
use crate::result::{HistoryRow, PositionFields, PositionRow, SubsurfaceFields};

const MEGA: f64 = 1e-6;

/// `path.csv`: a row per mesh position.
pub(super) fn path(rows: &[PositionRow], file: &Path) -> Result<(), ReportError> {
    write(file, rows.iter())
}

/// `convergence.csv`: the steps of every position.
pub(super) fn convergence(fields: &[PositionFields], file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        position: usize,
        step: usize,
        approach_um: f64,
        load_solid_n_per_mm: f64,
        load_fluid_n_per_mm: f64,
        load_error: f64,
    }
    let rows = fields.iter().flat_map(|at| {
        at.history.iter().map(|row: &HistoryRow| Row {
            position: at.position,
            step: row.step,
            approach_um: row.approach * MICRO,
            load_solid_n_per_mm: row.load_solid * 1e-3,
            load_fluid_n_per_mm: row.load_fluid * 1e-3,
            load_error: row.load_error,
        })
    });
    write(file, rows)
}

/// The gap of a contact: position and undeformed gap in metres, to the last bit.
pub(super) fn gap(x: &[f64], gap: &[f64], file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        x_m: f64,
        h_m: f64,
    }
    let rows = x.iter().zip(gap).map(|(&x_m, &h_m)| Row { x_m, h_m });
    write(file, rows)
}

/// `surface.csv`: fields along the contact, with the pressure of the smooth dry contact.
pub(super) fn surface(
    fields: &PositionFields,
    at: &PositionRow,
    file: &Path,
) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        x_um: f64,
        height_pinion_um: f64,
        height_wheel_um: f64,
        displacement_pinion_um: f64,
        displacement_wheel_um: f64,
        plastic_pinion_um: f64,
        plastic_wheel_um: f64,
        gap_um: f64,
        pressure_solid_mpa: f64,
        pressure_fluid_mpa: f64,
        shear_mpa: f64,
        pressure_hertz_mpa: f64,
    }
    let hertz = |x_um: f64| {
        let inside = 1.0 - (x_um / at.half_width_um).powi(2);
        at.hertz_pressure_mpa * inside.max(0.0).sqrt()
    };
    write(
        file,
        (0..fields.x.len()).map(|i| Row {
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
        }),
    )
}

/// Points in a row of `subsurface.csv`: the stress below the surface is smooth along it.
const POINTS_IN_A_ROW: usize = 200;

/// `subsurface.csv`: stress below the surface, every k-th point of each depth.
pub(super) fn subsurface(
    x: &[f64],
    below: &SubsurfaceFields,
    file: &Path,
) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        x_um: String,
        depth_um: String,
        sigma_xx_mpa: String,
        sigma_zz_mpa: String,
        tau_xz_mpa: String,
        von_mises_mpa: String,
    }
    // Six digits: the fields are large and are looked at, not computed with.
    let text = |value: f64| format!("{value:.5e}");
    let x_len = x.len();
    let stride = x.len().div_ceil(POINTS_IN_A_ROW).max(1);
    let rows = below.depths.iter().enumerate().flat_map(|(level, &depth)| {
        x.iter().enumerate().step_by(stride).map(move |(i, &x)| {
            let at = level * x_len + i;
            Row {
                x_um: text(x * MICRO),
                depth_um: text(depth * MICRO),
                sigma_xx_mpa: text(below.sigma_xx[at] * MEGA),
                sigma_zz_mpa: text(below.sigma_zz[at] * MEGA),
                tau_xz_mpa: text(below.tau_xz[at] * MEGA),
                von_mises_mpa: text(below.von_mises[at] * MEGA),
            }
        })
    });
    write(file, rows)
}

pub(super) fn write<R: Serialize>(
    file: &Path,
    rows: impl Iterator<Item = R>,
) -> Result<(), ReportError> {
    let failed = |source| ReportError::Csv {
        path: file.to_owned(),
        source,
    };
    let mut writer = csv::Writer::from_path(file).map_err(failed)?;
    for row in rows {
        writer.serialize(row).map_err(failed)?;
    }
    writer.flush().map_err(|source| ReportError::Io {
        path: file.to_owned(),
        source,
    })
}
