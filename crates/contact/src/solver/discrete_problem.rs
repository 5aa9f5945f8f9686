//! Discrete contact problem, on the finest grid and on coarser grids.

use std::borrow::Cow;
use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::numerics::extremes;
use asperity_core::quantity::{Length, LineEnergy, Pressure};

use super::workspace::{Assessment, ReferenceBounds, Task};
use crate::boundary::Boundary;
use crate::cells::Cells;
use crate::certificate::Certificate;
use crate::error::ContactError;
use crate::half_plane::cell_compliance;
use crate::problem::{ContactProblem, Control, SolverSettings};
use crate::strip_kernel::datum_constant;

/// Loosest tolerance of a coarser grid whose finest grid has free ends and a rough contact. The coarse
/// solution is only a start, and the finest grid, solved on a window, is cheap.
const COARSE_TOLERANCE_FREE: f64 = 1e-4;
/// The same for periodic grids, which are solved as a whole, and for smooth contacts, which take few
/// iterations to a better start.
const COARSE_TOLERANCE_FINE: f64 = 1e-6;
/// Certificate of a coarser grid relative to its start. Halving the cells changes a rough contact so much that a
/// better coarse solution hardly improves the next start: 0.1 costs a tenth of a solution on 10⁵ points.
const GAIN: f64 = 0.5;
/// The same for a smooth contact, where the next start is as good as the coarse solution.
const SMOOTH_GAIN: f64 = 0.02;
/// Tolerance of the iteration relative to the tolerance of the solution: near round-off the certificates of a window
/// and of the whole grid differ in a few digits.
const TOLERANCE_MARGIN: f64 = 0.9;
/// Least reference gap, relative to the deformation, for bodies whose gap varies by less: the error of
/// a flat contact cannot be measured by its gap.
const FLAT: f64 = 1e-3;

/// Data shared by all grids of a problem.
pub(crate) struct DiscreteProblem<'a> {
    pub(crate) problem: &'a ContactProblem<'a>,
    pub(crate) cells: Cells,
    /// h plus the displacement by the prescribed pressure, minus a controlled approach, in m.
    pub(crate) gap: Cow<'a, [f64]>,
    reference_bounds: ReferenceBounds,
    /// Σp in Pa when the load is controlled.
    sum: Option<f64>,
    limit: f64,
    compliance: f64,
    /// Displacement by the datum per Σp in m/Pa.
    datum: f64,
    /// Σ of the prescribed pressure in Pa.
    prescribed_sum: f64,
}

