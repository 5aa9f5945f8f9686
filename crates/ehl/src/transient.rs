//! Transient contact of two rough surfaces, recorded: load against film, films, pressures, friction.
//!
//! Three boundary films have three names: `contact_film` is the thickness at which a node counts as in
//! contact, `solid_film` the film below which load counts as carried by solids, and `boundary_layer`
//! (of the friction law) the layer over which boundary friction fades. Load on contact nodes does not
//! converge with the grid and is not a result; load on films below 20 and 50 nm, the mean film and friction
//! converge. The first three half-widths of travel are a start-up.

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::batch_means::{BatchMeans, RecordMean};
use crate::dimensionless::{LineContact, Scales};
use crate::error::EhlError;
use crate::evidence::{Evidence, Solved};
use crate::fluid::Fluid;
use crate::friction::{BoundaryFilms, Friction, FrictionLaw, ShearedNode, THINNEST};
use crate::heated_friction::{HeatHistory, HeatedNode, RecordHeat};
use crate::moving_profile::MovingProfile;
use crate::newton::{Ceiling, Limits, NodeState};
use crate::oil::Oil;
use crate::steady::{self, Window, check_cells, solve_sequence};
use crate::stepper::{StepSettings, Stepper};

/// Default films of the load-against-film distribution \[m\].
const FILMS: [f64; 6] = [5e-9, 1e-8, 2e-8, 5e-8, 1e-7, 2e-7];

/// Limits of a time step.
const STEP_LIMITS: Limits = Limits {
    // The error after a step of this size is its square, below 1e-6: less than the error of the time step.
    tolerance: 5e-4,
    linear_tolerance: 1e-3,
    loosest: 1e-3,
    largest_change: 1.0,
    iterations: 40,
    flips: 0,
    load: 1e-6,
};

/// Limits of the smooth start: tight, so that the film of smooth surfaces stays constant over the steps.
const START_LIMITS: Limits = Limits {
    tolerance: 1e-8,
    linear_tolerance: 1e-6,
    loosest: 1e-3,
    ..steady::LIMITS
};

/// Two rough surfaces in lubricated line contact.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughContact {
    /// Bodies, load and speeds.
    pub contact: LineContact,
    /// Oil at the temperature of the inlet.
    pub oil: Oil,
    /// Surface that moves at u₁.
    pub surface_1: MovingProfile,
    /// Surface that moves at u₂.
    pub surface_2: MovingProfile,
}

/// Pressure at which the surfaces yield.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticCeiling {
    /// Flow pressure, about 2.8 times the yield strength.
    pub pressure: Pressure,
}

/// Grid, length and outputs of a record.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordSettings {
    /// Cells of the even grid, a multiple of 64; at least 8 a shortest wave of the profiles.
    pub cells: usize,
    /// Ends of the film.
    pub window: Window,
    /// Film at which a node counts as in contact.
    pub contact_film: Length,
    /// Film thickness below which load counts as carried by the solids.
    pub solid_film: Length,
    /// Travel before the record begins, in half-widths.
    pub start: f64,
    /// Travel of the record, in half-widths.
    pub length: f64,
    /// Standard error of the solid share to reach, and the longest record allowed for it.
    pub until: Option<(f64, f64)>,
    /// Travel over which periodic surfaces rise from smooth, in half-widths.
    pub ramp: f64,
    /// Longest time step in cells of travel.
    pub courant: f64,
    /// Yield of the surfaces.
    pub ceiling: Option<PlasticCeiling>,
    /// Films of the load-against-film distribution.
    pub films: Vec<Length>,
    /// Law of friction.
    pub friction: Option<FrictionLaw>,
    /// Heat of film and surfaces in the friction, which needs its law.
    pub heat: Option<RecordHeat>,
    /// Whether every step goes into the history.
    pub history: bool,
    /// Travel between frames of the whole film, in half-widths.
    pub frame_interval: Option<f64>,
}

