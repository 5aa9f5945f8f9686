//! Table of a rig: one row per measured point.
//!
//! | column | meaning |
//! |---|---|
//! | `torque_nm`, `speed_rpm` | torque and speed of the pinion |
//! | `temperature_c` | temperature of the oil at the mesh |
//! | `loss_w` or `torque_loss_nm` | measured loss, as power or as torque at the pinion |
//! | `sigma_w` | standard deviation of the loss as power |
//! | `includes` | `mesh`, `mesh+bearings` or `all` |
//! | `assembly`, `run`, `order` | assembly of the rig, run, order of measurement |
//! | `flank_state` | state of the flanks in words |
//! | `case` | case file of the row, relative to the table |
//!
//! The header is not case-sensitive; other columns are not read, and W454 names them. Lines that begin with `#` are comments.

use crate::error;
use std::f64::consts::PI;

use asperity_core::Fault;
use asperity_core::message::Warning;
use serde::{Deserialize, Serialize};

use asperity_table::{Row, RowFault, Table};

use crate::number_table;

/// Scope of a measured loss.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scope {
    /// Only the mesh: losses of bearings, seals and churning were subtracted.
    Mesh,
    /// Mesh and the load-dependent losses of the bearings.
    MeshAndBearings,
}

/// Measured point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RigRow {
    /// Line in the table, counted from 1.
    pub line: usize,
    /// Torque of the pinion \[N m\].
    pub torque_nm: f64,
    /// Speed of the pinion \[1/min\].
    pub speed_rpm: f64,
    /// Oil temperature \[°C\].
    pub temperature_c: f64,
    /// Measured loss \[W\].
    pub loss_w: f64,
    /// Its standard deviation \[W\].
    pub sigma_w: f64,
    /// Scope of the loss.
    pub includes: Scope,
    /// Name of the assembly.
    pub assembly: String,
    /// Name of the run.
    pub run: Option<String>,
    /// Order of measurement.
    pub order: Option<f64>,
    /// State of the flanks.
    pub flank_state: Option<String>,
    /// Case file, as written in the table.
    pub case: Option<String>,
}

impl RigRow {
    /// Makes a point with mesh losses only, of assembly `1`.
    #[must_use]
    pub fn of_mesh(
        line: usize,
        [torque_nm, speed_rpm, temperature_c]: [f64; 3],
        loss_w: f64,
        sigma_w: f64,
    ) -> Self {
        Self {
            line,
            torque_nm,
            speed_rpm,
            temperature_c,
            loss_w,
            sigma_w,
            includes: Scope::Mesh,
            assembly: "1".to_owned(),
            run: None,
            order: None,
            flank_state: None,
            case: None,
        }
    }

    /// Changes the assembly.
    #[must_use]
    pub fn in_assembly(mut self, assembly: &str) -> Self {
        assembly.clone_into(&mut self.assembly);
        self
    }

    /// Speed of the pinion \[rad/s\].
    #[must_use]
    pub fn omega(&self) -> f64 {
        self.speed_rpm * PI / 30.0
    }

    /// Standard deviation relative to the loss.
    #[must_use]
    pub fn relative_sigma(&self) -> f64 {
        self.sigma_w / self.loss_w
    }
}

/// Limits of a rig for suggested measurements; by default the range of its table.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reach {
    /// Largest absolute torque of the pinion \[N m\].
    pub torque_max_nm: Option<f64>,
    /// Largest speed of the pinion \[1/min\].
    pub speed_max_rpm: Option<f64>,
    /// Oil temperatures \[°C\].
    pub temperatures_c: Option<Vec<f64>>,
}

/// Table of measured points.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RigTable {
    /// Name in messages.
    pub name: String,
    /// Rows.
    pub rows: Vec<RigRow>,
    /// Whether a comment or a column declares the losses as simulated.
    pub is_simulated: bool,
    /// Doubts about its columns.
    pub warnings: Vec<Warning>,
    /// Limits of the rig.
    pub reach: Reach,
}

/// Known columns.
const KNOWN: [&str; 13] = [
    "torque_nm",
    "speed_rpm",
    "temperature_c",
    "loss_w",
    "torque_loss_nm",
    "sigma_w",
    "assembly",
    "run",
    "order",
    "includes",
    "flank_state",
    "case",
    SIMULATED_COLUMN,
];
/// Prefixes of column names, with the known column of the quantity.
const STEMS: [(&str, &str); 6] = [
    ("torque_loss", "torque_loss_nm"),
    ("torque", "torque_nm"),
    ("speed", "speed_rpm"),
    ("temperature", "temperature_c"),
    ("loss", "loss_w"),
    ("sigma", "sigma_w"),
];
/// Word in a comment of a table that declares its measurements as simulated.
pub const SIMULATED: &str = "SIMULATED";

