//! Thinned positions and points of the flanks in contact, for a page.

use asperity::result::ContactView;

use crate::thin::thin;

/// Number of positions of a page.
const POSITIONS: usize = 48;
/// Number of bins of a position.
const BINS: usize = 200;

/// At most 48 of `views` in even steps, including the first, the last and the one of the position `shown`. Each is thinned
/// with the extremes of both flanks and both pressures, and rounded to the visible digits: 0.01 µm along the contact, 1 nm of
/// height, 0.1 MPa.
pub(crate) fn thinned_views(views: &[ContactView], shown: Option<usize>) -> Vec<ContactView> {
    let count = views.len().min(POSITIONS);
    let mut selected: Vec<usize> = (0..count)
        .map(|k| k * (views.len() - 1) / count.saturating_sub(1).max(1))
        .collect();
    let index = views.iter().position(|view| Some(view.position) == shown);
    if let Some(index) = index.filter(|index| !selected.contains(index)) {
        // Replaces its nearest neighbour that is not an end.
        let inner = 1..selected.len().saturating_sub(1);
        if let Some(nearest) = inner.min_by_key(|k| selected[*k].abs_diff(index)) {
            selected[nearest] = index;
        }
    }
    selected.into_iter().map(|k| thinned(&views[k])).collect()
}

/// Columns of a view at one point.
type ViewColumns = [f64; 5];

fn thinned(view: &ContactView) -> ContactView {
    let rows: Vec<ViewColumns> = (0..view.x_um.len())
        .map(|k| {
            [
                view.x_um[k],
                view.pinion_um[k],
                view.wheel_um[k],
                view.pressure_solid_mpa[k],
                view.pressure_fluid_mpa[k],
            ]
        })
        .collect();
    let rows = thin(
        &rows,
        BINS,
        |row| row[0],
        |&[_, columns @ ..]: &ViewColumns| columns,
    );
    let column = |k: usize, steps: f64| -> Vec<f64> {
        rows.iter()
            .map(|row| (row[k] * steps).round() / steps)
            .collect()
    };
    let columns = [
        column(1, 1e3),
        column(2, 1e3),
        column(3, 10.0),
        column(4, 10.0),
    ];
    ContactView::new(view.position, column(0, 100.0), columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn views(count: usize, points: usize) -> Vec<ContactView> {
        let view = |position: usize| {
            let x = (0..points).map(|k| k as f64).collect();
            let spike = |at: usize| -> Vec<f64> {
                (0..points)
                    .map(|k| if k == at { 9.0 } else { 0.0 })
                    .collect()
            };
            ContactView::new(
                position,
                x,
                [spike(1), spike(points / 2), spike(3), spike(5)],
            )
        };
        (1..=count).map(view).collect()
    }

    #[test]
    fn ends_and_the_position_shown_stay() {
        let few = thinned_views(&views(1000, 8), Some(501));
        assert_eq!((few.len(), few[0].position), (48, 1));
        assert_eq!(few[47].position, 1000);
        assert!(few.iter().any(|view| view.position == 501));
        assert!(
            few.windows(2)
                .all(|pair| pair[0].position < pair[1].position)
        );
        assert!(thinned_views(&[], None).is_empty());
        assert_eq!(thinned_views(&views(1, 8), Some(1)).len(), 1);
    }

    #[test]
    fn spikes_survive() {
        let few = &thinned_views(&views(1, 10_000), None)[0];
        assert!(few.x_um.len() <= 2 + 8 * BINS);
        for column in [&few.pinion_um, &few.wheel_um, &few.pressure_solid_mpa] {
            assert!(column.contains(&9.0));
        }
    }
}
