//! What is drawn against the tables that it was drawn from.

use std::path::Path;

use serde_json::Value;

use crate::chromium;
use crate::looks::first_look;
use crate::pages::{self, Page};

/// A table by its columns.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn read(folder: &Path, file: &str) -> Self {
        let mut reader = csv::Reader::from_path(folder.join(file)).unwrap();
        let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
        Self {
            header: cells(reader.headers().unwrap()),
            rows: reader.records().map(|row| cells(&row.unwrap())).collect(),
        }
    }

    fn index(&self, name: &str) -> usize {
        let found = self.header.iter().position(|column| column == name);
        found.unwrap_or_else(|| panic!("{name} in {:?}", self.header))
    }

    /// Rows whose cell in `column` is `text`, or the same number.
    fn with(mut self, column: &str, text: &str) -> Self {
        let index = self.index(column);
        let same = |cell: &str| match (cell.parse::<f64>(), text.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() < 0.5,
            _ => cell == text,
        };
        self.rows.retain(|row| same(&row[index]));
        self
    }

    /// The rows with one of these texts in `column`.
    fn of(mut self, column: &str, texts: &[&str]) -> Self {
        let index = self.index(column);
        self.rows.retain(|row| texts.contains(&row[index].as_str()));
        self
    }

    /// Numbers of a column; NaN where a cell is empty.
    fn column(&self, name: &str) -> Vec<f64> {
        let index = self.index(name);
        let cells = self.rows.iter().map(|row| row[index].as_str());
        cells
            .map(|cell| {
                if cell.is_empty() {
                    f64::NAN
                } else {
                    cell.parse().unwrap()
                }
            })
            .collect()
    }

    /// Numbers of several columns, row by row.
    fn map<const N: usize>(&self, names: [&str; N], of: impl Fn([f64; N]) -> f64) -> Vec<f64> {
        let columns = names.map(|name| self.column(name));
        let row = |k: usize| std::array::from_fn(|column| columns[column][k]);
        (0..self.rows.len()).map(|k| of(row(k))).collect()
    }
}

/// Lowest and highest of the values that there are.
fn ends(values: &[f64]) -> [f64; 2] {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    })
}

fn positive(values: Vec<f64>) -> Vec<f64> {
    values.into_iter().filter(|value| *value > 0.0).collect()
}

fn json(folder: &Path, file: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join(file)).unwrap()).unwrap()
}

fn numbers(values: &Value) -> Vec<f64> {
    values
        .as_array()
        .unwrap()
        .iter()
        .map(|value| value.as_f64().unwrap())
        .collect()
}

/// Ends of the cells of a trace whose loss per length lies between the bounds that a curve names: "100 to 300", "above 300".
fn of_strip(ridges: &Value, chart: &str, curve: &str) -> Vec<f64> {
    let strip = match chart.split_once('-').unwrap() {
        ("watts", "pinion") => &ridges["along"][0],
        ("watts", _) => &ridges["along"][1],
        (_, number) => &ridges["near"][number.parse::<usize>().unwrap() - 1],
    };
    let bound = |text: &str| text.replace('−', "-").parse::<f64>().unwrap();
    let words: Vec<&str> = curve.split(' ').collect();
    let [low, high] = match words[..] {
        ["below", high] => [f64::NEG_INFINITY, bound(high)],
        ["above", low] => [bound(low), f64::INFINITY],
        [low, _, high, ..] => [low, high].map(bound),
        _ => panic!("{curve} names no bounds"),
    };
    // A bound belongs to the side that is farther from zero.
    let is_within = |w: f64| {
        let is_above = w > low || (w == low && low > 0.0);
        is_above && (w < high || (w == high && high < 0.0))
    };
    let cells = strip["cells"].as_array().unwrap().iter().map(numbers);
    let cells = cells.filter(|cell| is_within(cell[2]));
    cells.flat_map(|cell| [cell[0], cell[1]]).collect()
}

