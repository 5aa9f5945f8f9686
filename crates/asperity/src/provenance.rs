//! Which equations a result rests on, and their sources.

use asperity_core::{Equation, Reference};
use asperity_ehl_regime::{FilmLaw, LoadShareLaw, ThermalLaw};
use asperity_ns_film::FluidModel;
use asperity_tribo_friction::FrictionLaw;

use crate::case::{Case, Formulation};
use crate::equations;
use crate::result::EquationUse;

/// Equations of every run.
const ALWAYS: &[&str] = &[
    "E-star",
    "Pair-1",
    "Path-1",
    "Kinematics-1",
    "Force-1",
    "Load-1",
    "Mean-1",
    "Hertz-1",
    "Hertz-2",
    "P8",
    "P9",
    "P11",
    "P12",
    "P15",
    "P16",
    "P17",
    "P18",
    "P20",
    "Loss-1",
    "Plausible-1",
];
/// Equations of the rough contact.
const ROUGH_CONTACT: &[&str] = &[
    "P1",
    "P2",
    "P3",
    "P4",
    "Plastic-1",
    "Plastic-2",
    "Share-1",
    "Share-2",
    "Subsurface-3",
    "Mises-1",
];

/// Tags of the equations that `case` uses; `touched` when any position was a rough contact.
fn tags(case: &Case, touched: bool) -> Vec<&'static str> {
    let model = &case.model;
    let mut tags = ALWAYS.to_vec();
    if touched {
        tags.extend(ROUGH_CONTACT);
        tags.push("P21");
    }
    tags.extend(match model.film {
        FilmLaw::DowsonToyoda => &["Dowson-Toyoda", "Dowson-Higginson"][..],
        FilmLaw::Moes => &["Moes", "Dowson-Higginson"],
        FilmLaw::ErtelGrubin => &["Ertel-Grubin", "Dowson-Higginson"],
        FilmLaw::HamrockDowson | FilmLaw::HamrockDowsonLine => &["P13", "P14"],
    });
    tags.extend(match model.thermal {
        ThermalLaw::Gupta => &["Thermal-load", "P10"][..],
        ThermalLaw::MurchWilson => &["Thermal-load", "Murch-Wilson"],
        ThermalLaw::None => &[],
    });
    tags.extend(match model.friction {
        FrictionLaw::Xu => &["P7"][..],
        FrictionLaw::BenedictKelley => &["Benedict-Kelley"],
        FrictionLaw::Iso14179Part1 => &["ISO-14179-1"],
        FrictionLaw::Iso14179Part2 => &["Schlenk"],
        FrictionLaw::Matsumoto => &["Matsumoto", "Matsumoto-share", "Eyring"],
        FrictionLaw::Doleschel => &["Doleschel", "Doleschel-share", "Eyring"],
        FrictionLaw::Eyring => &["Eyring"],
        FrictionLaw::Constant => &[],
    });
    match case.formulation {
        Formulation::Corrected => tags.push(match model.load_share {
            LoadShareLaw::LambdaStar => "Film-share",
            LoadShareLaw::ZhuHu => "Zhu-Hu",
        }),
        Formulation::Paper => {
            tags.push("P19");
            if touched && model.fluid_pressure == FluidModel::Paper {
                tags.extend(["P23", "P29", "P30", "P31"]);
            }
        }
    }
    tags
}

/// The equations used, with the publications they come from.
pub(crate) fn used(case: &Case, touched: bool) -> (Vec<EquationUse>, Vec<Reference>) {
    let found: Vec<&'static Equation> = tags(case, touched)
        .into_iter()
        .filter_map(equations::find)
        .collect();
    let uses = found
        .iter()
        .map(|equation| EquationUse {
            tag: equation.tag.into(),
            title: equation.title.into(),
            references: equation.references.iter().map(|r| r.key.into()).collect(),
        })
        .collect();
    (uses, equations::bibliography(&found))
}

#[cfg(test)]
mod tests {
    use crate::equations;

    #[test]
    fn every_tag_named_here_is_that_of_an_equation() {
        // Tags are the quoted words of this file before its tests.
        let source = include_str!("provenance.rs");
        let code = source.split("#[cfg(test)]").next().unwrap();
        let tags: Vec<&str> = code.split('"').skip(1).step_by(2).collect();
        assert!(tags.len() > 40, "{} tags", tags.len());
        for tag in tags {
            assert!(equations::find(tag).is_some(), "no equation {tag}");
        }
    }
}
