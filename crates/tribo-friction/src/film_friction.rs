//! Friction of a smooth film in a line contact, with the heat of film and surfaces; a contact at a point is in
//! [`point_film`](crate::point_film).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | w, R, E* | load per length, relative radius, reduced modulus | N/m, m, Pa |
//! | a, p₀ | half width and largest pressure of Hertz | m, Pa |
//! | h | central film thickness, with its thermal reduction | m |
//! | u₁, u₂, V_s | surface speeds, sliding speed u₁ − u₂ | m/s |
//! | T₀, T_s | bulk temperature, mean temperature of the surfaces in the contact | K |
//! | B = √(k ρ c), κ = k/(ρ c) | thermal contact coefficient and diffusivity of a flank | W s^½/(m² K), m²/s |
//! | φ | share of the load on asperities | - |
//! | p′ | pressure that flattens the roughness at a place of the film | Pa |
//!
//! The film has one thickness and carries the Hertz pressure; no asperities. Where asperities carry a share of the load, the
//! film has the pressure of what is left to it ([`LoadedFilm::carry`]), and between rough flanks the pressure ripples
//! ([`LoadedFilm::carry_rippled`]). The shear stress is that of
//! [`FilmRheology`]: by default Eyring's law on Barus' viscosity below a limiting shear stress. Elastic shear is left out:
//! it matters below slide-to-roll ratios of about 5·10⁻⁴, where the loss is negligible.
//!
//! C is the mean over the contact, weighted with the pressure, of the rise under a fast semi-elliptic
//! line source (its largest value is Blok's 1.11); it needs Péclet numbers u a/(2 κ) above 1, so that
//! slower surfaces enter with the speed 2 κ/a.
//!
//! Checked against two independent programs in fourteen conditions (one is
//! `references/film_friction.py`). A warning outside the ranges
//! of the comparison with measured gears (own choice).

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroUsize;

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::numerics::{Solved, gauss_legendre, newton_root};
use asperity_core::quantity::{Length, Pressure, Temperature};
use asperity_core::{Checked, DomainError, FittedRange, OutOfRange, cite};
use asperity_oil::{FilmPoint, FilmRheology, ShearedPoint};
use serde::Serialize;

use crate::error::FrictionError;

/// √(2π) Γ(5/2) Γ(1/4)/(2^(5/2) Γ(7/4)² Γ(11/4)) · (2/π) √(2/π).
pub(crate) const MEAN_FLASH: f64 = 0.798_507_829_726;
/// Share of the limiting stress from which a place counts as limited.
const LIMITED: f64 = 0.7;
/// Relative step at which the iteration for the surface temperature ends; the error is its square.
const TEMPERATURE_TOLERANCE: f64 = 1e-9;

/// Places along half of a rippled film, and groups of its parts at each: within .6 % of the friction of sixteen places times all
/// parts, .1 % in the mean.
pub(crate) const PLACES: NonZeroUsize = NonZeroUsize::MIN.saturating_add(5);
const GROUPS: usize = 4;
/// Pressure over the largest Hertz pressure where a film at light load would have none.
const LEAST_PRESSURE: f64 = 0.005;

/// Range in which the law was compared with measured gears.
const RANGES: [FittedRange; 4] = [
    FittedRange::new("bulk temperature", -30.0, 120.0, "°C", "film friction"),
    FittedRange::new("viscosity", 2.0, 5000.0, "mPa s", "film friction"),
    FittedRange::new("maximum pressure", 0.3, 2.5, "GPa", "film friction"),
    FittedRange::new("entrainment speed", 0.1, 30.0, "m/s", "film friction"),
];

/// A smooth film in a line contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmLineContact {
    /// Load, geometry, speeds and bodies.
    pub line: LineContact,
    /// Central film thickness h with its thermal reduction.
    pub film: Length,
    /// Bulk temperature T₀ of the flanks and of the oil at the inlet.
    pub temperature: Temperature,
}

/// Heating included in the film friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum FilmHeat {
    /// Film and surfaces are heated by the friction.
    #[default]
    FilmAndSurfaces,
    /// Everything stays at the bulk temperature.
    Isothermal,
}