/// Energies \[Wh\] that the points of a cycle at each torque lose with a finish, and none at other torques.
fn by_torque(cycle: &Table) -> Vec<f64> {
    let [times, torques, losses] = ["time_s", "torque_nm", "loss_w"].map(|name| cycle.column(name));
    let last = times.len() - 1;
    let energy = |k: usize| {
        let weight = 0.5 * (times[(k + 1).min(last)] - times[k.saturating_sub(1)]);
        losses[k] * weight / 3600.0
    };
    let sum = |torque: &f64| -> f64 {
        let points = (0..=last).filter(|k| torques[*k] == *torque);
        points.map(energy).sum()
    };
    let sums = torques.iter().map(sum);
    std::iter::once(0.0).chain(sums).collect()
}

/// Values of a curve in the tables of a gear train.
fn of_set(folder: &Path, chart: &str) -> Vec<f64> {
    match chart {
        "meshes" => Table::read(folder, "meshes.csv").column("loss_w"),
        _ => {
            let whole = json(folder, "planetary.json");
            let kinds = whole["kinds"].as_object().unwrap().values();
            let kinds = kinds.map(|kind| kind.as_f64().unwrap());
            kinds.filter(|kind| *kind > 0.0).collect()
        }
    }
}

/// Values of a curve in the tables of a report; none for lines that no table holds: constants and constructions.
fn of_report(folder: &Path, chart: &str, curve: &str) -> Option<Vec<f64>> {
    let path = Table::read(folder, "path.csv");
    let along = |column: &str| Some(path.column(column));
    let page = json(folder, "page.json");
    let position = page["contact"]["position"].as_u64().unwrap_or(1) as usize;
    let at = |column: &str| path.column(column)[position - 1];
    let surface = || Table::read(folder, &format!("position_{position:02}/surface.csv"));
    // Range that charts of the contact show, in half-widths.
    let near = |of: &dyn Fn(&Table) -> Vec<f64>| -> Vec<f64> {
        let table = surface();
        let pairs = table.column("x_um").into_iter().zip(of(&table));
        let shown = pairs.filter(|(x, _)| x.abs() <= 1.6 * at("half_width_um"));
        shown.map(|(_, value)| value).collect()
    };
    let scaled = |column: &str, factor: f64| {
        let values = near(&|table| table.column(column));
        Some(values.into_iter().map(|value| factor * value).collect())
    };
    let body = if chart.ends_with("wheel") {
        "wheel"
    } else {
        "pinion"
    };
    match (chart, curve) {
        ("trace-pinion" | "trace-wheel", _) => {
            let column = match curve {
                "as measured" => "measured_um",
                "form removed" => "form_removed_um",
                _ => "roughness_um",
            };
            Some(Table::read(folder, &format!("flank_{body}.csv")).column(column))
        }
        ("abbott-pinion" | "abbott-wheel", "material ratio") => {
            Some(Table::read(folder, &format!("abbott_{body}.csv")).column("height_um"))
        }
        // The construction of Rk.
        ("abbott-pinion" | "abbott-wheel", _) => None,
        ("psd", body) => {
            let flank = ["pinion", "wheel"].iter().position(|name| *name == body);
            let rows = page["flanks"][flank.unwrap()]["spectrum"].as_array();
            let densities = rows.unwrap().iter().map(|row| row["density_um3"].as_f64());
            Some(densities.map(Option::unwrap).collect())
        }
        ("load-share", _) => along("load_share"),
        ("pressure-path", _) => along("hertz_pressure_mpa"),
        ("speeds", "sliding V_s") => along("sliding_m_per_s"),
        ("speeds", _) => along("entrainment_m_per_s"),
        ("film", "central") => along("film_central_um"),
        ("film", _) => along("film_minimum_um"),
        ("lambda-star", _) => along("lambda_star"),
        ("friction", "whole contact") => along("mu"),
        ("friction", _) => along("mu_film"),
        ("temperatures", curve) if curve.starts_with("contact") => {
            let column = if curve.ends_with("hottest offset") {
                "flash_max_k"
            } else {
                "flash_k"
            };
            let result = json(folder, "result.json");
            let bulk = result["bulk"]["bulk_c"].as_f64().or_else(|| {
                let text = result["inputs"]["operation"]["bulk_temperature"].as_str()?;
                text.split(' ').next()?.parse().ok()
            });
            Some(
                path.column(column)
                    .into_iter()
                    .map(|flash| bulk.unwrap() + flash)
                    .collect(),
            )
        }
        // The same along the path.
        ("temperatures", _) => None,
        ("local-loss", "5 to 95 %") => {
            let drawn = &json(folder, "result.json")["uncertainty"];
            let rolling = path.column("rolling_w_per_m");
            let ends = drawn["path_sliding_w_per_m"].as_array().unwrap();
            let pairs = ends.iter().zip(rolling);
            Some(
                pairs
                    .flat_map(|(ends, rolling)| {
                        numbers(ends)
                            .into_iter()
                            .map(move |end| 1e-3 * (end + rolling))
                    })
                    .collect(),
            )
        }
        ("local-loss", curve) => {
            let names = ["film", "boundary layer", "lubricated asperities", "rolling"];
            let columns = [
                "film_w_per_m",
                "boundary_w_per_m",
                "lubricated_asperity_w_per_m",
                "rolling_w_per_m",
            ];
            let single = path.rows.len() < 2;
            let up_to =
                |count: usize| path.map(columns, |row| 1e-3 * row.iter().take(count).sum::<f64>());
            match names.iter().position(|name| *name == curve) {
                Some(k) if single => Some(path.map(columns, |row| 1e-3 * row[k])),
                // An area lies on the one before.
                Some(k) => Some([up_to(k), up_to(k + 1)].concat()),
                None => Some(up_to(4)),
            }
        }
        ("load", "contacts evaluated") => along("line_load_n_per_mm"),
        ("load", curve) => {
            let column = match curve {
                "mean over the face" => "mean_n_per_mm",
                "highest" => "highest_n_per_mm",
                _ => "lowest_n_per_mm",
            };
            Some(Table::read(folder, "load.csv").column(column))
        }
        ("load-map", _) => Some(Table::read(folder, "load_map.csv").column("load_n_per_mm")),
        ("flanks-change", "pinion") => scaled("plastic_pinion_um", -1e3),
        ("flanks-change", _) => scaled("plastic_wheel_um", -1e3),
        ("pressure", "asperities") => Some(surface().column("pressure_solid_mpa")),
        ("pressure", "fluid") => Some(surface().column("pressure_fluid_mpa")),
        ("pressure", _) => Some(surface().column("pressure_hertz_mpa")),
        ("von-mises", _) => {
            let table = Table::read(folder, &format!("position_{position:02}/subsurface.csv"));
            let reach = 1.6 * at("half_width_um");
            Some(table.map(
                ["x_um", "depth_um", "von_mises_mpa"],
                |[x, depth, stress]| {
                    if x.abs() <= reach && depth <= reach {
                        stress
                    } else {
                        f64::NAN
                    }
                },
            ))
        }
        ("patch-pressure" | "patch-losses", _) => {
            let table = Table::read(folder, &format!("position_{position:02}/patch.csv"));
            let reach = 1.6 * at("half_width_um");
            let column = match chart {
                "patch-pressure" => "pressure_mpa",
                _ => "spot_loss_mw",
            };
            let shown = table.map(["x_um", column], |[x, value]| {
                if x.abs() <= reach { value } else { f64::NAN }
            });
            // Where the flanks stay apart, no loss is drawn.
            Some(match chart {
                "patch-pressure" => shown,
                _ => positive(shown),
            })
        }
        ("scan-rows", _) => {
            let rows = Table::read(folder, "scan_rows.csv").with("flank", curve);
            Some(rows.column("loss_w"))
        }
        ("scan-share" | "scan-flow", _) => {
            let of = if curve == "patch" { "patch" } else { "lines" };
            let kind = chart.trim_start_matches("scan-");
            Some(Table::read(folder, "scan_gaps.csv").column(&format!("{kind}_{of}")))
        }
        ("facing", "hertz") => Some(vec![0.0, at("hertz_pressure_mpa")]),
        ("facing", "solid" | "fluid") => {
            let table = surface();
            let column = format!("pressure_{curve}_mpa");
            Some(table.map(["x_um", &column], |[x, p]| {
                if x.abs() <= 1.5 * at("half_width_um") {
                    p
                } else {
                    f64::NAN
                }
            }))
        }
        ("facing", curve) => {
            let column = if curve == "lower" {
                "pinion_um"
            } else {
                "wheel_um"
            };
            let views = page["views"].as_array().unwrap();
            let shown = views
                .iter()
                .find(|view| view["position"] == position)
                .unwrap();
            Some(numbers(&shown[column]))
        }
        ("band", _) => {
            let loss = &json(folder, "result.json")["uncertainty"]["loss"];
            let parts = loss["parts"].as_array().unwrap().iter();
            let ends = std::iter::once(loss).chain(parts);
            Some(
                ends.flat_map(|part| numbers(&part["quantiles_w"]))
                    .collect(),
            )
        }
        (chart, _) if chart.starts_with("watts-") => Some(of_strip(
            &json(folder, "result.json")["ridges"],
            chart,
            curve,
        )),
        other => panic!("no table is known for {other:?} of a report"),
    }
}

