//! Quantities that follow from the numbers of a case and show a wrong one: W201 and E212 as for [`ranges`].

use std::f64::consts::PI;

use asperity_core::Code;
use asperity_core::decimals;
use asperity_core::quantity::{AngularSpeed, Pressure, Torque};
use asperity_flanks::meeting::at_pitch;
use asperity_gear::GearPair;
use asperity_oil::LubricantState;

use crate::input::case_input::{CaseInput, GearsInput, OperationInput};
use crate::input::ranges::{self, UNUSUAL, digits, impossible_at, with_unit, within};
use crate::physical_limits::{HIGHEST_PRESSURE, HIGHEST_SPEED};
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;
use asperity_core::message::Warning;

/// Code of a division of the profile shifts.
const DIVIDED: Code = Code::W445;
/// Code of tips that leave little clearance.
const CLEARANCE: Code = Code::W453;
/// Code of the warning that names the keys of symbols.
pub(crate) const SYMBOLS: Code = Code::W202;

/// Viscosity of the oil at the bulk temperature \[Pa s\]: usual, and beyond which it is no oil of a gear drive.
const OIL_USUAL: [f64; 2] = [1e-3, 10.0];
const OIL_POSSIBLE: [f64; 2] = [1e-5, 100.0];

/// Refuses an oil that does not flow at the bulk temperature, or is a gas there.
pub(crate) fn refuse_stiff_oil(
    oil: &LubricantState,
    operation: &OperationInput,
    source: &Source,
) -> Result<(), CaseError> {
    let viscosity = oil.dynamic_viscosity.si();
    if within(viscosity, OIL_POSSIBLE) {
        return Ok(());
    }
    let seen = format!("an oil of {} Pa s there", digits(viscosity));
    let usual = format!("{} to {} Pa s", OIL_USUAL[0], OIL_USUAL[1]);
    let key = operation.temperature_key().into();
    Err(impossible_at(source, key, seen, usual))
}

/// A quantity at the pitch point, which shows a wrong unit of the keys that it follows from.
pub(crate) struct AtPitchPoint {
    value: f64,
    unit: &'static str,
    usual: [f64; 2],
    most: f64,
    /// The key of the operation that it is reported at.
    key: &'static str,
    name: &'static str,
}

/// Hertz pressure with the load on one pair of teeth, and pitch-line speed:
///
/// p₀ = √(w E*/(π R)) with w = |T|/(r_b1 b), R = C (T₁T₂ − C)/(T₁T₂ cos β_b); v = r_w1 ω.
pub(crate) fn at_pitch_point(
    gears: &GearPair,
    modulus: Pressure,
    torque: Torque,
    speed: AngularSpeed,
) -> [AtPitchPoint; 2] {
    [
        hertz(gears, modulus, torque),
        AtPitchPoint {
            value: gears.working_pitch_radius[0].si().abs() * speed.si(),
            unit: "m/s",
            usual: [0.05, 120.0],
            most: HIGHEST_SPEED,
            key: "speed",
            name: "pitch-line speed (by speed, teeth, module)",
        },
    ]
}

fn hertz(gears: &GearPair, modulus: Pressure, torque: Torque) -> AtPitchPoint {
    let (load, radius) = at_pitch(gears, torque);
    AtPitchPoint {
        value: 1e-9 * (load * modulus.si() / (PI * radius)).sqrt(),
        unit: "GPa",
        usual: [0.06, 3.0],
        most: 1e-9 * HIGHEST_PRESSURE.si(),
        key: "torque",
        name: "Hertz pressure at the pitch point (by torque, face width, teeth, module, Young's modulus)",
    }
}

/// Hertz pressure at which flanks run in, over the flow pressure of the softer one: they flow as a whole from 1 on, and below
/// their surface from 0.6 on.
const RUNNING_IN_USUAL: f64 = 0.5;

/// Hertz pressure of running-in at the pitch point, reported at `key`; the softer flank flows at `softer`.
pub(crate) fn at_running_in(
    gears: &GearPair,
    modulus: Pressure,
    torque: Torque,
    softer: Pressure,
    key: &'static str,
) -> AtPitchPoint {
    let load = hertz(gears, modulus, torque);
    let [least, most] = load.usual;
    let flow = 1e-9 * softer.si();
    AtPitchPoint {
        usual: [least, most.min(RUNNING_IN_USUAL * flow)],
        most: load.most.min(flow),
        key,
        ..load
    }
}

impl AtPitchPoint {
    /// Refuses a running-in in which flanks flow as a whole, with the part of the torque that does not do so.
    pub(crate) fn refuse_flow(&self, source: &Source) -> Result<(), CaseError> {
        if self.value < self.most {
            return Ok(());
        }
        let key = Section::new(source, "operation").key(self.key);
        let seen = format!(
            "a Hertz pressure of {} GPa at the pitch point, where the softer flank flows as a whole at {} GPa,",
            decimals(self.value, 1),
            digits(self.most)
        );
        // The pressure rises with the root of the torque.
        let part = (self.usual[1] / self.value).powi(2);
        let step = 10_f64.powf(part.log10().floor() - 1.0);
        let part = digits((part / step).floor() * step);
        let usual = format!("{}, up to {part} of this torque", self.usual());
        Err(impossible_at(source, key, seen, usual))
    }

