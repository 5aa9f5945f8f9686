//! Gradient of the friction of a window over the heights of both traces against central differences with exact contacts.

use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;
use asperity_mixed_film::TraceChange;

use super::*;

/// Step of the differences over a height \[m\]: .05 to .5 nm agree to 1e-4.
const STEP: f64 = 0.2e-9;

fn exact_table(contact: &LineContact, flanks: &Flanks) -> (RoughContact, ContactTable) {
    let composite = flanks.window(STARTS, points(contact));
    let mut rough = rough(contact, &composite, FLOW).unwrap().exactly(true);
    let table = ContactTable::build(&mut rough).unwrap();
    (rough, table)
}

fn friction(flanks: &Flanks, settings: &LoadShareSettings) -> f64 {
    let contact = e_drive();
    let (_, table) = exact_table(&contact, flanks);
    share(&contact, flanks, &table, STARTS, 90.0, settings).coefficient
}

/// dμ/dz \[1/m\] over the heights of both traces.
fn gradient(flanks: &Flanks, settings: &LoadShareSettings) -> [Vec<f64>; 2] {
    let (contact, rheology) = (e_drive(), oil("e-fluid"));
    let (mut rough, table) = exact_table(&contact, flanks);
    let mut film = PositionFilm::new(&rheology, &contact, celsius(90.0), settings).unwrap();
    let [first, second] = &flanks.spectra;
    let pair = PairSpectrum::from_traces([first, second]);
    let traces = AttenuatedTraces::new([first, second], &film.flattening(&pair).unwrap());
    let n = points(&contact);
    let window = traces.window(STARTS, n).unwrap();
    let found = film.gradient(&mut rough, &table, &window, 1.0).unwrap();
    let of_window = traces.window_gradient(STARTS.map(|start| start as isize), &found, 1.0);
    let unflattening = film.unflattening(&flanks.spectra, &pair).unwrap();
    let gradient = unflattening.gradient(&flanks.spectra, [&of_window]);
    // Along a change that is flattened itself.
    let windows = [None, Some(of_window)];
    let changes = [0, 1, 1].map(|body: usize| {
        let change = bump(flanks.heights[body].len(), 900 + 250 * body, 120);
        (body, change)
    });
    let of = |(body, change): &(usize, Vec<f64>)| {
        TraceChange::new(*body, change.clone(), flanks.spectra[0].spacing()).unwrap()
    };
    let short = TraceChange::new(1, vec![0.0; 900], flanks.spectra[0].spacing()).unwrap();
    assert!(unflattening.along(&windows, &[short]).is_err());
    let along = unflattening
        .along(&windows, &changes.each_ref().map(of))
        .unwrap();
    for ((body, change), along) in changes.iter().zip(along) {
        let product: f64 = gradient[*body].iter().zip(change).map(|(g, z)| g * z).sum();
        assert!(
            along[0] == 0.0 && (along[1] / product - 1.0).abs() < 1e-9,
            "{along:?} {product}"
        );
    }
    gradient
}

/// Central difference of the friction along `shape` of a trace, whose largest value is 1.
fn quotient(flanks: &Flanks, settings: &LoadShareSettings, body: usize, shape: &[f64]) -> f64 {
    let at = |step: f64| {
        let mut heights = flanks.heights.clone();
        for (z, one) in heights[body].iter_mut().zip(shape) {
            *z += step * one;
        }
        friction(&Flanks::new(heights), settings)
    };
    (at(STEP) - at(-STEP)) / (2.0 * STEP)
}

/// A bump of 1 - cos with its middle at `middle`, `width` points wide at its foot.
fn bump(points: usize, middle: usize, width: usize) -> Vec<f64> {
    let mut shape = vec![0.0; points];
    for (k, value) in shape.iter_mut().enumerate() {
        let off = 2.0 * (k as f64 - middle as f64) / width as f64;
        if off.abs() < 1.0 {
            *value = 0.5 * (1.0 + (std::f64::consts::PI * off).cos());
        }
    }
    shape
}

#[test]
fn the_gradient_over_the_heights_is_the_central_difference() {
    let flanks = ground();
    let alone = independent();
    let with = |supply| LoadShareSettings {
        spot_speed: SpotSpeed::Carried,
        supply,
        ..alone
    };
    // Largest errors of the middle and of the worst height, and of bumps.
    for (settings, limits) in [
        (alone, [1e-6, 1e-3, 1e-3]),
        (with(InletSupply::Rough), [1e-6, 1e-3, 1e-3]),
        (with(InletSupply::Grubin), [1e-6, 1e-3, 1e-3]),
        (with(InletSupply::Starved), [1e-6, 1e-3, 1e-3]),
    ] {
        let gradient = gradient(flanks, &settings);
        let largest = gradient
            .iter()
            .flatten()
            .fold(0.0, |m: f64, g| m.max(g.abs()));
        let n = points(&e_drive());
        // Heights across the window, every one with more than a hundredth of the largest gradient.
        let mut errors = Vec::new();
        for k in 0..24 {
            let body = k % 2;
            let within = STARTS[body] + n / 3 + (k * 7919) % (n / 3);
            let found = gradient[body][within];
            if found.abs() < 0.01 * largest {
                continue;
            }
            let mut shape = vec![0.0; flanks.heights[body].len()];
            shape[within] = 1.0;
            let expected = quotient(flanks, &settings, body, &shape);
            errors.push((found / expected - 1.0).abs());
        }
        errors.sort_by(f64::total_cmp);
        assert!(errors.len() >= 8);
        assert!(errors[errors.len() / 2] < limits[0], "{errors:?}");
        // One height moves a spot past the film at which its share on the boundary layer is that of its roughness: a kink.
        assert!(errors[errors.len() - 2] < limits[1], "{errors:?}");
        // Bumps of 2 to 200 um, also outside of the contact, where only the inlet sees them.
        for (k, width) in [4, 12, 40, 100, 200, 400].into_iter().enumerate() {
            let body = k % 2;
            let middle = STARTS[body] + n / 3 + (k * 104_729) % (n / 3);
            let shape = bump(flanks.heights[body].len(), middle, width);
            let found: f64 = gradient[body].iter().zip(&shape).map(|(g, s)| g * s).sum();
            let expected = quotient(flanks, &settings, body, &shape);
            assert!((found - expected).abs() < limits[2] * expected.abs().max(0.01 * largest));
        }
    }
}