/// Values of a curve in the tables of a study.
fn of_study(folder: &Path, page: &str, chart: &str, curve: &str) -> Option<Vec<f64>> {
    let table = |file: &str| Table::read(folder, file);
    match (page, chart) {
        ("compared/compare.html", "losses") => Some(table("compare.csv").column("loss_w")),
        ("compared/compare.html", "parts") => Some(table("parts.csv").column("loss_w")),
        ("compared/compare.html", "components") => {
            let ends = ["loss_p05_w", "loss_p95_w"];
            Some(table("components.csv").map(ends, |[low, high]| 0.5 * (high - low)))
        }
        ("compared/compare.html", "local-losses") => {
            let name = curve.trim_end_matches(", 5 to 95 %");
            let own = table("path.csv").with("finish", name);
            let columns: &[&str] = if name == curve {
                &["loss_w_per_m"]
            } else {
                &["loss_p05_w_per_m", "loss_p95_w_per_m"]
            };
            let values = columns.iter().flat_map(|column| own.column(column));
            Some(values.map(|value| 1e-3 * value).collect())
        }
        ("compared/compare.html", chart) if chart.contains('-') && !chart.starts_with("loss-") => {
            let (kind, flank) = chart.split_once('-').unwrap();
            let own = table(&format!("{kind}.csv")).with("finish", curve);
            let column = match kind {
                "traces" => "roughness_um",
                _ => "density_um3",
            };
            Some(own.with("flank", flank).column(column))
        }
        ("compared/compare.html", _) => {
            Some(table("offsets.csv").with("finish", curve).column("loss_w"))
        }
        ("map/map.html", chart) => {
            let map = table("map.csv");
            Some(match chart.split('-').next().unwrap() {
                "efficiency" => {
                    table("efficiency.csv").map(["efficiency"], |[value]| 100.0 * value)
                }
                "interval" => map.map(
                    ["loss_p05_w", "loss_w", "loss_p95_w"],
                    |[low, median, high]| 50.0 * (high - low) / median,
                ),
                _ => map.column("loss_w"),
            })
        }
        ("driven/cycle.html", "time") => {
            Some(table("cycle.csv").with("finish", curve).column("loss_w"))
        }
        ("driven/cycle.html", "torque") => {
            Some(by_torque(&table("cycle.csv").with("finish", curve)))
        }
        ("driven/cycle.html", _) => {
            Some(Table::read(&folder.join("../map"), "map.csv").column("loss_w"))
        }
        // Signed: where the loss falls, the bars are left of zero.
        ("changed/sensitivity.html", chart) => {
            let groups: &[&str] = match chart {
                "uncertain" => &["boundary layer", "filters"],
                _ => &["flanks", "oil", "gears"],
            };
            Some(
                table("sensitivity.csv")
                    .of("group", groups)
                    .column("difference_w"),
            )
        }
        ("pressed/ridges.html", "ridges") => Some(table("ridges.csv").column("mean_gradient_w")),
        ("pressed/ridges.html", "octaves") => {
            let octaves = table("octaves.csv");
            Some(octaves.map(["pinion_w", "wheel_w"], |[pinion, wheel]| pinion + wheel))
        }
        // Coloured cells of the traces: no curve is a whole column.
        ("pressed/ridges.html", chart) => {
            Some(of_strip(&json(folder, "ridges.json"), chart, curve))
        }
        ("limited/callout.html", "traces") => Some(table("traces.csv").column("limit_over_recipe")),
        ("limited/callout.html", _) if curve.starts_with("5 to 95 %") => {
            let curve = table("curve.csv");
            let [low, high] = ["loss_p05_w", "loss_p95_w"].map(|name| curve.column(name));
            // Of the ends of the curve one side of the scatter is not known, and nothing is drawn.
            let both = low.into_iter().zip(high);
            let both = both.filter(|(low, high)| low.is_finite() && high.is_finite());
            Some(both.flat_map(|(low, high)| [low, high]).collect())
        }
        ("limited/callout.html", _) => Some(table("curve.csv").column("loss_w")),
        ("swept/sweep.html", chart) if chart.contains("-over-") => {
            let (output, axis) = chart.split_once("-over-").unwrap();
            assert_eq!(axis, "operation-torque");
            let values = table("sweep.csv").column(output);
            let factor = if output == "efficiency" { 100.0 } else { 1.0 };
            let values = values.into_iter().map(|value| factor * value);
            (curve != "mean").then(|| values.collect())
        }
        ("swept/sweep.html", chart) => {
            let output = chart.trim_start_matches("tornado-");
            let own = table("effects.csv").with("output", output);
            let factor = if output == "efficiency" { 100.0 } else { 1.0 };
            Some(own.map(["difference"], |[value]| factor * value))
        }
        ("design/design.html", _) => Some(
            table("design.csv")
                .with("temperature_c", celsius(curve))
                .column("torque_nm"),
        ),
        ("found/calibration.html", "measured") => Some(match curve {
            "equal" => [
                table("points.csv").column("measured_w"),
                table("points.csv").column("fitted_w"),
            ]
            .concat(),
            _ => table("points.csv")
                .with("temperature_c", celsius(curve))
                .column("measured_w"),
        }),
        ("found/calibration.html", chart) if chart.starts_with("over-") => Some(
            table("points.csv")
                .with("temperature_c", celsius(curve))
                .column("residual_sigma"),
        ),
        ("found/calibration.html", chart) => {
            let found = json(folder, "calibration.json");
            let all = found["parameters"].as_array().unwrap();
            let key = chart.trim_start_matches("profile-");
            let one = all.iter().find(|one| one["key"] == key).unwrap();
            let profile = one["profile"].as_array().unwrap();
            Some(
                profile
                    .iter()
                    .map(|pair| pair[1].as_f64().unwrap())
                    .collect(),
            )
        }
        // The guide to the boundary friction is in no table.
        ("traction/traction.html", _) if curve.starts_with("guide") => None,
        ("traction/traction.html", chart) => {
            let file = match chart {
                "over-slide" => "traction_over_slide_to_roll.csv",
                _ => "traction_over_speed.csv",
            };
            let at = curve.trim_start_matches("5 to 95 %, ");
            let own = table(file).with("temperature_c", celsius(at));
            let columns: &[&str] = if at == curve {
                &["traction"]
            } else {
                &["traction_p05", "traction_p95"]
            };
            Some(
                columns
                    .iter()
                    .flat_map(|column| own.column(column))
                    .collect(),
            )
        }
        ("oil/oil_fit.html", chart) => Some(match chart.strip_prefix("curves-") {
            Some(at) => {
                let own = table("points.csv").with("temperature_c", at);
                own.column(if curve == "fit" { "fitted" } else { "traction" })
            }
            None => table("points.csv").column("residual_sigma"),
        }),
        ("measure/evidence.html", _) => {
            let left = table("evidence.csv");
            let now = numbers(&json(folder, "evidence.json")["loss"]["quantiles_w"]);
            Some([now, left.column("low_w"), left.column("high_w")].concat())
        }
        ("planned/oil_plan.html", _) => {
            const NAMES: [(&str, &str); 4] = [
                ("Eyring stress", "eyring_stress"),
                ("limiting shear stress over pressure", "limiting_shear"),
                (
                    "fall of the limiting shear stress",
                    "limiting_shear_temperature",
                ),
                ("pressure-viscosity factor", "pressure_viscosity_factor"),
            ];
            let (_, key) = NAMES.iter().find(|(name, _)| *name == curve).unwrap();
            let errors = table("expected_errors.csv").with("key", key);
            let errors = errors.column("standard_deviation");
            // The chosen points, which the table has last, are no stage of the standard plan.
            let (_, stages) = errors.split_last().unwrap();
            let before = stages[0];
            Some(stages.iter().map(|error| 100.0 * error / before).collect())
        }
        ("rubbed/stribeck.html", _) => {
            let rubbing_s = match curve {
                "before rubbing" => "0",
                _ => "3600",
            };
            let points = table("points.csv").with("rubbing_s", rubbing_s);
            Some(points.column("traction"))
        }
        ("change/change.html", "material-ratio") => {
            Some(table("material_ratio.csv").column(&format!("{curve}_um")))
        }
        // A part of the trace.
        ("change/change.html", "close-up") => None,
        ("change/change.html", chart) => {
            let own = table(&format!("{}.csv", chart.replace('-', "_")));
            Some(match curve {
                // From the lower of both traces up to the first.
                "lost" => [own.column("before_um"), own.column("after_um")].concat(),
                _ => own.column(&format!("{curve}_um")),
            })
        }
        // The page of a film holds its numbers itself.
        ("film.html", _) => None,
        other => panic!("no table is known for {other:?}"),
    }
}

