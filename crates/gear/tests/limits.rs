//! Refusals with their reasons, and limits.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use asperity_core::quantity::{Angle, AngularSpeed, Length, Torque};
use asperity_gear::{GearError, GearPair, GearPairInput, LoadSharing, PositionRule};

fn mm(value: f64) -> Length {
    Length::from_si(value * 1e-3)
}

fn spur() -> GearPairInput {
    GearPairInput::standard([25, 40], mm(3.0), Angle::from_si(0.0), mm(30.0))
}

fn helical() -> GearPairInput {
    GearPairInput {
        helix: Angle::from_si(25f64.to_radians()),
        ..spur()
    }
}

fn refusal(input: &GearPairInput) -> GearError {
    GearPair::new(input).unwrap_err()
}

#[track_caller]
fn assert_says(error: &GearError, text: &str) {
    assert!(error.to_string().contains(text), "{error}");
}

#[test]
fn a_tip_past_the_mating_involute_is_interference() {
    // A wheel of full depth undercuts a pinion of 8 teeth.
    let few = GearPairInput {
        teeth: [8, 60],
        ..spur()
    };
    assert_says(&refusal(&few), "the tip of the wheel reaches ");
    assert_says(&refusal(&few.swapped()), "the tip of the pinion reaches ");
}

#[test]
fn a_spur_pair_with_a_gap_between_the_pairs_is_refused() {
    let short = GearPairInput {
        addendum: 0.5,
        ..spur()
    };
    assert_says(
        &refusal(&short),
        "a spur pair needs a transverse contact ratio above 1, this one has 0.",
    );
    // The same teeth work when an overlap makes up for it.
    let wide = GearPairInput {
        addendum: 0.5,
        ..helical()
    };
    let pair = GearPair::new(&wide).unwrap();
    assert!(pair.path().eps_alpha < 1.0 && pair.path().eps_gamma > 1.0);
    let narrow = GearPairInput {
        overlap: Some(mm(0.5)),
        ..wide
    };
    assert_says(
        &refusal(&narrow),
        "a helical pair needs a total contact ratio above 1",
    );
}

#[test]
fn pointed_teeth_are_refused() {
    let pointed = GearPairInput {
        profile_shift: Some([1.4, 0.0]),
        addendum: 1.1,
        ..spur()
    };
    let negative = "the tooth of the pinion is pointed: its thickness at the tip would be -";
    assert_says(&refusal(&pointed), negative);
    // With the sum of the shifts alone, only what no division could save is refused.
    let both = GearPairInput {
        profile_shift: None,
        centre_distance: Some(mm(99.0)),
        tip_radius: Some([mm(37.5 + 7.0), mm(60.0 + 7.0)]),
        ..spur()
    };
    assert_says(
        &refusal(&both),
        "however the profile shifts are divided, a tooth is pointed: the tip half-angles times the tooth numbers sum to -",
    );
}

#[test]
fn tips_that_do_not_reach_each_other_are_refused() {
    let apart = GearPairInput {
        profile_shift: None,
        centre_distance: Some(mm(105.0)),
        tip_radius: Some([mm(40.5), mm(63.0)]),
        ..spur()
    };
    assert_says(&refusal(&apart), "the gears do not touch");
}

#[test]
fn contradicting_givens_are_refused() {
    let shifted = GearPairInput {
        profile_shift: Some([0.3, 0.1]),
        ..spur()
    };
    let right = GearPair::new(&shifted).unwrap().centre_distance;
    let given = |centre: Length| GearPairInput {
        centre_distance: Some(centre),
        ..shifted.clone()
    };
    // 0.01 of the module of 3 mm is accepted, and the given distance counts.
    let rounded = right + mm(0.029);
    assert_eq!(
        GearPair::new(&given(rounded)).unwrap().centre_distance,
        rounded
    );
    let wrong = refusal(&given(right + mm(0.031)));
    assert_says(&wrong, " contradicts the profile shifts, which give ");
    let overlapping = refusal(&given(mm(90.0)));
    assert_says(
        &overlapping,
        " must be larger than the sum of the base radii",
    );
}

