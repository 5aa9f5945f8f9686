//! Gradient of the loss of a mesh over the heights of both traces.
//!
//! The heights act through the rough contacts and through the roughness that the inlets leave
//! ([`PositionFilm::gradient`](asperity_mixed_film::PositionFilm::gradient)). Contact sets, places of the windows, and the
//! relief are held. Kinks of the loss, where the gradient is one-sided: a cell that enters or leaves a contact, another cell
//! that becomes the highest of a peak of the pressure or the lowest between two peaks, two such valleys of equal pressure, the
//! first touch, a share at a row of the table, a slope of the gap that is held, a film at its floor.

use asperity_core::cite;
use asperity_core::numerics::add_times;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Temperature;
use asperity_core::task::par_map;
use asperity_mixed_film::{Kinks, TraceChange};
use asperity_roughness::resampling::respaced_gradient;

use super::bulk_temperature::rise_exponent;
use super::stages::{Stages, losses_at, sampled, warmed};
use crate::contacts::Contacts;
use crate::lubrication::PositionGradient;
use crate::mesh::numbered;
use crate::result::Losses;
use asperity_case::case::{LoadedCase, OperatingCase, ShareLaw};
use asperity_case::error::{Error, PositionError};

/// Step of the difference quotient of the loss over the bulk temperature \[K\].
const TEMPERATURE_STEP: f64 = 0.1;

/// Gradient of the loss of a mesh over the heights of both traces.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LossGradient {
    /// Derivative of the loss over the height of each point of both prepared traces \[W/m\].
    pub by_height: [Vec<f64>; 2],
    /// The losses, from exact contacts.
    pub losses: Losses,
    /// Change of the loss with the equilibrium bulk temperature over its change at a held temperature; 1 with a stated
    /// temperature.
    pub heat_balance: f64,
    /// Sliding loss at positions whose contact the traces do not resolve \[W\]: it is left out of the gradient.
    pub unresolved_w: f64,
    /// Windows at or next to a kink of the loss.
    pub kinks: Kinks,
    /// The case with exact contacts and its number of offsets stated, at the bulk temperature as the case states it: its
    /// losses with other traces can be compared.
    pub case: LoadedCase,
    /// Its contacts.
    pub contacts: Contacts,
    /// The gradient of each position.
    positions: Vec<PositionGradient>,
}

impl LossGradient {
    /// Derivative of the loss at each offset of the traces along each change of a trace \[W\].
    ///
    /// # Errors
    /// When a change does not have as many heights as its prepared trace.
    pub fn along(&self, changes: &[TraceChange]) -> Result<Vec<Vec<f64>>, Error> {
        let of = |at: &PositionGradient| {
            let along = at.unflattening.along(&at.windows, changes);
            along.map_err(PositionError::from)
        };
        let of_positions = par_map(&self.positions, of);
        let mut sums = vec![vec![0.0; self.case.case.model.offsets]; changes.len()];
        for of_position in of_positions {
            for (sums, of_change) in sums.iter_mut().zip(&of_position.map_err(Box::new)?) {
                add_times(sums, self.heat_balance, of_change);
            }
        }
        Ok(sums)
    }

    /// Derivative of the loss over the height of each point of both traces as they were read, in their own direction \[W/m\];
    /// `None` of a trace whose preparation is not linear, or that was not read.
    ///
    /// ```text
    /// ∂P/∂z = Aᵀ ∂P/∂z_p                                                    [Measured-gradient]
    /// ```
    ///
    /// A prepares a trace: mirroring, form, filters, ends and spacing. Spikes that were replaced, gaps, place and relief are held.
    ///
    /// # Errors
    /// When the traces are not the ones of the files.
    pub fn by_measured_height(&self) -> Result<[Option<Vec<f64>>; 2], Error> {
        cite!("Measured-gradient");
        let prepared = self.case.surfaces.traces().map_err(Box::new)?;
        let of = |body: usize| -> Result<Option<Vec<f64>>, PositionError> {
            let flank = &self.case.flanks[body];
            let Some(record) = &flank.preparation else {
                return Ok(None);
            };
            let over_prepared = respaced_gradient(
                &self.by_height[body],
                record.points_after,
                record.spacing,
                prepared[body].spacing(),
            );
            let mut measured = record.gradient(&over_prepared)?;
            if flank.mirrored {
                measured.iter_mut().for_each(|heights| heights.reverse());
            }
            Ok(measured)
        };
        Ok([of(0).map_err(Box::new)?, of(1).map_err(Box::new)?])
    }
}

