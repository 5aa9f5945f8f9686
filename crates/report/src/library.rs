//! Gears, steels and oils of the library as JSON, with numbers that follow from theirs.

use std::collections::BTreeSet;

use asperity::core::nearest_name;
use asperity::gear::{GearPair, GearPairInput, Plane};
use asperity::oil::{LibraryOil, LubricantError, LubricantInput, library};
use asperity_core::presets::{
    FigureRow, GearPreset, PresetError, PresetSource, SteelPreset, gear, gears, sources, steel,
    steels,
};
use asperity_core::quantity::{Length, Temperature};
use asperity_core::{Code, Fault};
use serde_json::{Value, json};

/// Temperatures \[°C\] at which the viscosities of an oil are listed.
const LISTED: [f64; 2] = [40.0, 100.0];

fn unknown(kind: &str, name: &str, known: &[String]) -> Fault {
    let similar = nearest_name(name, known);
    let question = similar.map_or(".".to_owned(), |name| format!(". Did you mean \"{name}\"?"));
    let known = known.join(", ");
    Fault::new(
        Code::E220,
        format!("the library has no {kind} named \"{name}\"{question} It has: {known}"),
    )
}

/// The error of a name that the library does not have, or of its files.
pub fn unlisted(error: PresetError) -> Fault {
    match error {
        PresetError::Unknown { kind, name, known } => {
            unknown(if kind == "steels" { "steel" } else { kind }, &name, &known)
        }
        error => Fault::internal(error),
    }
}

/// The gears called `name`, or all.
///
/// # Errors
/// When the library has no gears of this name.
pub fn gears_named(name: Option<&str>) -> Result<Vec<GearPreset>, Fault> {
    Ok(match name {
        Some(name) => vec![gear(name).map_err(unlisted)?],
        None => gears().map_err(unlisted)?,
    })
}

/// The steel called `name`, or all.
///
/// # Errors
/// When the library has no steel of this name.
pub fn steels_named(name: Option<&str>) -> Result<Vec<SteelPreset>, Fault> {
    Ok(match name {
        Some(name) => vec![steel(name).map_err(unlisted)?],
        None => steels().map_err(unlisted)?,
    })
}

/// The oil called `name`, in upper or lower case.
///
/// # Errors
/// When the library has no oil of this name.
pub fn oil_named(name: &str) -> Result<LibraryOil, Fault> {
    let mut oils = library().map_err(Fault::internal)?;
    let is_named = |oil: &LibraryOil| oil.name.eq_ignore_ascii_case(name.trim());
    match oils.iter().position(is_named) {
        Some(index) => Ok(oils.swap_remove(index)),
        None => {
            let known: Vec<String> = oils.into_iter().map(|oil| oil.name).collect();
            Err(unknown("oil", name, &known))
        }
    }
}

/// The oil called `name`, or all.
///
/// # Errors
/// See [`oil_named`].
pub fn oils_named(name: Option<&str>) -> Result<Vec<LibraryOil>, Fault> {
    match name {
        Some(name) => Ok(vec![oil_named(name)?]),
        None => library().map_err(Fault::internal),
    }
}

/// Centre distance and transverse contact ratio that follow from the numbers of a preset.
///
/// # Errors
/// When the numbers make no gear pair.
pub fn pair_of(preset: &GearPreset) -> Result<(Length, f64), Fault> {
    let gears = &preset.gears;
    let tip = gears.tip_diameter.as_ref();
    let pair = GearPair::new(&GearPairInput {
        teeth: gears.teeth.value,
        module: gears.module.value,
        module_plane: Plane::Normal,
        helix: gears.helix.value,
        pressure_angle: gears.pressure_angle.value,
        face_width: gears.face_width.value,
        overlap: None,
        profile_shift: Some(gears.profile_shift.value),
        centre_distance: None,
        tip_radius: tip.map(|tip| tip.value.map(|diameter| diameter / 2.0)),
        addendum: 1.0,
    });
    let pair = pair.map_err(|error| Fault::internal(format!("{}: {error}", preset.name)))?;
    Ok((pair.centre_distance, pair.path.eps_alpha))
}

