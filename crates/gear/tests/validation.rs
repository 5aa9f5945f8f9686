//! Against closed forms, the reference case, and a measured gear pair.
//!
//! "Table 2" is the case of Rodríguez 2022, Table 2, with the module read as the normal module; its
//! numbers were evaluated independently in double precision by `references/table_2.py`.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use crate::common::{ROUNDING, assert_close, degrees, mm};
use asperity_core::quantity::{AngularSpeed, Length, Torque};
use asperity_gear::involute::{ToothSection, tooth_thickness};
use asperity_gear::{Gear, GearPair, GearPairInput, LoadSharing, PositionRule};

fn table_2() -> GearPair {
    let input = GearPairInput::standard([50, 120], mm(1.3), degrees(30.0), mm(50.0));
    GearPair::new(&input).unwrap()
}

const TORQUE: Torque = Torque::from_si(285.0);
const SPEED: AngularSpeed = AngularSpeed::from_si(100.0 * std::f64::consts::PI);

#[test]
fn the_reference_case_has_the_geometry_of_table_2() {
    let pair = table_2();
    let lengths = [
        (pair.reference_radius[0], 75.055_534_994_651_34 / 2.0),
        (pair.reference_radius[1], 180.133_283_987_163_22 / 2.0),
        (pair.centre_distance, 127.594_409_490_907_28),
        (pair.base_radius[0], 34.596_512_345_935_5),
        (pair.base_radius[1], 83.031_629_630_245_2),
        (pair.tip_radius[0], 38.827_767_497_325_674),
        (pair.tip_radius[1], 91.366_641_993_581_61),
    ];
    for (length, expected) in lengths {
        assert_close(length.si() * 1e3, expected, ROUNDING);
    }
    let angles = [
        (pair.transverse_pressure_angle, 22.795_877_258_858_475),
        (pair.working_pressure_angle, 22.795_877_258_858_475),
        (pair.base_helix, 28.024_320_673_604_695),
    ];
    for (angle, expected) in angles {
        assert_close(angle.si().to_degrees(), expected, ROUNDING);
    }
}

#[test]
fn the_reference_case_has_the_path_of_contact_of_table_2() {
    let pair = table_2();
    let path = pair.path();
    let lengths = [
        (path.base_pitch, 4.347_525_961_032_781),
        (path.length, 6.315_930_046_778_412),
        (path.a, 11.310_097_932_432_123),
        (path.c, 14.540_105_461_476_728),
        (path.e, 17.626_027_979_210_534),
        (path.t1t2, 49.436_358_569_020_88),
    ];
    for (length, expected) in lengths {
        assert_close(length.si() * 1e3, expected, ROUNDING);
    }
    let ratios = [
        (path.eps_1, 0.709_811_176_607_839_4),
        (path.eps_2, 0.742_953_016_956_178_3),
        (path.eps_alpha, 1.452_764_193_564_017_9),
        (path.eps_beta, 6.121_343_965_072_898_5),
        (path.eps_gamma, 7.574_108_158_636_916),
    ];
    for (ratio, expected) in ratios {
        assert_close(ratio, expected, ROUNDING);
    }
}

#[test]
fn a_transverse_module_gives_the_diameters_directly() {
    let input = GearPairInput {
        module_plane: asperity_gear::Plane::Transverse,
        ..GearPairInput::standard([50, 120], mm(1.3), degrees(30.0), mm(50.0))
    };
    let pair = GearPair::new(&input).unwrap();
    assert_close(pair.reference_radius[0].si(), 32.5e-3, ROUNDING);
    assert_close(pair.centre_distance.si(), 110.5e-3, ROUNDING);
    // Independent evaluation, as for Table 2.
    assert_close(pair.path().eps_beta, 7.068_319_172_074_258, ROUNDING);
    let forces = pair.forces(TORQUE).unwrap();
    assert_close(forces.normal_base.si(), 10_775.689_056_634_244, ROUNDING);
}

