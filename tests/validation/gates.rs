//! The gates of measurement, computed together with the defaults of the program and printed as they come out.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock};

use asperity::PositionError;
use asperity::Run;
use asperity::case::{LoadedCase, RunningInPlan};
use asperity::flanks::Surfaces;
use asperity::lubrication::load_share_law::{LoadShare, ShareConditions, SharedLoad};
use asperity::pipeline::{History, HistorySettings, HistoryState, history};
use asperity::quantity::Torque;
use asperity::result::{FlankHeights, Losses, OffsetRow};
use asperity::running_in::{limits, run_in};
use asperity_core::Profile;
use asperity_tests::{contacts, losses_with};

use crate::britton::britton;
use crate::disc;
use crate::ehl_records::{Deviation, deviation};
use crate::gate::{Class, Estimate, Gate, Verdict, table, whole_table};
use crate::load_share::{FEW, losses};
use crate::measured_cases::{FZG_SPEEDS, Kept, Sampled, kept, measured, turns};
use crate::share_laws::erf;

/// Gates that do not pass. A verdict that changes fails the test: change the list, and say why in the commit.
const NOT_PASSED: [(&str, Verdict); 15] = [
    ("T1 FZG C-mod, mean μ at 0.5 m/s", Verdict::Fail),
    (
        "T1 loss over the source's law, coded again, 0.5 m/s",
        Verdict::Undecided,
    ),
    (
        "T1 loss over the source's law, coded again, 1.25 m/s",
        Verdict::Undecided,
    ),
    (
        "T1 loss over the source's law, coded again, 8.3 m/s",
        Verdict::Undecided,
    ),
    (
        "T3 Britton, Ra 0.4 to 0.05 um, jet oil, 70 °C: change of μ",
        Verdict::Undecided,
    ),
    (
        "T3 Britton, Ra 0.4 to 0.05 um, jet oil, 90 °C: change of μ",
        Verdict::Undecided,
    ),
    (
        "T3 Britton, Ra 0.4 to 0.05 um, jet oil, 110 °C: change of μ",
        Verdict::Undecided,
    ),
    (
        "T6 μ of polyglycol over mineral oil, FZG at 2.5 m/s",
        Verdict::Undecided,
    ),
    (
        "T7 efficiency run in at 1.7 minus at 0.9 GPa, FZG ground",
        Verdict::Fail,
    ),
    (
        "T9 solved asperity share minus records, root mean square, σ_d/h_c below 3",
        Verdict::Undecided,
    ),
    (
        "T9 solved asperity share minus records, root mean square, all with a defined share",
        Verdict::Undecided,
    ),
    (
        "T11 speed of a full film (asperity share 1 %), run in over fresh, one side rough",
        Verdict::Fail,
    ),
    (
        "T13 depth of plastic flow, FZG ground, 94.1 N m",
        Verdict::Fail,
    ),
    (
        "T13 depth of plastic flow, FZG ground, 302 N m",
        Verdict::Fail,
    ),
    (
        "T15 Rq of a disc of 0.5 um, ridges along rolling, 1.5 GPa",
        Verdict::Fail,
    ),
];

/// The law of the source of T1: 1 − erf(λ) of the load at the boundary coefficient, λ the film over Ra 0.2 um.
#[derive(Debug)]
struct Arana;

impl LoadShare for Arana {
    fn name(&self) -> &str {
        "arana"
    }

    fn share(&self, at: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
        let lambda = at.film.film.central.si() / 0.2e-6;
        Ok(SharedLoad::of_film(erf(lambda)))
    }
}

pub fn gates() -> &'static [Gate] {
    static GATES: OnceLock<Vec<Gate>> = OnceLock::new();
    GATES.get_or_init(|| {
        let mut rows = fzg_gates();
        rows.extend(finish_gates());
        rows.extend(oil_gates());
        rows.extend(running_in_gates());
        rows.extend(share_gates());
        rows.extend(petry_johnson_gates());
        rows.extend(limit_gates());
        rows.extend(film_gates());
        rows.extend(history_gates());
        let number = |gate: &Gate| {
            let text = gate.name.split_whitespace().next().unwrap();
            text[1..].parse::<u32>().unwrap()
        };
        rows.sort_by_key(number);
        rows
    })
}

