//! Parameters by which generated traces are compared with measured ones.

use asperity_core::Profile;
use asperity_core::numerics::standard_normal_below;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::autocorrelation::lengths;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::summits::summit_statistics;

const LAMBDA_C: Length = Length::from_si(0.25e-3);
const LAMBDA_S: Length = Length::from_si(2.5e-6);
/// Names of the parameters.
pub const NAMES: [&str; 20] = [
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

/// The parameters of a trace.
pub fn parameters(trace: &Profile) -> [f64; NAMES.len()] {
    let recipe = Preparation {
        lambda_c: Some(LAMBDA_C),
        lambda_s: Some(LAMBDA_S),
        ..Preparation::default()
    };
    let rough = prepare(trace, &recipe).unwrap().profile;
    let found = Parameters::from_profile(&rough, Mode::Iso4287, LAMBDA_C).unwrap();
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

/// Numbers of the parameters of two groups of traces that differ with p up to 0.01.
pub fn different(one: &[[f64; NAMES.len()]], other: &[[f64; NAMES.len()]]) -> Vec<usize> {
    let column = |rows: &[[f64; NAMES.len()]], k: usize| -> Vec<f64> {
        rows.iter().map(|row| row[k]).collect()
    };
    let differs = |k: &usize| rank_sum(&column(one, *k), &column(other, *k)) <= 0.01;
    (0..NAMES.len()).filter(differs).collect()
}
