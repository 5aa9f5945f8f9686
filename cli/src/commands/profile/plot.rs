//! `asperity profile plot`: a profile in four panels.

use std::path::{Path, PathBuf};

use asperity_core::Profile;
use asperity_roughness::material_ratio::{RkParameters, abbott_curve};
use asperity_roughness::spectral::power_spectrum;

use super::evaluated::{Evaluated, refusal, um};
use super::svg::{Curve, Panel, document};
use crate::args::{Common, ProfilePlotArgs};
use crate::failure::Failure;
use crate::output::{beside, print_text, save, save_new};

const GREY: &str = "#777777";
const BLUE: &str = "#1f5fa8";
const RED: &str = "#c0392b";
const GREEN: &str = "#2e7d32";

/// `asperity profile plot`
pub fn plot(args: &ProfilePlotArgs, common: &Common) -> Result<(), Failure> {
    let found = Evaluated::of(&args.file, &args.preparing, &args.reading)?;
    let rough = &found.parts.roughness.profile;
    let curve = abbott_curve(rough.heights())
        .map_err(|e| refusal(&found.reading, &found.plan, &e.into()))?;
    let spectrum = power_spectrum(rough).map_err(|e| refusal(&found.reading, &found.plan, &e))?;
    let lines = (1..spectrum.density.len()).map(|k| {
        // Wavelength in um; m³ are 1e18 um³.
        let wavelength = 1e6 / (k as f64 * spectrum.frequency_step);
        (wavelength, spectrum.density[k] * 1e18)
    });
    let spectrum = lines.filter(|(_, density)| *density > 0.0).collect();
    let name = args
        .file
        .file_name()
        .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let svg = document(
        &format!("{name}: {}", found.reading.format),
        &[
            primary(&found),
            roughness(&found),
            material(&curve, &found.iso4287.material),
            panel(
                "Power spectral density of R (Hann window, one-sided)",
                "wavelength, um",
                "C, um3",
                true,
                vec![line(spectrum, BLUE, "")],
            ),
        ],
    );
    let Some(output) = &args.output else {
        // Standard input has no name to go by.
        let output = match args.file.as_path() {
            name if name == Path::new("-") => PathBuf::from("profile.svg"),
            name => name.with_extension("svg"),
        };
        save_new(&output, svg.as_bytes())?;
        return print_text(common, &format!("{}\n", output.display()));
    };
    let common = &beside(output, common)?;
    save(output, svg.as_bytes())?;
    print_text(common, &format!("{}\n", output.display()))
}

fn panel(
    title: &str,
    x_label: &'static str,
    y_label: &'static str,
    logarithmic: bool,
    curves: Vec<Curve>,
) -> Panel {
    const HEIGHT: f64 = 260.0;
    Panel {
        title: title.to_owned(),
        x_label,
        y_label,
        logarithmic,
        height: HEIGHT,
        curves,
    }
}

fn line(points: Vec<(f64, f64)>, colour: &'static str, label: &'static str) -> Curve {
    Curve {
        points,
        colour,
        label,
        dashed: false,
    }
}

/// Positions in mm and heights in um, the first point at index `first` of the trace.
fn points(profile: &Profile, first: usize) -> Vec<(f64, f64)> {
    let dx = 1e3 * profile.spacing().si();
    let heights = profile.heights().iter().enumerate();
    heights
        .map(|(i, z)| ((first + i) as f64 * dx, 1e6 * z))
        .collect()
}

fn primary(found: &Evaluated) -> Panel {
    let mut curves = vec![line(points(&found.parts.primary, 0), GREY, "P")];
    let first = found.parts.roughness.first_index;
    if let Some(waviness) = &found.parts.waviness {
        curves.push(line(points(waviness, first), RED, "W"));
    }
    panel(
        "Primary profile P and mean line W",
        "x, mm",
        "z, um",
        false,
        curves,
    )
}

fn roughness(found: &Evaluated) -> Panel {
    let p = &found.iso4287.heights;
    let title = format!(
        "Roughness profile R: Ra {:.4}, Rq {:.4}, Rz {:.4} um (ISO 4287)",
        um(p.ra),
        um(p.rq),
        um(p.rz)
    );
    let first = found.parts.roughness.first_index;
    let curve = line(points(&found.parts.roughness.profile, first), BLUE, "");
    panel(&title, "x, mm", "z, um", false, vec![curve])
}

/// The curve, its equivalent line and the triangles of Rpk and Rvk.
fn material(curve: &[f64], rk: &RkParameters) -> Panel {
    let n = curve.len() as f64;
    let points = curve.iter().enumerate();
    let points = points
        .map(|(k, z)| ((k as f64 + 0.5) / n * 100.0, 1e6 * z))
        .collect();
    let (top, foot) = (um(rk.upper), um(rk.lower));
    let dashed = |points: Vec<(f64, f64)>, colour, label| Curve {
        points,
        colour,
        label,
        dashed: true,
    };
    let curves = vec![
        line(points, BLUE, "material ratio"),
        dashed(vec![(0.0, top), (100.0, foot)], RED, "equivalent line"),
        dashed(
            vec![
                (0.0, top),
                (rk.mr1, top),
                (0.0, top + um(rk.rpk)),
                (0.0, top),
            ],
            GREEN,
            "Rpk, Rvk",
        ),
        dashed(
            vec![
                (100.0, foot),
                (rk.mr2, foot),
                (100.0, foot - um(rk.rvk)),
                (100.0, foot),
            ],
            GREEN,
            "",
        ),
    ];
    let title = format!(
        "Rk {:.4}, Rpk {:.4}, Rvk {:.4} um, Mr1 {:.1}, Mr2 {:.1} %",
        um(rk.rk),
        um(rk.rpk),
        um(rk.rvk),
        rk.mr1,
        rk.mr2
    );
    panel(&title, "Mr, %", "z, um", false, curves)
}