/// Gradient of the loss of a case over the heights of both prepared traces.
///
/// ```text
/// dP/dz = Σ_i w_i V_s,i f_i (1/K) Σ_k dμ_ik/dz / (1 − n (∂P/∂T) (T_b − T_oil)/P)      [Loss-gradient]
/// ```
///
/// The last factor belongs to a bulk temperature that follows from the loss, of which its rise is the power n.
///
/// # Errors
/// As [`Run::losses`](crate::Run::losses), and when the loss is not from the default load share and film friction, or a flank has no
/// trace or several.
pub fn gradient(loaded: &LoadedCase) -> Result<LossGradient, Error> {
    gradient_of(loaded, &[])
}

/// As [`gradient`], with exact contacts that were computed before, if they are of this case at any oil, speed, temperature and
/// constants.
///
/// # Errors
/// As [`gradient`].
pub fn gradient_with(contacts: &Contacts, loaded: &LoadedCase) -> Result<LossGradient, Error> {
    gradient_of(loaded, &[contacts])
}

/// Derivatives of the loss along changes of the traces, at each offset, as a mean over these changes by Simpson's rule: from
/// [`LossGradient::along`] before them, half-way and after them \[W\].
///
/// ```text
/// P(z + Δz) − P(z) = ḡ Δz,  ḡ = (g(z) + 4 g(z + Δz/2) + g(z + Δz))/6                       [Mean-gradient]
/// ```
///
/// Contact sets change along Δz. A ridge that stays in contact until it is half pressed has its steepest gradient half-way.
#[must_use]
pub fn mean_along([before, half, after]: [&[Vec<f64>]; 3]) -> Vec<Vec<f64>> {
    cite!("Mean-gradient");
    let of_offsets = |((before, half), after): ((&Vec<f64>, &Vec<f64>), &Vec<f64>)| {
        let of_three = before.iter().zip(half).zip(after);
        of_three
            .map(|((before, half), after)| (before + 4.0 * half + after) / 6.0)
            .collect()
    };
    let of_changes = before.iter().zip(half).zip(after);
    of_changes.map(of_offsets).collect()
}

fn gradient_of(loaded: &LoadedCase, known: &[&Contacts]) -> Result<LossGradient, Error> {
    refuse(loaded).map_err(Box::new)?;
    let exact = loaded.overridden(|over| over.exact_contacts = true)?;
    let used = Provenance::new();
    let (sampled, contacts) = used.collect(|| sampled(&exact, known))?;
    let warm = warmed(&sampled, &contacts, false)?;
    let stages = Stages::new(&warm, &contacts, &|_, _| {}, used)?;
    let positions = stages.lubricated()?;
    let lubrication = stages.lubrication();
    let of_position = |at| {
        let row = stages.contacts.at(at)?;
        if row.iter().any(|contact| contact.window.is_some()) {
            lubrication.gradient(at, row).map(Some)
        } else {
            Ok(None)
        }
    };
    let found = numbered(par_map(&stages.mesh.positions, of_position))?;
    let unresolved = stages.mesh.positions.iter().zip(&positions).zip(&found);
    let unresolved_w = unresolved
        .filter(|(_, gradient)| gradient.is_none())
        .map(|((at, position), _)| {
            let forces = position.offsets.iter().map(|offset| offset.friction_force);
            at.weight * at.mean_sliding() * asperity_core::numerics::mean(forces)
        })
        .sum();
    let losses = stages.summed(|| stages.solved(positions)?.losses())?;
    cite!("Loss-gradient");
    let heat_balance = heat_balance(&warm, &contacts, &losses)?;
    let positions: Vec<_> = found.into_iter().flatten().collect();
    let spectra = warm.surfaces.whole_spectra().map_err(Box::new)?;
    let of_position = |at: &PositionGradient| {
        let windows = at.windows.iter().flatten();
        at.unflattening.gradient(spectra, windows)
    };
    let of_positions = par_map(&positions, of_position);
    let mut by_height = spectra.each_ref().map(|trace| vec![0.0; trace.points()]);
    let mut kinks = Kinks::default();
    let offsets = warm.case.model.offsets as f64;
    for (at, of_position) in positions.iter().zip(&of_positions) {
        kinks += at.kinks;
        for (sums, of_body) in by_height.iter_mut().zip(of_position) {
            add_times(sums, heat_balance / offsets, of_body);
        }
    }
    drop(stages);
    drop(warm);
    let contacts = contacts.into_owned();
    let offsets = contacts.offsets();
    let case = sampled.overridden(|over| over.offsets = Some(offsets))?;
    Ok(LossGradient {
        by_height,
        losses,
        heat_balance,
        unresolved_w,
        kinks,
        case,
        contacts,
        positions,
    })
}

