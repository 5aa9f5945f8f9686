//! Discrete Reynolds equation: flux through the faces, its slopes, and the balance of each node.
//!
//! Finite volumes around the nodes, so that oil is conserved to rounding. The Couette part is the third-order
//! upwind-biased interpolation QUICK (Leonard, Comput. Methods Appl. Mech. Eng. 19, 1979, 59-98): central differences
//! oscillate in the stiff contact, where the pressure gradient carries no flow, and first-order upwinding smears the
//! roughness. The Poiseuille part uses the mean fluidity that is exact for an exponential viscosity between two nodes,
//! because η varies by decades from node to node. Between ridges that are much shorter than the contact it is the mean over them.
//!
//! | symbol | meaning |
//! |---|---|
//! | P, H | pressure, film |
//! | θ | void fraction of a cavitated node |
//! | m | (1 − θ)·ρ·H, oil at a node |
//! | φ | fluidity η₀/η |
//! | λ | 12·u_m·η₀·R²/(a³·p₀) |
//! | Σ | standard deviation of the ridges across the flow |

use asperity_core::cite;

use crate::bands::Bands;
use crate::fluid::Fluid;
use crate::grid::FilmGrid;

/// Thinnest film in the Poiseuille conductance; thinner or negative films occur between iterations.
const LEAST_FILM: f64 = 1e-9;
/// Difference of logarithms below which the logarithmic mean is a series.
const SERIES: f64 = 1e-3;
/// Largest half difference of logarithms, below the overflow of the exponential.
const LARGEST: f64 = 300.0;

/// Fields on the nodes.
#[derive(Clone, Copy)]
pub(crate) struct ReynoldsFields<'a> {
    pub(crate) pressure: &'a [f64],
    pub(crate) film: &'a [f64],
    pub(crate) void: &'a [f64],
}

/// Flux and its slopes at one state.
pub(crate) struct Reynolds {
    /// Flux through the face after each node but the last.
    pub(crate) flux: Vec<f64>,
    /// Oil at the nodes.
    pub(crate) mass: Vec<f64>,
    /// Slopes of the oil at the nodes over pressure, film and void fraction.
    pub(crate) mass_slopes: [Vec<f64>; 3],
    /// Slopes of the balance of each inner node over pressure, film and void fraction.
    pub(crate) slopes: [Bands; 3],
    log_viscosity: Vec<[f64; 2]>,
    /// ρ·H³/λ with its slopes over pressure and film.
    conductance: Vec<[f64; 3]>,
}

/// Mean fluidity of a face between logarithmic viscosities a and b, with its slopes over both.
///
/// The mean is exact where ln η varies linearly between the nodes.
///
/// φ = (e^−a − e^−b)/(b − a)                                                `[Log-mean]`
pub(crate) fn log_mean(a: f64, b: f64) -> [f64; 3] {
    let half = 0.5 * (b - a);
    let scale = (-0.5 * (a + b)).exp();
    let (ratio, slope) = if half.abs() < SERIES {
        (1.0 + half * half / 6.0, half / 3.0)
    } else {
        let x = half.clamp(-LARGEST, LARGEST);
        let grown = x.exp();
        let (sinh, cosh) = (0.5 * (grown - 1.0 / grown), 0.5 * (grown + 1.0 / grown));
        (sinh / x, (cosh * x - sinh) / (x * x))
    };
    [
        scale * ratio,
        -0.5 * scale * (ratio + slope),
        0.5 * scale * (slope - ratio),
    ]
}

impl Reynolds {
    pub(crate) fn new(nodes: usize) -> Self {
        let zeros = || vec![0.0; nodes];
        Self {
            flux: vec![0.0; nodes - 1],
            mass: zeros(),
            mass_slopes: [zeros(), zeros(), zeros()],
            slopes: std::array::from_fn(|_| Bands::zero(nodes)),
            log_viscosity: vec![[0.0, 0.0]; nodes],
            conductance: vec![[0.0; 3]; nodes],
        }
    }

    /// Flux through every face and its slopes.
    ///
    /// ```text
    /// F = m̂ − (ρH³/λ)/(1 + 6 Σ²/H²)·φ·dP/dX,  m̂ = −m₋/8 + 3m/4 + 3m₊/8 on an even grid            [EHL-flux]
    /// ```
    pub(crate) fn evaluate(&mut self, grid: &FilmGrid, fluid: &Fluid, fields: ReynoldsFields) {
        cite!("EHL-flux");
        cite!("Log-mean");
        self.nodal(fluid, fields);
        for bands in &mut self.slopes {
            bands.clear();
        }
        for face in 0..grid.spacing.len() {
            self.face(grid, fluid, fields, face);
        }
    }

