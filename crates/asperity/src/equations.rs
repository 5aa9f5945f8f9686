//! Every equation of the model: with those of the crates above, the table behind `docs/EQUATIONS.md`.

use asperity_core::{Equation, Reference};

/// Every equation of the model, in order.
pub fn all() -> Vec<&'static Equation> {
    let equations = asperity_core::equations()
        .chain(asperity_oil::EQUATIONS)
        .chain(asperity_profile_io::equations::EQUATIONS)
        .chain(asperity_roughness::equations::EQUATIONS)
        .chain(asperity_gear::equations::EQUATIONS)
        .chain(asperity_contact::equations::equations())
        .chain(asperity_ehl_regime::equations::EQUATIONS)
        .chain(asperity_ehl::equations::EQUATIONS)
        .chain(asperity_tribo_friction::equations::EQUATIONS)
        .chain(asperity_ns_film::equations::EQUATIONS)
        .chain(asperity_efficiency::equations::EQUATIONS)
        .chain(crate::load_share::equations::EQUATIONS)
        .chain(crate::band::equations::EQUATIONS)
        .chain(crate::records::equations::EQUATIONS);
    in_order(equations)
}

/// Those of the 2022 paper first and by number, the others by tag.
pub fn in_order(equations: impl IntoIterator<Item = &'static Equation>) -> Vec<&'static Equation> {
    let mut equations: Vec<&'static Equation> = equations.into_iter().collect();
    equations
        .sort_by_key(|equation| (paper_number(equation.tag).unwrap_or(u32::MAX), equation.tag));
    equations
}

/// Number of an equation of the paper: 7 for `P7`, none for `Hertz-1`.
fn paper_number(tag: &str) -> Option<u32> {
    tag.strip_prefix('P')?.parse().ok()
}

/// The equation of the model with this tag, whatever its case.
///
/// ```
/// assert_eq!(asperity::equations::find("p7").map(|e| e.tag), Some("P7"));
/// ```
pub fn find(tag: &str) -> Option<&'static Equation> {
    with_tag(all(), tag)
}

/// The one of `equations` with this tag, whatever its case.
pub fn with_tag(
    equations: impl IntoIterator<Item = &'static Equation>,
    tag: &str,
) -> Option<&'static Equation> {
    let is_it = |equation: &&Equation| equation.tag.eq_ignore_ascii_case(tag.trim());
    equations.into_iter().find(is_it)
}

/// The sources of `equations`, each once, by key.
pub fn bibliography(equations: &[&'static Equation]) -> Vec<Reference> {
    let mut references: Vec<Reference> = equations
        .iter()
        .flat_map(|equation| equation.references)
        .copied()
        .collect();
    references.sort_by_key(|reference| reference.key);
    references.dedup_by_key(|reference| reference.key);
    references
}

/// `docs/EQUATIONS.md`.
pub fn markdown(equations: &[&'static Equation]) -> String {
    let mut page = String::from(
        "# Equations\n\n\
        The file of each equation, its formula as used, and the test that verifies it. Tags `P1` to `P37` are the\n\
        numbers in the 2022 paper; the others come from the sources named. This page is written by\n\
        `asperity equations --markdown`; `asperity equations P7` prints one row.\n\n\
        | tag | gives | formula as used | file | test | sources |\n|---|---|---|---|---|---|\n",
    );
    for equation in equations {
        let keys: Vec<_> = equation.references.iter().map(|r| r.key).collect();
        page.push_str(&format!(
            "| {} | {} | {} | [{}](../{}) | `{}` | {} |\n",
            equation.tag,
            cell(equation.title),
            cell(equation.formula),
            equation.file,
            equation.file,
            equation.test,
            if keys.is_empty() {
                "own definition".to_owned()
            } else {
                keys.join(", ")
            },
        ));
    }
    page.push_str("\n## Misprints of the paper\n\n| equation | printed, and what is used instead |\n|---|---|\n");
    for equation in equations {
        if let Some(misprint) = equation.misprint {
            page.push_str(&format!("| {} | {} |\n", equation.tag, cell(misprint)));
        }
    }
    page.push_str("\n## Sources\n\n");
    for reference in bibliography(equations) {
        page.push_str(&format!("- `{}` {}\n", reference.key, reference.text));
    }
    page
}

/// Text as a cell of a Markdown table.
fn cell(text: &str) -> String {
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .replace('|', "\\|")
}