#[test]
fn the_reference_case_moves_as_table_2_says() {
    let pair = table_2();
    let path = *pair.path();
    // R mm, V_s, V_e m/s, SRR.
    let points = [
        (
            path.a,
            9.881_144_420_938_57,
            -1.437_543_789_273_886_5,
            4.271_943_952_227_93,
            -0.336_508_110_909_126_1,
        ),
        (
            path.e,
            12.848_111_791_664_245,
            1.373_417_464_095_144_4,
            4.850_671_269_098_024,
            0.283_139_670_347_219_7,
        ),
    ];
    for (s, radius, sliding, entrainment, ratio) in points {
        let motion = pair.kinematics(s, SPEED).unwrap();
        assert_close(motion.radius.si() * 1e3, radius, ROUNDING);
        assert_close(motion.sliding.si(), sliding, ROUNDING);
        assert_close(motion.entrainment.si(), entrainment, ROUNDING);
        assert_close(motion.slide_to_roll, ratio, ROUNDING);
    }
    let pitch = pair.kinematics(path.c, SPEED).unwrap();
    assert_close(pitch.radius.si() * 1e3, 11.626_875_546_138_667, ROUNDING);
    assert_close(pitch.entrainment.si(), 4.567_908_850_019_612, ROUNDING);
    assert_eq!((pitch.sliding.si(), pitch.slide_to_roll), (0.0, 0.0));
}

#[test]
fn the_reference_case_carries_the_forces_of_table_2() {
    let pair = table_2();
    let forces = pair.forces(TORQUE).unwrap();
    assert_eq!(forces.driver, Gear::Pinion);
    assert_close(forces.transverse_base.si(), 8_237.824_586_196_552, ROUNDING);
    assert_close(forces.normal_base.si(), 9_332.020_466_327_23, ROUNDING);
    assert_close(forces.tangential.si(), 7_594.376_617_802_001, ROUNDING);
    // The three parts at the pitch cylinder are those of the normal force.
    let sum = [forces.tangential, forces.radial, forces.axial]
        .map(|part| part.si().powi(2))
        .iter()
        .sum::<f64>()
        .sqrt();
    assert_close(sum, forces.normal_base.si(), ROUNDING);
    let load = pair
        .line_load(pair.path().c, TORQUE, &LoadSharing::Uniform)
        .unwrap();
    // The other program averaged the contact length over 2000 phases, good to 5e-9.
    assert_close(load.si(), 113_408.970_079_308_56, 1e-8);
}

#[test]
fn the_reference_case_has_the_contact_lengths_of_table_2() {
    let pair = table_2();
    let mean = pair.mean_contact_length().si();
    assert_close(mean, 82.286_440_098_539_63e-3, ROUNDING);
    // The extremes of 2000 phases in another program; between two phases the length moves by at most
    // b/(2000 ε_β cos β_b) = 4.6 µm.
    let lengths = (0..2000).map(|k| pair.contact_length(f64::from(k) / 2000.0).unwrap().si());
    let (short, long) = lengths.fold((f64::INFINITY, 0.0f64), |(short, long), length| {
        (short.min(length), long.max(length))
    });
    assert!((short - 81.778_073_955_512_31e-3).abs() < 4.7e-6, "{short}");
    assert!((long - 82.900_879_491_492_55e-3).abs() < 4.7e-6, "{long}");
}

#[test]
fn the_reference_case_has_the_loss_factors_of_table_2() {
    let pair = table_2();
    let factors = pair.loss_factors(&LoadSharing::Uniform).unwrap();
    assert_close(factors.ohlendorf, 0.060_808_147_690_953_926, ROUNDING);
    // The other program took the mean of 400 000 phases by the midpoint rule; from 40 000 on its
    // result moves by 1e-11.
    assert_close(factors.local_phase_averaged, 0.073_278_709_190_6, 1e-10);
    assert_close(factors.local, 0.073_282_753_546_255_6, ROUNDING);
}

