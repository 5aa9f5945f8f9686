//! A simulated rig, designed and calibrated: nothing of it was measured.

use asperity_calibration::rig_table::RigRow;
use asperity_calibration::{Limits, RigCase, RigTable, Watch, calibrate, design, plan};
use asperity_report::StudyResult;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::path::Path::new("fixtures/cases/fzg-c.toml");
    let case = asperity::case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(4));
    })?;
    let limits = Limits {
        torques_nm: vec![60.0, 183.4],
        speeds_rpm: vec![30.0, 100.0, 300.0, 1000.0, 3000.0],
        temperatures_c: vec![40.0, 65.0, 90.0],
        hours: 8.0,
        minutes_per_point: 15.0,
        sigma: 0.03,
        assemblies: 2,
    };
    let found = plan(&case, &limits, &[], &|_, _| {})?;
    print!("{}", found.summary());
    // A rig whose oil and flanks are not those of the defaults.
    let truth = case.with_key("model.boundary_friction", "0.095")?;
    let losses = design::simulated(&truth, &found, 1)?;
    let rows = found
        .rows()
        .zip(&losses)
        .enumerate()
        .map(|(k, ((number, assembly), loss))| {
            let point = &found.points[number];
            let at = [point.torque_nm, point.speed_rpm, point.temperature_c];
            RigRow::of_mesh(k + 2, at, *loss, 0.03 * loss).in_assembly(&format!("{}", assembly + 1))
        });
    let table = RigTable::of_rows("SIMULATED", rows.collect(), true);
    let cases = [RigCase { name: None, case }];
    let found = calibrate(table, "", &cases, &[], &Watch::SILENT)?;
    print!("{}", found.summary());
    Ok(())
}