/// 1/(1 − n (∂P/∂T) (T_b − T_oil)/P) of a case at its bulk temperature; 1 where that is stated.
fn heat_balance(warm: &OperatingCase, contacts: &Contacts, losses: &Losses) -> Result<f64, Error> {
    let (Some(found), Some(law)) = (warm.bulk_report(), warm.bulk) else {
        return Ok(1.0);
    };
    let loss = |step: f64| {
        let bulk = Temperature::from_si(warm.temperature().si() + step);
        let losses = losses_at(contacts, &warm.loaded().at(bulk)?)?;
        Ok::<f64, Error>(losses.summary.loss_w)
    };
    let slope = (loss(TEMPERATURE_STEP)? - loss(-TEMPERATURE_STEP)?) / (2.0 * TEMPERATURE_STEP);
    let rise = rise_exponent(law) * (found.bulk_c - found.oil_c);
    Ok(1.0 / (1.0 - slope * rise / losses.summary.loss_w))
}

/// Refuses a loss that is not from the solved load share with the friction of its film.
///
/// # Errors
/// When [`gradient`] refuses the case.
pub fn refuse(loaded: &LoadedCase) -> Result<(), PositionError> {
    let (case, surfaces) = (&loaded.case, &loaded.surfaces);
    surfaces.check_one_pair()?;
    if surfaces.is_surrogate() {
        return Err(PositionError::no_profile());
    }
    surfaces.traces()?;
    let model = &case.model;
    check_heights(loaded)?;
    let differs = if case.laws.is_any() {
        "a user-defined law"
    } else if !matches!(case.share_law(), ShareLaw::Solved(_)) {
        "model.load_share"
    } else if model.film_friction.shear_law().is_none() {
        "model.film_friction"
    } else {
        return Ok(());
    };
    Err(PositionError::no_gradient(differs))
}

