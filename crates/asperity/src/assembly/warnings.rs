//! Warnings raised from a finished result.

use std::collections::{BTreeMap, BTreeSet};

use asperity_contact::plasticity::{FIRST_YIELD, first_yield_pressure, softer_flow_pressure};
use asperity_contact::{ContactWarning, SUSPECT_GAP};
use asperity_core::quantity::{Length, Pressure};
use asperity_core::{Code, OutOfRange, Treatment};
use asperity_efficiency::equivalent_friction;
use asperity_ehl::PlasticCeiling;
use asperity_gear::{EdgeContactNote, Gear, LoadMapEvidence, StiffnessSource};

use super::micropitting::outside_of_scope;
use crate::gearbox::parts_of_mesh;
use crate::lubrication::{FormulaFilm, LubricatedPosition, LubricatedWindow, NOTED_DEVIATION};
use crate::mesh::Mesh;
use crate::pictures::Picture;
use crate::reference_solution::{LARGEST_ROUGHNESS, elastic_above_flow};
use crate::result::gearbox::GearboxPart;
use crate::result::{FullFilmRow, OutsideInput, RecordRow, Regime, Summary};
use crate::sampling::{length_for, windows_of_traces};
use asperity_case::case::{Case, OperatingCase, Positions};
use asperity_case::error::PositionError;
use asperity_case::flanks::is_substituted;
use asperity_case::flanks::local_roughness::FEW_ASPERITIES;
use asperity_case::flanks::placement::FULL_COVERAGE;
use asperity_case::mesh_position::MeshPosition;
use asperity_case::message::{Subject, Warning};
use asperity_oil::GOLD_FIT;

/// Least part of the loss at untested pressures that is worth a warning.
const LEAST_SHARE: f64 = 0.005;

/// Warnings about the positions and the summary.
pub(crate) fn warnings(
    loaded: &OperatingCase,
    positions: &[LubricatedPosition],
    pictures: &[Option<Picture>],
    summary: &Summary,
) -> Result<Vec<Warning>, PositionError> {
    let mut found = Vec::new();
    found.extend(relief(loaded, None));
    notes(loaded, &mut found);
    bulk(loaded, &mut found);
    ranges(positions.iter().map(outside_at), &mut found);
    let equivalent = equivalent_friction(summary.efficiency, summary.loss_factor_local)?;
    if !equivalent.outside.is_empty() {
        found.push(Warning::new(
            Code::W402,
            format!(
                "mu_eq {:.3} is outside 0.01-0.12 for lubricated steel",
                equivalent.value
            ),
        ));
    }
    same_trace(loaded, &mut found);
    found.extend(far_lay(loaded, None)?);
    no_sliding(
        loaded,
        positions.iter().map(|position| &position.at),
        &mut found,
    );
    stress(loaded, positions, pictures, &mut found)?;
    contacts(positions, &mut found);
    load_reached(summary, &mut found);
    one_tooth(loaded, &mut found);
    roughness(loaded, positions, &mut found)?;
    full_film(positions, &mut found);
    above_tested_pressure(loaded, positions, summary, &mut found);
    Ok(found)
}

/// Warnings about a case on its mesh with its smooth films that need no solution of its contacts.
pub(crate) fn of_case(
    loaded: &OperatingCase,
    mesh: &Mesh,
    films: &[FormulaFilm],
) -> Result<Vec<Warning>, PositionError> {
    let mut found = Vec::new();
    let at = || mesh.positions.iter();
    found.extend(relief(loaded, None));
    notes(loaded, &mut found);
    ranges(
        films.iter().map(|film| film.outside.iter().collect()),
        &mut found,
    );
    same_trace(loaded, &mut found);
    one_tooth(loaded, &mut found);
    values_alone(loaded, &mut found)?;
    short_traces(loaded, at(), &mut found);
    gearbox(&parts_of_mesh(loaded)?, &mut found);
    micropitting(loaded, &mut found);
    found.extend(far_lay(loaded, None)?);
    no_sliding(loaded, at(), &mut found);
    yielding(loaded, at(), "", &mut found)?;
    covered(loaded, at(), &mut found);
    let edge_contact = mesh.load.edge_contact_note()?;
    let evidence = mesh.load.evidence();
    load(loaded, at(), edge_contact.as_ref(), evidence, &mut found);
    Ok(found)
}

