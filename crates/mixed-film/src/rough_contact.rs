//! Rough contact of two flanks under the pressure of the film between them.
//!
//! The film carries 1 − φ of the load as that share of the Hertz pressure and deforms both flanks; the
//! asperities carry φ on the roughness as it is outside the contact, up to the flow pressure.

use std::cell::RefCell;
use std::sync::Arc;

use asperity_contact::dense_reference::FixedSets;
use asperity_contact::hertz_line::HertzLine;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, Lead, Solver, SolverSettings,
};
use asperity_core::numerics::Lanes;
use asperity_core::quantity::{Length, LineEnergy, LineLoad, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::LoadShareError;
use crate::spot_tree::{BySpot, Spot, SpotGrid, pressure_gradient, spot_of_cells, spots_of};
use crate::window_gap::middle_weights;

/// Share of the Hertz half width over which the gap is averaged and the film between rough flanks is evaluated.
pub(crate) const CORE: f64 = 0.8;
/// Least flow pressure over the Hertz pressure.
const LEAST_FLOW_PRESSURE: f64 = 1.5;
/// Starts are kept this far below the pressure limit, so that no cell begins fixed.
const BELOW_LIMIT: f64 = 0.999;

/// Inputs of a rough contact.
#[derive(Debug, Clone, Copy)]
pub struct RoughWindow<'a> {
    /// Heights z₁ + z₂ of the composite window \[m\], the contact in its middle; not attenuated.
    pub composite: &'a [f64],
    /// Distance of the points.
    pub spacing: Length,
    /// Load per length of contact line w.
    pub load: LineLoad,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Pressure at which the softer flank flows.
    pub flow_pressure: Pressure,
    /// Settings of the contact solver.
    pub settings: SolverSettings,
}

/// Inputs of the rough contact of a patch: a window with an extent along the lead, over which it is periodic.
#[derive(Debug, Clone, Copy)]
pub struct PatchWindow<'a> {
    /// Heights z₁ + z₂ of the composite window \[m\], row after row, the contact in the middle of each; not attenuated.
    pub composite: &'a [f64],
    /// Points along rolling.
    pub columns: usize,
    /// Points along the lead; a window with one row is a line.
    pub rows: usize,
    /// Distances of the columns and of the rows.
    pub spacings: [Length; 2],
    /// Mean load per length of contact line w.
    pub load: LineLoad,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Pressure at which the softer flank flows.
    pub flow_pressure: Pressure,
    /// Settings of the contact solver.
    pub settings: SolverSettings,
}

impl<'a> From<&RoughWindow<'a>> for PatchWindow<'a> {
    fn from(line: &RoughWindow<'a>) -> Self {
        Self {
            composite: line.composite,
            columns: line.composite.len(),
            rows: 1,
            spacings: [line.spacing; 2],
            load: line.load,
            radius: line.radius,
            modulus: line.modulus,
            flow_pressure: line.flow_pressure,
            settings: line.settings,
        }
    }
}

/// The contact at one asperity share.
#[derive(Debug, Clone)]
pub struct ContactState {
    /// Asperity share φ.
    pub asperity_share: f64,
    /// Mean gap over the middle 0.8 of the Hertz contact.
    pub mean_gap: Length,
    /// Touching spots, from one end of the window to the other, of a patch row after row.
    pub spots: Vec<Spot>,
    /// Share of the points within the Hertz contact that touch.
    pub area: f64,
    /// Largest sum of asperity and film pressure.
    pub max_pressure: Pressure,
    /// Energy dissipated by plastic flow in one pass over this window.
    pub dissipated: LineEnergy,
    /// The contact itself; its displacement leaves out that by the film.
    pub solution: ContactSolution,
}

/// Pressures of the touching cells of a window.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SparsePressure {
    cells: Vec<u32>,
    /// \[Pa\]
    pressure: Vec<f64>,
}

impl SparsePressure {
    pub(crate) fn from_pressure(pressure: &[f64]) -> Self {
        let touching = (0u32..).zip(pressure).filter(|(_, p)| **p > 0.0);
        let (cells, pressure) = touching.unzip();
        Self { cells, pressure }
    }

    fn on(&self, points: usize) -> Vec<f64> {
        let mut all = vec![0.0; points];
        for (cell, p) in self.cells.iter().zip(&self.pressure) {
            all[*cell as usize] = *p;
        }
        all
    }
}

