//! `asperity film`: fluid pressure across the film over its thickness, Fig. 8 of the paper.

use asperity_paper_2022::{FilmSurvey, film as survey};
use asperity_report::columns;

use super::{load_case, on_the_path};
use crate::args::{Common, FilmArgs};
use crate::failure::Failure;
use crate::output::print;

/// `asperity film`
pub fn film(args: &FilmArgs, common: &Common) -> Result<(), Failure> {
    let loaded = load_case(&args.case, &args.set, None)?;
    let position = on_the_path(&loaded, args.position)?;
    let survey = survey(&loaded, position).map_err(|error| Failure::about(&args.case, &error))?;
    print(common, || &survey, || table(&survey))
}

fn table(survey: &FilmSurvey) -> String {
    let table = columns! { row in &survey.rows;
        number thickness "film" "µm" "{:.4}" = row.thickness_m * 1e6;
        number reynolds_cross_pa "reynolds-cross" "Pa" "{:.4e}";
        number paper_pa "paper" "Pa" "{:.4e}";
        number ratio_to_hertz "ratio to p0" "" "{:.2e}";
        number thickness_over_radius "film over radius" "" "{:.1e}";
    };
    format!(
        "pressure difference across the film at {:.4} of the path\np0 {:.0} MPa, central film {:.3} um\n{}",
        survey.path_fraction,
        survey.hertz_pressure_pa * 1e-6,
        survey.film_central_m * 1e6,
        table.text("")
    )
}
