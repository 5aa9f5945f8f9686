//! Published and independently computed numbers of lubricated line contacts; `references/smooth_film.py`
//! computes the steady smooth ones.

use crate::common::{contact, gear_oil, moes, of_moes, remaining_amplitude};
use asperity_core::Profile;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, Length, PerKelvin, Pressure, SpecificHeat, Temperature, ThermalConductivity,
};
use asperity_ehl::traction::{Heat, TractionLaw, traction};
use asperity_ehl::{
    MovingProfile, RecordSettings, RoughContact, SteadySettings, Window, steady, transient,
};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

#[test]
fn the_gear_case_has_its_film_and_rolling_force() {
    // An independent program on the same grid: 4.19172 and 3.71392 at 512 cells.
    let (pair, oil) = (contact(1.2e9, 5.0, 0.0), gear_oil());
    let settings = SteadySettings {
        cells: 512,
        window: Some(Window::ROUGH),
    };
    let film = steady::solve(&pair, &oil, &settings).unwrap().value;
    assert!((moes(&pair, &oil, film.central_film) - 4.19172).abs() < 2e-5);
    assert!((moes(&pair, &oil, film.minimum_film) / 3.71392 - 1.0).abs() < 1e-3);
    // 48.45 N/m per surface on this window, by another program.
    assert!(
        (film.rolling_force.si() / 48.45 - 1.0).abs() < 1e-3,
        "{}",
        film.rolling_force
    );
}

#[test]
fn the_rolling_force_grows_with_the_inlet_as_the_tail_says() {
    // Far before the contact (h/2)·dp/dx = 12·η₀·u_m·R/x²: what the window cuts off is
    // 12·η₀·u_m·R/|x_in|. The parabola alone is that exact to a few per cent of the tail.
    let (pair, oil) = (contact(1.2e9, 5.0, 0.0), gear_oil());
    let a = pair.scales(&oil).unwrap().half_width.si();
    let whole = |inlet: f64, cells| {
        let settings = SteadySettings {
            cells,
            window: Some(Window { inlet, outlet: 1.5 }),
        };
        let film = steady::solve(&pair, &oil, &settings).unwrap().value;
        film.rolling_force.si() + 12.0 * 0.01 * 5.0 * 10e-3 / (-inlet * a)
    };
    let (near, far) = (whole(-6.0, 1024), whole(-12.0, 2048));
    assert!((near / far - 1.0).abs() < 0.02, "{near} {far}");
}

#[test]
fn films_converge_with_the_square_of_the_cell() {
    let (pair, oil) = (contact(1.2e9, 5.0, 0.0), gear_oil());
    let central = |cells| {
        let settings = SteadySettings {
            cells,
            window: Some(Window::ROUGH),
        };
        steady::solve(&pair, &oil, &settings)
            .unwrap()
            .value
            .central_film
            .si()
    };
    let films: Vec<f64> = [128, 256, 512, 1024].into_iter().map(central).collect();
    for k in 0..2 {
        let order = ((films[k + 1] - films[k]) / (films[k + 2] - films[k + 1])).log2();
        assert!(order > 1.9, "{order}");
    }
}

#[test]
fn the_window_floods_the_inlet() {
    let (pair, oil) = (contact(1.2e9, 5.0, 0.0), gear_oil());
    let usual = Window::tabulated(&pair.scales(&oil).unwrap());
    let wide = Window {
        inlet: 2.0 * usual.inlet,
        outlet: usual.outlet,
    };
    let central = |window, cells| {
        let settings = SteadySettings {
            cells,
            window: Some(window),
        };
        steady::solve(&pair, &oil, &settings)
            .unwrap()
            .value
            .central_film
            .si()
    };
    let ratio = central(usual, 1024) / central(wide, 2048);
    assert!(ratio < 1.0 + 1e-4 && ratio > 0.997, "{ratio}");
}

/// M, L, laws, central and minimum film of an independent dense program on graded grids up to 1280 cells.
const SMOOTH_TABLE: [(f64, f64, PressureViscosityLaw, DensityLaw, f64, f64); 4] = {
    let roelands = PressureViscosityLaw::Roelands { exponent: 0.6 };
    let compressible = DensityLaw::DowsonHigginson;
    let barus = PressureViscosityLaw::Barus;
    let incompressible = DensityLaw::Incompressible;
    [
        (20.0, 5.0, roelands, compressible, 3.0345, 2.5474),
        (50.0, 10.0, roelands, compressible, 3.7336, 3.3360),
        (10.0, 1.0, barus, incompressible, 2.1365, 1.6482),
        (100.0, 2.0, barus, incompressible, 1.7871, 1.3496),
    ]
};

#[test]
fn steady_films_are_those_of_the_smooth_table() {
    for (m, l, viscosity, density, central, minimum) in SMOOTH_TABLE {
        let (pair, oil) = of_moes(m, l, viscosity, density);
        let [coarse, fine] = [1024, 2048].map(|cells| {
            let settings = SteadySettings {
                cells,
                window: None,
            };
            let film = steady::solve(&pair, &oil, &settings).unwrap().value;
            [film.central_film, film.minimum_film].map(|film| moes(&pair, &oil, film))
        });
        for (k, expected) in [central, minimum].into_iter().enumerate() {
            // The error falls with the square of the cell. The table has five digits; the minimum is between nodes.
            let found = fine[k] + (fine[k] - coarse[k]) / 3.0;
            assert!(
                (found / expected - 1.0).abs() < 2e-4,
                "{m} {l} {found} {expected}"
            );
            assert!((coarse[k] / expected - 1.0).abs() < 4e-3);
        }
    }
}

