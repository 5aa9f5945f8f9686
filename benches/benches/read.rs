//! Reading text at the sizes labs send.

use std::hint::black_box;

use asperity_profile_io::read::{ReadOptions, read_bytes};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// x in mm and heights in um, as instruments export them; the heights have the digits of a rough profile.
fn table(points: usize) -> String {
    let mut text = String::from("x [mm];z [um]\n");
    let mut state = 1_u64;
    for i in 0..points {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        let z = (state >> 33) as f64 / f64::from(u32::MAX) - 0.25;
        text += &format!("{:.4};{z:.5}\n", 0.0005 * i as f64);
    }
    text
}

fn reading(c: &mut Criterion) {
    let mut group = c.benchmark_group("read text");
    group.sample_size(20);
    for points in [10_000, 100_000, 1_000_000] {
        let text = table(points);
        let id = BenchmarkId::from_parameter(points);
        group.bench_with_input(id, text.as_bytes(), |b, bytes| {
            b.iter(|| {
                read_bytes("flank.csv", black_box(bytes), &ReadOptions::default())
                    .expect("the table is valid")
            });
        });
    }
    group.finish();
}

criterion_group!(benches, reading);
criterion_main!(benches);
