//! Refusals, and the result of no loss.

use asperity_core::quantity::{
    AngularSpeed, Length, LineEnergy, LineLoad, Power, Pressure, Speed, Time, Torque,
};
use asperity_core::{DomainError, Fault};
use asperity_efficiency::deformation::{
    SurfaceDeformation, elastic_energy, engagement_period, hysteresis_power, plastic_work,
    printed_deformation, running_in,
};
use asperity_efficiency::output_torque::{output_torque, power_flow};
use asperity_efficiency::{
    Breakdown, EfficiencyError, LossKind, MeshOperation, PositionLoss, RollingSurfaces,
    equivalent_friction, mesh_efficiency, mesh_loss,
};

fn place() -> PositionLoss {
    PositionLoss {
        weight: Length::from_si(0.08),
        sliding_force: LineLoad::from_si(5e3),
        sliding_speed: Speed::from_si(-0.7),
        rolling_force: LineLoad::from_si(160.0),
        entrainment_speed: Speed::from_si(4.5),
    }
}

fn operation() -> MeshOperation {
    MeshOperation {
        pinion_torque: Torque::from_si(100.0),
        pinion_speed: AngularSpeed::from_si(10.0),
        teeth: [20, 30],
    }
}

fn is_domain<T: std::fmt::Debug>(result: Result<T, EfficiencyError>) -> bool {
    let fault = result.err().map(Fault::from);
    fault.is_some_and(|fault| fault.cause::<DomainError>().is_some())
}

#[test]
fn losses_cannot_be_negative_or_unknown() {
    let bad = [
        PositionLoss {
            weight: Length::from_si(-1.0),
            ..place()
        },
        PositionLoss {
            sliding_force: LineLoad::from_si(-1.0),
            ..place()
        },
        PositionLoss {
            sliding_speed: Speed::from_si(f64::NAN),
            ..place()
        },
        PositionLoss {
            rolling_force: LineLoad::from_si(f64::INFINITY),
            ..place()
        },
        PositionLoss {
            entrainment_speed: Speed::from_si(-4.0),
            ..place()
        },
        PositionLoss {
            sliding_force: LineLoad::from_si(1e300),
            sliding_speed: Speed::from_si(1e300),
            ..place()
        },
    ];
    for position in bad {
        assert!(
            is_domain(mesh_loss(&[place(), position], RollingSurfaces::Both)),
            "{position:?}"
        );
    }
    let none = mesh_loss(&[], RollingSurfaces::Both);
    let expected = "a mesh loss needs at least one position";
    assert_eq!(none.unwrap_err().to_string(), expected);
    let negative = [(LossKind::Sliding, Power::from_si(-1.0))];
    assert!(is_domain(mesh_efficiency(&operation(), &negative)));
}

#[test]
fn a_mesh_that_loses_all_it_gets_has_no_efficiency() {
    for loss in [1000.0, 1500.0] {
        let refused = power_flow(&operation(), Power::from_si(loss));
        let refused = refused.unwrap_err().to_string();
        assert!(
            refused.contains("are not below the input power"),
            "{refused}"
        );
    }
    // When the wheel drives, the input is what the losses leave, and them.
    let back = MeshOperation {
        pinion_torque: Torque::from_si(-100.0),
        ..operation()
    };
    assert_eq!(
        power_flow(&back, Power::from_si(1000.0))
            .unwrap()
            .efficiency,
        0.5
    );
}

#[test]
fn operations_that_are_none_are_refused() {
    let bad = [
        MeshOperation {
            pinion_torque: Torque::from_si(0.0),
            ..operation()
        },
        MeshOperation {
            pinion_torque: Torque::from_si(f64::NAN),
            ..operation()
        },
        MeshOperation {
            pinion_speed: AngularSpeed::from_si(0.0),
            ..operation()
        },
        MeshOperation {
            teeth: [0, 30],
            ..operation()
        },
        MeshOperation {
            teeth: [20, 0],
            ..operation()
        },
    ];
    for operation in bad {
        assert!(is_domain(mesh_efficiency(&operation, &[])), "{operation:?}");
    }
    let speed = AngularSpeed::from_si(1.0);
    assert!(is_domain(output_torque(
        Torque::from_si(1.0),
        speed,
        speed,
        1.01
    )));
    assert!(is_domain(equivalent_friction(0.99, 0.0)));
    assert!(is_domain(equivalent_friction(f64::NAN, 0.1)));
}

#[test]
fn a_mesh_without_losses_gives_all_of_its_power_out() {
    let mesh = mesh_efficiency(&operation(), &[(LossKind::Sliding, Power::from_si(0.0))]).unwrap();
    assert_eq!(mesh.flow.efficiency, 1.0);
    // Through the speed ratio 3/2, which rounds.
    assert!((mesh.flow.output_torque.si() - 150.0).abs() < 1e-12);
    assert_eq!(mesh.breakdown.components[0].share_percent, 0.0);
}

#[test]
fn deformations_that_release_energy_are_refused() {
    let dx = Length::from_si(1e-6);
    let released = plastic_work(&[1e9], &[-1e-9], dx);
    let released = released.unwrap_err().to_string();
    assert!(
        released.contains("cannot release more than it took"),
        "{released}"
    );
    let uneven = elastic_energy(&[1e9, 1e9], &[1e-9], dx);
    assert_eq!(
        uneven.unwrap_err().to_string(),
        "displacement has 1 points where 2 are needed"
    );
    assert!(is_domain(plastic_work(&[-1e9], &[1e-9], dx)));
    assert!(is_domain(plastic_work(&[1e9], &[f64::NAN], dx)));
    assert!(is_domain(plastic_work(
        &[1e9],
        &[1e-9],
        Length::from_si(0.0)
    )));
    // A point may give some back when the whole takes.
    assert!(plastic_work(&[1e9, 1e9], &[2e-9, -1e-9], dx).is_ok());
}

#[test]
fn deformation_powers_need_sensible_numbers() {
    let (face, period) = (Length::from_si(0.05), Time::from_si(4e-4));
    let surface = SurfaceDeformation {
        stress: Pressure::from_si(5e8),
        elastic: Length::from_si(1e-9),
        plastic: Length::from_si(-1e-10),
    };
    assert!(is_domain(printed_deformation(
        &surface,
        Length::from_si(1e-4),
        period
    )));
    assert!(is_domain(running_in(
        &[LineEnergy::from_si(-1.0)],
        face,
        period
    )));
    assert!(is_domain(running_in(&[], face, Time::from_si(0.0))));
    assert!(is_domain(hysteresis_power(
        LineEnergy::from_si(1.0),
        1.5,
        face,
        period
    )));
    assert!(is_domain(engagement_period(0, AngularSpeed::from_si(1.0))));
    assert!(is_domain(Breakdown::new(&[], Time::from_si(-1.0))));
}
