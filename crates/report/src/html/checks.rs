//! The values that an engineer checks first: gears, oil at its temperature, contact, and mesh.

use asperity::oil::{FilmConstantName, Mark};
use asperity::result::loss_band::Digits;
use asperity::result::{FilmConstant, PositionRow, RunResult, Scope};
use asperity::uncertainty::UncertainParameter as Constant;
use asperity_core::quantity::{Angle, Length};
use maud::{Markup, html};

use super::band::values;
use super::temperatures;
use crate::{Column, Kind, Table, columns};

/// Name, value, and key in `result.json` of a number; an empty key for a number that is derived from several.
type CheckRow = (&'static str, String, &'static str);

pub(super) fn section(result: &RunResult) -> Markup {
    html! {
        div.checks {
            div { (gears(result)) }
            div { (rows("Contact", &contact(result))) }
            div { (rows("Mesh", &mesh(result))) }
        }
        (oil(result))
    }
}

fn rows(title: &str, rows: &[CheckRow]) -> Markup {
    html! {
        h3 { (title) }
        div.scroll { table { tbody {
            @for (name, value, key) in rows {
                tr { th scope="row" { (name) } td.number data-key=[(!key.is_empty()).then_some(key)] { (value) } }
            }
        } } }
    }
}

fn mm(length: Length) -> String {
    format!("{:.3} mm", 1e3 * length.si())
}

fn degrees(angle: Angle) -> String {
    format!("{:.3}°", angle.si().to_degrees())
}

fn gears(result: &RunResult) -> Markup {
    let gears = &result.gears;
    let path = &gears.path;
    let both = |of: &dyn Fn(usize) -> String| [of(0), of(1)];
    let shift = |gear: usize| {
        let shift = gears.profile_shift.map(|shift| shift[gear]);
        shift.map_or("–".to_owned(), |x| format!("{x:.4}"))
    };
    let height = |gear: usize| {
        let height = gears.tip_radius[gear].si() - gears.reference_radius[gear].si();
        // A ring has its teeth inside, and negative radii.
        format!("{:.3} mm", 1e3 * height)
    };
    let each = [
        ("teeth z", both(&|gear| gears.teeth[gear].to_string())),
        (
            "tip diameter d_a",
            both(&|gear| format!("{:.3} mm", 2e3 * gears.tip_radius[gear].si().abs())),
        ),
        ("tip height h_a", both(&height)),
        ("profile shift x", both(&shift)),
    ];
    let pair = [
        ("centre distance a", mm(gears.centre_distance)),
        ("normal module m_n", mm(gears.normal_module)),
        ("helix angle β", degrees(gears.helix)),
        ("face width in mesh b", mm(gears.face_width)),
        (
            "working transverse pressure angle α_wt",
            degrees(gears.working_pressure_angle),
        ),
        (
            "contact ratios ε_α and ε_β",
            format!("{:.3} and {:.3}", path.eps_alpha, path.eps_beta),
        ),
    ];
    let second = if gears.internal { "ring" } else { "wheel" };
    html! {
        h3 { "Gears" }
        (Table::new([
            Column::new(Kind::Head, "", "", each.iter().map(|(name, _)| name)),
            Column::new(Kind::Number, "pinion", "", each.iter().map(|(_, values)| &values[0])),
            Column::new(Kind::Number, second, "", each.iter().map(|(_, values)| &values[1])),
        ]))
        (columns! { row in &pair;
            head name "of the pair" "" = row.0;
            number value "" "" = &row.1;
        })
    }
}

/// The row where `of` is largest.
fn largest(result: &RunResult, of: fn(&PositionRow) -> f64) -> Option<&PositionRow> {
    let rows = result.path.iter();
    rows.max_by(|a, b| of(a).total_cmp(&of(b)))
}

