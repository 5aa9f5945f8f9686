//! Limits of filters and parameters where something vanishes.

#![allow(clippy::unwrap_used, clippy::panic)]

use asperity_core::cancel::Token;
use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_roughness::form::{self, Form};
use asperity_roughness::gaussian_filter::{Ends, mean_line, weights};
use asperity_roughness::generate::{Finish, Pits, SelfAffine, Surrogate};
use asperity_roughness::height_parameters::{Mode, height_parameters, in_sections};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::relocation::{Bounds, relocate};
use asperity_roughness::robust_filter::robust_mean_line;
use asperity_roughness::summits::asperity_radius;
use asperity_roughness::{RoughnessError, Warning};

const DX: Length = Length::from_si(1e-6);

fn flat(n: usize, z: f64) -> Profile {
    Profile::new(DX, vec![z; n]).unwrap()
}

fn rough(n: usize) -> Profile {
    let recipe = SelfAffine {
        points: n,
        spacing: DX,
        rq: Length::from_si(0.3e-6),
        hurst: 0.8,
        roll_off: Length::from_si(80e-6),
        short_cut: Length::from_si(8e-6),
        seed: 21,
    };
    recipe.generate().unwrap()
}

#[test]
fn a_flat_profile_has_no_shape_and_no_element_but_is_no_error() {
    for mode in [Mode::Iso4287, Mode::Iso21920] {
        let found = in_sections(&flat(1000, 0.0), mode, 5).unwrap();
        assert_eq!(
            (found.ra.si(), found.rq.si(), found.rz.si(), found.rdq),
            (0.0, 0.0, 0.0, 0.0)
        );
        assert_eq!(
            (found.rsk, found.rku, found.rsm, found.rc),
            (None, None, None, None)
        );
    }
    let found = rk_parameters(&[0.0; 100]).unwrap();
    assert_eq!(
        (found.rk.si(), found.rpk.si(), found.rvk.si()),
        (0.0, 0.0, 0.0)
    );
    let none = asperity_radius(&flat(1000, 0.0), Length::from_si(5e-6));
    assert!(
        matches!(none, Err(RoughnessError::NoSummit { .. })),
        "{none:?}"
    );
}

#[test]
fn a_constant_height_is_all_mean_line() {
    for ends in [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect] {
        let line = mean_line(&flat(700, 0.1), Length::from_si(80e-6), ends).unwrap();
        assert!(line.iter().all(|w| (w - 0.1).abs() < 1e-16), "{ends:?}");
    }
}

#[test]
fn without_form_and_filters_a_profile_stays_as_it_is() {
    let profile = rough(500);
    let nothing = Preparation {
        form: Form::None,
        lambda_s: None,
        lambda_c: None,
        ends: Ends::Cut,
    };
    let prepared = prepare(&profile, &nothing).unwrap();
    assert_eq!((prepared.profile, prepared.first_index), (profile, 0));
}

#[test]
fn a_cutoff_of_one_spacing_hardly_filters_and_a_shorter_one_is_refused() {
    let profile = rough(500);
    let line = mean_line(&profile, DX, Ends::Reflect).unwrap();
    // w₀ = 1/(1 + 2 e^(−π/α²)) = 1 − 1.3e-6.
    for (w, z) in line.iter().zip(profile.heights()) {
        assert!((w - z).abs() < 1e-5 * 0.3e-6 * 10.0);
    }
    assert!(mean_line(&profile, DX * 0.5, Ends::Cut).is_err());
    assert!(weights(Length::from_si(f64::NAN), DX).is_err());
    assert!(weights(Length::from_si(1e9), Length::from_si(1e-12)).is_err());
}

#[test]
fn a_trace_too_short_for_its_cutoff_is_refused_with_the_length_needed() {
    let recipe = Preparation {
        lambda_c: Some(Length::from_si(0.8e-3)),
        ..Preparation::default()
    };
    let prepared = prepare(&rough(1500), &recipe);
    match prepared {
        Err(RoughnessError::TooShort { needed, .. }) => assert_eq!(needed, Length::from_si(1.6e-3)),
        other => panic!("{other:?}"),
    }
    let crossed = Preparation {
        lambda_s: Some(Length::from_si(0.3e-3)),
        lambda_c: Some(Length::from_si(0.25e-3)),
        ..Preparation::default()
    };
    let refused = prepare(&rough(1500), &crossed).unwrap_err().to_string();
    assert!(
        refused.contains("shorter than the cut-off lambda_c"),
        "{refused}"
    );
    assert!(height_parameters(&rough(500), Mode::Iso4287, Length::from_si(0.8e-3)).is_err());
    assert!(in_sections(&rough(30), Mode::Iso4287, 5).is_err());
    assert!(rk_parameters(&[1.0; 9]).is_err());
    assert!(rk_parameters(&[f64::NAN; 20]).is_err());
    assert!(form::fit(&[1.0, 2.0], 2).is_err());
}

