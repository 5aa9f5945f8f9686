//! Plastic flow: paths of load, energy, residual profiles.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::{CYLINDER, hertz_problem, largest, relative_difference, rough_gap, tight};
use asperity_contact::running_in::RunningIn;
use asperity_contact::two_flanks::TwoFlanks;
use asperity_contact::{Boundary, ContactProblem, Control, Solver};
use asperity_core::Profile;
use asperity_core::quantity::{Length, LineLoad, Pressure};

/// Approach under each load of a path, with plastic displacement carried on; and that displacement
/// with the energy of its steps.
fn load_path(gap: &mut [f64], spacing: Length, limit: Pressure, loads: &[f64]) -> (Vec<f64>, f64) {
    let mut solver = Solver::new(gap.len(), Boundary::FreeEnds).unwrap();
    let (mut approaches, mut dissipated) = (vec![], 0.0);
    let mut start: Option<Vec<f64>> = None;
    for &load in loads {
        let problem = ContactProblem {
            control: Control::Load(LineLoad::from_si(load)),
            pressure_limit: Some(limit),
            start: start.as_deref(),
            ..hertz_problem(gap, spacing)
        };
        let solution = solver.solve(&problem, &tight()).unwrap();
        approaches.push(solution.approach.si());
        dissipated += solution.dissipated.si();
        for (h, w) in gap.iter_mut().zip(&solution.plastic_displacement) {
            *h += w;
        }
        start = Some(solution.pressure);
    }
    (approaches, dissipated)
}

#[test]
fn loading_in_steps_flows_as_much_as_loading_at_once() {
    let limit = Pressure::from_si(4e9);
    let (gap, spacing) = rough_gap(1_000);
    let path = |steps: u32| {
        let loads: Vec<f64> = (1..=steps)
            .map(|k| CYLINDER.load.si() * f64::from(k) / f64::from(steps))
            .collect();
        let mut after = gap.clone();
        let (_, dissipated) = load_path(&mut after, spacing, limit, &loads);
        (after, dissipated)
    };
    let (once, energy) = path(1);
    let (stepwise, sum) = path(10);
    let flow: Vec<f64> = once.iter().zip(&gap).map(|(a, h)| a - h).collect();
    let steps: Vec<f64> = stepwise.iter().zip(&gap).map(|(a, h)| a - h).collect();
    // A certificate of 1e-12 of a gap range of 15 µm, on a flow of 0.3 µm.
    assert!(largest(&flow) > 1e-7);
    assert!(relative_difference(&steps, &flow) < 1e-8);
    assert!((sum / energy - 1.0).abs() < 1e-8);
}

#[test]
fn the_dissipated_energy_is_the_area_of_the_load_approach_loop() {
    let steps = 40_u32;
    let load = |k: u32| CYLINDER.load.si() * f64::from(k) / f64::from(steps);
    let loads: Vec<f64> = (1..=steps).chain((1..steps).rev()).map(load).collect();
    let (mut gap, spacing) = CYLINDER.gap(1_000);
    let limit = Pressure::from_si(1.5e9);
    let (approaches, dissipated) = load_path(&mut gap, spacing, limit, &loads);
    let area: f64 = loads
        .windows(2)
        .zip(approaches.windows(2))
        .map(|(w, d)| 0.5 * (w[0] + w[1]) * (d[1] - d[0]))
        .sum();
    // The trapezoids miss 0.3 % with 20 steps and 0.02 % with 80.
    assert!(
        (area / dissipated - 1.0).abs() < 2e-3,
        "{}",
        area / dissipated
    );
}

