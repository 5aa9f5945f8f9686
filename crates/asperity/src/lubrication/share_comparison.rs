//! Load-share laws compared with the reference solution, at one place and over the same traces.

use asperity_contact::SolverSettings;
use asperity_core::Profile;
use asperity_core::numerics::GOLDEN_SECTION;
use asperity_core::quantity::{Length, Pressure};
use asperity_core::task::try_par_map;
use asperity_ehl::Record;
use asperity_ehl_regime::published_shares::masjedi_khonsari;
use asperity_ehl_regime::{Lay, LoadShareLaw, PairSpectrum, TraceSpectrum};
use serde::Serialize;

use super::chosen_laws::ChosenLaws;
use super::decision::lambda_star_of;
use super::film_of_case::formula_film;
use crate::reference_solution::{ReferenceContact, ReferenceError, rheology};
use asperity_case::case::OperatingCase;
use asperity_case::flanks::{Roughness, Surfaces, Texture};
use asperity_mixed_film::{
    AttenuatedTraces, ContactTable, InletSupply, LoadShareError, LoadShareSettings,
    LoadShareSolution, PositionFilm, RoughContact, RoughWindow, SmoothFilm,
};

/// Windows of the traces that the laws are averaged over.
pub const WINDOWS: usize = 8;
/// Half width of a window in Hertz half-widths.
const HALF_WINDOW: f64 = 3.0;

/// Solid share of one law.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LawShare {
    /// Name of the law as in a case file.
    pub law: &'static str,
    /// Share of the load on the asperities; none where the law has no answer.
    pub solid_share: Option<f64>,
    /// Solid share minus that in the reference solution.
    pub minus_reference: Option<f64>,
    /// Mean gap of the flanks \[µm\], of laws that solve for it.
    pub mean_gap_um: Option<f64>,
    /// Friction coefficient, of laws that solve for it.
    pub friction: Option<f64>,
}

/// The laws compared with the reference solution.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShareComparison {
    /// Solid share of the reference solution: mean of the loads below 20 and 50 nm.
    pub reference_share: f64,
    /// Mean film of the reference solution \[µm\].
    pub reference_mean_film_um: f64,
    /// Friction of the reference solution with the heat of film and surfaces, by the laws.
    pub reference_friction: Option<f64>,
    /// Windows that the laws are averaged over.
    pub windows: usize,
    /// The laws.
    pub laws: Vec<LawShare>,
}

/// A window of both traces with its rough contact.
#[derive(Debug, Clone)]
pub struct ComparedWindow {
    /// First point of each trace.
    pub starts: [usize; 2],
    /// Number of points.
    pub points: usize,
    /// The rough contact.
    pub contact: ContactTable,
    roughness: Roughness,
}

/// Compares the load-share laws with `record` of `contact`, made with heat.
///
/// # Errors
/// When a window leaves its trace, a rough contact does not converge or a law refuses the numbers.
pub fn shares(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    record: &Record,
) -> Result<ShareComparison, ReferenceError> {
    let windows = compared_windows(loaded, contact, WINDOWS)?;
    let settings = share_settings(loaded, contact)?;
    let smooth = LoadShareSettings {
        supply: InletSupply::Smooth,
        ..settings
    };
    let [rough, smooth] =
        [settings, smooth].map(|settings| solved(loaded, contact, &windows, &settings));
    let reference_share = reference_share(record);
    let friction = record.heated.map(|heated| heated.friction);
    let row = |law, share: Option<f64>, gap, friction| LawShare {
        law,
        solid_share: share,
        minus_reference: share.map(|share| share - reference_share),
        mean_gap_um: gap,
        friction,
    };
    let by_contact = |law, solutions: &[LoadShareSolution]| {
        let mean = |of: &dyn Fn(&LoadShareSolution) -> f64| {
            Some(solutions.iter().map(of).sum::<f64>() / solutions.len() as f64)
        };
        let gap = mean(&|solution| solution.mean_gap.si() * 1e6);
        let share = mean(&|solution| solution.asperity_share);
        row(law, share, gap, mean(&|solution| solution.coefficient))
    };
    let by_law = |law: LoadShareLaw| mean_share(loaded, contact, &windows, law);
    Ok(ShareComparison {
        reference_share,
        reference_mean_film_um: record.mean_film.mean * 1e6,
        reference_friction: friction.map(|friction| friction.shifted.mean),
        windows: windows.len(),
        laws: vec![
            by_contact("solved", &rough?),
            row("lambda-star", by_law(LoadShareLaw::LambdaStar)?, None, None),
            row("zhu-hu", by_law(LoadShareLaw::ZhuHu)?, None, None),
            row(
                "masjedi-khonsari",
                Some(regression(loaded, contact, &windows)?),
                None,
                None,
            ),
            by_contact("jgp", &smooth?),
        ],
    })
}