/// The number of "90 °C".
fn celsius(curve: &str) -> &str {
    curve.trim_end_matches(" °C")
}

/// Values of a curve, by its number, in the tables of the paper's figures.
fn of_figure(folder: &Path, figure: &str, curve: &str) -> Option<Vec<f64>> {
    let table = |file: &str| Table::read(folder, file);
    let pick = |file: &str, columns: &[&str]| {
        let number: usize = curve.parse().unwrap();
        Some(table(file).column(columns[number]))
    };
    const SURFACE: &str = "fig09_fig10_surface.csv";
    const PRESSURES: [&str; 3] = [
        "pressure_solid_mpa",
        "pressure_fluid_mpa",
        "pressure_hertz_mpa",
    ];
    match figure {
        "fig06a_surfaces" => pick(
            "fig06_surface.csv",
            &["height_first_um", "height_second_um"],
        ),
        "fig06b_deformation" => pick(
            "fig06_surface.csv",
            &["gap_undeformed_um", "gap_um", "displacement_um"],
        ),
        "fig06c_contact_stress" => {
            pick("fig06_surface.csv", &["pressure_mpa", "pressure_hertz_mpa"])
        }
        "fig06d_subsurface" => Some(table("fig06_subsurface.csv").column("von_mises_mpa")),
        "fig07a_lubricants" => {
            let densities = ["750", "850", "950", "1050", "1150"];
            let own = table("fig07_lubricants.csv").with(
                "density_kg_per_m3",
                densities[curve.parse::<usize>().unwrap()],
            );
            Some(own.map(["difference_paper_pa"], |[p]| p.abs()))
        }
        "fig07b_efficiency" => {
            let number: usize = curve.parse().unwrap();
            let own = table("fig07_lubricants.csv")
                .with("density_kg_per_m3", ["750", "1150"][number / 2]);
            Some(own.column(["efficiency_with_percent", "efficiency_without_percent"][number % 2]))
        }
        "fig08a_pitch" | "fig08b_sliding" => {
            let column = ["paper_pa", "reynolds_cross_pa"][curve.parse::<usize>().unwrap()];
            Some(table(&format!("{figure}.csv")).map([column], |[p]| p.abs()))
        }
        "fig09c_change" => {
            let column = ["plastic_pinion_um", "plastic_wheel_um"][curve.parse::<usize>().unwrap()];
            Some(table(SURFACE).map([column], |[um]| -1e3 * um))
        }
        "fig10a_contact_stress" => pick(SURFACE, &PRESSURES),
        "fig10c_contact_stress_reflected" => pick("fig10c_surface.csv", &PRESSURES),
        "fig10b_contact_stress_near" => {
            let column = PRESSURES[curve.parse::<usize>().unwrap()];
            Some(table(SURFACE).map(["x_um", column], |[x, p]| {
                if (-110.0..=-70.0).contains(&x) {
                    p
                } else {
                    f64::NAN
                }
            }))
        }
        "fig11a_subsurface" | "fig11b_subsurface_near" => {
            Some(table("fig11_subsurface.csv").column("von_mises_mpa"))
        }
        "fig12a_in_contact" => Some(table("fig12_losses.csv").column("in_contact_w")),
        "fig12b_after_contact" => Some(table("fig12_losses.csv").column("after_contact_w")),
        "fig12c_every_engagement" => Some(table("fig12_losses.csv").column("every_engagement_w")),
        "fig13a_load" => {
            let steps = table("fig13_convergence.csv");
            Some(match curve {
                "0" => steps.map(["load_fluid_n_per_mm", "load_solid_n_per_mm"], |[a, b]| {
                    a + b
                }),
                _ => steps.column("load_fluid_n_per_mm"),
            })
        }
        "fig13b_convergence" => Some(positive(
            table("fig13_convergence.csv").column("load_error"),
        )),
        // Shifted by what their table does not hold. The profile has no table.
        "fig09a_touch" | "fig09b_load" | "profile" => None,
        other => panic!("no table is known for {other}"),
    }
}