    fn nodal(&mut self, fluid: &Fluid, fields: ReynoldsFields) {
        for i in 0..self.mass.len() {
            let (p, h, void) = (fields.pressure[i], fields.film[i], fields.void[i]);
            self.log_viscosity[i] = fluid.viscosity.log(p);
            let [rho, rho_slope] = fluid.density.at(p);
            let open = h.max(LEAST_FILM);
            let rough = 6.0 * (fluid.roughness / open).powi(2);
            let conductance = rho * open * open * open / (fluid.speed * (1.0 + rough));
            self.conductance[i] = [
                conductance,
                conductance * rho_slope / rho,
                (3.0 + 2.0 * rough / (1.0 + rough)) * conductance / open,
            ];
            self.mass[i] = (1.0 - void) * rho * h;
            self.mass_slopes[0][i] = (1.0 - void) * rho_slope * h;
            self.mass_slopes[1][i] = (1.0 - void) * rho;
            self.mass_slopes[2][i] = -rho * h;
        }
    }

    /// Flux through the face after node `i`; its slopes enter the balances on both sides.
    fn face(&mut self, grid: &FilmGrid, fluid: &Fluid, fields: ReynoldsFields, i: usize) {
        let (h, [w_0, w_1, w_2]) = (grid.spacing[i], grid.to_face[i]);
        let before = i.saturating_sub(1);
        let [plain, by_a, by_b] = log_mean(self.log_viscosity[i][0], self.log_viscosity[i + 1][0]);
        let film = 0.5 * (fields.film[i].max(LEAST_FILM) + fields.film[i + 1].max(LEAST_FILM));
        let thinned = fluid.thinning.fluidity(plain, film);
        let phi = thinned.value;
        let a_slope = thinned.by_fluidity * by_a * self.log_viscosity[i][1];
        let b_slope = thinned.by_fluidity * by_b * self.log_viscosity[i + 1][1];
        let (here, there) = (self.conductance[i], self.conductance[i + 1]);
        let mean = 0.5 * (here[0] + there[0]);
        let gradient = (fields.pressure[i + 1] - fields.pressure[i]) / h;
        let m = &self.mass;
        self.flux[i] = w_0 * m[before] + w_1 * m[i] + w_2 * m[i + 1] - mean * phi * gradient;
        let thinning = 0.5 * mean * thinned.by_film;
        let couette = |k: usize| {
            let slope = &self.mass_slopes[k];
            [w_0 * slope[before], w_1 * slope[i], w_2 * slope[i + 1]]
        };
        let (mut pressure, mut by_film, void) = (couette(0), couette(1), couette(2));
        pressure[1] += mean * phi / h - (0.5 * here[1] * phi + mean * a_slope) * gradient;
        pressure[2] -= mean * phi / h + (0.5 * there[1] * phi + mean * b_slope) * gradient;
        by_film[1] -= (0.5 * here[2] * phi + thinning) * gradient;
        by_film[2] -= (0.5 * there[2] * phi + thinning) * gradient;
        for (bands, slopes) in self.slopes.iter_mut().zip([pressure, by_film, void]) {
            add_face(bands, i, slopes);
        }
    }

    /// Balance of each inner node, outflow − inflow; the ends are zero.
    pub(crate) fn balance(&self, residual: &mut [f64]) {
        let last = self.flux.len();
        residual[0] = 0.0;
        residual[last] = 0.0;
        for (i, pair) in self.flux.windows(2).enumerate() {
            residual[i + 1] = pair[1] - pair[0];
        }
    }

    /// Adds the storage w·(c₀·m + past) to the balance and its slopes.
    pub(crate) fn add_storage(&mut self, grid: &FilmGrid, storage: Storage, residual: &mut [f64]) {
        for i in 1..residual.len() - 1 {
            let w = grid.weights[i];
            residual[i] += w * (storage.rate * self.mass[i] + storage.past[i]);
            for (bands, slope) in self.slopes.iter_mut().zip(&self.mass_slopes) {
                bands.diagonal[2][i] += w * storage.rate * slope[i];
            }
        }
    }
}

/// Time derivative of the oil at a node: rate·m + past.
#[derive(Clone, Copy)]
pub(crate) struct Storage<'a> {
    pub(crate) rate: f64,
    pub(crate) past: &'a [f64],
}

