//! Film and friction of touching asperities, each a small lubricated contact: of a line, or of an ellipse on a patch.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f_k | load of a spot | N/m |
//! | F_k, b_k | load and width of the contact that it is part of | N/m, m |
//! | l_k | its axis along the lead, infinite on a line | m |
//! | F_m,k | load through its middle; F_k on a line | N/m |
//! | R_k | radius along rolling of the flanks of the Hertz contact with these axes and this load | m |
//! | h_k | film thickness of that contact by Moes, at the surface temperature of the whole contact | m |
//! | u_m, a | entrainment speed and half width of the whole contact | m/s, m |
//! | k | part of its way through the contact in which a spot is one that formed in the inlet | - |
//! | β_i | least share on the boundary layer of a spot that formed inside the contact | - |
//! | p_k | mean asperity pressure F_k/b_k | Pa |
//! | τ_k | shear stress of its film | Pa |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::numerics::{CompleteElliptic, VECTOR_WIDTH};
use asperity_core::quantity::{Length, Temperature};
use asperity_ehl_regime::FilmGroups;
use asperity_ehl_regime::film_elliptic::hamrock_dowson_central;
use asperity_ehl_regime::film_line::{moes, moes_of_each};
use asperity_oil::{FilmOilState, FilmRheology, LANES, ShearedPoint};
use asperity_tribo_friction::boundary::{boundary_share, share_on_layer};

use crate::error::LoadShareError;
use crate::spot_tree::{BySpot, Spot};

/// Smallest film thickness used for the shear rate of a spot: a few molecules, where a boundary layer of 10 nm carries
/// 91 % of the load.
const THINNEST: f64 = 1e-9;

/// Relative step of the difference quotients of a spot's friction.
const SLOPE_STEP: f64 = 1e-4;

/// Data common to all spots of a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpotConditions<'a> {
    pub(crate) rheology: &'a FilmRheology,
    pub(crate) wall: Temperature,
    pub(crate) modulus: f64,
    pub(crate) feed: Feed,
    pub(crate) sliding: f64,
    pub(crate) boundary_layer: Length,
}

/// Films of the spots.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Feed {
    /// One speed \[m/s\] that carries oil into every spot.
    At(f64),
    /// A spot keeps the film of the inlet until the flanks have slid past it; another forms inside the contact.
    Carried {
        /// u_m \[m/s\]
        entrainment: f64,
        /// |u₁ − u₂|/2 \[m/s\]
        half_sliding: f64,
        /// Half width a of the whole contact \[m\].
        half_width: f64,
        /// β_i
        inner_boundary: f64,
    },
}

/// Shear stresses of the films of a spot at a nearby state, if known.
pub(crate) type SpotStresses = [Option<SpotStress>; 2];

/// Shear stress of a film of a spot.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpotStress {
    /// Temperature of the walls \[K\].
    wall: f64,
    /// \[Pa\]
    stress: f64,
    /// Slope over the temperature of the walls \[Pa/K\].
    slope: f64,
}

/// Slid distance over the largest width of two equal peaks, during which they touch.
const CROSSING: f64 = 2.0 * std::f64::consts::SQRT_2;

/// A film of a spot.
#[derive(Debug, Clone, Copy)]
struct SpotFilm {
    /// Share of the spot.
    part: f64,
    /// Thickness \[m\].
    film: f64,
    /// Share of its load on the boundary layer.
    boundary_share: f64,
    /// Mean pressure of the spot \[Pa\].
    pressure: f64,
}

impl SpotFilm {
    const NONE: Self = Self {
        part: 0.0,
        film: 0.0,
        boundary_share: 0.0,
        pressure: 0.0,
    };
}

/// The Hertz contact that a spot is part of.
#[derive(Debug, Clone, Copy)]
struct Contact {
    /// Load \[N/m\].
    load: f64,
    /// Width \[m\].
    width: f64,
    /// Its load through the middle \[N/m\] and the ratio of its axes l_k/b_k, of an ellipse.
    ellipse: Option<[f64; 2]>,
}

impl Contact {
    fn from_spot(spot: &Spot) -> Self {
        let ratio = spot.length / spot.width;
        Self {
            load: spot.joint_load.si(),
            width: spot.width.si(),
            ellipse: ratio.is_finite().then(|| [spot.middle_load.si(), ratio]),
        }
    }

    /// Mean pressure \[Pa\].
    fn pressure(self) -> f64 {
        self.load / self.width
    }