/// A window of two rough flanks along a line or over a patch, to be solved at any asperity share.
///
/// Keeps the last pressure as the start of the next share.
pub struct RoughContact {
    /// Undeformed gap x²/2R − z \[m\].
    undeformed: Vec<f64>,
    smooth: Arc<SmoothContact>,
    gap: Vec<f64>,
    last: Option<(f64, Vec<f64>)>,
    solver: Solver,
    grid: SpotGrid,
    load: f64,
    modulus: Pressure,
    flow_pressure: f64,
    settings: SolverSettings,
    is_exact: bool,
}

/// The contact of smooth flanks on the columns of a window, which all windows of a position share.
struct SmoothContact {
    /// Number of cells, and bits of spacing, load, radius and modulus.
    of: (usize, [u64; 4]),
    /// Hertz pressure of the cells, scaled to the load \[Pa\].
    hertz: Vec<f64>,
    /// Displacement by it \[m\].
    displacement: Vec<f64>,
    /// First column over which the gap is averaged, and the weight of each column from there on.
    core: (usize, Vec<f64>),
    /// Columns of the Hertz contact.
    inside: std::ops::Range<usize>,
    max_hertz: f64,
}

thread_local! {
    /// The smooth contact that was made last: the windows of a position are made one after the other.
    static LAST: RefCell<Option<Arc<SmoothContact>>> = const { RefCell::new(None) };
}

impl SmoothContact {
    /// The contact in the middle of `window`, whose numbers are valid; made by the thread before, if it was the last one.
    fn new(window: &PatchWindow<'_>, solver: &mut Solver) -> Result<Arc<Self>, LoadShareError> {
        let n = window.columns;
        let (dx, w, r) = (
            window.spacings[0].si(),
            window.load.si(),
            window.radius.si(),
        );
        let of = (n, [dx, w, r, window.modulus.si()].map(f64::to_bits));
        if let Some(last) = LAST.with_borrow(|last| last.clone().filter(|last| last.of == of)) {
            return Ok(last);
        }
        let a = HertzLine::new(window.load, window.radius, window.modulus)?
            .half_width
            .si();
        let place = |i: usize| place(i, n, dx);
        // Means over the cells: of their middles the pressure would turn steeply where the contact grows by a cell.
        let below = |x: f64| {
            let x = (x / a).clamp(-1.0, 1.0);
            0.5 * (x * (1.0 - x * x).sqrt() + x.asin())
        };
        let mean = |i: usize| below(place(i) + 0.5 * dx) - below(place(i) - 0.5 * dx);
        let mut hertz: Vec<f64> = (0..n).map(mean).collect();
        let scale = w / (hertz.iter().sum::<f64>() * dx);
        for p in &mut hertz {
            *p *= scale;
        }
        let mut displacement = vec![0.0; n];
        let (spacing, modulus) = (window.spacings[0], window.modulus);
        match window.rows {
            1 => solver.displacement(spacing, None, modulus, &hertz, &mut displacement)?,
            _ => {
                let mut line = Solver::new(n, Boundary::FreeEnds)?;
                line.displacement(spacing, None, modulus, &hertz, &mut displacement)?;
            }
        }
        let first = (0..n).find(|&i| place(i).abs() < a).unwrap_or(0);
        let count = (first..n).take_while(|&i| place(i).abs() < a).count();
        let core: Vec<(usize, f64)> = middle_weights(n, CORE * a / dx).collect();
        let made = Arc::new(Self {
            of,
            max_hertz: hertz.iter().fold(0.0, |m: f64, &p| m.max(p)),
            hertz,
            displacement,
            core: (
                core.first().map_or(0, |(i, _)| *i),
                core.iter().map(|(_, weight)| *weight).collect(),
            ),
            inside: first..first + count,
        });
        LAST.set(Some(made.clone()));
        Ok(made)
    }
}

/// Place of cell `i` of `n`, `dx` apart, from the middle of the window.
fn place(i: usize, n: usize, dx: f64) -> f64 {
    i as f64 * dx - 0.5 * (n as f64 - 1.0) * dx
}