fn contact(result: &RunResult) -> Vec<CheckRow> {
    let mut rows = Vec::new();
    if let Some(speed) = pitch_line_speed(result) {
        let force = result.summary.power_in_w / speed;
        rows.push(("tangential force F_t", format!("{force:.0} N"), ""));
        rows.push(("pitch-line speed", format!("{speed:.2} m/s"), ""));
    }
    let place = |row: &PositionRow| format!("{:.0} % of the path", 100.0 * row.path_fraction);
    if let Some(row) = largest(result, |row| row.hertz_pressure_mpa) {
        let value = format!("{:.0} MPa at {}", row.hertz_pressure_mpa, place(row));
        rows.push((
            "largest Hertz pressure p₀ of the positions, each at its load",
            value,
            "",
        ));
        let value = format!("{:.0} µm", row.half_width_um);
        rows.push(("half-width of the contact there", value, ""));
    }
    if let Some(row) = largest(result, |row| -row.film_central_um) {
        let film = [row.film_central_um, row.film_minimum_um];
        let [central, minimum] = film.map(|film| format!("{film:.3}"));
        let value = format!("{central} and {minimum} µm at {}", place(row));
        rows.push(("least film, central and minimum", value, ""));
    }
    let flash = |row: &PositionRow| row.flash_max_k;
    if let Some(row) = largest(result, flash) {
        let value = format!("{:.1} K at {}", flash(row), place(row));
        rows.push(("largest flash temperature of all offsets", value, ""));
        let contact = temperatures::bulk(result) + flash(row);
        rows.push((
            "largest contact temperature, there",
            format!("{contact:.0} °C"),
            "",
        ));
    }
    rows
}

/// Speed at the pitch circles \[m/s\]: the surface of the pinion moves in the contact with ω₁ s.
fn pitch_line_speed(result: &RunResult) -> Option<f64> {
    let row = result.path.iter().find(|row| row.s_mm > 0.0)?;
    let speed = row.u1_m_per_s / (1e-3 * row.s_mm);
    let speed = speed * result.gears.working_pitch_radius[0].si();
    (speed > 0.0).then_some(speed)
}

fn mesh(result: &RunResult) -> Vec<CheckRow> {
    let s = &result.summary;
    let scope = match s.scope {
        Scope::Mesh => "mesh only",
        Scope::Gearbox => "mesh and gearbox",
    };
    vec![
        ("scope", scope.to_owned(), "summary.scope"),
        (
            "power in",
            format!("{:.3} kW", 1e-3 * s.power_in_w),
            "summary.power_in_w",
        ),
        (
            "torque out",
            format!("{:.2} N m", s.torque_out_nm),
            "summary.torque_out_nm",
        ),
        (
            "equivalent friction μ_eq",
            format!("{:.4}", s.mu_equivalent),
            "summary.mu_equivalent",
        ),
        (
            "loss factor H_V of the load over the teeth",
            format!("{:.4}", s.loss_factor_local),
            "summary.loss_factor_local",
        ),
        (
            "H_V by Ohlendorf",
            format!("{:.4}", s.loss_factor_ohlendorf),
            "summary.loss_factor_ohlendorf",
        ),
        (
            "positions on the path, offsets of the traces",
            format!("{}, {}", s.positions, s.offsets),
            "",
        ),
    ]
}

