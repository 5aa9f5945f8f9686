//! Properties of every pair.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use asperity_core::quantity::{Angle, AngularSpeed, Length, Torque};
use asperity_gear::{GearPair, GearPairInput, LoadSharing, PositionRule};
use proptest::prelude::*;

/// Working pairs with 1 < ε_α ≤ 2; `helix` in degrees.
fn pairs(helix: impl Strategy<Value = f64>) -> impl Strategy<Value = (GearPairInput, GearPair)> {
    let teeth = [20u32..60, 20u32..130];
    let shifts = [-0.1f64..0.4, -0.1f64..0.4];
    (teeth, 1e-3f64..6e-3, helix, 0.01f64..0.08, shifts).prop_filter_map(
        "the pair must work with one or two pairs in contact",
        |(teeth, module, helix, width, shifts)| {
            let input = GearPairInput {
                profile_shift: Some(shifts),
                ..GearPairInput::standard(
                    teeth,
                    Length::from_si(module),
                    Angle::from_si(helix.to_radians()),
                    Length::from_si(width),
                )
            };
            let pair = GearPair::new(&input).ok()?;
            let two = pair.path().eps_alpha > 1.0 && pair.path().eps_alpha <= 2.0;
            two.then_some((input, pair))
        },
    )
}

fn spur() -> impl Strategy<Value = (GearPairInput, GearPair)> {
    pairs(Just(0.0))
}

fn helical() -> impl Strategy<Value = (GearPairInput, GearPair)> {
    pairs(5.0f64..35.0)
}

fn spur_or_helical() -> impl Strategy<Value = (GearPairInput, GearPair)> {
    pairs(prop_oneof![Just(0.0), 5.0f64..35.0])
}

fn laws() -> [LoadSharing; 4] {
    [
        LoadSharing::Uniform,
        LoadSharing::Trapezoid,
        LoadSharing::MinPotential,
        LoadSharing::Table(vec![(0.0, 0.0), (0.2, 0.4), (0.5, 1.3), (1.0, 0.1)]),
    ]
}

fn spur_only(law: &LoadSharing) -> bool {
    matches!(law, LoadSharing::Trapezoid)
}