#[test]
fn a_circle_fit_of_a_straight_or_flat_trace_is_the_line_fit() {
    for slope in [0.0, 1e-3] {
        let heights = (0..500).map(|i| slope * 1e-6 * f64::from(i)).collect();
        let line = Profile::new(DX, heights).unwrap();
        let left = form::remove(&line, Form::Circle).unwrap();
        assert!(left.heights().iter().all(|z| z.abs() < 1e-18), "{slope}");
    }
}

#[test]
fn no_pits_do_no_damage() {
    let profile = rough(500);
    let none = Pits {
        count: 0,
        width: Length::from_si(20e-6),
        depth: Length::from_si(5e-6),
        seed: 1,
    };
    assert_eq!(none.add_to(&profile).unwrap(), profile);
}

#[test]
fn recipes_without_a_profile_are_refused() {
    let recipe = SelfAffine {
        points: 1000,
        spacing: DX,
        rq: Length::from_si(0.3e-6),
        hurst: 0.8,
        roll_off: Length::from_si(80e-6),
        short_cut: Length::from_si(8e-6),
        seed: 0,
    };
    assert!(recipe.generate().is_ok());
    for bad in [
        SelfAffine {
            points: 0,
            ..recipe
        },
        SelfAffine {
            points: usize::MAX,
            ..recipe
        },
        SelfAffine {
            hurst: 1.0,
            ..recipe
        },
        SelfAffine {
            rq: Length::from_si(f64::NAN),
            ..recipe
        },
        SelfAffine {
            short_cut: DX,
            ..recipe
        },
        SelfAffine {
            short_cut: Length::from_si(2e-3),
            ..recipe
        },
        SelfAffine {
            spacing: Length::from_si(0.0),
            ..recipe
        },
    ] {
        assert!(bad.generate().is_err(), "{bad:?}");
    }
}

#[test]
fn no_section_at_all_is_refused() {
    let profile = rough(500);
    for mode in [Mode::Iso4287, Mode::Iso21920] {
        let refused = in_sections(&profile, mode, 0);
        assert!(matches!(refused, Err(RoughnessError::Domain(_))));
        assert!(in_sections(&profile, mode, 1).is_ok());
    }
}

#[test]
fn a_groove_is_warned_of_where_it_lies_and_a_finish_is_not() {
    let dominates = |profile: &Profile| {
        let prepared = prepare(profile, &Preparation::default()).unwrap();
        let is = |warning: &Warning| matches!(warning, Warning::SectionsDominate { .. });
        prepared.warnings.into_iter().find(is)
    };
    let surrogate = |finish: Finish, number: usize| Surrogate {
        finish,
        number: [number, 200],
        body: 0,
        length: Length::from_si(5e-3),
        spacing: Length::from_si(0.5e-6),
        lambda_s: None,
        lambda_c: None,
    };
    let ground = |number: usize| surrogate(Finish::Ground, number).generate().unwrap().0;
    // One in a thousand may exceed the bound.
    let warned = (0..200).filter(|number| dominates(&ground(*number)).is_some());
    assert!(warned.count() <= 1);
    let finish = surrogate(Finish::Superfinished, 0).generate().unwrap().0;
    let height = finish
        .heights()
        .iter()
        .fold(0.0_f64, |most, z| most.max(z.abs()));
    // A groove from 3.6 to 3.7 mm.
    let groove = |i: usize| (1.0 - ((0.5 * i as f64 - 3650.0) / 50.0).powi(2)).max(0.0);
    let grooved = finish.heights().iter().enumerate();
    let grooved = grooved
        .map(|(i, z)| z - 20.0 * height * groove(i))
        .collect();
    let grooved = Profile::new(finish.spacing(), grooved).unwrap();
    let found = dominates(&grooved).unwrap();
    let turned = dominates(&grooved.mirrored()).unwrap();
    let turned = turned.on_trace(true, grooved.length(), Length::from_si(1e-3));
    for (warning, start) in [(&found, 0.0), (&turned, 1e-3)] {
        let Warning::SectionsDominate {
            from,
            to,
            at,
            span,
            sound,
            ..
        } = warning
        else {
            unreachable!()
        };
        let [from, to, at] = [from, to, at].map(|x| x.si() - start);
        assert!(
            from < 3.6e-3 && to > 3.7e-3 && to - from < 0.8e-3,
            "{warning}"
        );
        assert!((3.6e-3..3.7e-3).contains(&at), "{warning}");
        assert!((span.si() / height - 20.0).abs() < 3.0, "{warning}");
        assert_eq!(sound.map(|x| x.si() - start), [0.0, from]);
    }
}

#[test]
fn cancelled_work_on_a_trace_ends() {
    let (token, trace) = (Token::new(), rough(600));
    token.cancel();
    let line = token.run(|| robust_mean_line(&trace, Length::from_si(0.25e-3)));
    assert!(matches!(line, Err(RoughnessError::Cancelled(_))));
    let relocated = token.run(|| relocate(&trace, &trace, Bounds::default()));
    assert_eq!(relocated.unwrap_err().code(), Code::E502);
}