impl Default for RecordSettings {
    fn default() -> Self {
        Self {
            cells: 512,
            window: Window::ROUGH,
            contact_film: Length::from_si(5e-9),
            solid_film: Length::from_si(2e-8),
            start: 3.0,
            length: 20.0,
            until: None,
            ramp: 1.0,
            courant: 1.0,
            ceiling: None,
            films: FILMS.map(Length::from_si).to_vec(),
            friction: None,
            heat: None,
            history: false,
            frame_interval: None,
        }
    }
}

/// Share of the load carried at films no thicker than a given one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadBelow {
    /// The film.
    pub film: Length,
    /// Share of the load at films no thicker than this.
    pub share: RecordMean,
}

/// Friction over the load, averaged over a record.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MeanFriction {
    /// Film friction everywhere.
    pub film: RecordMean,
    /// Boundary friction with the weight min(1, e^(−(h − H_b)/h_b)): the friction of the record.
    pub shifted: RecordMean,
    /// Boundary friction with the weight e^(−h/h_b), stored for comparison with older records only.
    pub graded: RecordMean,
    /// Boundary friction below the solid film.
    pub stepped: RecordMean,
    /// Share of the load on the boundary layer, with the weight of the shifted friction.
    pub boundary_share: RecordMean,
}

/// Friction with the heat of film and surfaces, and its temperatures.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct HeatedFriction {
    /// Friction over the load.
    pub friction: MeanFriction,
    /// Rise of the mean temperature of the film over the bulk, weighted with the pressure \[K\].
    pub film_rise: RecordMean,
    /// Mean rise of both surfaces, weighted with the pressure \[K\].
    pub surface_rise: RecordMean,
}

/// One time of a record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Moment {
    /// Half-widths travelled at the mean speed.
    pub time: f64,
    /// Share of the load below the solid film.
    pub solid_share: f64,
    /// Film at x = 0.
    pub central_film: Length,
    /// Mean film within the half-width.
    pub mean_film: Length,
    /// Largest pressure.
    pub max_pressure: Pressure,
    /// Friction, with a law.
    pub friction: Option<Friction>,
}

/// The whole film at one time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Frame {
    /// Half-widths travelled at the mean speed.
    pub time: f64,
    /// Pressure over p₀ on the nodes.
    pub pressure: Vec<f64>,
    /// Film over a²/R on the nodes.
    pub film: Vec<f64>,
    /// States of the nodes.
    pub state: Vec<NodeState>,
}

/// Results of a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Record {
    /// Scales of the contact.
    pub scales: Scales,
    /// Central film of smooth surfaces with the Newtonian oil.
    pub smooth_film: Length,
    /// Travel recorded, in half-widths.
    pub travel: f64,
    /// Blocks of one half-width that the standard errors come from.
    pub blocks: usize,
    /// Share of the load at films no thicker than `solid_film`.
    pub solid_share: RecordMean,
    /// Share of the load at films no thicker than each threshold.
    pub load_below: Vec<LoadBelow>,
    /// Share of the load on contact nodes; does not converge with the grid.
    pub contact_share: RecordMean,
    /// Share of the load at the flow pressure.
    pub plastic_share: RecordMean,
    /// Mean film within the half-width \[m\].
    pub mean_film: RecordMean,
    /// Standard deviation of the film within the half-width, over place and time.
    pub film_spread: Length,
    /// Mean over time of the largest pressure \[Pa\].
    pub mean_max_pressure: RecordMean,
    /// Largest pressure of all times.
    pub max_pressure: Pressure,
    /// Friction at the bulk temperature, with a law.
    pub friction: Option<MeanFriction>,
    /// Friction with the heat of film and surfaces, if requested.
    pub heated: Option<HeatedFriction>,
    /// Mean over time of the pressure over p₀ on the nodes.
    pub mean_pressure: Vec<f64>,
    /// Mean over time of the film over a²/R on the nodes.
    pub mean_film_on_nodes: Vec<f64>,
    /// Every step, if requested.
    pub history: Vec<Moment>,
    /// Frames, if requested.
    pub frames: Vec<Frame>,
    /// Places of the nodes over a.
    pub x: Vec<f64>,
}

