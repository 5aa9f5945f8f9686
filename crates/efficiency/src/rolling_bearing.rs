//! Friction torque of a rolling bearing by SKF's model, with constants from the bearing's catalogue.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | d, D, d_m | bore, outside diameter, their mean | mm |
//! | F_r, F_a | radial and axial load | N |
//! | C₀ | static load rating (ball bearings) | N |
//! | Y | axial load factor (tapered rollers) | - |
//! | n, ν | speed; viscosity of the oil at its temperature | 1/min, mm²/s |
//! | R₁, R₂, S₁, S₂, K_z | constants of the series, from the catalogue | SKF's |
//! | K_rs | replenishment: 6e-8 with grease, 3e-8 with a jet or a low oil level, 0 in a bath | - |
//! | μ_bl, μ_EHL | sliding friction coefficients in boundary and in full-film lubrication | - |
//! | M | friction torque | N mm |
//!
//! Source: SKF, Rolling Bearings (catalogue, 2012), "The SKF model for calculating the frictional moment", table 2a. The
//! variables G_rr and G_sl, φ_bl and the values of μ_EHL were read there; φ_ish and φ_rs are taken from independent programs.
//! Drag in an oil bath and contact seals of the bearing are not included. The catalogue requires the minimum load of the
//! bearing, F_a ≤ 0.5 C₀ for deep groove ball bearings and F_a ≤ 0.5 F_r for cylindrical roller bearings.

use asperity_core::quantity::{AngularSpeed, Force, KinematicViscosity, Length, Torque};
use asperity_core::{Checked, DomainError, FittedRange, cite};

use crate::error::EfficiencyError;

/// Type of the rolling elements, with the constants of that type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BearingForm {
    /// Deep groove ball bearing.
    DeepGrooveBall {
        /// Static load rating C₀.
        static_rating: Force,
    },
    /// Cylindrical roller bearing.
    CylindricalRoller,
    /// Tapered roller bearing.
    TaperedRoller {
        /// Axial load factor Y.
        axial_factor: f64,
    },
}

/// Constants of a bearing series, in the units of its catalogue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingConstants {
    /// R₁ of the rolling torque.
    pub r1: f64,
    /// R₂ of the rolling torque; not used for cylindrical roller bearings.
    pub r2: f64,
    /// S₁ of the sliding torque.
    pub s1: f64,
    /// S₂ of the sliding torque.
    pub s2: f64,
    /// K_z of the type.
    pub k_z: f64,
    /// K_rs of the lubrication.
    pub k_rs: f64,
    /// Sliding friction coefficient in boundary lubrication, μ_bl.
    pub mu_bl: f64,
    /// Sliding friction coefficient in full-film lubrication, μ_EHL.
    pub mu_ehl: f64,
}

/// A rolling bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingBearing {
    /// Type of the rolling elements.
    pub form: BearingForm,
    /// Bore d.
    pub bore: Length,
    /// Outside diameter D.
    pub outside_diameter: Length,
    /// Constants of the series.
    pub constants: BearingConstants,
}

/// Friction torques of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingTorque {
    /// Rolling friction.
    pub rolling: Torque,
    /// Sliding friction.
    pub sliding: Torque,
}

impl BearingTorque {
    /// Sum of both.
    #[must_use]
    pub fn total(self) -> Torque {
        self.rolling + self.sliding
    }
}

/// Factor of φ_bl (SKF).
const BROKEN_FILM: f64 = 2.6e-8;
/// Factor of φ_ish (SKF).
const SHEAR_HEATING: f64 = 1.84e-9;
/// Permitted ratio of axial to radial load of a cylindrical roller bearing.
const AXIAL_OVER_RADIAL: FittedRange = FittedRange::new(
    "axial over radial load",
    0.0,
    0.5,
    "-",
    "SKF's torque of a cylindrical roller bearing",
);
/// Permitted ratio of the axial load to C₀ of a deep groove ball bearing.
const AXIAL_OVER_RATING: FittedRange = FittedRange::new(
    "axial load over static rating",
    0.0,
    0.5,
    "-",
    "SKF's torque of a deep groove ball bearing",
);