    /// Load \[N/m\] and radius \[m\] of the line contact with the largest pressure and the radius along rolling of the ellipse.
    ///
    /// ```text
    /// R_k = Φ π E* (b_k/2)²/(4 F_m,k),  line of the load Φ F_m,k,
    /// Φ = 1/(K − D) for l_k ≥ b_k, else b_k/(l_k D),  D = (K − E)/m                             [Spot-radius]
    /// ```
    ///
    /// K, E: complete elliptic integrals of the parameter m = 1 − (shorter/longer axis)². Φ is 4/π of a circle and 1 of a line.
    fn line_through_middle(self, modulus: f64) -> (f64, f64) {
        let (load, factor) = match self.ellipse {
            None => (self.load, 1.0),
            Some([middle, ratio]) => {
                cite!("Spot-radius");
                (middle, radius_over_line(ratio))
            }
        };
        let radius = PI * modulus * 0.25 * self.width * self.width / (4.0 * load);
        (load * factor, radius * factor)
    }
}

/// Φ of the ratio of the axes l/b.
fn radius_over_line(ratio: f64) -> f64 {
    let shorter = ratio.min(1.0 / ratio);
    let of = CompleteElliptic::from_complement(shorter * shorter);
    if ratio >= 1.0 {
        1.0 / (of.first - of.difference)
    } else {
        1.0 / (ratio * of.difference)
    }
}

/// Part of its way through the contact in which a spot is one that formed in the inlet.
///
/// ```text
/// L = 2√2 u_m b/|u₁ − u₂|,  k = L/(4a) for L ≤ 2a, else 1 − a/L                [Carried-part]
/// ```
///
/// Two peaks of radius r that are offset by x overlap by b²/(2r) − x²/(4r), with the overlap of the Hertz contact whose largest
/// width is b: they touch while the flanks slide by 2√2 b. Meanwhile the spot travels by L. At a distance x from the inlet the spots whose age is above x/u_m formed in it, max(0, 1 − x/L) of ages that are spread evenly;
/// k is the mean over 2a. 1 without sliding.
fn carried_part(entrainment: f64, sliding: f64, half_width: f64, width: f64) -> f64 {
    cite!("Carried-part");
    let travel = CROSSING * entrainment * width / sliding;
    if travel <= 2.0 * half_width {
        travel / (4.0 * half_width)
    } else {
        1.0 - half_width / travel
    }
}

/// Film of a contact whose oil flows out at its sides over the film of the line through its middle: the factor of Hamrock and
/// Dowson.
///
/// ```text
/// h_k = h_Moes (1 − 0.61 e^(−0.73 l_k/b_k))                                  [Spot-side-flow]
/// ```
///
/// For l_k < b_k this extrapolates the fit. The factor of a point contact on Moes' film of a line is no published combination.
///
/// # Errors
/// When the ratio of the axes is not positive.
fn side_flow(groups: &FilmGroups, ratio: f64) -> Result<f64, LoadShareError> {
    cite!("Spot-side-flow");
    let film = |ratio| hamrock_dowson_central(groups, Length::from_si(1.0), ratio);
    Ok(film(ratio)?.value / film(f64::INFINITY)?.value)
}

/// Friction of all spots of a contact, as means over their load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct SpotFriction {
    /// Share β on the boundary layer.
    pub(crate) boundary_share: f64,
    /// (1 − β) μ_a.
    pub(crate) lubricated: f64,
    /// Film h_a.
    pub(crate) film: f64,
}

impl SpotFriction {
    /// μ_a of the lubricated part; 0 without one.
    pub(crate) fn asperity_coefficient(&self) -> f64 {
        let share = 1.0 - self.boundary_share;
        if share > 0.0 {
            self.lubricated / share
        } else {
            0.0
        }
    }

    /// Friction coefficient (1 − β) μ_a + β μ_b with the coefficient `boundary` of the boundary layer.
    pub(crate) fn total(&self, boundary: f64) -> f64 {
        self.lubricated + self.boundary_share * boundary
    }

    /// Adds `weight` times `other`.
    pub(crate) fn add(&mut self, other: &Self, weight: f64) {
        self.boundary_share += weight * other.boundary_share;
        self.lubricated += weight * other.lubricated;
        self.film += weight * other.film;
    }
}

