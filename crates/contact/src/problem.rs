//! Contact problem, settings of its solver, and solution.

use asperity_core::DomainError;
use asperity_core::numerics::vectorised;
use asperity_core::quantity::{Length, LineEnergy, LineLoad, Pressure};
use serde::{Deserialize, Serialize};

use crate::boundary::Boundary;
use crate::cells::{Cells, Lead};
use crate::certificate::Certificate;
use crate::error::ContactError;

/// Fewest points of a contact problem.
pub const LEAST_POINTS: usize = 2;
/// Largest tolerance accepted. At 1e-2 some pressures are wrong by more than half, and a looser solution
/// takes hardly less time.
pub const MAX_TOLERANCE: f64 = 1e-4;
/// Range of the gap over the range of the deformation above which an outlier in the gap is suspected.
pub const SUSPECT_GAP: f64 = 1e3;

/// Load or approach that presses the bodies together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Control {
    /// Load per metre of face width (periodic: per metre and period).
    Load(LineLoad),
    /// Approach of the bodies; the load follows, and may be zero.
    Approach {
        /// δ in g = h + u − δ.
        approach: Length,
        /// Distance at which the displacement by a cell is zero; more than a quarter of the window.
        /// Ignored for periodic ends.
        datum: Length,
    },
}

/// Two elastic half-planes with a gap between them, pressed together.
#[derive(Debug, Clone, Copy)]
pub struct ContactProblem<'a> {
    /// Undeformed gap h in m at the cell centres, from any datum; may be negative. Of a patch row after row, each along
    /// rolling.
    pub gap: &'a [f64],
    /// Distance of the cell centres along rolling.
    pub spacing: Length,
    /// Rows along the lead; `None` for a line, which is the same at every place along the lead.
    pub lead: Option<Lead>,
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Ends of the window along rolling.
    pub boundary: Boundary,
    /// Load or approach.
    pub control: Control,
    /// Additional pressure in Pa on both bodies, such as a fluid pressure. It deforms them but is not part of
    /// the contact pressure or of the load.
    pub prescribed_pressure: Option<&'a [f64]>,
    /// Pressure at which the softer body flows: the limit of the contact pressure.
    pub pressure_limit: Option<Pressure>,
    /// Pressure in Pa to start from: the solution of a neighbouring problem.
    pub start: Option<&'a [f64]>,
}

/// Tolerance and method of the solver.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, rename_all = "kebab-case", deny_unknown_fields)]
pub struct SolverSettings {
    /// Largest accepted duality gap, penetration and load error; at most [`MAX_TOLERANCE`].
    pub tolerance: f64,
    /// Most iterations on the finest grid.
    pub max_iterations: usize,
    /// Solve coarser grids first, unless a start is given.
    pub cascade: bool,
    /// With free ends, solve only where the bodies are in contact, then certify on the whole grid.
    pub window: bool,
}

impl Default for SolverSettings {
    /// Tolerance 1e-8: the contact set is exact in all of eight rough and smooth reference problems.
    fn default() -> Self {
        Self {
            tolerance: 1e-8,
            max_iterations: 5_000,
            cascade: true,
            window: true,
        }
    }
}

/// A certified solution of a [`ContactProblem`].
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ContactSolution {
    /// Pressure between the solids in Pa.
    pub pressure: Vec<f64>,
    /// Displacement u in m of both bodies together under pressure and prescribed pressure. Zero at
    /// `datum` from each loaded cell; for periodic ends without mean.
    pub displacement: Vec<f64>,
    /// Gap in m after elastic and plastic displacement, not negative except within the tolerance.
    pub gap: Vec<f64>,
    /// Load Σ p·dx, of a patch the mean over the lead, without the prescribed pressure.
    pub load: LineLoad,
    /// δ in g = h + u − δ.
    pub approach: Length,
    /// Datum distance of `displacement` and `approach`; zero for periodic ends, which have no datum.
    pub datum: Length,
    /// Share of the points of the gap with pressure; times the length of the gap over the Hertz width 2b it is the share of
    /// that width.
    pub contact_fraction: f64,
    /// Largest pressure.
    pub max_pressure: Pressure,
    /// Plastic displacement w in m of both bodies together, where the pressure is at its limit.
    pub plastic_displacement: Vec<f64>,
    /// Energy dissipated by the plastic displacement, as all energies and loads per metre of the lead.
    pub dissipated: LineEnergy,
    /// Elastic energy ½ ∫ (p + prescribed)·u dx with u from `displacement`; depends on its datum.
    pub elastic_energy: LineEnergy,
    /// Largest pressure at an end of a window with free ends; zero for periodic ends.
    pub end_pressure: Pressure,
    /// Range of the undeformed gap, including the displacement by a prescribed pressure.
    pub gap_range: Length,
    /// Range of the deformation about the contact: from half a contact width before the first point in
    /// contact to half a contact width behind the last.
    pub deformation: Length,
    /// Iterations on the finest grid.
    pub iterations: usize,
    /// Error bounds of the solution.
    pub certificate: Certificate,
}

