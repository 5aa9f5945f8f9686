//! Labels along a line, moved so that they do not overlap.

/// Moves `positions` as little as necessary so that they are at least `spacing` apart. The result is in the order of the
/// input.
pub(super) fn spread(positions: &[f64], spacing: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..positions.len()).collect();
    order.sort_by(|a, b| positions[*a].total_cmp(&positions[*b]));
    // Runs of adjacent labels, each centred on the mean of their positions.
    let mut runs: Vec<Vec<usize>> = Vec::new();
    let start = |run: &[usize]| {
        let mean = run.iter().map(|k| positions[*k]).sum::<f64>() / run.len() as f64;
        mean - 0.5 * spacing * (run.len() - 1) as f64
    };
    for label in order {
        let mut run = vec![label];
        while let Some(before) = runs.pop() {
            if start(&before) + spacing * before.len() as f64 <= start(&run) {
                runs.push(before);
                break;
            }
            run = [before, run].concat();
        }
        runs.push(run);
    }
    let mut moved = positions.to_vec();
    for run in &runs {
        for (k, label) in run.iter().enumerate() {
            moved[*label] = start(run) + spacing * k as f64;
        }
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn labels_that_touch_are_moved_apart_and_others_stay() {
        let positions = [0.0, 10.0, 12.0, 14.0, 60.0];
        let moved = spread(&positions, 8.0);
        assert_eq!(moved, [-3.0, 5.0, 13.0, 21.0, 60.0]);
        assert!(moved.windows(2).all(|pair| pair[1] - pair[0] >= 8.0));
    }

    #[test]
    fn labels_keep_their_order_whatever_that_of_the_list() {
        let moved = spread(&[5.0, 4.0, 4.0], 10.0);
        assert!(moved[1] < moved[0] && moved[2] < moved[0]);
        assert!(spread(&[], 10.0).is_empty());
    }
}