/// W401 and W428: properties of oil and steel outside the range of their laws.
fn notes(loaded: &OperatingCase, found: &mut Vec<Warning>) {
    for note in loaded.oil_notes().iter().chain(&loaded.case.steel_notes) {
        found.push(Warning {
            about: (note.correlation == GOLD_FIT).then_some(Subject::PressureViscosity),
            ..Warning::new(code(note), note.to_string())
        });
    }
}

/// W404: one trace for both flanks.
fn same_trace(loaded: &OperatingCase, found: &mut Vec<Warning>) {
    if loaded.surfaces.same_trace {
        found.push(Warning::new(
            Code::W404,
            "both flanks use the same trace, so their roughness is correlated and S = sqrt(Rq1^2 + Rq2^2) is not exact",
        ));
    }
}

/// W452: a lay above 1/3; where it was drawn, with the ratio of the loss at a lay of 1/6 to the loss
/// of the case.
pub(crate) fn far_lay(
    loaded: &OperatingCase,
    confirmed: Option<f64>,
) -> Result<Option<Warning>, PositionError> {
    let Some(lay) = loaded.lay_beyond_records()? else {
        return Ok(None);
    };
    let worth = confirmed.map_or(String::new(), |ratio| {
        let side = if ratio < 1.0 { "lower" } else { "higher" };
        let percent = 100.0 * (ratio - 1.0).abs();
        format!("; at a lay of 1/6 the loss is {percent:.0} % {side}")
    });
    let lines = match loaded.surfaces.sheets() {
        Some(_) => String::new(),
        None => format!(", and above 1/6 the contact of lines is not confirmed{worth}"),
    };
    let text = format!(
        "lay {:.2} of both flanks is above 1/3: no reference solution has such flanks{lines}",
        lay.gamma()
    );
    Ok(Some(Warning {
        about: Some(Subject::Lay),
        ..Warning::new(Code::W452, text)
    }))
}

/// W443: the loss by film friction at pressures above the tested ones.
fn above_tested_pressure(
    case: &Case,
    positions: &[LubricatedPosition],
    summary: &Summary,
    found: &mut Vec<Warning>,
) {
    let Some(file) = &case.oil_file else {
        return;
    };
    let most = file.film_friction.pressure_max;
    // Friction power of film and lubricated asperities, whole and above the tested pressure, up to a common factor.
    let mut powers = [[0.0; 2]; 2];
    for position in positions {
        let at = &position.at;
        let speed = at.weight * at.motion.sliding.si().abs();
        let of_film = load_above(most.si() / at.hertz.max_pressure.si());
        for window in &position.offsets {
            let [film, lubricated, _] = window.rubbing.parts(window.friction.mu);
            // Share of the load on share of the area.
            let touching = window.solved.filter(|solved| solved.area > 0.0);
            let mean = touching.map_or(0.0, |solved| {
                let hertz = std::f64::consts::FRAC_PI_4 * at.hertz.max_pressure.si();
                solved.asperity_share / solved.area * hertz
            });
            let of_spots = f64::from(u8::from(mean > most.si()));
            let each = speed / position.offsets.len() as f64;
            for (power, (force, above)) in powers
                .iter_mut()
                .zip([(film, of_film), (lubricated, of_spots)])
            {
                power[0] += each * force;
                power[1] += each * force * above;
            }
        }
    }
    let watts = powers
        .iter()
        .zip([summary.film_w, summary.lubricated_asperity_w])
        .map(|([whole, above], watts)| {
            if *whole > 0.0 {
                watts * above / whole
            } else {
                0.0
            }
        });
    let [film, spots] = [0, 1].map(|k| watts.clone().nth(k).unwrap_or(0.0));
    if film + spots >= LEAST_SHARE * summary.loss_w {
        let text = format!(
            "{:.0} W of the loss come from pressures above the tested {:.2} GPa ({film:.0} W in the film, {spots:.0} W in touching asperities): the limiting shear stress is extrapolated",
            film + spots,
            1e-9 * most.si()
        );
        found.push(Warning::new(Code::W443, text));
    }
}