/// Spots of some contacts whose mean friction is sought, with the stresses of their films at the last temperature.
#[derive(Debug, Clone, Default)]
pub(crate) struct SpotList {
    contacts: Vec<Contact>,
    /// Weight of each in the mean.
    weights: Vec<f64>,
    stresses: Vec<SpotStresses>,
    /// Memory for their films and for the points of these.
    films: Vec<[SpotFilm; 2]>,
    sheared: Vec<ShearedPoint>,
}

impl SpotList {
    /// The spots of some contacts, with the weight of each contact.
    pub(crate) fn new(contacts: &[(&[Spot], f64)]) -> Self {
        let count = contacts.iter().map(|(spots, _)| spots.len()).sum();
        let mut list = Self {
            contacts: Vec::with_capacity(count),
            weights: Vec::with_capacity(count),
            stresses: vec![SpotStresses::default(); count],
            films: Vec::with_capacity(count),
            sheared: Vec::with_capacity(2 * count),
        };
        for (spots, weight) in contacts {
            let total: f64 = spots.iter().map(|spot| spot.load.si()).sum();
            list.contacts.extend(spots.iter().map(Contact::from_spot));
            let weights = spots.iter().map(|spot| weight * spot.load.si() / total);
            list.weights.extend(weights);
        }
        list
    }
}

