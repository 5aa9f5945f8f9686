//! The draws that every case shares.

use std::borrow::Cow;
use std::sync::OnceLock;

use asperity_core::cite;
use asperity_core::numerics::{standard_normal_below, standard_normal_quantile};
use serde::{Deserialize, Serialize};

use crate::hypercube::permutation;
use asperity_case::case::UncertainParameter;

/// Number of draws: with 4096 the ends of the interval of the ground e-drive differ by 2 % between seeds, and the error
/// falls with the square root of the number.
pub(crate) const DRAWS: usize = 16_384;

/// Share of each tail of a constant that is not drawn.
const CUT: f64 = 0.005;
/// Seed of the draws that all flanks share; the draws of flanks number k have the next seeds.
const SEED: u64 = 3;

/// One draw of everything that is uncertain: standard normal where not said otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Draw {
    /// Constants, in the order of [`UncertainParameter::ALL`].
    pub constants: [f64; UncertainParameter::ALL.len()],
    /// β_i in its range, 0 to 1.
    pub inner_boundary: f64,
    /// Weight of the bias of the model, 0 to 1.
    pub weight: f64,
    /// Rolling loss.
    pub rolling: f64,
    /// Tip relief over the approach of the teeth, 0 to 1.
    pub relief: f64,
    /// Length of the tip relief in its range, 0 to 1.
    pub length: f64,
    /// Power of the ratio of loss factors.
    pub power: f64,
    /// Error of the law of film friction whose constants traction curves state.
    pub film_law: f64,
    /// Law of pressure where traction curves do not decide it, 0 to 1.
    pub pressure_law: f64,
    /// Way from the loss at the lay of the case to that at the largest lay that is confirmed, 0 to 1.
    pub far_lay: f64,
    /// Way from the held thermal reduction to the printed one, 0 to 1.
    pub held_thermal: f64,
    /// Gap that the computed flow supplies to patches.
    pub patch_gap: f64,
    /// Way from the loss by the computed flow of patches to that by the flow of lines, 0 to 1.
    pub patch_law: f64,
    /// Its part by the flanks.
    pub of_flanks: FlankDraw,
}

/// The part of a draw that differs from flanks to other flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlankDraw {
    /// Error of the model.
    pub model: f64,
    /// Sampling of the flanks.
    pub sampling: f64,
    /// Place of placed traces, 0 to 1.
    pub place: f64,
    /// Form of surrogates.
    pub form: f64,
}

impl Draw {
    /// The run: medians, and no bias of the model.
    pub const fn medians() -> Self {
        Self {
            constants: [0.0; UncertainParameter::ALL.len()],
            inner_boundary: 0.5,
            weight: 0.0,
            rolling: 0.0,
            relief: 0.5,
            length: 0.5,
            power: 0.0,
            film_law: 0.0,
            pressure_law: 1.0,
            far_lay: 0.0,
            held_thermal: 0.0,
            patch_gap: 0.0,
            patch_law: 0.0,
            of_flanks: FlankDraw {
                model: 0.0,
                sampling: 0.0,
                place: 0.5,
                form: 0.0,
            },
        }
    }
}

/// The draws that all flanks share, with the flanks of the run.
pub fn shared_draws() -> impl Iterator<Item = Draw> {
    static SHARED: OnceLock<Vec<Draw>> = OnceLock::new();
    once(&SHARED, || draws(SEED)).iter().copied()
}

/// The draws of a seed, each axis in the strata of the stream of its name: another axis moves none of the others.
fn draws(seed: u64) -> Vec<Draw> {
    let (cut, normal) = (cut_normal(), normal());
    let axis = |name: &str| permutation(DRAWS, seed, name);
    let constants = UncertainParameter::ALL.map(|kind| axis(&format!("{kind:?}")));
    let normals = ["rolling", "power", "film_law", "patch_gap"].map(axis);
    let places = [
        "inner_boundary",
        "weight",
        "relief",
        "length",
        "pressure_law",
        "far_lay",
        "held_thermal",
        "patch_law",
    ];
    let places = places.map(axis);
    let draw = |j: usize| {
        let [rolling, power, film_law, patch_gap] = normals.each_ref().map(|axis| normal[axis[j]]);
        let [
            inner_boundary,
            weight,
            relief,
            length,
            pressure_law,
            far_lay,
            held_thermal,
            patch_law,
        ] = places.each_ref().map(|axis| place(axis[j]));
        Draw {
            constants: constants.each_ref().map(|axis| cut[axis[j]]),
            inner_boundary,
            weight,
            rolling,
            relief,
            length,
            power,
            film_law,
            pressure_law,
            far_lay,
            held_thermal,
            patch_gap,
            patch_law,
            ..Draw::medians()
        }
    };
    (0..DRAWS).map(draw).collect()
}

/// Draws of a mesh in the comparison with another one: shared as far as a constant belongs to the same thing, of a second set for the
/// rest.
///
/// ```text
/// z = ρ z₀ + √(1 − ρ²) z₁;  of a constant that the other run states: z = √(1 − ρ²) z₀             [Common-draw]
/// ```
///
/// z₀, z₁: standard normal draws of the first and the second set; ρ: 1 of the same thing, 0 of another. A place u between 0 and 1
/// has z = Φ⁻¹(u).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Common {
    /// Number of the flanks, which have the error of the model and the sampling.
    pub flanks: usize,
    /// ρ of each constant.
    pub constants: [f64; UncertainParameter::ALL.len()],
    /// Whether the other run states the constant: what both have in common of it is known.
    pub stated: [bool; UncertainParameter::ALL.len()],
    /// ρ of the error of the model on the same flanks.
    pub model: f64,
    /// ρ of the sampling of the same flanks.
    pub sampling: f64,
    /// ρ of the unknown tip relief.
    pub relief: f64,
    /// Whether the error of the film law belongs to the same traction curves.
    pub curves: bool,
}

