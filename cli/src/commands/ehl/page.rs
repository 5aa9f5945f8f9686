//! Page of a lubricated contact.

use asperity::ehl::transient::Moment;
use asperity::ehl::{RoughContact, Scales, SteadyFilm, SteadySettings, Window, steady};
use asperity::reference_solution::formula_film;
use asperity_core::{Code, Fault, PROGRAM};
use asperity_report::html::{
    FilmAndPressure, FilmFrame, LubricatedContact, SharePoint, lubricated_contact,
};

use super::rough::Recorded;
use super::smooth::Smooth;
use crate::failure::Failure;

/// Common contents of the pages of a contact.
struct PageContents<'a> {
    title: &'a str,
    scales: &'a Scales,
    warnings: Vec<(Code, String)>,
}

fn page_of(
    about: PageContents<'_>,
    contact: &RoughContact,
    smooth: &SteadyFilm,
) -> Result<LubricatedContact, Failure> {
    let refused = |error| Fault::from(error).about(about.title);
    let formula = formula_film(&contact.contact, &contact.oil).map_err(refused)?;
    let scales = about.scales;
    let owned = |(code, text): (Code, String)| (code.to_string(), text);
    Ok(LubricatedContact {
        title: about.title.to_owned(),
        subtitle: format!(
            "{PROGRAM} · half-width {:.4}, Hertz pressure {:.4}, slide-to-roll ratio {:.3}, Moes load {:.1}, Moes lubricant {:.1}",
            scales.half_width,
            scales.max_pressure,
            // The sum turns −0 into 0.
            (1e3 * scales.slide_to_roll).round() / 1e3 + 0.0,
            scales.moes_load,
            scales.moes_lubricant
        ),
        verdict: String::new(),
        numbers: Vec::new(),
        notes: Vec::new(),
        warnings: about.warnings.into_iter().map(owned).collect(),
        hertz_pressure: scales.max_pressure.si() * 1e-9,
        formula: formula.map(|film| film.si() * 1e6),
        smooth: curve(scales, &smooth.x, &smooth.pressure, &smooth.film),
        mean: None,
        shares: Vec::new(),
        history: Vec::new(),
        frames: Vec::new(),
    })
}

/// Curves of pressure in GPa and film in µm.
fn curve(scales: &Scales, x: &[f64], pressure: &[f64], film: &[f64]) -> FilmAndPressure {
    FilmAndPressure {
        x: x.to_vec(),
        pressure: gigapascals(scales, pressure),
        film: micrometres(scales, film),
    }
}

fn gigapascals(scales: &Scales, pressure: &[f64]) -> Vec<f64> {
    let p_0 = scales.max_pressure.si() * 1e-9;
    pressure.iter().map(|p| p * p_0).collect()
}

fn micrometres(scales: &Scales, film: &[f64]) -> Vec<f64> {
    let unit = scales.film_length(1.0).si() * 1e6;
    film.iter().map(|h| h * unit).collect()
}

fn number(name: &str, value: String) -> (String, String) {
    (name.to_owned(), value)
}

/// Next step after a smooth film.
const NEXT_OF_SMOOTH: &str = "Without --smooth the command solves the flanks of a case with their traces; asperity run computes the loss.";
/// Next step after a record.
const NEXT: &str = "The command asperity run computes the loss of a case with a faster model of this contact. For a case, --compare prints the \
    load share of that model next to this solution.";

/// The inlet of a record, which makes its smooth film thinner, in words.
fn inlet_of(window: Window) -> String {
    format!(
        "Rough and smooth film have an inlet that begins {:.1} half-widths before the middle. With the longer inlet of asperity ehl \
        --smooth the smooth film is slightly thicker.",
        -window.inlet
    )
}

impl Smooth {
    /// Page of the smooth film.
    pub fn page(&self, contact: &RoughContact) -> Result<String, Failure> {
        let film = &self.solved.value;
        let about = PageContents {
            title: &self.title,
            scales: &film.scales,
            warnings: self.warnings(),
        };
        let mut page = page_of(about, contact, film)?;
        let micrometres = |length: f64| format!("{:.3} µm", length * 1e6);
        page.verdict = format!(
            "Smooth film: {} in the middle, {} at least.",
            micrometres(film.central_film.si()),
            micrometres(film.minimum_film.si())
        );
        page.numbers = vec![
            number("central film", micrometres(film.central_film.si())),
            number("minimum film", micrometres(film.minimum_film.si())),
            number(
                "rolling force per surface",
                format!("{:.2} N/m", film.rolling_force.si()),
            ),
        ];
        let names = ["traction, isothermal", "traction, thermal"];
        page.notes = vec![NEXT_OF_SMOOTH.to_owned()];
        for (name, traction) in names.into_iter().zip(self.tractions()) {
            if let Some(traction) = traction {
                page.numbers
                    .push(number(name, format!("{:.5}", traction.coefficient)));
            }
        }
        Ok(lubricated_contact(&page))
    }
}

