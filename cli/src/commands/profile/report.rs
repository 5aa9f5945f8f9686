//! One profile as text and as JSON.

use std::fmt::Write as _;

use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::height_parameters::HeightParameters;
use serde_json::{Value, json};

use super::{Evaluated, um};
use crate::args::{PreparingArgs, name_of};

fn heights(p: &HeightParameters) -> Value {
    json!({
        "ra_um": um(p.ra), "rq_um": um(p.rq), "rz_um": um(p.rz), "rp_um": um(p.rp), "rv_um": um(p.rv),
        "rt_um": um(p.rt), "rz1max_um": um(p.rz1max), "rsk": p.rsk, "rku": p.rku,
        "rsm_um": p.rsm.map(um), "rc_um": p.rc.map(um), "rdq": p.rdq, "sections": p.sections,
    })
}

/// P and W parameters over the whole length, under names of their own.
fn whole(letter: &str, p: &HeightParameters) -> Value {
    let mut found = serde_json::Map::new();
    for (name, value) in [
        ("a_um", Some(um(p.ra))),
        ("q_um", Some(um(p.rq))),
        ("p_um", Some(um(p.rp))),
        ("v_um", Some(um(p.rv))),
        ("t_um", Some(um(p.rt))),
        ("sk", p.rsk),
        ("ku", p.rku),
        ("sm_um", p.rsm.map(um)),
        ("c_um", p.rc.map(um)),
        ("dq", Some(p.rdq)),
    ] {
        found.insert(format!("{letter}{name}"), json!(value));
    }
    Value::Object(found)
}

/// The report with the keys that scripts rely on.
pub fn json(found: &Evaluated) -> Value {
    let (reading, material) = (&found.reading, &found.iso4287.material);
    let spectral = &found.iso4287.spectral;
    let notes = found.warnings().into_iter();
    let notes: Vec<Value> = notes
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
        "preparation": found.parts.roughness.record,
        "section_um": um(found.section),
        "iso4287": heights(&found.iso4287.heights),
        "iso21920": heights(&found.iso21920.heights),
        "primary": whole("p", &found.primary),
        "waviness": found.waviness.as_ref().map(|p| whole("w", p)),
        "material_ratio": {
            "rk_um": um(material.rk), "rpk_um": um(material.rpk), "rvk_um": um(material.rvk),
            "mr1_percent": material.mr1, "mr2_percent": material.mr2,
        },
        "spectral": {
            "m0_um2": spectral.m0 * 1e12, "m2": spectral.m2, "m4_per_um2": spectral.m4 * 1e-12,
            "bandwidth": spectral.bandwidth(),
        },
        "warnings": notes,
    })
}

/// The report for reading.
pub fn text(found: &Evaluated, args: &PreparingArgs) -> String {
    let mut text = String::new();
    // Writing into a string cannot fail.
    let _ = write_file(&mut text, found);
    let _ = write_recipe(&mut text, found, args);
    let _ = write_parameters(&mut text, found);
    let _ = write_printed(&mut text, found);
    for warning in found.warnings() {
        let _ = writeln!(text, "  {} {warning}", warning.code());
    }
    text
}

fn write_file(text: &mut String, found: &Evaluated) -> std::fmt::Result {
    let reading = &found.reading;
    writeln!(text, "{}", reading.name)?;
    let encoding = reading.encoding.map_or(String::new(), |e| format!(", {e}"));
    writeln!(
        text,
        "  {}{encoding}, heights in {}; {} points, dx {} ({}), length {}",
        reading.format,
        reading.z_unit,
        reading.points,
        rounded(reading.spacing),
        name_of(&reading.spacing_source),
        rounded(reading.length)
    )?;
    let facts = &reading.metadata;
    let stated = [
        ("instrument", facts.instrument.clone()),
        ("date", facts.date.clone()),
        ("title", facts.title.clone()),
        (
            "nominal length",
            facts.nominal_length.map(|l| l.to_string()),
        ),
        ("lambda_c", facts.lambda_c.map(|l| l.to_string())),
        ("lambda_s", facts.lambda_s.map(|l| l.to_string())),
        ("filter state", Some(name_of(&reading.filter_state))),
    ];
    let known = stated
        .into_iter()
        .filter_map(|(name, value)| Some(format!("{name} {}", value?)));
    writeln!(text, "  stated: {}", known.collect::<Vec<_>>().join(", "))
}