/// Units and decimals.
const PERCENT: (&str, usize) = ("%", 1);
const FRICTION: (&str, usize) = ("-", 4);
const RATIO: (&str, usize) = ("-", 3);

/// Central film \[um\], mean over the path.
fn mean_film(found: &Losses) -> f64 {
    let films = found.path.iter().map(|row| row.film_central_um);
    films.sum::<f64>() / found.path.len() as f64
}

/// T1: FZG type C-mod with tip relief.
fn fzg_gates() -> Vec<Gate> {
    let kept = Kept::new(measured("fzg-c-mod", &[]));
    let slow = turns(0.5);
    let at_slow = |keys: &[(&str, &str)]| {
        let found = kept.at(&[&[("operation.speed", &*slow)], keys].concat());
        found.friction()
    };
    let friction = "at most 0.065 on ground flanks of Ra 0.2 um (here surrogates); μ_b was chosen with it known";
    let nominal = kept.at(&[("operation.speed", &turns(8.3))]);
    let factor = Estimate::exact(nominal.losses.summary.loss_factor_local / 0.1680 - 1.0);
    let mut rows = vec![
        Gate::new(
            Class::Measured,
            "T1 FZG C-mod, mean μ at 0.5 m/s",
            friction,
            at_slow(&[]),
            Some([0.055, 0.068]),
            FRICTION,
        )
        .against([f64::NEG_INFINITY, 0.065]),
        Gate::new(
            Class::Measured,
            "T1 the same with boundary friction 0.07",
            "-",
            at_slow(&[("model.boundary_friction", "0.07")]),
            None,
            FRICTION,
        ),
        Gate::new(
            Class::ComputedBySource,
            "T1 H_VL, relief over the double contact",
            "0.1680 with 35 um relief, length not printed",
            factor.times(100.0),
            Some([-5.0, 5.0]),
            PERCENT,
        )
        .against([0.0; 2]),
        Gate::new(
            Class::ComputedBySource,
            "T1 gap at 8.3 m/s, mean over the path",
            "just below 0.2 um",
            Estimate::exact(mean_film(&nominal.losses)),
            Some([0.15, 0.20]),
            ("um", 3),
        )
        .against([0.2; 2]),
    ];
    rows.extend(FZG_SPEEDS.iter().map(|(speed, _)| {
        let turns = turns(*speed);
        let ours = kept.at(&[("operation.speed", &turns)]);
        // The law depends on smooth films only: one offset is like any number of them.
        let keys = [
            ("model.offsets", "1"),
            ("model.film_friction", "eyring-arana"),
            ("model.boundary_friction", "0.065"),
            ("operation.speed", &turns),
        ];
        let arana = measured("fzg-c-mod", &keys);
        let arana = arana.with_laws(|laws| laws.load_share = Some(Arc::new(Arana)));
        let arana = Estimate::exact(losses(&arana).summary.loss_w);
        let change = ours.mean(&|row| row.loss_w).change_to(arana);
        let measured = match speed {
            0.5 => "law within 5 % of the measured loss; μ_b was chosen with it known",
            _ => "law within 5 % of the measured loss",
        };
        Gate::new(
            Class::Measured,
            format!("T1 loss over the source's law, coded again, {speed} m/s"),
            measured,
            change.times(100.0),
            Some([-15.0, 15.0]),
            PERCENT,
        )
        .against([-5.0, 5.0])
    }));
    rows
}

/// Measured losses \[W\] of the Petry-Johnson gears, read in a secondary text.
pub fn measured_loss(speed: u32) -> [f64; 2] {
    match speed {
        2000 => [166.0, 174.0],
        4000 => [286.0, 320.0],
        6000 => [456.0, 499.0],
        8000 => [606.0, 633.0],
        _ => [472.0, 640.0],
    }
}

