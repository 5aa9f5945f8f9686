//! Stored record of transient mixed lubrication.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ | share of the load on films not above the solid film | - |
//! | b | share of the load on the boundary layer | - |
//! | μ, μ_s, μ_τ | friction with boundary friction that fades above contact, with boundary friction below the solid film, of the film only | - |
//! | μ_b | boundary friction | - |
//! | μ_f, μ_l | film friction above and below the solid film | - |

use asperity_core::cite;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl::{FrictionLaw, Record, RecordMean, Solved};
use serde::{Deserialize, Serialize};

use crate::reference_solution::ReferenceContact;

/// Points at which friction is summed over the Hertz pressure.
const HERTZ_POINTS: usize = 200;
/// Solid share that counts as zero \[-\].
const NO_SHARE: f64 = 1e-9;

/// Time means of a record of transient mixed lubrication, with the evidence of its convergence.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PathRecord {
    /// Share φ of the load at films no thicker than the solid film.
    pub solid_share: RecordMean,
    /// Share of the load at films no thicker than 50 nm.
    pub share_below_50_nm: RecordMean,
    /// Share b of the load on the boundary layer.
    pub boundary_share: RecordMean,
    /// Mean gap within the half-width \[m\].
    pub mean_film: RecordMean,
    /// Central film of smooth flanks.
    pub smooth_film: Length,
    /// Friction with the weight min(1, e^(−(h − H_b)/h_b)) of the boundary friction, isothermal.
    pub friction: RecordMean,
    /// Friction with the weight e^(−h/h_b), isothermal: the weight of the solved load share.
    pub graded_friction: RecordMean,
    /// Friction with the whole boundary friction below the solid film, isothermal.
    pub stepped_friction: RecordMean,
    /// Film friction of the load above the solid film, isothermal.
    pub film_friction: f64,
    /// Film friction of the load below it, isothermal.
    pub lubricated_friction: f64,
    /// Friction of a smooth film under the Hertz pressure by the same law.
    pub smooth_friction: f64,
    /// Time mean of the largest pressure \[Pa\].
    pub mean_max_pressure: RecordMean,
    /// Largest pressure of all steps.
    pub max_pressure: Pressure,
    /// Standard deviation of the roughness after its attenuation in the contact.
    pub attenuated_roughness: Length,
    /// Travel in half-widths.
    pub travel: f64,
    /// Positions of the nodes relative to the half-width a.
    pub x: Vec<f64>,
    /// Time mean of the pressure at the nodes relative to p₀.
    pub pressure: Vec<f64>,
    /// Time mean of the film at the nodes \[m\].
    pub film: Vec<f64>,
    /// Largest load error of a step.
    pub load_error: f64,
    /// Time steps.
    pub steps: usize,
    /// Steps repeated at half their length.
    pub steps_cut: usize,
    /// Steps with a node held in contact.
    pub loose_steps: usize,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// GMRES iterations.
    pub gmres_iterations: usize,
    /// Tags of the equations used.
    pub(super) tags: Vec<String>,
}

