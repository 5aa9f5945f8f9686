//! Warnings about a record: ridges that cannot leak, and elastic pressures above the flow pressure.

use asperity_core::Code;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl::{PlasticCeiling, Record};

use super::settings::LARGEST_ROUGHNESS;
use asperity_case::case::STEEL_FLOW_PRESSURE;

/// Flow pressure of the hardest steel of the conversion table, 68 HRC or 940 HV `[Hardness-1]`: a ceiling above it
/// represents elastic surfaces.
const HARDEST_STEEL: Pressure = Pressure::from_si(9.218_251e9);

/// Codes and texts of the warnings about a record: W415 if the attenuated roughness exceeds [`LARGEST_ROUGHNESS`]
/// smooth films, W435 by [`elastic_above_flow`].
#[must_use]
pub fn record_warnings(
    record: &Record,
    attenuated_roughness: Length,
    ceiling: Option<PlasticCeiling>,
) -> Vec<(Code, String)> {
    let ratio = attenuated_roughness / record.smooth_film;
    let rough = (ratio > LARGEST_ROUGHNESS).then(|| {
        format!(
            "the roughness left in the contact is {ratio:.2} smooth films (above {LARGEST_ROUGHNESS}): the modelled \
             ridges cannot leak, so rely on measurements rather than on this solution"
        )
    });
    let elastic = elastic_above_flow(record.max_pressure, ceiling);
    let warnings = [(Code::W415, rough), (Code::W435, elastic)];
    let warnings = warnings.into_iter();
    warnings
        .filter_map(|(code, text)| Some((code, text?)))
        .collect()
}

/// Warning about a record whose `largest` pressure steel does not bear without yielding; `None` if its surfaces
/// yield at a `ceiling` that a steel can have, or the pressure stays below the flow pressure of case-hardened steel.
#[must_use]
pub fn elastic_above_flow(largest: Pressure, ceiling: Option<PlasticCeiling>) -> Option<String> {
    let yields = ceiling.is_some_and(|ceiling| ceiling.pressure <= HARDEST_STEEL);
    (!yields && largest > STEEL_FLOW_PRESSURE).then(|| {
        format!(
            "the pressure reaches {largest:.3}, above the {STEEL_FLOW_PRESSURE} at which case-hardened steel flows: the \
             record is elastic, and its pressures, load on thin films and friction are too high for steel"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::hardness::Hardness;

    #[test]
    fn elastic_records_above_the_flow_pressure_are_noted_with_their_pressure() {
        let gigapascals = |value: f64| Pressure::from_si(value * 1e9);
        let ceiling = |value: f64| {
            Some(PlasticCeiling {
                pressure: gigapascals(value),
            })
        };
        for elastic in [None, ceiling(15.0)] {
            let text = elastic_above_flow(gigapascals(8.25), elastic).unwrap();
            assert!(text.contains("8.25 GPa, above the 7 GPa"), "{text}");
            assert_eq!(elastic_above_flow(gigapascals(6.9), elastic), None);
        }
        // A node at the ceiling of a hard steel has yielded there.
        assert_eq!(elastic_above_flow(gigapascals(7.6), ceiling(7.6)), None);
        let hardest: Hardness = "68 HRC".parse().unwrap();
        let flow = hardest.flow_pressure().unwrap();
        assert!((flow / HARDEST_STEEL - 1.0).abs() < 1e-6);
    }
}