/// Warning about a converged solution whose input may be wrong.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub enum ContactWarning {
    /// The contact reaches a free end of the window and would extend beyond it.
    PressureAtEnd {
        /// Largest pressure at an end.
        end_pressure: Pressure,
        /// Largest pressure.
        max_pressure: Pressure,
    },
    /// The range of the gap is more than [`SUSPECT_GAP`] times the deformation, as with an outlier or a
    /// wrong unit.
    GapBeyondDeformation {
        /// Range of the gap.
        gap_range: Length,
        /// Range of the deformation about the contact.
        deformation: Length,
    },
}

impl std::fmt::Display for ContactWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::PressureAtEnd {
                end_pressure,
                max_pressure,
            } => write!(
                f,
                "the contact runs into the end of the window: {end_pressure:.4} there, {max_pressure:.4} at most"
            ),
            Self::GapBeyondDeformation {
                gap_range,
                deformation,
            } => write!(
                f,
                "the gap spans {gap_range:.4} where the bodies deform by {deformation:.4}: an outlier or a wrong unit?"
            ),
        }
    }
}

impl ContactSolution {
    /// Warnings about the solution; usually empty.
    ///
    /// ```
    /// use asperity_contact::{ContactProblem, ContactWarning, SolverSettings, solve};
    /// // The window is narrower than the contact.
    /// let gap: Vec<f64> = (0..100).map(|i| (1e-6 * (f64::from(i) - 49.5)).powi(2) / 6e-3).collect();
    /// let problem = ContactProblem::new(&gap, "1 um".parse()?, "115.4 GPa".parse()?, "300 N/mm".parse()?);
    /// let warnings = solve(&problem, &SolverSettings::default())?.warnings();
    /// assert!(matches!(warnings[..], [ContactWarning::PressureAtEnd { .. }]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn warnings(&self) -> Vec<ContactWarning> {
        let mut warnings = vec![];
        if self.end_pressure.si() > 0.0 {
            warnings.push(ContactWarning::PressureAtEnd {
                end_pressure: self.end_pressure,
                max_pressure: self.max_pressure,
            });
        }
        // Without contact nothing deforms.
        let deforms = self.deformation.si() > 0.0;
        if deforms && self.gap_range.si() > SUSPECT_GAP * self.deformation.si() {
            warnings.push(ContactWarning::GapBeyondDeformation {
                gap_range: self.gap_range,
                deformation: self.deformation,
            });
        }
        warnings
    }
}

impl<'a> ContactProblem<'a> {
    /// Makes the problem of an elastic contact with free ends over `gap` in m under a load. Set other
    /// fields with the struct update syntax.
    ///
    /// ```
    /// use asperity_contact::{ContactProblem, SolverSettings, solve};
    /// let gap: Vec<f64> = (0..1000).map(|i| (0.6e-6 * (f64::from(i) - 499.5)).powi(2) / 6e-3).collect();
    /// let elastic = ContactProblem::new(&gap, "0.6 um".parse()?, "115.4 GPa".parse()?, "300 N/mm".parse()?);
    /// let flowing = ContactProblem { pressure_limit: Some("1.5 GPa".parse()?), ..elastic };
    /// let [elastic, flowing] = [elastic, flowing].map(|problem| solve(&problem, &SolverSettings::default()));
    /// assert!(flowing?.contact_fraction > elastic?.contact_fraction);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(gap: &'a [f64], spacing: Length, modulus: Pressure, load: LineLoad) -> Self {
        Self {
            gap,
            spacing,
            modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Load(load),
            lead: None,
            prescribed_pressure: None,
            pressure_limit: None,
            start: None,
        }
    }
}