impl PathRecord {
    /// Selects the values to store from `solved`, the record of `contact` with a friction law.
    pub(super) fn new(
        contact: &ReferenceContact,
        solved: &Solved<Record>,
        law: &FrictionLaw,
    ) -> Self {
        let (record, evidence) = (&solved.value, &solved.evidence);
        let friction = record.friction.unwrap_or_default();
        let [mu_f, mu_l] = parts(
            record.solid_share.mean,
            [friction.shifted, friction.stepped, friction.film].map(|part| part.mean),
            friction.boundary_share.mean,
            law.boundary_friction,
        );
        let below_50 = record.load_below.iter().find(|below| {
            let nanometres = below.film.si() * 1e9;
            (nanometres - 50.0).abs() < 1e-6
        });
        let scales = &record.scales;
        Self {
            solid_share: record.solid_share,
            share_below_50_nm: below_50.map_or(record.solid_share, |below| below.share),
            boundary_share: friction.boundary_share,
            mean_film: record.mean_film,
            smooth_film: record.smooth_film,
            friction: friction.shifted,
            graded_friction: friction.graded,
            stepped_friction: friction.stepped,
            film_friction: mu_f,
            lubricated_friction: mu_l,
            smooth_friction: smooth_friction(contact, law, record.smooth_film),
            mean_max_pressure: record.mean_max_pressure,
            max_pressure: record.max_pressure,
            attenuated_roughness: contact.attenuated_roughness,
            travel: record.travel,
            x: record.x.clone(),
            pressure: record.mean_pressure.clone(),
            film: record
                .mean_film_on_nodes
                .iter()
                .map(|film| scales.film_length(*film).si())
                .collect(),
            load_error: evidence.load_error,
            steps: evidence.steps,
            steps_cut: evidence.steps_cut,
            loose_steps: evidence.loose_steps,
            newton_iterations: evidence.newton_iterations,
            gmres_iterations: evidence.gmres_iterations,
            tags: Vec::new(),
        }
    }

    /// Share of the solid load on the boundary layer in the expectation over the two rules of boundary friction, the rule that
    /// falls with the film and the whole one below the solid film.
    pub(super) fn expected_boundary_part(&self) -> f64 {
        if self.solid_share.mean > NO_SHARE {
            0.5 * (self.falling_boundary_part() + 1.0)
        } else {
            0.0
        }
    }

    /// Share of the solid load on the boundary layer whose friction falls with the film, at most 1.
    fn falling_boundary_part(&self) -> f64 {
        let phi = self.solid_share.mean;
        if phi > NO_SHARE {
            (self.boundary_share.mean / phi).min(1.0)
        } else {
            0.0
        }
    }

    /// Friction with its film part times `heat`.
    pub(super) fn hot_friction(&self, boundary_friction: f64, heat: f64) -> f64 {
        let boundary = self.falling_boundary_part() * self.solid_share.mean * boundary_friction;
        boundary + heat * (self.friction.mean - boundary)
    }

    /// Friction with its film part times `heat` and the whole boundary friction below the solid film.
    pub(super) fn hot_stepped_friction(&self, boundary_friction: f64, heat: f64) -> f64 {
        let boundary = self.solid_share.mean * boundary_friction;
        boundary + heat * (self.stepped_friction.mean - boundary)
    }

    /// Film friction of the load above the solid film relative to the smooth film, in the expectation over the two rules of
    /// boundary friction, so that the parts make up the mean of the two frictions of the record:
    ///
    /// ```text
    /// (1 − φ) μ_f = (μ + μ_s)/2 − (φ − b̄) μ_l − b̄ μ_b,  b̄ = (b + φ)/2                    [Record-expected]
    /// ```
    pub(super) fn expected_film_ratio(&self, boundary_friction: f64) -> f64 {
        cite!("Record-expected");
        let phi = self.solid_share.mean;
        if self.smooth_friction <= 0.0 {
            return 1.0;
        }
        let whole = if phi < 1.0 {
            (self.stepped_friction.mean - phi * boundary_friction) / (1.0 - phi)
        } else {
            self.film_friction
        };
        0.5 * (self.film_friction + whole) / self.smooth_friction
    }
}

/// Film friction above and below the solid film, so that the parts make up the friction of the record.
///
/// ```text
/// μ_l = (μ_τ − (μ_s − μ_b·φ))/φ,  μ = (1 − φ)·μ_f + (φ − b)·μ_l + b·μ_b,  b ≤ φ    [Record-friction]
/// ```
fn parts(phi: f64, [mu, mu_s, mu_tau]: [f64; 3], b: f64, mu_b: f64) -> [f64; 2] {
    cite!("Record-friction");
    let mu_l = if phi > NO_SHARE {
        (mu_tau - (mu_s - mu_b * phi)) / phi
    } else {
        mu_tau
    };
    let b = b.min(phi);
    let mu_f = if phi < 1.0 {
        (mu - (phi - b) * mu_l - b * mu_b) / (1.0 - phi)
    } else {
        mu_tau
    };
    [mu_f, mu_l]
}

