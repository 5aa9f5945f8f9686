//! Losses by the deformation of the flanks.
//!
//! Source: Rodríguez 2022, eq. 19, as printed (`[P19]`); plastic work and hysteresis by their
//! definitions (the others).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p | contact pressure | Pa |
//! | u, du_pl | normal displacement, plastic displacement gained in a pass | m |
//! | E_pl, E_el | plastic work, stored elastic energy per engagement and metre of face | J/m |
//! | T_z | time between two engagements, 2π/(z₁ω₁) | s |
//! | T | time of one revolution | s |
//! | b | face width | m |
//! | α_h | share of the elastic energy that is not recovered | - |
//!
//! Limits: eq. 19 counts one a × a patch once per revolution, which is too small by b z₁/a; it serves
//! for comparison with the paper. Plastic work is part of running-in: it decays over the passes and is
//! not part of the steady efficiency.

use asperity_core::DomainError;
use asperity_core::quantity::{AngularSpeed, Energy, Length, LineEnergy, Power, Pressure, Time};
use serde::Serialize;

use crate::error::EfficiencyError;

/// P = σ δ a²/T                                                                `[P19]`
///
/// as printed in the 2022 paper, with the von Mises stress σ, the deformation δ, the half width a of the contact and
/// the time T of one revolution.
///
/// # Errors
/// When stress or deformation is negative, width or period not positive, or one not finite.
///
/// ```
/// use asperity_efficiency::deformation::printed_deformation_power;
/// let power = printed_deformation_power(
///     "500 MPa".parse()?, "1 nm".parse()?, "120 um".parse()?, "20 ms".parse()?,
/// )?;
/// assert!((power.si() - 3.6e-7).abs() < 1e-20);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn printed_deformation_power(
    stress: Pressure,
    deformation: Length,
    width: Length,
    period: Time,
) -> Result<Power, EfficiencyError> {
    asperity_core::cite!("P19");
    let sigma = DomainError::non_negative("stress", stress)?;
    let delta = DomainError::non_negative("deformation", deformation)?;
    let a = DomainError::positive("contact width", width)?;
    let t = DomainError::positive("period", period)?;
    Ok(Power::from_si(sigma * delta * a * a / t))
}

/// Deformation of one surface, for the paper's formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SurfaceDeformation {
    /// Von Mises stress σ, as in the text of the paper next to eq. 19, not the contact pressure.
    pub stress: Pressure,
    /// Elastic deformation.
    pub elastic: Length,
    /// Plastic deformation.
    pub plastic: Length,
}

/// Deformation loss of one surface, in the paper's formulation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SurfaceDeformationPower {
    /// In contact: elastic and plastic deformation.
    pub in_contact: Power,
    /// After contact: plastic deformation only.
    pub after_contact: Power,
}

/// Evaluates `[P19]` at the two instants of the 2022 paper: in contact with δ = δ_el + δ_pl, and after
/// contact with δ = δ_pl.
///
/// # Errors
/// As [`printed_deformation_power`].
///
/// ```
/// use asperity_efficiency::deformation::{SurfaceDeformation, printed_deformation};
/// let surface = SurfaceDeformation {
///     stress: "500 MPa".parse()?, elastic: "3 nm".parse()?, plastic: "1 nm".parse()?,
/// };
/// let power = printed_deformation(&surface, "120 um".parse()?, "20 ms".parse()?)?;
/// assert!((power.in_contact / power.after_contact - 4.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn printed_deformation(
    surface: &SurfaceDeformation,
    width: Length,
    period: Time,
) -> Result<SurfaceDeformationPower, EfficiencyError> {
    DomainError::non_negative("elastic deformation", surface.elastic)?;
    DomainError::non_negative("plastic deformation", surface.plastic)?;
    let power = |delta| printed_deformation_power(surface.stress, delta, width, period);
    Ok(SurfaceDeformationPower {
        in_contact: power(surface.elastic + surface.plastic)?,
        after_contact: power(surface.plastic)?,
    })
}

/// E_pl = Σ p du_pl Δx                                                         `[Deformation-1]`
///
/// Plastic work of one engagement per metre of face, from pressures \[Pa\] and the plastic
/// displacements gained at the same points \[m\], `spacing` apart.
///
/// # Errors
/// When the arrays differ in length, a number is not finite, a pressure is negative, or the work is.
///
/// ```
/// use asperity_efficiency::deformation::plastic_work;
/// let work = plastic_work(&[0.0, 2e9, 1e9], &[0.0, 3e-9, 0.0], "0.5 um".parse()?)?;
/// assert!((work.si() - 3e-6).abs() < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plastic_work(
    pressure: &[f64],
    plastic_gain: &[f64],
    spacing: Length,
) -> Result<LineEnergy, EfficiencyError> {
    asperity_core::cite!("Deformation-1");
    work("plastic work", pressure, plastic_gain, spacing)
}

/// E_el = ½ Σ p u Δx                                                           `[Deformation-2]`
///
/// Elastic energy stored in the contact per metre of face, from pressures \[Pa\] and the elastic
/// approach at the same points \[m\].
///
/// # Errors
/// As [`plastic_work`].
///
/// ```
/// use asperity_efficiency::deformation::elastic_energy;
/// let energy = elastic_energy(&[1e9, 1e9], &[2e-6, 2e-6], "10 um".parse()?)?;
/// assert!((energy.si() - 0.02).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn elastic_energy(
    pressure: &[f64],
    displacement: &[f64],
    spacing: Length,
) -> Result<LineEnergy, EfficiencyError> {
    asperity_core::cite!("Deformation-2");
    Ok(work("elastic energy", pressure, displacement, spacing)? * 0.5)
}