/// Column of simulated values, `true`: the mark that programs retain which leave out comments.
pub(crate) const SIMULATED_COLUMN: &str = "simulated";

/// Whether a comment or a column of a table declares its values as simulated.
pub(crate) fn is_simulated(text: &str) -> bool {
    let mut lines = text.lines();
    let is_true = |cell: &str| cell.eq_ignore_ascii_case("true") || cell == "1";
    lines.any(|line| line.starts_with('#') && line.contains(SIMULATED))
        || number_table::read("", text).is_ok_and(|table| {
            let marked = |row: Row<'_>| Ok(row.text(SIMULATED_COLUMN).is_some_and(is_true));
            let rows = number_table::all("", &table, marked);
            rows.is_ok_and(|rows| rows.contains(&true))
        })
}

impl RigTable {
    /// Reads the table in `text`, separated by commas, semicolons (with decimal commas) or tabs.
    ///
    /// # Errors
    /// When a column is missing or a row is not valid; lists all such rows.
    ///
    /// ```
    /// use asperity_calibration::RigTable;
    /// let text = "Torque_Nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n183.4,2166,90,310,9,mesh\n";
    /// assert_eq!(RigTable::read("rig.csv", text)?.rows[0].torque_nm, 183.4);
    /// let without = "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n183.4,2166,90,310,,mesh\n";
    /// assert_eq!(RigTable::read("rig.csv", without).unwrap_err().code(), "E134");
    /// # Ok::<(), asperity_core::Fault>(())
    /// ```
    pub fn read(name: &str, text: &str) -> Result<Self, Fault> {
        let table = number_table::read(name, text)?;
        check_columns(name, &table)?;
        let rows = number_table::all(name, &table, row)?;
        Ok(Self {
            name: name.to_owned(),
            rows,
            is_simulated: is_simulated(text),
            warnings: table.unread(name).into_iter().collect(),
            reach: Reach::default(),
        })
    }

    /// Makes a table of rows that are not from a file.
    #[must_use]
    pub fn of_rows(name: &str, rows: Vec<RigRow>, is_simulated: bool) -> Self {
        Self {
            name: name.to_owned(),
            rows,
            is_simulated,
            warnings: Vec::new(),
            reach: Reach::default(),
        }
    }

    /// Distinct case names of the rows; `None` for rows without a case.
    #[must_use]
    pub(crate) fn case_names(&self) -> Vec<Option<String>> {
        let mut names: Vec<Option<String>> = self.rows.iter().map(|row| row.case.clone()).collect();
        names.sort();
        names.dedup();
        names
    }

    /// Number of rows that equal an earlier row in everything but the line.
    #[must_use]
    pub fn repeated(&self) -> usize {
        let is_equal = |a: &RigRow, b: &RigRow| {
            *a == RigRow {
                line: a.line,
                ..b.clone()
            }
        };
        let rows = self.rows.iter().enumerate();
        rows.filter(|(k, row)| self.rows[..*k].iter().any(|other| is_equal(row, other)))
            .count()
    }

    /// Names of the assemblies, in the order of their first rows.
    #[must_use]
    pub fn assemblies(&self) -> Vec<String> {
        let mut assemblies: Vec<String> = Vec::new();
        for row in &self.rows {
            if !assemblies.contains(&row.assembly) {
                assemblies.push(row.assembly.clone());
            }
        }
        assemblies
    }
}

/// Checks that the needed columns are there in their units.
fn check_columns(file: &str, table: &Table) -> Result<(), Fault> {
    let refuse = |rule: String| error::column(file, rule);
    for name in table.names() {
        let stem = STEMS.iter().find(|(stem, _)| name.starts_with(stem));
        if let (Some((_, column)), false) = (stem, KNOWN.contains(&name.as_str())) {
            return Err(refuse(format!(
                "column {name} is not known; give {column} in this unit"
            )));
        }
    }
    const NEEDED: [&str; 5] = [
        "torque_nm",
        "speed_rpm",
        "temperature_c",
        "sigma_w",
        "includes",
    ];
    if let [first, ..] = &number_table::misspelt(table, &NEEDED, &KNOWN)[..] {
        return Err(refuse(first.clone()));
    }
    for needed in NEEDED {
        if !table.has(needed) {
            return Err(refuse(format!("column {needed} is missing")));
        }
    }
    match ["loss_w", "torque_loss_nm"].map(|name| table.has(name)) {
        [false, false] => Err(refuse(
            "column loss_w (or torque_loss_nm) is missing".to_owned(),
        )),
        [true, true] => Err(refuse(
            "loss_w and torque_loss_nm exclude each other".to_owned(),
        )),
        _ => Ok(()),
    }
}

