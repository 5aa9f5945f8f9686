//! Report files of GEARpie (C. Fernandes, FEUP; MIT licence), an independent open gear tool: calculated,
//! not measured. Its steel has 206 GPa.

use asperity::mesh::MeshPosition;
use asperity::mesh::position_at;
use asperity_gear::LoadSharing;
use asperity_tests::{CaseText, table_2};
use toml::Value;

use crate::comparison::{Comparison, Table};

/// A row of the report files, with the digits they print.
struct Printed {
    name: &'static str,
    module_mm: f64,
    teeth: [i64; 2],
    helix_deg: f64,
    shift: [f64; 2],
    width_mm: f64,
    tip_radius_mm: [f64; 2],
    centre_mm: f64,
    eps_alpha: f64,
    eps_beta: f64,
    length_mm: f64,
    torque: f64,
    speed: f64,
    f_bt: f64,
    p0_mpa: f64,
    half_width_um: f64,
    ohlendorf: f64,
    local: f64,
}

const C14: Printed = Printed {
    name: "C14",
    module_mm: 4.5,
    teeth: [16, 24],
    helix_deg: 0.0,
    shift: [0.1817, 0.1715],
    width_mm: 14.0,
    tip_radius_mm: [41.318, 59.272],
    centre_mm: 91.5,
    eps_alpha: 1.46,
    eps_beta: 0.0,
    length_mm: 19.43,
    torque: 200.0,
    speed: 1500.0,
    f_bt: 5912.1,
    p0_mpa: 1347.3,
    half_width_um: 199.567,
    ohlendorf: 0.1986,
    // From tooth stiffness, which this comparison leaves out.
    local: 0.1946,
};

const C40: Printed = Printed {
    name: "C40",
    width_mm: 40.0,
    torque: 215.5,
    speed: 1800.0,
    f_bt: 6370.7,
    p0_mpa: 827.4,
    half_width_um: 122.559,
    local: 0.1984,
    ..C14
};

const H701: Printed = Printed {
    name: "H701",
    module_mm: 2.5,
    teeth: [28, 42],
    helix_deg: 15.0,
    shift: [0.2290, 0.1489],
    width_mm: 17.0,
    tip_radius_mm: [39.276, 57.193],
    centre_mm: 91.5,
    eps_alpha: 1.52,
    eps_beta: 0.56,
    length_mm: 11.53,
    torque: 200.0,
    speed: 1500.0,
    f_bt: 5898.4,
    p0_mpa: 962.2,
    half_width_um: 71.357,
    ohlendorf: 0.1225,
    local: 0.1404,
};

const H951: Printed = Printed {
    name: "H951",
    module_mm: 1.75,
    teeth: [38, 57],
    helix_deg: 15.0,
    shift: [1.6915, 2.0003],
    width_mm: 21.2418,
    tip_radius_mm: [38.115, 55.867],
    centre_mm: 91.5,
    eps_alpha: 0.93,
    eps_beta: 1.00,
    length_mm: 4.98,
    torque: 200.0,
    speed: 1000.0,
    f_bt: 6208.9,
    p0_mpa: 1039.6,
    half_width_um: 97.230,
    ohlendorf: 0.0739,
    local: 0.0688,
};

impl Printed {
    /// The oil of Table 2 serves: nothing compared depends on it.
    fn case(&self) -> CaseText {
        let mm = |value: f64| format!("{value} mm");
        let tips = self
            .tip_radius_mm
            .map(|radius| Value::from(mm(2.0 * radius)));
        table_2()
            .with("gears.teeth", self.teeth.map(Value::from).to_vec())
            .with("gears.module", mm(self.module_mm))
            .with("gears.helix", format!("{} deg", self.helix_deg))
            .with("gears.face_width", mm(self.width_mm))
            .with("gears.profile_shift", self.shift.map(Value::from).to_vec())
            .with("gears.tip_diameter", tips.to_vec())
            .with("material.pinion.young", "206 GPa")
            .with("operation.torque", format!("{} N m", self.torque))
            .with("operation.speed", format!("{} 1/min", self.speed))
    }

    fn geometry(&self) -> Vec<Comparison> {
        let result = self.case().run().result;
        let gears = &result.gears;
        let path = gears.path();
        let force = gears
            .forces(result.inputs.operation.torque)
            .unwrap()
            .transverse_base;
        let printed = |quantity: &str, unit, number, actual| {
            Comparison::printed(format!("{}: {quantity}", self.name), unit, number, actual)
        };
        let mut rows = vec![
            // The shifts are printed to 1e-4, which moves the centre by less than 5e-4 mm.
            printed(
                "a",
                "mm",
                (self.centre_mm, 1e-3),
                gears.centre_distance.si() * 1e3,
            ),
            printed("ε_α", "-", (self.eps_alpha, 0.01), path.eps_alpha),
            printed("AE", "mm", (self.length_mm, 0.01), path.length.si() * 1e3),
        ];
        if self.eps_beta > 0.0 {
            rows.push(printed("ε_β", "-", (self.eps_beta, 0.01), path.eps_beta));
        }
        let force = Comparison::new(
            format!("{}: F_bt", self.name),
            "N",
            self.f_bt,
            force.si(),
            // Lengths and shifts are printed to four digits or five.
            1e-4,
        );
        rows.push(force);
        let ohlendorf = result.summary.loss_factor_ohlendorf;
        rows.push(printed(
            "H_V, Ohlendorf",
            "-",
            (self.ohlendorf, 1e-4),
            ohlendorf,
        ));
        rows
    }