/// The superfinished pair of Petry-Johnson with its contacts, which serve every speed and temperature.
fn petry_johnson() -> &'static Kept {
    static KEPT: OnceLock<Kept> = OnceLock::new();
    KEPT.get_or_init(|| Kept::new(measured("petry-johnson", &[])))
}

/// The losses of superfinished flanks known by their Rq, with all other defaults.
pub fn petry_johnson_at(speed: u32) -> Arc<Sampled> {
    static FOUND: Mutex<BTreeMap<u32, Arc<Sampled>>> = Mutex::new(BTreeMap::new());
    let mut found = FOUND.lock().unwrap();
    let sampled = found.entry(speed).or_insert_with(|| {
        let speed = format!("{speed} 1/min");
        Arc::new(petry_johnson().at(&[("operation.speed", &speed)]))
    });
    Arc::clone(sampled)
}

/// Laws of the bulk temperature of T2 with their names: the conductances of the rig are unknown, 10 to 40 W/K a gear are
/// assumed.
const BULK_LAWS: [(&str, &str); 3] = [
    (
        "iso, unconfirmed",
        r#"{ law = "iso", lubrication = "jet" }"#,
    ),
    (
        "network, 10 W/K a gear",
        r#"{ law = "network", pinion_to_oil = "10 W/K", wheel_to_oil = "10 W/K" }"#,
    ),
    (
        "network, 40 W/K a gear",
        r#"{ law = "network", pinion_to_oil = "40 W/K", wheel_to_oil = "40 W/K" }"#,
    ),
];

/// The loss at the bulk temperature that `law` finds, the oil jet at the 110 °C of the case, over the loss at 110 °C. Both in
/// the same windows, of which few are enough for a ratio.
fn over_oil_temperature(speed: u32, law: &str) -> f64 {
    static FEW_WINDOWS: OnceLock<Kept> = OnceLock::new();
    let few = [("model.positions", "4"), ("model.offsets", "1")];
    let kept = FEW_WINDOWS.get_or_init(|| Kept::new(measured("petry-johnson", &few)));
    let speed = ("operation.speed", &*format!("{speed} 1/min"));
    let keys = [
        speed,
        (
            "lubricant.viscosity",
            r#"{ law = "given", dynamic_viscosity = "10.6 mPa s", temperature = "110 °C" }"#,
        ),
        ("operation.oil_temperature", "110 °C"),
        ("operation.bulk", law),
    ];
    let [warm, at_oil] = [&keys[..], &[speed]].map(|keys| kept.at(keys).losses.summary.loss_w);
    warm / at_oil
}

/// Losses \[W\] with the laws of the bulk temperature, as text; `loss_w` is the one at the temperature of the oil.
fn heated(speed: u32, loss_w: f64) -> String {
    let loss = |(name, law): (&str, &str)| {
        let loss = loss_w * over_oil_temperature(speed, law);
        format!("{loss:.0} by {name}")
    };
    BULK_LAWS.map(loss).join(", ")
}

/// T2: within 25 % of the measured interval up to 8000 1/min.
fn petry_johnson_gates() -> Vec<Gate> {
    let rows = [2000, 4000, 6000, 8000, 10_000].map(|speed| {
        let [low, high] = measured_loss(speed);
        let also = match speed {
            10_000 => "; 590 to 645 W with the signs of the errors that hold up to 8000 1/min",
            _ => "",
        };
        let found = petry_johnson_at(speed).mean(&|row| row.loss_w);
        Gate::new(
            Class::CalibratedOn,
            format!("T2 Petry-Johnson, superfinished 40/40, {speed} 1/min"),
            format!("{low:.0} to {high:.0} W (grade C){also}"),
            found,
            (speed <= 8000).then_some([0.75 * low, 1.25 * high]),
            ("W", 0),
        )
        .against([low, high])
        .noted(format!(
            " (at the bulk temperature of its loss: {})",
            heated(speed, found.value)
        ))
    });
    rows.into()
}