impl RollingBearing {
    /// Checks the dimensions and constants.
    ///
    /// # Errors
    /// When a length, C₀, Y or a constant is not positive (K_rs and coefficients: negative), or the outside diameter
    /// is not larger than the bore.
    pub fn check(&self) -> Result<(), EfficiencyError> {
        let d = DomainError::positive("bore", self.bore)?;
        let outside = DomainError::positive("outside diameter", self.outside_diameter)?;
        let rule = "must be above the bore";
        DomainError::require(outside > d, "outside diameter", outside, "m", rule)?;
        let k = &self.constants;
        let above = "must be finite and greater than zero";
        let least = "must be finite and not negative";
        for (name, value) in [("r1", k.r1), ("s1", k.s1), ("k_z", k.k_z)] {
            let holds = value.is_finite() && value > 0.0;
            DomainError::require(holds, name, value, "-", above)?;
        }
        for (name, value) in [
            ("r2", k.r2),
            ("s2", k.s2),
            ("k_rs", k.k_rs),
            ("mu_bl", k.mu_bl),
            ("mu_ehl", k.mu_ehl),
        ] {
            let holds = value.is_finite() && value >= 0.0;
            DomainError::require(holds, name, value, "-", least)?;
        }
        match self.form {
            BearingForm::DeepGrooveBall { static_rating } => {
                DomainError::positive("static rating", static_rating)?;
            }
            BearingForm::TaperedRoller { axial_factor } => {
                let holds = axial_factor.is_finite() && axial_factor > 0.0;
                DomainError::require(holds, "axial factor", axial_factor, "-", above)?;
            }
            BearingForm::CylindricalRoller => {}
        }
        Ok(())
    }

