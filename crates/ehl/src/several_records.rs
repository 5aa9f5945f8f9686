//! Records of one contact that begin at different places of its surfaces.

use asperity_core::quantity::Length;
use asperity_core::task::try_par_map;

use crate::batch_means::RecordMean;
use crate::error::EhlError;
use crate::evidence::Solved;
use crate::transient::{
    HeatedFriction, MeanFriction, Progress, Record, RecordSettings, RoughContact, record_watched,
};

/// Parts of the surfaces between one beginning and the next: multiples of them, minus their whole parts, fill
/// both evenly and never with the same pairs.
const PARTS: [f64; 2] = [0.618_033_988_749_894_9, 0.414_213_562_373_095];

/// Records a rough contact `count` times in parallel, in order, each from another pair of places; `watch` sees
/// every step of every record and stops them all by returning false.
///
/// # Errors
/// The first error of [`record_watched`]; of surfaces that pass once there is one record.
pub fn record_several(
    contact: &RoughContact,
    count: usize,
    settings: &RecordSettings,
    watch: &(dyn Fn(usize, Progress) -> bool + Sync),
) -> Result<Vec<Solved<Record>>, EhlError> {
    let periods = [&contact.surface_1, &contact.surface_2].map(|surface| surface.period());
    let has_beginnings = periods.iter().any(Option::is_some);
    let count = if has_beginnings { count.max(1) } else { 1 };
    try_par_map(0..count, |number| {
        let [first, second] = [0, 1].map(|surface| {
            let part = (number as f64 * PARTS[surface]).fract();
            periods[surface].map_or(Length::from_si(0.0), |period| period * part)
        });
        let shifted = RoughContact {
            surface_1: contact.surface_1.clone().shifted(first),
            surface_2: contact.surface_2.clone().shifted(second),
            ..contact.clone()
        };
        record_watched(&shifted, settings, |progress| watch(number, progress))
    })
}

/// Mean of independent records of one contact: means of their means, standard errors of those, the work of all,
/// and history and frames of the first. None of no record.
pub fn mean_of(records: &[Solved<Record>]) -> Option<Solved<Record>> {
    let (first, others) = records.split_first()?;
    let count = records.len() as f64;
    let mean = |of: &dyn Fn(&Record) -> RecordMean| {
        let all = || records.iter().map(|record| of(&record.value));
        let squares: f64 = all().map(|one| one.standard_error.powi(2)).sum();
        RecordMean {
            mean: all().map(|one| one.mean).sum::<f64>() / count,
            standard_error: squares.sqrt() / count,
        }
    };
    let nodes = |of: fn(&Record) -> &Vec<f64>| -> Vec<f64> {
        let at = |i| {
            records
                .iter()
                .map(|record| of(&record.value)[i])
                .sum::<f64>()
                / count
        };
        (0..of(&first.value).len()).map(at).collect()
    };
    let mut evidence = first.evidence;
    for other in others {
        evidence.join(&other.evidence);
    }
    let mut value = first.value.clone();
    value.solid_share = mean(&|r| r.solid_share);
    for (k, below) in value.load_below.iter_mut().enumerate() {
        below.share = mean(&|r| r.load_below[k].share);
    }
    value.contact_share = mean(&|r| r.contact_share);
    value.plastic_share = mean(&|r| r.plastic_share);
    value.mean_film = mean(&|r| r.mean_film);
    value.mean_max_pressure = mean(&|r| r.mean_max_pressure);
    let friction = |of: &dyn Fn(&Record) -> Option<MeanFriction>| {
        let part = |part: fn(&MeanFriction) -> RecordMean| {
            mean(&|r| of(r).map_or(RecordMean::default(), |friction| part(&friction)))
        };
        of(&first.value).map(|_| MeanFriction {
            film: part(|f| f.film),
            shifted: part(|f| f.shifted),
            graded: part(|f| f.graded),
            stepped: part(|f| f.stepped),
            boundary_share: part(|f| f.boundary_share),
        })
    };
    value.friction = friction(&|r| r.friction);
    value.heated = friction(&|r| r.heated.map(|heated| heated.friction)).map(|friction| {
        let rise = |of: fn(&HeatedFriction) -> RecordMean| {
            mean(&|r| r.heated.map_or(RecordMean::default(), |heated| of(&heated)))
        };
        HeatedFriction {
            friction,
            film_rise: rise(|heated| heated.film_rise),
            surface_rise: rise(|heated| heated.surface_rise),
        }
    });
    let spread = |record: &Solved<Record>| record.value.film_spread.si().powi(2);
    value.film_spread = Length::from_si((records.iter().map(spread).sum::<f64>() / count).sqrt());
    let largest = records.iter().map(|r| r.value.max_pressure.si());
    value.max_pressure = asperity_core::quantity::Pressure::from_si(largest.fold(0.0, f64::max));
    value.travel = records.iter().map(|r| r.value.travel).sum();
    value.blocks = records.iter().map(|r| r.value.blocks).sum();
    value.mean_pressure = nodes(|r| &r.mean_pressure);
    value.mean_film_on_nodes = nodes(|r| &r.mean_film_on_nodes);
    Some(Solved { value, evidence })
}