/// T3 and T4: superfinishing.
fn finish_gates() -> Vec<Gate> {
    let britton = [70.0, 90.0, 110.0].map(|celsius| {
        let found = britton(celsius);
        let is_inside = (0.2..=0.5).contains(&found.film_ratio);
        Gate::new(
            Class::UnknownTemperature,
            format!("T3 Britton, Ra 0.4 to 0.05 um, jet oil, {celsius} °C: change of μ"),
            "-30 %, temperature unknown",
            found.change.times(100.0),
            is_inside.then_some([-40.0, -20.0]),
            PERCENT,
        )
        .against([-30.0; 2])
        .noted(format!(" at h/Rq {:.2}", found.film_ratio))
    });
    let mut rows = Vec::from(britton);
    let null = Gate::new(
        Class::Measured,
        "T4 superfinishing in thick films, FZG at 40 °C, 20 m/s: change of μ",
        "nothing measurable",
        null_pair().times(100.0),
        Some([-8.0, 8.0]),
        PERCENT,
    );
    rows.push(null.against([0.0; 2]));
    rows
}

/// T5: limiting shear.
fn limit_gates() -> Vec<Gate> {
    let kept = kept("e-drive-superfinished", &[]);
    let limits = [("mineral", 0.047), ("naphthenic", 0.053), ("pao", 0.035)];
    let rows = limits.map(|(oil, limit)| {
        let path = kept.at(&[("lubricant.base_oil", oil)]).losses.path;
        let largest = path.iter().map(|row| row.mu_film).fold(0.0, f64::max);
        Gate::new(
            Class::ByConstruction,
            format!("T5 largest film friction, e-drive superfinished, {oil}"),
            format!("limiting shear over pressure {limit}"),
            Estimate::exact(largest),
            Some([f64::NEG_INFINITY, limit + 0.005]),
            FRICTION,
        )
        .against([f64::NEG_INFINITY, limit])
    });
    rows.into()
}

/// FZG flanks in a thick film: change of the friction by superfinishing.
fn null_pair() -> Estimate {
    let keys = [
        ("operation.bulk_temperature", "40 °C"),
        ("operation.speed", &*turns(20.0)),
    ];
    let friction = |name: &str| Sampled::new(&measured(name, &keys)).friction();
    friction("fzg-c-superfinished").change_to(friction("fzg-c-ground"))
}

/// T6: base oils of one viscosity in the FZG gears at 90 °C.
fn oil_gates() -> Vec<Gate> {
    let kept = Kept::new(measured("fzg-c-ground", &[]));
    let oils = [
        ("polyglycol", "0.6", [0.6; 2], [0.45, 0.75]),
        ("ester", "0.6 to 1.0", [0.6, 1.0], [0.45, 1.15]),
    ];
    let row = |(oil, measured, range, rule): (&str, &str, [f64; 2], [f64; 2]), speed: f64| {
        let turns = turns(speed);
        let at = |oil: &str| kept.at(&[("lubricant.base_oil", oil), ("operation.speed", &turns)]);
        Gate::new(
            Class::CalibratedOn,
            format!("T6 μ of {oil} over mineral oil, FZG at {speed} m/s"),
            measured,
            at(oil).friction_over(&at("mineral")),
            Some(rule),
            RATIO,
        )
        .against(range)
    };
    let rows = oils.map(|oil| [2.5, 8.3].map(|speed| row(oil, speed)));
    rows.into_iter().flatten().collect()
}

/// Torques of FZG type C whose mean pressure over the path is near 0.9 and 1.7 GPa \[N m\].
const LOW_AND_HIGH: [f64; 2] = [94.1, 302.0];

/// The flanks of a case run in plastically at a torque \[N m\].
fn run_in_at(case: &LoadedCase, torque: f64) -> Surfaces {
    let plan = RunningInPlan {
        torque: Torque::from_si(torque),
        engagements: None,
    };
    let found = run_in(&case.case, &case.surfaces, &plan, &|_| {});
    found.unwrap().surfaces
}