/// Quadrature over the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct FilmSettings {
    /// Gauss-Legendre nodes over half the contact: 16 give 4·10⁻⁶ of the coefficient or better.
    pub nodes: NonZeroUsize,
    /// Heating included.
    pub heat: FilmHeat,
}

impl Default for FilmSettings {
    fn default() -> Self {
        Self {
            nodes: NonZeroUsize::MIN.saturating_add(15),
            heat: FilmHeat::default(),
        }
    }
}

/// Film friction with its temperatures.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmFrictionSolution {
    /// Friction coefficient μ_f.
    pub coefficient: f64,
    /// Mean shear stress over the contact.
    pub mean_stress: Pressure,
    /// Rise T_s − T₀ of the surface temperature \[K\].
    pub surface_rise: f64,
    /// Largest rise of the mean film temperature over the walls, at the nodes \[K\].
    pub largest_film_rise: f64,
    /// Mean of that rise, weighted with the pressure \[K\].
    pub mean_film_rise: f64,
    /// Share of the load on places with more than 0.7 of the limiting stress.
    pub limited_share: f64,
    /// Half width a along the motion.
    pub half_width: Length,
    /// Largest Hertz pressure p₀.
    pub max_pressure: Pressure,
    /// Evidence of the coefficient's iteration.
    pub evidence: Solved,
}

/// A Gauss node of the contact.
#[derive(Debug, Clone)]
struct Node {
    at: ShearedPoint,
    /// Friction coefficient per stress \[1/Pa\].
    weight: f64,
    /// Whether the stress is that of the last temperature, or of a film near to this one.
    is_known: bool,
}

impl Node {
    fn new(point: FilmPoint, weight: f64) -> Self {
        Self {
            at: ShearedPoint {
                point,
                start: None,
                stress: [0.0; 2],
            },
            weight,
            is_known: false,
        }
    }

    /// The stress with its slope, if it is known.
    fn stress(&self) -> Option<[f64; 2]> {
        self.is_known.then_some(self.at.stress)
    }
}

/// The film of one contact, for evaluation at any surface temperature.
///
/// Stores the stresses of the last temperature as the start of the next.
#[derive(Debug, Clone)]
pub struct LoadedFilm<'a> {
    rheology: &'a FilmRheology,
    nodes: Vec<Node>,
    /// Rise of the surface temperature at which the nodes have their stress \[K\].
    last_rise: f64,
    /// T_s − T₀ per friction coefficient \[K\].
    rise_per_friction: f64,
    bulk: f64,
    /// Load, per length of a line.
    load: f64,
    /// Area of contact, width of a line.
    area: f64,
    half_width: f64,
    max_pressure: f64,
    heat: FilmHeat,
    outside: Vec<OutOfRange>,
    /// Pressure of the whole load at each node \[Pa\], and friction coefficient of the whole load per stress there \[1/Pa\].
    hertz: Vec<[f64; 2]>,
    /// The same at the places of a rippled film.
    few: Vec<[f64; 2]>,
    /// |u₁ − u₂| \[m/s\]
    sliding: f64,
    /// Thickness of the smooth film \[m\].
    film: f64,
    /// Friction coefficient of the whole load per stress of the film at ambient pressure, before and behind the contact \[1/Pa\].
    inlet: f64,
}

/// A part of a film between rough flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmRipple {
    /// Share of the area.
    pub area: f64,
    /// Pressure p′ that flattens the roughness there \[Pa\].
    pub pressure: f64,
    /// Film thickness there \[m\].
    pub film: f64,
}

/// Loaded area of a film, in SI units.
pub(crate) struct FilmArea {
    /// Load, per length of a line.
    pub load: f64,
    /// Area, width of a line.
    pub area: f64,
    /// Half width along the motion.
    pub half_width: f64,
    pub max_pressure: f64,
    pub speeds: [f64; 2],
    pub film: f64,
    pub bulk: f64,
    /// T_s − T₀ per friction coefficient \[K\].
    pub rise_per_friction: f64,
    /// Pressure at each node, and friction coefficient per stress there.
    pub nodes: Vec<[f64; 2]>,
    /// The same at the places of a rippled film.
    pub few: Vec<[f64; 2]>,
}

