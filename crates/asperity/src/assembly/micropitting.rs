//! The film of the micropitting rating along the path of contact, and the measured flanks at the same places.
//!
//! Pressure, speeds and friction come from the run, the film and its temperature from ISO/TS 6336-22
//! ([`asperity_ehl_regime::micropitting`]). No permissible value is known here: without a stated one there is no
//! safety factor, and in no case a verdict.

use asperity_contact::plasticity::softer_flow_pressure;
use asperity_core::numerics::mean;
use asperity_core::quantity::{Length, Pressure, Temperature};
use asperity_core::{FittedRange, Profile};
use asperity_ehl_regime::micropitting::{OilAt, RatedContact, specific_film};
use asperity_roughness::gaussian_filter::{Ends, mean_line};

use crate::lubrication::LubricatedPosition;
use crate::mesh::MeshPosition;
use crate::result::ContactView;
use crate::result::{MicropittingCell, MicropittingReport};
use asperity_case::case::{Case, MicropittingInput, OperatingCase};
use asperity_case::error::PositionError;
use asperity_case::flanks::{OffsetIndex, Surfaces};

/// Cut-off of the roughness that is shorter than most contacts.
const SHORT: Length = Length::from_si(80e-6);
/// Share of the loaded points whose pressure stays below the one given.
const MOST: f64 = 0.99;
/// Part of the flow pressure from which a point counts as flowing.
const FLOWING: f64 = 0.999;

/// Range of the data behind the specification (ISO/TS 6336-22:2018, abstract).
const SCOPE: [FittedRange; 5] = [
    range("module", 3.0, 11.0, "mm"),
    range("pitch line velocity", 8.0, 60.0, "m/s"),
    range("virtual contact ratio", 0.0, 2.5, "-"),
    range("normal pressure angle", 0.0, 25.0, "deg"),
    range("helix angle", 0.0, 25.0, "deg"),
];

const fn range(name: &'static str, low: f64, high: f64, unit: &'static str) -> FittedRange {
    FittedRange::new(name, low, high, unit, "ISO/TS 6336-22")
}

/// Rating of a solved path, `None` unless the case requests it; `ends` are the points A and E, if they were solved.
pub(crate) fn report(
    loaded: &OperatingCase,
    positions: &[LubricatedPosition],
    views: &[Option<&ContactView>],
    ends: &[&LubricatedPosition],
) -> Result<Option<MicropittingReport>, PositionError> {
    let Some(given) = &loaded.case.input.micropitting else {
        return Ok(None);
    };
    let rating = Rating::new(loaded, given)?;
    let mut cells = Vec::with_capacity(positions.len() + ends.len());
    for (k, position) in positions.iter().enumerate() {
        cells.push(rating.cell(position, views.get(k).copied().flatten())?);
    }
    for end in ends {
        cells.push(rating.cell(end, None)?);
    }
    cells.sort_by(|a, b| a.path_fraction.total_cmp(&b.path_fraction));
    let least = cells.iter().min_by(|a, b| a.lambda.total_cmp(&b.lambda));
    let Some(least) = least.copied() else {
        return Ok(None);
    };
    let path = loaded.case.gears.path();
    let pitch = (path.c - path.a) / (path.e - path.a);
    Ok(Some(MicropittingReport {
        lambda_min: least.lambda,
        path_fraction: least.path_fraction,
        place: if least.path_fraction < pitch {
            "root of the pinion against the tip of the wheel".to_owned()
        } else {
            "tip of the pinion against the root of the wheel".to_owned()
        },
        outside: outside_of_scope(loaded),
        load_factor: rating.load_factor,
        permissible: given.permissible,
        safety: given
            .permissible
            .map(|permissible| least.lambda / permissible),
        ra_um: rating.ra.map(|ra| ra.si() * 1e6),
        cells,
    }))
}

/// Inputs outside of the scope.
pub(super) fn outside_of_scope(case: &Case) -> Vec<String> {
    let gears = &case.gears;
    let cosine = gears.base_helix.si().cos();
    let values = [
        gears.normal_module.si() * 1e3,
        case.speed.si() * gears.working_pitch_radius[0].si().abs(),
        gears.path().eps_alpha / (cosine * cosine),
        gears.normal_pressure_angle.si().to_degrees(),
        gears.helix.si().abs().to_degrees(),
    ];
    let mut notes = Vec::new();
    for (range, value) in SCOPE.iter().zip(values) {
        range.check(value, &mut notes);
    }
    let mut found: Vec<String> = notes.iter().map(ToString::to_string).collect();
    if gears.internal {
        found.push("the pair is internal, and ISO/TS 6336-22 is for external gears".to_owned());
    }
    found
}

/// Data common to all places.
struct Rating<'a> {
    loaded: &'a OperatingCase,
    load_factor: f64,
    ra: [Length; 2],
    /// Thermal contact coefficients of both gears.
    effusivity: [f64; 2],
    /// Flow pressure of the softer flank.
    flow: Pressure,
    /// The flanks without wavelengths above 0.08 mm, where both were measured.
    short: Option<Surfaces>,
}

