//! Load-sharing laws compared with the transient solution, the reference.

use asperity::lubrication::ShareComparison;

/// Table of the laws.
pub fn text(comparison: &ShareComparison) -> String {
    let or_dash = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| String::from("-"), |value| format!("{value:.digits$}"))
    };
    let mut text = format!(
        "  laws over {} windows of the same traces; reference, the transient solution: mean of the loads below 20 and 50 nm,\n  \
         friction with heat\n  \
         {:<18} {:>11} {:>9} {:>12} {:>9}\n  {:<18} {:>11.4} {:>9} {:>12.4} {:>9}\n",
        comparison.windows,
        "law",
        "solid share",
        "off by",
        "mean gap um",
        "friction",
        "reference",
        comparison.reference_share,
        "",
        comparison.reference_mean_film_um,
        or_dash(comparison.reference_friction, 5),
    );
    for law in &comparison.laws {
        let off = law
            .minus_reference
            .map_or_else(String::new, |off| format!("{off:+.4}"));
        text.push_str(&format!(
            "  {:<18} {:>11} {off:>9} {:>12} {:>9}\n",
            law.law,
            or_dash(law.solid_share, 4),
            or_dash(law.mean_gap_um, 4),
            or_dash(law.friction, 5),
        ));
    }
    text
}
