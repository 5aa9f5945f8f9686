//! The equations that a result names are those that made it.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;

use asperity_core::Profile;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::composite::combined_rq;
use asperity_roughness::form::Form;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare, prepare_with};

fn wave() -> Profile {
    let z = |i: usize| 1e-6 * (i as f64 * 0.5e-6 / 50e-6 * std::f64::consts::TAU).sin();
    Profile::new(Length::from_si(0.5e-6), (0..8000).map(z).collect()).unwrap()
}

fn tags(work: impl FnOnce()) -> BTreeSet<&'static str> {
    let used = Provenance::new();
    used.collect(work);
    used.tags()
}

#[test]
fn preparing_names_the_fit_and_the_filter_that_ran() {
    let profile = wave();
    let gaussian = tags(|| drop(prepare(&profile, &Preparation::default()).unwrap()));
    let expected = ["Form-1", "Gauss-1", "Gauss-3", "Gauss-4", "Prep-1"];
    assert_eq!(gaussian, BTreeSet::from(expected));
    let recipe = Preparation {
        form: Form::Circle,
        lambda_s: None,
        ..Preparation::default()
    };
    let filter = RoughnessFilter::RobustGaussian;
    let robust = tags(|| drop(prepare_with(&profile, &recipe, filter).unwrap()));
    let expected = ["Form-1", "Form-2", "Gauss-1", "Prep-1", "Robust-1"];
    assert_eq!(robust, BTreeSet::from(expected));
}

#[test]
fn parameters_name_the_standard_they_follow() {
    let profile = prepare(&wave(), &Preparation::default()).unwrap().profile;
    let of = |mode| {
        tags(|| drop(Parameters::from_profile(&profile, mode, Length::from_si(0.8e-3)).unwrap()))
    };
    let common = [
        "Height-1",
        "Moment-1",
        "Rk-1",
        "Rk-2",
        "Section-1",
        "Slope-1",
    ];
    let with = |tag| common.into_iter().chain([tag]).collect::<BTreeSet<_>>();
    assert_eq!(of(Mode::Iso4287), with("Height-2"));
    assert_eq!(of(Mode::Iso21920), with("Height-3"));
}

#[test]
fn a_single_formula_names_itself() {
    let rq = Length::from_si(0.3e-6);
    let found = tags(|| drop(combined_rq(rq, rq)));
    assert_eq!(found, BTreeSet::from(["P8"]));
}