    fn at_pitch_point(&self) -> MeshPosition {
        let case = self.case().load().case.clone();
        position_at(&case, case.gears.path().c).unwrap()
    }
}

/// Four digits of p₀ and the rounding of the inputs.
const HERTZ: f64 = 5e-4;

pub fn spur_pairs() -> Table {
    let mut rows = Vec::new();
    for pair in [C14, C40] {
        rows.extend(pair.geometry());
        let local = pair.case().run().result.summary.loss_factor_local;
        rows.push(Comparison::printed(
            format!("{}: H_V, equal shares", pair.name),
            "-",
            (pair.ohlendorf, 1e-4),
            local,
        ));
        let hertz = pair.at_pitch_point().hertz;
        let push = |quantity, unit, expected, actual| {
            let quantity = format!("{}: {quantity} at the pitch point", pair.name);
            Comparison::new(quantity, unit, expected, actual, HERTZ)
        };
        rows.push(push(
            "p₀",
            "MPa",
            pair.p0_mpa,
            hertz.max_pressure.si() * 1e-6,
        ));
        rows.push(push(
            "a_H",
            "µm",
            pair.half_width_um,
            hertz.half_width.si() * 1e6,
        ));
    }
    Table {
        name: "gear-tool-spur",
        test: "spur_pairs_are_those_of_an_independent_gear_tool",
        rows,
    }
}

#[test]
fn spur_pairs_are_those_of_an_independent_gear_tool() {
    spur_pairs().hold();
}

#[test]
fn other_load_distributions_lie_around_that_of_an_independent_gear_tool() {
    // The tool shares by tooth stiffness: between equal shares and a trapezoid.
    let with = |sharing: &str| {
        let case = C14.case().with("model.load_distribution", sharing);
        case.run().result.summary.loss_factor_local
    };
    assert!(with("trapezoid") < C14.local && C14.local < with("uniform"));
    // The closed form of least potential energy comes within 2 %.
    asperity_tests::assert_close("min-potential", with("min-potential"), C14.local, 0.02);
}

/// p₀ and a_H as the tool reckons them on a helical pair.
///
/// It takes the contact length of the instant at which a line of contact reaches the pitch point,
/// where the load here is that at the mean length. Its p₀ is that of the transverse radius; its half
/// width is that of the normal radius, printed as one half of it.
fn hertz_as_there(pair: &Printed) -> [Comparison; 2] {
    let gears = pair.case().load().case.gears.clone();
    let path = gears.path();
    let length = gears.contact_length(path.eps_2 - path.eps_beta).unwrap();
    let load_ratio = gears.mean_contact_length() / length;
    let radius_ratio = gears.base_helix.si().cos();
    let hertz = pair.at_pitch_point().hertz;
    let p0 = hertz.max_pressure.si() * (load_ratio / radius_ratio).sqrt();
    let half_width = 0.5 * hertz.half_width.si() * load_ratio.sqrt();
    let row = |quantity, unit, expected, actual| {
        let name = pair.name;
        let quantity = format!("{name}: {quantity} at the pitch point, read as there");
        Comparison::new(quantity, unit, expected, actual, HERTZ)
    };
    [
        row("p₀", "MPa", pair.p0_mpa, p0 * 1e-6),
        row("a_H", "µm", pair.half_width_um, half_width * 1e6),
    ]
}

pub fn helical_pairs() -> Table {
    let mut rows = Vec::new();
    for pair in [H701, H951] {
        rows.extend(pair.geometry());
        let gears = pair.case().load().case.gears.clone();
        let factors = gears.loss_factors(&LoadSharing::Uniform).unwrap();
        let local = |kind, actual, tolerance| {
            let quantity = format!("{}: H_V, local, {kind}", pair.name);
            Comparison::new(quantity, "-", pair.local, actual, tolerance)
        };
        // Steps over face and phase there, Gauss points here.
        let at_each_instant = factors.local_phase_averaged;
        rows.push(local("load shared at each instant", at_each_instant, 6e-3));
        // What the program reckons with; the same where ε_β is whole.
        rows.push(local(
            "load at the mean contact length",
            factors.local,
            0.045,
        ));
        rows.extend(hertz_as_there(&pair));
    }
    Table {
        name: "gear-tool-helical",
        test: "helical_pairs_are_those_of_an_independent_gear_tool",
        rows,
    }
}

#[test]
fn helical_pairs_are_those_of_an_independent_gear_tool() {
    helical_pairs().hold();
}

#[test]
fn fzg_gears_press_as_hard_as_reported_where_one_pair_carries_all() {
    // Arana et al., Proc. IMechE J 233 (2019) 303: FZG type C at load stage 7, about 1400 MPa near
    // the lowest point of single contact.
    let case =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/fzg-c.toml");
    let case = asperity::case::load(&case, None).unwrap().case.clone();
    let b = case.gears.path().b;
    // Just inside, where the share has reached one.
    let inside = b + (case.gears.path().c - b) * 1e-3;
    let pressure = position_at(&case, inside).unwrap().hertz.max_pressure;
    asperity_tests::assert_close("p0", pressure.si(), 1400e6, 0.03);
}
