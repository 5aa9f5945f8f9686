//! Terms of the field that pages explain, each in one place: a page lists those that it uses.

use maud::{Markup, html};

/// Term with the words by which pages name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Term {
    /// Name.
    pub name: &'static str,
    /// Words of a page by which the term is listed, in any case, whole words only; without any the name is the word.
    words: &'static [&'static str],
    /// Meaning, as in `docs/GLOSSARY.md`.
    pub meaning: &'static str,
}

const fn term(name: &'static str, words: &'static [&'static str], meaning: &'static str) -> Term {
    Term {
        name,
        words,
        meaning,
    }
}

/// All terms, in the order of a page: mesh, contact, oil, losses, flanks, uncertainty, measurements.
pub const TERMS: &[Term] = &[
    term(
        "path of contact",
        &["path of contact", "from A to E", "% of the path"],
        "part of the line of action on which teeth are in contact, from A to E; C is the pitch point",
    ),
    term(
        "T₁",
        &[],
        "point where the line of action touches the base circle of the pinion",
    ),
    term(
        "mesh position",
        &["positions"],
        "a position on the path of contact with its weight in the mean over a mesh cycle",
    ),
    term(
        "offset",
        &["offsets"],
        "shift of the two traces against each other; each offset pairs other asperities",
    ),
    term(
        "window",
        &["windows"],
        "piece of the two traces that is in contact at one position and one offset",
    ),
    term(
        "transverse contact ratio",
        &["ε_α"],
        "ε_α, length of the path of contact in base pitches",
    ),
    term(
        "overlap ratio",
        &["ε_β"],
        "ε_β, advance of the contact over the face width in base pitches",
    ),
    term(
        "line load",
        &[],
        "force per length of contact line, normal to the flank",
    ),
    term(
        "gear loss factor",
        &["H_V"],
        "H_V, sliding loss divided by friction coefficient and input power",
    ),
    term(
        "equivalent friction",
        &["μ_eq"],
        "μ_eq, the constant friction coefficient that explains the loss with the loss factor H_V",
    ),
    term(
        "K_γ",
        &[],
        "load on the most loaded of equal meshes divided by the mean load",
    ),
    term(
        "sliding speed",
        &["V_s", "sliding"],
        "difference of the surface speeds of the flanks",
    ),
    term(
        "entrainment speed",
        &["V_e", "entrainment"],
        "mean of the surface speeds of the flanks",
    ),
    term(
        "slide-to-roll ratio",
        &["slide-to-roll", "slide-to-roll ratios"],
        "sliding speed divided by entrainment speed",
    ),
    term(
        "Hertz contact",
        &["Hertz", "p₀", "half-width", "half-widths"],
        "elastic contact of smooth flanks; its largest pressure is p₀, the half-width is half of its width",
    ),
    term(
        "asperities",
        &[],
        "high points of a rough flank that touch the other flank",
    ),
    term(
        "load share",
        &["load on asperities", "share of the load", "load share"],
        "fraction of the load that the asperities carry; in a row of path.csv, the fraction of the tooth force on one contact line",
    ),
    term(
        "mixed lubrication",
        &["mixed"],
        "asperities carry 2 % of the load or more, the film the rest",
    ),
    term(
        "film",
        &["film"],
        "oil between the flanks; as a part of the loss, its friction while the flanks slide",
    ),
    term(
        "lubricated asperities",
        &[],
        "touching asperities that still have an oil film; as a part of the loss, its friction",
    ),
    term(
        "boundary layer",
        &[],
        "adsorbed or reacted layer on the metal that separates touching asperities",
    ),
    term(
        "boundary friction",
        &[],
        "friction coefficient of asperities separated only by the boundary layer",
    ),
    term(
        "boundary share",
        &[],
        "part of the load on asperities that the boundary layer carries",
    ),
    term(
        "rolling",
        &["rolling"],
        "part of the loss that draws the oil into the contact, also without sliding",
    ),
    term(
        "inner contact",
        &["inner contacts"],
        "asperity contact that formed inside the Hertz zone, where no oil flows in; its least boundary share is β_i",
    ),
    term(
        "film parameter",
        &["Λ*", "Lambda*", "film over roughness"],
        "Λ, film thickness over composite root mean square roughness; Λ*, over the reduced height of the peaks, which touch below 1",
    ),
    term(
        "Eyring stress",
        &[],
        "shear stress above which the oil shears markedly faster than a Newtonian fluid",
    ),
    term(
        "limiting shear stress",
        &["limiting shear"],
        "maximum shear stress of the oil at a pressure",
    ),
    term(
        "pressure-viscosity coefficient",
        &["pressure-viscosity"],
        "relative increase of the viscosity with pressure",
    ),
    term(
        "thermal reduction",
        &[],
        "reduction of the film thickness by shear heating in the inlet",
    ),
    term(
        "bulk temperature",
        &["bulk temperature", "flanks at"],
        "temperature of the gear body below the flank, without flash temperature",
    ),
    term(
        "flash temperature",
        &[],
        "temperature rise of the surfaces while they pass the contact",
    ),
    term(
        "Moes numbers",
        &["Moes load", "Moes lubricant"],
        "dimensionless load and stiffening of the oil of a line contact",
    ),
    term(
        "trace",
        &["traces"],
        "points measured along a line of a flank, possibly unevenly spaced",
    ),
    term(
        "cut-off",
        &["λs", "λc"],
        "wavelength at which a filter transmits half the amplitude: λc for roughness, λs for short waves",
    ),
    term(
        "Rk, Rpk, Rvk",
        &["Rk", "Rpk", "Rvk"],
        "heights of the core, the peaks and the valleys of the material ratio curve",
    ),
    term("Rdq", &[], "root mean square slope of a profile"),
    term(
        "lay",
        &[],
        "direction of the ridges: 0 across the face width, 1 the same in all directions",
    ),
    term(
        "surrogate flank",
        &["surrogate", "surrogates"],
        "generated profile with the stated roughness values of a flank without a trace; 12 pairs of several shapes are solved",
    ),
    term(
        "running-in",
        &["run in"],
        "change of the roughness in the first load cycles by plastic deformation and wear",
    ),
    term(
        "lot",
        &["lots"],
        "flanks of one recipe, whose heights, wavelengths and peaks scatter",
    ),
    term(
        "uncertainty interval",
        &["5 to 95 %", "5 and 95 %", "90 % interval"],
        "5 to 95 % of the samples of a result",
    ),
    term(
        "sample",
        &["samples"],
        "one loss with constants, model and flanks at random within their uncertainty",
    ),
    term(
        "ln",
        &[],
        "natural logarithm; a difference of 0.05 is about 5 %",
    ),
    term(
        "sampling of the flanks",
        &[],
        "error of the loss because the traces show a small part of few teeth",
    ),
    term(
        "error of the model",
        &[],
        "error of the contact model of a run against reference solutions",
    ),
    term(
        "reference solution",
        &["reference solutions"],
        "transient solution of the mixed contact at one place, the reference of the model of a run",
    ),
    term(
        "second set of gears",
        &["second set"],
        "other gears of the same drawing and finish, whose flanks are other samples of it",
    ),
    term(
        "standard error",
        &["standard errors"],
        "standard deviation of a mean",
    ),
    term(
        "traction curve",
        &["traction curves"],
        "friction of smooth bodies with a full film over the slide-to-roll ratio; it shows the constants of the oil",
    ),
    term(
        "Stribeck curve",
        &[],
        "friction over the speed; at the lowest speeds it is the boundary friction",
    ),
    term(
        "assembly",
        &["assemblies"],
        "gears that are taken from the rig and mounted again, or other gears of the same drawing",
    ),
    term(
        "D-optimal",
        &[],
        "of all sets of points the one that leaves the smallest errors of all parameters together",
    ),
    term(
        "identified",
        &["not identified"],
        "determined by the measured points, not by the range known before",
    ),
    term(
        "prior",
        &["priors"],
        "range of a parameter that is assumed before the measurement",
    ),
    term(
        "profile likelihood",
        &[],
        "interval from fits of all other parameters at each value of this one",
    ),
    term(
        "nuisance term",
        &["nuisance terms"],
        "error of the rig that is fitted together with the parameters",
    ),
    term(
        "chi squared",
        &[],
        "sum of the squared residuals, each over its standard deviation",
    ),
    term(
        "family",
        &[],
        "oils of the same kind of base oil, whose constants are known without a test of this oil",
    ),
];

impl Term {
    /// Whether `text`, in lower case, has one of its words.
    fn is_in(&self, text: &str) -> bool {
        let name = [self.name];
        let words = name.iter().chain(self.words);
        words.map(|word| word.to_lowercase()).any(|word| {
            text.match_indices(&word).any(|(at, _)| {
                let (before, after) = (&text[..at], &text[at + word.len()..]);
                !before.ends_with(is_letter) && !after.starts_with(is_letter)
            })
        })
    }
}

/// Whether a letter continues a word; after "Λ*" and "5 to 95 %" anything else may follow.
fn is_letter(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// The terms that a page uses, of its `text` without markup.
pub(crate) fn used(text: &str) -> impl Iterator<Item = &'static Term> + use<> {
    let text = text.to_lowercase();
    TERMS.iter().filter(move |term| term.is_in(&text))
}

/// The list of `terms`.
pub(crate) fn list<'a>(terms: impl Iterator<Item = &'a Term>) -> Markup {
    html! {
        dl.terms { @for term in terms { div { dt { (term.name) } dd { (term.meaning) "." } } } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_lists_the_terms_of_its_whole_words() {
        let names = |text| used(text).map(|term| term.name).collect::<Vec<_>>();
        assert_eq!(
            names("At the Lambda* of 0.4 the Films differ; H_Vx, splay."),
            ["film parameter"]
        );
        assert_eq!(
            names("loss, in brackets 5 to 95 % (H_V 0.15)"),
            ["gear loss factor", "uncertainty interval"]
        );
        assert!(names("").is_empty());
    }

    #[test]
    fn sentences_have_at_most_25_words() {
        for term in TERMS {
            let words = term.meaning.split(' ').count();
            assert!(words <= 25, "{}: {words} words", term.name);
        }
    }
}
