//! Traces generated like measured ones, against traces of the same surface that were left out of the fit.
#![allow(clippy::unwrap_used)]

use asperity_core::Profile;
use asperity_core::numerics::standard_normal_below;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::autocorrelation::lengths;
use asperity_roughness::generate::{Fitted, Ground, SelfAffine, lower_envelope};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::summits::summit_statistics;

/// Of 3 mm, with a parent of a round number of points.
const POINTS: usize = 6000;
const DX: Length = Length::from_si(0.5e-6);
const LAMBDA_C: Length = Length::from_si(0.25e-3);
const LAMBDA_S: Length = Length::from_si(2.5e-6);
const NAMES: [&str; 20] = [
    "Ra",
    "Rq",
    "Rz",
    "Rp",
    "Rv",
    "Rt",
    "Rz1max",
    "Rsk",
    "Rku",
    "RSm",
    "Rc",
    "Rdq",
    "Rk",
    "Rpk",
    "Rvk",
    "Mr1",
    "Mr2",
    "m4",
    "length of the autocorrelation",
    "curvature of the summits",
];

fn parameters(trace: &Profile) -> [f64; NAMES.len()] {
    let recipe = Preparation {
        lambda_c: Some(LAMBDA_C),
        lambda_s: Some(LAMBDA_S),
        ..Preparation::default()
    };
    let rough = prepare(trace, &recipe).unwrap().profile;
    let found = Parameters::of(&rough, Mode::Iso4287, LAMBDA_C).unwrap();
    let (h, m) = (&found.heights, &found.material);
    let summits = summit_statistics(&rough, LAMBDA_S).unwrap();
    [
        h.ra.si(),
        h.rq.si(),
        h.rz.si(),
        h.rp.si(),
        h.rv.si(),
        h.rt.si(),
        h.rz1max.si(),
        h.rsk.unwrap(),
        h.rku.unwrap(),
        h.rsm.unwrap().si(),
        h.rc.unwrap().si(),
        h.rdq,
        m.rk.si(),
        m.rpk.si(),
        m.rvk.si(),
        m.mr1,
        m.mr2,
        found.spectral.m4,
        lengths(&rough).unwrap().to_one_fifth.unwrap().si(),
        summits.mean_curvature,
    ]
}

/// Two-sided p of the rank-sum test of Wilcoxon, Mann and Whitney (normal approximation with continuity correction).
pub fn rank_sum(a: &[f64], b: &[f64]) -> f64 {
    let (n, m) = (a.len() as f64, b.len() as f64);
    let pairs = a.iter().flat_map(|x| b.iter().map(move |y| (x, y)));
    let u: f64 = pairs
        .map(|(x, y)| {
            if x > y {
                1.0
            } else if x == y {
                0.5
            } else {
                0.0
            }
        })
        .sum();
    let deviation = (n * m * (n + m + 1.0) / 12.0).sqrt();
    let z = ((u - 0.5 * n * m).abs() - 0.5).max(0.0) / deviation;
    2.0 * standard_normal_below(-z)
}

/// The parameters of ten seeds like `fitted` that differ from those of `left_out` with p up to 0.01.
fn different(fitted: &[Profile], left_out: &[Profile]) -> Vec<String> {
    let mut recipe = Fitted::to(&fitted[0], &fitted[1..], 0).unwrap();
    let made: Vec<_> = (1..=10)
        .map(|seed| {
            recipe.seed = seed;
            parameters(&recipe.generate().unwrap().profile)
        })
        .collect();
    let kept: Vec<_> = left_out.iter().map(parameters).collect();
    let column = |rows: &[[f64; 20]], k: usize| rows.iter().map(|row| row[k]).collect::<Vec<_>>();
    let p = |k: usize| rank_sum(&column(&made, k), &column(&kept, k));
    let mean = |rows: &[[f64; 20]], k| column(rows, k).iter().sum::<f64>() / rows.len() as f64;
    (0..NAMES.len())
        .map(|k| (k, p(k)))
        .filter(|(_, p)| *p <= 0.01)
        .map(|(k, p)| {
            let ratio = mean(&made, k) / mean(&kept, k);
            format!("{}: p {p:.4}, ratio of the means {ratio:.3}", NAMES[k])
        })
        .collect()
}

/// Points of a long profile from which all traces of a surface are cut.
const ALL: usize = 12 * POINTS;

fn affine(rq: f64, roll_off: f64, seed: u64) -> Profile {
    let recipe = SelfAffine {
        points: ALL,
        spacing: DX,
        rq: Length::from_si(rq),
        hurst: 0.8,
        roll_off: Length::from_si(roll_off),
        short_cut: Length::from_si(2e-6),
        seed,
    };
    recipe.generate().unwrap()
}

/// Grooves of grits on a self-affine background: ridges higher than the dales are deep.
fn ground() -> Profile {
    let grooves = Ground {
        points: ALL,
        spacing: DX,
        rq: Length::from_si(0.2e-6),
        grit_spacing: Length::from_si(12e-6),
        grit_radius: Length::from_si(60e-6),
        grit_protrusion: Length::from_si(0.5e-6),
        seed: 1,
    };
    let grooves = grooves.generate().unwrap();
    let background = affine(0.2e-6, 80e-6, 2);
    let both = grooves.heights().iter().zip(background.heights());
    Profile::new(DX, both.map(|(a, b)| a + b).collect()).unwrap()
}

/// The lower envelope of a coarse and a fine process: plateaus with dales.
fn honed() -> Profile {
    let plateaus = affine(0.05e-6, 30e-6, 3);
    let dales = affine(0.4e-6, 60e-6, 4);
    let dales: Vec<f64> = dales.heights().iter().map(|z| z + 0.4e-6).collect();
    lower_envelope(&plateaus, &Profile::new(DX, dales).unwrap()).unwrap()
}

fn traces(surface: &Profile) -> [Vec<Profile>; 2] {
    let cut = |first: usize| {
        let pieces = surface.heights().chunks(POINTS).skip(first).step_by(2);
        let profile = |piece: &[f64]| Profile::new(DX, piece.to_vec()).unwrap();
        pieces.map(profile).collect()
    };
    [cut(0), cut(1)]
}

#[test]
fn eighteen_of_twenty_parameters_are_those_of_traces_left_out() {
    let surfaces = [
        ("ground", ground()),
        ("self-affine", affine(0.3e-6, 80e-6, 5)),
    ];
    for (name, surface) in surfaces {
        let [fitted, left_out] = traces(&surface);
        let off = different(&fitted, &left_out);
        assert!(off.len() <= 2, "{name}: {off:?}");
    }
}

/// The phases of dales cut into a plateau are lost: what remains is what the heights alone decide.
#[test]
fn heights_of_a_honed_surface_are_kept() {
    let [fitted, left_out] = traces(&honed());
    let off = different(&fitted, &left_out).join("; ");
    for name in ["Ra", "Rq", "Rt", "Rk", "Rpk", "Rvk", "Mr1", "Mr2"] {
        assert!(!off.contains(&format!("{name}: p")), "{off}");
    }
}