#[test]
fn the_tips_of_a_ring_do_not_follow_from_the_centre_distance() {
    let input = GearPairInput {
        centre_distance: Some(mm(39.0)),
        ..GearPairInput::standard([24, 75], mm(1.5), Angle::from_si(0.0), mm(20.0))
    };
    let refused = GearPair::internal(&input).unwrap_err();
    assert_says(
        &refused,
        "the centre distance gives only the sum of the shifts, ",
    );
    assert!(
        refused
            .to_string()
            .contains("state both shifts with this sum")
    );
}

#[test]
fn a_positive_shift_brings_the_teeth_of_a_ring_towards_its_axis() {
    let tip = |shift: f64| {
        let standard = GearPairInput::standard([24, 75], mm(1.5), Angle::from_si(0.0), mm(20.0));
        let input = GearPairInput {
            profile_shift: Some([0.1, shift]),
            ..standard
        };
        GearPair::internal(&input).unwrap().tip_radius[1].si().abs()
    };
    assert!((tip(0.0) - tip(0.2) - 0.2 * 1.5e-3).abs() < 1e-9);
}

#[test]
fn nonsense_numbers_are_named() {
    let nan = Length::from_si(f64::NAN);
    let bad = [
        GearPairInput {
            teeth: [0, 40],
            ..spur()
        },
        GearPairInput {
            module: mm(0.0),
            ..spur()
        },
        GearPairInput {
            module: nan,
            ..spur()
        },
        GearPairInput {
            helix: Angle::from_si(1.4),
            ..spur()
        },
        GearPairInput {
            pressure_angle: Angle::from_si(0.0),
            ..spur()
        },
        GearPairInput {
            pressure_angle: Angle::from_si(0.9),
            ..spur()
        },
        GearPairInput {
            face_width: [mm(30.0), mm(-1.0)],
            ..spur()
        },
        GearPairInput {
            overlap: Some(mm(31.0)),
            ..spur()
        },
        GearPairInput {
            profile_shift: Some([f64::INFINITY, 0.0]),
            ..spur()
        },
        GearPairInput {
            profile_shift: Some([-30.0, 0.0]),
            ..spur()
        },
        GearPairInput {
            centre_distance: Some(nan),
            ..spur()
        },
        GearPairInput {
            tip_radius: Some([mm(41.0), nan]),
            ..spur()
        },
        GearPairInput {
            tip_radius: Some([mm(20.0), mm(63.0)]),
            ..spur()
        },
        GearPairInput {
            addendum: f64::NAN,
            ..spur()
        },
        GearPairInput {
            face_width: [Length::from_si(1e6); 2],
            ..helical()
        },
    ];
    for input in bad {
        let error = refusal(&input);
        assert!(matches!(error, GearError::Domain(_)), "{error}");
    }
}

#[test]
fn the_overlap_of_the_faces_carries_the_load() {
    let stepped = GearPairInput {
        face_width: [mm(30.0), mm(24.0)],
        ..spur()
    };
    assert_eq!(GearPair::new(&stepped).unwrap().face_width, mm(24.0));
    let shifted = GearPairInput {
        overlap: Some(mm(20.0)),
        ..stepped
    };
    assert_eq!(GearPair::new(&shifted).unwrap().face_width, mm(20.0));
}

#[test]
fn questions_off_the_path_have_no_answer() {
    let pair = GearPair::new(&spur()).unwrap();
    let path = *pair.path();
    let torque = Torque::from_si(100.0);
    let before = path.a - mm(0.001);
    let law = LoadSharing::Uniform;
    assert_says(
        &pair.line_load(before, torque, &law).unwrap_err(),
        " is off the path of contact, which goes from ",
    );
    assert_says(
        &pair.single_position(before).unwrap_err(),
        " is off the path of contact, which goes from ",
    );
    assert!(
        pair.line_load(path.a, torque, &law).is_ok()
            && pair.line_load(path.e, torque, &law).is_ok()
    );
    let speed = AngularSpeed::from_si(100.0);
    assert!(pair.kinematics(path.t1t2 + mm(0.001), speed).is_err());
    assert!(pair.kinematics(Length::from_si(f64::NAN), speed).is_err());
    assert!(pair.kinematics(path.c, AngularSpeed::from_si(0.0)).is_err());
    assert!(pair.forces(Torque::from_si(f64::NAN)).is_err());
    assert!(pair.contact_length(f64::NAN).is_err());
    assert_says(
        &law.share(1.7, 1.6).unwrap_err(),
        "xi = 1.7 is off the path of contact, which goes from 0 to 1.6",
    );
    assert!(law.weight(0.1, f64::NAN).is_err());
}

