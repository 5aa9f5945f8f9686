//! Invariants of steady and transient lubricated contacts.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a problem that cannot be solved fails its test"
)]

use crate::common::{contact, gear_oil, uniform, waves};
use asperity_core::Code;
use asperity_core::quantity::{Length, Pressure, Speed};
use asperity_ehl::{
    EhlError, LineContact, MovingProfile, NodeState, Oil, PlasticCeiling, Record, RecordSettings,
    RoughContact, Solved, SteadySettings, Window, steady, transient,
};
use asperity_oil::{PressureViscosityLaw, ShearLaw};

fn settings(cells: usize, start: f64, length: f64) -> RecordSettings {
    RecordSettings {
        cells,
        start,
        length,
        history: true,
        ..RecordSettings::default()
    }
}

/// Two wavy surfaces at u_m = 1 m/s, slide-to-roll ratio `srr`, Eyring stress 5 MPa.
fn rough(srr: f64, rq: f64) -> RoughContact {
    RoughContact {
        contact: contact(1.2e9, 1.0, srr),
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

fn run(contact: &RoughContact, settings: &RecordSettings) -> Solved<Record> {
    transient::record(contact, settings).unwrap()
}

#[test]
fn steady_films_carry_the_load_and_lose_no_oil() {
    for (p_0, u_m) in [(0.5e9, 1.0), (1.2e9, 5.0), (2.0e9, 20.0)] {
        let solved = steady::solve(
            &contact(p_0, u_m, 0.0),
            &gear_oil(),
            &SteadySettings::default(),
        )
        .unwrap();
        let evidence = solved.evidence;
        assert!(evidence.load_error < 1e-10, "{evidence:?}");
        // A balance is a difference of two fluxes of the size of one.
        assert!(evidence.complementarity < 1e-8, "{evidence:?}");
        assert!(evidence.mass_balance < 1e-8, "{evidence:?}");
        let film = solved.value;
        for ((p, void), h) in film.pressure.iter().zip(&film.void).zip(&film.film) {
            assert!(*p >= 0.0 && (0.0..1.0).contains(void) && *h > 0.0);
            assert_eq!(p * void, 0.0);
        }
    }
}

#[test]
fn forty_cold_starts_converge() {
    // 0.3 to 2.5 GPa and 0.05 to 50 m/s: M 0.5..1120, L 3.4..19.
    for p_0 in [0.3e9, 0.8e9, 1.2e9, 1.8e9, 2.5e9] {
        for u_m in [0.05, 0.5, 5.0, 50.0] {
            for cells in [512, 1024] {
                let settings = SteadySettings {
                    cells,
                    window: Some(Window::ROUGH),
                };
                let solved = steady::solve(&contact(p_0, u_m, 0.0), &gear_oil(), &settings);
                let evidence = solved
                    .unwrap_or_else(|e| panic!("{p_0} {u_m} {cells}: {e}"))
                    .evidence;
                assert!(evidence.load_error < 1e-10);
            }
        }
    }
}

/// A random smooth problem; what it is, where it was refused.
fn random_smooth(state: &mut u64, cells: usize) -> Option<(PressureViscosityLaw, f64, f64)> {
    let mut between = |low: f64, high: f64| low * (high / low).powf(uniform(state));
    let (p_0, u_m, eta) = (
        between(0.2e9, 3e9),
        between(0.05, 50.0),
        between(0.002, 0.5),
    );
    let alpha = between(0.5e-8, 3e-8);
    let viscosity_law = match (uniform(state) * 4.0) as usize {
        0 => PressureViscosityLaw::Isoviscous,
        1 => PressureViscosityLaw::Barus,
        _ => PressureViscosityLaw::Roelands {
            exponent: 0.4 + 0.4 * uniform(state),
        },
    };
    let oil = Oil {
        viscosity: asperity_core::quantity::DynamicViscosity::from_si(eta),
        pressure_viscosity: asperity_core::quantity::PressureViscosity::from_si(alpha),
        viscosity_law,
        ..gear_oil()
    };
    let settings = SteadySettings {
        cells,
        window: None,
    };
    match steady::solve(&contact(p_0, u_m, 0.0), &oil, &settings) {
        Ok(solved) => {
            assert!(solved.evidence.load_error < 1e-9);
            assert!(solved.value.film.iter().all(|h| h.is_finite()));
            None
        }
        Err(error) if error.is_unconverged() => {
            let scales = contact(p_0, u_m, 0.0).scales(&oil).unwrap();
            Some((viscosity_law, alpha * p_0, scales.moes_load))
        }
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn random_smooth_problems_converge_or_are_refused() {
    let mut state = 7;
    let refused: Vec<_> = (0..100)
        .filter_map(|_| random_smooth(&mut state, 512))
        .collect();
    assert!(refused.is_empty(), "{refused:?}");
}

/// `cargo test --release -p asperity-ehl --test properties -- --ignored`
#[test]
#[ignore = "long: two thousand problems"]
fn two_thousand_random_smooth_problems_converge_or_are_refused() {
    let mut state = 11;
    let refused: Vec<_> = (0..2000)
        .filter_map(|_| random_smooth(&mut state, 512))
        .collect();
    for (law, exponent, load) in &refused {
        println!("{law:?} alpha p0 {exponent:.1} M {load:.0}");
    }
    // Measured 3; what does not converge is refused with its evidence.
    assert!(refused.len() <= 5, "{} of 2000 refused", refused.len());
}

#[test]
fn one_set_of_numbers_has_one_film() {
    // Three contacts of equal M, L and α·p₀ (incompressible Barus needs no more).
    let film = |radius: f64, modulus: f64, speed: f64| {
        let pair = LineContact::at_pressure(
            Length::from_si(radius),
            Pressure::from_si(modulus),
            Pressure::from_si(0.6e9 * modulus / 115.4e9),
            Speed::from_si(speed),
            0.0,
        )
        .unwrap();
        let oil = Oil {
            viscosity: asperity_core::quantity::DynamicViscosity::from_si(
                0.01 * radius / 10e-3 * modulus / 115.4e9 / speed,
            ),
            pressure_viscosity: asperity_core::quantity::PressureViscosity::from_si(
                1.8e-8 * 115.4e9 / modulus,
            ),
            viscosity_law: PressureViscosityLaw::Barus,
            density_law: asperity_oil::DensityLaw::Incompressible,
            shear_law: ShearLaw::Newtonian,
        };
        let solved = steady::solve(&pair, &oil, &SteadySettings::default())
            .unwrap()
            .value;
        crate::common::moes(&pair, &oil, solved.central_film)
    };
    let first = film(10e-3, 115.4e9, 1.0);
    // Equal up to the tolerance of the iteration.
    assert!((film(25e-3, 115.4e9, 3.0) / first - 1.0).abs() < 1e-9);
    assert!((film(4e-3, 50e9, 0.2) / first - 1.0).abs() < 1e-9);
}

#[test]
fn a_steady_film_stays_steady() {
    let smooth = RoughContact {
        contact: contact(1.2e9, 5.0, 0.2),
        oil: gear_oil(),
        surface_1: MovingProfile::smooth(),
        surface_2: MovingProfile::smooth(),
    };
    let record = run(&smooth, &settings(256, 0.0, 2.0)).value;
    let first = record.history[0].central_film;
    for moment in &record.history {
        assert!((moment.central_film / first - 1.0).abs() < 1e-12);
        assert!((moment.central_film / record.smooth_film - 1.0).abs() < 1e-7);
    }
}

#[test]
fn rough_steps_keep_their_conditions() {
    let contact = rough(0.2, 0.15e-6);
    let record_settings = RecordSettings {
        frame_interval: Some(0.5),
        ..settings(256, 1.0, 2.0)
    };
    let solved = run(&contact, &record_settings);
    let evidence = solved.evidence;
    // Linear systems within a step are solved to 1e-3 of a step below 1e-4.
    assert!(evidence.load_error < 1e-6, "{evidence:?}");
    assert!(evidence.mass_balance < 1e-4, "{evidence:?}");
    assert!(evidence.complementarity < 1e-3, "{evidence:?}");
    assert_eq!(evidence.loose_steps, 0);
    assert!(
        evidence.newton_iterations < 9 * evidence.steps,
        "{evidence:?}"
    );
    for frame in &solved.value.frames {
        for (p, state) in frame.pressure.iter().zip(&frame.state) {
            assert!(*p >= 0.0);
            assert!(*state != NodeState::Cavitated || *p == 0.0);
        }
    }
}

#[test]
fn swapping_the_surfaces_and_the_sign_of_sliding_changes_nothing() {
    let (one, other) = (rough(0.3, 0.1e-6), rough(-0.3, 0.1e-6));
    let swapped = RoughContact {
        surface_1: one.surface_2.clone(),
        surface_2: one.surface_1.clone(),
        ..other
    };
    let settings = settings(128, 1.0, 2.0);
    let (a, b) = (run(&one, &settings).value, run(&swapped, &settings).value);
    // The same problem up to the order of two sums.
    assert!((a.mean_film.mean / b.mean_film.mean - 1.0).abs() < 1e-6);
    assert!((a.solid_share.mean - b.solid_share.mean).abs() < 1e-4);
}

#[test]
fn a_shift_by_one_period_changes_nothing() {
    let one = rough(0.3, 0.1e-6);
    let shifted = RoughContact {
        surface_1: one.surface_1.clone().shifted(Length::from_si(480e-6)),
        ..one.clone()
    };
    let settings = settings(128, 1.0, 2.0);
    let (a, b) = (run(&one, &settings).value, run(&shifted, &settings).value);
    assert!((a.mean_film.mean / b.mean_film.mean - 1.0).abs() < 1e-6);
}

#[test]
fn opposite_waves_at_one_speed_are_a_smooth_film() {
    // Galilean check: z₁ = −z₂ in pure rolling cancel.
    let profile = waves(3, 0.1e-6);
    let negative: Vec<f64> = profile.heights().iter().map(|z| -z).collect();
    let mirror = asperity_core::Profile::new(profile.spacing(), negative).unwrap();
    let both = RoughContact {
        contact: contact(1.2e9, 5.0, 0.0),
        oil: gear_oil(),
        surface_1: MovingProfile::periodic(&profile),
        surface_2: MovingProfile::periodic(&mirror),
    };
    let record = run(&both, &settings(128, 0.0, 2.0)).value;
    for moment in &record.history {
        assert!((moment.central_film / record.smooth_film - 1.0).abs() < 1e-7);
    }
}

#[test]
fn the_load_below_a_film_rises_with_the_film() {
    let record = run(&rough(0.2, 0.15e-6), &settings(256, 1.0, 2.0)).value;
    let shares: Vec<f64> = record
        .load_below
        .iter()
        .map(|below| below.share.mean)
        .collect();
    assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]));
    assert!(
        shares[shares.len() - 1] > 0.3 && shares[0] < 0.3,
        "{shares:?}"
    );
    assert!((record.solid_share.mean - shares[2]).abs() < 1e-15);
    assert!(record.solid_share.standard_error.is_finite());
}

#[test]
fn shear_thinning_makes_the_thin_films() {
    let thinned = rough(0.2, 0.15e-6);
    let newtonian = RoughContact {
        oil: gear_oil(),
        ..thinned.clone()
    };
    let settings = settings(256, 1.0, 2.0);
    let (thin, thick) = (
        run(&thinned, &settings).value,
        run(&newtonian, &settings).value,
    );
    let below = |record: &Record| record.load_below[3].share.mean;
    assert!(
        below(&thin) > 1.2 * below(&thick),
        "{} {}",
        below(&thin),
        below(&thick)
    );
    assert!((thin.mean_film.mean / thick.mean_film.mean - 1.0).abs() < 0.2);
}

#[test]
fn the_ceiling_holds_the_pressure() {
    let contact = rough(0.2, 0.3e-6);
    let elastic = run(&contact, &settings(256, 1.0, 2.0)).value;
    let flow = elastic.max_pressure / 1.3;
    let ceiling = PlasticCeiling { pressure: flow };
    let limited = run(
        &contact,
        &RecordSettings {
            ceiling: Some(ceiling),
            ..settings(256, 1.0, 2.0)
        },
    )
    .value;
    assert!(
        limited.max_pressure <= flow * (1.0 + 1e-12),
        "{}",
        limited.max_pressure
    );
    assert!(limited.plastic_share.mean > 0.0);
}

#[test]
fn a_single_pass_runs_in_and_must_be_long_enough() {
    let trace = waves(5, 0.1e-6);
    let once = MovingProfile::single_pass(&trace, Length::from_si(50e-6)).unwrap();
    let short = RoughContact {
        surface_1: once,
        surface_2: MovingProfile::smooth(),
        ..rough(0.2, 0.1e-6)
    };
    let error = transient::record(&short, &settings(128, 1.0, 2.0)).unwrap_err();
    assert_eq!(error.code(), Code::E209);
    let start = "the profile of surface 1 is ";
    assert!(error.to_string().starts_with(start), "{error}");
    let heights: Vec<f64> = (0..4).flat_map(|_| trace.heights().to_vec()).collect();
    let long = asperity_core::Profile::new(trace.spacing(), heights).unwrap();
    let passing = RoughContact {
        surface_1: MovingProfile::single_pass(&long, Length::from_si(50e-6)).unwrap(),
        ..short
    };
    let record = run(&passing, &settings(128, 0.0, 2.0)).value;
    // The record begins when the profile fills the window: 4 half-widths and the taper later.
    assert!(record.history[0].time > 3.6, "{}", record.history[0].time);
    assert!(record.film_spread.si() > 1e-9);
}

#[test]
fn a_watcher_stops_a_record() {
    let error =
        transient::record_watched(&rough(0.2, 0.1e-6), &settings(128, 1.0, 2.0), |progress| {
            progress.steps < 5
        })
        .unwrap_err();
    assert!(matches!(error, EhlError::Stopped { .. }));
}

#[test]
fn nonsense_is_refused() {
    let bad = |cells| {
        let settings = SteadySettings {
            cells,
            window: None,
        };
        steady::solve(&contact(1e9, 1.0, 0.0), &gear_oil(), &settings).unwrap_err()
    };
    for cells in [100, 0] {
        let refused = bad(cells);
        assert_eq!(refused.code(), Code::E209);
        let start = format!("{cells} cells: give a multiple of ");
        assert!(refused.to_string().starts_with(&start), "{refused}");
    }
    let mut oil = gear_oil();
    oil.viscosity_law = PressureViscosityLaw::Roelands { exponent: f64::NAN };
    let settings = SteadySettings::default();
    assert!(steady::solve(&contact(1e9, 1.0, 0.0), &oil, &settings).is_err());
    let window = SteadySettings {
        cells: 128,
        window: Some(Window {
            inlet: f64::NAN,
            outlet: 1.5,
        }),
    };
    assert!(steady::solve(&contact(1e9, 1.0, 0.0), &gear_oil(), &window).is_err());
}
