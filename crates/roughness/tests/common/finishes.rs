//! Surfaces of eight finishes, for the records of generated flanks.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::generate::{Ground, Like, Pits, SelfAffine, lower_envelope, truncated};

const DX: Length = Length::from_si(0.5e-6);
/// Points of a trace of 3 mm.
pub const POINTS: usize = 6000;
fn affine(points: usize, rq: f64, [roll_off, short_cut]: [f64; 2], seed: u64) -> Profile {
    let recipe = SelfAffine {
        points,
        spacing: DX,
        rq: Length::from_si(rq),
        hurst: 0.75,
        roll_off: Length::from_si(roll_off),
        short_cut: Length::from_si(short_cut),
        seed,
    };
    recipe.generate().unwrap()
}

fn sum(one: &Profile, other: &Profile) -> Profile {
    let both = one.heights().iter().zip(other.heights());
    Profile::new(DX, both.map(|(a, b)| a + b).collect()).unwrap()
}

/// Grooves of grits with this distance, and of this Rq, on a background.
fn ground(points: usize, grit_spacing: f64, rq: f64, seed: u64) -> Profile {
    let recipe = Ground {
        points,
        spacing: DX,
        rq: Length::from_si(rq),
        grit_spacing: Length::from_si(grit_spacing),
        grit_radius: Length::from_si(50e-6),
        grit_protrusion: Length::from_si(0.4e-6),
        seed,
    };
    let background = affine(points, 0.15e-6, [60e-6, 4e-6], seed + 1);
    sum(&recipe.generate().unwrap(), &background)
}

fn honed(points: usize, seed: u64) -> Profile {
    let dales = affine(points, 0.6e-6, [70e-6, 4e-6], seed);
    let dales = dales.heights().iter().map(|z| z + 0.35e-6).collect();
    let plateaus = affine(points, 0.08e-6, [30e-6, 4e-6], seed + 1);
    lower_envelope(&plateaus, &Profile::new(DX, dales).unwrap()).unwrap()
}

/// A tenth of a polished ground texture is cut off.
fn superfinished(points: usize, seed: u64) -> Profile {
    let texture = affine(points, 0.1e-6, [40e-6, 4e-6], seed);
    truncated(&texture, 0.1).unwrap().0
}

/// Dimples of shot, one in 0.1 mm, on a ground texture.
fn peened(points: usize, seed: u64) -> Profile {
    let pits = Pits {
        count: points / 200,
        width: Length::from_si(80e-6),
        depth: Length::from_si(1.2e-6),
        seed,
    };
    let texture = affine(points, 0.2e-6, [50e-6, 4e-6], seed + 1);
    pits.add_to(&texture).unwrap()
}

/// A honed flank on waves of a millimetre.
fn wavy(points: usize, seed: u64) -> Profile {
    let waves = affine(points, 0.4e-6, [1.2e-3, 0.5e-3], seed + 2);
    sum(&ground(points, 15e-6, 0.2e-6, seed), &waves)
}

/// Name of a finish, and a surface of it with a number of points and a seed.
pub type Finish = (&'static str, fn(usize, u64) -> Profile);

/// The finishes.
pub const FINISHES: [Finish; 8] = [
    ("ground, grits 10 um", |n, seed| {
        ground(n, 10e-6, 0.2e-6, seed)
    }),
    ("ground, grits 10 um, grooves 1.5", |n, seed| {
        ground(n, 10e-6, 0.3e-6, seed)
    }),
    ("ground, grits 20 um", |n, seed| {
        ground(n, 20e-6, 0.2e-6, seed)
    }),
    ("ground, grits 20 um, grooves 1.5", |n, seed| {
        ground(n, 20e-6, 0.3e-6, seed)
    }),
    ("honed", honed),
    ("superfinished", superfinished),
    ("peened", peened),
    ("ground, long waves", wavy),
];

/// `count` traces cut out of one surface.
pub fn traces((_, surface): Finish, count: usize, seed: u64) -> Vec<Profile> {
    let whole = surface(count * POINTS, seed);
    let parts = whole.heights().chunks_exact(POINTS);
    parts
        .map(|z| Profile::new(DX, z.to_vec()).unwrap())
        .collect()
}

/// `count` traces with the first seeds like `given`.
pub fn made_like(given: &[Profile], count: usize) -> (Like, Vec<Profile>) {
    let like = Like::to(&given[0], &given[1..], None).unwrap();
    let seeds = 1..=count as u64;
    let made = seeds.map(|seed| like.generate(seed).unwrap().generated.profile);
    let made = made.collect();
    (like, made)
}

/// Seed of the surface of a repetition; `ASPERITY_SEED` takes other surfaces.
pub fn seed_of(repetition: u64) -> u64 {
    std::env::var("ASPERITY_SEED").map_or(7000, |seed| seed.parse().unwrap()) + 10 * repetition
}