/// Share of the load of a Hertz line contact at pressures above `t` times the largest.
///
/// (2/π) (arcsin x + x √(1 − x²)), x = √(1 − t²)
fn load_above(t: f64) -> f64 {
    let x = (1.0 - t * t).max(0.0).sqrt();
    std::f64::consts::FRAC_2_PI * (x.asin() + x * (1.0 - x * x).max(0.0).sqrt())
}

/// W426: a hotter equilibrium exists in addition to the bulk temperature.
fn bulk(loaded: &OperatingCase, found: &mut Vec<Warning>) {
    let Some(report) = loaded.bulk_report() else {
        return;
    };
    let hot = match (report.hotter_c, report.runs_away_from_c) {
        (Some(hotter), _) => format!("a second equilibrium exists at {hotter:.0} °C"),
        (None, Some(from)) => {
            format!("an iteration started at {from:.0} °C finds no equilibrium")
        }
        (None, None) => return,
    };
    let text = format!("bulk temperature {:.0} °C; {hot}", report.bulk_c);
    found.push(Warning::new(Code::W426, text));
}

/// W439: the amounts that a tip relief which is not stated may have, and the loss at both ends where it was drawn.
pub(crate) fn relief(loaded: &OperatingCase, at_ends: Option<[f64; 2]>) -> Option<Warning> {
    let assumed = loaded.case.assumed_relief.as_ref()?;
    let gears = match assumed.gears {
        [true, false] => "of the pinion",
        [false, true] => "of the wheel",
        _ => "of both gears",
    };
    let edges = if loaded.case.gears.internal {
        ""
    } else {
        ", with tip edge contact"
    };
    let most = 1e6 * assumed.approach.si();
    let worth = at_ends.map_or(String::new(), |ratios| {
        let [none, whole] = ratios.map(|ratio| 100.0 * (ratio - 1.0));
        format!(". The loss changes by {whole:+.0} % with {most:.0} um, and by {none:+.0} % without relief{edges}")
    });
    let text = format!("tip relief {gears} not stated, taken from 0 to {most:.0} um{worth}");
    Some(Warning::new(Code::W439, text))
}

/// W401: a part of the gearbox outside the range of its law.
pub(crate) fn gearbox<'a>(
    parts: impl IntoIterator<Item = &'a GearboxPart>,
    found: &mut Vec<Warning>,
) {
    for part in parts {
        let notes = part.outside.iter();
        found.extend(notes.map(|note| Warning::new(Code::W401, format!("{}: {note}", part.name))));
    }
}

/// W432: a case to be rated outside the scope of the specification.
pub(crate) fn micropitting(loaded: &OperatingCase, found: &mut Vec<Warning>) {
    let outside = match loaded.case.input.micropitting {
        Some(_) => outside_of_scope(loaded),
        None => return,
    };
    if !outside.is_empty() {
        let text = format!(
            "the specific film is not a rating by ISO/TS 6336-22 here: {}",
            outside.join("; ")
        );
        found.push(Warning::new(Code::W432, text));
    }
}

/// W450: one tooth of a flank is traced, and several of the other.
fn one_tooth(loaded: &OperatingCase, found: &mut Vec<Warning>) {
    let gear = match loaded.surfaces.several_teeth() {
        Some([1, _]) => Gear::Pinion,
        Some([_, 1]) => Gear::Wheel,
        _ => return,
    };
    let text = format!(
        "one tooth of the {gear} is traced: the standard error of the mean loss leaves out the scatter between its teeth"
    );
    found.push(Warning::new(Code::W450, text));
}

