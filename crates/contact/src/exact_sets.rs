//! Contact by exact sets: the matrix of the touching points, factored for each set.
//!
//! Every point is apart, touching or flowing. With these sets known the problem is linear and is solved by a Cholesky
//! factorisation; points whose pressure or gap has the wrong sign then change sets until none does (Hintermüller, Ito and Kunisch
//! 2002). The result is exact to round-off. A set of n points costs n³/6 products: up to about a hundred points that is less than
//! iterations with transforms.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y = p·a/(π·E*) | pressure in units that make the matrix dimensionless | m |
//! | A = C/a + D | dimensionless kernel and a constant that belongs to the datum | - |
//! | h, g, α | undeformed gap, gap g = A y + h − α, approach | m |

use asperity_core::cite;
use asperity_core::numerics::Cholesky;

use crate::convolution::vectorised;

/// Points that are searched together.
const BLOCK: usize = 64;
/// Overlap, relative to the range of the gap, that counts as round-off and leaves a point in its set.
const ROUND_OFF: f64 = 1e-12;

/// Set to which a point belongs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum State {
    Apart,
    Touching,
    Flowing,
}

impl State {
    /// Set of a pressure with this limit.
    pub(crate) fn from_pressure(pressure: f64, limit: f64) -> Self {
        if pressure > 0.0 && pressure >= limit {
            Self::Flowing
        } else if pressure > 0.0 {
            Self::Touching
        } else {
            Self::Apart
        }
    }
}

/// C/a, by the displacement of one cell.
#[derive(Debug, Clone, Default)]
pub(crate) struct Matrix {
    /// C/a at negative and positive lags along rolling, for one lag along the lead after the other.
    lags: Vec<f64>,
    columns: usize,
}

impl Matrix {
    /// The matrix with this kernel at the lags of `columns` columns, for one lag along the lead after the other.
    pub(crate) fn from_kernel(kernel: &[f64], columns: usize) -> Self {
        let rows = kernel.chunks_exact(columns);
        let lags = rows.flat_map(|row| row[1..].iter().rev().chain(row));
        Self {
            lags: lags.copied().collect(),
            columns,
        }
    }

    /// Number of columns up to which it is the matrix of a line.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// C/a of a row at the lags of the other columns from `column`, the first of them at the first place.
    fn lags_from(&self, rows: usize, column: usize) -> &[f64] {
        &self.lags[(2 * self.columns - 1) * rows + self.columns - 1 - column..]
    }

    /// C/a of points in one row with `columns` columns between them.
    pub(crate) fn lag(&self, columns: usize) -> f64 {
        self.lags_from(0, 0)[columns]
    }

    /// Factor of the rows and columns `touching` of A on a grid with this number of columns.
    pub(crate) fn factor(
        &self,
        touching: &[usize],
        (columns, constant): (usize, f64),
    ) -> Option<Cholesky> {
        let places: Vec<[usize; 2]> = touching
            .iter()
            .map(|point| [point / columns, point % columns])
            .collect();
        let element = |i: usize, j: usize| {
            let [[row, column], [other_row, other]] = [places[i], places[j]];
            self.lags_from(row.abs_diff(other_row), column)[other] + constant
        };
        Cholesky::new(touching.len(), element, 0.0)
    }

    /// Adds C/a y to the points `displaced` of rows of `columns`, with the pressures y of the `pressed` points.
    pub(crate) fn displace(&self, pressed: &[(usize, f64)], columns: usize, displaced: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || {
                for (row, displaced) in displaced.chunks_exact_mut(columns).enumerate() {
                    let lags = |at: usize| {
                        &self.lags_from(row.abs_diff(at / columns), at % columns)[..columns]
                    };
                    // Four points together: a displacement is read and written once for all of them.
                    let (groups, rest) = pressed.as_chunks::<4>();
                    for group in groups {
                        let [a, b, c, d] = group.map(|(at, _)| lags(at));
                        let [y_a, y_b, y_c, y_d] = group.map(|(_, y)| y);
                        for (i, u) in displaced.iter_mut().enumerate() {
                            *u += (a[i] * y_a + b[i] * y_b) + (c[i] * y_c + d[i] * y_d);
                        }
                    }
                    for (at, y) in rest {
                        for (u, c) in displaced.iter_mut().zip(lags(*at)) {
                            *u += c * y;
                        }
                    }
                }
            },
        );
    }
}

/// A contact in the units of the matrix.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SetProblem<'a> {
    pub(crate) matrix: &'a Matrix,
    /// h plus the displacement by a prescribed pressure, minus a controlled approach \[m\].
    pub(crate) gap: &'a [f64],
    pub(crate) columns: usize,
    /// D
    pub(crate) constant: f64,
    /// Σy if the load is controlled \[m\].
    pub(crate) sum: Option<f64>,
    /// Largest y \[m\].
    pub(crate) limit: f64,
    /// Range of the gap \[m\].
    pub(crate) range: f64,
    /// Most points that touch, and most sets that are solved.
    pub(crate) most: [usize; 2],
}

/// Sets of a contact, with the pressures of the last set solved.
#[derive(Debug, Clone, Default)]
pub(crate) struct ExactSets {
    pub(crate) states: Vec<State>,
    /// y
    pub(crate) y: Vec<f64>,
    /// C/a y
    pub(crate) displaced: Vec<f64>,
    /// Points of the set solved last.
    pub(crate) touching: Vec<usize>,
    /// Points whose displacement was added last, with y.
    pub(crate) pressed: Vec<(usize, f64)>,
}

/// Sets that settled.
pub(crate) struct Settled {
    /// α; zero when the approach is controlled.
    pub(crate) approach: f64,
    /// Linear systems solved.
    pub(crate) steps: usize,
}