impl RoughContact {
    /// The contact of a window.
    ///
    /// # Errors
    /// When a height is not finite, load, radius, modulus or spacing not positive, the window does not hold
    /// the Hertz contact, or the flow pressure is below one and a half times the Hertz pressure.
    pub fn new(window: &RoughWindow<'_>) -> Result<Self, LoadShareError> {
        Self::of_patch(&window.into())
    }

    /// The contact of a patch, pressed together by the mean load.
    ///
    /// # Errors
    /// As [`new`](Self::new), and when the heights are not rows of columns.
    pub fn of_patch(window: &PatchWindow<'_>) -> Result<Self, LoadShareError> {
        let w = DomainError::positive("line load", window.load)?;
        let r = DomainError::positive("radius", window.radius)?;
        let dx = DomainError::positive("spacing", window.spacings[0])?;
        DomainError::positive("spacing along the lead", window.spacings[1])?;
        let flow = DomainError::positive("flow pressure", window.flow_pressure)?;
        let line = HertzLine::new(window.load, window.radius, window.modulus)?;
        let (n, rows) = (window.columns, window.rows);
        let points = window.composite.len();
        let rule = "must be the number of rows times the number of columns";
        let is_patch = rows > 0 && points == n * rows;
        DomainError::require(is_patch, "number of heights", points as f64, "-", rule)?;
        let reach = 0.5 * (n as f64 - 1.0) * dx;
        let rule = "must be longer than the Hertz contact is wide";
        let fits = reach > line.half_width.si();
        DomainError::require(fits, "half the window", reach, "m", rule)?;
        for &z in window.composite {
            DomainError::finite("height", Length::from_si(z))?;
        }
        let mut solver = Solver::of_patch([n, rows], Boundary::FreeEnds)?;
        let smooth = SmoothContact::new(window, &mut solver)?;
        let least = LEAST_FLOW_PRESSURE * smooth.max_hertz;
        if flow < least {
            return Err(LoadShareError::FlowPressureTooLow {
                flow_pressure: window.flow_pressure,
                least: Pressure::from_si(least),
            });
        }
        let heights = window.composite.iter().enumerate();
        Ok(Self {
            undeformed: heights
                .map(|(i, z)| place(i % n, n, dx).powi(2) / (2.0 * r) - z)
                .collect(),
            smooth,
            gap: vec![0.0; points],
            last: None,
            solver,
            grid: SpotGrid {
                columns: n,
                rows,
                spacings: window.spacings,
            },
            load: w,
            modulus: window.modulus,
            flow_pressure: flow,
            settings: window.settings,
            is_exact: false,
        })
    }

    /// Solves every contact to its exact sets, with `exact`: the error of the pressures is then round-off.
    #[must_use]
    pub fn exactly(self, exact: bool) -> Self {
        Self {
            is_exact: exact,
            ..self
        }
    }

    /// Lets the next solution start from coarser grids instead of the last pressure.
    pub(crate) fn start_anew(&mut self) {
        self.last = None;
    }

    /// Lets the next solution start from the pressure at an asperity share.
    pub(crate) fn start_from(&mut self, asperity_share: f64, pressure: &SparsePressure) {
        self.last = Some((asperity_share, pressure.on(self.points())));
    }

    /// Mean gap where the flanks, deformed by the whole film pressure, first touch anywhere in the window.
    #[must_use]
    pub fn first_touch_gap(&self) -> Length {
        let gap = |i: usize| self.smooth_gap(i);
        let least = (0..self.undeformed.len())
            .map(gap)
            .fold(f64::INFINITY, f64::min);
        Length::from_si(
            self.core()
                .map(|(i, weight)| weight * (gap(i) - least))
                .sum(),
        )
    }

    /// Gap at a point under the whole film pressure \[m\].
    fn smooth_gap(&self, point: usize) -> f64 {
        self.undeformed[point] + self.smooth.displacement[point % self.grid.columns]
    }

    /// Points of some columns, row after row.
    fn within(&self, columns: &std::ops::Range<usize>) -> impl Iterator<Item = usize> + use<> {
        let (all, columns) = (self.grid.columns, columns.clone());
        let rows = (0..self.grid.rows).map(move |row| row * all);
        rows.flat_map(move |first| first + columns.start..first + columns.end)
    }