#[test]
fn flanks_pressed_again_on_their_residual_profiles_stay_elastic() {
    let points = 1_500;
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let flank = |seed: u64| {
        let heights = crate::common::self_affine(&x, 6..=200, seed);
        let heights = heights.iter().map(|z| 1e-6 * z).collect();
        Profile::new(Length::from_si(0.4e-6), heights).unwrap()
    };
    let (pinion, wheel) = (flank(3), flank(4));
    let flanks = TwoFlanks {
        first: &pinion,
        second: &wheel,
        radius: CYLINDER.radius,
        load: CYLINDER.load,
        modulus: CYLINDER.modulus,
        pressure_limit: Some(Pressure::from_si(4e9)),
    };
    let first = flanks.press(&tight()).unwrap();
    assert!(first.dissipated.si() > 1e-3);
    let [one, other] = flanks.residual(&first, [0.25, 0.75]).unwrap();
    let again = TwoFlanks {
        first: &one,
        second: &other,
        ..flanks
    };
    let second = again.press(&tight()).unwrap();
    assert!(second.dissipated.si() < 1e-8 * first.dissipated.si());
    assert!(relative_difference(&second.pressure, &first.pressure) < 1e-7);
    // Height is lost where there was flow and nowhere else, in the shares asked for.
    let lost = |before: &Profile, after: &Profile| -> f64 {
        before
            .heights()
            .iter()
            .zip(after.heights())
            .map(|(z, r)| z - r)
            .sum()
    };
    let flow: f64 = first.plastic_displacement.iter().sum();
    assert!((lost(&pinion, &one) / (0.25 * flow) - 1.0).abs() < 1e-9);
    assert!((lost(&wheel, &other) / (0.75 * flow) - 1.0).abs() < 1e-9);
}

#[test]
fn each_flank_runs_in_by_its_own_share_where_it_meets_the_other() {
    let points = 800;
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let heights = crate::common::self_affine(&x, 6..=100, 3);
    let rough = heights.iter().map(|z| 1e-6 * z).collect();
    let rough = Profile::new(Length::from_si(0.6e-6), rough).unwrap();
    let smooth = Profile::new(Length::from_si(0.6e-6), vec![0.0; points]).unwrap();
    let flanks = TwoFlanks {
        first: &rough,
        second: &smooth,
        radius: CYLINDER.radius,
        load: CYLINDER.load,
        modulus: CYLINDER.modulus,
        pressure_limit: Some(Pressure::from_si(3e9)),
    };
    let once = flanks.press(&tight()).unwrap();
    let plan = RunningIn {
        shifts: vec![100],
        shares: [0.2, 0.8],
        shakedown: 1e-6,
        max_cycles: 100,
    };
    let ran_in = plan.run(&flanks, &tight()).unwrap();
    let flow = |share: f64| once.plastic_displacement.iter().map(move |w| -share * w);
    // The smooth flank is the same at any shift, so the first pass is the contact without one, and the
    // second is elastic.
    let cycle = &ran_in.cycles[0];
    assert_eq!(ran_in.cycles.len(), 2);
    assert!((cycle.dissipated / once.dissipated - 1.0).abs() < 1e-6);
    assert!((cycle.contact_fraction / once.contact_fraction - 1.0).abs() < 1e-9);
    let largest = crate::common::largest(&once.plastic_displacement);
    assert!((cycle.largest_flow.si() / largest - 1.0).abs() < 1e-6);
    let close = |found: &[f64], expected: &[f64]| {
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 1e-5 * largest, "{off:e} of {largest:e}");
    };
    let worn: Vec<f64> = rough
        .heights()
        .iter()
        .zip(flow(0.2))
        .map(|(z, w)| z + w)
        .collect();
    close(ran_in.flanks[0].heights(), &worn);
    // Point i of the second flank met point i + 100 of the first.
    let mut dented: Vec<f64> = flow(0.8).collect();
    dented.rotate_left(100);
    close(ran_in.flanks[1].heights(), &dented);
    let mean = |heights: &[f64]| heights.iter().sum::<f64>() / heights.len() as f64;
    for (k, flank) in ran_in.flanks.iter().enumerate() {
        let last = &ran_in.cycles[1];
        let peak = crate::common::largest(flank.heights()) - mean(flank.heights());
        assert!((last.peak[k].si() - peak).abs() < 1e-18);
    }
}