/// Reason for which sets did not settle.
pub(crate) enum Unsettled {
    /// More points touch than may.
    TooMany(usize),
    /// After these steps as many points still change, or no point is left to carry the load.
    Changing { steps: usize, points: usize },
}

impl ExactSets {
    /// Solves the problem from the present states, until no point changes its set.
    pub(crate) fn settle(&mut self, problem: &SetProblem) -> Result<Settled, Unsettled> {
        let [most_points, most_steps] = problem.most;
        let mut points = self.states.len();
        for steps in 1..=most_steps {
            self.list_touching();
            if self.touching.len() > most_points {
                return Err(Unsettled::TooMany(self.touching.len()));
            }
            let Some(approach) = self.solve(problem) else {
                return Err(Unsettled::Changing { steps, points });
            };
            points = self.update(problem, approach);
            if points == 0 {
                return Ok(Settled { approach, steps });
            }
        }
        Err(Unsettled::Changing {
            steps: most_steps,
            points,
        })
    }

    /// Lists the points that touch. Most blocks have none.
    fn list_touching(&mut self) {
        self.touching.clear();
        for (block, states) in self.states.chunks(BLOCK).enumerate() {
            let is_touching = |state: &State| *state == State::Touching;
            if !states.iter().fold(false, |any, s| any | is_touching(s)) {
                continue;
            }
            let numbered = states.iter().zip(block * BLOCK..);
            let touching = numbered.filter(|(state, _)| is_touching(state));
            self.touching.extend(touching.map(|(_, i)| i));
        }
    }

    /// The pressures \[Pa\] of sets that settled, with the limit and the compliance a/(π·E*); at the points that flow the limit to
    /// the last digit.
    pub(crate) fn pressures(&self, limit: f64, compliance: f64) -> impl Iterator<Item = f64> {
        let points = self.states.iter().zip(&self.y);
        points.map(move |(state, y)| match state {
            State::Apart => 0.0,
            State::Touching => y / compliance,
            State::Flowing => limit,
        })
    }

    /// p = π·E*·C⁻¹·(δ − h)                                                                 `[P3]`
    ///
    /// Pressures and approach that close the gap of the touching points; `None` if no touching point is left to carry the rest of
    /// the load.
    fn solve(&mut self, problem: &SetProblem) -> Option<f64> {
        cite!("P3");
        let SetProblem { matrix, .. } = *problem;
        let flows = |state: &State| match state {
            State::Flowing => problem.limit,
            _ => 0.0,
        };
        self.y.clear();
        self.y.extend(self.states.iter().map(flows));
        let flowing: f64 = self.y.iter().sum();
        self.displaced.clear();
        self.displaced.resize(self.y.len(), 0.0);
        self.pressed.clear();
        if flowing > 0.0 {
            let y = self.y.iter().copied().enumerate();
            self.pressed.extend(y.filter(|(_, y)| *y > 0.0));
            matrix.displace(&self.pressed, problem.columns, &mut self.displaced);
        }
        if self.touching.is_empty() {
            return problem.sum.is_none().then_some(0.0);
        }
        let factor = matrix.factor(&self.touching, (problem.columns, problem.constant))?;
        // The pressures are those at zero approach plus α times those of a unit approach.
        let by_flowing = problem.constant * flowing;
        let closed = self.touching.iter();
        let closed = closed.map(|&i| -problem.gap[i] - self.displaced[i] - by_flowing);
        let mut closed: Vec<f64> = closed.collect();
        factor.solve(&mut closed);
        let mut unit = vec![1.0; self.touching.len()];
        factor.solve(&mut unit);
        let approach = problem.sum.map_or(0.0, |sum| {
            let carried = flowing + closed.iter().sum::<f64>();
            (sum - carried) / unit.iter().sum::<f64>()
        });
        for ((&point, closed), unit) in self.touching.iter().zip(&closed).zip(&unit) {
            self.y[point] = closed + approach * unit;
        }
        self.pressed.clear();
        let touching = self.touching.iter().map(|&i| (i, self.y[i]));
        self.pressed.extend(touching);
        matrix.displace(&self.pressed, problem.columns, &mut self.displaced);
        Some(approach)
    }

    /// Moves points whose pressure or gap has the wrong sign to another set and returns their number.
    fn update(&mut self, problem: &SetProblem, approach: f64) -> usize {
        cite!("Active-1");
        let limit = problem.limit;
        let round_off = ROUND_OFF * problem.range;
        let rise = problem.constant * self.y.iter().sum::<f64>() - approach;
        let mut changes = 0;
        let blocks = (self.states.chunks_mut(BLOCK).zip(self.y.chunks(BLOCK)))
            .zip(self.displaced.chunks(BLOCK).zip(problem.gap.chunks(BLOCK)));
        for ((states, y), (displaced, gap)) in blocks {
            // Most blocks are apart and stay so.
            let is_apart = vectorised(
                #[inline(always)]
                || {
                    let points = y.iter().zip(displaced).zip(gap);
                    !points.fold(false, |any, ((y, u), h)| {
                        any | (*y != 0.0) | (u + h + rise < -round_off)
                    })
                },
            );
            if is_apart {
                continue;
            }
            let points = states.iter_mut().zip(y).zip(displaced.iter().zip(gap));
            for ((state, &y), (u, h)) in points {
                let g = u + h + rise;
                let next = match *state {
                    State::Touching if y < 0.0 => State::Apart,
                    State::Touching if y >= limit => State::Flowing,
                    State::Apart if g < -round_off => State::Touching,
                    State::Flowing if g > round_off => State::Touching,
                    same => same,
                };
                changes += usize::from(next != *state);
                *state = next;
            }
        }
        changes
    }
}