#[test]
fn sharing_laws_keep_to_the_pairs_they_were_made_for() {
    let spur = GearPair::new(&spur()).unwrap();
    let helical = GearPair::new(&helical()).unwrap();
    let trapezoid = LoadSharing::Trapezoid;
    assert!(spur.loss_factors(&trapezoid).is_ok());
    assert!(matches!(
        helical.loss_factors(&trapezoid),
        Err(GearError::SpurLawOnHelical { .. })
    ));
    for law in [LoadSharing::Trapezoid, LoadSharing::MinPotential] {
        assert_says(
            &law.weight(0.5, 2.1).unwrap_err(),
            " holds for transverse contact ratios from ",
        );
        assert_says(
            &law.weight(0.5, 1.0).unwrap_err(),
            " holds for transverse contact ratios from ",
        );
    }
}

#[test]
fn tables_that_cannot_be_read_name_their_row() {
    let cases: [(&[(f64, f64)], usize); 8] = [
        (&[], 0),
        (&[(0.0, 1.0)], 0),
        (&[(0.1, 1.0), (1.0, 1.0)], 0),
        (&[(0.0, 1.0), (0.9, 1.0)], 1),
        (&[(0.0, 1.0), (0.5, -1.0), (1.0, 1.0)], 1),
        (&[(0.0, 1.0), (0.5, 1.0), (0.5, 1.0), (1.0, 1.0)], 2),
        (&[(0.0, 1.0), (f64::NAN, 1.0), (1.0, 1.0)], 1),
        (&[(0.0, 0.0), (1.0, 0.0)], 1),
    ];
    for (rows, wrong) in cases {
        let error = LoadSharing::Table(rows.to_vec())
            .weight(0.5, 1.5)
            .unwrap_err();
        assert_says(&error, &format!("load sharing table, row {wrong}: "));
    }
}

#[test]
fn a_table_of_ones_is_uniform_sharing() {
    let ones = LoadSharing::Table(vec![(0.0, 1.0), (0.3, 1.0), (1.0, 1.0)]);
    for input in [spur(), helical()] {
        let pair = GearPair::new(&input).unwrap();
        let (table, uniform) = (
            pair.loss_factors(&ones),
            pair.loss_factors(&LoadSharing::Uniform),
        );
        let (table, uniform) = (table.unwrap(), uniform.unwrap());
        assert!((table.local / uniform.local - 1.0).abs() < 1e-13);
        assert!((table.local_phase_averaged / uniform.local_phase_averaged - 1.0).abs() < 1e-13);
    }
}

#[test]
fn positions_cover_every_segment_or_are_refused() {
    let pair = GearPair::new(&spur()).unwrap();
    let rule = PositionRule::GaussLegendre;
    assert_eq!(pair.positions(4, rule).unwrap().len(), 4);
    for count in [0, 3, usize::MAX] {
        let refused = pair.positions(count, rule);
        assert_says(
            &refused.unwrap_err(),
            " mesh positions were requested; this pair needs ",
        );
    }
    let path = *pair.path();
    let ends = [path.a, path.b, path.c, path.d, path.e];
    let places = pair.positions(32, rule).unwrap();
    for segment in ends.windows(2) {
        let inside = places
            .iter()
            .filter(|place| place.s > segment[0] && place.s < segment[1]);
        assert!(inside.count() > 2);
    }
    assert!(places.is_sorted_by(|one, next| one.s < next.s));
}

#[test]
fn a_helix_that_vanishes_leaves_the_geometry_of_the_spur_pair() {
    let straight = GearPair::new(&spur()).unwrap();
    let nearly = GearPair::new(&GearPairInput {
        helix: Angle::from_si(1e-7),
        ..spur()
    })
    .unwrap();
    assert!((nearly.path().eps_alpha - straight.path().eps_alpha).abs() < 1e-12);
    // Load shared at each instant goes over into equal shares; the mean line load does not.
    let at = |pair: &GearPair| {
        pair.loss_factors(&LoadSharing::Uniform)
            .unwrap()
            .local_phase_averaged
    };
    assert!((at(&nearly) / at(&straight) - 1.0).abs() < 1e-4);
    // A helix in the last digits is none.
    let none = GearPair::new(&GearPairInput {
        helix: Angle::from_si(1e-17),
        ..spur()
    })
    .unwrap();
    assert!(none.is_spur());
    assert_eq!(at(&none), at(&straight));
}

