//! Prepares a trace in memory with the usual filters and prints its Rq.
//!
//! `cargo run -p asperity-flanks --example prepare_a_trace`

use std::error::Error;

use asperity_core::Profile;
use asperity_flanks::read_place::StatedPlace;
use asperity_flanks::statements::Statements;
use asperity_flanks::trace::{TraceContent, TraceInputs, prepared_trace};
use asperity_flanks::trace_filters::StatedFilters;
use asperity_gear::{Gear, GearPair, GearPairInput};
use asperity_profile_io::read::ReadOptions;
use asperity_roughness::preparation::{LAMBDA_C, LAMBDA_S, Preparation};

fn main() -> Result<(), Box<dyn Error>> {
    let wave = |i: i32| 0.3e-6 * (0.02 * f64::from(i)).sin();
    let trace = Profile::new("0.5 um".parse()?, (0..8000).map(wave).collect())?;
    let drawing = ("1.8 mm".parse()?, "23.4 deg".parse()?, "32 mm".parse()?);
    let drawing = GearPairInput::standard([23, 68], drawing.0, drawing.1, drawing.2);
    let gears = GearPair::new(&drawing)?;
    let nothing_stated = Statements::default();
    let content = TraceContent::Heights(&trace, &nothing_stated);
    let inputs = TraceInputs {
        name: "a wave",
        options: &ReadOptions::default(),
        is_line_stated: false,
        outliers: None,
        place: StatedPlace::default(),
        filters: StatedFilters {
            preparation: Preparation {
                lambda_c: Some(LAMBDA_C),
                lambda_s: Some(LAMBDA_S),
                ..Preparation::default()
            },
            cutoffs: [None; 2],
            ends: None,
            form: None,
        },
        needed_of_scan: None,
        shortest_form: None,
    };
    let prepared = prepared_trace(content, inputs, &gears, Gear::Pinion);
    let prepared = prepared.map_err(|error| format!("{error:?}"))?;
    let parameters = prepared.flank.report.parameters.ok_or("no parameters")?;
    println!("Rq {:.3} um", 1e6 * parameters.heights.rq.si());
    Ok(())
}
