//! Displacement of two half-planes by a pressure on an even grid, by fast transforms.
//!
//! Source: the paper's eqs. 1, 3 and 4 (boundary elements), Johnson 1985 chapter 2.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, W | pressure of a cell, load per metre of face width | Pa, N/m |
//! | u | displacement of both bodies together, away from each other | m |
//! | C_ij | kernel at the distance of the cells i and j | m |
//! | h, g, δ | undeformed gap, gap, approach | m |
//! | E* | reduced modulus | Pa |
//! | dx = 2a | distance of the cell centres | m |
//!
//! Free ends: the Toeplitz matrix C is embedded in a circulant of twice a length with small factors.
//! Periodic ends: C is a circulant. Every symbol is real and dimensionless, so one plan serves all
//! spacings and moduli.

use std::f64::consts::PI;

use asperity_core::numerics::FourierNumber;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};
use rustfft::FftPlanner;

use crate::boundary::{Boundary, PeriodicKernel};
use crate::convolution::{Buffers, Convolution, EvenFilter, fast_length};
use crate::error::ContactError;
use crate::problem::LEAST_POINTS;
use crate::strip_kernel::{column_of_period, spectral_symbol, strip_column};

/// The displacement operator of a grid, with its plan and buffers.
///
/// ```
/// use asperity_contact::{Boundary, half_plane::HalfPlane};
/// let mut plane = HalfPlane::new(3, "1 um".parse()?, "115 GPa".parse()?, Boundary::FreeEnds)?;
/// let mut displacement = [0.0; 3];
/// plane.displacement(&[0.0, 1e9, 0.0], &mut displacement)?;
/// assert!(displacement[1] > displacement[0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct HalfPlane {
    filter: EvenFilter,
    buffers: Buffers,
    compliance: f64,
    boundary: Boundary,
}

impl HalfPlane {
    /// Makes the operator of `points` cells.
    ///
    /// # Errors
    /// When there are fewer than two points, or spacing or modulus is not positive.
    pub fn new(
        points: usize,
        spacing: Length,
        modulus: Pressure,
        boundary: Boundary,
    ) -> Result<Self, ContactError> {
        if points < LEAST_POINTS {
            return Err(ContactError::too_few_points(points, LEAST_POINTS));
        }
        let compliance = cell_compliance(spacing, modulus)?;
        let mut buffers = Buffers::default();
        let planner = &mut f64::planner();
        let filter = displacement_filter(planner, points, boundary, &mut vec![], &mut buffers);
        buffers.reserve(&filter);
        Ok(Self {
            filter,
            buffers,
            compliance,
            boundary,
        })
    }

    /// uᵢ = (1/(π·E*))·Σⱼ C_ij·p_j                                                      `[P1]`
    ///
    /// Writes the displacement in m by `pressure` in Pa, with C(0) = 0 for free ends (see
    /// [`datum_constant`](crate::strip_kernel::datum_constant)) and without mean for periodic ends.
    ///
    /// # Errors
    /// When an array does not have one value per cell.
    pub fn displacement(
        &mut self,
        pressure: &[f64],
        displacement: &mut [f64],
    ) -> Result<(), ContactError> {
        cite_kernel(self.boundary);
        displace(
            &self.filter,
            &mut self.buffers,
            self.compliance,
            pressure,
            displacement,
        )
    }
}

/// Writes the displacement in m by `pressure` in Pa, of a filter and the compliance of a cell.
pub(crate) fn displace(
    filter: &EvenFilter,
    buffers: &mut Buffers,
    compliance: f64,
    pressure: &[f64],
    displacement: &mut [f64],
) -> Result<(), ContactError> {
    check_lengths(filter.points(), pressure, displacement)?;
    filter.filter(buffers, compliance, pressure);
    displacement.copy_from_slice(buffers.signal(filter.points()));
    Ok(())
}

/// Checks that pressure and displacement have `need` values.
pub(crate) fn check_lengths(
    need: usize,
    pressure: &[f64],
    displacement: &[f64],
) -> Result<(), ContactError> {
    cite!("P1");
    for (name, got) in [
        ("pressure", pressure.len()),
        ("displacement", displacement.len()),
    ] {
        if got != need {
            return Err(ContactError::WrongLength { name, need, got });
        }
    }
    Ok(())
}

