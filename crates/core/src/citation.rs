//! Citation of an equation: its source, its file and its test.
//!
//! Every crate lists its equations in `equations.rs`; the orchestrator joins the lists into the
//! table `docs/EQUATIONS.md`, and a test holds table, sources and tests together.

use serde::Serialize;

/// A publication.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub struct Reference {
    /// Short key, `author_year`.
    pub key: &'static str,
    /// Authors, title, place, year, as a bibliography prints it (with DOI where there is one).
    pub text: &'static str,
}

/// One equation of the model: its tag in the sources, its formula and its test.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Equation {
    /// Tag as it stands in the doc comment between brackets: `P7`, `Hertz-1`.
    pub tag: &'static str,
    /// Quantity given, in a few words.
    pub title: &'static str,
    /// The formula in Unicode text, as used.
    pub formula: &'static str,
    /// Source file, from the root of the workspace.
    pub file: &'static str,
    /// Name of a test function that proves it.
    pub test: &'static str,
    /// Publication; none for a definition of this project.
    pub references: &'static [Reference],
    /// Misprint of the 2022 paper, and the form used instead.
    pub misprint: Option<&'static str>,
}

impl Equation {
    /// A row of the table of equations, for an equation that no misprint touches.
    #[must_use]
    pub const fn new(
        tag: &'static str,
        title: &'static str,
        formula: &'static str,
        file: &'static str,
        test: &'static str,
        references: &'static [Reference],
    ) -> Self {
        Self {
            tag,
            title,
            formula,
            file,
            test,
            references,
            misprint: None,
        }
    }

    /// The same row with what the 2022 paper prints, and what is used instead.
    #[must_use]
    pub const fn corrected(self, misprint: &'static str) -> Self {
        Self {
            misprint: Some(misprint),
            ..self
        }
    }
}

/// The paper whose model this workspace builds.
pub const RODRIGUEZ_2022: Reference = Reference {
    key: "rodriguez_2022",
    text: "I. Victoria Rodríguez, Modelling of gear surface roughness impact on gear meshing efficiency, manuscript and thesis, KTH and Volvo, 2022",
};
