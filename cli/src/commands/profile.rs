//! `asperity profile info`: what a file holds, and its roughness.

use std::fmt::Write as _;
use std::path::Path;

use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, Prepared, prepare};
use asperity_roughness::read::{ReadOptions, Reading, read};
use asperity_roughness::{Parameters, Warning};
use serde_json::{Value, json};

use crate::args::{Common, ProfileInfoArgs, ReadingArgs, name_of};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// λc where none is asked for: the usual cut-off of Ra 0.1 to 2 µm.
const CUTOFF: Length = Length::from_si(0.8e-3);

struct Info {
    reading: Reading,
    prepared: Prepared,
    iso4287: Parameters,
    iso21920: Parameters,
}

/// `asperity profile info`
pub fn info(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    let mut reports = Vec::new();
    for file in &args.files {
        let info = look_at(file, args)?;
        if common.json {
            reports.push(as_json(&info));
        } else {
            print_text(common, &as_text(&info, args))?;
        }
    }
    match (common.json, reports.as_slice()) {
        (false, _) => Ok(()),
        (true, [one]) => print_json(one),
        (true, many) => print_json(many),
    }
}

fn look_at(file: &Path, args: &ProfileInfoArgs) -> Result<Info, Failure> {
    let reading = read(file, &options(&args.reading))
        .map_err(|error| Failure::new(error.code(), error.to_string()))?;
    let refused = |error: asperity_roughness::RoughnessError| {
        Failure::new("E120", format!("{}: {error}", file.display()))
    };
    let prepared = prepare(&reading.profile, &recipe(args)).map_err(refused)?;
    let section = section_length(args, &prepared);
    let of = |mode| Parameters::of(&prepared.profile, mode, section).map_err(refused);
    Ok(Info {
        iso4287: of(Mode::Iso4287)?,
        iso21920: of(Mode::Iso21920)?,
        reading,
        prepared,
    })
}

fn options(args: &ReadingArgs) -> ReadOptions {
    ReadOptions {
        x_unit: args.x_unit,
        z_unit: args.z_unit,
        dx: args.dx,
        columns: args.columns,
        decimal: args.decimal,
        separator: args.separator,
        encoding: args.encoding,
        gaps: args.gaps.unwrap_or_default(),
    }
}

fn recipe(args: &ProfileInfoArgs) -> Preparation {
    let usual = Preparation::default();
    if args.as_is || args.level {
        return Preparation {
            form: if args.as_is { Form::None } else { Form::Level },
            lambda_s: None,
            lambda_c: None,
            ..usual
        };
    }
    let kept = |given: Option<Length>, usual: Option<Length>| match given {
        None => usual,
        Some(length) => (length.si() > 0.0).then_some(length),
    };
    Preparation {
        form: args.form.unwrap_or(usual.form),
        lambda_s: kept(args.lambda_s, usual.lambda_s),
        lambda_c: kept(args.lambda_c, usual.lambda_c),
        ends: args.ends.unwrap_or(usual.ends),
    }
}

/// The cut-off; without a filter the trace is five sections.
fn section_length(args: &ProfileInfoArgs, prepared: &Prepared) -> Length {
    if args.as_is || args.level {
        return prepared.profile.spacing() * (prepared.profile.len() / 5) as f64;
    }
    args.lambda_c
        .filter(|cutoff| cutoff.si() > 0.0)
        .unwrap_or(CUTOFF)
}

fn warnings(info: &Info) -> Vec<&Warning> {
    let mut all: Vec<&Warning> = Vec::new();
    let lists = [
        &info.reading.warnings,
        &info.prepared.warnings,
        &info.iso4287.warnings,
    ];
    for warning in lists.into_iter().flatten() {
        if !all.contains(&warning) {
            all.push(warning);
        }
    }
    all
}

fn um(length: Length) -> f64 {
    length.si() * 1e6
}