impl ContactProblem<'_> {
    /// Length of the window along rolling, including half a cell beyond the first and the last point.
    pub fn window_length(&self) -> Length {
        let rows = self.lead.map_or(1, |lead| lead.rows.max(1));
        self.spacing * (self.gap.len() / rows) as f64
    }

    /// Cells of the window of a valid problem; a line is one row.
    pub(crate) fn cells(&self) -> Result<Cells, ContactError> {
        Cells::new(self.gap.len(), self.spacing, self.lead)
    }

    /// Datum distance of the solution: the one of a controlled approach, or twice the window.
    pub(crate) fn datum(&self) -> Length {
        match (self.boundary, self.control) {
            (Boundary::Periodic(_), _) => Length::from_si(0.0),
            (Boundary::FreeEnds, Control::Approach { datum, .. }) => datum,
            (Boundary::FreeEnds, Control::Load(_)) => self.window_length() * 2.0,
        }
    }

    /// Checks the problem.
    pub(crate) fn validate(&self) -> Result<(), ContactError> {
        let points = self.gap.len();
        let columns = self.cells()?.columns;
        if columns < LEAST_POINTS {
            return Err(ContactError::too_few_points(columns, LEAST_POINTS));
        }
        DomainError::positive("reduced modulus", self.modulus)?;
        check_elements(
            "gap",
            self.gap,
            points,
            "m",
            f64::is_finite,
            "must be finite",
        )?;
        if let Some(prescribed) = self.prescribed_pressure {
            let name = "prescribed pressure";
            check_elements(
                name,
                prescribed,
                points,
                "Pa",
                f64::is_finite,
                "must be finite",
            )?;
        }
        if let Some(start) = self.start {
            let rule = "must be finite and not negative";
            let holds = |p: f64| p.is_finite() & (p >= 0.0);
            check_elements("start", start, points, "Pa", holds, rule)?;
        }
        if let Some(limit) = self.pressure_limit {
            DomainError::positive("pressure limit", limit)?;
        }
        self.validate_control()
    }

    fn validate_control(&self) -> Result<(), ContactError> {
        let length = self.window_length();
        match self.control {
            Control::Load(load) => {
                DomainError::positive("load", load)?;
                let Some(limit) = self.pressure_limit else {
                    return Ok(());
                };
                let capacity = LineLoad::from_si(limit.si() * length.si());
                if capacity <= load {
                    return Err(ContactError::LimitBelowMeanPressure {
                        limit,
                        capacity,
                        load,
                    });
                }
                Ok(())
            }
            Control::Approach { approach, datum } => self.validate_approach(approach, datum),
        }
    }

    fn validate_approach(&self, approach: Length, datum: Length) -> Result<(), ContactError> {
        DomainError::finite("approach", approach)?;
        if self.boundary == Boundary::FreeEnds {
            DomainError::positive("datum distance", datum)?;
            let least = self.window_length() * LEAST_DATUM;
            if datum <= least {
                return Err(ContactError::datum_too_near(datum, least));
            }
            return Ok(());
        }
        // Displacements of a period have no mean, so the mean gap depends only on the approach.
        let mean_gap = Length::from_si(self.gap.iter().sum::<f64>() / self.gap.len() as f64);
        if approach >= mean_gap {
            return Err(ContactError::approach_beyond_mean_gap(approach, mean_gap));
        }
        Ok(())
    }
}

/// Datum distance over window length above which the displacement matrix is positive definite:
/// the logarithmic capacity of an interval is a quarter of its length.
pub const LEAST_DATUM: f64 = 0.25;

fn check_elements(
    name: &'static str,
    values: &[f64],
    need: usize,
    unit: &'static str,
    holds: impl Fn(f64) -> bool,
    rule: &'static str,
) -> Result<(), ContactError> {
    if values.len() != need {
        return Err(ContactError::WrongLength {
            name,
            need,
            got: values.len(),
        });
    }
    // All are looked at, in lanes of one vector, before the first bad one is sought.
    let all_hold = vectorised(
        #[inline(always)]
        || values.iter().fold(true, |all, &value| all & holds(value)),
    );
    if all_hold {
        return Ok(());
    }
    match values.iter().position(|&value| !holds(value)) {
        None => Ok(()),
        Some(index) => Err(ContactError::BadElement {
            name,
            index,
            value: values[index],
            unit,
            rule,
        }),
    }
}