    pub(crate) fn usual(&self) -> String {
        let [low, high] = self.usual;
        format!("{low} to {high} {}", self.unit)
    }

    /// Refuses a load or a speed that no pair of gears has.
    pub(crate) fn refuse_impossible(&self, source: &Source) -> Result<(), CaseError> {
        if self.value <= self.most {
            return Ok(());
        }
        let key = Section::new(source, "operation").key(self.key);
        let seen = format!(
            "a {} of {} {}",
            self.name,
            decimals(self.value, 0),
            self.unit
        );
        Err(impossible_at(source, key, seen, self.usual()))
    }

    fn unusual(&self) -> Option<Warning> {
        let text = || {
            let value = with_unit(&digits(self.value), self.unit);
            let (key, name, usual) = (self.key, self.name, self.usual());
            format!("operation.{key}: a {name} of {value} is unusual; usual is {usual}")
        };
        (!within(self.value, self.usual)).then(|| Warning::new(UNUSUAL, text()))
    }
}

/// The warning about an oil that is unusually thin or stiff at the bulk temperature.
pub(crate) fn unusual_oil(input: &CaseInput, oil: &LubricantState) -> Option<Warning> {
    let viscosity = oil.dynamic_viscosity.si();
    if within(viscosity, OIL_USUAL) {
        return None;
    }
    let [low, high] = OIL_USUAL;
    let viscosity = digits(viscosity);
    let key = input.operation.temperature_key();
    let text = format!("{key}: the oil has {viscosity} Pa s there; usual is {low} to {high} Pa s");
    Some(Warning::new(UNUSUAL, text))
}

/// Warnings about the unusual numbers of a case.
pub(crate) fn unusual(
    input: &CaseInput,
    source: &Source,
    loads: impl Iterator<Item = AtPitchPoint>,
) -> Vec<Warning> {
    let mut warnings = ranges::unusual(input, source);
    warnings.extend(loads.filter_map(|load| load.unusual()));
    warnings
}

/// Warns of a pinion with more teeth than the wheel, which may be exchanged; not in a gear train.
pub(crate) fn step_up(gears: &GearPair, source: &Source) -> Option<Warning> {
    let [pinion, wheel] = gears.teeth;
    let text = || {
        format!(
            "gears.teeth: the pinion, which is named first and has the speed and the torque of the case, has {pinion} teeth and the wheel {wheel}"
        )
    };
    (pinion > wheel && source.mesh().is_none()).then(|| Warning::new(UNUSUAL, text()))
}

/// W445: profile shifts of which the case gives only the sum, by its centre distance.
pub(crate) fn divided_shifts(
    input: &GearsInput,
    gears: &GearPair,
    source: &Source,
) -> Option<Warning> {
    let is_stated = input.profile_shift.is_some() || input.tip_diameter.is_some();
    let [x1, x2] = gears.profile_shift?;
    (input.centre_distance.is_some() && !is_stated).then(|| {
        let sum = gears.profile_shift_sum;
        let key = source.key_in_train("gears.profile_shift".into());
        let text = format!(
            "{key}: the centre distance gives the sum {sum:.3}, taken as [{x1:.3}, {x2:.3}] with equal specific sliding at both ends of contact"
        );
        Warning::new(DIVIDED, text)
    })
}

/// W453: tips without alteration that leave little clearance, and the worth of the tip alteration of ISO 21771.
pub(crate) fn little_clearance(
    input: &GearsInput,
    gears: &GearPair,
    source: &Source,
) -> Option<Warning> {
    /// Alteration \[modules\] from which it is noted: a fifth of the usual clearance of 0.25 modules.
    const WORTHWHILE: f64 = -0.05;
    let k = gears.tip_alteration();
    if gears.internal || input.tip_diameter.is_some() || k >= WORTHWHILE {
        return None;
    }
    let altered = gears.with_tip_chamfer([gears.normal_module * -k; 2]).ok()?;
    let both = [gears, &altered].map(|pair| {
        let [d1, d2] = pair.tip_radius.map(|r| decimals(2e3 * r.si(), 3));
        let [contact, loss] = [pair.path.eps_alpha, pair.ohlendorf_loss_factor()];
        format!(
            "tips of {d1} and {d2} mm, a contact ratio of {} and H_V {} by Ohlendorf",
            decimals(contact, 3),
            decimals(loss, 3)
        )
    });
    let key = source.key_in_train("gears.tip_diameter".into());
    let [without, with] = both;
    let text = format!(
        "{key}: not stated, taken by the addendum alone: {without}; the tip alteration k = {} of ISO 21771 gives {with}",
        decimals(k, 3)
    );
    Some(Warning::new(CLEARANCE, text))
}
