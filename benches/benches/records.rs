//! Records of gear meshes with heat, of the first 256 steps of each record: at most 3.4 ms a step on
//! 22 November 2026.
use std::path::Path;
use std::time::Duration;

use asperity::ehl::{RecordSettings, transient};
use asperity::reference_solution::ReferenceContact;
use asperity_benches::WORKSPACE;
use criterion::{Criterion, criterion_group, criterion_main};

#[path = "../../crates/asperity/examples/mixed_ehl_records.rs"]
#[allow(dead_code, reason = "the example also makes the tables")]
mod mixed_ehl_records;

/// A moderate record, one of hot thin films, and the one whose steps cost most.
const RECORDS: [&str; 3] = ["e-half_90_0.1", "e-ground_150_0.1", "fzg_0.5_0.15"];

fn records(criterion: &mut Criterion) {
    let workspace = Path::new(WORKSPACE);
    let settings = RecordSettings {
        start: 0.0,
        length: 2.0,
        ..RecordSettings::default()
    };
    let mut group = criterion.benchmark_group("256 steps with heat");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5));
    let conditions = mixed_ehl_records::conditions();
    let chosen = conditions
        .iter()
        .filter(|condition| RECORDS.contains(&&*condition.name));
    for condition in chosen {
        let loaded = condition.load(workspace).expect("a condition");
        let loaded = loaded.at_stated().expect("a condition");
        let settings = condition.settings(&settings);
        let contact =
            ReferenceContact::new(&loaded, condition.position, &settings).expect("a contact");
        group.bench_function(&condition.name, |bencher| {
            bencher.iter(|| transient::record(&contact.rough, &contact.record).expect("a record"));
        });
    }
}

criterion_group!(benches, records);
criterion_main!(benches);