fn row(cells: Row<'_>) -> Result<RigRow, RowFault> {
    // Of the table as a whole, not of a row.
    let _ = cells.text(SIMULATED_COLUMN);
    let includes = cells.text("includes").ok_or_else(|| {
        let rule = "is missing; write mesh or mesh+bearings, the scope of the loss";
        cells.fault("includes", rule)
    })?;
    let includes = match includes.to_lowercase().replace(' ', "").as_str() {
        "mesh" => Scope::Mesh,
        "mesh+bearings" => Scope::MeshAndBearings,
        "all" => {
            let rule = "all includes churning and seals, which cannot be separated from film friction; subtract the loss \
                        measured without load at the same speed and temperature, and write mesh+bearings";
            return Err(cells.fault("includes", rule));
        }
        other => {
            let rule = format!("{other:?} is not known; mesh, mesh+bearings or all");
            return Err(cells.fault("includes", rule));
        }
    };
    let (torque_nm, speed_rpm) = (cells.number("torque_nm")?, cells.number("speed_rpm")?);
    let omega = speed_rpm * PI / 30.0;
    let (loss, loss_w) = if cells.has("loss_w") {
        ("loss_w", cells.number("loss_w")?)
    } else {
        ("torque_loss_nm", cells.number("torque_loss_nm")? * omega)
    };
    let row = RigRow {
        line: cells.line,
        torque_nm,
        speed_rpm,
        temperature_c: cells.number("temperature_c")?,
        loss_w,
        sigma_w: cells.number("sigma_w")?,
        includes,
        assembly: cells.text("assembly").unwrap_or("1").to_owned(),
        run: cells.text("run").map(str::to_owned),
        order: cells.optional("order")?,
        flank_state: cells.text("flank_state").map(str::to_owned),
        case: cells.text("case").map(str::to_owned),
    };
    plausible(&row, loss).map_err(|(column, rule)| cells.fault(column, rule))?;
    Ok(row)
}

/// Checks a row for wrong units, by ranges far wider than any rig needs.
fn plausible(row: &RigRow, loss: &'static str) -> Result<(), (&'static str, String)> {
    const SPEED: [f64; 2] = [0.1, 100_000.0];
    const TORQUE: [f64; 2] = [0.01, 1e6];
    const TEMPERATURE: [f64; 2] = [-60.0, 200.0];
    /// Loss relative to the power, from a very good mesh to a worm gear.
    const SHARE: [f64; 2] = [3e-4, 0.3];
    /// Standard deviation relative to the loss.
    const SIGMA: [f64; 2] = [5e-4, 0.5];
    let within = |value: f64, [low, high]: [f64; 2]| (low..=high).contains(&value);
    if !within(row.torque_nm.abs(), TORQUE) {
        let rule = format!(
            "{} N m; expected is 0.01 to 1e6 N m at the pinion",
            row.torque_nm
        );
        return Err(("torque_nm", rule));
    }
    if !within(row.speed_rpm, SPEED) {
        let rule = format!(
            "{} 1/min; expected is 0.1 to 100000 1/min, positive",
            row.speed_rpm
        );
        return Err(("speed_rpm", rule));
    }
    if !within(row.temperature_c, TEMPERATURE) {
        let rule = format!(
            "{} °C; expected is -60 to 200 °C (kelvin or Fahrenheit?)",
            row.temperature_c
        );
        return Err(("temperature_c", rule));
    }
    let power = row.torque_nm.abs() * row.omega();
    if !within(row.loss_w / power, SHARE) {
        let percent = 100.0 * row.loss_w / power;
        let rule = format!(
            "{:.4} W is {percent:.3} % of the power of {power:.0} W; expected is 0.03 to 30 % (kW, or torque instead of power?)",
            row.loss_w
        );
        return Err((loss, rule));
    }
    if !within(row.relative_sigma(), SIGMA) {
        let rule = format!(
            "{} W is {:.3} % of the loss; expected is 0.05 to 50 % (a share instead of W?)",
            row.sigma_w,
            100.0 * row.relative_sigma()
        );
        return Err(("sigma_w", rule));
    }
    Ok(())
}
