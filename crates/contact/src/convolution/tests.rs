use std::f64::consts::TAU;

use asperity_core::numerics::FourierNumber;

use super::*;

/// Values without pattern between −1 and 1.
fn values(count: usize, seed: f64) -> Vec<f64> {
    let value = |k: usize| (seed + 12.9898 * k as f64 * (k + 1) as f64).sin();
    (0..count).map(value).collect()
}

fn assert_close(found: &[f64], expected: &[f64], what: &str) {
    for (f, e) in found.iter().zip(expected) {
        // Round-off of sums of some tens of values of the size of one.
        assert!((f - e).abs() < 1e-13, "{what}: {found:?} {expected:?}");
    }
}

#[test]
fn filtering_is_the_sum_over_all_pairs_of_points() {
    let mut planner = f64::planner();
    for points in 2..60 {
        let (column, signal) = (values(points, 0.3), values(points, 7.1));
        let mut buffers = Buffers::default();
        let filter = EvenFilter::from_column(&mut planner, &column, &mut buffers);
        buffers.reserve(&filter);
        let sum = |lag: &dyn Fn(usize, usize) -> usize| -> Vec<f64> {
            let term = |i, j| 2.0 * column[lag(i, j)] * signal[j];
            let row = |i| (0..points).map(|j| term(i, j)).sum();
            (0..points).map(row).collect()
        };
        filter.filter(&mut buffers, 2.0, &signal);
        let free = sum(&|i, j| i.abs_diff(j));
        assert_close(buffers.signal(points), &free, "free ends");

        let period: Vec<f64> = (0..points).map(|k| column[k.min(points - k)]).collect();
        let filter = EvenFilter::from_period(&mut planner, &period, &mut buffers);
        buffers.reserve(&filter);
        filter.filter(&mut buffers, 2.0, &signal);
        let around = sum(&|i, j| i.abs_diff(j).min(points - i.abs_diff(j)));
        assert_close(buffers.signal(points), &around, "periodic");

        let mean = 2.0 / points as f64 * period.iter().sum::<f64>();
        let total: f64 = signal.iter().sum();
        let without: Vec<f64> = around.iter().map(|y| y - mean * total).collect();
        let filter = filter.without_mean();
        filter.filter(&mut buffers, 2.0, &signal);
        assert_close(buffers.signal(points), &without, "without mean");
    }
}

#[test]
fn runs_are_filtered_as_among_zeros() {
    let points = 41;
    let (column, all) = (values(points, 0.3), values(points, 7.1));
    let (mut planner, mut buffers) = (f64::planner(), Buffers::default());
    let filter = EvenFilter::from_column(&mut planner, &column, &mut buffers);
    buffers.reserve(&filter);
    let runs = [
        Run::new(1, 2),
        Run::new(5, 9),
        Run::new(12, 33),
        Run::new(40, 41),
    ];
    let list: Vec<usize> = runs.iter().flat_map(|run| run.range()).collect();
    let mut signal = vec![0.0; points];
    for &i in &list {
        signal[i] = all[i];
    }
    filter.filter(&mut buffers, 1.0, &signal);
    let expected = buffers.signal(points).to_vec();
    for (to, &i) in buffers.signal(points).iter_mut().zip(&list) {
        *to = all[i];
    }
    filter.filter_runs(&mut buffers, 1.0, &runs);
    assert_close(buffers.signal(points), &expected, "runs");
}

#[test]
fn a_symbol_multiplies_each_wave() {
    for length in [2, 9, 12, 40] {
        let symbol = |k: usize| 1.0 / (1.0 + k as f64);
        let (mut planner, mut buffers) = (f64::planner(), Buffers::default());
        let filter = EvenFilter::from_symbol(&mut planner, length, length, symbol);
        buffers.reserve(&filter);
        for k in 0..=length / 2 {
            let wave: Vec<f64> = (0..length)
                .map(|j| (0.4 + TAU * (k * j) as f64 / length as f64).cos())
                .collect();
            // The wave at half the sampling rate has only its cosine.
            let scaled: Vec<f64> = wave.iter().map(|x| x * symbol(k)).collect();
            filter.filter(&mut buffers, 1.0, &wave);
            assert_close(buffers.signal(length), &scaled, "wave");
        }
    }
}

#[test]
fn fast_lengths_are_near_and_even() {
    for least in 1..5_000 {
        let length = fast_length(least);
        assert!(length.is_multiple_of(2) && length >= least);
        assert!(
            length as f64 <= 1.26 * least as f64 + 8.0,
            "{least}: {length}"
        );
    }
    assert_eq!(fast_length(10_000), 10_240);
    assert_eq!(fast_length(100_000), 102_400);
    assert_eq!(fast_length(4_608), 4_608);
}