/// T7: running-in at a high load against a low one, on ground and on superfinished flanks.
fn running_in_gates() -> Vec<Gate> {
    let gain = |name: &str| {
        let case = measured(name, &[]);
        let offsets = Sampled::new(&case).losses.offsets.len().to_string();
        // The same windows for both states.
        let case = case.with_key("model.offsets", &offsets).unwrap();
        let [low, high] =
            LOW_AND_HIGH.map(|torque| Sampled::new(&case.with_surfaces(run_in_at(&case, torque))));
        let gain = |low: &OffsetRow, high: &OffsetRow| 100.0 * (high.efficiency - low.efficiency);
        low.paired(&high.losses, &gain)
    };
    let row = |finish: &str, of: &str, class, measured: &str, rule| {
        let name = format!("T7 efficiency run in at 1.7 minus at 0.9 GPa, FZG {of}");
        let value = gain(&format!("fzg-c-{finish}"));
        Gate::new(class, name, measured, value, Some(rule), ("point", 4))
    };
    vec![
        row(
            "ground",
            "ground",
            Class::Measured,
            "order of 0.1",
            [0.03, 0.2],
        ),
        row(
            "superfinished",
            "superfinished",
            Class::ByConstruction,
            "none",
            [-0.02, 0.02],
        ),
    ]
}

/// T11 to T15: the speed of a full film on run-in flanks, how early and how far they run in, how deep they flow and wear, and a disc.
fn history_gates() -> Vec<Gate> {
    let warm = [("operation.bulk_temperature", "50 °C")];
    let case = with_smooth_wheel(&measured("fzg-c-ground", &warm));
    let worn = case.with_surfaces(run_in_at(&case, LOW_AND_HIGH[1]));
    let ratio = full_film_speed(&worn) / full_film_speed(&case);
    let speed = Gate::new(
        Class::Measured,
        "T11 speed of a full film (asperity share 1 %), run in over fresh, one side rough",
        "0.1 with Sq -17 %",
        Estimate::exact(ratio),
        Some([f64::NEG_INFINITY, 0.3]),
        RATIO,
    );
    let ground = measured(
        "fzg-c-ground",
        &[("model.positions", "8"), ("model.offsets", "4")],
    );
    let both = |heights: &FlankHeights| heights.rq_um[0].hypot(heights.rq_um[1]);
    let [low, high] = LOW_AND_HIGH.map(|torque| worn_in(&ground, torque, 1e5));
    let rq = |found: &History, k: usize| both(&found.states[k].heights);
    let last = |found: &History| rq(found, found.states.len() - 1);
    let first = rq(&high, 0);
    let early = both(&high.steps[high.steps.len() - 1].heights);
    let share = (first - early) / (first - last(&high));
    let early = Gate::new(
        Class::Measured,
        "T12 part of the change of Rq of 1e5 engagements in the first 1000, 1.7 GPa",
        "most of it",
        Estimate::exact(100.0 * share),
        Some([60.0, f64::INFINITY]),
        ("%", 0),
    );
    let smoother = Gate::new(
        Class::Measured,
        "T12 Rq after 1e5 engagements, 1.7 over 0.9 GPa",
        "more load ends smoother",
        Estimate::exact(last(&high) / last(&low)),
        Some([f64::NEG_INFINITY, 1.0]),
        RATIO,
    );
    let depths = LOW_AND_HIGH.map(|torque| {
        let keys = [("operation.torque", &*format!("{torque} N m"))];
        let depth = depth_of_flow(&measured("fzg-c-ground", &keys));
        Gate::new(
            Class::Measured,
            format!("T13 depth of plastic flow, FZG ground, {torque} N m"),
            "below 10",
            Estimate::exact(depth),
            Some([0.0, 10.0]),
            ("um", 1),
        )
    });
    [
        vec![speed, early, smoother],
        depths.into(),
        vec![worn_end(), disc::gate()],
    ]
    .concat()
}

/// Usual wear coefficient \[1/Pa\].
pub const WEAR: f64 = 3e-19;