/// Flow pressure \[GPa\] and elastic limit \[MPa\] at the hardness of a steel.
///
/// # Errors
/// When the hardness is outside the range of the correlations.
pub fn strength(steel: &SteelPreset) -> Result<(f64, Option<f64>), Fault> {
    let hardness = steel.hardness.value;
    let flow = hardness.flow_pressure().map_err(Fault::internal)?;
    let limit = if steel.is_powder_metal() {
        None
    } else {
        Some(
            hardness
                .yield_strength()
                .map_err(Fault::internal)?
                .value
                .si()
                / 1e6,
        )
    };
    Ok((flow.si() / 1e9, limit))
}

/// Viscosity \[mPa s\] and α \[1/GPa\] of an oil of the library at 40 and 100 °C.
///
/// # Errors
/// When the oil has no state there.
pub fn states(name: &str) -> Result<[(f64, f64); 2], Fault> {
    let input = LubricantInput {
        oil: Some(name.to_owned()),
        ..LubricantInput::default()
    };
    let at = |celsius: f64| -> Result<(f64, f64), LubricantError> {
        let temperature = Temperature::from_celsius(celsius);
        // A viscosity without a temperature applies at the temperature of the case.
        let state = input.resolve(temperature)?.at(temperature)?.value;
        let alpha = state.pressure_viscosity.si() / 1e-9;
        Ok((state.dynamic_viscosity.si() / 1e-3, alpha))
    };
    let states = at(LISTED[0]).and_then(|cold| Ok([cold, at(LISTED[1])?]));
    states.map_err(Fault::internal)
}

/// Sources of the numbers.
///
/// # Errors
/// When the list of sources cannot be read.
pub fn used(rows: &[FigureRow<'_>]) -> Result<Vec<PresetSource>, Fault> {
    let keys: BTreeSet<&str> = rows.iter().map(|row| row.source).collect();
    let is_used = |source: &PresetSource| keys.contains(source.key.as_str());
    let sources = sources().map_err(Fault::internal)?;
    Ok(sources.into_iter().filter(is_used).collect())
}

/// Gears with their numbers, certainties and sources, as `asperity list gears --json` lists them.
///
/// # Errors
/// See [`pair_of`].
pub fn listed_gears(preset: &GearPreset) -> Result<Value, Fault> {
    let (distance, ratio) = pair_of(preset)?;
    Ok(json!({
        "name": preset.name,
        "title": preset.title,
        "note": preset.note,
        "preset": preset,
        "figures": preset.rows(),
        "centre_distance_mm": distance.si() * 1e3,
        "transverse_contact_ratio": ratio,
        "sources": used(&preset.rows())?,
    }))
}

/// A steel with its numbers, certainties and sources, as `asperity list steels --json` lists it.
///
/// # Errors
/// See [`strength`].
pub fn listed_steel(steel: &SteelPreset) -> Result<Value, Fault> {
    let (flow, limit) = strength(steel)?;
    Ok(json!({
        "name": steel.name,
        "number": steel.number,
        "treatment": steel.treatment,
        "note": steel.note,
        "figures": steel.rows(),
        "flow_pressure_gpa": flow,
        "elastic_limit_mpa": limit,
        "sources": used(&steel.rows())?,
    }))
}

/// An oil with its numbers, certainties and source, as `asperity list oils --json` lists it.
///
/// # Errors
/// See [`states`].
pub fn listed_oil(oil: &LibraryOil) -> Result<Value, Fault> {
    let [(cold, _), (hot, alpha)] = states(&oil.name)?;
    Ok(json!({
        "name": oil.name,
        "note": oil.note,
        "source": oil.source,
        "certainty": oil.certainty,
        "lubricant": oil.lubricant,
        "dynamic_viscosity_40_mpa_s": cold,
        "dynamic_viscosity_100_mpa_s": hot,
        "pressure_viscosity_100_per_gpa": alpha,
    }))
}