/// W451: contacts that carry their load less closely than the paper's limit, within `paper.numerical_error`.
fn load_reached(summary: &Summary, found: &mut Vec<Warning>) {
    /// The paper stops at 1 %.
    const LARGE: f64 = 0.011;
    if summary.worst_load_error > LARGE {
        let percent = 100.0 * summary.worst_load_error;
        let text = format!(
            "the contacts carry their load with an error of up to {percent:.0} %, within paper.numerical_error"
        );
        found.push(Warning::new(Code::W451, text));
    }
}

/// Distinct inputs outside their ranges: W401, W402, W403 and W405, in the order of their texts.
pub(crate) fn outside(
    loaded: &OperatingCase,
    positions: &[LubricatedPosition],
    summary: &Summary,
) -> Result<Vec<OutsideInput>, PositionError> {
    let of_the_case = loaded.oil_notes().iter().chain(&loaded.case.steel_notes);
    let of_positions = positions.iter().flat_map(outside_at);
    let mut found = BTreeMap::new();
    let mut add = |code, correlation, input| {
        let outside = OutsideInput {
            code,
            correlation,
            input,
        };
        found.insert(outside.to_string(), outside);
    };
    for note in of_the_case.chain(of_positions) {
        add(code(note), note.correlation, Some(note.name));
    }
    let equivalent = equivalent_friction(summary.efficiency, summary.loss_factor_local)?;
    if !equivalent.outside.is_empty() {
        add(Code::W402, "equivalent friction", None);
    }
    let materials = &loaded.case.materials;
    let bearable = first_yield_pressure(&materials[0], &materials[1])?;
    let passes = |position: &LubricatedPosition| position.at.hertz.max_pressure > bearable;
    if positions.iter().any(passes) {
        let yielding = "yield below the surface";
        add(Code::W405, yielding, Some("Hertz pressure"));
    }
    Ok(found.into_values().collect())
}

/// Code of the warning about an input outside its range.
fn code(note: &OutOfRange) -> Code {
    match note.treatment {
        Treatment::SinteredSteel => Code::W428,
        Treatment::Held => Code::W403,
        _ => Code::W401,
    }
}

/// W421 to W425, W433: load over the teeth, and its cells.
pub(crate) fn load<'a>(
    loaded: &OperatingCase,
    positions: impl ExactSizeIterator<Item = &'a MeshPosition>,
    edge_contact: Option<&EdgeContactNote>,
    evidence: &LoadMapEvidence,
    found: &mut Vec<Warning>,
) {
    let mut add = |code, text: String| found.push(Warning::new(code, text));
    if let Some(note) = edge_contact {
        add(
            Code::W421,
            format!(
                "tips are not relieved and the teeth approach by {:.1} um: with contact of the tip edges H_V is {:.4} instead of {:.4}",
                note.approach.si() * 1e6,
                note.with,
                note.without
            ),
        );
    }
    let count = positions.len();
    let is_substituted = |at: &&MeshPosition| is_substituted(&loaded.surfaces, at);
    let light = positions.filter(is_substituted).count();
    if light > 0 {
        add(
            Code::W422,
            format!(
                "{light} of {count} cells of the path carry so little load that the spacing of the traces does not resolve their contact: the roughness of the whole traces is used there"
            ),
        );
    }
    if !evidence.converged {
        add(
            Code::W423,
            format!(
                "the load over the teeth did not settle: the last change is {:.1e} of the mean load",
                evidence.residual
            ),
        );
    }
    if let Some(StiffnessSource::IsoForRootForm(gear)) = evidence.stiffness {
        add(
            Code::W424,
            format!(
                "the root of the {gear} has no simple outline: the stiffness is that of ISO 6336-1"
            ),
        );
    }
    for (gear, root) in [Gear::Pinion, Gear::Wheel]
        .into_iter()
        .zip(loaded.case.load_settings.root)
    {
        if let Some(below) = loaded.case.gears.contact_below_involute(gear, root) {
            add(
                Code::W433,
                format!(
                    "the gears interfere: contact reaches a roll length of {:.2} mm below the involute of the {gear}, into its fillet",
                    below.si() * 1e3
                ),
            );
        }
    }
    if loaded.case.gears.tips_may_foul() {
        let [z1, z2] = loaded.case.gears.teeth;
        add(
            Code::W425,
            format!(
                "the ring has only {} teeth more than the pinion: tips may foul away from the line of action, which is not checked",
                z2.saturating_sub(z1)
            ),
        );
    }
}

