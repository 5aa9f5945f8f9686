//! Cases shared by the tests.
#![allow(dead_code, reason = "each test file uses a part")]
#![allow(
    clippy::unwrap_used,
    reason = "a case that cannot be built fails its test"
)]

use asperity_core::Profile;
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_ehl::{LineContact, Oil, Scales};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

/// Oil of the gear case: 10 mPa s, α 18 1/GPa, Roelands 0.6, compressible, Newtonian.
pub fn gear_oil() -> Oil {
    Oil {
        viscosity: DynamicViscosity::from_si(0.01),
        pressure_viscosity: PressureViscosity::from_si(1.8e-8),
        viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
        density_law: DensityLaw::DowsonHigginson,
        shear_law: ShearLaw::Newtonian,
    }
}

/// Cylinder of 10 mm radius, steel on steel.
pub fn contact(p_0: f64, u_m: f64, slide_to_roll: f64) -> LineContact {
    LineContact::at_pressure(
        Length::from_si(10e-3),
        Pressure::from_si(115.4e9),
        Pressure::from_si(p_0),
        Speed::from_si(u_m),
        slide_to_roll,
    )
    .unwrap()
}

/// A_d/A_i of a wave that passes through the contact in pure rolling, by the coefficients of the gap law
/// `power`; the solver agrees with it within 10 % for ∇ from 2 to 8 (at 14 the curve is a fifth too low).
pub fn remaining_amplitude(wavelength: Length, scales: &Scales) -> f64 {
    let per_half_width = scales.moes_load.powf(0.75) / scales.moes_lubricant.sqrt();
    let nabla = wavelength / scales.half_width * per_half_width;
    1.0 / (1.0 + nabla * (0.125 + 0.04 * nabla))
}

/// A contact of the Moes numbers M and L with α = 20 1/GPa.
pub fn of_moes(
    m: f64,
    l: f64,
    viscosity_law: PressureViscosityLaw,
    density_law: DensityLaw,
) -> (LineContact, Oil) {
    let (radius, modulus, alpha) = (10e-3, 115.4e9, 2e-8);
    // α·p₀ = L·√(M/2π); an isoviscous film has any pressure.
    let exponent = if l > 0.0 {
        l * (m / std::f64::consts::TAU).sqrt()
    } else {
        10.0
    };
    let p_0 = exponent / alpha;
    let w = std::f64::consts::PI * radius * p_0 * p_0 / modulus;
    let group = (w / (2.0 * modulus * radius) / m).powi(2);
    let u_m = 1.0;
    let viscosity = group * 2.0 * modulus * radius / (2.0 * u_m);
    let contact = LineContact::at_pressure(
        Length::from_si(radius),
        Pressure::from_si(modulus),
        Pressure::from_si(p_0),
        Speed::from_si(u_m),
        0.0,
    )
    .unwrap();
    let oil = Oil {
        viscosity: DynamicViscosity::from_si(viscosity),
        pressure_viscosity: PressureViscosity::from_si(alpha),
        viscosity_law,
        density_law,
        shear_law: ShearLaw::Newtonian,
    };
    (contact, oil)
}

/// Film in the units of Moes' diagram.
pub fn moes(contact: &LineContact, oil: &Oil, film: Length) -> f64 {
    let scales = contact.scales(oil).unwrap();
    let unit = scales.film_length(1.0).si();
    scales.moes_film(film.si() / unit)
}

/// Next of a sequence of numbers in 0..1 (SplitMix64).
pub fn uniform(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// Length of the surfaces of [`waves`].
const PERIOD: f64 = 480e-6;
/// Numbers of the waves over that length.
pub const WAVES: std::ops::RangeInclusive<u32> = 1..=16;

/// Length of wave `k` of [`WAVES`].
pub fn wave_length(k: u32) -> Length {
    Length::from_si(PERIOD / f64::from(k))
}

/// Periodic waves of 30 to 480 µm with amplitudes in proportion to their length.
pub fn waves(seed: u64, rq: f64) -> Profile {
    let points = 960;
    let mut state = seed;
    let modes: Vec<(f64, f64)> = WAVES
        .map(|k| (f64::from(k), std::f64::consts::TAU * uniform(&mut state)))
        .collect();
    let heights: Vec<f64> = (0..points)
        .map(|i| {
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(points);
            modes
                .iter()
                .map(|(k, phase)| (k * turn + phase).cos() / k)
                .sum()
        })
        .collect();
    let square: f64 = heights.iter().map(|z: &f64| z * z).sum();
    let scale = rq / (square / f64::from(points)).sqrt();
    let heights = heights.into_iter().map(|z| scale * z).collect();
    Profile::new(Length::from_si(PERIOD / f64::from(points)), heights).unwrap()
}
