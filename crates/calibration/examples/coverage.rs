//! How often the bands hold the truth: a hundred simulated rigs of three temperatures, seven speeds and two
//! assemblies with errors of 3 % a point. Takes some minutes with `--release`; nothing of it was measured.

use asperity_calibration::rig_table::RigRow;
use asperity_calibration::simulate::{Simulated, losses};
use asperity_calibration::{Rig, RigCase, RigTable};

const REPEATS: u64 = 100;
const SIGMA: f64 = 0.03;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::path::Path::new("fixtures/cases/fzg-c.toml");
    let case = asperity::case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(4));
    })?;
    let mut rows = Vec::new();
    for assembly in ["1", "2"] {
        for temperature in [40.0, 65.0, 90.0] {
            for speed in [25.0, 60.0, 140.0, 330.0, 790.0, 1870.0, 4400.0] {
                let at = [183.4, speed, temperature];
                rows.push(RigRow::of_mesh(rows.len() + 2, at, 1.0, SIGMA).in_assembly(assembly));
            }
        }
    }
    let table = RigTable::of_rows("SIMULATED", rows, true);
    let cases = [RigCase { name: None, case }];
    let rig = Rig::new(table, &cases, &[], &|_| {})?;
    let first = rig.first_surfaces(&|_| {})?;
    // The defaults, and parameters off them to either side.
    let truths = [
        [0.0; 4],
        [0.18, 0.35, -0.10, -0.22],
        [-0.15, -0.35, 0.08, 0.20],
    ];
    for truth in truths {
        let measured = rig.observations(&rig.table.rows);
        let wanted: Vec<Simulated> = measured
            .iter()
            .map(|seen| Simulated {
                point: seen.point,
                assembly: seen.assembly,
                omega: seen.omega,
            })
            .collect();
        let (mut held, mut widths, mut rounds, mut squares) = ([0; 4], [0.0; 4], 0, 0.0);
        for repeat in 0..REPEATS {
            let simulated = losses(&rig.model, &truth, &wanted, SIGMA, repeat)?;
            let observations = measured.iter().zip(simulated).map(|(seen, loss)| {
                let mut seen = *seen;
                (seen.log_loss, seen.sigma) = (loss.ln(), SIGMA);
                seen
            });
            let fit = rig.fit(observations.collect(), first.clone(), &|_| {})?;
            rounds += fit.rounds;
            squares += fit
                .problem()
                .of_measurements(&fit.minimum.x)
                .iter()
                .map(|r| r * r)
                .sum::<f64>();
            for k in 0..4 {
                let band = fit.band(k, 0.95)?;
                let [low, high] = band.ends;
                held[k] += u32::from((low..=high).contains(&truth[k]));
                widths[k] += 0.5 * (high - low) / REPEATS as f64;
            }
        }
        println!(
            "truth {truth:?}: {:.1} rounds, chi squared {:.1}",
            rounds as f64 / REPEATS as f64,
            squares / REPEATS as f64
        );
        for (k, parameter) in rig.parameters.iter().enumerate() {
            println!(
                "  {:<18} held in {:>3} of {REPEATS}, half-width {:.3}",
                parameter.words(),
                held[k],
                widths[k]
            );
        }
    }
    Ok(())
}