/// Progress of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Half-widths travelled.
    pub time: f64,
    /// Half-widths to travel, as known now.
    pub end: f64,
    /// Steps taken.
    pub steps: usize,
    /// Steps repeated at half their length.
    pub steps_cut: usize,
}

/// Quantities of the batch means before the shares of the films.
const SOLID: usize = 0;
const CONTACT: usize = 1;
const PLASTIC: usize = 2;
const FILM: usize = 3;
const FILM_SQUARE: usize = 4;
const PRESSURE: usize = 5;
const FRICTION: usize = 6;
const HEATED: usize = 11;
const FILM_RISE: usize = 16;
const SURFACE_RISE: usize = 17;
const SHARES: usize = 18;

/// Records a rough contact.
///
/// # Errors
/// When an input is outside its domain, the smooth start or a time step does not converge, or a single
/// pass of a profile ends too early.
pub fn record(
    contact: &RoughContact,
    settings: &RecordSettings,
) -> Result<Solved<Record>, EhlError> {
    record_watched(contact, settings, |_| true)
}

/// Records a rough contact; `watch` is called after every step and stops the record by returning false.
///
/// # Errors
/// As [`record`]; [`EhlError::Stopped`] when `watch` returns false.
pub fn record_watched(
    contact: &RoughContact,
    settings: &RecordSettings,
    mut watch: impl FnMut(Progress) -> bool,
) -> Result<Solved<Record>, EhlError> {
    settings.validate()?;
    let scales = contact.contact.scales(&contact.oil)?;
    let fluid = Fluid::new(&contact.oil, &scales);
    let smooth = solve_sequence(
        &scales,
        &fluid.newtonian(),
        settings.window,
        settings.cells,
        &START_LIMITS,
    )?;
    let mut evidence = Evidence {
        newton_iterations: 0,
        gmres_iterations: 0,
        ..Evidence::new(&smooth.grid, &smooth.solution, 0.0)
    };
    let smooth_film = scales.film_length(smooth.grid.interpolate(&smooth.solution.film, 0.0));
    let surfaces = [contact.surface_1.clone(), contact.surface_2.clone()];
    let step_settings = settings.steps(&scales);
    let mut stepper = Stepper::new(smooth, scales, fluid, surfaces, step_settings);
    let start = settings.start.max(stepper.filled_after());
    let mut recorder = Recorder::new(settings, &scales, step_settings);
    recorder.heat = match (&settings.heat, &settings.friction) {
        (Some(heat), Some(law)) => Some(HeatHistory::new(
            heat,
            law.boundary_friction,
            &contact.contact,
            &scales,
            &stepper.grid.x,
        )?),
        _ => None,
    };
    let mut end = start + settings.length;
    let longest = settings.until.map_or(end, |(_, longest)| start + longest);
    stepper.check_lengths(longest.max(end))?;
    // A record ends at `end`, or block by block up to `longest` until the standard error is reached.
    while stepper.time < end - 1e-9 {
        let step = stepper.advance()?;
        evidence.join(&Evidence {
            steps: 1,
            ..Evidence::new(&stepper.grid, &stepper.now, step_settings.contact_film)
        });
        // The surfaces are warm when the record begins.
        let heated = recorder.heated(&stepper, step)?;
        if stepper.time > start {
            recorder.add(&stepper, step, heated);
        }
        let progress = Progress {
            time: stepper.time,
            end,
            steps: evidence.steps,
            steps_cut: stepper.steps_cut,
        };
        if !watch(progress) {
            return Err(EhlError::Stopped { time: stepper.time });
        }
        if stepper.time >= end - 1e-9 && !recorder.is_settled(settings) {
            end = (end + BLOCK).min(longest);
        }
    }
    evidence.steps_cut = stepper.steps_cut;
    Ok(Solved {
        value: recorder.finish(&stepper, smooth_film, stepper.time - start),
        evidence,
    })
}