/// The history of a case at a torque \[N m\] to a number of engagements, the first 1000 at most by flow.
fn worn_in(case: &LoadedCase, torque: f64, engagements: f64) -> History {
    let settings = HistorySettings {
        plan: RunningInPlan {
            torque: Torque::from_si(torque),
            engagements: Some(1e3),
        },
        limit: limits(&case.case).unwrap()[1],
        worn: engagements * WEAR,
        least: None,
    };
    history(&case.at_stated().unwrap(), &settings, &|_| {}).unwrap()
}

/// T14: depth worn off both flanks together at the end of the path where it is deeper. Teeth that meet early by their deflection load
/// this end more, which is not in the model. In proportion, as the asperity share of the end hardly falls.
fn worn_end() -> Gate {
    let keys = [
        ("model.positions", "16"),
        ("model.offsets", "4"),
        ("operation.torque", "302 N m"),
    ];
    let case = measured("fzg-c-ground", &keys);
    let found = worn_in(&case, LOW_AND_HIGH[1], 1e6);
    let [pinion, wheel] = case.case.gears.teeth.map(f64::from);
    // Depth over k and engagements of the pinion at both ends of the path [m Pa].
    let rates = |state: &HistoryState| {
        let path = asperity_tests::losses(&case.with_surfaces(state.surfaces.clone()))
            .unwrap()
            .path;
        [&path[0], &path[path.len() - 1]].map(|at| {
            let load = 1e3 * at.line_load_n_per_mm * (1.0 - at.film_share);
            let of = |speed: f64| at.sliding_m_per_s.abs() / speed.abs();
            load * (of(at.u1_m_per_s) + of(at.u2_m_per_s) * pinion / wheel)
        })
    };
    let worn = found.states.iter().filter(|state| state.worn > 0.0);
    let flowed = found.states.iter().rfind(|state| state.worn == 0.0);
    let points: Vec<(f64, [f64; 2])> = flowed
        .into_iter()
        .chain(worn)
        .map(|state| (state.worn, rates(state)))
        .collect();
    let depth = |end: usize| {
        let steps = points.windows(2);
        let depths =
            steps.map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (pair[0].1[end] + pair[1].1[end]));
        1e6 * depths.sum::<f64>()
    };
    let depth = depth(0).max(depth(1));
    let gate = Gate::new(
        Class::Measured,
        "T14 depth worn off an unrelieved tooth end, 1e6 engagements, 1.7 GPa",
        "0.5 to 4 (ISO 6336-1: 2.0)",
        Estimate::exact(depth),
        None,
        ("um", 3),
    );
    let of_k = [0.5, 4.0].map(|reached| reached / depth);
    gate.noted(format!(
        " (reached with {:.0} to {:.0} times k)",
        of_k[0], of_k[1]
    ))
}

/// The case with a wheel whose roughness is a twentieth.
fn with_smooth_wheel(case: &LoadedCase) -> LoadedCase {
    let [pinion, wheel] = case.surfaces.traces().unwrap();
    let smooth = wheel.heights().iter().map(|z| 0.05 * z).collect();
    let smooth = Profile::new(wheel.spacing(), smooth).unwrap();
    case.with_surfaces(case.surfaces.with_traces([pinion.clone(), smooth]))
}

/// Speed of the pitch line at which the asperities carry 1 % of the load \[m/s\].
fn full_film_speed(case: &LoadedCase) -> f64 {
    let tables = contacts(case).unwrap();
    let points = (0..12).map(|k| {
        let speed = 0.25 * 2.0_f64.powi(k);
        let faster = case.with_key("operation.speed", &turns(speed)).unwrap();
        let share = losses_with(&tables, &faster)
            .unwrap()
            .summary
            .asperity_share;
        (-share.ln(), speed.ln())
    });
    let points: Vec<(f64, f64)> = points.collect();
    assert!(
        points[0].0 < -0.01_f64.ln() && points[11].0 > -0.01_f64.ln(),
        "{points:?}"
    );
    asperity_core::numerics::interpolate(&points, -0.01_f64.ln()).exp()
}