impl<'a> LoadedFilm<'a> {
    /// The film of a line contact.
    ///
    /// ```text
    /// μ_f = (2a/w) ∫₀^(π/2) τ cos t dt,  p = p₀ cos t                      [Film-friction]
    /// ```
    ///
    /// # Errors
    /// When load, radius, modulus, film, the sum of the speeds or a thermal constant is not positive, or
    /// the oil has no viscosity at the bulk temperature.
    pub fn new(
        rheology: &'a FilmRheology,
        contact: &FilmLineContact,
        settings: FilmSettings,
    ) -> Result<Self, FrictionError> {
        cite!("Film-friction");
        let line = &contact.line;
        let w = DomainError::positive("line load", line.load)?;
        let r = DomainError::positive("radius", line.radius)?;
        let e = DomainError::positive("reduced modulus", line.modulus)?;
        let h = DomainError::positive("film", contact.film)?;
        let bulk = DomainError::positive("bulk temperature", contact.temperature)?;
        let [u1, u2] = line.speeds;
        let u = [
            DomainError::finite("speed of the first surface", u1)?,
            DomainError::finite("speed of the second surface", u2)?,
        ];
        DomainError::positive("entrainment speed", line.entrainment())?;
        let half_width = (4.0 * w * r / (PI * e)).sqrt();
        let max_pressure = 2.0 * w / (PI * half_width);
        let rise_per_friction = match settings.heat {
            FilmHeat::FilmAndSurfaces => surface_rise_per_friction(w, u, half_width, &line.bodies)?,
            FilmHeat::Isothermal => 0.0,
        };
        let node = |&(x, weight): &(f64, f64)| {
            let cos = (0.5 * FRAC_PI_2 * (1.0 + x)).cos();
            let weight = 2.0 * half_width / w * 0.5 * FRAC_PI_2 * weight * cos;
            [max_pressure * cos, weight]
        };
        let area = FilmArea {
            load: w,
            area: 2.0 * half_width,
            half_width,
            max_pressure,
            speeds: u,
            film: h,
            bulk,
            rise_per_friction,
            nodes: gauss_legendre(settings.nodes).iter().map(node).collect(),
            few: gauss_legendre(PLACES).iter().map(node).collect(),
        };
        Self::on(rheology, area, settings.heat)
    }

    /// The film on a loaded area.
    pub(crate) fn on(
        rheology: &'a FilmRheology,
        area: FilmArea,
        heat: FilmHeat,
    ) -> Result<Self, FrictionError> {
        let [u1, u2] = area.speeds;
        let bulk = Temperature::from_si(area.bulk);
        let seen = [
            bulk.celsius(),
            rheology.state(bulk)?.viscosity.si() * 1e3,
            area.max_pressure * 1e-9,
            0.5 * (u1 + u2),
        ];
        let mut outside = Vec::new();
        for (range, value) in RANGES.iter().zip(seen) {
            range.check(value, &mut outside);
        }
        let sliding = (u1 - u2).abs();
        let node = |&[pressure, weight]: &[f64; 2]| {
            let point = point(rheology, heat, [pressure, sliding, area.film]);
            Node::new(point, weight)
        };
        Ok(Self {
            rheology,
            nodes: area.nodes.iter().map(node).collect(),
            last_rise: 0.0,
            rise_per_friction: area.rise_per_friction,
            bulk: area.bulk,
            load: area.load,
            area: area.area,
            half_width: area.half_width,
            max_pressure: area.max_pressure,
            heat,
            outside,
            hertz: area.nodes,
            few: area.few,
            sliding,
            film: area.film,
            inlet: 0.0,
        })
    }

