//! Compliance of a tooth and its foundation according to Weber and Banaschek.
//!
//! Source: C. Weber and K. Banaschek 1953, the base of ISO 6336-1 and DIN 3990 (18/π derived again
//! by references/small_constants.py; compliance checked against the stiffness polynomial of ISO 6336-1 and finite elements).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | q₁ | bending, shear and compression of the tooth, per metre of contact line | m²/N |
//! | q₂ | compliance of the half-plane below the root chord | m²/N |
//! | L | height η of the load line on the centre line of the tooth | m |
//! | s_f | root chord | m |
//! | a′ | angle of the load line | rad |
//! | X(η) | half thickness of the tooth | m |
//!
//! Limits: prismatic teeth on a massive body; for a load line below the root chord (L < 0) q₁ = 0, and q₂ is evaluated
//! with the negative L.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use asperity_core::cite;
use asperity_core::material::Material;

use crate::quadrature::gauss_legendre;
use crate::tooth_outline::{LoadLine, Outline};

/// Points on the involute between the root and the load line.
const INVOLUTE_ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(15);

/// Compliance of one tooth of a gear.
#[derive(Debug, Clone)]
pub(crate) struct ToothCompliance {
    pub(crate) outline: Outline,
    young: f64,
    poisson: f64,
    rule: Vec<(f64, f64)>,
}

impl ToothCompliance {
    pub(crate) fn new(outline: Outline, material: &Material) -> Self {
        cite!("Compliance-1");
        cite!("Compliance-2");
        Self {
            outline,
            young: material.young.si(),
            poisson: material.poisson,
            rule: gauss_legendre(INVOLUTE_ORDER),
        }
    }

    /// q₁ + q₂ for a contact at the roll length ρ of the virtual gear.
    pub(crate) fn total(&self, roll: f64) -> f64 {
        let load = self.outline.load_line(roll);
        self.bending(&load) + self.foundation(&load)
    }

    /// q₁ = cos² a′·\[12 (1 − ν²)/E·∫₀ᴸ (L − η)²/(2X)³ dη
    /// + (2.4 (1 + ν)/E + tan² a′ (1 − ν²)/E)·∫₀ᴸ dη/(2X)\]                       [Compliance-1]
    pub(crate) fn bending(&self, load: &LoadLine) -> f64 {
        let top = load.arm;
        if top <= 0.0 {
            return 0.0;
        }
        let [moment, area] = self.outline.integrate(top, &self.rule, |eta, half| {
            let width = 2.0 * half;
            [(top - eta).powi(2) / width.powi(3), 1.0 / width]
        });
        let (e, nu) = (self.young, self.poisson);
        let plane = (1.0 - nu * nu) / e;
        load.angle.cos().powi(2)
            * (12.0 * plane * moment
                + (2.4 * (1.0 + nu) / e + load.angle.tan().powi(2) * plane) * area)
    }

    /// q₂ = cos² a′ (1 − ν²)/E·\[18/π (L/s_f)² + 2 (1 − 2ν)/(1 − ν)·L/s_f
    /// + 4.8/π·(1 + (1 − ν)/2.4·tan² a′)\]                                       [Compliance-2]
    pub(crate) fn foundation(&self, load: &LoadLine) -> f64 {
        let nu = self.poisson;
        let arm = load.arm / self.outline.root_chord;
        load.angle.cos().powi(2) * (1.0 - nu * nu) / self.young
            * (18.0 / PI * arm * arm
                + 2.0 * (1.0 - 2.0 * nu) / (1.0 - nu) * arm
                + 4.8 / PI * (1.0 + (1.0 - nu) / 2.4 * load.angle.tan().powi(2)))
    }
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;
    use crate::error::{Gear, GearError};
    use crate::hertz_compliance::HertzCompliance;
    use crate::input::GearPairInput;
    use crate::pair::GearPair;
    use crate::pair_compliance::radius;
    use crate::tooth_outline::{RootForm, ToothFlank};
    use asperity_core::quantity::{
        Angle, Density, Length, Pressure, SpecificHeat, ThermalConductivity,
    };

