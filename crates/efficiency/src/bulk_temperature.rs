//! Bulk temperature of the gears from the loss of their mesh.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ϑ_oil, ϑ_M | temperatures of the oil and of the gear bodies | K |
//! | P | loss of the mesh | W |
//! | a, b | centre distance, face width | m |
//! | X_S | lubrication factor, by the oil supply of the mesh | - |
//! | G₁, G₂, G₁₂ | conductances from the gears to the oil, and between the gears | W/K |
//! | β | share of the frictional heat that goes into gear 1 | - |
//!
//! The rise after Oster, as in ISO/TR 15144-1, is unconfirmed: no accessible source has its constants. ISO's X_Ca is
//! 1 here: it corrects a loss computed without tip relief, and P includes the relief. Published heat transfer coefficients
//! differ by factors, so the conductances of the network are inputs.

use asperity_core::quantity::{Length, Power, Temperature, ThermalConductance};
use asperity_core::{DomainError, cite};

use crate::error::EfficiencyError;

/// Change of the temperature at which the fixed-point iteration ends \[K\].
pub const SETTLED: f64 = 0.01;
/// Largest number of steps of the fixed-point iteration.
pub const MOST_STEPS: usize = 50;
/// Temperature above the oil \[K\] from which a second equilibrium is searched.
pub const HOTTER_START: f64 = 60.0;

/// Factor of Oster's rise (unconfirmed) \[K\] for P in kW, a and b in mm.
const OSTER: f64 = 7400.0;
/// Exponent of Oster's rise (unconfirmed).
pub const OSTER_EXPONENT: f64 = 0.72;
/// Lubrication factor of the jet lubrication of Oster's tests (unconfirmed).
const OSTER_JET: f64 = 1.2;

/// Rise of the bulk temperature over the oil \[K\].
///
/// ```text
/// ϑ_M − ϑ_oil = 7400 (P/(a b))^0.72 X_S/1.2,  P in kW, a and b in mm             [Bulk-iso]
/// ```
///
/// X_S: 1.2 of a jet, 1.0 of dipping gears, 0.2 submerged.
///
/// # Errors
/// When the loss is negative, or a length or X_S is not positive.
///
/// ```
/// use asperity_efficiency::bulk_temperature::iso_rise;
/// let rise = iso_rise("400 W".parse()?, "91.5 mm".parse()?, "14 mm".parse()?, 1.0)?;
/// assert!((rise - 18.4543).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn iso_rise(
    loss: Power,
    centre_distance: Length,
    face_width: Length,
    lubrication: f64,
) -> Result<f64, EfficiencyError> {
    cite!("Bulk-iso");
    let p = DomainError::non_negative("loss of the mesh", loss)?;
    let a = DomainError::positive("centre distance", centre_distance)?;
    let b = DomainError::positive("face width", face_width)?;
    let rule = "must be finite and greater than zero";
    let holds = lubrication.is_finite() && lubrication > 0.0;
    DomainError::require(holds, "factor of the lubrication", lubrication, "-", rule)?;
    let specific = (p * 1e-3) / (a * 1e3 * b * 1e3);
    Ok(OSTER * specific.powf(OSTER_EXPONENT) * lubrication / OSTER_JET)
}

/// Conductances of two gears in oil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Network {
    /// From pinion and wheel to the oil.
    pub to_oil: [ThermalConductance; 2],
    /// Between the gears.
    pub between: ThermalConductance,
}

impl Network {
    /// Temperature rises of pinion and wheel over the oil \[K\]. The share `first` of the heat `loss` goes into
    /// the pinion.
    ///
    /// ```text
    /// (G₁ + G₁₂) Δϑ₁ − G₁₂ Δϑ₂ = β P,  (G₂ + G₁₂) Δϑ₂ − G₁₂ Δϑ₁ = (1 − β) P      [Bulk-network]
    /// ```
    ///
    /// # Errors
    /// When a conductance to the oil is not positive, the conductance between the gears or the loss is negative,
    /// or the share is not within 0..1.
    ///
    /// ```
    /// use asperity_efficiency::bulk_temperature::Network;
    /// let network = Network { to_oil: ["12 W/K".parse()?, "18 W/K".parse()?], between: "3 W/K".parse()? };
    /// let [pinion, wheel] = network.rises("400 W".parse()?, 0.5)?;
    /// assert!((pinion - 15.68627).abs() < 1e-5 && (wheel - 11.76471).abs() < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn rises(&self, loss: Power, first: f64) -> Result<[f64; 2], EfficiencyError> {
        cite!("Bulk-network");
        let p = DomainError::non_negative("loss of the mesh", loss)?;
        let g1 = DomainError::positive("conductance of the pinion to the oil", self.to_oil[0])?;
        let g2 = DomainError::positive("conductance of the wheel to the oil", self.to_oil[1])?;
        let g12 = DomainError::non_negative("conductance between the gears", self.between)?;
        let rule = "must be 0 to 1";
        let holds = (0.0..=1.0).contains(&first);
        DomainError::require(holds, "share of the heat into the pinion", first, "-", rule)?;
        let (a, b) = (g1 + g12, g2 + g12);
        let determinant = a * b - g12 * g12;
        let (q1, q2) = (first * p, (1.0 - first) * p);
        Ok([
            (b * q1 + g12 * q2) / determinant,
            (a * q2 + g12 * q1) / determinant,
        ])
    }
}