fn heights(parameters: &Parameters) -> Value {
    let p = &parameters.heights;
    json!({
        "ra_um": um(p.ra), "rq_um": um(p.rq), "rz_um": um(p.rz), "rp_um": um(p.rp), "rv_um": um(p.rv),
        "rt_um": um(p.rt), "rz1max_um": um(p.rz1max), "rsk": p.rsk, "rku": p.rku,
        "rsm_um": p.rsm.map(um), "rc_um": p.rc.map(um), "rdq": p.rdq, "sections": p.sections,
    })
}

fn as_json(info: &Info) -> Value {
    let (reading, material) = (&info.reading, &info.iso4287.material);
    let spectral = &info.iso4287.spectral;
    let notes: Vec<Value> = warnings(info)
        .into_iter()
        .map(|w| json!({ "code": w.code(), "text": w.to_string() }))
        .collect();
    json!({
        "file": reading.name,
        "format": reading.format,
        "n": reading.points,
        "dx_um": um(reading.spacing),
        "length_um": um(reading.length),
        "filter_state": reading.filter_state,
        "reading": reading,
        "preparation": info.prepared.record,
        "iso4287": heights(&info.iso4287),
        "iso21920": heights(&info.iso21920),
        "material_ratio": {
            "rk_um": um(material.rk), "rpk_um": um(material.rpk), "rvk_um": um(material.rvk),
            "mr1_percent": material.mr1, "mr2_percent": material.mr2,
        },
        "spectral": { "m0_um2": spectral.m0 * 1e12, "m2": spectral.m2, "m4_per_um2": spectral.m4 * 1e-12 },
        "warnings": notes,
    })
}

fn as_text(info: &Info, args: &ProfileInfoArgs) -> String {
    let mut text = String::new();
    // Writing into a string cannot fail.
    let _ = write_text(&mut text, info, args);
    text
}

fn write_text(text: &mut String, info: &Info, args: &ProfileInfoArgs) -> std::fmt::Result {
    let reading = &info.reading;
    writeln!(text, "{}", reading.name)?;
    writeln!(
        text,
        "  {}, {}, heights in {}; {} points, dx {} ({}), length {}",
        reading.format,
        reading.encoding,
        reading.z_unit,
        reading.points,
        reading.spacing,
        name_of(&reading.spacing_source),
        reading.length
    )?;
    let recipe = &info.prepared.record.recipe;
    let cutoff = |value: Option<Length>| value.map_or("none".to_owned(), |v| v.to_string());
    writeln!(
        text,
        "  form {}, lambda_s {}, lambda_c {}, ends {}{}",
        name_of(&recipe.form),
        cutoff(recipe.lambda_s),
        cutoff(recipe.lambda_c),
        name_of(&recipe.ends),
        if args.as_is { " (as is)" } else { "" },
    )?;
    writeln!(
        text,
        "  {:10} {:>10} {:>10} {:>10} {:>10} {:>10} {:>8} {:>8} {:>10}",
        "um", "Ra", "Rq", "Rz", "Rp", "Rv", "Rsk", "Rku", "RSm"
    )?;
    for (mode, parameters) in [("iso4287", &info.iso4287), ("iso21920", &info.iso21920)] {
        let p = &parameters.heights;
        let number = |value: Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.3}"));
        writeln!(
            text,
            "  {mode:10} {:>10.4} {:>10.4} {:>10.4} {:>10.4} {:>10.4} {:>8} {:>8} {:>10}",
            um(p.ra),
            um(p.rq),
            um(p.rz),
            um(p.rp),
            um(p.rv),
            number(p.rsk),
            number(p.rku),
            number(p.rsm.map(um)),
        )?;
    }
    let m = &info.iso4287.material;
    writeln!(
        text,
        "  Rk {:.4}  Rpk {:.4}  Rvk {:.4} um  Mr1 {:.2}  Mr2 {:.2} %",
        um(m.rk),
        um(m.rpk),
        um(m.rvk),
        m.mr1,
        m.mr2
    )?;
    for warning in warnings(info) {
        writeln!(text, "  {} {warning}", warning.code())?;
    }
    Ok(())
}
