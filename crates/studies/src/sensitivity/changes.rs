//! The changes of a case in a sensitivity study, one at a time.

use asperity::case::{GearFlankInput, LoadedCase, ReliefInput, TipRelief};
use asperity::flanks::{Surfaces, Texture};
use asperity::gear::{ReliefExtent, ReliefShape};
use asperity::oil::{BaseOil, ViscosityLaw};
use asperity::pipeline::less_of_scans;
use asperity::{Error, PositionError};
use asperity_core::Profile;
use asperity_core::quantity::{KinematicViscosity, Length, Temperature};
use asperity_roughness::RoughnessError;

use super::bands::{edges, wavelength_bands};

/// Factors on the heights, reciprocal to each other.
pub(super) const HEIGHTS: [f64; 2] = [0.8, 1.25];
/// Factor on one wavelength band.
const BAND: f64 = 0.5;
/// Step of the coefficient of boundary friction.
const FRICTION: f64 = 0.01;
/// Factors on the height of the boundary layer.
const LAYER: [f64; 2] = [0.5, 2.0];
/// Factors on the viscosity.
const VISCOSITY: [f64; 2] = [0.8, 1.25];
/// Step of the temperature \[K\].
const TEMPERATURE: f64 = 10.0;
/// Step of the tip relief.
const RELIEF: Length = Length::from_si(5e-6);
const BASE_OILS: [BaseOil; 4] = [
    BaseOil::Mineral,
    BaseOil::Pao,
    BaseOil::Ester,
    BaseOil::Polyglycol,
];

/// Group of the use of scans, whose change has other windows.
pub(super) const SCANS: &str = "scans";

/// Group of the filters, which change how the loss depends on the constants.
pub(super) const FILTERS: &str = "filters";

/// Approximate number of changes of a case.
pub(super) const CHANGES: usize = 24;

/// Change of a case.
pub(super) struct Change {
    /// Group of the change.
    pub(super) group: &'static str,
    /// Changed quantity.
    pub(super) what: String,
    /// New value.
    pub(super) to: String,
    /// Changed case.
    pub(super) case: Result<LoadedCase, Error>,
}

impl Change {
    /// Makes the changes of a group from what is changed, to what, and the changed case.
    fn in_group(group: &'static str) -> impl Fn(String, String, Result<LoadedCase, Error>) -> Self {
        move |what, to, case| Self {
            group,
            what,
            to,
            case,
        }
    }
}

/// All changes that apply to `case`.
pub(super) fn changes(case: &LoadedCase) -> Vec<Change> {
    let mut changes = flanks(case);
    changes.extend(cutoffs(case));
    changes.extend(scans(case));
    changes.extend(boundary(case));
    changes.extend(oil(case));
    changes.extend(relief(case));
    changes
}

fn flanks(loaded: &LoadedCase) -> Vec<Change> {
    let change = Change::in_group("flanks");
    let mut changes: Vec<Change> = HEIGHTS
        .into_iter()
        .map(|factor| {
            let surfaces = loaded.surfaces.with_heights_times(factor);
            let what = "heights of both flanks".to_owned();
            change(what, format!("× {factor}"), on(loaded, surfaces))
        })
        .collect();
    let Some(edges) = range(loaded).map(edges) else {
        return changes;
    };
    for band in 0..edges.len() - 1 {
        let less = |trace: &Profile| -> Result<Profile, RoughnessError> {
            let part = &wavelength_bands(trace, &edges)?[band];
            let heights = trace.heights().iter().zip(part);
            let heights = heights.map(|(z, part)| z - (1.0 - BAND) * part).collect();
            Ok(Profile::new(trace.spacing(), heights)?)
        };
        let case = on(loaded, loaded.surfaces.with_changed_traces(less));
        let [from, to] = [edges[band], edges[band + 1]].map(|edge| digits(1e6 * edge.si(), 2));
        let what = format!("wavelengths {from} to {to} um");
        changes.push(change(what, format!("× {BAND}"), case));
    }
    changes
}