/// Products and sums of a few numbers.
const ROUNDING: f64 = 1e-12;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_radii_of_curvature_sum_to_the_distance_between_the_base_circles((_, pair) in spur_or_helical(), at in 0.0f64..1.0) {
        let s = pair.path().a + pair.path().length * at;
        let motion = pair.kinematics(s, AngularSpeed::from_si(100.0)).unwrap();
        let sum = (motion.rho1 + motion.rho2).si();
        prop_assert!((sum / pair.path().t1t2.si() - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn sliding_is_the_difference_of_the_surface_speeds((_, pair) in spur_or_helical(), at in 0.0f64..1.0, omega in 1.0f64..2000.0) {
        let s = pair.path().a + pair.path().length * at;
        let motion = pair.kinematics(s, AngularSpeed::from_si(omega)).unwrap();
        let difference = motion.u1.si() - motion.u2.si();
        let size = motion.entrainment.si();
        prop_assert!((motion.sliding.si() - difference).abs() < ROUNDING * size);
        let arm = (s - pair.path().c).si();
        let rolling = omega * (1.0 + 1.0 / pair.ratio) * arm;
        prop_assert!((motion.sliding.si() - rolling).abs() < ROUNDING * size);
    }

    #[test]
    fn the_working_geometry_closes((_, pair) in spur_or_helical()) {
        let radii = pair.working_pitch_radius[0] + pair.working_pitch_radius[1];
        prop_assert!((radii / pair.centre_distance - 1.0).abs() < ROUNDING);
        // T₁T₂, the base radii and the centre distance make a right-angled triangle.
        let legs = pair.path().t1t2.si().hypot((pair.base_radius[0] + pair.base_radius[1]).si());
        prop_assert!((legs / pair.centre_distance.si() - 1.0).abs() < ROUNDING);
        let path = pair.path();
        prop_assert!((path.eps_1 + path.eps_2 - path.eps_alpha).abs() < ROUNDING);
        let overlap = pair.face_width.si() * pair.helix.si().sin()
            / (std::f64::consts::PI * pair.normal_module.si());
        prop_assert!((path.eps_beta - overlap).abs() < ROUNDING * (1.0 + overlap));
    }

    #[test]
    fn coordinates_and_places_are_inverse_to_each_other((_, pair) in spur_or_helical(), xi in 0.0f64..2.0) {
        let path = pair.path();
        prop_assert!((path.coordinate(path.place(xi)) - xi).abs() < ROUNDING);
        prop_assert_eq!(path.coordinate(path.a), 0.0);
        prop_assert!((path.coordinate(path.d) - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn the_shares_of_all_pairs_in_contact_sum_to_one(eps in 1.001f64..2.0, phase in 0.0f64..1.0) {
        for law in laws() {
            let sum: f64 = [phase, phase + 1.0]
                .into_iter()
                .filter(|xi| *xi <= eps)
                .map(|xi| law.share(xi, eps).unwrap())
                .sum();
            prop_assert!((sum - 1.0).abs() < 1e-14, "{} {sum}", law.name());
        }
    }

    #[test]
    fn least_energy_and_equal_shares_are_symmetric(eps in 1.001f64..2.0, at in 0.0f64..1.0) {
        for law in [LoadSharing::Uniform, LoadSharing::Trapezoid, LoadSharing::MinPotential] {
            let (here, mirrored) = (at * eps, eps - at * eps);
            let difference = law.weight(here, eps).unwrap() - law.weight(mirrored, eps).unwrap();
            prop_assert!(difference.abs() < ROUNDING / (eps - 1.0), "{}", law.name());
        }
    }

    #[test]
    fn the_mean_load_on_all_contact_lines_is_the_tooth_force((_, pair) in spur_or_helical(), torque in 1.0f64..1e4) {
        let torque = Torque::from_si(torque);
        let force = pair.forces(torque).unwrap().normal_base.si();
        for law in laws().iter().filter(|law| pair.is_spur() || !spur_only(law)) {
            let mean = pair
                .mean_over_mesh(512, |place| pair.line_load(place.s, torque, law).unwrap().si())
                .unwrap();
            // The kinks of the table are not segment ends; 512 places step over them. A segment too
            // narrow for a second place is off by the cube of its width.
            let tolerance = if matches!(law, LoadSharing::Table(_)) { 1e-4 } else { 1e-9 };
            prop_assert!((mean / force - 1.0).abs() < tolerance, "{} {mean} {force}", law.name());
        }
    }

    #[test]
    fn rows_on_the_lines_of_a_table_change_no_loss_factor((_, pair) in spur_or_helical()) {
        // Rows between make kinks of no height: the integrals split there as well.
        let plain = LoadSharing::Table(vec![(0.0, 0.2), (0.37, 1.0), (1.0, 0.1)]);
        let split = LoadSharing::Table(vec![(0.0, 0.2), (0.185, 0.6), (0.37, 1.0), (0.685, 0.55), (1.0, 0.1)]);
        let [plain, split] = [plain, split].map(|law| pair.loss_factors(&law).unwrap());
        for (a, b) in [(plain.local, split.local), (plain.local_phase_averaged, split.local_phase_averaged)] {
            prop_assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        }
    }

    #[test]
    fn means_over_positions_are_means_over_the_mesh_cycle((_, pair) in spur_or_helical(), power in 0i32..4) {
        // By phases: at each, integrate ξ^n along every line of contact.
        let (eps, phases) = (pair.path().eps_alpha, 2000);
        let per_coordinate = pair.face_width.si() / pair.base_helix.si().cos();
        let antiderivative = |xi: f64| xi.powi(power + 1) / f64::from(power + 1);
        let line = |front: f64| {
            if pair.is_spur() {
                return if (0.0..eps).contains(&front) { front.powi(power) * per_coordinate } else { 0.0 };
            }
            let (from, to) = (front.max(0.0), (front + pair.path().eps_beta).min(eps));
            let part = (antiderivative(to) - antiderivative(from)) / pair.path().eps_beta;
            if to > from { part * per_coordinate } else { 0.0 }
        };
        let reach = pair.path().eps_gamma.ceil() as i32;
        let by_phase = (0..phases)
            .map(|k| (f64::from(k) + 0.5) / f64::from(phases))
            .map(|phase| (-reach..=reach).map(|j| line(phase + f64::from(j))).sum::<f64>())
            .sum::<f64>() / f64::from(phases);
        let mean = pair.mean_over_mesh(16, |place| place.xi.powi(power)).unwrap();
        // A jump inside one of 2000 phases.
        prop_assert!((mean / by_phase - 1.0).abs() < 4e-3, "{mean} {by_phase}");
    }

    #[test]
    fn the_mean_contact_length_is_the_mean_over_the_phases((_, pair) in spur_or_helical()) {
        let count = 1000;
        let lengths: Vec<f64> = (0..count)
            .map(|k| pair.contact_length((f64::from(k) + 0.5) / f64::from(count)).unwrap().si())
            .collect();
        let mean = lengths.iter().sum::<f64>() / f64::from(count);
        // The length jumps or bends inside one of a thousand phases.
        prop_assert!((mean / pair.mean_contact_length().si() - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_whole_overlap_ratio_keeps_the_contact_length_constant((input, pair) in helical(), whole in 1u32..5) {
        let width = pair.face_width * (f64::from(whole) / pair.path().eps_beta);
        let pair = GearPair::new(&GearPairInput { face_width: [width; 2], ..input }).unwrap();
        let mean = pair.mean_contact_length();
        for k in 0..20 {
            let length = pair.contact_length(0.05 * f64::from(k)).unwrap();
            prop_assert!((length / mean - 1.0).abs() < 1e-10);
        }
        // Then the load at each instant is the mean load.
        let factors = pair.loss_factors(&LoadSharing::Uniform).unwrap();
        prop_assert!((factors.local_phase_averaged / factors.local - 1.0).abs() < 1e-10);
    }

    #[test]
    fn constant_friction_with_equal_shares_loses_mu_times_ohlendorf((_, pair) in spur(), mu in 0.01f64..0.12) {
        let path = pair.path();
        // Ohlendorf's formula supposes the pitch point in single contact.
        prop_assume!(path.c >= path.b && path.c <= path.d);
        let (torque, speed) = (Torque::from_si(100.0), AngularSpeed::from_si(300.0));
        let loss = pair
            .mean_over_mesh(8, |place| {
                let load = pair.line_load(place.s, torque, &LoadSharing::Uniform).unwrap().si();
                mu * load * pair.kinematics(place.s, speed).unwrap().sliding.si().abs()
            })
            .unwrap();
        let efficiency = 1.0 - loss / (100.0 * 300.0);
        prop_assert!((efficiency - (1.0 - mu * pair.ohlendorf_loss_factor())).abs() < 1e-14);
    }

    #[test]
    fn widening_a_pair_leaves_its_loss_factors((input, pair) in spur_or_helical(), factor in 1.0f64..3.0) {
        let wider = GearPairInput { face_width: input.face_width.map(|b| b * factor), ..input };
        let wider = GearPair::new(&wider).unwrap();
        for law in laws().iter().filter(|law| pair.is_spur() || !spur_only(law)) {
            let (one, two) = (pair.loss_factors(law).unwrap(), wider.loss_factors(law).unwrap());
            prop_assert!((two.local / one.local - 1.0).abs() < ROUNDING);
            prop_assert!((two.ohlendorf / one.ohlendorf - 1.0).abs() < ROUNDING);
        }
    }

    #[test]
    fn ratios_do_not_depend_on_the_size((input, pair) in spur_or_helical(), factor in 0.1f64..10.0) {
        let larger = GearPair::new(&GearPairInput {
            module: input.module * factor,
            face_width: input.face_width.map(|b| b * factor),
            ..input
        })
        .unwrap();
        let law = LoadSharing::MinPotential;
        let (one, two) = (pair.loss_factors(&law).unwrap(), larger.loss_factors(&law).unwrap());
        for (one, two) in [
            (one.local, two.local),
            (one.local_phase_averaged, two.local_phase_averaged),
            (pair.path().eps_gamma, larger.path().eps_gamma),
            (pair.path().t1t2.si() * factor, larger.path().t1t2.si()),
        ] {
            prop_assert!((two / one - 1.0).abs() < 1e-11);
        }
    }

    #[test]
    fn exchanging_the_gears_mirrors_the_path((input, pair) in spur_or_helical()) {
        let other = GearPair::new(&input.swapped()).unwrap();
        let (path, mirrored) = (pair.path(), other.path());
        let close = |one: f64, two: f64| (one - two).abs() < 1e-11 * two.abs().max(1.0);
        prop_assert!(close(path.eps_1, mirrored.eps_2) && close(path.eps_2, mirrored.eps_1));
        prop_assert!(close(path.a.si(), (path.t1t2 - mirrored.e).si()));
        let law = LoadSharing::MinPotential;
        let (one, two) = (pair.loss_factors(&law).unwrap(), other.loss_factors(&law).unwrap());
        prop_assert!(close(one.local, two.local) && close(one.ohlendorf, two.ohlendorf));
        prop_assert!(close(one.local_phase_averaged, two.local_phase_averaged));
    }

    #[test]
    fn the_sign_of_the_torque_only_names_the_driver((_, pair) in spur_or_helical(), torque in 1.0f64..1e4) {
        let forces = |t| pair.forces(Torque::from_si(t)).unwrap();
        let (forward, back) = (forces(torque), forces(-torque));
        prop_assert_eq!(forward.normal_base, back.normal_base);
        prop_assert_ne!(forward.driver, back.driver);
    }

    #[test]
    fn unloaded_path_ends_lower_the_loss((_, pair) in spur()) {
        // Less load where sliding is fastest: trapezoid and least energy lose less.
        let local = |law| pair.loss_factors(&law).unwrap().local;
        let uniform = local(LoadSharing::Uniform);
        prop_assert!(local(LoadSharing::Trapezoid) < uniform);
        prop_assert!(local(LoadSharing::MinPotential) < uniform);
    }

    #[test]
    fn weights_of_positions_are_positive_and_sum_to_the_contact_length((_, pair) in spur_or_helical(), count in 4usize..80) {
        for rule in [PositionRule::GaussLegendre, PositionRule::Midpoint] {
            let places = pair.positions(count, rule).unwrap();
            prop_assert_eq!(places.len(), count);
            prop_assert!(places.iter().all(|place| place.weight.si() > 0.0));
            prop_assert!(places.iter().all(|place| place.s > pair.path().a && place.s < pair.path().e));
            let sum: f64 = places.iter().map(|place| place.weight.si()).sum();
            prop_assert!((sum / pair.mean_contact_length().si() - 1.0).abs() < ROUNDING);
        }
    }

    #[test]
    fn no_numbers_make_it_panic(
        teeth in [any::<u32>(), any::<u32>()],
        numbers in proptest::collection::vec(any::<f64>(), 10),
        given in [any::<bool>(), any::<bool>(), any::<bool>()],
    ) {
        let length = |k: usize| Length::from_si(numbers[k]);
        let input = GearPairInput {
            teeth: [teeth[0] % 200, teeth[1]],
            module_plane: asperity_gear::Plane::Transverse,
            pressure_angle: Angle::from_si(numbers[1] % 1.0),
            overlap: None,
            profile_shift: given[0].then_some([numbers[2], numbers[3] % 2.0]),
            centre_distance: given[1].then_some(length(4)),
            tip_radius: given[2].then_some([length(5), length(6)]),
            addendum: numbers[7] % 2.0,
            ..GearPairInput::standard(teeth, length(0), Angle::from_si(numbers[8] % 1.0), length(9))
        };
        if let Ok(pair) = GearPair::new(&input) {
            let factors = pair.loss_factors(&LoadSharing::Uniform).unwrap();
            prop_assert!(factors.local.is_finite());
        }
    }
}