    /// Lets the pressure of the smooth film differ from Hertz's, as at light load: by `excess` over the largest Hertz pressure, whose
    /// coefficients belong to even powers of the place in the contact, and with the stress `inlet` before and behind the
    /// contact, as a mean over its width and over that of the film at ambient pressure.
    ///
    /// ```text
    /// p = p₀ (y + √(y² + 4 · 0.005²))/2,  y = cos t + Σ c_k sin^(2k) t
    /// μ_f += (2a/w) I τ(p = 0)                                                     [Light-film]
    /// ```
    ///
    /// The root keeps the pressure above zero and changes it by less than 3e-4 p₀ above p₀/10.
    ///
    /// # Errors
    /// When the inlet is negative or not finite.
    pub fn reach_beyond(&mut self, excess: &[f64], inlet: f64) -> Result<(), FrictionError> {
        cite!("Light-film");
        let rule = "must be finite and not negative";
        let fits = inlet.is_finite() && inlet >= 0.0;
        DomainError::require(fits, "stress before the contact", inlet, "-", rule)?;
        for [pressure, _] in self.hertz.iter_mut().chain(&mut self.few) {
            let cos = *pressure / self.max_pressure;
            let square = 1.0 - cos * cos;
            let excess = excess.iter().rev().fold(0.0, |sum, c| sum * square + c);
            let sum = cos + excess;
            *pressure = self.max_pressure * 0.5 * (sum + sum.hypot(2.0 * LEAST_PRESSURE));
        }
        self.inlet = inlet * self.area / self.load;
        self.carry(1.0)
    }

    /// The node of the film before and behind the contact, of a film that carries `share` of the load.
    fn inlet_node(&self, share: f64) -> Option<Node> {
        (self.inlet > 0.0).then(|| {
            let point = point(self.rheology, self.heat, [0.0, self.sliding, self.film]);
            Node::new(point, self.inlet / share)
        })
    }

    /// Lets the film carry `share` of the load, the rest of which is on asperities; its friction coefficient is then relative to
    /// this share.
    ///
    /// ```text
    /// μ_f = 2a/((1 − φ) w) ∫₀^(π/2) τ cos t dt,  p = (1 − φ) p₀ cos t                [Own-pressure]
    /// ```
    ///
    /// The half width belongs to the whole load: a Hertz contact with the load (1 − φ) w and the radius R/(1 − φ). The heat of the
    /// surfaces comes from the friction of the whole contact ([`surface_rise`](Self::surface_rise)).
    ///
    /// # Errors
    /// When the share is not above 0 and at most 1.
    pub fn carry(&mut self, share: f64) -> Result<(), FrictionError> {
        cite!("Own-pressure");
        require_share(share)?;
        let rest = Node::new(FilmPoint::REST, 0.0);
        self.nodes.resize(self.hertz.len(), rest);
        for (node, [pressure, weight]) in self.nodes.iter_mut().zip(&self.hertz) {
            let at = [share * pressure, self.sliding, self.film];
            node.at.point = point(self.rheology, self.heat, at);
            node.weight = weight / share;
        }
        self.nodes.extend(self.inlet_node(share));
        Ok(())
    }

    /// [`carry`](Self::carry) of a film between rough flanks, whose pressure ripples. `parts` are in the order of their pressures.
    ///
    /// ```text
    /// p = max(0, (1 − φ) p₀ cos t + (1 − φ)² p′ + c),  c so that the mean over the parts is (1 − φ) p₀ cos t   [Rippled-film]
    /// ```
    ///
    /// One 1 − φ because the film carries that share, one because it does that share of the flattening. At every place along
    /// the contact, neighbouring parts are taken together in groups of equal load, each with its load over its mean pressure as area
    /// and the mean of ln h, in which Eyring's stress is a line. Parts without ripple are [`carry`](Self::carry).
    ///
    /// # Errors
    /// When the share is not above 0 and at most 1, or there are no parts.
    pub fn carry_rippled(&mut self, share: f64, parts: &[FilmRipple]) -> Result<(), FrictionError> {
        cite!("Rippled-film");
        require_share(share)?;
        let areas: f64 = parts.iter().map(|part| part.area).sum();
        let rule = "must be positive";
        DomainError::require(areas > 0.0, "area of the film", areas, "-", rule)?;
        let rest = Node::new(FilmPoint::REST, 0.0);
        self.nodes.resize(self.few.len() * GROUPS, rest);
        let logs: Vec<f64> = parts.iter().map(|part| part.film.ln()).collect();
        let places = self.nodes.chunks_exact_mut(GROUPS);
        for ([pressure, weight], nodes) in self.few.iter().zip(places) {
            let mean = share * pressure;
            let before = near_stresses(nodes);
            for (node, group) in nodes
                .iter_mut()
                .zip(groups(mean, share * share, parts, &logs))
            {
                let film = (group.log_film / group.load).exp();
                let at = [group.square / group.load, self.sliding, film];
                node.at.point = point(self.rheology, self.heat, at);
                node.weight = weight / share * group.load / at[0] / areas;
                let near = before.and_then(|before| guess(&before, at[0]));
                node.is_known = near.is_some();
                node.at.stress = near.unwrap_or_default();
            }
        }
        self.nodes.extend(self.inlet_node(share));
        Ok(())
    }

