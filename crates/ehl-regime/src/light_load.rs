//! Pressure of a smooth film at light load, where it reaches beyond the Hertz contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | M, L | Moes' load and material number | - |
//! | a, p₀, w | half-width, largest pressure, and load per length of the Hertz contact | m, Pa, N/m |
//! | h, h_c | film thickness, and at the centre | m |
//! | η₀, α | viscosity at ambient pressure, pressure-viscosity coefficient | Pa·s, 1/Pa |
//! | p̃ | pressure at which the central film shears as the film does where it is | Pa |
//! | u | width on which p̃ is higher than at a place, over that of the Hertz contact | - |
//!
//! Source: 64 steady solutions of this project's own solver (flooded, isothermal, Newtonian, Roelands' viscosity with the exponent 0.6,
//! Dowson and Higginson's density) for M from 0.1 to 70 and L from 2 to 16. Scaled by p₀ and a they depend on M and L alone but
//! for the density and Roelands' law. Below M = 10 the pressure begins long before the contact; at M = 1.4, which the first stage
//! of an electric drive has at .3 GPa and 9000 1/min, the largest is three quarters of p₀.

use asperity_core::cite;

use crate::attenuation::MoesNumbers;

/// M of the solutions.
const LOADS: [f64; 16] = [
    0.1, 0.17, 0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 12.0, 20.0, 35.0, 70.0,
];
/// L of the solutions.
const MATERIALS: [f64; 4] = [2.0, 4.0, 8.0, 16.0];
/// Numbers of a solution: four coefficients of the excess, and the inlet.
const NUMBERS: usize = 5;
/// The numbers of the solutions.
const SOLUTIONS: [[[f64; NUMBERS]; MATERIALS.len()]; LOADS.len()] = [
    [
        [-0.96569, 0.54613, -0.19881, 0.46503, 12.72805],
        [-0.96445, 0.54784, -0.16730, 0.43819, 12.86561],
        [-0.96294, 0.56164, -0.20030, 0.46712, 13.14509],
        [-0.95955, 0.56610, -0.20994, 0.47764, 13.84312],
    ],
    [
        [-0.94601, 0.72269, -0.94815, 1.12318, 7.17576],
        [-0.94403, 0.78191, -1.09113, 1.25290, 7.41886],
        [-0.92842, 0.52985, -0.09248, 0.35553, 7.86753],
        [-0.91837, 0.54259, -0.12700, 0.38977, 8.62791],
    ],
    [
        [-0.88473, 0.50454, -0.35252, 0.59680, 3.89843],
        [-0.87506, 0.58570, -0.48067, 0.70881, 4.10694],
        [-0.85372, 0.53612, -0.21974, 0.47616, 4.59750],
        [-0.82957, 0.54305, -0.21918, 0.47612, 5.68427],
    ],
    [
        [-0.78778, 0.41303, -0.45069, 0.69430, 2.21284],
        [-0.76143, 0.47091, -0.38242, 0.63449, 2.46254],
        [-0.72360, 0.47731, -0.30386, 0.56560, 3.02539],
        [-0.67853, 0.46113, -0.26824, 0.54314, 4.35266],
    ],
    [
        [-0.67750, 0.23345, -0.29801, 0.58914, 1.55587],
        [-0.64274, 0.31860, -0.27275, 0.56945, 1.80797],
        [-0.59303, 0.35633, -0.35411, 0.65501, 2.35362],
        [-0.51244, 0.17299, -0.05318, 0.47959, 3.76118],
    ],
    [
        [-0.51464, 0.01086, -0.23085, 0.59390, 1.10424],
        [-0.47984, 0.14992, -0.42953, 0.78653, 1.34741],
        [-0.40597, -0.03181, 0.00412, 0.50325, 1.91406],
        [-0.22761, -1.07317, 1.90077, -0.56130, 3.19994],
    ],
    [
        [-0.33360, -0.23070, -0.11564, 0.56773, 0.86184],
        [-0.29885, -0.19480, -0.14224, 0.67289, 1.09698],
        [-0.19043, -0.73575, 0.87156, 0.12151, 1.62531],
        [0.04273, -2.61785, 4.68213, -2.12600, 2.87004],
    ],
    [
        [-0.16401, -0.38760, -0.13380, 0.61581, 0.69932],
        [-0.12126, -0.59458, 0.33089, 0.41182, 0.93885],
        [0.00143, -1.46616, 1.96798, -0.45761, 1.43010],
        [0.12179, -2.24842, 3.24148, -1.09597, 2.43575],
    ],
    [
        [-0.07132, -0.30262, -0.49994, 0.83508, 0.57816],
        [-0.03284, -0.58632, 0.08407, 0.56169, 0.79738],
        [0.03258, -0.98538, 0.68940, 0.30120, 1.19847],
        [0.07937, -0.90789, -0.00982, 0.89543, 2.05448],
    ],
    [
        [-0.05356, 0.10573, -1.40698, 1.33403, 0.44384],
        [-0.03990, 0.11126, -1.54838, 1.52450, 0.61669],
        [-0.01701, 0.21942, -2.04760, 1.90526, 0.96869],
        [-0.00373, 0.48983, -2.91484, 2.48962, 1.68608],
    ],
    [
        [-0.05428, 0.34624, -1.64604, 1.29286, 0.35928],
        [-0.05609, 0.56445, -2.28017, 1.78392, 0.49929],
        [-0.05507, 0.82704, -3.00383, 2.25521, 0.79072],
        [-0.05115, 0.97647, -3.29614, 2.35462, 1.45340],
    ],
    [
        [-0.04194, 0.31934, -1.27068, 0.91410, 0.27758],
        [-0.04402, 0.43151, -1.50926, 1.07351, 0.40035],
        [-0.04833, 0.60903, -1.88187, 1.27048, 0.63011],
        [-0.04534, 0.64969, -1.86470, 1.18216, 1.15595],
    ],
    [
        [-0.02494, 0.16005, -0.61835, 0.39086, 0.20665],
        [-0.02572, 0.19411, -0.64204, 0.40293, 0.29988],
        [-0.02448, 0.15985, -0.35934, 0.11360, 0.49578],
        [-0.02295, 0.13383, -0.12570, -0.13155, 0.97214],
    ],
    [
        [-0.01046, 0.01211, -0.06638, -0.03000, 0.14388],
        [-0.01000, 0.00101, 0.00972, -0.07968, 0.21036],
        [-0.00821, -0.05172, 0.25011, -0.27922, 0.34615],
        [-0.00506, -0.13602, 0.60297, -0.58039, 0.72011],
    ],
    [
        [-0.00334, -0.04241, 0.13676, -0.16842, 0.09840],
        [-0.00305, -0.04899, 0.16988, -0.17880, 0.14345],
        [-0.00210, -0.07378, 0.26672, -0.24459, 0.23413],
        [-0.00040, -0.11404, 0.41423, -0.35672, 0.48514],
    ],
    [
        [-0.00042, -0.04532, 0.15103, -0.15677, 0.06058],
        [-0.00045, -0.04202, 0.14339, -0.13891, 0.09043],
        [0.00007, -0.05323, 0.18387, -0.16288, 0.16023],
        [0.00056, -0.06238, 0.21418, -0.17988, 0.32601],
    ],
];

