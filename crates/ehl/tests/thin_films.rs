//! Rough contacts with thin films: no surface enters the other, oil is conserved, and the film of contact nodes, which
//! stands for no measured length, has little influence.

#![allow(
    clippy::unwrap_used,
    reason = "a record that cannot be solved fails its test"
)]

use crate::common::{WAVES, contact, gear_oil, remaining_amplitude, wave_length, waves};
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity};
use asperity_ehl::{
    FrictionLaw, MovingProfile, Oil, Record, RecordSettings, RoughContact, Solved, transient,
};
use asperity_oil::ShearLaw;

/// Two surfaces of the same `rq` \[m\] at the mean speed `u_m` \[m/s\], slide-to-roll ratio 0.2, Eyring stress 5 MPa.
fn rough(rq: f64, u_m: f64) -> RoughContact {
    RoughContact {
        contact: contact(1.2e9, u_m, 0.2),
        oil: Oil {
            shear_law: ShearLaw::Eyring {
                stress: Pressure::from_si(5e6),
            },
            ..gear_oil()
        },
        surface_1: MovingProfile::periodic(&waves(1, rq)),
        surface_2: MovingProfile::periodic(&waves(2, rq)),
    }
}

/// A record of every step from the smooth film on.
fn recorded(contact: &RoughContact, cells: usize, contact_film: f64) -> Solved<Record> {
    let settings = RecordSettings {
        cells,
        contact_film: Length::from_si(contact_film),
        start: 0.0,
        length: 6.0,
        friction: Some(FrictionLaw {
            viscosity: DynamicViscosity::from_si(0.01),
            pressure_viscosity: PressureViscosity::from_si(1.8e-8),
            eyring_stress: Pressure::from_si(5e6),
            limiting_stress: Pressure::from_si(2e6),
            limiting_slope: 0.035,
            boundary_friction: 0.08,
            boundary_layer: Length::from_si(10e-9),
        }),
        frame_interval: Some(0.0),
        ..RecordSettings::default()
    };
    transient::record(contact, &settings).unwrap()
}

/// Roughness that is left of the waves in the contact over the smooth film.
fn roughness_over_film(rq: f64, record: &Record) -> f64 {
    let (mut left, mut all) = (0.0, 0.0);
    for k in WAVES {
        // Amplitudes are in proportion to the length of the wave.
        let square = f64::from(k).powi(-2);
        left += square * remaining_amplitude(wave_length(k), &record.scales).powi(2);
        all += square;
    }
    rq * (2.0 * left / all).sqrt() / record.smooth_film.si()
}

#[test]
fn no_accepted_step_has_surfaces_inside_each_other() {
    for (u_m, contact_film) in [(1.0, 5e-9), (0.3, 5e-9), (0.3, 2e-9)] {
        let solved = recorded(&rough(0.3e-6, u_m), 128, contact_film);
        let record = &solved.value;
        assert_eq!(record.frames.len(), solved.evidence.steps);
        for frame in &record.frames {
            // The end nodes have no pressure by definition, and no conditions.
            let inner = &frame.film[1..frame.film.len() - 1];
            let least = inner.iter().copied().fold(f64::INFINITY, f64::min);
            let least = record.scales.film_length(least).si() / contact_film;
            // The film that an accepted step may have below the contact film; rounding of the convolution.
            assert!(
                least >= 0.01 * (1.0 - 1e-6),
                "{u_m} m/s, T {}: {least}",
                frame.time
            );
        }
    }
}

#[test]
fn full_and_cavitated_nodes_neither_gain_nor_lose_oil() {
    // Bounds of the mean over a record: 0.02 of the flux where the roughness is below three smooth films, 0.03 to
    // five. The 65 gear meshes have at most 0.0162 and 0.0193.
    for (u_m, bounds, most) in [(1.0, 1.0..3.0, 0.02), (0.1, 3.0..5.0, 0.03)] {
        let solved = recorded(&rough(0.3e-6, u_m), 128, 5e-9);
        let ratio = roughness_over_film(0.3e-6, &solved.value);
        let evidence = solved.evidence;
        assert!(bounds.contains(&ratio), "{ratio}");
        assert!(evidence.mean_mass_balance < most, "{evidence:?}");
        assert!(evidence.mean_mass_balance <= evidence.mass_balance);
        assert!(evidence.mean_boundary_supply <= evidence.boundary_supply);
        assert!(evidence.mean_boundary_supply > 0.0, "{evidence:?}");
    }
}

#[test]
fn the_film_of_contact_nodes_has_little_influence() {
    // Rough enough that most of the load below 20 nm is on contact nodes, as on ground flanks.
    let contact = rough(0.9e-6, 1.0);
    let [thin, thick] = [2e-9, 10e-9].map(|film| recorded(&contact, 256, film).value);
    let change = |of: &dyn Fn(&Record) -> f64| (of(&thick) / of(&thin) - 1.0).abs();
    let friction = |record: &Record| record.friction.unwrap();
    let [gap, load, shifted, graded] = [
        change(&|r| r.mean_film.mean),
        change(&|r| r.solid_share.mean),
        change(&|r| friction(r).shifted.mean),
        change(&|r| friction(r).graded.mean),
    ];
    assert!(gap < 0.06, "{gap}");
    assert!(load < 0.15, "{load}");
    assert!(shifted < 0.05, "{shifted}");
    // The weight e^(−h/h_b) takes the film of contact nodes for a film of oil.
    assert!(graded > 0.05, "{graded}");
}