    /// Inputs outside the ranges in which the law was compared with measured gears.
    #[must_use]
    pub fn outside(&self) -> &[OutOfRange] {
        &self.outside
    }

    /// Rise of the surface temperature over the bulk by a friction coefficient of the whole contact
    /// \[K\].
    #[must_use]
    pub fn surface_rise(&self, coefficient: f64) -> f64 {
        self.rise_per_friction * coefficient
    }

    /// Film friction at a surface temperature `rise` \[K\] above the bulk, and its slope over it \[1/K\].
    ///
    /// # Errors
    /// When a stress has no root, which no finite input causes.
    pub fn friction_at(&mut self, rise: f64) -> Result<[f64; 2], FrictionError> {
        self.friction_beside(rise, &mut [])
    }

    /// [`friction_at`](Self::friction_at), with the stresses of `others` between the same walls: points that are sheared together
    /// fill the lanes of a vector.
    ///
    /// # Errors
    /// As [`friction_at`](Self::friction_at).
    pub fn friction_beside(
        &mut self,
        rise: f64,
        others: &mut [ShearedPoint],
    ) -> Result<[f64; 2], FrictionError> {
        cite!("Limiting-shear");
        cite!("Larsson-Andersson");
        cite!("Alpha-T");
        let warmer = rise - self.last_rise;
        self.last_rise = rise;
        for node in &mut self.nodes {
            let start = |[before, slope]: [f64; 2]| before + slope * warmer;
            node.at.start = node.stress().map(start);
        }
        let nodes = self.nodes.iter_mut().map(|node| &mut node.at);
        let points = nodes.chain(others);
        self.rheology.shear(points, self.bulk + rise)?;
        let mut sum = [0.0, 0.0];
        for node in &mut self.nodes {
            node.is_known = true;
            let [stress, slope] = node.at.stress;
            sum[0] += node.weight * stress;
            sum[1] += node.weight * slope;
        }
        Ok(sum)
    }

    /// Film friction where all heat of the contact comes from the film itself.
    ///
    /// # Errors
    /// As [`friction_at`](Self::friction_at).
    pub fn solve(&mut self) -> Result<Checked<FilmFrictionSolution>, FrictionError> {
        // From scratch, so that the result does not depend on earlier evaluations.
        for node in &mut self.nodes {
            node.is_known = false;
        }
        let [cold, slope] = self.friction_at(0.0)?;
        let c = self.rise_per_friction;
        let evidence = if c == 0.0 || cold == 0.0 {
            Solved {
                value: cold,
                residual: 0.0,
                iterations: 1,
            }
        } else {
            let mut failed = None;
            // Friction rises with the temperature where the limiting stress does.
            let highest = if slope > 0.0 { 2.0 * cold } else { cold };
            let root = newton_root(
                |mu| match self.friction_at(c * mu) {
                    Ok([friction, slope]) => (mu - friction, 1.0 - c * slope),
                    Err(error) => {
                        failed = Some(error);
                        (f64::NAN, 1.0)
                    }
                },
                [0.0, highest],
                cold / (1.0 - c * slope),
                TEMPERATURE_TOLERANCE,
            );
            match (root, failed) {
                (_, Some(error)) => return Err(error),
                (Ok(root), None) => root,
                (Err(source), None) => {
                    return Err(FrictionError::no_root("film friction", source));
                }
            }
        };
        Ok(Checked {
            value: self.conclude(evidence),
            outside: self.outside.clone(),
        })
    }