/// Mean of the loads below 20 and 50 nm: what touches is between the two.
fn reference_share(record: &Record) -> f64 {
    let below = |nm: f64| {
        let same = |film: Length| (film.si() * 1e9 - nm).abs() < 1e-6;
        record.load_below.iter().find(|below| same(below.film))
    };
    match (below(20.0), below(50.0)) {
        (Some(low), Some(high)) => 0.5 * (low.share.mean + high.share.mean),
        _ => record.solid_share.mean,
    }
}

/// The choices of a case for the load share on the traces of `contact`.
///
/// # Errors
/// When the roughness of a trace is not finite.
pub fn share_settings(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
) -> Result<LoadShareSettings, ReferenceError> {
    let rms = |trace: &Profile| {
        let square = trace.heights().iter().map(|z| z * z).sum::<f64>() / trace.len() as f64;
        Length::from_si(square.sqrt())
    };
    Ok(LoadShareSettings {
        lay: Lay::of_pair(loaded.case.model.lay, contact.traces.each_ref().map(rms))?,
        ..loaded.case.solved_share()
    })
}

/// Load share and friction of the windows, with Ψ of the inlet from both whole traces.
fn solved(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    windows: &[ComparedWindow],
    settings: &LoadShareSettings,
) -> Result<Vec<LoadShareSolution>, ReferenceError> {
    let case = loaded;
    let line = contact.position.line_contact(case.modulus, case.materials);
    let rheology = rheology(case)?;
    let formula = formula_film(case, &contact.position)?;
    let smooth = SmoothFilm {
        central: formula.film.central,
        thermal_factor: formula.thermal_reduction,
    };
    let mut film = PositionFilm::with_film(&rheology, &line, case.temperature(), settings, smooth)?;
    let spectrum = |trace: &Profile| TraceSpectrum::new(trace.heights(), trace.spacing());
    let [first, second] = contact.traces.each_ref().map(spectrum);
    let spectra = [&first?, &second?];
    let flattening = film.flattening(&PairSpectrum::from_traces(spectra))?;
    let traces = AttenuatedTraces::new(spectra, &flattening);
    let share = |window: &ComparedWindow| {
        let roughness = traces.window(window.starts, window.points)?;
        Ok(film.share(&window.contact, &roughness)?.value)
    };
    windows.iter().map(share).collect()
}

/// `count` windows of `contact` with their rough contacts; [`shares`] averages over [`WINDOWS`].
///
/// # Errors
/// When a window leaves its trace or a rough contact does not converge.
pub fn compared_windows(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    count: usize,
) -> Result<Vec<ComparedWindow>, ReferenceError> {
    let [first, second] = &contact.traces;
    let points = points_of_window(contact);
    let place =
        |part: f64, length: usize| (part * length.saturating_sub(points) as f64).round() as usize;
    let starts = |k: usize| {
        [
            place((k as f64 + 0.5) / count as f64, first.len()),
            place((0.5 + k as f64 * GOLDEN_SECTION).fract(), second.len()),
        ]
    };
    windows_at(loaded, contact, &(0..count).map(starts).collect::<Vec<_>>())
}