#[test]
fn the_local_loss_factor_of_a_helical_pair_has_a_closed_form() {
    let pair = table_2();
    let local = pair.loss_factors(&LoadSharing::Uniform).unwrap().local;
    // The closed form π(u+1)(ε₁²+ε₂²)/(z₁ u cos β_b ε_α) by hand from the numbers of Table 2.
    let (e1, e2) = (0.709_811_176_607_839_4f64, 0.742_953_016_956_178_3f64);
    let hand = std::f64::consts::PI * 3.4 * (e1 * e1 + e2 * e2)
        / (50.0 * 2.4 * degrees(28.024_320_673_604_695).si().cos() * (e1 + e2));
    assert_close(local, hand, ROUNDING);
}

#[test]
fn local_loss_factors_of_spur_pairs_follow_the_sharing() {
    // Table 2 as a spur pair; the other program integrated with 200 001 points.
    let spur = GearPairInput::standard([50, 120], mm(1.3), degrees(0.0), mm(50.0));
    let table_2_spur = GearPair::new(&spur).unwrap();
    let petry_johnson = petry_johnson();
    let cases = [
        (
            &table_2_spur,
            [0.074_075_973_2, 0.067_538_509_2, 0.068_398_783_2],
        ),
        (
            &petry_johnson,
            [0.092_911_387_3, 0.089_717_682_3, 0.090_177_005_0],
        ),
    ];
    let laws = [
        LoadSharing::Uniform,
        LoadSharing::Trapezoid,
        LoadSharing::MinPotential,
    ];
    for (pair, expected) in cases {
        for (law, expected) in laws.iter().zip(expected) {
            let local = pair.loss_factors(law).unwrap().local;
            // A jump of the shares inside one of its 200 000 intervals leaves it 3e-6 off.
            assert_close(local, expected, 3e-6);
        }
    }
}

/// Petry-Johnson et al., Journal of Mechanical Design 130 (2008) 062601: 40/40 teeth, m = 92.74/40
/// mm, 28°, outside diameter 95.95 mm, face 26.7 mm, a = 91.5 mm.
fn petry_johnson() -> GearPair {
    let input = GearPairInput {
        pressure_angle: degrees(28.0),
        centre_distance: Some(mm(91.5)),
        tip_radius: Some([mm(95.95 / 2.0); 2]),
        ..GearPairInput::standard([40, 40], mm(92.74 / 40.0), degrees(0.0), mm(26.7))
    };
    GearPair::new(&input).unwrap()
}

#[test]
fn the_petry_johnson_gears_have_their_published_diameters() {
    let pair = petry_johnson();
    // Printed: base diameter 81.89 mm, from a module and an angle that are rounded themselves.
    assert!((pair.base_radius[0].si() * 2e3 - 81.89).abs() < 0.01);
    // Independent evaluation, as for Table 2.
    assert_close(pair.path().eps_alpha, 1.427_763_886_183_572_5, ROUNDING);
    assert_close(
        pair.ohlendorf_loss_factor(),
        0.092_911_184_483_272_97,
        ROUNDING,
    );
    // The diameter at which the tip of the mate starts contact; printed 87.73 mm.
    let start = (pair.base_radius[0].si().powi(2) + pair.path().a.si().powi(2)).sqrt();
    assert_close(2e3 * start, 87.787_950_728_401_57, ROUNDING);
    assert!((2e3 * start - 87.73).abs() < 0.06);
    // The division of the negative shift is not known, so neither are the tip lands.
    assert!(pair.profile_shift_sum < 0.0 && pair.tip_thickness.is_none());
}