/// The neighbouring cut-offs λc and λs of the standard series; none of a flank without a trace.
fn cutoffs(loaded: &LoadedCase) -> Vec<Change> {
    if range(loaded).is_none() {
        return Vec::new();
    }
    let change = Change::in_group(FILTERS);
    let recipe = &loaded.case.preparation;
    let mut changes = Vec::new();
    if let Some(present) = recipe.lambda_c {
        let mm = |length: Length| format!("{} mm", digits(1e3 * length.si(), 2));
        changes.extend(neighbours(present).map(|to| {
            let case = loaded.with(|input| input.surface.cutoff = Some(to));
            change(format!("cut-off λc {}", mm(present)), mm(to), case)
        }));
    }
    if let Some(present) = recipe.lambda_s {
        let um = |length: Length| format!("{} um", digits(1e6 * length.si(), 2));
        changes.extend(neighbours(present).map(|to| {
            let case = loaded.with(|input| input.surface.noise_cutoff = Some(to));
            change(format!("cut-off λs {}", um(present)), um(to), case)
        }));
    }
    changes
}

/// Less of the scans: rows instead of patches, or single rows instead of several.
fn scans(loaded: &LoadedCase) -> Option<Change> {
    let scans = less_of_scans(loaded)?;
    let change = Change::in_group(SCANS);
    Some(change(scans.taken, scans.other.to_owned(), scans.case))
}

/// The next smaller and the next larger cut-off of the series 0.08, 0.25, 0.8, 2.5 of ISO 21920-3.
fn neighbours(cutoff: Length) -> [Length; 2] {
    /// Cut-offs closer than this are the same.
    const SAME: f64 = 1e-3;
    let exponent = cutoff.si().log10().floor() as i32;
    let series = (exponent - 1..=exponent + 1)
        .flat_map(|exponent| [2.5, 8.0].map(|step| step * 10_f64.powi(exponent)));
    let (mut smaller, mut larger) = (0.0_f64, f64::INFINITY);
    for step in series {
        if step < cutoff.si() * (1.0 - SAME) {
            smaller = smaller.max(step);
        } else if step > cutoff.si() * (1.0 + SAME) {
            larger = larger.min(step);
        }
    }
    [smaller, larger].map(Length::from_si)
}

/// The case with other surfaces.
fn on<E: Into<PositionError>>(
    loaded: &LoadedCase,
    surfaces: Result<Surfaces, E>,
) -> Result<LoadedCase, Error> {
    let surfaces = surfaces.map_err(|error| Error::Whole(Box::new(error.into())))?;
    Ok(loaded.with_surfaces(surfaces))
}

/// Shortest and longest wavelength of the prepared traces; `None` if a flank was not measured.
fn range(loaded: &LoadedCase) -> Option<[Length; 2]> {
    let traces = loaded
        .surfaces
        .textures()
        .iter()
        .map(|texture| match texture {
            Texture::Trace(trace) => Some(trace),
            _ => None,
        });
    let traces = traces.collect::<Option<Vec<_>>>()?;
    let recipe = &loaded.case.preparation;
    let shortest = recipe.lambda_s.unwrap_or(traces[0].spacing() * 2.0);
    let whole = traces.iter().map(|trace| trace.length().si());
    let whole = Length::from_si(whole.fold(f64::INFINITY, f64::min));
    let longest = recipe.lambda_c.unwrap_or(whole);
    (shortest.si() < longest.si()).then_some([shortest, longest])
}

