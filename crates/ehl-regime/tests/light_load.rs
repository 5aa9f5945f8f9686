//! Where a smooth film shears at light load.

use asperity_ehl_regime::MoesNumbers;
use asperity_ehl_regime::light_load::LightLoad;

fn at(load: f64, material: f64) -> LightLoad {
    LightLoad::new(&MoesNumbers { load, material })
}

#[test]
fn light_load_has_no_kink_over_load_and_material() {
    for material in [1.0, 2.0, 4.4, 6.0, 11.0, 16.0, 25.0] {
        // From the rigid contact below the table to Hertz's above it, in steps of a hundredth of ln M.
        let all: Vec<LightLoad> = (-500..900)
            .map(|k| at((0.01 * f64::from(k)).exp(), material))
            .collect();
        for three in all.windows(3) {
            let bend = |of: &dyn Fn(&LightLoad) -> f64| {
                (of(&three[0]) - 2.0 * of(&three[1]) + of(&three[2])).abs()
            };
            for u in [0.0_f64, 0.5, 0.8, 0.95] {
                let excess = |at: &LightLoad| {
                    let terms = at.excess.iter().rev();
                    terms.fold(0.0, |sum, c| sum * u * u + c)
                };
                assert!(bend(&excess) < 0.004, "{material} {u}: {three:?}");
            }
            assert!(bend(&|at| at.inlet.ln()) < 0.02, "{material}: {three:?}");
        }
    }
}

#[test]
fn light_load_ends_in_the_rigid_and_the_hertz_contact() {
    // Nothing is left of Hertz's pressure in the middle of the one, and nothing to add in the other.
    let (light, heavy) = (at(0.05, 6.0), at(1e5, 6.0));
    assert!(light.excess[0] < -0.9 && light.inlet > 10.0, "{light:?}");
    assert!(
        heavy.excess.iter().all(|c| c.abs() < 1e-3) && heavy.inlet < 1e-3,
        "{heavy:?}"
    );
    // The stress before the contact falls as the load rises.
    let inlets: Vec<f64> = (-30..60)
        .map(|k| at((0.1 * f64::from(k)).exp(), 6.0).inlet)
        .collect();
    assert!(inlets.windows(2).all(|two| two[0] > two[1]));
}