fn write_recipe(text: &mut String, found: &Evaluated, args: &PreparingArgs) -> std::fmt::Result {
    let record = &found.parts.roughness.record;
    let recipe = &record.recipe;
    let cutoff = |value: Option<Length>| value.map_or("none".to_owned(), |v| v.to_string());
    writeln!(
        text,
        "  form {}, lambda_s {}, lambda_c {} ({}), ends {}, {} sections of {}{}",
        name_of(&recipe.form),
        cutoff(recipe.lambda_s),
        cutoff(recipe.lambda_c),
        name_of(&record.filter),
        name_of(&recipe.ends),
        found.iso4287.heights.sections,
        rounded(found.section),
        if args.as_is { " (as is)" } else { "" },
    )
}

fn write_parameters(text: &mut String, found: &Evaluated) -> std::fmt::Result {
    let names = ["Ra", "Rq", "Rz", "Rp", "Rv", "Rt", "Rc"];
    write!(text, "  {:10}", "um")?;
    for name in names {
        write!(text, " {name:>9}")?;
    }
    writeln!(text, " {:>8} {:>8} {:>9} {:>8}", "Rsk", "Rku", "RSm", "Rdq")?;
    let row = |text: &mut String, name: &str, p: &HeightParameters| {
        write!(text, "  {name:10}")?;
        for value in [p.ra, p.rq, p.rz, p.rp, p.rv, p.rt] {
            write!(text, " {:>9.4}", um(value))?;
        }
        let number = |value: Option<f64>, digits| {
            value.map_or("none".to_owned(), |v| format!("{v:.digits$}"))
        };
        writeln!(
            text,
            " {:>9} {:>8} {:>8} {:>9} {:>8.4}",
            number(p.rc.map(um), 4),
            number(p.rsk, 3),
            number(p.rku, 3),
            number(p.rsm.map(um), 3),
            p.rdq
        )
    };
    row(text, "R iso4287", &found.iso4287.heights)?;
    row(text, "R iso21920", &found.iso21920.heights)?;
    row(text, "P (whole)", &found.primary)?;
    if let Some(waviness) = &found.waviness {
        row(text, "W (whole)", waviness)?;
    }
    write_material(text, &found.iso4287)
}

fn write_material(text: &mut String, found: &Parameters) -> std::fmt::Result {
    let (m, s) = (&found.material, &found.spectral);
    writeln!(
        text,
        "  Rk {:.4}  Rpk {:.4}  Rvk {:.4} um  Mr1 {:.2}  Mr2 {:.2} % (least-squares line)",
        um(m.rk),
        um(m.rpk),
        um(m.rvk),
        m.mr1,
        m.mr2
    )?;
    writeln!(
        text,
        "  m0 {:.5} um2  m2 {:.5}  m4 {:.5} 1/um2  bandwidth {}",
        s.m0 * 1e12,
        s.m2,
        s.m4 * 1e-12,
        s.bandwidth()
            .map_or("none".to_owned(), |b| format!("{b:.2}"))
    )
}

/// What the instrument printed, beside ours where it is the same parameter.
fn write_printed(text: &mut String, found: &Evaluated) -> std::fmt::Result {
    for printed in &found.reading.metadata.printed {
        let ours = value_of(&printed.name, found);
        let ours = ours.map_or("not computed".to_owned(), |v| {
            format!("{v:.0$}", printed.decimals.max(3))
        });
        writeln!(
            text,
            "  printed {:6} {:>12.*} {:3} ours {ours}",
            printed.name, printed.decimals, printed.value, printed.unit
        )?;
    }
    Ok(())
}

/// Our value of a parameter by its printed name, in um, percent or as a number.
fn value_of(name: &str, found: &Evaluated) -> Option<f64> {
    let (r, m) = (&found.iso4287.heights, &found.iso4287.material);
    let (p, w) = (&found.primary, found.waviness.as_ref());
    Some(match name {
        "Ra" => um(r.ra),
        "Rq" => um(r.rq),
        "Rz" => um(r.rz),
        "Rp" => um(r.rp),
        "Rv" => um(r.rv),
        "Rt" => um(r.rt),
        "Rc" => um(r.rc?),
        "RSm" => um(r.rsm?),
        "Rsk" => r.rsk?,
        "Rku" => r.rku?,
        "RDq" | "Rdq" => r.rdq,
        "Rmax" | "Rz1max" | "Rzx" => um(r.rz1max),
        "Rk" => um(m.rk),
        "Rpk" => um(m.rpk),
        "Rvk" => um(m.rvk),
        "Mr1" => m.mr1,
        "Mr2" => m.mr2,
        "Pa" => um(p.ra),
        "Pq" => um(p.rq),
        "Pt" => um(p.rt),
        "Wa" => um(w?.ra),
        "Wq" => um(w?.rq),
        "Wt" => um(w?.rt),
        _ => return None,
    })
}

/// A length with seven digits: what is left out is rounding.
fn rounded(length: Length) -> Length {
    let text = format!("{:.6e}", length.si());
    Length::from_si(text.parse().unwrap_or(length.si()))
}