fn boundary(loaded: &LoadedCase) -> Vec<Change> {
    let model = &loaded.case.model;
    let change = Change::in_group("boundary layer");
    let friction = [-FRICTION, FRICTION].map(|step| {
        let to = model.boundary_friction + step;
        let case = loaded.with(|input| {
            let fitted = input.calibration.as_mut();
            match fitted.and_then(|fitted| fitted.boundary_friction.as_mut()) {
                Some(fitted) => *fitted = fitted.map(|mu| mu * (to / model.boundary_friction)),
                None => input.model.boundary_friction = Some(to),
            }
        });
        let what = format!("boundary friction {}", model.boundary_friction);
        change(what, digits(to, 4), case)
    });
    let nm = |length: Length| format!("{} nm", digits(1e9 * length.si(), 3));
    let layer = LAYER.map(|factor| {
        let to = model.boundary_layer * factor;
        let case = loaded.with(|input| {
            let fitted = input.calibration.as_mut();
            match fitted.and_then(|fitted| fitted.boundary_layer.as_mut()) {
                Some(fitted) => *fitted = fitted.map(|layer| layer * factor),
                None => input.model.boundary_layer = Some(to),
            }
        });
        let what = format!("boundary layer {}", nm(model.boundary_layer));
        change(what, nm(to), case)
    });
    friction.into_iter().chain(layer).collect()
}

fn oil(loaded: &LoadedCase) -> Vec<Change> {
    let change = Change::in_group("oil");
    let viscosity = VISCOSITY.map(|factor| {
        let case = viscosity(loaded, factor)
            .and_then(|law| loaded.with(|input| input.lubricant.viscosity = Some(law)));
        change("viscosity".to_owned(), format!("× {factor}"), case)
    });
    let temperature = loaded.case.stated_temperature.celsius();
    let celsius = |temperature: f64| format!("{} °C", digits(temperature, 5));
    // A viscosity without temperature applies at any temperature of the case.
    let knows_temperature = !matches!(
        loaded.case.input.lubricant.viscosity,
        Some(ViscosityLaw::Given {
            temperature: None,
            ..
        })
    );
    let steps = [-TEMPERATURE, TEMPERATURE].into_iter();
    let temperature = steps.filter(|_| knows_temperature).map(|step| {
        let (from, temperature) = (celsius(temperature), temperature + step);
        let case = loaded.with(|input| {
            (input.operation).set_temperature(Temperature::from_celsius(temperature));
        });
        let to = celsius(temperature);
        change(format!("temperature {from}"), to, case)
    });
    let present = loaded.case.lubricant.base_oil();
    // The constants of an oil file are those of its oil, whatever the family.
    let is_known = loaded.case.oil_file.is_some();
    let others = BASE_OILS
        .into_iter()
        .filter(|oil| !is_known && Some(*oil) != present);
    let base = others.map(|oil| {
        let case = loaded.with(|input| {
            input.lubricant.base_oil = Some(oil);
            input.lubricant.assume_base_oil = None;
        });
        let what = match present {
            Some(present) => format!("base oil {}", present.name()),
            None => "base oil".to_owned(),
        };
        change(what, oil.name().to_owned(), case)
    });
    viscosity
        .into_iter()
        .chain(temperature)
        .chain(base)
        .collect()
}

