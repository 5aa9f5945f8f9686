//! From solved positions to the result: rows, summary, warnings.

mod cycle;
mod deformation_losses;
mod micropitting;
mod provenance;
mod published_laws;
mod restated;
mod reversed;
mod solved;
mod warnings;

pub(crate) use warnings::{
    far_lay, gearbox as warnings_of_gearbox, of_case as warnings_of_case, relief as relief_warning,
};

pub use reversed::Reversed;

pub(crate) use cycle::operation;
pub(crate) use provenance::{equations_used, sources_used};
pub(crate) use solved::Solved;

use asperity_core::message::gravest_first;
use asperity_core::numerics::{deviation, mean, median};
use asperity_core::quantity::Power;
use asperity_core::{Fault, PROGRAM};
use asperity_efficiency::output_torque::power_flow;
use asperity_efficiency::{LossKind, MeshEfficiency, MeshOperation, equivalent_friction};
use asperity_gear::EdgeContactNote;

use self::deformation_losses::of_all_offsets;
use self::published_laws::published_laws;
use crate::contacts::running_in::RanIn;
use crate::gearbox;
use crate::lubrication::{ContactNumbers, LubricatedPosition, LubricatedWindow, rolling};
use crate::pictures::Picture;
use crate::records::{PathRecords, PlacedRecord};
use crate::result::film_constants::film_constants;
use crate::result::{
    FlankRecord, GearboxReport, LoadReport, Losses, MeshOutcome, OffsetRow, PairSampling, PointRow,
    PositionRow, RecordRow, Regime, RunInFlanks, RunResult, RunningIn, SCHEMA_VERSION, Scope,
    Summary, ToothTrace, TracePairs,
};
use crate::sampling::{means_of_pairs, sampling_of_teeth};
use asperity_case::balance::{efficiency, finite, sum};
use asperity_case::case::{Case, ShareLaw};
use asperity_case::error::PositionError;
use asperity_case::message::Warning;