fn expected(page: &Page, chart: &str, curve: &str) -> Option<Vec<f64>> {
    match page.name.as_str() {
        "figures" => of_figure(&page.folder, chart, curve),
        name if name.starts_with("report, ") => of_report(&page.folder, chart, curve),
        "planetary, set" => Some(of_set(&page.folder, chart)),
        // Its meshes have no tables of their fields.
        name if name.starts_with("planetary, ") => None,
        name => of_study(&page.folder, name, chart, curve),
    }
}

#[test]
fn drawn_extremes_are_those_of_the_tables() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let mut faults = Vec::new();
    let mut compared = 0;
    // The curves are read before the charts are driven.
    for (page, [opened, _]) in pages::all().iter().zip(first_look(browser)) {
        for drawn in opened.found["curves"].as_array().unwrap() {
            let text = |key: &str| drawn[key].as_str().unwrap();
            let (chart, curve) = (text("chart"), text("curve"));
            let Some(values) = expected(page, chart, curve) else {
                continue;
            };
            let [low, high] = ends(&values);
            compared += 1;
            let number = |key: &str| drawn[key].as_f64();
            // Ticks and points are placed to a tenth of a unit of the drawing.
            let near = |drawn: f64, due: f64| {
                (drawn - due).abs() <= 3.0 * number("worth").unwrap() + 1e-5 * due.abs()
            };
            let ends_are_near = match (number("low"), number("high")) {
                // A block of cells has its largest loss, and can hide the smallest spot.
                (Some(a), Some(b)) if chart == "patch-losses" => a >= low && near(b, high),
                (Some(a), Some(b)) => near(a, low) && near(b, high),
                // A field of a file of its own is read by its highest band.
                _ => true,
            };
            let levels: Vec<f64> = drawn["levels"].as_array().map_or(Vec::new(), |all| {
                // The label of a last band that is far wider is no number.
                all.iter().filter_map(serde_json::Value::as_f64).collect()
            });
            let reaches = match levels[..] {
                [.., before, last] => {
                    last <= high
                        && (chart.starts_with("efficiency")
                            // Each band is about three times as wide as the one below.
                            || (chart == "patch-losses" && high < 12.0 * last)
                            || high - last <= 1.001 * (last - before))
                }
                _ => true,
            };
            if !ends_are_near || !reaches || drawn["empty"].as_u64().unwrap_or(0) > 0 {
                faults.push(format!("{}: {drawn} for {low}..{high}", page.name));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(compared > 200, "{compared} curves were compared");
}

#[test]
fn a_map_leaves_blank_what_has_no_efficiency() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let mut all = pages::all().iter().zip(first_look(browser));
    let (_, [opened, _]) = all.find(|(page, _)| page.name == "map/map.html").unwrap();
    let curves = opened.found["curves"].as_array().unwrap();
    let field = curves
        .iter()
        .find(|drawn| drawn["chart"] == "efficiency-0-0")
        .unwrap();
    assert!(
        field["blank"].as_u64().unwrap() > 0 && field["empty"] == 0,
        "{field}"
    );
}