/// Refuses patches, and a case whose friction follows from pressures in the windows: it can have no sliding loss, whatever the heights
/// are.
///
/// # Errors
/// With the formulation of such a case, or with the contact of patches.
pub fn check_heights(loaded: &LoadedCase) -> Result<(), PositionError> {
    if loaded.surfaces.sheets().is_some() {
        return Err(PositionError::of_patches());
    }
    let formulation = loaded.case.formulation;
    match formulation.pressures() {
        None => Ok(()),
        Some(_) => {
            let differs = format!("formulation = \"{}\"", formulation.name());
            Err(PositionError::no_gradient(&differs))
        }
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::Code;
    use asperity_core::Profile;
    use asperity_core::profile::mirrored_indices;
    use asperity_core::provenance::Provenance;
    use asperity_mixed_film::TABLE_SHARES;

    use super::super::stages::{Stages, sampled};
    use super::gradient;
    use crate::pipeline::losses;
    use asperity_case::case::{CaseInput, LoadedCase, Source, load_holding, load_with};
    use asperity_roughness::composite::resampled;

    /// Steps of the difference quotients, in the order in which neighbours are compared \[m\].
    const STEPS: [f64; 6] = [3e-11, 1e-11, 3e-12, 1e-10, 3e-10, 1e-9];
    /// Height of the bumps \[m\].
    const BUMP: f64 = 1e-9;
    /// Narrowest and widest bump, in points.
    const BUMP_POINTS: [f64; 2] = [4.0, 400.0];

    /// Heights in contact that are compared, as many others, and a fifth of both as bumps. With `ASPERITY_HEIGHTS=50` one height of
    /// 300 was off by more than 1e-4 in three cases (23 November 2026): a cell enters the contact within 0.01 nm.
    fn heights_each() -> usize {
        const FEW: usize = 4;
        let wanted = std::env::var("ASPERITY_HEIGHTS").ok();
        wanted.and_then(|text| text.parse().ok()).unwrap_or(FEW)
    }

    fn e_drive(settings: &[(&str, &str)]) -> LoadedCase {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let few = [("model.positions", "4"), ("model.offsets", "2")];
        let set = |input: &mut asperity_case::case::CaseInput| {
            for (key, value) in few.iter().chain(settings) {
                input.set(key, value).unwrap();
            }
        };
        load_with(file, &set).unwrap()
    }

    fn heights(case: &LoadedCase) -> [Vec<f64>; 2] {
        let traces = case.surfaces.traces().unwrap();
        traces.map(|trace| trace.heights().to_vec())
    }

    /// The case with other heights.
    fn with_heights(case: &LoadedCase, heights: [Vec<f64>; 2]) -> LoadedCase {
        let spacing = case.surfaces.traces().unwrap()[0].spacing();
        let traces = heights.map(|z| Profile::new(spacing, z).unwrap());
        case.with_surfaces(case.surfaces.with_traces(traces))
    }

    /// The case with a trace moved by `step` times `shape`.
    fn moved(case: &LoadedCase, body: usize, shape: &[(usize, f64)], step: f64) -> LoadedCase {
        let mut heights = heights(case);
        for (i, one) in shape {
            heights[body][*i] += step * one;
        }
        with_heights(case, heights)
    }

    /// Central difference of the loss along `shape` of a trace.
    fn quotient(case: &LoadedCase, body: usize, shape: &[(usize, f64)], step: f64) -> f64 {
        let at = |step: f64| {
            losses(&moved(case, body, shape, step))
                .unwrap()
                .summary
                .loss_w
        };
        (at(step) - at(-step)) / (2.0 * step)
    }

    /// Central difference of the loss along `shape` of a trace with its step: the first that agrees with the step before to 1e-4,
    /// else the one that agrees best.
    fn settled_quotient(case: &LoadedCase, body: usize, shape: &[(usize, f64)]) -> (f64, f64) {
        let mut before = f64::INFINITY;
        let (mut best, mut least) = ((f64::NAN, f64::NAN), f64::INFINITY);
        for step in STEPS {
            let now = quotient(case, body, shape, step);
            let change = (now / before - 1.0).abs();
            if change < least {
                (best, least) = ((now, step), change);
            }
            if least < 1e-4 {
                break;
            }
            before = now;
        }
        best
    }

    /// The contact of one window at one row of its table.
    struct RowContact {
        name: String,
        /// Place of each cell on both traces.
        places: [Vec<usize>; 2],
        pressure: Vec<f64>,
        /// Whether the share of the window is next to this row.
        is_next: bool,
    }

    /// The contacts of all windows that touch.
    fn row_contacts(case: &LoadedCase) -> Vec<RowContact> {
        let (sampled, contacts) = sampled(case, &[]).unwrap();
        let stated = sampled.at_stated().unwrap();
        let stages = Stages::new(&stated, &contacts, &|_, _| {}, Provenance::new()).unwrap();
        let points = case.surfaces.traces().unwrap().map(Profile::len);
        let mut found = Vec::new();
        for (number, position) in stages.lubricated().unwrap().iter().enumerate() {
            let windows = contacts.at(&position.at).unwrap();
            for (k, contact) in windows.iter().enumerate() {
                let phi = position.offsets[k].solved.unwrap().asperity_share;
                let Some(window) = contact.window.filter(|_| phi > 0.0) else {
                    continue;
                };
                let mut rough = contact.rough().unwrap();
                let above = TABLE_SHARES.partition_point(|share| *share <= phi);
                for (row, share) in TABLE_SHARES.iter().enumerate().rev() {
                    found.push(RowContact {
                        name: format!("position {number}, offset {k}, share {share}"),
                        places: [0, 1].map(|body: usize| {
                            let start = window.starts[body];
                            mirrored_indices(points[body], start, window.points).collect()
                        }),
                        pressure: rough.at(*share).unwrap().solution.pressure,
                        is_next: row == above || row + 1 == above,
                    });
                }
            }
        }
        found
    }

    /// Points of both traces that are in a cell under pressure, in one window at least, at a row of the table next to its share:
    /// one is enough for the height to act through the touching cells of a contact.
    fn in_contact(case: &LoadedCase) -> [Vec<bool>; 2] {
        let mut found = heights(case).map(|z| vec![false; z.len()]);
        for contact in row_contacts(case).iter().filter(|row| row.is_next) {
            for (found, places) in found.iter_mut().zip(&contact.places) {
                for (i, pressure) in places.iter().zip(&contact.pressure) {
                    found[*i] |= *pressure > 0.0;
                }
            }
        }
        found
    }

    /// Cells that enter or leave a contact as a trace moves by `step` along `shape` to both sides.
    fn changed_cells(
        case: &LoadedCase,
        body: usize,
        shape: &[(usize, f64)],
        step: f64,
    ) -> Vec<String> {
        let sides = [-step, step].map(|step| row_contacts(&moved(case, body, shape, step)));
        let mut changed = Vec::new();
        for (below, above) in sides[0].iter().zip(&sides[1]) {
            let both = below.pressure.iter().zip(&above.pressure);
            for (cell, (a, b)) in both.enumerate() {
                if (*a > 0.0) != (*b > 0.0) {
                    changed.push(format!("{}, cell {cell}", below.name));
                }
            }
        }
        changed
    }

    /// Points `k` of `count` of those that `is_drawn`, evenly over both traces.
    fn drawn(
        gradient: &[Vec<f64>; 2],
        count: usize,
        is_drawn: impl Fn(usize, usize) -> bool,
    ) -> Vec<(usize, usize)> {
        let points = |body: usize| (0..gradient[body].len()).map(move |i| (body, i));
        let all: Vec<_> = points(0)
            .chain(points(1))
            .filter(|(body, i)| is_drawn(*body, *i))
            .collect();
        (0..count.min(all.len()))
            .map(|k| all[k * all.len() / count.min(all.len())])
            .collect()
    }

    #[test]
    fn the_gradient_of_the_loss_is_its_central_difference() {
        let found = gradient(&e_drive(&[])).unwrap();
        assert_eq!((found.heat_balance, found.unresolved_w), (1.0, 0.0));
        let (case, gradient, count) = (&found.case, &found.by_height, heights_each());
        let all = gradient.iter().flatten();
        let largest = all.fold(0.0, |m: f64, g| m.max(g.abs()));
        let in_contact = in_contact(case);
        let mut errors = Vec::new();
        let mut changed = 0;
        for touching in [true, false] {
            let points = drawn(gradient, count, |body, i| {
                in_contact[body][i] == touching && gradient[body][i].abs() > 0.01 * largest
            });
            assert_eq!(points.len(), count);
            for (body, i) in points {
                let shape = [(i, 1.0)];
                let (quotient, step) = settled_quotient(case, body, &shape);
                let error = (gradient[body][i] / quotient - 1.0).abs();
                if error > 1e-3 {
                    let cells = changed_cells(case, body, &shape, step);
                    println!("trace {body}, point {i}: {error:.1e}, {cells:?}");
                    assert!(!cells.is_empty());
                    changed += 1;
                }
                errors.push(error);
            }
        }
        errors.sort_by(f64::total_cmp);
        let [median, largest] = [count, 2 * count - 1].map(|k: usize| errors[k]);
        println!("median {median:.1e}, largest {largest:.1e}");
        // Where a cell enters or leaves within the step, the quotient is no slope.
        assert!(median < 1e-6 && changed <= 1 + count / 10, "{errors:?}");
        let bumps = (2 * count).div_ceil(5);
        for k in 0..bumps {
            let body = k % 2;
            let part = (k as f64 + 0.5) / bumps as f64;
            let width = (BUMP_POINTS[0] * (BUMP_POINTS[1] / BUMP_POINTS[0]).powf(part)) as usize;
            let begin = (k * 104_729 + 900) % (gradient[body].len() - width);
            let cosine = |j: usize| (std::f64::consts::TAU * j as f64 / width as f64).cos();
            let shape: Vec<(usize, f64)> = (0..=width)
                .map(|j| (begin + j, 0.5 * (1.0 - cosine(j))))
                .collect();
            let expected: f64 = shape.iter().map(|(i, s)| gradient[body][*i] * s).sum();
            let (settled, _) = settled_quotient(case, body, &shape);
            let error = (expected / settled - 1.0).abs();
            assert!(error < 0.03, "{width} points from {begin}: {error}");
            // Cells that enter or leave within the height of the bump bend the loss.
            let off = (expected / quotient(case, body, &shape, BUMP) - 1.0).abs();
            if off > 0.01 {
                let cells = changed_cells(case, body, &shape, BUMP);
                println!("{width} points from {begin}: {off:.1e} within 1 nm, {cells:?}");
                assert!(!cells.is_empty());
            }
        }
    }

    /// The e-drive case with these traces instead of its files.
    fn with_files(traces: &[Profile; 2]) -> LoadedCase {
        let folder = std::path::Path::new("../../fixtures/cases");
        let text = asperity_storage::whole_file(&folder.join("e-drive.toml"), 1 << 16).unwrap();
        let source = Source::from_bytes("e-drive.toml", &text).unwrap();
        let names = ["pinion", "wheel"].map(|of| format!("../profiles/ground_{of}.csv"));
        let held = [0, 1].map(|body: usize| (names[body].clone().into(), traces[body].clone()));
        let few = |input: &mut CaseInput| {
            (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        };
        let loaded = load_holding(source, folder, &held, &[], &few).unwrap();
        loaded
            .overridden(|over| over.exact_contacts = true)
            .unwrap()
    }

    #[test]
    fn the_gradient_over_measured_heights_is_the_central_difference_of_runs_with_other_files() {
        /// Height of the bumps: cells that enter a contact within 1 nm would count.
        const STEP: f64 = 1e-10;
        let spacing = asperity_core::quantity::Length::from_si;
        let files = e_drive(&[]).flanks.clone();
        // The wheel is mirrored, and resampled after its preparation.
        let traces = [(0, 0.5e-6), (1, 0.7e-6)].map(|(body, dx): (usize, f64)| {
            resampled(files[body].trace.as_ref().unwrap(), spacing(dx)).unwrap()
        });
        let found = gradient(&with_files(&traces)).unwrap();
        let measured = found.by_measured_height().unwrap().map(Option::unwrap);
        let mut worst_of_prepared = 0.0_f64;
        for (body, trace) in traces.iter().enumerate() {
            let (dx, n) = (trace.spacing().si(), trace.len());
            assert_eq!(measured[body].len(), n);
            for width in [30e-6, 120e-6] {
                let bump = |middle: usize| -> Vec<f64> {
                    let value = |i: usize| {
                        let off = 2.0 * dx * (i as f64 - middle as f64) / width;
                        if off.abs() < 1.0 {
                            0.5 * (1.0 + (std::f64::consts::PI * off).cos())
                        } else {
                            0.0
                        }
                    };
                    (0..n).map(value).collect()
                };
                let of = |shape: &[f64]| -> f64 {
                    shape.iter().zip(&measured[body]).map(|(s, g)| s * g).sum()
                };
                // Where a bump of this width costs most.
                let middles = (n / 10..n - n / 10).step_by(10);
                let shape = middles
                    .map(bump)
                    .max_by(|a, b| of(a).total_cmp(&of(b)))
                    .unwrap();
                let at = |step: f64| {
                    let heights = trace.heights().iter().zip(&shape);
                    let heights = heights.map(|(z, s)| z + step * s).collect();
                    let mut files = traces.clone();
                    files[body] = Profile::new(trace.spacing(), heights).unwrap();
                    losses(&with_files(&files)).unwrap().summary.loss_w
                };
                let quotient = (at(STEP) - at(-STEP)) / (2.0 * STEP);
                let error = of(&shape) / quotient - 1.0;
                println!("trace {body}, {width} m: {error:.1e}");
                assert!(error.abs() < 0.03, "trace {body}, {width} m: {error}");
                if body == 0 {
                    let record = found.case.flanks[0].preparation.as_ref().unwrap();
                    let kept = &shape[record.dropped_each_end..];
                    let pairs = kept.iter().zip(&found.by_height[0]);
                    let prepared: f64 = pairs.map(|(s, g)| s * g).sum();
                    worst_of_prepared = worst_of_prepared.max((prepared / quotient - 1.0).abs());
                }
            }
        }
        assert!(worst_of_prepared > 0.05, "{worst_of_prepared}");
    }

    #[test]
    fn a_flank_without_a_measured_trace_has_no_gradient() {
        let error = gradient(&e_drive(&[("surface.wheel", r#"{ rq = "0.3 um" }"#)])).unwrap_err();
        assert_eq!(error.code(), Code::E303, "{error}");
    }

    #[test]
    fn a_fitted_circle_has_no_gradient_over_measured_heights() {
        let found = gradient(&e_drive(&[("surface.form", "circle")])).unwrap();
        assert_eq!(found.by_measured_height().unwrap(), [None, None]);
    }

    #[test]
    fn the_gradient_includes_the_heat_balance_of_the_flanks() {
        let network = r#"{ law = "network", pinion_to_oil = "12 W/K", wheel_to_oil = "20 W/K" }"#;
        for law in [r#"{ law = "iso", lubrication = "jet" }"#, network] {
            let oil = [
                ("operation.oil_temperature", "70 °C"),
                ("operation.bulk", law),
            ];
            let found = gradient(&e_drive(&oil)).unwrap();
            assert!(
                (found.heat_balance - 1.0).abs() > 0.02,
                "{law}: {}",
                found.heat_balance
            );
            let z = heights(&found.case);
            let expected: f64 = (z.iter().flatten().zip(found.by_height.iter().flatten()))
                .map(|(z, by_height)| z * by_height)
                .sum();
            let at = |part: f64| {
                let scaled = z.clone().map(|z| z.iter().map(|z| part * z).collect());
                losses(&with_heights(&found.case, scaled))
                    .unwrap()
                    .summary
                    .loss_w
            };
            let step = 2e-3;
            let quotient = (at(1.0 + step) - at(1.0 - step)) / (2.0 * step);
            // The equilibrium is iterated to 0.01 K: half of the last change of the temperature is missing.
            let error = quotient / expected - 1.0;
            assert!(error.abs() < 0.01, "{law}: {expected} W, {quotient} W");
        }
    }

    #[test]
    fn a_loss_that_is_not_of_the_default_model_has_no_gradient() {
        for (key, value) in [
            ("model.load_share", "lambda-star"),
            ("model.film_friction", "xu"),
        ] {
            let error = gradient(&e_drive(&[(key, value)])).unwrap_err();
            assert_eq!(error.code(), Code::E205, "{key}: {error}");
            assert!(error.to_string().contains(key), "{error}");
        }
    }
}