/// Where the share is at its largest, the film is as thick as the gap there, which follows from the heights.
#[test]
fn the_gradient_at_the_largest_share_is_the_central_difference() {
    let heights = ground().heights.clone();
    let flanks = Flanks::new(heights.map(|z| z.iter().map(|z| 12.0 * z).collect()));
    let settings = LoadShareSettings {
        spot_speed: SpotSpeed::Carried,
        ..independent()
    };
    let (_, table) = exact_table(&e_drive(), &flanks);
    let solved = share(&e_drive(), &flanks, &table, STARTS, 90.0, &settings);
    assert_eq!(solved.asperity_share, LARGEST_SHARE);
    let gradient = gradient(&flanks, &settings);
    for (k, width) in [40, 100, 200, 400].into_iter().enumerate() {
        let body = k % 2;
        let middle = STARTS[body] + points(&e_drive()) / 2;
        let shape = bump(flanks.heights[body].len(), middle, width);
        let found: f64 = gradient[body].iter().zip(&shape).map(|(g, s)| g * s).sum();
        let expected = quotient(&flanks, &settings, body, &shape);
        println!("{width}: {found} {expected}");
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{width}: {found} {expected}"
        );
    }
}

#[test]
fn kinks_are_counted_within_a_nanometre_of_mean_gap() {
    let (contact, rheology, settings) = (e_drive(), oil("e-fluid"), LoadShareSettings::default());
    let (_, table) = exact_table(&contact, ground());
    let mut film = PositionFilm::new(&rheology, &contact, celsius(90.0), &settings).unwrap();
    let first_touch = table.first_touch_gap();
    // Kinks where the supply is `gap`: the roughness is searched that the inlet needs for it.
    let mut at = |gap: f64| {
        let supplied = |film: &mut PositionFilm<'_>, rms: f64| {
            let window = WindowRoughness::even(Length::from_si(rms));
            let share = film.share(&table, &window).unwrap().value;
            (share.mean_gap.si(), share.asperity_share)
        };
        let [mut low, mut high] = [0.0, 1e-5];
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if supplied(&mut film, middle).0 < gap {
                low = middle
            } else {
                high = middle
            }
        }
        let (found, share) = supplied(&mut film, low);
        assert!((found - gap).abs() < 1e-13, "{found} {gap}");
        let kinks = film.kinks(&table, &WindowRoughness::even(Length::from_si(low)));
        let kinks = kinks.unwrap();
        assert_eq!((kinks.windows, kinks.apart == 1), (1, share == 0.0));
        kinks
    };
    for off in [-1.1e-9_f64, -0.9e-9, 0.9e-9, 1.1e-9] {
        let is_next = usize::from(off.abs() < 1e-9);
        let kinks = at(first_touch.si() + off);
        assert_eq!((kinks.first_touch, kinks.rows), (is_next, 0), "{off}");
        for row in table.rows().skip(4).take(4) {
            let kinks = at(row.mean_gap.si() + off);
            assert_eq!((kinks.first_touch, kinks.rows), (0, is_next), "{off}");
        }
    }
}

#[test]
fn a_window_without_contact_or_film_is_counted_as_apart_or_at_a_floor() {
    let (mut contact, rheology, settings) =
        (e_drive(), oil("e-fluid"), LoadShareSettings::default());
    let (_, table) = exact_table(&contact, ground());
    let rms = &WindowRoughness::even(Length::from_si(0.0));
    let bulk = celsius(90.0);
    let thick = SmoothFilm {
        central: table.first_touch_gap() * 2.0,
        thermal_factor: 1.0,
    };
    let mut film = PositionFilm::with_film(&rheology, &contact, bulk, &settings, thick).unwrap();
    let apart = film.kinks(&table, rms).unwrap();
    let one = Kinks {
        windows: 1,
        ..Kinks::default()
    };
    assert_eq!(apart, Kinks { apart: 1, ..one });
    // So thin a film that the asperities carry the largest share.
    let smooth = SmoothFilm {
        central: Length::from_si(1e-9),
        ..thick
    };
    let mut film = PositionFilm::with_film(&rheology, &contact, bulk, &settings, smooth).unwrap();
    let share = film.share(&table, rms).unwrap().value.asperity_share;
    let largest = film.kinks(&table, rms);
    assert_eq!((share, largest.unwrap().floors), (0.99, 1));
    // A film at which the gap is not at its end, with spots so slow that their films are thinner than 1 nm.
    contact.speeds = contact.speeds.map(|speed| speed * 1e-4);
    let smooth = SmoothFilm {
        central: Length::from_si(0.8e-6),
        ..smooth
    };
    let mut film = PositionFilm::with_film(&rheology, &contact, bulk, &settings, smooth).unwrap();
    let share = film.share(&table, rms).unwrap().value;
    assert!(
        share.asperity_share > 0.0 && share.asperity_share < 0.9,
        "{share:?}"
    );
    assert!(share.spot_film.si() < 1e-9, "{share:?}");
    let slow = film.kinks(&table, rms);
    assert_eq!(slow.unwrap().floors, 1);
}