/// Travel of a block of the standard errors, in half-widths.
const BLOCK: f64 = 1.0;

impl RecordSettings {
    fn validate(&self) -> Result<(), EhlError> {
        check_cells(self.cells)?;
        DomainError::positive("contact film", self.contact_film)?;
        DomainError::positive("solid film", self.solid_film)?;
        for film in &self.films {
            DomainError::positive("film of the distribution", *film)?;
        }
        let least = |name, value: f64, least: f64, rule| {
            DomainError::require(
                value.is_finite() && value >= least,
                name,
                value,
                "half-widths",
                rule,
            )
        };
        least(
            "start of the averages",
            self.start,
            0.0,
            "must not be negative",
        )?;
        least(
            "travel of the solution",
            self.length,
            1.0,
            "must be at least 1, for a block",
        )?;
        DomainError::require(
            self.ramp.is_finite() && self.ramp > 0.0,
            "ramp",
            self.ramp,
            "half-widths",
            "must be positive",
        )?;
        DomainError::require(
            self.courant > 0.0 && self.courant <= 2.0,
            "Courant number",
            self.courant,
            "-",
            "must lie above 0 and not above 2",
        )?;
        if let Some(ceiling) = &self.ceiling {
            DomainError::positive("flow pressure", ceiling.pressure)?;
        }
        if let Some(law) = &self.friction {
            law.validate()?;
        }
        Ok(())
    }

    fn steps(&self, scales: &Scales) -> StepSettings {
        StepSettings {
            contact_film: scales.film_of(self.contact_film),
            ceiling: self.ceiling.map(|ceiling| Ceiling {
                pressure: ceiling.pressure / scales.max_pressure,
            }),
            courant: self.courant,
            ramp: self.ramp,
            limits: STEP_LIMITS,
        }
    }
}

/// Sums of a record while it runs.
struct Recorder<'a> {
    settings: &'a RecordSettings,
    scales: Scales,
    steps: StepSettings,
    /// Films of the distribution over a²/R.
    films: Vec<f64>,
    means: BatchMeans,
    values: Vec<f64>,
    max_pressure: f64,
    /// Time integrals of pressure and film on the nodes, and the time.
    pressure: Vec<f64>,
    film: Vec<f64>,
    elapsed: f64,
    history: Vec<Moment>,
    frames: Vec<Frame>,
    next_frame: f64,
    heat: Option<HeatHistory>,
}

impl<'a> Recorder<'a> {
    fn new(settings: &'a RecordSettings, scales: &Scales, steps: StepSettings) -> Self {
        let films: Vec<f64> = settings.films.iter().map(|f| scales.film_of(*f)).collect();
        let count = SHARES + films.len();
        Self {
            settings,
            scales: *scales,
            steps,
            films,
            means: BatchMeans::new(count, BLOCK),
            values: vec![0.0; count],
            max_pressure: 0.0,
            pressure: Vec::new(),
            film: Vec::new(),
            elapsed: 0.0,
            history: Vec::new(),
            frames: Vec::new(),
            next_frame: f64::NEG_INFINITY,
            heat: None,
        }
    }

    fn boundary_films(&self) -> BoundaryFilms {
        BoundaryFilms {
            contact: self.settings.contact_film.si(),
            solid: self.settings.solid_film.si(),
        }
    }

    /// Friction of the film with the shear stress of each node, a function of pressure, film \[Pa, m\] and number.
    fn friction(
        &self,
        stepper: &Stepper,
        stress: impl Fn(f64, f64, usize) -> f64,
    ) -> Option<Friction> {
        let law = self.settings.friction?;
        let p_0 = self.scales.max_pressure.si();
        let nodes = stepper.now.film.iter().enumerate().map(|(i, film)| {
            let pressure = stepper.now.unknowns.pressure[i] * p_0;
            let film = film * self.scales.film;
            ShearedNode {
                weight: stepper.grid.weights[i],
                pressure,
                film,
                stress: stress(pressure, film, i),
            }
        });
        Some(law.friction(nodes, self.boundary_films()))
    }

