//! Friction of a rough contact with the heat of film and surfaces.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | T_b | bulk temperature of the bodies and of the oil at the inlet | K |
//! | T₁, T₂ | rises of the surface temperatures | K |
//! | V_s, τ | sliding speed u₁ − u₂, shear stress of the film | m/s, Pa |
//! | β, μ_b | weight and coefficient of the boundary friction | - |
//! | q, q₁, q₂ | heat per area and time, and its parts into the two bodies | W/m² |
//! | B = √(k ρ c) | thermal contact coefficient of a body | W s^½/(m² K) |
//! | k_f(p), h | conductivity and thickness of the film | W/(m K), m |
//! | ξ, t | place on a surface, moving with it; time | m, s |
//!
//! Each point of a surface remembers the heat that it has received, and is heated in depth only. In a film with an even source of
//! heat between walls of different temperatures, the hotter wall receives less:
//!
//! ```text
//! q = V_s (β μ_b p + (1 − β) τ(p, T, V_s/h)),  q₁,₂ = q/2 ∓ (k_f/h) (T₁ − T₂)
//! T_i(ξ, t) = ∫ q_i(ξ, t′)/√(t − t′) dt′/(√π B_i)
//! T = T_b + (T₁ + T₂)/2 + q h/(12 k_f)                                         [Record-heat]
//! ```
//!
//! The temperatures act on the friction only: the film has the viscosity of the inlet. β is the weight of the shifted friction.

use std::collections::VecDeque;
use std::f64::consts::PI;

use asperity_core::material::Material;
use asperity_core::quantity::Temperature;
use asperity_core::{DomainError, cite};
use asperity_oil::FilmRheology;

use crate::dimensionless::{LineContact, Scales};
use crate::error::EhlError;

/// Heat of a record: oil over temperature, bulk temperature, bodies.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordHeat {
    /// Shear stress of the oil over pressure, temperature and rate.
    pub rheology: FilmRheology,
    /// Bulk temperature of the bodies and of the oil at the inlet.
    pub bulk: Temperature,
    /// Materials of the two bodies.
    pub bodies: [Material; 2],
}

/// Step of ln a in the sum of exponentials e^(−a·t) for 1/√t: the sum is off by 2e-4.
const LOG_STEP: f64 = 1.0;
/// Slowest exponential: its change over a stay in the window.
const SLOWEST: f64 = 1e-2;
/// Fastest exponential: its change over the longest step. Faster ones are at their end within a step.
const FASTEST: f64 = 30.0;

/// Response of a surface to heat, as a sum of exponentials.
///
/// 1/√t = Σ_k w_k e^(−a_k t), a_k = e^(k·Δ), w_k = Δ √(a_k/π): the trapezoidal rule of a Gamma function.
struct HeatKernel {
    /// Rates a_k \[1/s\], the first 0 for all that are slower than the second.
    rates: Vec<f64>,
    /// Weights w_k \[1/√s\].
    weights: Vec<f64>,
    /// Integral of the exponentials faster than the last \[√s\].
    instantaneous: f64,
}

impl HeatKernel {
    /// The kernel for steps of `step` and stays of `stay` \[s\].
    fn new(step: f64, stay: f64) -> Self {
        let weight = |log: f64| LOG_STEP * (0.5 * log).exp() / PI.sqrt();
        let slowest = (SLOWEST / stay).ln();
        let count = ((FASTEST / step).ln() - slowest) / LOG_STEP;
        let logs: Vec<f64> = (0..=count.ceil().max(0.0) as usize)
            .map(|k| slowest + LOG_STEP * k as f64)
            .collect();
        let fastest = logs.last().copied().unwrap_or(slowest);
        // Geometric series of the exponentials left out at both ends.
        let ratio = (-0.5 * LOG_STEP).exp();
        let slow = weight(slowest) * ratio / (1.0 - ratio);
        let fast = LOG_STEP * (-0.5 * fastest).exp() / PI.sqrt() * ratio / (1.0 - ratio);
        let rates = std::iter::once(0.0).chain(logs.iter().map(|log| log.exp()));
        let weights = std::iter::once(slow).chain(logs.iter().map(|log| weight(*log)));
        Self {
            rates: rates.collect(),
            weights: weights.collect(),
            instantaneous: fast,
        }
    }