    /// Points over which the gap is averaged, with their weights in the mean.
    fn core(&self) -> impl Iterator<Item = (usize, f64)> {
        let (first, weights) = &self.smooth.core;
        let SpotGrid { columns, rows, .. } = self.grid;
        let starts = (0..rows).map(move |row| row * columns + first);
        starts.flat_map(move |start| {
            let weights = weights.iter().zip(start..);
            weights.map(move |(weight, i)| (i, weight / rows as f64))
        })
    }

    /// The contact at one asperity share.
    ///
    /// ```text
    /// film pressure (1 − φ) p_Hertz,  ∫ p_a dx = φ w,  0 ≤ p_a ≤ p_flow − (1 − φ) p₀     [Share-contact]
    /// ```
    ///
    /// # Errors
    /// When the share is not above 0 and at most 1, or the contact does not converge.
    pub fn at(&mut self, asperity_share: f64) -> Result<ContactState, LoadShareError> {
        cite!("Share-contact");
        let phi = asperity_share;
        let rule = "must be above 0 and not above 1";
        DomainError::require(phi > 0.0 && phi <= 1.0, "asperity share", phi, "-", rule)?;
        let limit = self.limit(phi).si();
        let start = self.last.take().map(|(before, mut pressure)| {
            let scale = phi / before;
            for p in &mut pressure {
                *p = (*p * scale).min(BELOW_LIMIT * limit);
            }
            pressure
        });
        let is_exact = self.is_exact;
        let solution = self.pressed(phi, |solver, problem, settings| {
            let problem = ContactProblem {
                start: start.as_deref(),
                ..*problem
            };
            if is_exact {
                solver.solve_exactly(&problem, settings)
            } else {
                solver.solve(&problem, settings)
            }
        })?;
        self.last = Some((phi, solution.pressure.clone()));
        Ok(self.state(phi, solution))
    }

    /// The contact at one asperity share, whose pressures are known.
    ///
    /// # Errors
    /// When they are not those of the contact.
    pub(crate) fn known(
        &mut self,
        asperity_share: f64,
        pressure: &SparsePressure,
    ) -> Result<ContactState, LoadShareError> {
        cite!("Share-contact");
        let all = pressure.on(self.points());
        let solution = self.pressed(asperity_share, |solver, problem, settings| {
            solver.solved_by(problem, settings, &all, 0)
        })?;
        Ok(self.state(asperity_share, solution))
    }

    /// Largest pressure of the asperities at an asperity share.
    fn limit(&self, asperity_share: f64) -> Pressure {
        let film = (1.0 - asperity_share) * self.smooth.max_hertz;
        Pressure::from_si(self.flow_pressure - film)
    }

    /// The problem at one asperity share, solved by `solve`.
    fn pressed(
        &mut self,
        phi: f64,
        solve: impl FnOnce(
            &mut Solver,
            &ContactProblem<'_>,
            &SolverSettings,
        ) -> Result<ContactSolution, ContactError>,
    ) -> Result<ContactSolution, LoadShareError> {
        let fluid = 1.0 - phi;
        let limit = self.limit(phi);
        let columns = self.grid.columns;
        let rows = self.undeformed.chunks_exact(columns);
        for (gap, undeformed) in self.gap.chunks_exact_mut(columns).zip(rows) {
            let parts = undeformed.iter().zip(&self.smooth.displacement);
            for (gap, (h, u)) in gap.iter_mut().zip(parts) {
                *gap = h + fluid * u;
            }
        }
        let problem = ContactProblem {
            lead: self.lead(),
            pressure_limit: Some(limit),
            ..ContactProblem::new(
                &self.gap,
                self.grid.spacings[0],
                self.modulus,
                LineLoad::from_si(phi * self.load),
            )
        };
        Ok(solve(&mut self.solver, &problem, &self.settings)?)
    }

    /// Rows of a patch.
    fn lead(&self) -> Option<Lead> {
        let SpotGrid { rows, spacings, .. } = self.grid;
        (rows > 1).then_some(Lead {
            rows,
            spacing: spacings[1],
        })
    }