/// The oil at the temperature of film and friction, and its constants with their sources.
fn oil(result: &RunResult) -> Markup {
    let oil = &result.lubricant;
    let origin = |key: &str| {
        let mut defaults = result.defaults.iter();
        let default = defaults.find(|default| default.key == key);
        match default.map(|default| (&default.value, &default.source)) {
            None => "from the case".to_owned(),
            Some((value, None)) => value.clone(),
            Some((value, Some(source))) => format!("{value}: {source}"),
        }
    };
    let state = [
        (
            "dynamic viscosity η",
            format!("{:.3} mPa s", 1e3 * oil.dynamic_viscosity.si()),
            "kinematic viscosity and density".to_owned(),
        ),
        (
            "kinematic viscosity ν",
            format!("{:.3} mm²/s", 1e6 * oil.kinematic_viscosity.si()),
            origin("lubricant.viscosity"),
        ),
        (
            "density ρ",
            format!("{:.1} kg/m³", oil.density.si()),
            origin("lubricant.density"),
        ),
        (
            "pressure-viscosity coefficient α",
            format!("{:.2} 1/GPa", 1e9 * oil.pressure_viscosity.si()),
            origin("lubricant.pressure_viscosity"),
        ),
    ];
    let temperature = format!("{:.1} °C", oil.temperature.celsius());
    let drawn = result.uncertainty.iter().flat_map(|band| &band.constants);
    let alpha = { drawn }.find(|constant| constant.name == Constant::PressureViscosity.name());
    let of_alpha = alpha.map(|alpha| {
        let [_, low, high] = values(alpha);
        format!("{low} to {high}")
    });
    let none = || "–".to_owned();
    let bands = [none(), none(), none(), of_alpha.unwrap_or_else(none)];
    let state = state.into_iter().zip(bands);
    let state = state.map(|((name, value, source), band)| {
        [
            name.to_owned(),
            format!("{value} at {temperature}"),
            band,
            source,
        ]
    });
    let constants = result.film_constants.iter().map(|constant| {
        let [value, band] = texts(constant);
        let source = format!("{}{}", constant.constant.source, confidence(constant));
        [shown(constant.name).0.to_owned(), value, band, source]
    });
    html! {
        h3 { "Oil at " (temperature) }
        (columns! { row in state.chain(constants);
            head name "quantity" "" = &row[0];
            number value "value" "" = &row[1];
            number band "interval" "" = &row[2];
            text source "source" "" = &row[3];
        })
    }
}

/// Name of a constant in words, with the unit and the factor by which its value is shown.
const fn shown(name: FilmConstantName) -> (&'static str, &'static str, f64) {
    match name {
        FilmConstantName::LimitingShear => ("limiting shear stress over pressure", "", 1.0),
        FilmConstantName::EyringStress => ("Eyring stress", " MPa", 1e-6),
        FilmConstantName::LimitingShearTemperature => (
            "fall of the limiting shear stress with temperature",
            " 1/K",
            1.0,
        ),
        FilmConstantName::PressureViscosityFactor => {
            ("pressure-viscosity factor of the friction", "", 1.0)
        }
        FilmConstantName::Conductivity => ("thermal conductivity", " W/(m K)", 1.0),
        FilmConstantName::ConductivityRise => ("its rise with pressure", " 1/GPa", 1.0),
        FilmConstantName::ConductivityBend => ("the bend of that rise", " 1/GPa", 1.0),
        FilmConstantName::GoldFactor => ("factor of Gold's pressure-viscosity law", " 1/GPa", 1.0),
        FilmConstantName::GoldExponent => ("exponent of Gold's law", "", 1.0),
        FilmConstantName::BoundaryFriction => ("boundary friction", "", 1.0),
        FilmConstantName::BoundaryLayer => ("boundary layer", " nm", 1e9),
        FilmConstantName::Hysteresis => ("share of elastic energy lost by hysteresis", "", 1.0),
        _ => ("constant of another version", "", 1.0),
    }
}

/// Value and band of a constant as text.
fn texts(FilmConstant { name, constant, .. }: &FilmConstant) -> [String; 2] {
    let (_, unit, factor) = shown(*name);
    let number = |value: f64| match (constant.mark, constant.low, constant.high) {
        (Mark::Calibrated, Some(low), Some(high)) => {
            Digits::of_interval([factor * low, factor * high]).rounded(factor * value)
        }
        // Round-off of the conversion is not shown.
        _ => ((factor * value * 1e6).round() / 1e6).to_string(),
    };
    let band = match (constant.low, constant.high) {
        (Some(low), Some(high)) => format!("{} to {}{unit}", number(low), number(high)),
        _ => "–".to_owned(),
    };
    [format!("{}{unit}", number(constant.value)), band]
}

/// Confidence in a constant.
fn confidence(constant: &FilmConstant) -> &'static str {
    match constant.constant.mark {
        Mark::Seen => " (read there)",
        Mark::Calibrated => " (calibrated here)",
        Mark::Judged => " (assumed)",
    }
}