/// g = h + u − δ,  u(x) = −(2/(π·E*))·∫ p(s)·ln|x − s| ds + const                         `[Gap-deformed]`
///
/// Gap in m at each point from undeformed gap h and displacement u in m, up to the shorter array.
///
/// ```
/// use asperity_contact::half_plane::deformed_gap;
/// let gap = deformed_gap(&[1e-6, 2e-6], &[0.5e-6, 0.0], "1 um".parse()?);
/// assert!((gap[0] - 0.5e-6).abs() < 1e-20);
/// # Ok::<(), asperity_core::quantity::QuantityError>(())
/// ```
pub fn deformed_gap(undeformed: &[f64], displacement: &[f64], approach: Length) -> Vec<f64> {
    cite!("Gap-deformed");
    let delta = approach.si();
    undeformed
        .iter()
        .zip(displacement)
        .map(|(h, u)| h + u - delta)
        .collect()
}

/// W = Σᵢ pᵢ·dx                                                                            `[P4]`
///
/// ```
/// use asperity_contact::half_plane::line_load;
/// assert_eq!(line_load(&[1e9, 2e9], "1 um".parse()?).si(), 3e3);
/// # Ok::<(), asperity_core::quantity::QuantityError>(())
/// ```
pub fn line_load(pressure: &[f64], spacing: Length) -> LineLoad {
    cite!("P4");
    LineLoad::from_si(pressure.iter().sum::<f64>() * spacing.si())
}

/// a/(π·E*) in m/Pa, the factor of a dimensionless kernel.
pub(crate) fn cell_compliance(spacing: Length, modulus: Pressure) -> Result<f64, ContactError> {
    let dx = DomainError::positive("spacing", spacing)?;
    let e = DomainError::positive("reduced modulus", modulus)?;
    Ok(0.5 * dx / (PI * e))
}

/// Records the equation of the displacement kernel of a boundary, which a cached operator does not
/// evaluate again:
///
/// free ends: C(x) of a strip                                                            `[P2]`
/// periodic ends: C(x) of a strip and all its images                                     `[Periodic-1]`
/// or of a wave, u_q = 2·p_q/(E*·|q|)                                                    `[Periodic-2]`
pub(crate) fn cite_kernel(boundary: Boundary) {
    match boundary {
        Boundary::FreeEnds => cite!("P2"),
        Boundary::Periodic(PeriodicKernel::Strip) => cite!("Periodic-1"),
        Boundary::Periodic(PeriodicKernel::Spectral) => cite!("Periodic-2"),
    }
}

/// The filter C/a. `column` caches the kernel of free ends, which is the same at the first cells of every
/// grid, and is extended if it is too short.
pub(crate) fn displacement_filter(
    planner: &mut FftPlanner<f64>,
    points: usize,
    boundary: Boundary,
    column: &mut Vec<f64>,
    buffers: &mut Buffers,
) -> EvenFilter {
    match boundary {
        Boundary::FreeEnds => {
            if column.len() < points {
                *column = strip_column(points);
            }
            EvenFilter::from_column(planner, &column[..points], buffers)
        }
        Boundary::Periodic(PeriodicKernel::Strip) => {
            EvenFilter::from_period(planner, &column_of_period(points), buffers).without_mean()
        }
        Boundary::Periodic(PeriodicKernel::Spectral) => {
            let symbol = |wave| spectral_symbol(wave, points);
            EvenFilter::from_symbol(planner, points, points, symbol)
        }
    }
}

/// The filter |q|·E*/2 in units of π·E*/(2a): nearly the inverse of the displacement, used as a
/// preconditioner, for which single precision is enough. Its zero mode, which the displacement does not
/// determine, is half of its first: a masked signal has a mean, which must be neither lost nor amplified.
pub(crate) fn inverse_filter(planner: &mut FftPlanner<f32>, points: usize) -> EvenFilter<f32> {
    let length = fast_length(points);
    let symbol = |wave: usize| if wave == 0 { 0.5 } else { wave as f64 } / length as f64;
    EvenFilter::from_symbol(planner, points, length, symbol)
}