#[test]
fn least_energy_shares_rise_from_about_a_third_to_two_thirds() {
    let share = |xi, eps| LoadSharing::MinPotential.share(xi, eps).unwrap();
    // R(0) = v(0)/(v(0) + v(1)), evaluated independently with the formula of Pedrero 2010.
    for (eps, start) in [
        (1.2, 0.367_697_578_150_316_23),
        (1.6, 0.352_428_481_175_624_7),
        (1.9, 0.350_846_739_565_537_8),
    ] {
        assert_close(share(0.0, eps), start, ROUNDING);
        assert_close(share(eps, eps), start, ROUNDING);
        // The mate that the entering pair relieves.
        assert_close(share(1.0, eps), 1.0 - start, ROUNDING);
        assert_eq!(share(0.5 * eps, eps), 1.0);
    }
}

#[test]
fn the_trapezoid_passes_through_its_corners() {
    let share = |xi| LoadSharing::Trapezoid.share(xi, 1.6).unwrap();
    for (xi, expected) in [
        (0.0, 1.0 / 3.0),
        (0.3, 0.5),
        (0.6 - 1e-9, 2.0 / 3.0),
        (0.6 + 1e-9, 1.0),
        (0.8, 1.0),
        (1.0 + 1e-9, 2.0 / 3.0),
        (1.3, 0.5),
        (1.6, 1.0 / 3.0),
    ] {
        // 1e-9 beside a corner the share is off by half of that.
        assert!((share(xi) - expected).abs() < 1e-9, "{xi}: {}", share(xi));
    }
}

#[test]
fn equal_shares_are_one_over_the_number_of_pairs() {
    let share = |xi, eps| LoadSharing::Uniform.share(xi, eps).unwrap();
    assert_eq!([0.1, 0.5, 1.2].map(|xi| share(xi, 1.4)), [0.5, 1.0, 0.5]);
    // High contact ratio: three or two pairs.
    assert_eq!(
        [0.1, 0.7, 1.2, 2.2].map(|xi| share(xi, 2.3)),
        [1.0 / 3.0, 0.5, 1.0 / 3.0, 1.0 / 3.0]
    );
}

#[test]
fn the_rack_tooth_of_a_large_gear_has_the_thickness_of_its_tool() {
    // On a rack the tooth narrows by 2 tan α per height: one module
    // above the pitch line it is π m/2 − 2 m tan 20°.
    let (z, angle) = (1_000_000, degrees(20.0));
    let r = 0.5e-3 * f64::from(z);
    let tooth = ToothSection {
        teeth: z,
        profile_shift: 0.0,
        normal_pressure_angle: angle,
        transverse_pressure_angle: angle,
        base_radius: Length::from_si(r * angle.si().cos()),
    };
    let s = tooth_thickness(&tooth, Length::from_si(r + 1e-3)).unwrap();
    let rack = 1e-3 * (0.5 * std::f64::consts::PI - 2.0 * angle.si().tan());
    // The gear differs from its rack by terms of m/r = 2e-6.
    assert_close(s.si(), rack, 1e-5);
}

#[test]
fn few_positions_suffice_for_the_means_of_smooth_quantities() {
    let pair = table_2();
    let mean = |count| {
        let motion = |s| pair.kinematics(s, SPEED).unwrap();
        pair.mean_over_mesh(count, |place| {
            let motion = motion(place.s);
            motion.sliding.si().abs().powf(0.8) / motion.radius.si().sqrt()
        })
        .unwrap()
    };
    // A power of |V_s| as friction laws have it, with an end at C that no polynomial follows.
    assert_close(mean(32), mean(4096), 3e-4);
    // Midpoints converge too, but slower.
    let places = pair.positions(32, PositionRule::Midpoint).unwrap();
    let sum: f64 = places
        .iter()
        .map(|place| place.weight.si() * place.xi.powi(4))
        .sum();
    let exact = pair.mean_over_mesh(8, |place| place.xi.powi(4)).unwrap();
    assert_close(sum, exact, 1e-3);
}