/// Adds the slopes of the flux after node `i` over nodes i − 1, i, i + 1 to rows i and i + 1.
fn add_face(bands: &mut Bands, i: usize, slopes: [f64; 3]) {
    let last = bands.diagonal[2].len() - 1;
    let [s_0, s_1, s_2] = slopes;
    let [far, before, here, after] = &mut bands.diagonal;
    if i > 0 {
        before[i] += s_0;
        here[i] += s_1;
        after[i] += s_2;
    }
    if i + 1 < last {
        if i > 0 {
            far[i + 1] -= s_0;
        }
        before[i + 1] -= s_1;
        here[i + 1] -= s_2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oil::Oil;
    use asperity_core::quantity::{DynamicViscosity, PressureViscosity};
    use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw, ShearThinning};

    fn fluid(thinning: ShearThinning) -> Fluid {
        let oil = Oil {
            viscosity: DynamicViscosity::from_si(0.01),
            pressure_viscosity: PressureViscosity::from_si(1.8e-8),
            viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
            density_law: DensityLaw::DowsonHigginson,
            shear_law: ShearLaw::Newtonian,
        };
        Fluid {
            viscosity: oil.viscosity_over(1.2e9),
            density: oil.density_law.relative(1.2e9),
            thinning,
            speed: 0.005,
            roughness: 0.04,
        }
    }

    #[test]
    fn the_log_mean_is_exact_for_barus() {
        // ∫ dP over a face at a constant reduced pressure gradient: φ·ΔP = (e^−a − e^−b)/α.
        for (a, b) in [(0.3_f64, 4.0), (2.0, 2.0 + 1e-5), (7.0, 1.0), (0.0, 60.0)] {
            let exact = -(-a).exp() * (-(b - a)).exp_m1() / (b - a);
            let [mean, by_a, by_b] = log_mean(a, b);
            assert!((mean / exact - 1.0).abs() < 1e-12);
            let step = 1e-5;
            let d_a = (log_mean(a + step, b)[0] - log_mean(a - step, b)[0]) / (2.0 * step);
            let d_b = (log_mean(a, b + step)[0] - log_mean(a, b - step)[0]) / (2.0 * step);
            assert!((by_a - d_a).abs() < 1e-8 * mean && (by_b - d_b).abs() < 1e-8 * mean);
        }
    }

    #[test]
    fn the_slopes_of_the_balance_are_its_differences() {
        let grid = FilmGrid::new(vec![-2.0, -1.4, -1.0, -0.7, -0.2, 0.1, 0.5, 1.1, 1.5]);
        let n = grid.nodes();
        let wave = |i: usize, k: f64| (k * i as f64).sin();
        let fields = [
            (0..n).map(|i| 0.6 + 0.4 * wave(i, 1.3)).collect::<Vec<_>>(),
            (0..n).map(|i| 0.09 + 0.03 * wave(i, 2.1)).collect(),
            (0..n).map(|i| 0.2 + 0.1 * wave(i, 0.9)).collect(),
        ];
        let thinnings = [
            ShearThinning::None,
            ShearThinning::Eyring { rate: 0.01 },
            ShearThinning::Carreau {
                rate: 0.01,
                exponent: 0.45,
            },
        ];
        for thinning in thinnings {
            let fluid = fluid(thinning);
            let past = vec![0.03; n];
            let balance = |fields: &[Vec<f64>; 3]| {
                let mut reynolds = Reynolds::new(n);
                let view = ReynoldsFields {
                    pressure: &fields[0],
                    film: &fields[1],
                    void: &fields[2],
                };
                reynolds.evaluate(&grid, &fluid, view);
                let mut residual = vec![0.0; n];
                reynolds.balance(&mut residual);
                let storage = Storage {
                    rate: 3.0,
                    past: &past,
                };
                reynolds.add_storage(&grid, storage, &mut residual);
                (residual, reynolds)
            };
            let (_, reynolds) = balance(&fields);
            for field in 0..3 {
                for j in 0..n {
                    let moved = |step: f64| {
                        let mut fields = fields.clone();
                        fields[field][j] += step;
                        balance(&fields).0
                    };
                    let (up, down) = (moved(1e-6), moved(-1e-6));
                    for i in 1..n - 1 {
                        let slope: f64 = reynolds.slopes[field]
                            .row(i)
                            .filter(|(column, _)| *column == j)
                            .map(|(_, value)| value)
                            .sum();
                        let expected = (up[i] - down[i]) / 2e-6;
                        let scale = 1.0 + expected.abs();
                        assert!((slope - expected).abs() < 1e-6 * scale, "{field} {i} {j}");
                    }
                }
            }
        }
    }
}