/// Equilibrium bulk temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BulkTemperature {
    /// The temperature.
    pub temperature: Temperature,
    /// Change of the temperature in one more step \[K\].
    pub residual: f64,
    /// Number of steps.
    pub steps: usize,
    /// Result of a start 60 K above the oil.
    pub hotter: HotterStart,
}

/// Result of a hot start of the fixed-point iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HotterStart {
    /// The same temperature.
    Same,
    /// A second, hotter equilibrium.
    Elsewhere(Temperature),
    /// No equilibrium: the loss heats the gears further, or the laws reject the state.
    Nowhere,
}

impl BulkTemperature {
    /// A second, hotter equilibrium, and the start from which none is reached, of an iteration that began at `start`.
    #[must_use]
    pub fn hotter_ends(&self, start: Temperature) -> [Option<Temperature>; 2] {
        match self.hotter {
            HotterStart::Same => [None, None],
            HotterStart::Elsewhere(second) => [Some(second), None],
            HotterStart::Nowhere => [None, Some(Temperature::from_si(start.si() + HOTTER_START))],
        }
    }
}

/// Computes the bulk temperature at which `made` returns its argument: the bulk temperature that results from the
/// loss at a bulk temperature.
///
/// ```text
/// ϑ ← (ϑ + g(ϑ))/2 until |g(ϑ) − ϑ| < 0.01 K                              [Bulk-fixed-point]
/// ```
///
/// Returns the lowest equilibrium. A second iteration starts 60 K above the oil and shows whether there is another
/// equilibrium, or none from there.
///
/// # Errors
/// The error of `made` at the temperature of the oil, and an error if the temperature did not settle in 50 steps
/// or left the domain of `made`.
pub fn fixed_point<E: From<EfficiencyError>>(
    oil: Temperature,
    mut made: impl FnMut(Temperature) -> Result<Temperature, E>,
) -> Result<BulkTemperature, E> {
    let lowest = lowest_fixed_point(oil, &mut made)?;
    let hotter = match lowest_fixed_point(oil + Temperature::from_si(HOTTER_START), made) {
        Err(_) => HotterStart::Nowhere,
        Ok(equilibrium) => {
            let difference = (equilibrium.temperature - lowest.temperature).si().abs();
            if difference > 10.0 * SETTLED {
                HotterStart::Elsewhere(equilibrium.temperature)
            } else {
                HotterStart::Same
            }
        }
    };
    Ok(BulkTemperature { hotter, ..lowest })
}

/// The same from the start `from` only, for a temperature that is needed within another iteration.
///
/// # Errors
/// As [`fixed_point`].
pub fn lowest_fixed_point<E: From<EfficiencyError>>(
    from: Temperature,
    mut made: impl FnMut(Temperature) -> Result<Temperature, E>,
) -> Result<BulkTemperature, E> {
    cite!("Bulk-fixed-point");
    let not_settled = |at: f64, residual: f64, steps| {
        let at = Temperature::from_si(at);
        E::from(EfficiencyError::bulk_not_settled(at, residual.abs(), steps))
    };
    let (mut at, mut residual) = (from.si(), f64::INFINITY);
    for steps in 1..=MOST_STEPS {
        residual = match made(Temperature::from_si(at)) {
            Ok(next) => next.si() - at,
            // `made` rejects the state of this step: report the last temperature and its change.
            Err(_) if steps > 1 => {
                return Err(not_settled(at - 0.5 * residual, residual, steps - 1));
            }
            Err(error) => return Err(error),
        };
        if residual.abs() < SETTLED {
            return Ok(BulkTemperature {
                temperature: Temperature::from_si(at + 0.5 * residual),
                residual: residual.abs(),
                steps,
                hotter: HotterStart::Same,
            });
        }
        at += 0.5 * residual;
    }
    Err(not_settled(at, residual, MOST_STEPS))
}