impl SpotConditions<'_> {
    /// Boundary share, friction and film of touching spots.
    ///
    /// ```text
    /// R_k = π E* (b_k/2)²/(4 F_k),  β = Σ f_k β_k/Σ f_k,
    /// μ_a = Σ f_k (1 − β_k) τ_k/p_k / Σ f_k (1 − β_k)                          [Spot-friction]
    /// ```
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn friction(&self, spots: &[Spot]) -> Result<SpotFriction, LoadShareError> {
        let mut spots = SpotList::new(&[(spots, 1.0)]);
        Ok(self.friction_of(&mut spots, |points| self.shear(points))?.0)
    }

    /// [`friction`](Self::friction) of the spots of a list; `shear` solves the stresses of their films, together with what else it
    /// has, and returns that.
    ///
    /// # Errors
    /// When a spot has no film, and those of `shear`.
    pub(crate) fn friction_of<T>(
        &self,
        spots: &mut SpotList,
        shear: impl FnOnce(&mut [ShearedPoint]) -> Result<T, LoadShareError>,
    ) -> Result<(SpotFriction, T), LoadShareError> {
        cite!("Spot-friction");
        let weights = std::mem::take(&mut spots.weights);
        let mut mean = SpotFriction::default();
        let add = |k: usize, of_spot: &SpotFriction| mean.add(of_spot, weights[k]);
        let other = self.of_each(spots, shear, add)?;
        spots.weights = weights;
        Ok((mean, other))
    }

    /// Sliding loss of each of some spots per metre of face \[W/m\], with the coefficient `boundary` of the boundary layer.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn losses(&self, spots: &[Spot], boundary: f64) -> Result<Vec<f64>, LoadShareError> {
        let mut list = SpotList::new(&[(spots, 1.0)]);
        let mut losses = Vec::with_capacity(spots.len());
        let add = |k: usize, of_spot: &SpotFriction| {
            losses.push(spots[k].load.si() * of_spot.total(boundary) * self.sliding);
        };
        self.of_each(&mut list, |points| self.shear(points), add)?;
        Ok(losses)
    }

    fn shear(&self, points: &mut [ShearedPoint]) -> Result<(), LoadShareError> {
        Ok(self.rheology.shear(points.iter_mut(), self.wall.si())?)
    }

    /// Whether the film of a spot is thinner than the smallest film thickness used for its shear rate.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn limits_shear_rate(&self, spots: &[Spot]) -> Result<bool, LoadShareError> {
        let state = self.rheology.state(self.wall)?;
        let mut list = SpotList::new(&[(spots, 1.0)]);
        self.find_films(&state, &mut list)?;
        let mut films = list.films.iter().flatten();
        Ok(films.any(|at| at.part > 0.0 && at.film < THINNEST))
    }

    /// Derivatives of the mean friction coefficient of `spots`, with the coefficient `boundary` of the boundary layer, over
    /// load, joint load and width of each spot \[m/N, m/N, 1/m\].
    ///
    /// ```text
    /// B = Σ f_k e_k/Σ f:  ∂B/∂f_k = (e_k − B)/Σ f,  ∂B/∂F_k = f_k ∂e/∂F/Σ f,  ∂B/∂b_k = f_k ∂e/∂b/Σ f   [Spot-gradient]
    /// ```
    ///
    /// The friction e(F, b) of one spot is smooth; its slopes are central difference quotients.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn slopes(
        &self,
        spots: &[Spot],
        boundary: f64,
    ) -> Result<Vec<BySpot>, LoadShareError> {
        cite!("Spot-gradient");
        let total: f64 = spots.iter().map(|spot| spot.load.si()).sum();
        let mut list = SpotList::new(&[(spots, 1.0)]);
        let (mean, ()) = self.friction_of(&mut list, |points| self.shear(points))?;
        let mean = mean.total(boundary);
        let h = SLOPE_STEP;
        let steps = [
            (1.0, 1.0),
            (1.0 + h, 1.0),
            (1.0 - h, 1.0),
            (1.0, 1.0 + h),
            (1.0, 1.0 - h),
        ];
        let moved = list.contacts.iter().flat_map(|contact| {
            steps.map(|(of_load, of_width)| Contact {
                load: contact.load * of_load,
                width: contact.width * of_width,
                ..*contact
            })
        });
        let starts = list.stresses.iter().flat_map(|stress| [*stress; 5]);
        let mut moved = SpotList {
            contacts: moved.collect(),
            stresses: starts.collect(),
            ..SpotList::default()
        };
        let mut found = Vec::with_capacity(moved.contacts.len());
        self.of_each(
            &mut moved,
            |points| self.shear(points),
            |_, of_spot| found.push(*of_spot),
        )?;
        let slopes = |(spot, found): (&Spot, &[SpotFriction; 5])| {
            let f = spot.load.si();
            let Contact { load, width, .. } = Contact::from_spot(spot);
            let [here, more, less, wider, narrower] = found.map(|of_spot| of_spot.total(boundary));
            let by_joint_load = (more - less) / load;
            let by_width = (wider - narrower) / width;
            let of_contact = [by_joint_load, by_width].map(|slope| f * slope / (2.0 * h * total));
            [(here - mean) / total, of_contact[0], of_contact[1]]
        };
        let found = found.as_chunks().0;
        Ok(spots.iter().zip(found).map(slopes).collect())
    }

    /// Friction and film of the contacts of a list, one after the other to `each`. The list holds the shear stresses of their films
    /// afterwards, which `shear` finds.
    fn of_each<T>(
        &self,
        list: &mut SpotList,
        shear: impl FnOnce(&mut [ShearedPoint]) -> Result<T, LoadShareError>,
        mut each: impl FnMut(usize, &SpotFriction),
    ) -> Result<T, LoadShareError> {
        cite!("Limiting-shear");
        cite!("Larsson-Andersson");
        let state = self.rheology.state(self.wall)?;
        self.find_films(&state, list)?;
        let SpotList {
            stresses,
            films,
            sheared,
            ..
        } = list;
        let wall = self.wall.si();
        sheared.clear();
        for (of_contact, stresses) in films.iter().zip(&*stresses) {
            let films = of_contact.iter().zip(stresses);
            sheared.extend(films.filter(|(at, _)| at.part > 0.0).map(|(at, near)| {
                let film = at.film.max(THINNEST);
                ShearedPoint {
                    point: self.rheology.film_point(at.pressure, self.sliding, film),
                    start: near.map(|near| near.stress + near.slope * (wall - near.wall)),
                    stress: [0.0; 2],
                }
            }));
        }
        let other = shear(sheared)?;
        let mut sheared = sheared.iter();
        for (k, (of_contact, stresses)) in films.iter().zip(stresses).enumerate() {
            let mut found = SpotFriction::default();
            let films = of_contact.iter().zip(stresses);
            for ((at, own), point) in films.filter(|(at, _)| at.part > 0.0).zip(&mut sheared) {
                let [stress, slope] = point.stress;
                *own = Some(SpotStress {
                    wall,
                    stress,
                    slope,
                });
                let of_film = SpotFriction {
                    boundary_share: at.boundary_share,
                    lubricated: (1.0 - at.boundary_share) * stress / at.pressure,
                    film: at.film,
                };
                found.add(&of_film, at.part);
            }
            each(k, &found);
        }
        Ok(other)
    }

    /// Sets the films of the contacts of a list.
    fn find_films(&self, state: &FilmOilState, list: &mut SpotList) -> Result<(), LoadShareError> {
        cite!("Boundary-share");
        // The layer is checked once; films are positive.
        boundary_share(Length::from_si(1.0), self.boundary_layer)?;
        let SpotList {
            contacts, films, ..
        } = list;
        films.clear();
        films.resize(contacts.len(), [SpotFilm::NONE; 2]);
        for (films, contacts) in films.chunks_mut(LANES).zip(contacts.chunks(LANES)) {
            self.films_of_each(state, contacts, films)?;
        }
        Ok(())
    }

    /// The films of up to [`LANES`] contacts.
    ///
    /// ```text
    /// β = k β(h(u_m)) + (1 − k) max(β_i, β(h(|u₁ − u₂|/2))),  β(h) = 1/(1 + h/h_b)            [Carried-film]
    /// ```
    ///
    /// A spot that forms inside the contact is surrounded by oil under its pressure. Sliding holds this oil at the stress where
    /// τ/τ₀ is large, and for flow along the motion Eyring's viscosity η/cosh(τ/τ₀) is there τ₀ h/V, whatever η is: the
    /// film that flows in is below a nanometre. β_i is what its roughness holds above the boundary layer.
    fn films_of_each(
        &self,
        state: &FilmOilState,
        contacts: &[Contact],
        films: &mut [[SpotFilm; 2]],
    ) -> Result<(), LoadShareError> {
        let (entrainment, inner) = match self.feed {
            Feed::At(speed) => (speed, None),
            Feed::Carried {
                entrainment,
                half_sliding,
                half_width,
                inner_boundary,
            } => {
                // Without a boundary layer nothing is left of the share on it.
                let held = match self.boundary_layer.si() {
                    layer if layer > 0.0 => layer * (1.0 / inner_boundary - 1.0),
                    _ => f64::INFINITY,
                };
                (entrainment, Some((half_sliding, half_width, held)))
            }
        };
        let flowing = self.flowing(state, contacts, entrainment)?;
        let Some((half_sliding, half_width, held)) = inner else {
            for ((of_spot, contact), film) in films.iter_mut().zip(contacts).zip(flowing) {
                of_spot[0] = self.with_film(1.0, film, contact);
            }
            return Ok(());
        };
        let part =
            |contact: &Contact| carried_part(entrainment, self.sliding, half_width, contact.width);
        // A film rises with its speed, at most in proportion.
        let may_be_thinner = |film: f64| held >= film * (half_sliding / entrainment).min(1.0);
        let mut of_each = contacts.iter().zip(flowing);
        let slow = if of_each.any(|(contact, film)| part(contact) < 1.0 && may_be_thinner(film)) {
            self.flowing(state, contacts, half_sliding)?
        } else {
            [f64::INFINITY; LANES]
        };
        for (k, (contact, of_spot)) in contacts.iter().zip(films).enumerate() {
            let (part, film) = (part(contact), flowing[k]);
            if part < 1.0 {
                cite!("Carried-film");
                let held = if may_be_thinner(film) {
                    held.min(slow[k])
                } else {
                    held
                };
                of_spot[1] = self.with_film(1.0 - part, held, contact);
            }
            of_spot[0] = self.with_film(part, film, contact);
        }
        Ok(())
    }

    fn with_film(&self, part: f64, film: f64, contact: &Contact) -> SpotFilm {
        SpotFilm {
            part,
            film,
            boundary_share: share_on_layer(film, self.boundary_layer.si()),
            pressure: contact.pressure(),
        }
    }

    /// Films \[m\] of up to [`LANES`] contacts, fed at a speed.
    fn flowing(
        &self,
        state: &FilmOilState,
        contacts: &[Contact],
        speed: f64,
    ) -> Result<[f64; LANES], LoadShareError> {
        let modulus = 2.0 * self.modulus;
        let groups_of = |contact: &Contact| {
            let (load, radius) = contact.line_through_middle(self.modulus);
            let groups = FilmGroups {
                material: state.pressure_viscosity.si() * modulus,
                speed: state.viscosity.si() * speed / (modulus * radius),
                load: load / (modulus * radius),
            };
            (groups, radius)
        };
        let mut inputs = [[1.0; LANES]; 4];
        for (k, contact) in contacts.iter().enumerate() {
            let (of_contact, radius) = groups_of(contact);
            let FilmGroups {
                material,
                speed,
                load,
            } = of_contact;
            for (lanes, value) in inputs.iter_mut().zip([material, speed, load, radius]) {
                lanes[k] = value;
            }
        }
        // Whole vectors: those that are left have inputs of 1.
        let mut films = moes_of_each(inputs, contacts.len().next_multiple_of(VECTOR_WIDTH));
        for (contact, film) in contacts.iter().zip(&mut films) {
            if let Some([_, ratio]) = contact.ellipse {
                *film *= side_flow(&groups_of(contact).0, ratio)?;
            }
            if !(film.is_finite() && *film > 0.0) {
                // It names what is wrong.
                let (groups, radius) = groups_of(contact);
                moes(&groups, Length::from_si(radius))?;
            }
        }
        Ok(films)
    }
}