/// The dense solver on graded grids, which other films are measured with.
#[cfg(feature = "oracle")]
mod oracle {
    use super::*;
    use asperity_ehl::graded;

    #[test]
    fn rows_of_the_smooth_table_are_met() {
        for (m, l, viscosity, density, central, minimum) in SMOOTH_TABLE {
            let (pair, oil) = of_moes(m, l, viscosity, density);
            let found = graded::reference(&pair, &oil, None, 160, 1).unwrap().value;
            for (found, expected) in [(found.central, central), (found.minimum, minimum)] {
                // The error of the coarser grids here and the digits of the table.
                let allowed = 5e-4 * expected + 2.0 * found.error;
                assert!(
                    (found.value - expected).abs() < allowed,
                    "{m} {l} {found:?} {expected}"
                );
                assert!(found.error < 5e-3 * expected);
            }
        }
    }

    #[test]
    fn a_rigid_isoviscous_film_is_that_of_martin() {
        // h_min·M = 2.4481 for rigid cylinders; 2.461 at M = 0.2.
        let (pair, oil) = of_moes(
            0.2,
            0.0,
            PressureViscosityLaw::Isoviscous,
            DensityLaw::Incompressible,
        );
        let found = graded::reference(&pair, &oil, None, 160, 1).unwrap().value;
        let product = 0.2 * found.minimum.value;
        assert!((product - 2.461).abs() < 0.005, "{product}");
        assert!((product / 2.4481 - 1.0).abs() < 0.01);
    }
}

#[test]
fn traction_of_the_gear_case_is_met() {
    let oil = gear_oil();
    let heat = Heat {
        bulk: Temperature::from_si(363.15),
        temperature_coefficient: PerKelvin::from_si(0.028),
        oil_conductivity: ThermalConductivity::from_si(0.14),
        material: Material {
            young: Pressure::from_si(210e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(1e9),
            density: Density::from_si(7830.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(465.0),
        },
    };
    let shear = ShearLaw::Eyring {
        stress: Pressure::from_si(5e6),
    };
    let settings = SteadySettings {
        cells: 1024,
        window: None,
    };
    let film = steady::solve(&contact(1.2e9, 5.0, 0.0), &oil, &settings)
        .unwrap()
        .value;
    // Another program: slide-to-roll ratio, isothermal, thermal.
    for (srr, isothermal, thermal) in [
        (0.01, 0.0205, 0.0203),
        (0.1, 0.0316, 0.0291),
        (0.2, 0.0351, 0.0300),
        (1.0, 0.0433, 0.0250),
    ] {
        let pair = contact(1.2e9, 5.0, srr);
        let law = |heat| TractionLaw {
            shear,
            limit: None,
            heat,
        };
        let cold = traction(&pair, &oil, &film, &law(None)).unwrap();
        let warm = traction(&pair, &oil, &film, &law(Some(heat))).unwrap();
        assert!(
            (cold.coefficient - isothermal).abs() < 2e-4,
            "{srr} {cold:?}"
        );
        assert!((warm.coefficient - thermal).abs() < 2e-4, "{srr} {warm:?}");
        if srr == 0.2 {
            assert!((warm.film_rise - 17.0).abs() < 1.0, "{warm:?}");
        }
    }
    let law = TractionLaw {
        shear: ShearLaw::Newtonian,
        limit: Some(0.05),
        heat: None,
    };
    let capped = traction(&contact(1.2e9, 5.0, 0.01), &oil, &film, &law).unwrap();
    assert!((capped.coefficient - 0.0440).abs() < 2e-4, "{capped:?}");
}

#[test]
fn waves_of_two_contacts_fall_on_one_curve() {
    // Pure rolling, initial amplitude a tenth of the film: computed A_d/A_i of an independent program.
    for (u_m, wave, expected) in [(5.0, 1.0, 0.517), (1.0, 0.5, 0.496), (5.0, 2.0, 0.255)] {
        let (pair, oil) = (contact(1.2e9, u_m, 0.0), gear_oil());
        let scales = pair.scales(&oil).unwrap();
        let window = SteadySettings {
            cells: 256,
            window: Some(Window::ROUGH),
        };
        let smooth = steady::solve(&pair, &oil, &window)
            .unwrap()
            .value
            .central_film
            .si();
        let length = wave * scales.half_width.si();
        let points = 256;
        let heights = (0..points)
            .map(|i| {
                0.1 * smooth * (std::f64::consts::TAU * f64::from(i) / f64::from(points)).cos()
            })
            .collect();
        let profile = Profile::new(Length::from_si(length / f64::from(points)), heights).unwrap();
        let settings = RecordSettings {
            cells: 256,
            start: 4.0,
            length: (2.0 * wave).max(2.0),
            ramp: 0.5,
            history: true,
            ..RecordSettings::default()
        };
        let rough = RoughContact {
            contact: pair,
            oil,
            surface_1: MovingProfile::periodic(&profile),
            surface_2: MovingProfile::smooth(),
        };
        let record = transient::record(&rough, &settings).unwrap().value;
        let films = record.history.iter().map(|m| m.central_film.si());
        let (low, high) = films.fold((f64::INFINITY, 0.0_f64), |(l, h), f| (l.min(f), h.max(f)));
        let left = (high - low) / (0.2 * smooth);
        assert!(
            (left - expected).abs() < 0.03 * expected + 0.005,
            "{u_m} {wave}: {left}"
        );
        let curve = remaining_amplitude(Length::from_si(length), &scales);
        assert!((curve / expected - 1.0).abs() < 0.1);
    }
}