impl<'a> DiscreteProblem<'a> {
    /// Makes the discrete form of a valid problem; `displace` returns the displacement in m by a pressure
    /// at a compliance.
    pub(crate) fn new<'b>(
        problem: &'a ContactProblem<'a>,
        displace: impl FnOnce(&[f64], f64) -> &'b mut [f64],
    ) -> Result<Self, ContactError> {
        let compliance = cell_compliance(problem.spacing, problem.modulus)?;
        let cells = problem.cells()?;
        let datum = datum_compliance(problem, 1.0, cells.rows)?;
        let prescribed_sum = problem.prescribed_pressure.unwrap_or(&[]).iter().sum();
        let mut gap = Cow::Borrowed(problem.gap);
        if let Some(prescribed) = problem.prescribed_pressure {
            for (h, u) in gap
                .to_mut()
                .iter_mut()
                .zip(displace(prescribed, compliance))
            {
                *h += *u;
            }
        }
        let (mut sum, mut deformation) = (None, 0.0);
        match problem.control {
            Control::Load(load) => {
                sum = Some(load.si() / problem.spacing.si() * cells.rows as f64);
                // The deformation of a line load is W/(π·E*) times a logarithm; as a lower bound the
                // logarithm is left out.
                deformation = load.si() / (PI * problem.modulus.si());
            }
            Control::Approach { approach, .. } => {
                for h in gap.to_mut() {
                    *h += datum * prescribed_sum - approach.si();
                    deformation = f64::max(deformation, -*h);
                }
            }
        }
        let (least, most) = extremes(&gap);
        Ok(Self {
            problem,
            cells,
            gap,
            reference_bounds: ReferenceBounds {
                least: FLAT * deformation,
                most: most - least,
            },
            sum,
            limit: problem.pressure_limit.map_or(f64::INFINITY, Pressure::si),
            compliance,
            datum,
            prescribed_sum,
        })
    }

    /// The problem on the `columns` of a window of the finest grid, whose gap is `gap`.
    pub(crate) fn task<'b>(
        &self,
        gap: &'b [f64],
        columns: usize,
        settings: &SolverSettings,
        max_iterations: usize,
    ) -> Task<'b> {
        Task {
            gap,
            columns,
            sum: self.sum,
            limit: self.limit,
            compliance: self.compliance,
            datum: self.datum,
            reference_gap: self.reference_bounds.most.max(self.reference_bounds.least),
            reference_bounds: self.reference_bounds,
            tolerance: TOLERANCE_MARGIN * settings.tolerance,
            least_tolerance: TOLERANCE_MARGIN * settings.tolerance,
            gain: GAIN,
            max_iterations,
        }
    }

    /// The problem on the whole of the finest grid, to be assessed.
    pub(crate) fn whole_task(&self, settings: &SolverSettings) -> Task<'_> {
        self.task(&self.gap, self.cells.columns, settings, 0)
    }

    /// The problem on a window of a coarser grid, whose gap is `gap`; the coarser grid is `halvings` levels below the finest.
    pub(crate) fn coarse_task<'b>(
        &self,
        gap: &'b [f64],
        window: Cells,
        halvings: i32,
        smooth: bool,
        settings: &SolverSettings,
    ) -> Result<Task<'b>, ContactError> {
        let width = 2f64.powi(halvings);
        let rows = window.rows as f64 / self.cells.rows as f64;
        let coarse = match self.problem.boundary {
            Boundary::FreeEnds if !smooth => COARSE_TOLERANCE_FREE,
            _ => COARSE_TOLERANCE_FINE,
        };
        Ok(Task {
            gap,
            columns: window.columns,
            sum: self.sum.map(|sum| sum / width * rows),
            limit: self.limit,
            compliance: self.compliance * width,
            datum: datum_compliance(self.problem, width, window.rows)?,
            reference_gap: self.reference_bounds.most.max(self.reference_bounds.least),
            reference_bounds: self.reference_bounds,
            tolerance: settings.tolerance.max(coarse),
            least_tolerance: settings.tolerance,
            gain: if smooth { SMOOTH_GAIN } else { GAIN },
            max_iterations: settings.max_iterations,
        })
    }

    /// Start pressure of the problem, scaled to its load; `None` without a start or if it carries no load.
    pub(crate) fn scaled_start(&self) -> Option<Vec<f64>> {
        let start = self.problem.start?;
        let carried: f64 = start.iter().sum();
        let scale = self.sum.map_or(1.0, |sum| sum / carried);
        (carried > 0.0).then(|| start.iter().map(|p| p * scale).collect())
    }

    /// Uniform pressure that carries the load; zero when the approach is controlled.
    pub(crate) fn even_pressure(&self) -> f64 {
        self.sum.map_or(0.0, |sum| sum / self.gap.len() as f64)
    }

    /// ½ ∫ (p + prescribed)·u dx, the mean over the lead.
    pub(crate) fn elastic_energy(&self, pressure: &[f64], displacement: &[f64]) -> LineEnergy {
        let cells = pressure.iter().zip(displacement);
        let work: f64 = match self.problem.prescribed_pressure {
            None => cells.map(|(p, u)| p * u).sum(),
            Some(prescribed) => {
                let cells = cells.zip(prescribed);
                cells.map(|((p, u), prescribed)| (p + prescribed) * u).sum()
            }
        };
        LineEnergy::from_si(0.5 * work * self.problem.spacing.si() / self.cells.rows as f64)
    }

    /// δ in m relative to the datum of the problem, from the α of the iteration, which has no datum.
    pub(crate) fn approach(&self, pressure: &[f64], iterated: f64) -> f64 {
        match self.problem.control {
            Control::Load(_) => {
                let sum: f64 = pressure.iter().sum();
                iterated + self.datum * (sum + self.prescribed_sum)
            }
            Control::Approach { approach, .. } => approach.si(),
        }
    }

    /// Range of the gap.
    pub(crate) fn gap_range(&self) -> Length {
        Length::from_si(self.reference_bounds.most)
    }

    /// Certificate of a pressure on the finest grid, with the duality gap that the assessment has summed:
    ///
    /// Σ p·(g − λ), or the smaller bound under a limit  `[Duality-1]`
    pub(crate) fn certificate(
        &self,
        pressure: &[f64],
        assessment: &Assessment,
        reference_gap: f64,
    ) -> Certificate {
        cite!("Duality-1");
        let carried: f64 = pressure.iter().sum();
        Certificate {
            duality_gap: assessment.duality_gap,
            penetration: assessment.penetration,
            load_error: self.sum.map_or(0.0, |sum| (carried / sum - 1.0).abs()),
            reference_gap: Length::from_si(reference_gap),
        }
    }
}

/// Points under pressure, or, if there are none, points where the undeformed bodies overlap.
pub(crate) fn touching(gap: &[f64], pressure: &[f64]) -> Vec<usize> {
    fn places(values: &[f64], holds: impl Fn(f64) -> bool) -> Vec<usize> {
        let numbered = values.iter().enumerate();
        numbered
            .filter_map(|(i, &value)| holds(value).then_some(i))
            .collect()
    }
    let loaded = places(pressure, |p| p > 0.0);
    if loaded.is_empty() {
        places(gap, |h| h < 0.0)
    } else {
        loaded
    }
}

/// Displacement by the datum in m per pascal of the sum of all pressures, for cells `width` times as wide
/// as the cells of the problem, in `rows` rows.
fn datum_compliance(
    problem: &ContactProblem,
    width: f64,
    rows: usize,
) -> Result<f64, ContactError> {
    if problem.boundary != Boundary::FreeEnds {
        return Ok(0.0);
    }
    let constant = datum_constant(problem.datum(), problem.spacing * (0.5 * width))?;
    Ok(constant.si() / (PI * problem.modulus.si()) / rows as f64)
}
