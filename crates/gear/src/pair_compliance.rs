//! Compliance of a pair of teeth along the path of contact, tabulated for the load map.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | q_b | teeth and foundations of both gears, over C_M | m²/N |
//! | q_H | flattening of the flanks, over C_M | m²/N |
//! | C_M | factor of theory to measurement | - |
//! | ξ | profile coordinate, 0 at A and ε_α at E | - |
//!
//! q_b is interpolated from 25 Chebyshev points with an error of 5e-7 (5e-4 where a load line passes below a root
//! chord) and tabulated at even steps.

use asperity_core::material::Material;
use serde::{Deserialize, Serialize};

use crate::chebyshev::{Chebyshev, SmoothTable};
use crate::error::{Gear, GearError};
use crate::hertz_compliance::HertzCompliance;
use crate::pair::GearPair;
use crate::tooth_compliance::ToothCompliance;
use crate::tooth_outline::{Outline, RootForm, ToothFlank};

/// Chebyshev points of a compliance along the path.
const TABLE_POINTS: usize = 25;

/// Source of the tooth stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StiffnessSource {
    /// Bending, foundation and flattening according to Weber and Banaschek.
    WeberBanaschek,
    /// The polynomial of ISO 6336-1, as stated in the case.
    Iso,
    /// The polynomial of ISO 6336-1, because the root outline of this gear cannot be constructed.
    IsoForRootForm(Gear),
}

/// q_b and q_H along the path.
#[derive(Debug, Clone)]
pub(crate) struct PairCompliance {
    pub(crate) source: StiffnessSource,
    bending: SmoothTable,
    flattening: ContactFlattening,
}

/// Dependence of q_H on the load.
#[derive(Debug, Clone)]
enum ContactFlattening {
    /// q_H(f) with its load-independent part tabulated.
    Hertz {
        shape: SmoothTable,
        /// 1/(π E*).
        sum: f64,
        /// 1/(π E* C_M).
        slope: f64,
    },
    /// A constant.
    Constant(f64),
}

impl PairCompliance {
    /// Compliance by Weber and Banaschek, or by ISO 6336-1 if a root outline cannot be constructed.
    pub(crate) fn teeth(
        pair: &GearPair,
        shift: [f64; 2],
        root: [RootForm; 2],
        materials: &[Material; 2],
        stiffness_factor: f64,
        load: f64,
    ) -> Result<Self, GearError> {
        let outline = |gear: usize, name| {
            Outline::new(ToothFlank::new(pair, gear, shift[gear]), root[gear], name)
        };
        let outlines = match (outline(0, Gear::Pinion), outline(1, Gear::Wheel)) {
            (Ok(pinion), Ok(wheel)) => [pinion, wheel],
            (Err(GearError::RootForm { gear, .. }), _)
            | (_, Err(GearError::RootForm { gear, .. })) => {
                let mut iso = Self::iso(pair, shift, materials, stiffness_factor, load)?;
                iso.source = StiffnessSource::IsoForRootForm(gear);
                return Ok(iso);
            }
            (Err(error), _) | (_, Err(error)) => return Err(error),
        };
        require_involute_contact(pair, &outlines)?;
        let [pinion, wheel] = outlines;
        let teeth = [
            ToothCompliance::new(pinion, &materials[0]),
            ToothCompliance::new(wheel, &materials[1]),
        ];
        let range = [0.0, pair.path.eps_alpha];
        let bending = Chebyshev::fit(range, TABLE_POINTS, |xi| {
            let [rho1, rho2] = rolls(pair, xi);
            let q = teeth[0].total(rho1) + teeth[1].total(rho2);
            positive(q / stiffness_factor)
        })?;
        let hertz = HertzCompliance::new(materials)?;
        let shape = Chebyshev::fit(range, TABLE_POINTS, |xi| {
            let depth = depths(pair, [&teeth[0].outline.flank, &teeth[1].outline.flank], xi);
            finite(hertz.shape(depth) / stiffness_factor)
        })?;
        // The smallest value, at the ends of the path, must be positive.
        positive(hertz.at(
            depths(
                pair,
                [&teeth[0].outline.flank, &teeth[1].outline.flank],
                0.0,
            ),
            radius(pair, 0.0),
            load,
        ))?;
        Ok(Self {
            source: StiffnessSource::WeberBanaschek,
            bending: SmoothTable::new(&bending),
            flattening: ContactFlattening::Hertz {
                shape: SmoothTable::new(&shape),
                sum: hertz.sum,
                slope: hertz.sum / stiffness_factor,
            },
        })
    }

