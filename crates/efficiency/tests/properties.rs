//! Balances and scalings that hold for every mesh.

use asperity_core::quantity::{AngularSpeed, Length, LineLoad, Power, Speed, Time, Torque};
use asperity_efficiency::{
    Breakdown, LossKind, MeshOperation, PositionLoss, RollingSurfaces, equivalent_friction,
    mesh_efficiency, mesh_loss,
};
use proptest::prelude::*;

const KINDS: [LossKind; 5] = [
    LossKind::Sliding,
    LossKind::Rolling,
    LossKind::DeformationPinion,
    LossKind::DeformationWheel,
    LossKind::Hysteresis,
];

/// Sums of a few positive numbers.
const ROUNDING: f64 = 1e-13;

fn losses() -> impl Strategy<Value = Vec<(LossKind, Power)>> {
    let one = (0usize..KINDS.len(), 0.0f64..50.0);
    proptest::collection::vec(one.prop_map(|(k, p)| (KINDS[k], Power::from_si(p))), 1..8)
}

fn operations() -> impl Strategy<Value = MeshOperation> {
    let torque = prop_oneof![10.0f64..1e3, -1e3f64..-10.0];
    (torque, 50.0f64..2000.0, [10u32..200, 10u32..200]).prop_map(|(torque, speed, teeth)| {
        MeshOperation {
            pinion_torque: Torque::from_si(torque),
            pinion_speed: AngularSpeed::from_si(speed),
            teeth,
        }
    })
}

fn positions() -> impl Strategy<Value = Vec<PositionLoss>> {
    let one = (
        1e-4f64..0.01,
        0.0f64..1e4,
        -5.0f64..5.0,
        0.0f64..300.0,
        0.1f64..20.0,
    );
    let place = one.prop_map(
        |(weight, force, sliding, rolling, entrainment)| PositionLoss {
            weight: Length::from_si(weight),
            sliding_force: LineLoad::from_si(force),
            sliding_speed: Speed::from_si(sliding),
            rolling_force: LineLoad::from_si(rolling),
            entrainment_speed: Speed::from_si(entrainment),
        },
    );
    proptest::collection::vec(place, 1..40)
}

proptest! {
    #[test]
    fn input_is_output_and_losses_whichever_gear_drives(operation in operations(), losses in losses()) {
        let Ok(mesh) = mesh_efficiency(&operation, &losses) else {
            // Up to 350 W may be more than a slow mesh gets; that is refused, not balanced.
            let power = operation.pinion_torque.si() * operation.pinion_speed.si();
            prop_assert!(power > 0.0 && power <= 350.0);
            return Ok(());
        };
        prop_assert!(mesh.breakdown.imbalance(&mesh.flow, &operation) < ROUNDING);
        let sum = mesh.flow.output_power + mesh.flow.loss;
        prop_assert!((sum / mesh.flow.input_power - 1.0).abs() < ROUNDING);
        prop_assert!((0.0..=1.0).contains(&mesh.flow.efficiency));
        // The torque given at gear 1 is the input of the pinion that drives, the output of one that does not.
        let given = if mesh.flow.pinion_drives { mesh.flow.input_torque } else { mesh.flow.output_torque };
        prop_assert!((given.si() / operation.pinion_torque.si().abs() - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn shares_sum_to_a_hundred_percent_and_energies_to_power_times_period(losses in losses(), period in 1e-5f64..1e-2) {
        let parts = Breakdown::new(&losses, Time::from_si(period)).unwrap();
        prop_assume!(parts.total.si() > 0.0);
        let shares: f64 = parts.components.iter().map(|part| part.share_percent).sum();
        prop_assert!((shares - 100.0).abs() < 1e-10);
        let energy = parts.energy_per_engagement.si();
        prop_assert!((energy / (parts.total.si() * period) - 1.0).abs() < ROUNDING);
        let by_kind: f64 = KINDS.iter().map(|kind| parts.power(*kind).si()).sum();
        prop_assert!((by_kind / parts.total.si() - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn losses_grow_in_proportion_to_force_and_to_speed(places in positions(), factor in 0.1f64..10.0) {
        let base = mesh_loss(&places, RollingSurfaces::Both).unwrap();
        let scaled: Vec<_> = places
            .iter()
            .map(|place| PositionLoss {
                sliding_force: place.sliding_force * factor,
                entrainment_speed: place.entrainment_speed * factor,
                sliding_speed: -place.sliding_speed,
                ..*place
            })
            .collect();
        let scaled = mesh_loss(&scaled, RollingSurfaces::Both).unwrap();
        prop_assert!((scaled.sliding.si() - factor * base.sliding.si()).abs() <= ROUNDING * scaled.sliding.si());
        prop_assert!((scaled.rolling.si() - factor * base.rolling.si()).abs() <= ROUNDING * scaled.rolling.si());
    }

    #[test]
    fn splitting_a_position_changes_no_loss(places in positions()) {
        let halves: Vec<_> = places
            .iter()
            .flat_map(|place| [PositionLoss { weight: place.weight * 0.5, ..*place }; 2])
            .collect();
        let (one, two) = (
            mesh_loss(&places, RollingSurfaces::Both).unwrap(),
            mesh_loss(&halves, RollingSurfaces::Both).unwrap(),
        );
        prop_assert!((one.sliding.si() - two.sliding.si()).abs() <= ROUNDING * one.sliding.si());
        prop_assert!((one.rolling.si() - two.rolling.si()).abs() <= ROUNDING * one.rolling.si());
    }

    #[test]
    fn more_loss_is_less_efficiency_and_more_equivalent_friction(operation in operations(), loss in 1.0f64..100.0) {
        let of = |loss: f64| {
            let losses = [(LossKind::Sliding, Power::from_si(loss))];
            mesh_efficiency(&operation, &losses).unwrap().flow.efficiency
        };
        let (less, more) = (of(loss), of(1.5 * loss));
        prop_assert!(more < less);
        let friction = |eta| equivalent_friction(eta, 0.1).unwrap().value;
        prop_assert!(friction(more) > friction(less));
    }
}