impl Solved<'_> {
    /// Losses, without the other parts of a result.
    pub(crate) fn losses(self) -> Result<Losses, PositionError> {
        let (summary, gearbox) = self.with_gearbox()?;
        let path = self.path()?;
        let running_in = self.running_in()?;
        check(&summary, gearbox.as_ref(), &path)?;
        // Losses do not need the second load map of a warning, and are no worse without it.
        let edge_contact = self.map.edge_contact_note().ok().flatten();
        Ok(Losses {
            outside: warnings::outside(self.loaded, &self.positions, &summary)?,
            warnings: self.warnings(
                &summary,
                gearbox.as_ref(),
                edge_contact.as_ref(),
                &[],
                &self.record_rows(),
            )?,
            summary,
            path,
            offsets: offset_rows(&self.meshes),
            pairs: self.pairs().and_then(|(_, sampling)| sampling),
            running_in,
            run_in: None,
            bulk: self.loaded.bulk_report().cloned(),
            gearbox,
            equations: Vec::new(),
        })
    }

    /// The outcome of a run; what its equations are is noted by the caller.
    pub(crate) fn outcome(
        self,
        pictures: Vec<Option<Picture>>,
        points: &[(&'static str, LubricatedPosition)],
    ) -> Result<MeshOutcome, PositionError> {
        let case = self.loaded;
        let (summary, gearbox) = self.with_gearbox()?;
        let path = self.path()?;
        let running_in = self.running_in()?;
        check(&summary, gearbox.as_ref(), &path)?;
        let load = LoadReport::new(case, self.map)?;
        let named = points.iter().filter(|(name, _)| ["A", "E"].contains(name));
        let ends: Vec<&LubricatedPosition> = named.map(|(_, position)| position).collect();
        let views = pictures.iter().map(|picture| Some(&picture.as_ref()?.view));
        let views: Vec<_> = views.collect();
        let micropitting = micropitting::report(self.loaded, &self.positions, &views, &ends)?;
        let records = self.record_rows();
        let edge_contact = load.edge_contact.as_ref();
        let warnings = self.warnings(
            &summary,
            gearbox.as_ref(),
            edge_contact,
            &pictures,
            &records,
        )?;
        let result = RunResult {
            schema_version: SCHEMA_VERSION,
            program: PROGRAM.to_owned(),
            title: case.title.clone(),
            case_file: self.loaded.file_name(),
            mesh: None,
            formulation: case.formulation,
            published_laws: published_laws(&self)?,
            load,
            path: with_stress(path, &pictures),
            points: self.points(points)?,
            records,
            uncertainty: None,
            bulk: case.bulk_report().cloned(),
            gearbox,
            micropitting,
            running_in,
            run_in: None,
            ridges: None,
            no_ridges: None,
            no_scans: None,
            scans: None,
            summary,
            warnings,
            flanks: [0, 1].map(|body| FlankRecord::from(&self.loaded.flanks[body])),
            pairs: self.trace_pairs(),
            gears: case.gears.clone(),
            lubricant: *case.oil(),
            film_constants: film_constants(case)?,
            inputs: case.input.clone(),
            defaults: case.defaults.clone(),
            equations: Vec::new(),
            references: Vec::new(),
        };
        let (mut fields, mut views) = (Vec::new(), Vec::new());
        for picture in pictures.into_iter().flatten() {
            fields.extend(picture.fields);
            views.push(picture.view);
        }
        Ok(MeshOutcome {
            result,
            offsets: offset_rows(&self.meshes),
            fields,
            views,
            load_map: self.map.clone(),
            traces: [0, 1].map(|body| self.loaded.flanks[body].trace.clone()),
        })
    }

    /// Every warning about a solved case: its files, positions and gearbox, the load over its teeth, its records. Losses have
    /// no pictures.
    fn warnings(
        &self,
        summary: &Summary,
        gearbox: Option<&GearboxReport>,
        edge_contact: Option<&EdgeContactNote>,
        pictures: &[Option<Picture>],
        records: &[RecordRow],
    ) -> Result<Vec<Warning>, PositionError> {
        let (loaded, positions) = (self.loaded, &self.positions);
        let mut warnings = loaded.warnings_here();
        warnings.extend(warnings::warnings(loaded, positions, pictures, summary)?);
        let parts = gearbox.iter().flat_map(|report| &report.parts);
        warnings::gearbox(parts, &mut warnings);
        warnings::micropitting(loaded, &mut warnings);
        let evidence = self.map.evidence();
        let at = positions.iter().map(|position| &position.at);
        warnings::load(loaded, at, edge_contact, evidence, &mut warnings);
        warnings::records(loaded, records, &mut warnings)?;
        gravest_first(&mut warnings, |warning| Some(warning.code));
        Ok(warnings)
    }

    fn record_rows(&self) -> Vec<RecordRow> {
        let rows = |records| record_rows(self.loaded, records);
        self.records.map(rows).unwrap_or_default()
    }

    /// Loss of each pair of teeth and the error of their mean, if there are several; none of one trace for each flank.
    fn pairs(&self) -> Option<(Vec<f64>, Option<PairSampling>)> {
        let surfaces = &self.loaded.surfaces;
        surfaces.teeth()?;
        let losses: Vec<f64> = self.meshes.iter().map(|m| m.flow.loss.si()).collect();
        let sampling = sampling_of_teeth(&losses, surfaces);
        Some((means_of_pairs(&losses, surfaces.pairs()), sampling))
    }

    fn trace_pairs(&self) -> Option<TracePairs> {
        let (losses, sampling) = self.pairs()?;
        let sampled = self.loaded.sampled.as_ref()?;
        let rows = losses.chunks(self.loaded.surfaces.teeth()?[1]);
        let losses_w: Vec<Vec<f64>> = rows.map(<[f64]>::to_vec).collect();
        let of_trace = |body: usize, tooth: usize| {
            let of_pairs: Vec<f64> = match body {
                0 => losses_w.get(tooth)?.clone(),
                _ => losses_w
                    .iter()
                    .filter_map(|row| row.get(tooth).copied())
                    .collect(),
            };
            (!of_pairs.is_empty()).then(|| mean(of_pairs))
        };
        let of = |body: usize| {
            let traces = sampled.traces[body].iter().map(|trace| ToothTrace {
                loss_w: of_trace(body, trace.tooth),
                ..ToothTrace::from(trace)
            });
            traces.collect()
        };
        Some(TracePairs {
            traces: [of(0), of(1)],
            losses_w,
            sampling,
        })
    }

    /// A row of the path with what is known of it between traces.
    fn row(&self, position: &LubricatedPosition, rolling: f64, per_width: f64) -> PositionRow {
        let case = self.loaded;
        let row = row(case, position, rolling, per_width);
        let sliding = position.at.mean_sliding();
        let forces: Vec<f64> = position
            .offsets
            .iter()
            .map(|o| sliding * o.friction_force)
            .collect();
        let between = sampling_of_teeth(&forces, &self.loaded.surfaces);
        PositionRow {
            sliding_standard_error_w_per_m: between.map(|found| found.standard_error_w),
            sliding_error_freedom: between.map(|found| found.freedom),
            face_zone: (!case.face_zones.is_empty()).then_some(position.at.zone),
            sliding_deviation_w_per_m: row
                .sliding_deviation_w_per_m
                .filter(|_| !matches!(case.share_law(), ShareLaw::Reference)),
            ..row
        }
    }

    /// Report on flanks that have run in.
    pub(crate) fn run_in_flanks(&self, ran_in: RanIn) -> Result<RunInFlanks, PositionError> {
        let [measured, run_in] = ran_in.heights;
        let summary = self.summary()?;
        let running_in = self.running_in()?;
        check(&summary, None, &self.path()?)?;
        let plan = self.loaded.case.running_in.as_ref();
        let torque = plan.map_or(self.loaded.case.torque, |plan| plan.torque);
        Ok(RunInFlanks {
            torque_nm: torque.si(),
            summary,
            running_in,
            measured,
            run_in,
            steps: ran_in.steps,
            is_settled: ran_in.is_settled,
        })
    }

    /// Plastic work of the first engagement, which no loss includes; none where the pressures of the windows give the deformation,
    /// of which it is a part.
    fn running_in(&self) -> Result<RunningIn, PositionError> {
        let mut windows = self.positions.iter().flat_map(|at| &at.offsets);
        let power = if windows.all(|window| window.deformation.is_some()) {
            0.0
        } else {
            of_all_offsets(self.loaded, &self.positions)?.plastic.si()
        };
        let period = self.meshes.first();
        let period = period.map_or(0.0, |mesh| mesh.engagement_period.si());
        Ok(RunningIn {
            energy_per_engagement_j: power * period,
            first_pass_w: power,
        })
    }

    fn path(&self) -> Result<Vec<PositionRow>, PositionError> {
        let case = self.loaded;
        let forces = case.gears.forces(case.torque)?;
        let per_width = forces.transverse_base.si() / case.gears.face_width.si();
        Ok(self
            .positions
            .iter()
            .zip(&self.rolling)
            .map(|(position, rolling)| self.row(position, *rolling, per_width))
            .collect())
    }

    fn points(
        &self,
        points: &[(&'static str, LubricatedPosition)],
    ) -> Result<Vec<PointRow>, PositionError> {
        let case = self.loaded;
        let forces = case.gears.forces(case.torque)?;
        let per_width = forces.transverse_base.si() / case.gears.face_width.si();
        points
            .iter()
            .map(|(point, position)| {
                let rolling = rolling(case, &position.at, &position.film)?;
                Ok(PointRow {
                    point: (*point).into(),
                    row: self.row(position, rolling, per_width),
                })
            })
            .collect()
    }

    /// The summary of the mesh, and the gearbox around it, where the case states one.
    fn with_gearbox(&self) -> Result<(Summary, Option<GearboxReport>), PositionError> {
        let mut summary = self.summary()?;
        let mesh = Power::from_si(summary.loss_w);
        let gearbox = gearbox::report_of_mesh(self.loaded, mesh)?;
        if let Some(found) = &gearbox {
            summary.scope = Scope::Gearbox;
            summary.gearbox_efficiency = Some(found.efficiency);
            summary.gearbox_loss_w = Some(found.loss_w);
        }
        Ok((summary, gearbox))
    }

    pub(crate) fn summary(&self) -> Result<Summary, PositionError> {
        let case = self.loaded;
        let (positions, meshes) = (&self.positions, &self.meshes);
        let factors = [case.gears.ohlendorf_loss_factor(), self.map.loss_factor()];
        let mut summary = summary(positions, meshes, &operation(case), factors)?;
        if let Some(records) =
            (self.records).filter(|_| matches!(case.share_law(), ShareLaw::Reference))
        {
            let places = || positions.iter().map(|position| &position.at);
            let weighted = places().map(|at| (at.s, at.weight));
            summary.asperity_share_standard_error = Some(records.mean_share_error(weighted));
            // Every offset has the friction of the records.
            summary.efficiency_deviation = None;
            let powers = places().map(|at| (at.s, at.weight * at.mean_sliding() * at.load.si()));
            summary.recorded_friction = records.friction_error(powers);
        }
        let swept = of_all_offsets(case, positions)?;
        summary.hysteresis_w = swept.hysteresis.si();
        summary.elastic_cycling_w = swept.elastic_cycling.si();
        Ok(summary)
    }
}

/// Invariants of a result: every number finite, parts that add up to their totals, efficiencies within 0 and 1.
fn check(s: &Summary, gearbox: Option<&GearboxReport>, path: &[PositionRow]) -> Result<(), Fault> {
    let along = |of: fn(&PositionRow) -> f64| {
        let powers = path.iter().map(|row| row.weight_m * of(row));
        powers.collect::<Vec<f64>>()
    };
    let [pinion, wheel] = s.deformation_w;
    let loss = [s.sliding_w, s.rolling_w, pinion, wheel];
    let sliding = [s.film_w, s.lubricated_asperity_w, s.boundary_w];
    let sliding_along = along(|row| row.sliding_w_per_m);
    let rolling_along = along(|row| row.rolling_w_per_m);
    sum("loss", "W", s.loss_w, &loss)?;
    sum("sliding loss", "W", s.sliding_w, &sliding)?;
    sum(
        "sliding loss along the path",
        "W",
        s.sliding_w,
        &sliding_along,
    )?;
    sum(
        "rolling loss along the path",
        "W",
        s.rolling_w,
        &rolling_along,
    )?;
    efficiency("efficiency", s.efficiency, s.loss_w, s.power_in_w)?;
    if let Some(of) = gearbox {
        sum(
            "loss of the gearbox",
            "W",
            of.loss_w,
            &[s.loss_w, of.parts_w],
        )?;
        efficiency(
            "efficiency of the gearbox",
            of.efficiency,
            of.loss_w,
            of.power_in_w,
        )?;
    }
    finite("torque out", "N m", s.torque_out_nm)?;
    finite("equivalent friction", "-", s.mu_equivalent)?;
    finite("hysteresis", "W", s.hysteresis_w)?;
    finite("elastic work", "W", s.elastic_cycling_w)?;
    finite("share of the asperities", "-", s.asperity_share)
}

fn offset_rows(meshes: &[MeshEfficiency]) -> Vec<OffsetRow> {
    let row = |(index, mesh): (usize, &MeshEfficiency)| OffsetRow {
        offset: index + 1,
        efficiency: mesh.flow.efficiency,
        loss_w: mesh.flow.loss.si(),
        sliding_w: mesh.breakdown.power(LossKind::Sliding).si(),
        rolling_w: mesh.breakdown.power(LossKind::Rolling).si(),
    };
    meshes.iter().enumerate().map(row).collect()
}

fn summary(
    positions: &[LubricatedPosition],
    meshes: &[MeshEfficiency],
    operation: &MeshOperation,
    [ohlendorf, local]: [f64; 2],
) -> Result<Summary, PositionError> {
    let efficiencies: Vec<f64> = meshes.iter().map(|mesh| mesh.flow.efficiency).collect();
    let loss = mean(meshes.iter().map(|mesh| mesh.flow.loss.si()));
    // Of the mean loss: where the wheel drives, the mean of the efficiencies is another number.
    let flow = power_flow(operation, Power::from_si(loss))?;
    let efficiency = flow.efficiency;
    let power = |kind| mean(meshes.iter().map(|mesh| mesh.breakdown.power(kind).si()));
    // A single position may stand for the mesh; the loss factor is of the whole path.
    let equivalent = equivalent_friction(efficiency, local)?;
    let contacts = || {
        positions
            .iter()
            .flat_map(|position| &position.offsets)
            .filter_map(|offset| offset.contact)
    };
    let total: f64 = positions.iter().map(|position| position.at.weight).sum();
    let mixed: f64 = positions
        .iter()
        .map(|position| position.at.weight * mixed_share(position))
        .sum();
    // Means of the parts are parts of the mean: the cycle mean is linear in the force.
    let part_of = |part: usize| {
        let parts = positions.iter().map(|position| {
            position.at.weight
                * position.at.mean_sliding()
                * mean(forces(position).map(|force| force[part]))
        });
        parts.sum()
    };
    let share_of = |of: &dyn Fn(&LubricatedWindow) -> f64| {
        let shares = positions
            .iter()
            .map(|position| position.at.weight * mean(position.offsets.iter().map(of)));
        shares.sum::<f64>() / total
    };
    let (sliding_w, boundary_w) = (power(LossKind::Sliding), part_of(2));
    Ok(Summary {
        scope: Scope::Mesh,
        gearbox_efficiency: None,
        gearbox_loss_w: None,
        efficiency,
        efficiency_deviation: deviation(&efficiencies),
        offsets: meshes.len(),
        power_in_w: flow.input_power.si(),
        torque_out_nm: flow.output_torque.si(),
        loss_w: loss,
        loss_at_medians_w: None,
        sliding_w,
        film_w: part_of(0),
        lubricated_asperity_w: part_of(1),
        boundary_w,
        rolling_w: power(LossKind::Rolling),
        deformation_w: [
            power(LossKind::DeformationPinion),
            power(LossKind::DeformationWheel),
        ],
        deformation_in_contact_w: [0, 1].map(|body: usize| {
            let of = |offset: &LubricatedWindow| {
                offset
                    .deformation
                    .map_or(0.0, |power| power.in_contact[body])
            };
            let at = positions
                .iter()
                .map(|position| mean(position.offsets.iter().map(of)));
            at.sum()
        }),
        hysteresis_w: 0.0,
        elastic_cycling_w: 0.0,
        asperity_share: share_of(&|offset| 1.0 - offset.film_share),
        asperity_share_standard_error: None,
        recorded_friction: None,
        boundary_share: share_of(&boundary_share),
        mu_equivalent: equivalent.value,
        loss_factor_ohlendorf: ohlendorf,
        loss_factor_local: local,
        mixed_share: mixed / total,
        regime: Regime::of_friction(mixed / total, boundary_w, sliding_w),
        positions: positions.len(),
        worst_load_error: contacts().map(|c| c.load_error).fold(0.0, f64::max),
        worst_duality_gap: contacts().map(|c| c.duality_gap).fold(0.0, f64::max),
    })
}

/// Friction forces \[N/m\] of film, lubricated asperities and boundary layer at each offset.
fn forces(position: &LubricatedPosition) -> impl Iterator<Item = [f64; 3]> {
    let offsets = position.offsets.iter();
    offsets.map(|offset| offset.rubbing.parts(offset.friction.mu))
}

/// Share of the load on the boundary layer: all that the asperities carry, if the law does not distinguish.
fn boundary_share(offset: &LubricatedWindow) -> f64 {
    (1.0 - offset.film_share) * offset.boundary_part
}

/// A row of the path; `per_width` is the transverse base force over the face width \[N/m\], which is the
/// load of a line of contact that carries everything.
fn row(case: &Case, position: &LubricatedPosition, rolling: f64, per_width: f64) -> PositionRow {
    let (at, film) = (&position.at, &position.film);
    let motion = &at.motion;
    let offsets = &position.offsets;
    let path = case.gears.path();
    let over = |value: fn(&LubricatedWindow) -> f64| mean(offsets.iter().map(value));
    let contacts: Vec<_> = offsets.iter().filter_map(|offset| offset.contact).collect();
    let touching = |value: fn(&ContactNumbers) -> f64| {
        (!contacts.is_empty()).then(|| mean(contacts.iter().map(value)))
    };
    let known: Vec<f64> = offsets
        .iter()
        .filter_map(|offset| offset.lambda_star)
        .collect();
    let frictions: Vec<f64> = offsets.iter().map(|o| o.friction_force).collect();
    let force = mean(frictions.iter().copied());
    let share = mixed_share(position);
    let solid = over(|offset| 1.0 - offset.film_share);
    let gaps: Vec<f64> = offsets
        .iter()
        .filter_map(|offset| {
            let recorded = offset.recorded.map(|recorded| recorded.mean_gap.mean);
            recorded.or_else(|| Some(offset.solved?.mean_gap.si()))
        })
        .collect();
    let recorded = offsets.first().and_then(|offset| offset.recorded);
    let sliding = at.mean_sliding();
    let parts = [0, 1, 2].map(|part| mean(forces(position).map(|force| force[part])));
    let surfaces = case.formulation.rolling_surfaces().count();
    PositionRow {
        position: at.number,
        s_mm: at.s.si() * 1e3,
        path_fraction: (at.s - path.a) / (path.e - path.a),
        weight_m: at.weight,
        line_load_n_per_mm: at.load.si() * 1e-3,
        sliding_load_n_per_mm: at.load.si() * at.sliding_factor * 1e-3,
        load_share: at.load.si() / per_width,
        radius_mm: motion.radius.si() * 1e3,
        u1_m_per_s: motion.u1.si(),
        u2_m_per_s: motion.u2.si(),
        sliding_m_per_s: motion.sliding.si(),
        entrainment_m_per_s: motion.entrainment.si(),
        slide_to_roll: motion.slide_to_roll,
        half_width_um: at.hertz.half_width.si() * 1e6,
        hertz_pressure_mpa: at.hertz.max_pressure.si() * 1e-6,
        thermal_reduction: film.thermal_reduction,
        film_central_um: film.shown.central.si() * 1e6,
        film_minimum_um: film.shown.minimum.si() * 1e6,
        lambda_star: median(known),
        // Between flat flanks it has no limit.
        film_ratio: Some(over(|offset| offset.film_ratio)).filter(|ratio| ratio.is_finite()),
        mixed_share: share,
        regime: Regime::of_friction(share, parts[2], force),
        film_share: over(|offset| offset.film_share),
        film_share_standard_error: recorded.map(|share| share.solid_share.standard_error),
        boundary_of_asperities: (solid > 0.0).then(|| over(boundary_share) / solid),
        boundary_share: over(boundary_share),
        mean_gap_um: (!gaps.is_empty()).then(|| mean(gaps.iter().copied()) * 1e6),
        roughness_over_film: {
            let solved = offsets.iter().filter_map(|offset| offset.solved);
            let ratios: Vec<f64> = solved.map(|share| share.roughness_over_film).collect();
            (!ratios.is_empty()).then(|| mean(ratios))
        },
        full_film: position.full_film.as_ref().map(|film| film.row),
        mu_film: over(|offset| offset.friction.mu),
        mu: force / at.load.si(),
        flash_k: over(|offset| offset.flash),
        flash_max_k: offsets
            .iter()
            .map(|offset| offset.flash)
            .fold(0.0, f64::max),
        sliding_w_per_m: force * sliding,
        sliding_standard_error_w_per_m: None,
        sliding_error_freedom: None,
        face_zone: None,
        sliding_deviation_w_per_m: deviation(&frictions).map(|force| force * sliding),
        film_w_per_m: parts[0] * sliding,
        lubricated_asperity_w_per_m: parts[1] * sliding,
        boundary_w_per_m: parts[2] * sliding,
        rolling_w_per_m: surfaces * rolling * motion.entrainment.si(),
        contact_fraction: touching(|contact| contact.contact_fraction),
        p_max_mpa: position.rough_pressure(),
        plastic_work_j_per_m: touching(|contact| contact.plastic_work),
        von_mises_max_mpa: None,
        von_mises_depth_um: None,
        yield_depth_um: None,
        yield_share: None,
        iterations: contacts.iter().map(|contact| contact.iterations).sum(),
        load_error: contacts.iter().map(|c| c.load_error).fold(0.0, f64::max),
    }
}

/// Rows of the path with the stress below the contacts of their pictures.
fn with_stress(mut path: Vec<PositionRow>, pictures: &[Option<Picture>]) -> Vec<PositionRow> {
    for (row, picture) in path.iter_mut().zip(pictures) {
        let stress = picture.as_ref().and_then(|picture| picture.stress);
        row.von_mises_max_mpa = stress.map(|stress| stress.largest.value.si() * 1e-6);
        row.von_mises_depth_um = stress.map(|stress| stress.largest.depth.si() * 1e6);
        row.yield_depth_um = stress.map(|stress| stress.yield_depth.si() * 1e6);
        row.yield_share = stress.map(|stress| stress.yield_share);
    }
    path
}

fn record_rows(case: &Case, records: &PathRecords) -> Vec<RecordRow> {
    let path = case.gears.path();
    let row = |place: &PlacedRecord| {
        let (at, record) = (&place.position, &place.record);
        RecordRow {
            path_fraction: (at.s - path.a) / (path.e - path.a),
            hertz_pressure_mpa: at.hertz.max_pressure.si() * 1e-6,
            slide_to_roll: at.motion.slide_to_roll,
            smooth_film_um: record.smooth_film.si() * 1e6,
            roughness_over_film: record.attenuated_roughness / record.smooth_film,
            solid_share: record.solid_share.mean,
            solid_share_standard_error: record.solid_share.standard_error,
            share_below_50_nm: record.share_below_50_nm.mean,
            mean_gap_um: record.mean_film.mean * 1e6,
            mean_gap_standard_error_um: record.mean_film.standard_error * 1e6,
            friction: record.friction.mean,
            friction_standard_error: record.friction.standard_error,
            graded_friction: record.graded_friction.mean,
            stepped_friction: record.stepped_friction.mean,
            mean_p_max_mpa: record.mean_max_pressure.mean * 1e-6,
            p_max_mpa: record.max_pressure.si() * 1e-6,
            travel_half_widths: record.travel,
            steps: record.steps,
            steps_cut: record.steps_cut,
            loose_steps: record.loose_steps,
            load_error: record.load_error,
        }
    };
    records.places.iter().map(row).collect()
}

/// Share of the offsets of a position that are in the mixed regime.
pub(crate) fn mixed_share(position: &LubricatedPosition) -> f64 {
    let is_mixed = |offset: &LubricatedWindow| f64::from(offset.regime == Regime::Mixed);
    mean(position.offsets.iter().map(is_mixed))
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::pipeline::losses;
    use crate::result::Losses;
    use asperity_core::Code;

    #[test]
    fn a_fault_in_the_balance_of_a_run_has_its_code() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let case = asperity_case::case::load_with(file, &|input| {
            input.model.positions = Some(3);
            input.model.offsets = Some(1);
        });
        let whole = losses(&case.unwrap()).unwrap();
        let code = |fault: fn(&mut Losses)| {
            let mut faulty = whole.clone();
            fault(&mut faulty);
            let Losses {
                summary,
                gearbox,
                path,
                ..
            } = &faulty;
            let checked = check(summary, gearbox.as_ref(), path);
            checked.err().map(|fault| fault.code())
        };
        assert_eq!(code(|_| ()), None);
        let sums: [fn(&mut Losses); 6] = [
            |run| run.summary.loss_w *= 1.0 + 1e-6,
            |run| run.summary.film_w += 1e-3,
            |run| run.summary.deformation_w[1] += 1e-3,
            |run| run.path[1].sliding_w_per_m *= 1.0 + 1e-6,
            |run| run.path[2].rolling_w_per_m *= 1.0 + 1e-6,
            |run| run.summary.efficiency -= 1e-6,
        ];
        assert_eq!(sums.map(code), [Some(Code::E501); 6]);
        let impossible: [fn(&mut Losses); 4] = [
            |run| run.summary.efficiency = 1.5,
            |run| run.summary.rolling_w = f64::NAN,
            |run| run.path[0].sliding_w_per_m = f64::INFINITY,
            |run| run.summary.mu_equivalent = f64::NAN,
        ];
        assert_eq!(impossible.map(code), [Some(Code::E308); 4]);
    }
}