    /// Friction torque under a radial and an axial load, at a speed and a viscosity.
    ///
    /// ```text
    /// M = φ_ish φ_rs G_rr (ν n)^0.6 + G_sl μ_sl                                     [Bearing-1]
    /// ```
    ///
    /// # Errors
    /// As [`check`](Self::check), and when a load, the speed or the viscosity is negative.
    ///
    /// ```
    /// use asperity_efficiency::rolling_bearing::{BearingConstants, BearingForm, RollingBearing};
    /// let bearing = RollingBearing {
    ///     form: BearingForm::DeepGrooveBall { static_rating: "11 kN".parse()? },
    ///     bore: "40 mm".parse()?,
    ///     outside_diameter: "68 mm".parse()?,
    ///     constants: BearingConstants {
    ///         r1: 4.3e-7, r2: 1.7, s1: 4.63e-3, s2: 4.25, k_z: 3.1, k_rs: 6e-8, mu_bl: 0.12, mu_ehl: 0.04,
    ///     },
    /// };
    /// let torque = bearing.torque(
    ///     ["2 kN".parse()?, "0 N".parse()?], "3000 1/min".parse()?, "10 mm2/s".parse()?,
    /// )?;
    /// assert!((torque.value.total().si() - 0.052_902_8).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn torque(
        &self,
        load: [Force; 2],
        speed: AngularSpeed,
        viscosity: KinematicViscosity,
    ) -> Result<Checked<BearingTorque>, EfficiencyError> {
        cite!("Bearing-1");
        self.check()?;
        let [radial, axial] = load;
        let fr = DomainError::non_negative("radial", radial)?;
        let fa = DomainError::non_negative("axial", axial)?;
        let n = DomainError::non_negative("speed", speed)? * 30.0 / std::f64::consts::PI;
        let nu = DomainError::non_negative("viscosity", viscosity)? * 1e6;
        let d_m = 0.5e3 * (self.bore + self.outside_diameter).si();
        let [g_rr, g_sl] = self.variables(fr, fa, d_m);
        let rolling = shear_heating(n, nu, d_m) * self.replenishment(n, nu);
        let sliding = self.sliding_coefficient(n, nu, d_m);
        let newton_metres = |torque: f64| Torque::from_si(torque * 1e-3);
        let mut notes = Vec::new();
        match self.form {
            BearingForm::DeepGrooveBall { static_rating } => {
                AXIAL_OVER_RATING.check(fa / static_rating.si(), &mut notes);
            }
            BearingForm::CylindricalRoller if fa > 0.0 => {
                AXIAL_OVER_RADIAL.check(fa / fr, &mut notes);
            }
            BearingForm::CylindricalRoller | BearingForm::TaperedRoller { .. } => {}
        }
        Ok(Checked {
            value: BearingTorque {
                rolling: newton_metres(rolling * g_rr * (nu * n).powf(0.6)),
                sliding: newton_metres(g_sl * sliding),
            },
            outside: notes,
        })
    }

    /// ```text
    /// φ_rs = exp(−K_rs ν n (d + D) √(K_z/(2 (D − d))))                               [Bearing-3]
    /// ```
    fn replenishment(&self, n: f64, nu: f64) -> f64 {
        cite!("Bearing-3");
        let (d, outside) = (self.bore.si() * 1e3, self.outside_diameter.si() * 1e3);
        let narrowing = (self.constants.k_z / (2.0 * (outside - d))).sqrt();
        (-self.constants.k_rs * nu * n * (d + outside) * narrowing).exp()
    }

    /// ```text
    /// μ_sl = φ_bl μ_bl + (1 − φ_bl) μ_EHL,  φ_bl = exp(−2.6e-8 (n ν)^1.4 d_m)        [Bearing-4]
    /// ```
    fn sliding_coefficient(&self, n: f64, nu: f64, d_m: f64) -> f64 {
        cite!("Bearing-4");
        let bl = (-BROKEN_FILM * (n * nu).powf(1.4) * d_m).exp();
        bl * self.constants.mu_bl + (1.0 - bl) * self.constants.mu_ehl
    }

    /// Variables G_rr and G_sl of geometry and load, in SKF's units.
    ///
    /// ```text
    /// balls, F_a = 0:   G_rr = R₁ d_m^1.96 F_r^0.54,  G_sl = S₁ d_m^−0.26 F_r^(5/3)
    /// balls, F_a > 0:   G_rr = R₁ d_m^1.96 (F_r + R₂ F_a/sin α_F)^0.54,
    ///                   G_sl = S₁ d_m^−0.145 (F_r⁵ + S₂ d_m^1.5 F_a⁴/sin α_F)^(1/3),  α_F = 24.6° (F_a/C₀)^0.24
    /// cylinders:        G_rr = R₁ d_m^2.41 F_r^0.31,  G_sl = S₁ d_m^0.9 F_a + S₂ d_m F_r
    /// tapers:           G_rr = R₁ d_m^2.38 (F_r + R₂ Y F_a)^0.31,  G_sl = S₁ d_m^0.82 (F_r + S₂ Y F_a)  [Bearing-5]
    /// ```
    fn variables(&self, fr: f64, fa: f64, d_m: f64) -> [f64; 2] {
        cite!("Bearing-5");
        let k = &self.constants;
        match self.form {
            BearingForm::DeepGrooveBall { .. } if fa == 0.0 => [
                k.r1 * d_m.powf(1.96) * fr.powf(0.54),
                k.s1 * d_m.powf(-0.26) * fr.powf(5.0 / 3.0),
            ],
            BearingForm::DeepGrooveBall { static_rating } => {
                let degrees = 24.6 * (fa / static_rating.si()).powf(0.24);
                let sine = degrees.to_radians().sin();
                let loads = fr.powi(5) + k.s2 * d_m.powf(1.5) / sine * fa.powi(4);
                [
                    k.r1 * d_m.powf(1.96) * (fr + k.r2 / sine * fa).powf(0.54),
                    k.s1 * d_m.powf(-0.145) * loads.cbrt(),
                ]
            }
            BearingForm::CylindricalRoller => [
                k.r1 * d_m.powf(2.41) * fr.powf(0.31),
                k.s1 * d_m.powf(0.9) * fa + k.s2 * d_m * fr,
            ],
            BearingForm::TaperedRoller { axial_factor: y } => [
                k.r1 * d_m.powf(2.38) * (fr + k.r2 * y * fa).powf(0.31),
                k.s1 * d_m.powf(0.82) * (fr + k.s2 * y * fa),
            ],
        }
    }
}

/// ```text
/// φ_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 ν^0.64)                                      [Bearing-2]
/// ```
fn shear_heating(n: f64, nu: f64, d_m: f64) -> f64 {
    cite!("Bearing-2");
    1.0 / (1.0 + SHEAR_HEATING * (n * d_m).powf(1.28) * nu.powf(0.64))
}