/// Inputs of film and friction outside their ranges at a solved position.
fn outside_at(position: &LubricatedPosition) -> Vec<&OutOfRange> {
    let offsets = position.offsets.iter();
    let in_friction = offsets.flat_map(|offset| &offset.friction.outside);
    position.film.outside.iter().chain(in_friction).collect()
}

/// W401 and W403: one line for each correlation and input, over all positions, of which `outside` are the inputs.
fn ranges<'a>(
    outside: impl ExactSizeIterator<Item = Vec<&'a OutOfRange>>,
    found: &mut Vec<Warning>,
) {
    struct Seen<'a> {
        note: &'a OutOfRange,
        least: f64,
        most: f64,
        positions: usize,
    }
    let mut seen: BTreeMap<(&str, &str), Seen<'_>> = BTreeMap::new();
    let mut add = |note: &'a OutOfRange, is_new: &mut BTreeSet<(&str, &str)>| {
        let key = (note.correlation, note.name);
        let entry = seen.entry(key).or_insert(Seen {
            note,
            least: note.value,
            most: note.value,
            positions: 0,
        });
        entry.least = entry.least.min(note.value);
        entry.most = entry.most.max(note.value);
        if is_new.insert(key) {
            entry.positions += 1;
        }
    };
    let positions = outside.len();
    for at in outside {
        let mut here = BTreeSet::new();
        for note in at {
            add(note, &mut here);
        }
    }
    for entry in seen.values() {
        let note = entry.note;
        let value = if entry.least == entry.most {
            short(entry.least)
        } else {
            format!("{} .. {}", short(entry.least), short(entry.most))
        };
        found.push(Warning::new(
            code(note),
            format!(
                "{}: {} {value}{} is {} at {} of {} positions",
                note.correlation,
                note.name,
                note.unit_after_a_number(),
                note.limits(|&limit| short(limit)),
                entry.positions,
                positions,
            ),
        ));
    }
}

/// Four digits that mean something, without trailing zeros.
fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{value:.2e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// W412: the single position is the pitch point, where there is no sliding.
fn no_sliding<'a>(
    loaded: &OperatingCase,
    mut positions: impl Iterator<Item = &'a MeshPosition>,
    found: &mut Vec<Warning>,
) {
    /// Slide-to-roll ratios below this are round-off at the pitch point.
    const PURE_ROLLING: f64 = 1e-9;
    let rolls = |at: &MeshPosition| at.motion.slide_to_roll.abs() < PURE_ROLLING;
    let is_single = loaded.case.formulation.positions() == Positions::Single;
    if is_single && positions.all(rolls) {
        found.push(Warning::new(
            Code::W412,
            "the single position is the pitch point, where there is no sliding: the efficiency contains no sliding loss. Set paper.position, e.g. 0.25",
        ));
    }
}