    /// Per exponential e^(−a Δt) and (1 − e^(−a Δt))/a over a step \[s\].
    fn over(&self, step: f64) -> Vec<[f64; 2]> {
        let of = |a: &f64| {
            if *a > 0.0 {
                [(-a * step).exp(), -(-a * step).exp_m1() / a]
            } else {
                [1.0, step]
            }
        };
        self.rates.iter().map(of).collect()
    }
}

/// Surface with the heat that its points have received.
struct HeatedSurface {
    /// Cells travelled per cell of mean travel.
    speed: f64,
    /// √π B.
    effusivity: f64,
    /// Cells by which point j is beyond node j, 0 to 1.
    shift: f64,
    /// Integrals of the heat with each exponential, of each point \[J/m²\].
    points: VecDeque<Vec<f64>>,
}

impl HeatedSurface {
    fn new(speed: f64, body: &Material, nodes: usize, modes: usize) -> Result<Self, DomainError> {
        let rho = DomainError::positive("density of the bodies", body.density)?;
        let c = DomainError::positive("heat capacity of the bodies", body.heat_capacity)?;
        let k = DomainError::positive("conductivity of the bodies", body.conductivity)?;
        Ok(Self {
            speed,
            effusivity: (PI * rho * c * k).sqrt(),
            shift: 0.0,
            points: vec![vec![0.0; modes]; nodes + 1].into(),
        })
    }

    /// Moves the points by a travel in cells; fresh ones enter cold. Their heat fades by `fading`.
    fn advance(&mut self, travel: f64, fading: &[[f64; 2]]) {
        self.shift += self.speed * travel;
        while self.shift >= 1.0 {
            self.shift -= 1.0;
            if let Some(mut left) = self.points.pop_back() {
                left.fill(0.0);
                self.points.push_front(left);
            }
        }
        while self.shift < 0.0 {
            self.shift += 1.0;
            if let Some(mut left) = self.points.pop_front() {
                left.fill(0.0);
                self.points.push_back(left);
            }
        }
        for point in &mut self.points {
            for (integral, [fade, _]) in point.iter_mut().zip(fading) {
                *integral *= fade;
            }
        }
    }

    /// Rises at the nodes by the heat received before. Point 0 is before node 0.
    fn rises(&self, weights: &[f64]) -> Vec<f64> {
        let of = |point: &Vec<f64>| {
            let sum: f64 = point.iter().zip(weights).map(|(s, w)| s * w).sum();
            sum / self.effusivity
        };
        let points: Vec<f64> = self.points.iter().map(of).collect();
        let between = |pair: &[f64]| self.shift * pair[0] + (1.0 - self.shift) * pair[1];
        points.windows(2).map(between).collect()
    }

    /// Adds the heat of a step, `heat` at the nodes.
    fn receive(&mut self, heat: &[f64], fading: &[[f64; 2]]) {
        let last = heat.len() - 1;
        for (j, point) in self.points.iter_mut().enumerate() {
            // Point j is beyond node j − 1 by the shift.
            let [low, high] = [j.saturating_sub(1), j.min(last)].map(|node| heat[node]);
            let received = (1.0 - self.shift) * low + self.shift * high;
            if received != 0.0 {
                for (integral, [_, gain]) in point.iter_mut().zip(fading) {
                    *integral += received * gain;
                }
            }
        }
    }
}

/// State of a node: pressure \[Pa\], film \[m\], weight β of the boundary friction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HeatedNode {
    pub(crate) pressure: f64,
    pub(crate) film: f64,
    pub(crate) boundary: f64,
}

/// Shear stress and temperature rises of a node.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Heated {
    /// Shear stress of the film \[Pa\].
    pub(crate) stress: f64,
    /// Rise of the mean film temperature over the bulk \[K\].
    pub(crate) film_rise: f64,
    /// Mean rise of both surfaces \[K\].
    pub(crate) surface_rise: f64,
}

/// Temperatures of both surfaces of a record, advanced with its steps.
pub(crate) struct HeatHistory {
    heat: RecordHeat,
    kernel: HeatKernel,
    surfaces: [HeatedSurface; 2],
    /// Seconds, and cells, per half-width of mean travel.
    seconds: f64,
    cells: f64,
    /// V_s \[m/s\].
    sliding: f64,
    boundary_friction: f64,
    nodes: Vec<Heated>,
}