/// Verdict of a travel whose halves differ.
const TOO_SHORT: &str = "The travel is too short for an answer. ";

/// Reason for the friction at the pitch point.
const AT_PITCH_POINT: &str = "Here the flanks roll with almost no sliding. The friction of the boundary layer does not depend on the \
    sliding speed, so that the coefficient is not 0. Almost no loss follows from it.";

impl Recorded {
    /// Friction without sliding, and a pressure at its ceiling, in words.
    fn beyond(&self) -> Vec<String> {
        /// Slide-to-roll ratio that is printed as 0.
        const PRINTED_AS_ZERO: f64 = 0.0005;
        let record = &self.solved.value;
        let is_pitch_point = record.scales.slide_to_roll.abs() < PRINTED_AS_ZERO;
        let rubs = is_pitch_point && record.friction.is_some();
        let ceiling = self.ceiling.map(|ceiling| ceiling.pressure);
        let reached = ceiling.filter(|ceiling| record.max_pressure >= *ceiling);
        [
            rubs.then(|| AT_PITCH_POINT.to_owned()),
            reached.map(|ceiling| {
                format!("The largest pressure is at most the flow pressure of the softer flank, {ceiling:.1}, at which the flanks yield.")
            }),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// Page of the record, with the frames of the first record.
    pub fn page(&self, contact: &RoughContact) -> Result<String, Failure> {
        let record = &self.solved.value;
        let scales = &record.scales;
        let settings = SteadySettings {
            cells: self.cells,
            window: Some(self.window),
        };
        let smooth = steady::solve(&contact.contact, &contact.oil, &settings)
            .map_err(|error| Fault::from(error).about(&self.title))?;
        let about = PageContents {
            title: &self.title,
            scales,
            warnings: self.warnings(),
        };
        let mut page = page_of(about, contact, &smooth.value)?;
        let share = &record.solid_share;
        page.verdict = format!(
            "{}Share of the load on films below {:.0} nm: {}.",
            self.doubt().map_or("", |_| TOO_SHORT),
            self.solid_film.si() * 1e9,
            self.shown(share.mean, share.standard_error)
        );
        page.numbers = vec![
            number(
                "share of the load on these films",
                self.shown(share.mean, share.standard_error),
            ),
            number(
                "mean film",
                self.shown_with(
                    " µm",
                    record.mean_film.mean * 1e6,
                    record.mean_film.standard_error * 1e6,
                ),
            ),
            number(
                "smooth film from the same inlet",
                format!("{:.3} µm", record.smooth_film.si() * 1e6),
            ),
            number(
                "largest pressure, mean",
                format!("{:.3} GPa", record.mean_max_pressure.mean * 1e-9),
            ),
            number("travel", format!("{:.1} half-widths", record.travel)),
        ];
        if let Some(friction) = &record.friction {
            let text = self.shown(friction.shifted.mean, friction.shifted.standard_error);
            page.numbers.push(number("friction", text));
        }
        let notes = self.beyond().into_iter();
        page.notes = self
            .doubt()
            .into_iter()
            .chain([self.travel()])
            .chain(notes)
            .collect();
        page.notes.extend([inlet_of(self.window), NEXT.to_owned()]);
        page.mean = Some(curve(
            scales,
            &record.x,
            &record.mean_pressure,
            &record.mean_film_on_nodes,
        ));
        page.shares = record
            .load_below
            .iter()
            .map(|below| SharePoint {
                film_nm: below.film.si() * 1e9,
                share: below.share.mean,
                standard_error: Some(below.share.standard_error).filter(|e| e.is_finite()),
            })
            .collect();
        let moment = |m: &Moment| {
            [
                m.time,
                m.solid_share,
                m.mean_film.si() * 1e6,
                m.max_pressure.si() * 1e-9,
            ]
        };
        page.history = record.history.iter().map(moment).collect();
        page.frames = record
            .frames
            .iter()
            .map(|frame| FilmFrame {
                travel: frame.time,
                pressure: gigapascals(scales, &frame.pressure),
                film: micrometres(scales, &frame.film),
            })
            .collect();
        Ok(lubricated_contact(&page))
    }
}