    fn steel() -> Material {
        Material {
            young: Pressure::from_si(206e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(1e9),
            density: Density::from_si(7850.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(460.0),
        }
    }

    fn golden() -> Value {
        serde_json::from_str(include_str!("../tests/golden/load_map.json")).unwrap()
    }

    fn numbers(value: &Value) -> Vec<f64> {
        let values = value.as_array().unwrap();
        values.iter().map(|value| value.as_f64().unwrap()).collect()
    }

    fn pair(row: &Value) -> GearPair {
        let two = |key: &str| -> Option<[f64; 2]> {
            row[key].as_array()?;
            numbers(&row[key]).try_into().ok()
        };
        let input = GearPairInput {
            profile_shift: Some(two("shift").unwrap_or_default()),
            tip_radius: two("tip_radius").map(|radii| radii.map(Length::from_si)),
            ..GearPairInput::standard(
                two("teeth").unwrap().map(|z| z as u32),
                Length::from_si(row["module"].as_f64().unwrap_or(1.5e-3)),
                Angle::from_si(row["helix"].as_f64().unwrap().to_radians()),
                Length::from_si(row["width"].as_f64().unwrap_or(20e-3)),
            )
        };
        if row["internal"].as_bool().unwrap_or(false) {
            GearPair::internal(&input).unwrap()
        } else {
            GearPair::new(&input).unwrap()
        }
    }

    fn tooth(pair: &GearPair, gear: usize) -> ToothCompliance {
        let flank = ToothFlank::new(pair, gear, pair.profile_shift.unwrap()[gear]);
        let outline = Outline::new(flank, RootForm::default(), Gear::Pinion).unwrap();
        ToothCompliance::new(outline, &steel())
    }

    fn rolls(pair: &GearPair, xi: f64) -> [f64; 2] {
        let (s, cos) = (pair.path.place(xi).si(), pair.base_helix.si().cos());
        [s / cos, (pair.path.t1t2.si() - s).abs() / cos]
    }

    #[track_caller]
    fn close(value: f64, expected: f64, relative: f64) {
        assert!(
            (value - expected).abs() <= relative * expected.abs(),
            "{value} is not {expected} to {relative:e}"
        );
    }

    #[test]
    fn tooth_compliances_are_those_of_an_independent_program() {
        // It integrates by trapezia between 400 points of the outline: 1e-4.
        for row in golden()["cases"].as_array().unwrap() {
            let pair = pair(row);
            for gear in 0..2 {
                let tooth = tooth(&pair, gear);
                let expected = row["bending_foundation"][gear].as_array().unwrap();
                for (xi, expected) in numbers(&row["xi"]).into_iter().zip(expected) {
                    let load = tooth.outline.load_line(rolls(&pair, xi)[gear]);
                    let parts = numbers(expected);
                    close(tooth.bending(&load), parts[0], 1e-4);
                    close(tooth.foundation(&load), parts[1], 1e-4);
                }
            }
        }
    }

    #[test]
    fn ring_teeth_have_the_compliance_of_an_independent_program() {
        for row in golden()["ring"].as_array().unwrap() {
            let pair = pair(row);
            let xi = pair.path.eps_2;
            for gear in 0..2 {
                let tooth = tooth(&pair, gear);
                let load = tooth.outline.load_line(rolls(&pair, xi)[gear]);
                let parts = numbers(&row["bending_foundation_c"][gear]);
                close(tooth.bending(&load), parts[0], 1e-4);
                close(tooth.foundation(&load), parts[1], 1e-4);
            }
        }
    }

    #[test]
    fn the_flattening_is_that_of_an_independent_program() {
        let hertz = HertzCompliance::new(&[steel(); 2]).unwrap();
        for row in golden()["cases"].as_array().unwrap() {
            let pair = pair(row);
            let teeth = [tooth(&pair, 0), tooth(&pair, 1)];
            for (k, xi) in numbers(&row["xi"]).into_iter().enumerate() {
                let rolls = rolls(&pair, xi);
                let depth = [0, 1].map(|gear| teeth[gear].outline.flank.load(rolls[gear]).2);
                let q = hertz.at(depth, radius(&pair, xi), 2e5);
                close(q, numbers(&row["hertz_200"])[k], 1e-6);
                let whole = teeth[0].total(rolls[0]) + teeth[1].total(rolls[1]) + q;
                // It takes the compliance from a table, good to 5e-4 for H951.
                let table = if row["name"] == "H951" { 5e-4 } else { 1e-4 };
                close(0.8 / whole, numbers(&row["stiffness_200"])[k], table);
            }
        }
    }

    #[test]
    fn the_stiffest_place_has_about_the_stiffness_of_iso_6336() {
        // Largest stiffness at 300 N/mm over the polynomial of the standard: within 4 % (H951 lies
        // outside of its range).
        let hertz = HertzCompliance::new(&[steel(); 2]).unwrap();
        for row in golden()["cases"].as_array().unwrap() {
            let pair = pair(row);
            let Ok(iso) = pair.iso_single_stiffness(pair.profile_shift.unwrap()) else {
                assert_eq!(row["name"], "H951");
                continue;
            };
            let teeth = [tooth(&pair, 0), tooth(&pair, 1)];
            let largest = (0..=60)
                .map(|k| {
                    let xi = pair.path.eps_alpha * f64::from(k) / 60.0;
                    let rolls = rolls(&pair, xi);
                    let depth = [0, 1].map(|gear| teeth[gear].outline.flank.load(rolls[gear]).2);
                    let q = hertz.at(depth, radius(&pair, xi), 3e5);
                    1.0 / (teeth[0].total(rolls[0]) + teeth[1].total(rolls[1]) + q)
                })
                .fold(0.0, f64::max);
            close(largest, iso, 0.04);
        }
    }

    #[test]
    fn the_fillet_meets_the_involute_with_its_slope() {
        // z 20, 30 and 60 without undercut, x from −0.05 to 0.4: the outline has no step or kink.
        for (z, x) in [(20, 0.2), (30, 0.0), (60, -0.05), (24, 0.4)] {
            let outline = outline(z, x).unwrap();
            assert!(!outline.undercut);
            let rule = gauss_legendre(INVOLUTE_ORDER);
            let h = outline.flank_height(outline.involute_start);
            let area = |top: f64| outline.integrate(top, &rule, |_, half| [half])[0];
            // The half thickness just below and just above the joint.
            let d = 1e-4 * outline.flank.module;
            let below = (area(h) - area(h - d)) / d;
            let above = (area(h + d) - area(h)) / d;
            close(below, above, 1e-3);
        }
    }

    #[test]
    fn undercut_grows_from_nothing_without_a_jump() {
        // z = 17.1 is the limit for x = 0, so z 17 is undercut by a hair and z 18 is not.
        let q = |z| {
            let outline = outline(z, 0.0).unwrap();
            let pitch_roll = outline.flank.reference_radius * outline.flank.pressure_angle.sin();
            (
                outline.undercut,
                ToothCompliance::new(outline, &steel()).total(pitch_roll),
            )
        };
        let found: Vec<(bool, f64)> = (15..20).map(q).collect();
        assert_eq!(
            found
                .iter()
                .map(|(undercut, _)| *undercut)
                .collect::<Vec<_>>(),
            [true, true, true, false, false]
        );
        // Second differences of a smooth series stay far below its first ones.
        for three in found.windows(3) {
            let (first, second) = (three[1].1 - three[0].1, three[2].1 - three[1].1);
            assert!(first < 0.0 && second < 0.0, "{found:?}");
            assert!((second - first).abs() < 0.5 * first.abs(), "{found:?}");
        }
    }

    #[test]
    fn a_root_that_cannot_be_drawn_is_refused() {
        // A rack that cuts through the tooth.
        let form = RootForm {
            dedendum: 5.0,
            fillet_radius: 0.38,
        };
        let refused = Outline::new(flank(20, 0.0), form, Gear::Pinion);
        assert!(
            matches!(refused, Err(GearError::RootForm { .. })),
            "{refused:?}"
        );
    }

    fn flank(z: u32, x: f64) -> ToothFlank {
        let input = GearPairInput {
            profile_shift: Some([x, 0.0]),
            addendum: 0.8,
            ..GearPairInput::standard(
                [z, 40],
                Length::from_si(2e-3),
                Angle::from_si(0.0),
                Length::from_si(20e-3),
            )
        };
        ToothFlank::new(&GearPair::new(&input).unwrap(), 0, x)
    }

    fn outline(z: u32, x: f64) -> Result<Outline, GearError> {
        Outline::new(flank(z, x), RootForm::default(), Gear::Pinion)
    }
}
