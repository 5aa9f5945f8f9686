//! `asperity film`: fluid pressure across the film over its thickness, Fig. 8 of the paper.

use asperity::pipeline::{FilmSurvey, film as survey};

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
    let mut text = format!(
        "pressure difference across the film at {:.4} of the path (p0 {:.0} MPa, central film {:.3} um)\n\
         {:>12} {:>20} {:>12} {:>14} {:>10}\n",
        survey.path_fraction,
        survey.hertz_pressure_pa * 1e-6,
        survey.film_central_m * 1e6,
        "film um",
        "reynolds-cross Pa",
        "paper Pa",
        "ratio to p0",
        "h/R"
    );
    for row in &survey.rows {
        text.push_str(&format!(
            "{:>12.4} {:>20.4e} {:>12.4e} {:>14.2e} {:>10.1e}\n",
            row.thickness_m * 1e6,
            row.reynolds_cross_pa,
            row.paper_pa,
            row.ratio_to_hertz,
            row.thickness_over_radius
        ));
    }
    text
}