impl<'a> Rating<'a> {
    fn new(loaded: &'a OperatingCase, given: &MicropittingInput) -> Result<Self, PositionError> {
        let case = loaded;
        let effusivity = case.materials.each_ref().map(|steel| {
            let product = steel.conductivity.si() * steel.density.si() * steel.heat_capacity.si();
            product.sqrt()
        });
        let [pinion, wheel] = case.flow_pressure;
        Ok(Self {
            loaded,
            load_factor: given.load_factor.unwrap_or(1.0),
            ra: match given.ra {
                Some(ra) => ra,
                None => roughness(&loaded.surfaces)?,
            },
            effusivity,
            flow: softer_flow_pressure(pinion, wheel)?,
            short: short(&loaded.surfaces)?,
        })
    }

    /// Film and temperature by the specification, with the share and the pressures of the rough contact.
    fn cell(
        &self,
        position: &LubricatedPosition,
        view: Option<&ContactView>,
    ) -> Result<MicropittingCell, PositionError> {
        let at = &position.at;
        let seen = view.map(|view| self.seen(view, at));
        let offsets = position.offsets.iter();
        let case = self.loaded;
        let path = case.gears.path();
        let pressure = at.hertz.max_pressure * self.load_factor.sqrt();
        let contact = RatedContact {
            radius: at.motion.radius,
            pressure,
            speeds: [at.motion.u1, at.motion.u2],
            modulus: case.modulus * 2.0,
        };
        let flash = contact.flash(friction(position), self.effusivity)?;
        let hot = Temperature::from_si(case.temperature().si() + flash);
        let film = contact.film(self.oil(case.temperature())?, self.oil(hot)?)?;
        Ok(MicropittingCell {
            path_fraction: (at.s - path.a) / (path.e - path.a),
            pressure_mpa: pressure.si() * 1e-6,
            flash_k: flash,
            film_um: film.si() * 1e6,
            lambda: specific_film(film, self.ra)?,
            lambda_short: self.short_rq(at)?.map(|rq| film.si() / rq),
            solid_share: mean(offsets.map(|offset| 1.0 - offset.film_share)),
            solid_pressure_99_mpa: seen.and_then(|(pressure, _)| pressure),
            flowing_area: seen.map(|(_, area)| area),
        })
    }

    /// State of the oil at a temperature, by the laws of the run.
    fn oil(&self, temperature: Temperature) -> Result<OilAt, PositionError> {
        let state = self.loaded.case.lubricant.at(temperature)?.value;
        Ok(OilAt {
            viscosity: state.dynamic_viscosity,
            pressure_viscosity: state.pressure_viscosity,
        })
    }

    /// Composite Rq \[m\] of the short wavelengths under the contact, mean over the offsets.
    fn short_rq(&self, at: &MeshPosition) -> Result<Option<f64>, PositionError> {
        let Some(surfaces) = &self.short else {
            return Ok(None);
        };
        let model = &self.loaded.case.model;
        let count = surfaces.offsets(model.offsets);
        let mut sum = 0.0;
        for k in 0..count {
            let roughness = surfaces.roughness_at(at, model.window, OffsetIndex { k, count })?;
            sum += roughness.combined_rq()?.si();
        }
        Ok(Some(sum / count as f64).filter(|rq| *rq > 0.0))
    }

    /// Pressure that 99 % of the touching points stay below \[MPa\], and the share of the nominal contact at the flow
    /// pressure.
    fn seen(&self, view: &ContactView, at: &MeshPosition) -> (Option<f64>, f64) {
        let half_width = at.hertz.half_width.si() * 1e6;
        let points = view.x_um.iter().zip(&view.pressure_solid_mpa);
        let within: Vec<f64> = points
            .filter(|(x, _)| x.abs() <= half_width)
            .map(|(_, pressure)| *pressure)
            .collect();
        let mut touching: Vec<f64> = within.iter().copied().filter(|p| *p > 0.0).collect();
        touching.sort_by(f64::total_cmp);
        let last = touching.len().saturating_sub(1) as f64;
        let most = touching.get((MOST * last).round() as usize).copied();
        let flow = FLOWING * self.flow.si() * 1e-6;
        let flowing = within.iter().filter(|pressure| **pressure >= flow).count();
        (most, flowing as f64 / within.len().max(1) as f64)
    }
}

/// Friction coefficient of a position, mean over the offsets.
fn friction(position: &LubricatedPosition) -> f64 {
    let forces = position.offsets.iter().map(|offset| offset.friction_force);
    mean(forces) / position.at.load.si()
}

/// All traces without wavelengths above 0.08 mm; none where a flank was not measured.
fn short(surfaces: &Surfaces) -> Result<Option<Surfaces>, PositionError> {
    let filtered = |trace: &Profile| -> Result<Profile, PositionError> {
        let line = mean_line(trace, SHORT, Ends::Reg0)?;
        let heights = trace.heights().iter().zip(&line).map(|(z, w)| z - w);
        Ok(Profile::new(trace.spacing(), heights.collect())?)
    };
    let is_measured = surfaces.are_measured();
    is_measured
        .then(|| surfaces.with_changed_traces(filtered))
        .transpose()
}

/// Ra of both flanks, mean over their traces.
fn roughness(surfaces: &Surfaces) -> Result<[Length; 2], PositionError> {
    let each = surfaces.each().map(Surfaces::roughness_of_values);
    let each = each.collect::<Result<Vec<_>, _>>()?;
    Ok([0, 1].map(|body: usize| Length::from_si(mean(each.iter().map(|found| found.ra[body])))))
}
