//! Pressure of a wave of one flank that slides through a lubricated contact, solved and by linear theory.
//!
//! ```text
//! cargo run --release -p asperity-ehl --example sliding_waves [M L length/a SRR Eyring-stress/MPa cells]
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | l, z, k | length and amplitude of the wave on flank 1, 2π a/l | m, m, - |
//! | p̂, ĥ | complex amplitudes of pressure over π E* z/l and of film over z, at the place of the wave | - |
//! | r | speed of flank 1 over the mean speed | - |
//! | h, η | film and viscosity of smooth flanks at a place | m, Pa s |
//! | κ | compressibility of the oil there | 1/Pa |
//!
//! A pressure wave p displaces the flanks by p l/(π E*), so that ĥ = p̂ − 1. The mass of the film moves at the mean speed and is pressed
//! from high pressure to low:
//!
//! ```text
//! q' = −(Λ/(1 + β) + i k (1 − r)) q + i k (1 − r),  q = (1 + β) p̂,  q(−1) = 0
//! β = π E* h κ/l,  Λ = k³ h³ E* √((1/η)² + (V_s/(h τ₀))²)/(24 u_m a²)
//! ```
//!
//! ' is the derivative over x/a. V_s/(h τ₀) is the fluidity of Eyring's oil that is sheared by sliding. The theory has no inlet: it
//! starts from a film that follows the wave. Six numbers print their row; without them, a table is printed.

use std::f64::consts::{PI, TAU};

use asperity_core::Profile;
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_ehl::{LineContact, MovingProfile, Oil, RecordSettings, RoughContact, transient};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};
use rustfft::num_complex::Complex;

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

const RADIUS: f64 = 10e-3;
const MODULUS: f64 = 115.4e9;
const ALPHA: f64 = 2e-8;
/// Amplitude over the film.
const AMPLITUDE: f64 = 0.05;
/// Frames of a period.
const FRAMES: f64 = 24.0;
/// Steps of the theory.
const STEPS: usize = 4000;

/// M, L, l/a, slide-to-roll ratio, Eyring stress in MPa (0: Newtonian), cells.
const TABLE: [[f64; 6]; 17] = [
    [1.4, 6.0, 1.0, 0.0, 0.0, 512.0],
    [1.4, 6.0, 1.0, 1.2, 0.0, 512.0],
    [1.4, 6.0, 2.0, 1.2, 0.0, 512.0],
    [4.0, 7.0, 0.25, 1.2, 0.0, 512.0],
    [4.0, 7.0, 1.0, 0.0, 0.0, 512.0],
    [4.0, 7.0, 1.0, 0.5, 0.0, 512.0],
    [4.0, 7.0, 1.0, 1.2, 0.0, 512.0],
    [8.0, 6.0, 0.25, 0.0, 0.0, 512.0],
    [8.0, 6.0, 0.25, 0.5, 0.0, 512.0],
    [8.0, 6.0, 1.0, 0.0, 0.0, 512.0],
    [8.0, 6.0, 1.0, 0.5, 0.0, 512.0],
    [8.0, 6.0, 1.0, 0.5, 5.0, 512.0],
    [19.0, 9.8, 0.1, -0.7, 0.0, 1024.0],
    [19.0, 9.8, 0.25, -0.7, 0.0, 512.0],
    [19.0, 9.8, 0.25, -0.7, 5.0, 512.0],
    [19.0, 9.8, 1.0, -0.7, 0.0, 512.0],
    [19.0, 9.8, 1.0, -0.7, 5.0, 512.0],
];

fn main() -> Outcome<()> {
    let given: Vec<f64> = (std::env::args().skip(1))
        .map(|text| text.parse())
        .collect::<Result<_, _>>()?;
    println!(
        "| M, L | l/a | SRR | Eyring MPa | p̂ solved, x/a = -0.3, 0, 0.3 | p̂ by theory | ĥ solved, 0 |\n|---|---|---|---|---|---|---|"
    );
    match <[f64; 6]>::try_from(given) {
        Ok(row) => print_row(row),
        Err(_) => TABLE.into_iter().try_for_each(print_row),
    }
}

fn print_row([m, l, wave, slide, stress, cells]: [f64; 6]) -> Outcome<()> {
    let case = Case::new(m, l, slide, stress)?;
    let (solved, film) = case.solve(wave, cells as usize)?;
    let theory = case.theory(wave, film);
    let polar = |value: Complex<f64>| format!("{:.2} ({:+.0}°)", value.norm(), degrees(value));
    let solved_p = solved.map(|[p, _]| polar(p)).join(", ");
    let theory = theory.map(polar).join(", ");
    let stress = if stress > 0.0 {
        stress.to_string()
    } else {
        "-".to_owned()
    };
    println!(
        "| {m}, {l} | {wave} | {slide} | {stress} | {solved_p} | {theory} | {} |",
        polar(solved[1][1])
    );
    Ok(())
}

/// Lag behind the wave.
fn degrees(value: Complex<f64>) -> f64 {
    -value.arg().to_degrees()
}

/// Places of the results.
const PLACES: [f64; 3] = [-0.3, 0.0, 0.3];

struct Case {
    contact: LineContact,
    oil: Oil,
    max_pressure: f64,
    half_width: f64,
    /// Eyring stress, if any.
    stress: Option<f64>,
}