impl HeatHistory {
    /// Cold surfaces on the even grid `x`, places over a.
    pub(crate) fn new(
        heat: &RecordHeat,
        boundary_friction: f64,
        contact: &LineContact,
        scales: &Scales,
        x: &[f64],
    ) -> Result<Self, EhlError> {
        DomainError::positive("bulk temperature", heat.bulk)?;
        let (nodes, spacing) = (x.len(), x[1] - x[0]);
        let seconds = scales.half_width.si() / scales.entrainment;
        let window = x[nodes - 1] - x[0];
        let speeds = [contact.speed_1, contact.speed_2].map(|u| u.si() / scales.entrainment);
        // A surface at rest stays as long as one at a hundredth of the mean speed.
        let slow = speeds.iter().fold(1.0, |slow, u| u.abs().clamp(0.01, slow));
        let kernel = HeatKernel::new(spacing * seconds, window * seconds / slow);
        let modes = kernel.rates.len();
        let [first, second] =
            [0, 1].map(|k: usize| HeatedSurface::new(speeds[k], &heat.bodies[k], nodes, modes));
        Ok(Self {
            heat: heat.clone(),
            kernel,
            surfaces: [first?, second?],
            seconds,
            cells: 1.0 / spacing,
            sliding: scales.sliding.abs(),
            boundary_friction,
            nodes: vec![Heated::default(); nodes],
        })
    }

    /// Stress and temperatures after a step of `step` half-widths.
    ///
    /// # Errors
    /// When a stress does not converge, which no finite input causes.
    pub(crate) fn advance(
        &mut self,
        step: f64,
        states: impl Iterator<Item = HeatedNode>,
    ) -> Result<&[Heated], EhlError> {
        cite!("Record-heat");
        let fading = self.kernel.over(step * self.seconds);
        let weights = &self.kernel.weights;
        let gains = fading.iter().zip(weights).map(|([_, gain], w)| w * gain);
        let response = gains.sum::<f64>() + self.kernel.instantaneous;
        let [first, second] = &mut self.surfaces;
        for surface in [&mut *first, &mut *second] {
            surface.advance(step * self.cells, &fading);
        }
        let before = [first.rises(weights), second.rises(weights)];
        let responses = [response / first.effusivity, response / second.effusivity];
        let mut received = [vec![0.0; self.nodes.len()], vec![0.0; self.nodes.len()]];
        for (i, state) in states.enumerate() {
            let walls = Walls {
                before: [before[0][i], before[1][i]],
                responses,
            };
            let (node, heat) = self.heat.node(
                &walls,
                &state,
                self.sliding,
                self.boundary_friction,
                self.nodes[i].stress,
            )?;
            self.nodes[i] = node;
            (received[0][i], received[1][i]) = (heat[0], heat[1]);
        }
        for (surface, heat) in self.surfaces.iter_mut().zip(&received) {
            surface.receive(heat, &fading);
        }
        Ok(&self.nodes)
    }
}

/// Both walls at a node: rises by the heat received before, and by heat of this step per its amount \[K m²/W\].
struct Walls {
    before: [f64; 2],
    responses: [f64; 2],
}

impl Walls {
    /// Mean rise without heat, and per heat of the film, where conduction through the film is `g` \[W/(m² K)\].
    fn mean(&self, g: f64) -> [f64; 2] {
        let ([a_1, a_2], [r_1, r_2]) = (self.before, self.responses);
        let equal = g / (1.0 + g * (r_1 + r_2));
        [
            0.5 * (a_1 + a_2) - 0.5 * (r_1 - r_2) * equal * (a_1 - a_2),
            0.25 * (r_1 + r_2) - 0.25 * (r_1 - r_2) * (r_1 - r_2) * equal,
        ]
    }

    /// Parts of the heat `q` into both bodies.
    fn parts(&self, g: f64, q: f64) -> [f64; 2] {
        let ([a_1, a_2], [r_1, r_2]) = (self.before, self.responses);
        let difference = (a_1 - a_2 + 0.5 * (r_1 - r_2) * q) / (1.0 + g * (r_1 + r_2));
        [0.5 * q - g * difference, 0.5 * q + g * difference]
    }
}