#[test]
fn the_hand_of_the_helix_does_not_matter() {
    let left = GearPairInput {
        helix: -helical().helix,
        ..helical()
    };
    assert_eq!(
        GearPair::new(&left).unwrap(),
        GearPair::new(&helical()).unwrap()
    );
}

#[test]
fn a_pitch_point_off_the_path_is_allowed() {
    // Long and short addenda: all of the path is recess.
    let input = GearPairInput {
        profile_shift: Some([1.0, -1.0]),
        addendum: 0.95,
        ..GearPairInput::standard([40, 90], mm(2.0), Angle::from_si(0.0), mm(20.0))
    };
    let pair = GearPair::new(&input).unwrap();
    assert!(pair.path().eps_2 < 0.0);
    assert_eq!(
        pair.positions(8, PositionRule::GaussLegendre)
            .unwrap()
            .len(),
        8
    );
    let local = pair.loss_factors(&LoadSharing::Uniform).unwrap().local;
    let path = pair.path();
    // Nothing changes sign, so the mean sliding is that at the load-weighted middle of the path.
    let arm = 0.5 * (path.a.si() + path.e.si()) - path.c.si();
    let hand = (1.0 + 1.0 / pair.ratio) * arm / pair.base_radius[0].si();
    assert!((local / hand - 1.0).abs() < 1e-12, "{local} {hand}");
}

#[test]
fn exchanged_gears_take_everything_of_theirs_with_them() {
    let pair = GearPairInput {
        face_width: [mm(30.0), mm(28.0)],
        profile_shift: Some([0.2, -0.1]),
        tip_radius: Some([mm(41.0), mm(63.0)]),
        ..spur()
    };
    let swapped = pair.swapped();
    assert_eq!(swapped.teeth, [40, 25]);
    assert_eq!(swapped.face_width, [mm(28.0), mm(30.0)]);
    assert_eq!(swapped.profile_shift, Some([-0.1, 0.2]));
    assert_eq!(swapped.tip_radius, Some([mm(63.0), mm(41.0)]));
    assert_eq!(swapped.swapped(), pair);
}

#[test]
fn the_points_of_the_path_have_their_letters() {
    let pair = GearPair::new(&spur()).unwrap();
    let path = pair.path();
    let [a, b, c, d, e] = path.named_points();
    assert_eq!([a.0, b.0, c.0, d.0, e.0], ["A", "B", "C", "D", "E"]);
    assert_eq!(
        [a.1, b.1, c.1, d.1, e.1],
        [path.a, path.b, path.c, path.d, path.e]
    );
    assert!(a.1 < b.1 && b.1 < c.1 && c.1 < d.1 && d.1 < e.1);
}

#[test]
fn a_tooth_of_a_ring_is_what_the_tooth_of_a_wheel_leaves_of_the_pitch() {
    let (z, x) = (75.0, 0.15);
    let input = GearPairInput {
        profile_shift: Some([0.25, x]),
        ..GearPairInput::standard([24, 75], mm(2.0), Angle::from_si(0.0), mm(20.0))
    };
    let pair = GearPair::internal(&input).unwrap();
    let [_, thickness] = pair.tip_thickness.unwrap();
    let radius = pair.tip_radius[1].si().abs();
    let involute = |cosine: f64| {
        let angle = cosine.acos();
        angle.tan() - angle
    };
    let alpha = 20f64.to_radians();
    let base = 0.5 * z * 2e-3 * alpha.cos();
    // A wheel with as many teeth and the opposite shift fills the space of the ring.
    let space = (std::f64::consts::FRAC_PI_2 + 2.0 * -x * alpha.tan()) / z + involute(alpha.cos())
        - involute(base / radius);
    let expected = 2.0 * radius * (std::f64::consts::PI / z - space);
    assert!(
        (thickness.si() / expected - 1.0).abs() < 1e-10,
        "{thickness} {expected}"
    );
}