/// Where a smooth film shears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightLoad {
    /// Coefficients c of the excess over p₀.
    pub excess: [f64; NUMBERS - 1],
    /// Stress before and behind the width 2a of the highest pressures, as a mean over this width and over η₀ V/h_c.
    pub inlet: f64,
}

impl LightLoad {
    /// The film of a line contact.
    ///
    /// ```text
    /// p̃ = p + ln(h_c/h)/α = p₀ (√(1 − u²) + c₀ + c₁ u² + c₂ u⁴ + c₃ u⁶) for u < 1
    /// I = ∫ e^(α p) (h_c/h) dx/(2a) for u > 1                                       [Light-load]
    /// ```
    ///
    /// The coefficients are interpolated by cubics in ln M and ln L between the solutions, ln I too, held below M = 0.1 and in
    /// proportion to 1/M above M = 70. At full load c and I are small: Hertz's pressure.
    ///
    /// ```
    /// use asperity_ehl_regime::{MoesNumbers, light_load::LightLoad};
    /// let at = |load, material| LightLoad::of(&MoesNumbers { load, material });
    /// assert!((at(1.4, 8.0).excess[0] + 0.19043).abs() < 1e-12 && (at(1.4, 8.0).inlet - 1.62531).abs() < 1e-12);
    /// assert!(at(2000.0, 6.0).excess.iter().all(|c| c.abs() < 0.01));
    /// ```
    #[must_use]
    pub fn of(numbers: &MoesNumbers) -> Self {
        cite!("Light-load");
        let (first, last) = (LOADS[0], LOADS[LOADS.len() - 1]);
        let within = numbers.load.clamp(first, last);
        let [low, high] = [MATERIALS[0], MATERIALS[MATERIALS.len() - 1]];
        let material = numbers.material.clamp(low, high).ln();
        let (loads, materials) = (LOADS.map(f64::ln), MATERIALS.map(f64::ln));
        let number = |k: usize, of: fn(f64) -> f64| {
            let of_row = |row: &[[f64; NUMBERS]; MATERIALS.len()]| {
                cubic(&materials, &row.map(|solution| of(solution[k])), material)
            };
            cubic(&loads, &SOLUTIONS.each_ref().map(of_row), within.ln())
        };
        // The rigid contact below, Hertz's above.
        let beyond = (last / numbers.load).min(1.0);
        let below = (first / numbers.load).max(1.0);
        Self {
            excess: std::array::from_fn(|k| beyond * number(k, |c| c)),
            inlet: beyond * below * number(NUMBERS - 1, f64::ln).exp(),
        }
    }
}

/// Cubics through points, with the slope of the parabola through three of them at each.
fn cubic<const N: usize>(x: &[f64; N], y: &[f64; N], at: f64) -> f64 {
    let chord = |k: usize| (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
    let slope = |k: usize| {
        let middle = k.clamp(1, N - 2);
        let [left, right] = [chord(middle - 1), chord(middle)];
        let bend = (right - left) / (x[middle + 1] - x[middle - 1]);
        left + bend * (2.0 * x[k] - x[middle - 1] - x[middle])
    };
    let low = x.partition_point(|node| *node <= at).clamp(1, N - 1) - 1;
    let width = x[low + 1] - x[low];
    let t = (at - x[low]) / width;
    let [rise, begin, end] = [
        y[low + 1] - y[low],
        slope(low) * width,
        slope(low + 1) * width,
    ];
    let (c2, c3) = (3.0 * rise - 2.0 * begin - end, begin + end - 2.0 * rise);
    y[low] + t * (begin + t * (c2 + t * c3))
}