/// Greatest depth below the flanks at which the stress exceeds the elastic limit \[um\].
fn depth_of_flow(case: &LoadedCase) -> f64 {
    let outcome = Run::new(case).execute().unwrap().into_only().unwrap();
    let fields = outcome
        .fields
        .iter()
        .filter_map(|fields| fields.subsurface.as_ref());
    let deepest = fields.map(|stress| {
        let across = stress.plastic_stress.len() / stress.depths.len();
        let rows = stress.plastic_stress.chunks(across).zip(&stress.depths);
        let flows = rows.filter(|(row, _)| row.iter().any(|beyond| *beyond > 0.0));
        flows.map(|(_, depth)| 1e6 * depth).fold(0.0, f64::max)
    });
    deepest.fold(0.0, f64::max)
}

/// T9: the solved share against our own records.
fn share_gates() -> Vec<Gate> {
    let own = "own EHL records (no measurement)";
    let row = |what: &str, found: &Deviation, rule| {
        let name = format!("T9 solved asperity share minus records, root mean square, {what}");
        let note = format!(" of {}, mean {:+.3}", found.records, found.mean);
        Gate::new(
            Class::OwnReference,
            name,
            own,
            found.root_mean_square,
            rule,
            RATIO,
        )
        .noted(note)
    };
    let largest = |end: f64| Some([f64::NEG_INFINITY, end]);
    vec![
        row("σ_d/h_c below 3", &deviation(true, false), largest(0.04)),
        row(
            "all with a defined share",
            &deviation(false, false),
            largest(0.05),
        ),
        row("all", &deviation(false, true), None),
    ]
}

/// T10: power of the speed in the film.
fn film_gates() -> Vec<Gate> {
    let few = kept("../measured/fzg-c-ground", &FEW);
    let film = |speed: f64| mean_film(&few.at(&[("operation.speed", &turns(speed))]).losses);
    let row = |class, what: &str, slow: f64, fast: f64, rule| {
        let power = (film(fast) / film(slow)).ln() / (fast / slow).ln();
        Gate::new(
            class,
            format!("T10 power of the speed in the film, {what}"),
            "0.65 to 0.72 on a rig, oils not named",
            Estimate::exact(power),
            rule,
            RATIO,
        )
        .against([0.65, 0.72])
    };
    vec![
        row(
            Class::ByConstruction,
            "0.5 to 1 m/s",
            0.5,
            1.0,
            Some([0.65, 0.72]),
        ),
        row(
            Class::Measured,
            "8.3 to 16.6 m/s, with its heat",
            8.3,
            16.6,
            None,
        ),
    ]
}

/// All gates.
pub fn all_gates() -> String {
    whole_table(gates())
}

/// The gates that count, and what T1 and T3 require of the boundary friction.
pub fn gate_table() -> String {
    format!(
        "{}\n{}\nTest: `the_verdicts_of_the_gates_are_those_printed`.\n",
        table(gates()),
        boundary_friction()
    )
}

/// The opposite demands of T1 below 2 m/s and of T3.
fn boundary_friction() -> String {
    let of = |begin: &str| {
        let rows = gates().iter().filter(|gate| gate.name.starts_with(begin));
        rows.map(|gate| gate.value.value).collect::<Vec<f64>>()
    };
    let loss = of("T1 loss over");
    let change = of("T3");
    let (slow, hot) = (&loss[..2], change[change.len() - 1]);
    assert!(slow.iter().all(|change| *change < 0.0) && hot < -30.0);
    format!(
        "Below 2 m/s T1 requires more boundary friction than the model gives (loss {:+.0} and {:+.0} %), T3 less (change of μ {hot:.0} % at 110 °C, \
         measured -30 %).\n",
        slow[0], slow[1]
    )
}

#[test]
fn the_verdicts_of_the_gates_are_those_printed() {
    println!("{}", all_gates());
    let not_passed: Vec<(&str, Verdict)> = gates()
        .iter()
        .map(|gate| (&*gate.name, gate.verdict()))
        .filter(|(_, verdict)| !matches!(verdict, Verdict::Pass | Verdict::Printed))
        .collect();
    assert_eq!(not_passed, NOT_PASSED);
}