impl Case {
    /// A contact of Moes' numbers at 1 m/s.
    fn new(m: f64, l: f64, slide: f64, stress: f64) -> Outcome<Self> {
        let max_pressure = l * (m / TAU).sqrt() / ALPHA;
        let load = PI * RADIUS * max_pressure * max_pressure / MODULUS;
        let viscosity = (load / (2.0 * MODULUS * RADIUS) / m).powi(2) * MODULUS * RADIUS;
        let contact = LineContact::at_pressure(
            Length::from_si(RADIUS),
            Pressure::from_si(MODULUS),
            Pressure::from_si(max_pressure),
            Speed::from_si(1.0),
            slide,
        )?;
        let stress = (stress > 0.0).then_some(1e6 * stress);
        let oil = Oil {
            viscosity: DynamicViscosity::from_si(viscosity),
            pressure_viscosity: PressureViscosity::from_si(ALPHA),
            viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
            density_law: DensityLaw::DowsonHigginson,
            shear_law: stress.map_or(ShearLaw::Newtonian, |stress| ShearLaw::Eyring {
                stress: Pressure::from_si(stress),
            }),
        };
        Ok(Self {
            contact,
            oil,
            max_pressure,
            half_width: 2.0 * RADIUS * max_pressure / MODULUS,
            stress,
        })
    }

    /// Speed of flank 1 over the mean speed of 1 m/s.
    fn speed(&self) -> f64 {
        self.contact.speed_1.si()
    }

    /// Amplitudes of pressure and film at the places, and the film of smooth flanks at the middle.
    fn solve(&self, wave: f64, cells: usize) -> Outcome<([[Complex<f64>; 2]; 3], f64)> {
        let rough = |profile: MovingProfile| RoughContact {
            contact: self.contact,
            oil: self.oil,
            surface_1: profile,
            surface_2: MovingProfile::smooth(),
        };
        let settings = RecordSettings {
            cells: 256,
            start: 0.0,
            length: 1.0,
            ..RecordSettings::default()
        };
        let smooth = transient::record(&rough(MovingProfile::smooth()), &settings)?;
        let film = smooth.value.smooth_film.si();
        let (length, amplitude, points) = (wave * self.half_width, AMPLITUDE * film, 256);
        let heights =
            (0..points).map(|i| amplitude * (TAU * f64::from(i) / f64::from(points)).cos());
        let spacing = Length::from_si(length / f64::from(points));
        let profile = Profile::new(spacing, heights.collect())?;
        let period = wave / self.speed();
        let settings = RecordSettings {
            cells,
            start: 3.5,
            length: (1.5 / period).ceil() * period,
            frame_interval: Some(period / FRAMES),
            ..RecordSettings::default()
        };
        let record = transient::record(&rough(MovingProfile::periodic(&profile)), &settings)?.value;
        let pressure = self.max_pressure * length / (PI * MODULUS * amplitude);
        let height = record.scales.film_length(1.0).si() / amplitude;
        let k = TAU / wave;
        let amplitudes = PLACES.map(|place| {
            let node = record.x.partition_point(|x| *x < place);
            let phase = |time: f64| k * (record.x[node] - self.speed() * time);
            let of = |value: &dyn Fn(&transient::Frame) -> f64| {
                let samples = (record.frames.iter()).map(|frame| (phase(frame.time), value(frame)));
                amplitude_of(&samples.collect::<Vec<_>>())
            };
            [
                pressure * of(&|frame| frame.pressure[node]),
                height * of(&|frame| frame.film[node]),
            ]
        });
        Ok((amplitudes, film))
    }

    /// p̂ at the places by linear theory.
    fn theory(&self, wave: f64, film: f64) -> [Complex<f64>; 3] {
        let k = TAU / wave;
        let drive = Complex::new(0.0, k * (1.0 - self.speed()));
        let sliding = (self.contact.speed_1 - self.contact.speed_2).si().abs();
        let thinned = self.stress.map_or(0.0, |stress| sliding / (film * stress));
        let viscosity = (self.oil.viscosity_law).relative(self.oil.pressure_viscosity, 1.0);
        let density = self.oil.density_law.relative(1.0);
        let soft = |x: f64| {
            let pressure = self.max_pressure * (1.0 - x * x).max(0.0).sqrt();
            let [value, slope] = density.at(pressure);
            let beta = PI * MODULUS * film * slope / (value * wave * self.half_width);
            (beta, viscosity.log(pressure)[0])
        };
        PLACES.map(|place| {
            let step = (place + 1.0) / STEPS as f64;
            let mut q = Complex::new(0.0, 0.0);
            for i in 0..STEPS {
                let (beta, log) = soft(-1.0 + (i as f64 + 0.5) * step);
                let fluidity = (1.0 / (self.oil.viscosity.si() * log.exp())).hypot(thinned);
                let relaxed = (k * film).powi(3) * MODULUS * fluidity
                    / (24.0 * self.half_width * self.half_width);
                let rate = drive + relaxed / (1.0 + beta);
                let steady = drive / rate;
                q = steady + (q - steady) * (-rate * step).exp();
            }
            q / (1.0 + soft(place).0)
        })
    }
}

/// Complex amplitude of samples over their phase, by least squares with their mean.
fn amplitude_of(samples: &[(f64, f64)]) -> Complex<f64> {
    let mut sums = [[0.0; 4]; 3];
    for (phase, value) in samples {
        let basis = [1.0, phase.cos(), phase.sin()];
        for (row, a) in sums.iter_mut().zip(basis) {
            for (sum, b) in row.iter_mut().zip([basis[0], basis[1], basis[2], *value]) {
                *sum += a * b;
            }
        }
    }
    for i in 0..3 {
        let pivot = sums[i].map(|value| value / sums[i][i]);
        sums[i] = pivot;
        for row in (0..3).filter(|row| *row != i) {
            let factor = sums[row][i];
            for (value, of_pivot) in sums[row].iter_mut().zip(pivot) {
                *value -= factor * of_pivot;
            }
        }
    }
    // cos(φ − θ) is the real part of e^(iφ) e^(−iθ).
    Complex::new(sums[1][3], -sums[2][3])
}
