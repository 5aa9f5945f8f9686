//! Losses of a run at the median of their draws.

use asperity_core::cite;
use asperity_core::quantity::Power;
use asperity_efficiency::equivalent_friction;
use asperity_efficiency::output_torque::power_flow;

use super::cycle::operation;
use crate::gearbox;
use crate::result::{
    GearboxReport, Losses, MeshOutcome, OffsetRow, PairSampling, PositionRow, RunInFlanks, Summary,
};
use asperity_case::case::Case;
use asperity_case::error::{Error, PositionError};

/// Losses of a run restated at the median of their draws: each part by the same ratio, so that sums still add up.
///
/// ```text
/// P' = r P,  μ' = r μ,  r = P_median/P_run                                        [Loss-at-median]
/// ```
///
/// P, μ: losses \[W\] and friction coefficients of the run with every constant at its median. Efficiencies follow from the losses.
/// Loads, films, shares, pressures and temperatures remain those of the run.
struct Restated<'a> {
    case: &'a Case,
    loss_w: f64,
    ratio: f64,
}

impl MeshOutcome {
    /// States the loss `loss_w` \[W\] of `case` instead of the present one.
    pub(crate) fn restate(&mut self, case: &Case, loss_w: f64) -> Result<(), Error> {
        let result = &mut self.result;
        let restated = Restated::new(case, &result.summary, loss_w);
        restated.with_gearbox(&mut result.summary, &mut result.gearbox)?;
        let points = result.points.iter_mut().map(|point| &mut point.row);
        points.for_each(|row| restated.row(row));
        let mut sampling = None;
        if let Some(pairs) = &mut result.pairs {
            let losses = pairs.losses_w.iter_mut().flatten();
            let of_traces = pairs.traces.iter_mut().flatten();
            let of_traces = of_traces.filter_map(|trace| trace.loss_w.as_mut());
            losses
                .chain(of_traces)
                .for_each(|loss| *loss *= restated.ratio);
            sampling = pairs.sampling.as_mut();
        }
        let run_in = result.run_in.as_mut();
        restated.parts(&mut result.path, sampling, run_in, &mut self.offsets)
    }

    /// States the loss `loss_w` \[W\] of `case` with its uncertainty instead of the present ones.
    pub(crate) fn restate_drawn(&mut self, case: &Case, loss_w: f64) -> Result<(), Error> {
        let before = self.result.summary.loss_w;
        self.restate(case, loss_w)?;
        let factor = if before > 0.0 { loss_w / before } else { 1.0 };
        let result = &mut self.result;
        result.uncertainty = result.uncertainty.take().map(|found| found.times(factor));
        result.scans = result.scans.take().map(|scans| scans.times(factor));
        Ok(())
    }
}

impl Losses {
    /// States the loss `loss_w` \[W\] of `case` instead of the present one.
    ///
    /// # Errors
    /// When the loss is not below the power into the mesh.
    pub(crate) fn restate(&mut self, case: &Case, loss_w: f64) -> Result<(), Error> {
        let restated = Restated::new(case, &self.summary, loss_w);
        restated.with_gearbox(&mut self.summary, &mut self.gearbox)?;
        let (sampling, run_in) = (self.pairs.as_mut(), self.run_in.as_mut());
        restated.parts(&mut self.path, sampling, run_in, &mut self.offsets)
    }
}

impl<'a> Restated<'a> {
    fn new(case: &'a Case, summary: &Summary, loss_w: f64) -> Self {
        cite!("Loss-at-median");
        Self {
            case,
            loss_w: if summary.loss_w > 0.0 {
                loss_w
            } else {
                summary.loss_w
            },
            ratio: if summary.loss_w > 0.0 {
                loss_w / summary.loss_w
            } else {
                1.0
            },
        }
    }

    fn with_gearbox(
        &self,
        summary: &mut Summary,
        gearbox: &mut Option<GearboxReport>,
    ) -> Result<(), Error> {
        self.summary(summary, self.loss_w).map_err(Box::new)?;
        let mesh = Power::from_si(summary.loss_w);
        *gearbox = gearbox::report_of_mesh(self.case, mesh).map_err(Box::new)?;
        if let Some(found) = gearbox {
            summary.gearbox_efficiency = Some(found.efficiency);
            summary.gearbox_loss_w = Some(found.loss_w);
        }
        Ok(())
    }

    /// States the loss `loss_w`, the ratio times the present one up to rounding.
    fn summary(&self, s: &mut Summary, loss_w: f64) -> Result<(), PositionError> {
        s.loss_at_medians_w.get_or_insert(s.loss_w);
        let [pinion, wheel] = &mut s.deformation_w;
        for power in [
            &mut s.loss_w,
            &mut s.sliding_w,
            &mut s.film_w,
            &mut s.lubricated_asperity_w,
            &mut s.boundary_w,
            &mut s.rolling_w,
            &mut s.hysteresis_w,
            pinion,
            wheel,
        ] {
            *power *= self.ratio;
        }
        s.loss_w = loss_w;
        let flow = power_flow(&operation(self.case), Power::from_si(s.loss_w))?;
        s.efficiency = flow.efficiency;
        s.efficiency_deviation = s.efficiency_deviation.map(|spread| spread * self.ratio);
        s.power_in_w = flow.input_power.si();
        s.torque_out_nm = flow.output_torque.si();
        s.mu_equivalent = equivalent_friction(s.efficiency, s.loss_factor_local)?.value;
        Ok(())
    }

