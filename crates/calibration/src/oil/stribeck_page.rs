//! Page, tables and summary of a boundary friction from Stribeck curves.

use std::path::Path;

use asperity::case::CalibratedName;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Mark, Series};
use asperity_report::html::{figure, page};
use asperity_report::{Cell, StudyResult, Table, columns, tables, write_text};
use maud::{Markup, html};

use super::stribeck::{BoundaryState, Stribeck};
use super::text::is_simulated_source;
use super::traction::BOUNDARY_RATIO;
use crate::block::{constant, digits, origin};
use crate::page::{files, notes, warnings};

const POINTS: &str = "points.csv";

impl StudyResult for Stribeck {
    const KIND: &'static str = "boundary friction";
    const NAME: &'static str = "stribeck";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        let mut text = states(self).text("");
        text += &notes(&sentences(self), &self.sources, &self.warnings);
        text.push_str("for the case (low and high are the 2.5 % and 97.5 % quantiles):\n");
        text.push_str(&self.block());
        text
    }

    fn page(&self, (): ()) -> String {
        let sections = [
            ("Boundary friction", friction(self)),
            (
                "For the case",
                html! { pre { code { (self.block()) } } p { "low and high are the 2.5 % and 97.5 % quantiles." } },
            ),
            ("Provenance", files(&self.sources)),
        ];
        let subtitle = format!("{} · boundary friction", self.program);
        page(&self.title, &subtitle, &sections)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_text(&folder.join("case.toml"), &self.block())?;
        tables::write(&folder.join(POINTS), self.points.iter())
    }
}

impl Stribeck {
    /// The boundary friction as table `calibration` of a case.
    #[must_use]
    pub fn block(&self) -> String {
        let files: Vec<&str> = self.sources.iter().map(|[file, _]| &**file).collect();
        let key = CalibratedName::BoundaryFriction.key();
        format!(
            "{}{}\n",
            origin(
                &files.join(", "),
                self.sources.iter().any(is_simulated_source)
            ),
            constant(key, self.boundary_friction, self.band)
        )
    }
}

fn named(state: &BoundaryState) -> String {
    match state.rubbing_s > 0.0 {
        true => format!("after {:.0} s of rubbing", state.rubbing_s),
        false => "before rubbing".to_owned(),
    }
}

/// Boundary friction before and after rubbing.
fn states(stribeck: &Stribeck) -> Table {
    columns! { state in &stribeck.states;
        head state "state" "" = named(state);
        number friction "boundary friction" "" = Cell::optional(state.boundary_friction.map(digits));
        number points "points" "";
        number scatter "scatter" "%" "{:.1}" = state.boundary_friction.map(|_| 100.0 * state.scatter);
        number slope "per decade of speed" "%" "{:+.1}" = state.slope_per_decade.map(|slope| 100.0 * slope);
    }
}

fn sentences(stribeck: &Stribeck) -> Vec<String> {
    let temperatures = stribeck.temperatures_c.iter();
    let temperatures: Vec<String> = temperatures.map(|at| format!("{at:.0}")).collect();
    let [low, high] = stribeck.range.map(digits);
    vec![
        format!(
            "Boundary friction {} ({low}..{high}, 5 to 95 %) at {} °C: the mean of the points with a film of at most {BOUNDARY_RATIO} times the roughness of {:.0} nm after the longest rubbing",
            digits(stribeck.boundary_friction),
            temperatures.join(", "),
            stribeck.roughness_nm
        ),
        format!(
            "Standard deviation {:.1} %: 10 % for the transfer from the machine to a gear (judgement), and the scatter",
            100.0 * stribeck.deviation
        ),
        "Smooth specimens do not show the thickness of the boundary layer; losses of a rig do"
            .to_owned(),
    ]
}

fn friction(stribeck: &Stribeck) -> Markup {
    let mut chart = Chart::new(
        "stribeck",
        "Friction over the film",
        POINTS,
        Axis::new("film over roughness", "").log(),
        Axis::new("friction coefficient", "").from_zero(),
    );
    for state in &stribeck.states {
        let of = |point: &&super::stribeck::StribeckPoint| point.rubbing_s == state.rubbing_s;
        let points = stribeck.points.iter().filter(of);
        let points = points.map(|point| [point.film_ratio, point.traction]);
        chart = chart.with(Series::through(&named(state), Line::Scatter, points));
    }
    let chart = chart
        .marked(&[Mark {
            at: BOUNDARY_RATIO,
            label: "boundary".to_owned(),
        }])
        .level(stribeck.boundary_friction, "boundary friction");
    html! {
        (warnings(&stribeck.warnings))
        @for line in sentences(stribeck) { p { (line) "." } }
        div.charts { (figure(&Drawing::Curves(chart))) }
        (states(stribeck))
    }
}