/// W413, W414: a contact that runs into the end of its window, and a gap that no flank has.
fn contacts(positions: &[LubricatedPosition], found: &mut Vec<Warning>) {
    let count = positions.len();
    let at = |is_meant: &dyn Fn(&LubricatedPosition, &ContactWarning) -> bool| {
        let has_one =
            |position: &&LubricatedPosition| position.doubts.iter().any(|d| is_meant(position, d));
        positions.iter().filter(has_one).count()
    };
    let at_end = at(&|_, doubt| matches!(doubt, ContactWarning::PressureAtEnd { .. }));
    if at_end > 0 {
        found.push(Warning::new(
            Code::W413,
            format!(
                "the rough contact runs into the end of its window at {at_end} of {count} positions: raise model.window"
            ),
        ));
    }
    // The asperities may carry next to nothing and deform as little: what the whole load deforms is the measure.
    let beyond = at(&|position, doubt| {
        let ContactWarning::GapBeyondDeformation { gap_range, .. } = doubt else {
            return false;
        };
        let half_width = position.at.hertz.half_width.si();
        let of_all = half_width * half_width / (2.0 * position.at.motion.radius.si());
        gap_range.si() > SUSPECT_GAP * of_all
    });
    if beyond > 0 {
        found.push(Warning::new(
            Code::W414,
            format!(
                "the gap in the contact window spans more than {SUSPECT_GAP} times the deformation at {beyond} of {count} positions: an outlier or a wrong unit"
            ),
        ));
    }
}

/// W405: yield below the surface by the smooth contact, with the words about its zone; the pressure that the flanks bear, and
/// whether it is passed.
fn yielding<'a>(
    loaded: &OperatingCase,
    positions: impl Iterator<Item = &'a MeshPosition>,
    zone: &str,
    found: &mut Vec<Warning>,
) -> Result<(f64, bool), PositionError> {
    let [pinion, wheel] = &loaded.case.materials;
    let bearable = first_yield_pressure(pinion, wheel)?.si();
    let pressures = positions.map(|at| at.hertz.max_pressure.si());
    let highest = pressures.fold(0.0, f64::max);
    if highest > bearable {
        found.push(Warning::new(
            Code::W405,
            format!(
                "p0 {:.0} MPa exceeds {FIRST_YIELD} x the elastic limit {:.0} MPa: the flanks yield below the surface, which is not modelled{zone}",
                highest * 1e-6,
                loaded.case.elastic_limit().si() * 1e-6
            ),
        ));
    }
    Ok((bearable, highest > bearable))
}

/// W405, W409, W410: yield below the surface, and flow of the asperities.
fn stress(
    loaded: &OperatingCase,
    positions: &[LubricatedPosition],
    pictures: &[Option<Picture>],
    found: &mut Vec<Warning>,
) -> Result<(), PositionError> {
    // The zone of the position with the largest share.
    let stresses = pictures
        .iter()
        .flatten()
        .filter_map(|picture| picture.stress);
    let zones = stresses.filter(|stress| stress.yield_share > 0.0);
    let widest = zones.max_by(|one, other| one.yield_share.total_cmp(&other.yield_share));
    let zone = widest.map_or(String::new(), |zone| {
        format!(
            ". The von Mises stress exceeds the elastic limit down to {:.0} um, in {:.1} % of the section below a contact",
            zone.yield_depth.si() * 1e6,
            100.0 * zone.yield_share
        )
    });
    let at = positions.iter().map(|position| &position.at);
    let (bearable, yields) = yielding(loaded, at, &zone, found)?;
    let limit = loaded.case.elastic_limit();
    let flowing = |position: &&LubricatedPosition| {
        let mut contacts = position.offsets.iter().filter_map(|offset| offset.contact);
        contacts.any(|contact| contact.plastic_work > 0.0)
    };
    let count = positions.iter().filter(flowing).count();
    if count > 0 {
        found.push(Warning::new(
            Code::W409,
            format!(
                "asperities yield at {count} of {} positions: expect running-in{zone}",
                positions.len()
            ),
        ));
    }
    let strained = positions.iter().enumerate().map(|(k, position)| {
        let picture = pictures.get(k).and_then(Option::as_ref);
        strained(position, picture, limit, bearable)
    });
    let strained: usize = strained.sum();
    if strained > 0 && !yields {
        let contacts: usize = positions.iter().map(|p| p.offsets.len()).sum();
        found.push(Warning::new(
            Code::W410,
            format!(
                "asperities yield below their surface in {strained} of {contacts} contacts, as usual before running-in. The von Mises stress exceeds the elastic limit {:.0} MPa",
                limit.si() * 1e-6,
            ),
        ));
    }
    Ok(())
}