/// Points of a window of the traces of `contact`, an odd number.
#[must_use]
pub fn points_of_window(contact: &ReferenceContact) -> usize {
    let spacing = contact.traces[0].spacing();
    2 * (HALF_WINDOW * (contact.position.hertz.half_width / spacing)).ceil() as usize + 1
}

/// Windows of the traces of `contact` that begin at points, with their rough contacts.
///
/// # Errors
/// When a window leaves its trace or a rough contact does not converge.
pub fn windows_at(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    starts: &[[usize; 2]],
) -> Result<Vec<ComparedWindow>, ReferenceError> {
    let case = loaded;
    let line = contact.position.line_contact(case.modulus, case.materials);
    let [pinion, wheel] = case.flow_pressure.map(Pressure::si);
    let spacing = contact.traces[0].spacing();
    let points = points_of_window(contact);
    let surfaces = Surfaces::new(
        contact.traces.clone().map(Texture::Trace),
        case.preparation.lambda_s,
        loaded.surfaces.same_trace,
    );
    try_par_map(starts, |&starts| {
        let cut = |k: usize| {
            let trace = &contact.traces[k];
            let heights = trace.heights().get(starts[k]..starts[k] + points);
            let heights = heights
                .ok_or_else(|| LoadShareError::window_beyond_trace(starts[k], points, trace.len()));
            Ok::<_, ReferenceError>(Profile::new(spacing, heights?.to_vec())?)
        };
        let flanks = [cut(0)?, cut(1)?];
        let sum = flanks[0].heights().iter().zip(flanks[1].heights());
        let composite: Vec<f64> = sum.map(|(a, b)| a + b).collect();
        let mut rough = RoughContact::new(&RoughWindow {
            composite: &composite,
            spacing,
            load: line.load,
            radius: line.radius,
            modulus: line.modulus,
            flow_pressure: Pressure::from_si(pinion.min(wheel)),
            settings: SolverSettings {
                tolerance: case.model.tolerance,
                ..SolverSettings::default()
            },
        })?;
        Ok(ComparedWindow {
            starts,
            points,
            contact: ContactTable::build(&mut rough)?,
            roughness: surfaces.roughness_of(&flanks)?,
        })
    })
}

/// Mean solid share of a law of Λ* or of the classical film ratio; none where a window has no Λ* to decide by.
fn mean_share(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    windows: &[ComparedWindow],
    law: LoadShareLaw,
) -> Result<Option<f64>, ReferenceError> {
    let laws = ChosenLaws::from_case(loaded);
    let position = &contact.position;
    let film = formula_film(loaded, position)?.film;
    let mut sum = 0.0;
    for window in windows {
        let combined = window.roughness.combined_rq()?;
        let ratio = asperity_ehl_regime::film_ratio(film.minimum, 1.0, combined)?;
        let Some(lambda) = lambda_star_of(&laws, position, &film, &window.roughness)? else {
            return Ok(None);
        };
        sum += 1.0 - law.film_share(lambda, ratio)?;
    }
    Ok(Some(sum / windows.len() as f64))
}

fn regression(
    loaded: &OperatingCase,
    contact: &ReferenceContact,
    windows: &[ComparedWindow],
) -> Result<f64, ReferenceError> {
    let case = loaded;
    let [pinion, wheel] = case.flow_pressure.map(Pressure::si);
    let film = formula_film(case, &contact.position)?.conditions;
    let mut sum = 0.0;
    for window in windows {
        sum += masjedi_khonsari(
            &film.line_groups()?,
            window.roughness.combined_rq()?,
            film.radius,
            Pressure::from_si(pinion.min(wheel)),
            film.modulus,
        )?
        .value;
    }
    Ok(sum / windows.len() as f64)
}