/// Flanks with their number, with everything else in common.
impl From<usize> for Common {
    fn from(flanks: usize) -> Self {
        Self {
            flanks,
            constants: [1.0; UncertainParameter::ALL.len()],
            stated: [false; UncertainParameter::ALL.len()],
            model: 1.0,
            sampling: 1.0,
            relief: 1.0,
            curves: true,
        }
    }
}

impl Common {
    /// All draws of a mesh.
    pub fn draws(self) -> impl Iterator<Item = Draw> {
        let other = (self != self.flanks.into()).then(second_set);
        let all = shared_draws().zip(flank_draws(self.flanks)).enumerate();
        all.map(move |(j, (draw, of_flanks))| {
            let draw = Draw { of_flanks, ..draw };
            match other {
                Some(other) => self.mixed(draw, &other[j]),
                None => draw,
            }
        })
    }

    /// A draw of the first set, with the draw of the second set where things differ.
    fn mixed(&self, mut draw: Draw, other: &Draw) -> Draw {
        cite!("Common-draw");
        let own = |rho: f64| (1.0 - rho * rho).sqrt();
        let mix = |rho: f64, of: &mut f64, other: f64| {
            if rho < 1.0 {
                *of = rho * *of + own(rho) * other;
            }
        };
        let mix_places = |rho: f64, of: &mut f64, other: f64| {
            if rho < 1.0 {
                let mut z = standard_normal_quantile(*of);
                mix(rho, &mut z, standard_normal_quantile(other));
                *of = standard_normal_below(z);
            }
        };
        for (k, (of, other)) in draw.constants.iter_mut().zip(other.constants).enumerate() {
            if self.stated[k] {
                *of *= own(self.constants[k])
            } else {
                mix(self.constants[k], of, other)
            }
        }
        let (flanks, of_others) = (&mut draw.of_flanks, &other.of_flanks);
        mix(self.model, &mut flanks.model, of_others.model);
        mix(self.sampling, &mut flanks.sampling, of_others.sampling);
        mix_places(self.relief, &mut draw.relief, other.relief);
        mix_places(self.relief, &mut draw.length, other.length);
        if !self.curves {
            (draw.film_law, draw.pressure_law) = (other.film_law, other.pressure_law);
        }
        draw
    }
}

/// The second set of draws.
fn second_set() -> &'static [Draw] {
    /// Beyond the seeds of all flanks.
    const SECOND_SEED: u64 = 1 << 32;
    static SECOND_SET: OnceLock<Vec<Draw>> = OnceLock::new();
    once(&SECOND_SET, || {
        let of_flanks = flank_draws((SECOND_SEED + 1) as usize);
        let both = draws(SECOND_SEED).into_iter().zip(of_flanks);
        both.map(|(draw, of_flanks)| Draw { of_flanks, ..draw })
            .collect()
    })
}

/// The draws of flanks number `flanks`.
pub fn flank_draws(flanks: usize) -> impl Iterator<Item = FlankDraw> {
    static FIRST_FLANKS: OnceLock<Vec<FlankDraw>> = OnceLock::new();
    let drawn = || -> Vec<FlankDraw> {
        let (seed, normal) = (SEED + 1 + flanks as u64, normal());
        let axis = |name: &str| permutation(DRAWS, seed, name);
        let [model, sampling, misplaced, form] = ["model", "sampling", "place", "form"].map(axis);
        let draw = |j: usize| FlankDraw {
            model: normal[model[j]],
            sampling: normal[sampling[j]],
            place: place(misplaced[j]),
            form: normal[form[j]],
        };
        (0..DRAWS).map(draw).collect()
    };
    // A run takes the draws of its own flanks for every component of its uncertainty.
    let drawn = match flanks {
        0 => Cow::Borrowed(once(&FIRST_FLANKS, drawn)),
        _ => Cow::Owned(drawn()),
    };
    (0..DRAWS).map(move |j| drawn[j])
}

/// Draws that are made once; who takes them cites their equation, whether they were made before or not.
fn once<T>(stored: &'static OnceLock<Vec<T>>, make: impl FnOnce() -> Vec<T>) -> &'static [T] {
    cite!("Latin-hypercube");
    stored.get_or_init(make)
}

/// The middle of a stratum.
fn place(stratum: usize) -> f64 {
    (stratum as f64 + 0.5) / DRAWS as f64
}

/// Standard normal quantiles of the strata.
fn normal() -> &'static [f64] {
    static STRATA: OnceLock<Vec<f64>> = OnceLock::new();
    STRATA.get_or_init(|| {
        (0..DRAWS)
            .map(|k| standard_normal_quantile(place(k)))
            .collect()
    })
}

/// The same without the outermost 0.5 % of either side.
fn cut_normal() -> &'static [f64] {
    static STRATA: OnceLock<Vec<f64>> = OnceLock::new();
    let cut = |k: usize| CUT + (1.0 - 2.0 * CUT) * place(k);
    STRATA.get_or_init(|| {
        (0..DRAWS)
            .map(|k| standard_normal_quantile(cut(k)))
            .collect()
    })
}