/// A number with `count` significant digits, without trailing zeros.
fn digits(value: f64, count: usize) -> String {
    let magnitude = if value == 0.0 {
        0
    } else {
        value.abs().log10().floor() as i32
    };
    let decimals = (count as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The viscosity law with all viscosities times `factor`.
fn viscosity(loaded: &LoadedCase, factor: f64) -> Result<ViscosityLaw, Error> {
    let times = |value: KinematicViscosity| value * factor;
    Ok(match &loaded.case.input.lubricant.viscosity {
        Some(ViscosityLaw::AstmD341 { at_40, at_100 }) => ViscosityLaw::AstmD341 {
            at_40: times(*at_40),
            at_100: times(*at_100),
        },
        Some(ViscosityLaw::Vogel {
            limit_viscosity,
            slope_kelvin,
            pole_kelvin,
        }) => ViscosityLaw::Vogel {
            limit_viscosity: *limit_viscosity * factor,
            slope_kelvin: *slope_kelvin,
            pole_kelvin: *pole_kelvin,
        },
        Some(ViscosityLaw::Given {
            dynamic_viscosity,
            temperature,
        }) => ViscosityLaw::Given {
            dynamic_viscosity: *dynamic_viscosity * factor,
            temperature: *temperature,
        },
        // An oil of the library, or a grade with its index.
        None | Some(ViscosityLaw::IsoVg { .. }) => {
            let at = |celsius: f64| {
                let state = loaded.case.lubricant.at(Temperature::from_celsius(celsius));
                state.map(|state| times(state.value.kinematic_viscosity))
            };
            let both = at(40.0).and_then(|at_40| Ok((at_40, at(100.0)?)));
            let (at_40, at_100) = both.map_err(|error| Error::Whole(Box::new(error.into())))?;
            ViscosityLaw::AstmD341 { at_40, at_100 }
        }
    })
}

/// Tip relief of both gears; for an unrelieved gear from the end of single contact.
fn relief(loaded: &LoadedCase) -> Vec<Change> {
    let path = loaded.case.gears.path();
    let double_contact = Length::from_si((path.e.si() - path.d.si()).max(0.0));
    let gears = &loaded.case.input.gears;
    let mut flanks = [&gears.pinion, &gears.wheel].into_iter().flatten();
    if flanks.any(GearFlankInput::is_from_trace) {
        // Relief from a trace has no single amount.
        return Vec::new();
    }
    // As stated, or the middle of what is assumed.
    let present = loaded.case.micro_geometry.tip_relief;
    let um = |amount: Length| digits(1e6 * amount.si(), 3);
    let amounts = present.map(|relief| relief.map_or(Length::from_si(0.0), |relief| relief.amount));
    let steps = [-RELIEF, RELIEF];
    let possible = steps.into_iter().filter(|step| {
        let least = amounts.map(|amount| amount.si() + step.si());
        least.iter().all(|amount| *amount >= 0.0)
    });
    let named = |amounts: [Length; 2]| format!("{} and {} um", um(amounts[0]), um(amounts[1]));
    possible
        .map(|step| {
            let to = amounts.map(|amount| amount + step);
            let case = loaded.with(|input| {
                let gears = [&mut input.gears.pinion, &mut input.gears.wheel];
                for ((gear, present), amount) in gears.into_iter().zip(present).zip(to) {
                    let (length, start_diameter) = match present.map(|relief| relief.extent) {
                        None => (Some(double_contact), None),
                        Some(ReliefExtent::RollLength(length)) => (Some(length), None),
                        Some(ReliefExtent::StartDiameter(diameter)) => (None, Some(diameter)),
                    };
                    let is_parabolic =
                        present.is_some_and(|relief| relief.shape == ReliefShape::Parabolic);
                    let drawn = ReliefInput {
                        amount,
                        length,
                        start_diameter,
                        power: is_parabolic.then_some(2),
                    };
                    gear.get_or_insert_default().tip_relief = Some(TipRelief::Drawn(drawn));
                }
            });
            Change::in_group("gears")(format!("tip relief {}", named(amounts)), named(to), case)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::Length;

    use super::{digits, neighbours};

    #[test]
    fn the_neighbours_of_a_cutoff_are_those_of_the_series() {
        for (cutoff, smaller, larger) in [
            (0.25e-3, 0.08e-3, 0.8e-3),
            (0.8e-3, 0.25e-3, 2.5e-3),
            (2.5e-6, 0.8e-6, 8e-6),
            (1e-3, 0.8e-3, 2.5e-3),
        ] {
            let found = neighbours(Length::from_si(cutoff)).map(Length::si);
            for (found, expected) in found.into_iter().zip([smaller, larger]) {
                assert!((found / expected - 1.0).abs() < 1e-12, "{cutoff} {found}");
            }
        }
    }

    #[test]
    fn numbers_have_the_digits_that_count() {
        assert_eq!(digits(7.905_69, 2), "7.9");
        assert_eq!(digits(79.0569, 2), "79");
        assert_eq!(digits(250.0, 2), "250");
        assert_eq!(digits(0.07 + 0.01, 4), "0.08");
        assert_eq!(digits(-40.000_000_001, 5), "-40");
        assert_eq!(digits(0.0, 3), "0");
    }
}