/// Offsets of a position at which an asperity yields below its surface: by the stress field where that was
/// computed, elsewhere where its pressure passes that at which a line contact first yields.
fn strained(
    position: &LubricatedPosition,
    picture: Option<&Picture>,
    limit: Pressure,
    bearable: f64,
) -> usize {
    let stress = picture.and_then(|picture| picture.stress);
    let fields = stress.map(|stress| stress.largest.value > limit);
    let offsets = position.offsets.iter().enumerate();
    let yields = offsets.filter(|(index, offset)| match fields {
        Some(yields) if *index == 0 => yields,
        _ => offset
            .contact
            .is_some_and(|contact| contact.p_max > bearable),
    });
    yields.count()
}

/// W415 and W435: records whose ridges cannot leak, or are elastic above the flow pressure.
pub(crate) fn records(
    case: &Case,
    records: &[RecordRow],
    found: &mut Vec<Warning>,
) -> Result<(), PositionError> {
    if records.is_empty() {
        return Ok(());
    }
    let [pinion, wheel] = case.flow_pressure;
    let ceiling = PlasticCeiling {
        pressure: softer_flow_pressure(pinion, wheel)?,
    };
    let largest = records.iter().map(|record| record.p_max_mpa);
    let largest = Pressure::from_si(1e6 * largest.fold(0.0, f64::max));
    if let Some(text) = elastic_above_flow(largest, Some(ceiling)) {
        found.push(Warning::new(Code::W435, text));
    }
    let ratios = records.iter().map(|record| record.roughness_over_film);
    let beyond = ratios.clone().filter(|r| *r > LARGEST_ROUGHNESS).count();
    if beyond > 0 {
        found.push(Warning::new(
            Code::W415,
            format!(
                "the roughness left in the contact is up to {:.2} smooth films, above {LARGEST_ROUGHNESS} in {beyond} of {} reference solutions: the modelled ridges cannot leak, so rely on measurements rather than on these solutions",
                ratios.fold(0.0, f64::max),
                records.len()
            ),
        ));
    }
    Ok(())
}

/// W416: full films that differ from the formulas.
fn full_film(positions: &[LubricatedPosition], found: &mut Vec<Warning>) {
    let rows = || {
        let films = positions.iter().filter_map(|p| p.full_film.as_ref());
        films.map(|film| film.row)
    };
    let off = |row: &FullFilmRow| row.largest_deviation() > NOTED_DEVIATION;
    let count = rows().filter(off).count();
    if count == 0 {
        return;
    }
    let most = |of: &dyn Fn(&FullFilmRow) -> f64| {
        let values = rows().map(|row| of(&row));
        values.fold(0.0, |most: f64, value| {
            if value.abs() > most.abs() {
                value
            } else {
                most
            }
        })
    };
    found.push(Warning::new(
        Code::W416,
        format!(
            "the solved full film is more than {:.0} % off the formulas at {count} of {} positions: central film by up to {:+.0} %, minimum film {:+.0} %, friction {:+.0} %",
            100.0 * NOTED_DEVIATION,
            rows().count(),
            100.0 * most(&|row| row.film_central_deviation),
            100.0 * most(&|row| row.film_minimum_deviation),
            100.0 * most(&|row| row.mu_deviation.unwrap_or(0.0)),
        ),
    ));
}