#[cfg(test)]
mod tests {
    use asperity_contact::hertz_line::HertzLine;
    use asperity_contact::hertz_point::HertzPoint;
    use asperity_core::quantity::{Force, LineLoad, Pressure};

    use super::*;

    #[test]
    fn a_long_spot_has_the_film_of_a_line_and_a_round_one_less() {
        let groups = FilmGroups {
            material: 4000.0,
            speed: 1e-11,
            load: 1e-5,
        };
        let factor = |ratio| side_flow(&groups, ratio).unwrap();
        assert_eq!(factor(1e3), 1.0);
        assert!((factor(1.0) - (1.0 - 0.61 * (-0.73f64).exp())).abs() < 1e-12);
        assert!(factor(0.5) < factor(1.0));
    }

    #[test]
    fn a_spot_has_the_radius_of_the_elliptical_hertz_contact_with_its_axes() {
        let modulus = Pressure::from_si(115e9);
        for radii in [[1e-3, 1e-3], [1e-3, 0.4e-3], [1e-3, 8e-3], [1e-3, 50.0]] {
            let of_radii = radii.map(Length::from_si);
            let hertz = HertzPoint::new(Force::from_si(0.4), of_radii, modulus).unwrap();
            let [a, c] = hertz.half_axes.map(Length::si);
            let middle = 0.5 * PI * a * hertz.max_pressure.si();
            let contact = Contact {
                load: 0.0,
                width: 2.0 * a,
                ellipse: Some([middle, c / a]),
            };
            let (load, radius) = contact.line_through_middle(modulus.si());
            assert!(
                (radius / radii[0] - 1.0).abs() < 1e-12,
                "{radii:?}: {radius}"
            );
            // The line has the largest pressure of the ellipse.
            let line = LineLoad::from_si(load);
            let line = HertzLine::new(line, Length::from_si(radius), modulus).unwrap();
            assert!((line.max_pressure / hertz.max_pressure - 1.0).abs() < 1e-12);
        }
        // A ridge that becomes even along the lead.
        assert!((radius_over_line(1e4) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn a_spot_that_is_slid_past_fast_forms_inside_the_contact() {
        let (half_width, width) = (100e-6, 5e-6);
        let at = |sliding: f64| carried_part(6.0, sliding, half_width, width);
        assert_eq!(at(0.0), 1.0);
        // Fast sliding: travel 2√2 · 6 · 5 µm/12 = 7.07 µm of a way of 200 µm.
        assert!((at(12.0) - CROSSING * 2.5e-6 / 400e-6).abs() < 1e-15);
        // Slow sliding: travel 20 half-widths.
        assert!((at(CROSSING * 6.0 * width / (20.0 * half_width)) - 0.95).abs() < 1e-14);
        // Both forms join with one slope where the travel is the width of the contact.
        let joint = CROSSING * 6.0 * width / (2.0 * half_width);
        assert!((at(joint) - 0.5).abs() < 1e-15);
        let slope = |step: f64| (at(joint * (1.0 + step)) - at(joint)) / step;
        assert!((slope(1e-6) - slope(-1e-6)).abs() < 1e-5);
        // The mean over the way of the spots that are older than their distance from the inlet.
        for sliding in [0.1, 0.5, 2.0, 9.0] {
            let travel = CROSSING * 6.0 * width / sliding;
            let n = 100_000;
            let older = |i: u32| {
                let x = 2.0 * half_width * (f64::from(i) + 0.5) / f64::from(n);
                (1.0 - x / travel).max(0.0)
            };
            let mean = (0..n).map(older).sum::<f64>() / f64::from(n);
            assert!((at(sliding) - mean).abs() < 1e-8, "{sliding}");
        }
    }
}
