//! Report of a boundary friction from Stribeck curves.

use asperity::case::CalibratedName;
use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Mark, Series};
use asperity_report::{Cell, Report, StudyResult, Table, columns};

use super::stribeck::{BoundaryState, Stribeck};
use super::text::is_simulated_source;
use super::traction::BOUNDARY_RATIO;
use crate::block::{constant, origin};
use crate::report::{QUANTILES, files, notes, rehearsal};

const POINTS: &str = "points.csv";

impl StudyResult for Stribeck {
    const KIND: &'static str = "boundary friction";
    const NAME: &'static str = "stribeck";

    fn report(&self) -> Report<'_> {
        let report = Report::new(&self.title, "boundary friction")
            .section("Boundary friction")
            .verdict(rehearsal(&self.sources))
            .verdict([verdict(self)])
            .figures(|| [friction(self)])
            .table(states(self));
        notes(report, sentences(self), &self.warnings)
            .section("For the case")
            .heading(QUANTILES)
            .code(self.block())
            .section("Provenance")
            .table(files(&self.sources))
            .on_page()
            .text_file("case.toml", self.block())
            .rows(POINTS, || &self.points)
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
            constant(key, Estimate::new(self.boundary_friction.value, self.band))
        )
    }
}

fn named(state: &BoundaryState) -> String {
    if state.rubbing_s > 0.0 {
        format!("after {:.0} s of rubbing", state.rubbing_s)
    } else {
        "before rubbing".to_owned()
    }
}

/// Boundary friction before and after rubbing.
fn states(stribeck: &Stribeck) -> Table {
    let friction = |state: &BoundaryState| {
        let cell = |of: f64| {
            Cell::number(of, |of| {
                Digits::of_uncertainty(state.scatter * of).rounded(of)
            })
        };
        Cell::optional(state.boundary_friction.map(cell))
    };
    let table = columns! { state in &stribeck.states;
        head state "state" "" = named(state);
        file rubbing_s = state.rubbing_s;
        number boundary_friction "boundary friction" "" = friction(state);
        number points "points" "";
        percent scatter "scatter" "%" "{:.1}" = state.boundary_friction.map(|_| state.scatter);
        percent slope_per_decade "per decade of speed" "%" "{:+.1}" = state.slope_per_decade;
    };
    table.in_file("states.csv")
}

/// The boundary friction with its interval.
fn verdict(stribeck: &Stribeck) -> String {
    let temperatures = stribeck.temperatures_c.iter();
    let temperatures: Vec<String> = temperatures.map(|at| format!("{at:.0}")).collect();
    let found = stribeck.boundary_friction;
    format!(
        "Boundary friction {} at {} °C; in brackets 5 to 95 %.",
        Digits::of_interval(found.ends()).interval(found),
        temperatures.join(", ")
    )
}

fn sentences(stribeck: &Stribeck) -> Vec<String> {
    vec![
        format!(
            "The boundary friction is the mean of points after the longest rubbing, with a film of at most {BOUNDARY_RATIO} times the roughness of {:.0} nm.",
            stribeck.roughness_nm
        ),
        format!(
            "Standard deviation {:.1} %: 10 % for the transfer from the machine to a gear (assumed), and the scatter.",
            100.0 * stribeck.deviation
        ),
        "Smooth specimens do not show the thickness of the boundary layer; losses of a rig do."
            .to_owned(),
    ]
}

fn friction(stribeck: &Stribeck) -> Drawing {
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
        .level(stribeck.boundary_friction.value, "boundary friction");
    Drawing::Curves(chart)
}