#[test]
fn the_bearings_of_the_planets_carry_the_torque_of_the_carrier_and_their_centrifugal_force() {
    use asperity_core::quantity::{AngularSpeed, Mass, Torque};
    use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet, PlanetarySetInput};
    let set = PlanetarySet::new(&PlanetarySetInput::standard(
        [27, 24, 75],
        3,
        "1.5 mm".parse().unwrap(),
        "0 deg".parse().unwrap(),
        "20 mm".parse().unwrap(),
    ))
    .unwrap();
    let at = |speed: f64| PlanetaryOperation {
        sun_torque: Torque::from_si(120.0),
        sun_speed: AngularSpeed::from_si(speed),
        ring_speed: AngularSpeed::from_si(0.0),
        load_share_factor: 1.0,
    };
    // Without profile shift the radial forces of sun and ring cancel; the torque of the carrier is T_s (1 + z_r/z_s).
    let load = set
        .planet_load(&at(300.0), Mass::from_si(0.0))
        .unwrap()
        .si();
    let distance = 0.5 * 1.5e-3 * (27.0 + 24.0);
    let carrier = 120.0 * (1.0 + 75.0 / 27.0);
    assert!(
        (3.0 * load * distance / carrier - 1.0).abs() < 1e-12,
        "{load}"
    );
    // m a ω_c² across it.
    let mass = Mass::from_si(0.4);
    let fast = set.planet_load(&at(3000.0), mass).unwrap().si();
    let outwards = 0.4 * distance * (3000.0_f64 * 27.0 / 102.0).powi(2);
    assert!((fast / load.hypot(outwards) - 1.0).abs() < 1e-12, "{fast}");
    assert!(set.planet_load(&at(300.0), Mass::from_si(-1.0)).is_err());
}

/// Pairs known by their centre distance, with the shift of the pinion by bisection of the two specific slidings, outside of the
/// program.
const DIVIDED: [([u32; 2], f64, f64, f64, f64); 4] = [
    ([16, 24], 4.5, 0.0, 91.5, 0.309_349),
    ([25, 61], 2.0, 0.0, 87.5, 0.444_274),
    ([23, 68], 1.8, 23.4, 91.5, 0.561_540),
    ([23, 68], 1.8, 23.4, 89.9, 0.315_050),
];

#[test]
fn the_shifts_of_a_centre_distance_slide_equally_at_both_ends() {
    for (teeth, module, helix, distance, expected) in DIVIDED {
        let pair = |teeth: [u32; 2]| {
            let input = GearPairInput {
                centre_distance: Some(mm(distance)),
                ..GearPairInput::standard(teeth, mm(module), degrees(helix), mm(20.0))
            };
            GearPair::new(&input).unwrap()
        };
        let divided = pair(teeth);
        let [x1, x2] = divided.profile_shift.unwrap();
        assert!((x1 - expected).abs() < 1e-6, "{teeth:?}: {x1}");
        assert!((x1 + x2 - divided.profile_shift_sum).abs() < 1e-12);
        let path = divided.path();
        let slip = |rolling: f64, other: f64| 1.0 - other / rolling;
        let [a, e] = [path.a, path.e].map(|s| [s.si(), (path.t1t2 - s).si()]);
        let at_a = slip(divided.ratio * a[0], a[1]);
        let at_e = slip(e[1], divided.ratio * e[0]);
        assert!((at_a - at_e).abs() < 1e-9 * at_a.abs(), "{at_a} {at_e}");
        // Which gear is named first does not matter.
        let [y2, y1] = pair([teeth[1], teeth[0]]).profile_shift.unwrap();
        assert!((y1 - x1).abs() < 1e-9 && (y2 - x2).abs() < 1e-9);
    }
    let equal = GearPairInput {
        centre_distance: Some(mm(73.0)),
        ..GearPairInput::standard([24, 24], mm(3.0), degrees(0.0), mm(20.0))
    };
    let [x1, x2] = GearPair::new(&equal).unwrap().profile_shift.unwrap();
    assert!((x1 - x2).abs() < 1e-12 && x1 > 0.0);
}
