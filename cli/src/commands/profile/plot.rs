//! `asperity profile plot`: a profile in four panels.

use std::path::{Path, PathBuf};

use asperity_core::Profile;
use asperity_report::chart::{Axis, Chart, Line, Series, stacked};
use asperity_report::profile_json::{height as of_height, um};
use asperity_roughness::material_ratio::{RkParameters, abbott_curve};
use asperity_roughness::spectral::{PowerSpectrum, power_spectrum};

use super::evaluated::{EvaluatedFile, refusal};
use crate::args::{Common, ProfilePlotArgs};
use crate::failure::Failure;
use crate::output::{besides_file, print_text, save, save_new};

/// `asperity profile plot`
pub fn plot(args: &ProfilePlotArgs, common: &Common) -> Result<(), Failure> {
    let evaluated = EvaluatedFile::new(&args.file, &args.preparing, &args.reading)?;
    let rough = &evaluated.parts.roughness.profile;
    let curve = abbott_curve(rough.heights())
        .map_err(|e| refusal(&evaluated.reading, &evaluated.plan, &e.into()))?;
    let density =
        power_spectrum(rough).map_err(|e| refusal(&evaluated.reading, &evaluated.plan, &e))?;
    let name = args
        .file
        .file_name()
        .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let name = format!("{name}: {}", evaluated.reading.format);
    let charts = [
        primary(&evaluated, &name),
        roughness(&evaluated, &name),
        material(&curve, &evaluated.iso4287.material, &name),
        spectrum(&density, &name),
    ];
    let svg = stacked(&name, &charts);
    let Some(output) = &args.output else {
        // Standard input has no name.
        let output = match args.file.as_path() {
            name if name == Path::new("-") => PathBuf::from("profile.svg"),
            name => name.with_extension("svg"),
        };
        save_new(&output, svg.as_bytes())?;
        return print_text(common, &format!("{}\n", output.display()));
    };
    let common = &besides_file(output, common)?;
    save(output, svg.as_bytes())?;
    print_text(common, &format!("{}\n", output.display()))
}

/// Positions in mm and heights in um, the first point at index `first` of the trace.
fn series(name: &str, line: Line, profile: &Profile, first: usize) -> Series {
    let dx = 1e3 * profile.spacing().si();
    let heights = profile.heights().iter().enumerate();
    let points = heights.map(|(i, z)| [(first + i) as f64 * dx, 1e6 * z]);
    Series::through(name, line, points)
}

fn along() -> Axis {
    Axis::new("position", "mm")
}

fn height() -> Axis {
    Axis::new("height", "µm")
}

fn primary(evaluated: &EvaluatedFile, source: &str) -> Chart {
    let title = "Primary profile P and mean line W";
    let chart = Chart::new("primary", title, source, along(), height());
    let chart = chart.with(series("P", Line::Solid, &evaluated.parts.primary, 0));
    let first = evaluated.parts.roughness.first_index;
    match &evaluated.parts.waviness {
        Some(waviness) => chart.with(series("W", Line::Solid, waviness, first)),
        None => chart,
    }
}

fn roughness(evaluated: &EvaluatedFile, source: &str) -> Chart {
    let p = &evaluated.iso4287.heights;
    let title = format!(
        "Roughness profile R: Ra {}, Rq {}, Rz {} µm (ISO 4287)",
        of_height(p.ra),
        of_height(p.rq),
        of_height(p.rz)
    );
    let first = evaluated.parts.roughness.first_index;
    let rough = series("R", Line::Solid, &evaluated.parts.roughness.profile, first);
    Chart::new("roughness", &title, source, along(), height()).with(rough)
}

/// Material ratio curve, its equivalent line and the triangles of Rpk and Rvk.
fn material(curve: &[f64], rk: &RkParameters, source: &str) -> Chart {
    let n = curve.len() as f64;
    let ratio = |k: usize| (k as f64 + 0.5) / n * 100.0;
    let points = curve.iter().enumerate();
    let points = points.map(|(k, z)| [ratio(k), 1e6 * z]);
    let (top, foot) = (um(rk.upper), um(rk.lower));
    let peak = top + um(rk.rpk);
    let peaks = [[0.0, top], [0.0, peak], [rk.mr1, top], [0.0, top]];
    let floor = foot - um(rk.rvk);
    let dales = [
        [rk.mr2, foot],
        [100.0, floor],
        [100.0, foot],
        [rk.mr2, foot],
    ];
    let title = format!(
        "Material ratio: Rk {}, Rpk {}, Rvk {} µm, Mr1 {:.1}, Mr2 {:.1} %",
        of_height(rk.rk),
        of_height(rk.rpk),
        of_height(rk.rvk),
        rk.mr1,
        rk.mr2
    );
    let share = Axis::new("material ratio", "%");
    Chart::new("material-ratio", &title, source, share, height())
        .with(Series::through("material ratio", Line::Solid, points))
        .with(Series::through(
            "equivalent line",
            Line::Dashed,
            [[0.0, top], [100.0, foot]],
        ))
        .with(Series::through("Rpk", Line::Solid, peaks))
        .with(Series::through("Rvk", Line::Solid, dales))
}

fn spectrum(density: &PowerSpectrum, source: &str) -> Chart {
    let lines = (1..density.density.len()).map(|k| {
        // Frequency in 1/mm; m³ are 1e18 µm³.
        let frequency = 1e-3 * k as f64 * density.frequency_step;
        [frequency, density.density[k] * 1e18]
    });
    let points = lines.filter(|[_, density]| *density > 0.0);
    let title = "Power spectral density of R (Hann window, one-sided)";
    let frequency = Axis::new("spatial frequency", "1/mm").log();
    Chart::new(
        "spectrum",
        title,
        source,
        frequency,
        Axis::new("density", "µm³").log(),
    )
    .with(Series::through("density", Line::Solid, points))
}
