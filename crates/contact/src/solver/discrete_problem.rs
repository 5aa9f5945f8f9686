//! Discrete contact problem of the iteration, on its own grid and on coarser ones.

use std::borrow::Cow;
use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::quantity::{Length, LineEnergy, Pressure};

use super::cascadic_multigrid::Window;
use super::workspace::{Assessment, ReferenceBounds, Task};
use crate::boundary::Boundary;
use crate::certificate::Certificate;
use crate::error::ContactError;
use crate::half_plane::cell_compliance;
use crate::problem::{ContactProblem, Control, SolverSettings};
use crate::strip_kernel::datum_constant;

/// Tolerances of the coarser grids, which only give a start. With free ends the finest grid is
/// solved on a window and quickly; a large periodic one is worth a better start, and so is a smooth
/// contact, which takes few iterations to it.
const COARSE_TOLERANCE_FREE: f64 = 1e-4;
const COARSE_TOLERANCE_FINE: f64 = 1e-6;
/// Certificate of a coarser grid over that of its start: the next grid halves the cells, and the start of a rough
/// contact is hardly better for more (0.1 costs a tenth of a solution on 10⁵ points), that of a smooth one is.
const GAIN: f64 = 0.5;
const SMOOTH_GAIN: f64 = 0.02;
/// Tolerance asked of a window over that promised: near round-off its certificate and that of the
/// whole grid differ in a few digits.
const ROOM: f64 = 0.9;
/// Bodies whose gap varies less than this beside their deformation count as flat: their reference
/// gap is this share of the deformation.
const FLAT: f64 = 1e-3;

/// Data that all grids of a problem share.
pub(crate) struct DiscreteProblem<'a> {
    pub(crate) problem: &'a ContactProblem<'a>,
    /// h with the displacement by the prescribed pressure, minus a controlled approach in m.
    pub(crate) gap: Cow<'a, [f64]>,
    reference_bounds: ReferenceBounds,
    /// Σp in Pa when the load is controlled.
    sum: Option<f64>,
    limit: f64,
    compliance: f64,
    /// Displacement per Σp by the datum in m/Pa.
    datum: f64,
    /// Σ of the prescribed pressure in Pa.
    prescribed_sum: f64,
}

impl<'a> DiscreteProblem<'a> {
    /// The discrete form of a valid problem; `displace` is the displacement in m by a pressure for a
    /// compliance.
    pub(crate) fn new<'b>(
        problem: &'a ContactProblem<'a>,
        displace: impl FnOnce(&[f64], f64) -> &'b mut [f64],
    ) -> Result<Self, ContactError> {
        let compliance = cell_compliance(problem.spacing, problem.modulus)?;
        let datum = datum_compliance(problem, 1.0)?;
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
                sum = Some(load.si() / problem.spacing.si());
                deformation = load.si() / (PI * problem.modulus.si());
            }
            Control::Approach { approach, .. } => {
                for h in gap.to_mut() {
                    *h += datum * prescribed_sum - approach.si();
                    deformation = f64::max(deformation, -*h);
                }
            }
        }
        let least = gap.iter().copied().fold(f64::INFINITY, f64::min);
        let most = gap.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Ok(Self {
            problem,
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

    /// The problem on a part of the finest grid.
    pub(crate) fn task(
        &self,
        window: Window,
        settings: &SolverSettings,
        max_iterations: usize,
    ) -> Task<'_> {
        Task {
            gap: &self.gap[window.range()],
            sum: self.sum,
            limit: self.limit,
            compliance: self.compliance,
            datum: self.datum,
            reference_gap: self.reference_bounds.most.max(self.reference_bounds.least),
            reference_bounds: self.reference_bounds,
            tolerance: ROOM * settings.tolerance,
            least_tolerance: ROOM * settings.tolerance,
            gain: GAIN,
            max_iterations,
        }
    }

    /// The problem on the grid of this `gap`, after so many halvings, of a contact that is `smooth`
    /// or not.
    pub(crate) fn coarse_task<'b>(
        &self,
        gap: &'b [f64],
        halvings: i32,
        smooth: bool,
        settings: &SolverSettings,
    ) -> Result<Task<'b>, ContactError> {
        let width = 2f64.powi(halvings);
        let coarse = match self.problem.boundary {
            Boundary::FreeEnds if !smooth => COARSE_TOLERANCE_FREE,
            _ => COARSE_TOLERANCE_FINE,
        };
        Ok(Task {
            gap,
            sum: self.sum.map(|sum| sum / width),
            limit: self.limit,
            compliance: self.compliance * width,
            datum: datum_compliance(self.problem, width)?,
            reference_gap: self.reference_bounds.most.max(self.reference_bounds.least),
            reference_bounds: self.reference_bounds,
            tolerance: settings.tolerance.max(coarse),
            least_tolerance: settings.tolerance,
            gain: if smooth { SMOOTH_GAIN } else { GAIN },
            max_iterations: settings.max_iterations,
        })
    }

    /// The start of the problem, scaled to its load; none when it carries nothing.
    pub(crate) fn given_start(&self) -> Option<Vec<f64>> {
        let start = self.problem.start?;
        let carried: f64 = start.iter().sum();
        let scale = self.sum.map_or(1.0, |sum| sum / carried);
        (carried > 0.0).then(|| start.iter().map(|p| p * scale).collect())
    }

    /// The load spread evenly; no pressure when the approach is controlled.
    pub(crate) fn even_pressure(&self) -> f64 {
        self.sum.map_or(0.0, |sum| sum / self.gap.len() as f64)
    }

    /// ½ ∫ (p + prescribed)·u dx
    pub(crate) fn elastic_energy(&self, pressure: &[f64], displacement: &[f64]) -> LineEnergy {
        let prescribed = |cell: usize| self.problem.prescribed_pressure.map_or(0.0, |p| p[cell]);
        let work: f64 = (0..pressure.len())
            .map(|i| (pressure[i] + prescribed(i)) * displacement[i])
            .sum();
        LineEnergy::from_si(0.5 * work * self.problem.spacing.si())
    }

    /// δ in m from the datum of the problem, from the α of the iteration, which has none.
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

    /// Certificate of a pressure on the finest grid; its duality gap as the assessment has summed it:
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

/// The points under pressure, or, when there are none, those where the undeformed bodies overlap.
pub(crate) fn touching(gap: &[f64], pressure: &[f64]) -> Vec<usize> {
    let find = |holds: &dyn Fn(usize) -> bool| (0..gap.len()).filter(|&i| holds(i)).collect();
    let loaded: Vec<usize> = find(&|i| pressure[i] > 0.0);
    if loaded.is_empty() {
        find(&|i| gap[i] < 0.0)
    } else {
        loaded
    }
}

/// Displacement in m that the datum adds per pascal of the sum of all pressures, for cells `width`
/// times as wide as those of the problem.
fn datum_compliance(problem: &ContactProblem, width: f64) -> Result<f64, ContactError> {
    if problem.boundary != Boundary::FreeEnds {
        return Ok(0.0);
    }
    let constant = datum_constant(problem.datum(), problem.spacing * (0.5 * width))?;
    Ok(constant.si() / (PI * problem.modulus.si()))
}