    /// Friction and rises of film and surfaces after a step with heat.
    fn heated(
        &mut self,
        stepper: &Stepper,
        step: f64,
    ) -> Result<Option<(Friction, [f64; 2])>, EhlError> {
        let (Some(mut heat), Some(law)) = (self.heat.take(), self.settings.friction) else {
            return Ok(None);
        };
        let films = self.boundary_films();
        let p_0 = self.scales.max_pressure.si();
        let pressures = &stepper.now.unknowns.pressure;
        let states = pressures.iter().zip(&stepper.now.film).map(|(p, film)| {
            let film = film * self.scales.film;
            HeatedNode {
                pressure: p * p_0,
                film: film.max(THINNEST),
                boundary: law.shifted_weight(film, films),
            }
        });
        let nodes = heat.advance(step, states)?;
        let friction = self.friction(stepper, |_, _, i| nodes[i].stress);
        let mut rises = [0.0; 2];
        for (i, node) in nodes.iter().enumerate() {
            let load = stepper.grid.weights[i] * pressures[i];
            rises[0] += load * node.film_rise;
            rises[1] += load * node.surface_rise;
        }
        let load = stepper.grid.integral(pressures);
        let found = friction.map(|friction| (friction, rises.map(|rise| rise / load)));
        self.heat = Some(heat);
        Ok(found)
    }

    fn add(&mut self, stepper: &Stepper, step: f64, heated: Option<(Friction, [f64; 2])>) {
        self.values.fill(0.0);
        self.shares(stepper);
        self.films_within(stepper);
        let p_0 = self.scales.max_pressure.si();
        let pressure = &stepper.now.unknowns.pressure;
        let largest = pressure.iter().copied().fold(0.0, f64::max);
        self.max_pressure = self.max_pressure.max(largest);
        self.values[PRESSURE] = largest * p_0;
        let friction = self.settings.friction.and_then(|law| {
            let sliding = self.scales.sliding;
            self.friction(stepper, |pressure, film, _| {
                law.sheared(pressure, sliding, film)
            })
        });
        for (first, found) in [
            (FRICTION, friction),
            (HEATED, heated.map(|(friction, _)| friction)),
        ] {
            let Some(f) = found else { continue };
            let values = [f.film, f.shifted, f.graded, f.stepped, f.boundary_share];
            self.values[first..first + 5].copy_from_slice(&values);
        }
        if let Some((_, [film, surface])) = heated {
            (self.values[FILM_RISE], self.values[SURFACE_RISE]) = (film, surface);
        }
        self.means.add(&self.values, step);
        self.add_profiles(stepper, step);
        if self.settings.history {
            self.history.push(Moment {
                time: stepper.time,
                solid_share: self.values[SOLID],
                central_film: self
                    .scales
                    .film_length(stepper.grid.interpolate(&stepper.now.film, 0.0)),
                mean_film: Length::from_si(self.values[FILM]),
                max_pressure: Pressure::from_si(self.values[PRESSURE]),
                friction,
            });
        }
        self.add_frame(stepper);
    }

    /// Load at films no thicker than each threshold.
    ///
    /// share(h) = Σ wᵢ·Pᵢ·[Hᵢ ≤ h]/Σ wᵢ·Pᵢ                                `[Load-below-film]`
    fn shares(&mut self, stepper: &Stepper) {
        cite!("Load-below-film");
        let now = &stepper.now;
        let load = stepper.grid.integral(&now.unknowns.pressure);
        let solid = self.scales.film_of(self.settings.solid_film);
        let flow = self.steps.ceiling.map_or(f64::INFINITY, |c| c.pressure);
        for (i, p) in now.unknowns.pressure.iter().enumerate() {
            let part = stepper.grid.weights[i] * p / load;
            if part == 0.0 {
                continue;
            }
            // A node in contact is at the boundary film, whatever is left of the iteration.
            let film = if now.unknowns.state[i] == NodeState::Contact {
                self.values[CONTACT] += part;
                self.steps.contact_film
            } else {
                now.film[i]
            };
            if film <= solid {
                self.values[SOLID] += part;
            }
            if *p >= flow {
                self.values[PLASTIC] += part;
            }
            for (k, limit) in self.films.iter().enumerate() {
                if film <= *limit {
                    self.values[SHARES + k] += part;
                }
            }
        }
    }