fn work(
    name: &'static str,
    pressure: &[f64],
    displacement: &[f64],
    spacing: Length,
) -> Result<LineEnergy, EfficiencyError> {
    let dx = DomainError::positive("spacing", spacing)?;
    if displacement.len() != pressure.len() {
        return Err(EfficiencyError::length_mismatch(
            "displacement",
            displacement.len(),
            pressure.len(),
        ));
    }
    let mut sum = 0.0;
    for (&p, &u) in pressure.iter().zip(displacement) {
        DomainError::non_negative("pressure", Pressure::from_si(p))?;
        DomainError::finite("displacement", Length::from_si(u))?;
        sum += p * u * dx;
    }
    let energy = LineEnergy::from_si(sum);
    DomainError::finite(name, energy)?;
    if sum < 0.0 {
        return Err(EfficiencyError::negative_energy(name, energy));
    }
    Ok(energy)
}

/// T_z = 2π/(z₁ω₁)                                                             `[Deformation-3]`
///
/// Time between two engagements, equivalent to z₁n₁/60 engagements per second with n₁ in 1/min.
///
/// # Errors
/// When there is no tooth or the speed is not positive.
///
/// ```
/// use asperity_efficiency::deformation::engagement_period;
/// let period = engagement_period(50, "3000 1/min".parse()?)?;
/// assert!((period.si() - 1.0 / 2500.0).abs() < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn engagement_period(teeth: u32, speed: AngularSpeed) -> Result<Time, EfficiencyError> {
    asperity_core::cite!("Deformation-3");
    let z = f64::from(teeth);
    DomainError::require(z > 0.0, "teeth", z, "-", "must be at least 1")?;
    let omega = DomainError::positive("speed", speed)?;
    Ok(Time::from_si(std::f64::consts::TAU / (z * omega)))
}

/// Plastic work of running-in by pass.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunningIn {
    /// Plastic work at one tooth pair in each pass.
    pub energy_per_tooth: Vec<Energy>,
    /// Power during each pass.
    pub power: Vec<Power>,
    /// Work at one tooth pair over all passes.
    pub total_per_tooth: Energy,
}

/// E_z = E_pl·b, P = E_z/T_z = E_pl·b·z₁n₁/60                                  `[Deformation-4]`
///
/// `passes` holds the plastic work per engagement and metre of each pass over the flank, which falls
/// to zero during shakedown.
///
/// # Errors
/// When an energy is negative, or face width or period are not positive.
///
/// ```
/// use asperity_core::quantity::LineEnergy;
/// use asperity_efficiency::deformation::running_in;
/// let passes = [LineEnergy::from_si(2e-3), LineEnergy::from_si(0.0)];
/// let work = running_in(&passes, "50 mm".parse()?, "0.4 ms".parse()?)?;
/// assert!((work.power[0].si() - 0.25).abs() < 1e-15);
/// assert!((work.total_per_tooth.si() - 1e-4).abs() < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn running_in(
    passes: &[LineEnergy],
    face_width: Length,
    period: Time,
) -> Result<RunningIn, EfficiencyError> {
    asperity_core::cite!("Deformation-4");
    let b = DomainError::positive("face width", face_width)?;
    let t = DomainError::positive("engagement period", period)?;
    let mut energy_per_tooth = Vec::with_capacity(passes.len());
    for &pass in passes {
        let energy = DomainError::non_negative("plastic work", pass)? * b;
        energy_per_tooth.push(Energy::from_si(energy));
    }
    let power = energy_per_tooth
        .iter()
        .map(|energy| Power::from_si(energy.si() / t));
    let total: f64 = energy_per_tooth.iter().map(|energy| energy.si()).sum();
    Ok(RunningIn {
        power: power.collect(),
        energy_per_tooth,
        total_per_tooth: Energy::from_si(total),
    })
}

/// P = α_h·E_el·b/T_z                                                          `[Deformation-5]`
///
/// # Errors
/// When the energy is negative, α_h not within 0 ≤ α_h ≤ 1, or width or period not positive.
///
/// ```
/// use asperity_core::quantity::LineEnergy;
/// use asperity_efficiency::deformation::hysteresis_power;
/// let energy = LineEnergy::from_si(0.02);
/// let power = hysteresis_power(energy, 0.01, "50 mm".parse()?, "0.4 ms".parse()?)?;
/// assert!((power.si() - 0.025).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn hysteresis_power(
    elastic: LineEnergy,
    fraction: f64,
    face_width: Length,
    period: Time,
) -> Result<Power, EfficiencyError> {
    asperity_core::cite!("Deformation-5");
    let energy = DomainError::non_negative("elastic energy", elastic)?;
    DomainError::require(
        (0.0..=1.0).contains(&fraction),
        "hysteresis fraction",
        fraction,
        "-",
        "must lie between 0 and 1",
    )?;
    let b = DomainError::positive("face width", face_width)?;
    let t = DomainError::positive("engagement period", period)?;
    Ok(Power::from_si(fraction * energy * b / t))
}