    fn state(&self, phi: f64, solution: ContactSolution) -> ContactState {
        let core = self.core();
        let core = core.map(|(i, weight)| weight * solution.gap[i].max(0.0));
        let inside = &self.smooth.inside;
        let touching = self.within(inside).filter(|&i| solution.pressure[i] > 0.0);
        let mut highest = Lanes::new([0.0]);
        for row in solution.pressure.chunks_exact(self.grid.columns) {
            highest.fold([row, &self.smooth.hertz], |[most], [p, h]| {
                let both = p + (1.0 - phi) * h;
                [if both > most { both } else { most }]
            });
        }
        let [highest] = highest.reduce(|a, b| [a[0].max(b[0])]);
        ContactState {
            asperity_share: phi,
            mean_gap: Length::from_si(core.sum()),
            spots: spots_of(&solution.pressure, &self.grid),
            area: touching.count() as f64 / (inside.len() * self.grid.rows) as f64,
            max_pressure: Pressure::from_si(highest),
            dissipated: solution.dissipated,
            solution,
        }
    }

    /// The spot of each point of a contact, a place in [`ContactState::spots`]; `None` where the flanks stay apart.
    #[must_use]
    pub fn spot_of_points(&self, state: &ContactState) -> Vec<Option<u32>> {
        spot_of_cells(&state.solution.pressure, &self.grid)
    }

    /// Points of the window.
    #[must_use]
    pub fn points(&self) -> usize {
        self.undeformed.len()
    }

    /// Derivative of a number J over the heights of the composite window, with the sets of the contact `state` held.
    /// `by_gap` is ∂J/∂(mean gap), `by_spots` those over the spots.
    ///
    /// ```text
    /// ∂J/∂p_i = Σ_k (∂J/∂f_k ∂f_k/∂p_i + ∂J/∂F_k ∂F_k/∂p_i + ∂J/∂b_k ∂b_k/∂p_i) + ∂J/∂g Σ_j v_j A_ji
    /// ∂J/∂z = −∂J/∂h,  ∂J/∂h_j = v_j ∂J/∂g outside of the contact              [Share-contact-gradient]
    /// ```
    ///
    /// j are the points of the middle 0.8 of the Hertz contact that stay apart, v_j are their weights in the mean gap: the cells at
    /// its ends count with the part that lies within it.
    ///
    /// # Errors
    /// When the contact has too many touching points, or is one of a patch.
    pub(crate) fn height_gradient(
        &mut self,
        state: &ContactState,
        by_gap: f64,
        by_spots: &[BySpot],
    ) -> Result<Vec<f64>, LoadShareError> {
        cite!("Share-contact-gradient");
        let rows = self.grid.rows;
        let rule = "must be one: only a line has this gradient";
        DomainError::require(rows == 1, "rows", rows as f64, "-", rule)?;
        let pressure = &state.solution.pressure;
        let problem = ContactProblem {
            pressure_limit: Some(self.limit(state.asperity_share)),
            ..ContactProblem::new(
                &self.undeformed,
                self.grid.spacings[0],
                self.modulus,
                LineLoad::from_si(state.asperity_share * self.load),
            )
        };
        let sets = FixedSets::new(&problem, pressure)?;
        let mut apart = vec![0.0; pressure.len()];
        for (i, weight) in self.core() {
            if pressure[i] == 0.0 && state.solution.gap[i] > 0.0 {
                apart[i] = by_gap * weight;
            }
        }
        let by_approach: f64 = -apart.iter().sum::<f64>();
        let mut by_pressure = vec![0.0; pressure.len()];
        let spacing = self.grid.spacings[0];
        self.solver
            .displacement(spacing, None, self.modulus, &apart, &mut by_pressure)?;
        let of_spots = pressure_gradient(pressure, self.grid.spacings[0], by_spots.iter());
        for (sum, of_cell) in by_pressure.iter_mut().zip(of_spots) {
            *sum += of_cell;
        }
        let through_contact = sets.gap_gradient(&by_pressure, by_approach);
        let both = apart.iter().zip(&through_contact);
        Ok(both.map(|(direct, by_gap)| -direct - by_gap).collect())
    }

    /// Derivative of `by_gap` times the mean gap of first touch over the heights of the composite window.
    pub(crate) fn first_touch_gradient(&self, by_gap: f64) -> Vec<f64> {
        let gap = |i: usize| self.smooth_gap(i);
        let mut gradient = vec![0.0; self.undeformed.len()];
        for (i, weight) in self.core() {
            gradient[i] -= by_gap * weight;
        }
        let first = (0..gradient.len()).min_by(|i, j| gap(*i).total_cmp(&gap(*j)));
        if let Some(first) = first {
            gradient[first] += by_gap;
        }
        gradient
    }
}