    /// Mean and mean square of the film within the half-width.
    fn films_within(&mut self, stepper: &Stepper) {
        let mut count = 0.0;
        for (x, film) in stepper.grid.x.iter().zip(&stepper.now.film) {
            if x.abs() < 1.0 {
                let h = film * self.scales.film;
                self.values[FILM] += h;
                self.values[FILM_SQUARE] += h * h;
                count += 1.0;
            }
        }
        self.values[FILM] /= count;
        self.values[FILM_SQUARE] /= count;
    }

    fn add_profiles(&mut self, stepper: &Stepper, step: f64) {
        let now = &stepper.now;
        self.pressure.resize(now.film.len(), 0.0);
        self.film.resize(now.film.len(), 0.0);
        self.elapsed += step;
        for (sum, p) in self.pressure.iter_mut().zip(&now.unknowns.pressure) {
            *sum += step * p;
        }
        for (sum, h) in self.film.iter_mut().zip(&now.film) {
            *sum += step * h;
        }
    }

    fn add_frame(&mut self, stepper: &Stepper) {
        let Some(interval) = self.settings.frame_interval else {
            return;
        };
        if stepper.time >= self.next_frame {
            self.next_frame = stepper.time + interval;
            self.frames.push(Frame {
                time: stepper.time,
                pressure: stepper.now.unknowns.pressure.clone(),
                film: stepper.now.film.clone(),
                state: stepper.now.unknowns.state.clone(),
            });
        }
    }

    /// Whether the requested standard error is reached.
    fn is_settled(&self, settings: &RecordSettings) -> bool {
        settings.until.is_none_or(|(error, longest)| {
            self.means.estimate(SOLID).standard_error <= error
                || self.means.blocks() as f64 * BLOCK >= longest
        })
    }

    fn finish(self, stepper: &Stepper, smooth_film: Length, travel: f64) -> Record {
        let of = |index| self.means.estimate(index);
        let film = of(FILM);
        let friction = |first: usize| MeanFriction {
            film: of(first),
            shifted: of(first + 1),
            graded: of(first + 2),
            stepped: of(first + 3),
            boundary_share: of(first + 4),
        };
        let over_time = |sums: Vec<f64>| sums.iter().map(|sum| sum / self.elapsed).collect();
        let variance = of(FILM_SQUARE).mean - film.mean * film.mean;
        let load_below = self
            .settings
            .films
            .iter()
            .enumerate()
            .map(|(k, film)| LoadBelow {
                film: *film,
                share: of(SHARES + k),
            })
            .collect();
        Record {
            scales: self.scales,
            smooth_film,
            travel,
            blocks: self.means.blocks(),
            solid_share: of(SOLID),
            load_below,
            contact_share: of(CONTACT),
            plastic_share: of(PLASTIC),
            mean_film: film,
            film_spread: Length::from_si(variance.max(0.0).sqrt()),
            mean_max_pressure: of(PRESSURE),
            max_pressure: self.scales.max_pressure * self.max_pressure,
            friction: self.settings.friction.map(|_| friction(FRICTION)),
            heated: self.heat.as_ref().map(|_| HeatedFriction {
                friction: friction(HEATED),
                film_rise: of(FILM_RISE),
                surface_rise: of(SURFACE_RISE),
            }),
            mean_pressure: over_time(self.pressure),
            mean_film_on_nodes: over_time(self.film),
            history: self.history,
            frames: self.frames,
            x: stepper.grid.x.clone(),
        }
    }
}