/// W406, W407, W408, W411: limits of the traces.
fn roughness(
    loaded: &OperatingCase,
    positions: &[LubricatedPosition],
    found: &mut Vec<Warning>,
) -> Result<(), PositionError> {
    if !loaded.surfaces.are_measured() {
        return values_alone(loaded, found);
    }
    if loaded.surfaces.is_surrogate() {
        // W438 reports them, and there is no trace to improve.
        return Ok(());
    }
    // A solved or recorded load share does not depend on Λ*.
    let by_ratio = |offset: &LubricatedWindow| offset.solved.is_none() && offset.recorded.is_none();
    let mixed = |offset: &&LubricatedWindow| offset.regime == Regime::Mixed && by_ratio(offset);
    let offsets = || {
        positions
            .iter()
            .flat_map(|position| &position.offsets)
            .filter(mixed)
    };
    let few = offsets()
        .filter(|offset| offset.roughness.asperities < FEW_ASPERITIES)
        .count();
    if few > 0 {
        found.push(Warning::new(
            Code::W406,
            format!(
                "fewer than {FEW_ASPERITIES} asperities reach into the peak zone in {few} of {} mixed contacts; their mean radius is uncertain",
                offsets().count()
            ),
        ));
    }
    let without_peaks = offsets()
        .filter(|offset| offset.lambda_star.is_none())
        .count();
    if without_peaks > 0 {
        found.push(Warning::new(
            Code::W411,
            format!(
                "no peaks above the core in {without_peaks} of {} mixed contacts: the classical film ratio was used there",
                offsets().count()
            ),
        ));
    }
    let at = || positions.iter().map(|position| &position.at);
    short_traces(loaded, at(), found);
    covered(loaded, at(), found);
    Ok(())
}

/// W408: the film ratio from which the load share of a flank without a trace follows.
fn values_alone(loaded: &OperatingCase, found: &mut Vec<Warning>) -> Result<(), PositionError> {
    if loaded.surfaces.are_measured() {
        return Ok(());
    }
    let peak = loaded.surfaces.roughness_of_values()?.reduced_peak;
    let ratio = if peak.is_some_and(|peak| peak > 0.0) {
        "Lambda*"
    } else {
        "without rpk and asperity_radius the classical film ratio"
    };
    let text = format!(
        "a flank is given by roughness values only, so the rough contact was not computed: the load share follows from the film ratio, {ratio}"
    );
    found.push(Warning::new(Code::W408, text));
    Ok(())
}

/// W407: traces of few independent windows.
fn short_traces<'a>(
    loaded: &OperatingCase,
    positions: impl Iterator<Item = &'a MeshPosition>,
    found: &mut Vec<Warning>,
) {
    const FEW: f64 = 4.0;
    const ENOUGH: f64 = 8.0;
    let surfaces = &loaded.surfaces;
    let has_one = surfaces.offsets(loaded.case.model.offsets) <= surfaces.pairs();
    // The traces of several teeth are the sample, however long each is; surrogates have no trace to improve.
    if has_one || surfaces.several_teeth().is_some() || surfaces.is_surrogate() {
        return;
    }
    let half_widths = positions.map(|at| at.hertz.half_width.si());
    let widest = Length::from_si(half_widths.fold(0.0, f64::max));
    let Some(windows) = windows_of_traces(surfaces, loaded.case.model.window, widest)
        .filter(|windows| *windows < FEW)
    else {
        return;
    };
    let length = length_for(ENOUGH, loaded.case.model.window, widest);
    found.push(Warning::new(
        Code::W407,
        format!(
            "the traces hold only {windows:.1} independent windows of the contact: the sampling error rests on experience with like flanks; measure {:.1} mm or more",
            1e3 * length.si(),
        ),
    ));
}

/// W417: contacts beyond the ends of placed traces.
fn covered<'a>(
    loaded: &OperatingCase,
    positions: impl Iterator<Item = &'a MeshPosition> + Clone,
    found: &mut Vec<Warning>,
) {
    let coverage = loaded.surfaces.coverage(positions);
    if let Some(coverage) = coverage.filter(|coverage| *coverage < FULL_COVERAGE) {
        found.push(Warning::new(
            Code::W417,
            format!(
                "the traces cover {:.0} % of the loss along the path of contact; elsewhere the nearest window on them stands",
                100.0 * coverage
            ),
        ));
    }
}