    /// The solution, within the tolerance of the last evaluation, from which the slopes lead to it.
    fn conclude(&self, evidence: Solved) -> FilmFrictionSolution {
        let mu = evidence.value;
        let rise = self.surface_rise(mu);
        let warmer = rise - self.last_rise;
        let (mut largest, mut mean, mut limited, mut weights) = (0.0_f64, 0.0, 0.0, 0.0);
        for node in &self.nodes {
            let point = &node.at.point;
            let stress = (node.stress()).map_or(0.0, |[stress, slope]| stress + slope * warmer);
            let film_rise = point.heating() * stress;
            let load = node.weight * point.pressure();
            let limit = self
                .rheology
                .limiting_stress(point, self.bulk + rise + film_rise);
            largest = largest.max(film_rise);
            mean += load * film_rise;
            weights += load;
            limited += if stress > LIMITED * limit { load } else { 0.0 };
        }
        FilmFrictionSolution {
            coefficient: mu,
            mean_stress: Pressure::from_si(mu * self.load / self.area),
            surface_rise: rise,
            largest_film_rise: largest,
            mean_film_rise: mean / weights,
            limited_share: limited / weights,
            half_width: Length::from_si(self.half_width),
            max_pressure: Pressure::from_si(self.max_pressure),
            evidence,
        }
    }

    /// Whether the film is heated.
    #[must_use]
    pub fn heat(&self) -> FilmHeat {
        self.heat
    }
}

/// Parts of a rippled film that are taken together, as integrals over their area.
#[derive(Debug, Clone, Copy, Default)]
struct Group {
    /// ∫ p
    load: f64,
    /// ∫ p²
    square: f64,
    /// ∫ p ln h
    log_film: f64,
}

/// Groups of equal load of the parts of a film, with ln of their thickness, at a place with a mean pressure, whose ripple is `scale`
/// times their p′.
fn groups(mean: f64, scale: f64, parts: &[FilmRipple], logs: &[f64]) -> [Group; GROUPS] {
    let rippled = |part: &FilmRipple| mean + scale * part.pressure;
    let total: f64 = parts.iter().map(|part| part.area).sum();
    // From the highest pressure on, as many parts as are above zero with the pressure c that leaves them the whole load.
    let (mut area, mut load, mut offset, mut first) = (0.0, 0.0, 0.0, parts.len());
    for (k, part) in parts.iter().enumerate().rev() {
        area += part.area;
        load += part.area * rippled(part);
        let c = (mean * total - load) / area;
        if rippled(part) + c <= 0.0 {
            break;
        }
        (offset, first) = (c, k);
    }
    let each = mean * total / GROUPS as f64;
    let mut groups = [Group::default(); GROUPS];
    let (mut k, mut room) = (0, each);
    for (part, log_film) in parts.iter().zip(logs).skip(first) {
        let pressure = rippled(part) + offset;
        let mut rest = part.area * pressure;
        while rest > 0.0 {
            let is_last = k + 1 == GROUPS;
            let taken = if is_last { rest } else { rest.min(room) };
            groups[k].load += taken;
            groups[k].square += taken * pressure;
            groups[k].log_film += taken * log_film;
            rest -= taken;
            room -= taken;
            if room <= 0.0 && !is_last {
                k += 1;
                room = each;
            }
        }
    }
    groups
}

/// Pressure, and stress with its slope, of each group at a place of the film that was sheared last.
type NearStresses = [[f64; 3]; GROUPS];