/// Friction coefficient of a film of one thickness under the Hertz pressure.
fn smooth_friction(contact: &ReferenceContact, law: &FrictionLaw, film: Length) -> f64 {
    let line = &contact.rough.contact;
    let rate = (line.speed_1 - line.speed_2).si().abs() / film.si();
    let p_0 = contact.position.hertz.max_pressure.si();
    let (mut stress, mut load) = (0.0, 0.0);
    for k in 0..HERTZ_POINTS {
        let x = (k as f64 + 0.5) / HERTZ_POINTS as f64;
        let pressure = p_0 * (1.0 - x * x).sqrt();
        stress += law.film_stress(pressure, rate);
        load += pressure;
    }
    stress / load
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_expected_rule_is_the_mean_of_both() {
        let exact = |mean: f64| RecordMean {
            mean,
            ..RecordMean::default()
        };
        // Half of the solid load on a boundary layer of 0.1, or all of it; the film has 0.02 above and 0.04 below.
        let (phi, b, mu_b) = (0.2, 0.1, 0.1);
        let [mu_f, mu_l] = [0.02, 0.04];
        let (above, below) = ((1.0 - phi) * mu_f, phi * mu_l);
        let (falling, whole) = (above + 0.5 * below + b * mu_b, above + phi * mu_b);
        let record = PathRecord {
            solid_share: exact(phi),
            boundary_share: exact(b),
            friction: exact(falling),
            stepped_friction: exact(whole),
            film_friction: mu_f,
            lubricated_friction: mu_l,
            smooth_friction: 0.025,
            ..PathRecord::default()
        };
        let boundary = record.expected_boundary_part();
        assert!((boundary - 0.75).abs() < 1e-15);
        let film = 0.025 * record.expected_film_ratio(mu_b);
        let friction = (1.0 - phi) * film + phi * ((1.0 - boundary) * mu_l + boundary * mu_b);
        assert!((friction - 0.5 * (falling + whole)).abs() < 1e-15);
        // Where the weight of the boundary friction reaches above the solid film, the film has what is left.
        let wide = PathRecord {
            boundary_share: exact(0.16),
            friction: exact(falling + 0.01),
            ..record
        };
        let [film_friction, _] = parts(phi, [falling + 0.01, whole, above + below], 0.16, mu_b);
        let wide = PathRecord {
            film_friction,
            ..wide
        };
        let boundary = wide.expected_boundary_part();
        let film = 0.025 * wide.expected_film_ratio(mu_b);
        let friction = (1.0 - phi) * film + phi * ((1.0 - boundary) * mu_l + boundary * mu_b);
        assert!((friction - 0.5 * (falling + 0.01 + whole)).abs() < 1e-15);
    }

    #[test]
    fn friction_of_a_record_is_the_sum_of_its_parts() {
        // A fifth of the load is below the solid film, where the film has 0.04; elsewhere it has 0.02. Half of that fifth is
        // on a boundary layer of 0.1.
        let (phi, b, mu_b) = (0.2, 0.1, 0.1);
        let (above, below) = (0.8 * 0.02, 0.2 * 0.04);
        let mu = above + 0.5 * below + b * mu_b;
        let [mu_f, mu_l] = parts(phi, [mu, above + phi * mu_b, above + below], b, mu_b);
        assert!((mu_f - 0.02).abs() < 1e-15 && (mu_l - 0.04).abs() < 1e-15);
        let whole = (1.0 - phi) * mu_f + (phi - b) * mu_l + b * mu_b;
        assert!((whole - mu).abs() < 1e-15);
        assert_eq!(parts(0.0, [0.03, 0.03, 0.03], 0.0, 0.1), [0.03, 0.03]);
        assert_eq!(parts(1.0, [0.1, 0.1, 0.04], 1.0, 0.1)[1], 0.04);
    }
}