impl RecordHeat {
    /// Stress and temperatures of a node, and the heat into both bodies.
    fn node(
        &self,
        walls: &Walls,
        state: &HeatedNode,
        sliding: f64,
        boundary_friction: f64,
        start: f64,
    ) -> Result<(Heated, [f64; 2]), EhlError> {
        if state.pressure <= 0.0 || sliding == 0.0 {
            let [surface_rise, _] = walls.mean(0.0);
            let cold = Heated {
                stress: 0.0,
                film_rise: surface_rise,
                surface_rise,
            };
            return Ok((cold, walls.parts(0.0, 0.0)));
        }
        let point = self
            .rheology
            .film_point(state.pressure, sliding, state.film);
        let conduction = self.rheology.conductivity(state.pressure) / state.film;
        let [wall, per_heat] = walls.mean(conduction);
        // Rise of the film per stress: by its own heat, and by the walls that this heat warms.
        let per_stress = point.heating() + per_heat * sliding;
        let boundary = state.boundary * boundary_friction * state.pressure;
        let at = self.bulk.si() + wall + per_stress * boundary;
        let sheared = 1.0 - state.boundary;
        let start = (start > 0.0).then_some(start);
        let point = point.with_heating(sheared * per_stress);
        let stress = self.rheology.heated_stress(&point, at, start)?.0.value;
        let rubbed = boundary + sheared * stress;
        let q = sliding * rubbed;
        let node = Heated {
            stress,
            film_rise: wall + per_stress * rubbed,
            surface_rise: wall + per_heat * q,
        };
        Ok((node, walls.parts(conduction, q)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_oil::{BaseOil, LubricantInput};

    fn heat() -> RecordHeat {
        let oil = LubricantInput {
            oil: Some("m100".into()),
            base_oil: Some(BaseOil::Mineral),
            ..LubricantInput::default()
        };
        let bulk = "90 °C".parse().unwrap();
        let oil = oil.resolve(bulk).unwrap();
        let steel = Material {
            young: "210 GPa".parse().unwrap(),
            poisson: 0.3,
            elastic_limit: "1500 MPa".parse().unwrap(),
            density: "7830 kg/m3".parse().unwrap(),
            conductivity: "45 W/(m K)".parse().unwrap(),
            heat_capacity: "465 J/(kg K)".parse().unwrap(),
        };
        RecordHeat {
            rheology: FilmRheology::new(&oil, BaseOil::Mineral).unwrap(),
            bulk,
            bodies: [steel; 2],
        }
    }

    fn contact() -> (LineContact, Scales) {
        let contact = LineContact::at_pressure(
            "10 mm".parse().unwrap(),
            "115.4 GPa".parse().unwrap(),
            "1.2 GPa".parse().unwrap(),
            "5 m/s".parse().unwrap(),
            0.8,
        )
        .unwrap();
        let oil = crate::Oil {
            viscosity: "10 mPa s".parse().unwrap(),
            pressure_viscosity: "18 1/GPa".parse().unwrap(),
            viscosity_law: asperity_oil::PressureViscosityLaw::Roelands { exponent: 0.6 },
            density_law: asperity_oil::DensityLaw::DowsonHigginson,
            shear_law: asperity_oil::ShearLaw::Newtonian,
        };
        (contact, contact.scales(&oil).unwrap())
    }

    #[test]
    fn the_sum_of_exponentials_is_one_over_the_root_of_time() {
        let kernel = HeatKernel::new(1e-7, 1e-3);
        for k in 0..=40 {
            let t = 1e-7 * 10_f64.powf(0.1 * f64::from(k));
            let modes = kernel.rates.iter().zip(&kernel.weights);
            let sum: f64 = modes.map(|(a, w)| w * (-a * t).exp()).sum();
            assert!(
                (sum * t.sqrt() - 1.0).abs() < 3e-4,
                "{t}: {}",
                sum * t.sqrt()
            );
            let gains = kernel.over(t);
            let gains = gains.iter().zip(&kernel.weights);
            let response = gains.map(|([_, gain], w)| w * gain).sum::<f64>();
            let response = (response + kernel.instantaneous) / (2.0 * t.sqrt());
            assert!((response - 1.0).abs() < 3e-4, "{t}: {response}");
        }
    }

    #[test]
    fn surfaces_under_a_band_of_boundary_friction_warm_as_under_a_moving_source() {
        let (contact, scales) = contact();
        let cells = 512_usize;
        let x: Vec<f64> = (0..=cells)
            .map(|i| -2.5 + 4.0 * i as f64 / cells as f64)
            .collect();
        let mut history = HeatHistory::new(&heat(), 0.1, &contact, &scales, &x).unwrap();
        // So thin a film leaves no difference between the surfaces.
        let states = || {
            x.iter().map(|x| HeatedNode {
                pressure: if x.abs() < 1.0 { 1e9 } else { 0.0 },
                film: 2e-10,
                boundary: 1.0,
            })
        };
        for step in 0..1500 {
            // Some steps are halved.
            let parts = if step % 7 == 0 { 2 } else { 1 };
            for _ in 0..parts {
                history
                    .advance(4.0 / cells as f64 / f64::from(parts), states())
                    .unwrap();
            }
        }
        let q = scales.sliding * 0.1 * 1e9;
        let effusivity = (PI * 7830.0 * 465.0 * 45.0_f64).sqrt();
        let roots = contact.speed_1.si().sqrt() + contact.speed_2.si().sqrt();
        for place in [-0.5, 0.0, 0.5, 0.98] {
            let node = &history.nodes[((place + 2.5) / 4.0 * cells as f64).round() as usize];
            let path = (place + 1.0) * scales.half_width.si();
            let rise = 2.0 * q * path.sqrt() / (effusivity * roots);
            let ratio = node.surface_rise / rise;
            assert!((ratio - 1.0).abs() < 0.01, "{place}: {ratio} of {rise}");
        }
        // Behind the band the surfaces cool.
        let [end, behind] = [448, 500].map(|node: usize| history.nodes[node].surface_rise);
        assert!(behind < 0.7 * end, "{behind} {end}");
    }

    #[test]
    fn both_bodies_share_the_heat_and_insulating_films_share_it_evenly() {
        let walls = Walls {
            before: [30.0, 10.0],
            responses: [3e-8, 2e-8],
        };
        for g in [0.0, 1e6, 1e12] {
            let q = 2e8;
            let parts = walls.parts(g, q);
            assert!((parts[0] + parts[1] - q).abs() < 1e-3 * q);
            let rises = [0, 1].map(|k: usize| walls.before[k] + walls.responses[k] * parts[k]);
            let [wall, per_heat] = walls.mean(g);
            let mean = 0.5 * (rises[0] + rises[1]);
            assert!((wall + per_heat * q - mean).abs() < 1e-9, "{g}");
            assert!(g > 0.0 || parts[0] == parts[1]);
            assert!(g < 1e9 || (rises[0] - rises[1]).abs() < 1e-2, "{rises:?}");
        }
    }

    #[test]
    fn heat_lowers_the_stress_and_a_standing_film_makes_none() {
        let (contact, scales) = contact();
        let x: Vec<f64> = (0..=64).map(|i| -2.5 + 4.0 * f64::from(i) / 64.0).collect();
        let heat = heat();
        let mut history = HeatHistory::new(&heat, 0.1, &contact, &scales, &x).unwrap();
        let state = HeatedNode {
            pressure: 1e9,
            film: 0.3e-6,
            boundary: 0.0,
        };
        let warm = history.advance(0.01, x.iter().map(|_| state)).unwrap()[32];
        let cold = heat.rheology.film_point(1e9, scales.sliding.abs(), 0.3e-6);
        let cold = heat
            .rheology
            .heated_stress(&cold.isothermal(), heat.bulk.si(), None);
        let cold = cold.unwrap().0.value;
        assert!(warm.stress > 0.0 && warm.stress < cold && warm.film_rise > warm.surface_rise);
        let open = HeatedNode {
            pressure: 0.0,
            ..state
        };
        let mut cold = HeatHistory::new(&heat, 0.1, &contact, &scales, &x).unwrap();
        let nodes = cold.advance(0.01, x.iter().map(|_| open)).unwrap();
        assert!(
            nodes
                .iter()
                .all(|node| node.film_rise == 0.0 && node.stress == 0.0)
        );
    }
}