    /// Compliance by ISO 6336-1 with constant flattening, evaluated in the middle of the path at the mean load.
    pub(crate) fn iso(
        pair: &GearPair,
        shift: [f64; 2],
        materials: &[Material; 2],
        stiffness_factor: f64,
        load: f64,
    ) -> Result<Self, GearError> {
        let single = pair.iso_single_stiffness(shift)?;
        let flanks = [0, 1].map(|gear| ToothFlank::new(pair, gear, shift[gear]));
        let middle = 0.5 * pair.path.eps_alpha;
        let depth = depths(pair, [&flanks[0], &flanks[1]], middle);
        let hertz = HertzCompliance::new(materials)?.at(depth, radius(pair, middle), load);
        let range = [0.0, pair.path.eps_alpha];
        let bending = Chebyshev::fit(range, TABLE_POINTS, |xi| {
            positive((1.0 / pair.iso_stiffness_at(single, xi) - hertz) / stiffness_factor)
        })?;
        Ok(Self {
            source: StiffnessSource::Iso,
            bending: SmoothTable::new(&bending),
            flattening: ContactFlattening::Constant(hertz / stiffness_factor),
        })
    }

    /// Constant compliance, for limits with a closed form.
    #[cfg(test)]
    pub(crate) fn constant(bending: f64, flattening: f64) -> Self {
        let fit = Chebyshev::fit([0.0, 1.0], 1, |_| Ok::<_, ()>(bending));
        Self {
            source: StiffnessSource::Iso,
            bending: SmoothTable::new(&fit.unwrap()),
            flattening: ContactFlattening::Constant(flattening),
        }
    }

    /// q_b at ξ, constant beyond the ends of the path.
    pub(crate) fn bending(&self, xi: f64) -> f64 {
        self.bending.at(xi)
    }

    /// q_H at ξ under the load `load`, constant beyond the ends of the path.
    pub(crate) fn flattening(&self, pair: &GearPair, xi: f64, load: f64) -> f64 {
        match &self.flattening {
            ContactFlattening::Constant(q) => *q,
            ContactFlattening::Hertz { shape, sum, slope } => {
                let r = radius(pair, xi.clamp(0.0, pair.path.eps_alpha));
                shape.at(xi) - slope * (4.0 * load * r * sum).ln()
            }
        }
    }

    /// −dq_H/d ln f.
    pub(crate) fn slope(&self) -> f64 {
        match self.flattening {
            ContactFlattening::Constant(_) => 0.0,
            ContactFlattening::Hertz { slope, .. } => slope,
        }
    }
}

/// Roll lengths ρ_n = |ρ|/cos β_b of both flanks in the normal section.
fn rolls(pair: &GearPair, xi: f64) -> [f64; 2] {
    let s = pair.path.place(xi).si();
    let cos = pair.base_helix.si().cos();
    [s / cos, (pair.path.t1t2.si() - s).abs() / cos]
}

fn depths(pair: &GearPair, flanks: [&ToothFlank; 2], xi: f64) -> [f64; 2] {
    let rolls = rolls(pair, xi);
    [0, 1].map(|gear| flanks[gear].load(rolls[gear]).2)
}

/// Relative radius of curvature R at ξ.
pub(crate) fn radius(pair: &GearPair, xi: f64) -> f64 {
    let (s, t) = (pair.path.place(xi).si(), pair.path.t1t2.si());
    s * (t - s) / t / pair.base_helix.si().cos()
}

/// Checks that undercut ends below the lowest point of contact.
fn require_involute_contact(pair: &GearPair, outlines: &[Outline; 2]) -> Result<(), GearError> {
    let [a, e] = [rolls(pair, 0.0), rolls(pair, pair.path.eps_alpha)];
    let lowest = [a[0], e[1]];
    for (index, gear) in [Gear::Pinion, Gear::Wheel].into_iter().enumerate() {
        let outline = &outlines[index];
        if outline.undercut && outline.involute_start > lowest[index] {
            let base = outline.flank.base_radius;
            return Err(GearError::UndercutContact {
                gear,
                form_radius: outline.form_radius(),
                contact_radius: asperity_core::quantity::Length::from_si(base.hypot(lowest[index])),
            });
        }
    }
    Ok(())
}

fn positive(value: f64) -> Result<f64, GearError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(GearError::tooth_compliance(value))
    }
}

fn finite(value: f64) -> Result<f64, GearError> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(GearError::tooth_compliance(value))
    }
}