/// Stresses of `nodes` and their slopes; `None` before they are sheared.
fn near_stresses(nodes: &[Node]) -> Option<NearStresses> {
    let mut known = [[0.0; 3]; GROUPS];
    for (known, node) in known.iter_mut().zip(nodes) {
        let [stress, slope] = node.stress()?;
        *known = [node.at.point.pressure(), stress, slope];
    }
    Some(known)
}

/// Start for the stress of a node at another pressure with its slope, on the line through two groups of the film sheared last;
/// `None` where that is not above zero.
fn guess(before: &NearStresses, pressure: f64) -> Option<[f64; 2]> {
    let inner = before[1..GROUPS - 1].iter();
    let k = inner.take_while(|[p, ..]| *p < pressure).count();
    let ([p, stress, slope], [p_next, next, _]) = (before[k], before[k + 1]);
    let by_pressure = if p_next > p {
        (next - stress) / (p_next - p)
    } else {
        0.0
    };
    let found = stress + by_pressure * (pressure - p);
    (found > 0.0).then_some([found, slope])
}

fn require_share(share: f64) -> Result<(), FrictionError> {
    let rule = "must be above 0 and at most 1";
    let fits = share > 0.0 && share <= 1.0;
    DomainError::require(fits, "share of the film", share, "-", rule)?;
    Ok(())
}

/// The point of a film at a pressure, a sliding speed and a film thickness.
fn point(
    rheology: &FilmRheology,
    heat: FilmHeat,
    [pressure, sliding, film]: [f64; 3],
) -> FilmPoint {
    let point = rheology.film_point(pressure, sliding, film);
    match heat {
        FilmHeat::FilmAndSurfaces => point,
        FilmHeat::Isothermal => point.isothermal(),
    }
}

/// Rise of the mean surface temperature in the contact per friction coefficient \[K\].
///
/// ```text
/// T_s − T₀ = C μ w V_s/( (B₁ √u₁ + B₂ √u₂) √(2a) ),  u_i ≥ 2 κ_i/a         [Surface-heat]
/// ```
fn surface_rise_per_friction(
    load: f64,
    speeds: [f64; 2],
    half_width: f64,
    bodies: &[Material; 2],
) -> Result<f64, FrictionError> {
    cite!("Surface-heat");
    let mut conduction = 0.0;
    for (u, body) in speeds.iter().zip(bodies) {
        let k = DomainError::positive("conductivity", body.conductivity)?;
        let rho = DomainError::positive("density", body.density)?;
        let c = DomainError::positive("heat capacity", body.heat_capacity)?;
        let slowest = 2.0 * k / (rho * c) / half_width;
        conduction += (k * rho * c).sqrt() * u.abs().max(slowest).sqrt();
    }
    let sliding = (speeds[0] - speeds[1]).abs();
    Ok(MEAN_FLASH * load * sliding / (conduction * (2.0 * half_width).sqrt()))
}

/// Friction of the smooth film of a line contact.
///
/// # Errors
/// As [`LoadedFilm::new`].
///
/// ```
/// use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
/// use asperity_core::{line_contact::LineContact, material::Material};
/// use asperity_tribo_friction::{FilmLineContact, FilmSettings, film_friction::solve};
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "1500 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// let oil = LubricantInput {
///     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
/// }.resolve("90 °C".parse()?)?;
/// let rheology = FilmRheology::new(&oil, BaseOil::Mineral)?;
/// let line = LineContact {
///     load: "300 N/mm".parse()?, radius: "9 mm".parse()?, modulus: "115.385 GPa".parse()?,
///     speeds: ["4.6 m/s".parse()?, "3.4 m/s".parse()?], bodies: [steel, steel],
/// };
/// let contact = FilmLineContact { line, film: "0.26004 um".parse()?, temperature: "90 °C".parse()? };
/// let friction = solve(&rheology, &contact, FilmSettings::default())?;
/// assert!((friction.value.coefficient - 0.0351).abs() < 5e-5);
/// assert!(friction.outside.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    rheology: &FilmRheology,
    contact: &FilmLineContact,
    settings: FilmSettings,
) -> Result<Checked<FilmFrictionSolution>, FrictionError> {
    LoadedFilm::new(rheology, contact, settings)?.solve()
}