    fn row(&self, row: &mut PositionRow) {
        for number in [
            &mut row.mu_film,
            &mut row.mu,
            &mut row.sliding_w_per_m,
            &mut row.film_w_per_m,
            &mut row.lubricated_asperity_w_per_m,
            &mut row.boundary_w_per_m,
            &mut row.rolling_w_per_m,
        ] {
            *number *= self.ratio;
        }
        for spread in [
            &mut row.sliding_deviation_w_per_m,
            &mut row.sliding_standard_error_w_per_m,
        ] {
            *spread = spread.map(|spread| spread * self.ratio);
        }
    }

    /// The losses along the path, of pairs of traces, of flanks run in and of offsets. Flanks that have run in
    /// are not drawn: they have the ratio of the flanks as measured.
    fn parts(
        &self,
        path: &mut [PositionRow],
        sampling: Option<&mut PairSampling>,
        run_in: Option<&mut RunInFlanks>,
        offsets: &mut [OffsetRow],
    ) -> Result<(), Error> {
        path.iter_mut().for_each(|row| self.row(row));
        if let Some(sampling) = sampling {
            *sampling = sampling.times(self.ratio);
        }
        if let Some(flanks) = run_in {
            let loss_w = self.ratio * flanks.summary.loss_w;
            self.summary(&mut flanks.summary, loss_w)
                .map_err(Box::new)?;
        }
        for row in offsets {
            for power in [&mut row.loss_w, &mut row.sliding_w, &mut row.rolling_w] {
                *power *= self.ratio;
            }
            let flow = power_flow(&operation(self.case), Power::from_si(row.loss_w));
            row.efficiency = flow
                .map_err(PositionError::from)
                .map_err(Box::new)?
                .efficiency;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use crate::pipeline::losses;
    use asperity_case::case::load_with;

    #[test]
    fn a_restated_run_keeps_its_sums_and_its_power_flow() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let drive = load_with(file, &|input| {
            (input.model.positions, input.model.offsets) = (Some(4), Some(2));
            let seal = r#"[{ shaft = "pinion", diameter = "40 mm" }]"#;
            let _ = input.set("gearbox.seals", seal);
        });
        let drive = drive.unwrap();
        let coast = drive.with_key("operation.torque", "-145 N m").unwrap();
        for case in [drive, coast] {
            let before = losses(&case).unwrap();
            let mut after = before.clone();
            after
                .restate(&case.case, 1.1 * before.summary.loss_w)
                .unwrap();
            let s = &after.summary;
            assert_eq!(s.loss_at_medians_w, Some(before.summary.loss_w));
            let is = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-12;
            let parts = [s.film_w, s.lubricated_asperity_w, s.boundary_w, s.rolling_w];
            assert!(is(parts.iter().sum(), s.loss_w));
            let along = after
                .path
                .iter()
                .map(|row| row.weight_m * row.loss_w_per_m());
            assert!(is(along.sum(), s.loss_w));
            let mean = after.offsets.iter().map(|row| row.loss_w).sum::<f64>() / 2.0;
            assert!(is(mean, s.loss_w));
            for (before, after) in before.path.iter().zip(&after.path) {
                let force = after.sliding_load_n_per_mm * 1e3 * after.mu;
                let speed = after.sliding_m_per_s.abs();
                let is_still = speed == 0.0 || before.sliding_w_per_m == 0.0;
                assert!(is_still || is(force * speed, after.sliding_w_per_m));
                assert_eq!(before.film_share, after.film_share);
            }
            // The torque of the pinion is stated: the power into the mesh is its power, or in addition the loss.
            assert!(is((1.0 - s.efficiency) * s.power_in_w, s.loss_w));
            let stated = case.case.torque.si().abs() * case.case.speed.si();
            let driven = if case.case.torque.si() < 0.0 {
                s.loss_w
            } else {
                0.0
            };
            assert!(is(s.power_in_w, stated + driven));
            assert!(is(
                s.mu_equivalent * s.loss_factor_local,
                1.0 - s.efficiency
            ));
            let gearbox = after.gearbox.as_ref().unwrap();
            assert!(is(gearbox.loss_w, s.loss_w + gearbox.parts_w));
            assert_eq!(s.gearbox_loss_w, Some(gearbox.loss_w));
            // Restated at its first loss it is the run.
            after.restate(&case.case, before.summary.loss_w).unwrap();
            assert!(is(after.summary.film_w, before.summary.film_w));
        }
    }
}
