//! The film of one position at one temperature, and the load share of any window there.

pub mod gradient;
pub mod unflattening;

use asperity_contact::hertz_line::HertzLine;
use asperity_core::line_contact::LineContact;
use asperity_core::numerics::{Solved, secant_root};
use asperity_core::quantity::{Length, LineEnergy, Pressure, Speed, Temperature};
use asperity_core::{Checked, FittedRange, OutOfRange, cite};
use asperity_ehl_regime::inlet_flow::{
    CentralFilm, LARGEST_SHARE, flow_of_lines, inlet_factor, supplied_gap,
};
use asperity_ehl_regime::light_load::LightLoad;
use asperity_ehl_regime::steady_film::flow_rise;
use asperity_ehl_regime::{
    Attenuation, FilmConditions, FlowTable, GapLaw, MoesNumbers, PairSpectrum, PatchPair,
    RoughInlet, thermal_loading,
};
use asperity_oil::{FilmRheology, ShearedPoint};
use asperity_tribo_friction::boundary::{FrictionParts, SharedFriction};
use asperity_tribo_friction::{FilmHeat, FilmLineContact, FilmRipple, FilmSettings, LoadedFilm};

use crate::contact_table::ContactTable;
use crate::error::LoadShareError;
use crate::load_share_settings::{InletSupply, LoadShareSettings, PatchGap, SmoothFilm, SpotSpeed};
use crate::rough_contact::{CORE, ContactState, RoughContact};
use crate::solution::{LineLosses, LoadShareSolution, ShareEvidence};
use crate::spot_tree::Spot;
use crate::spots::{Feed, SpotConditions, SpotFriction, SpotList};
use crate::window_gap::gap_under;
use crate::window_roughness::{Flattening, WindowRoughness};

/// Relative step at which the secant iteration for friction ends: it leaves 2e-9 of the loss of the shipped e-drive case, 7e-8 at
/// most of the loss at one of its offsets.
const TOLERANCE: f64 = 3e-5;
/// Relative step in φ^¼ at which the direct solves end: 4e-8 of the share.
const DIRECT_TOLERANCE: f64 = 1e-8;

/// Relative step of the difference quotient of ln Ψ over σ_d.
const INLET_STEP: f64 = 1e-4;
/// Thinnest film in a valley or on a peak of the ripple, over the smooth film.
const THINNEST_RIPPLE: f64 = 0.2;
/// Lay factors t of the lays 1 and 1/3: σ_d is of all heights at the first, of the heights above the mean line at the second.
const PEAK_LAYS: [f64; 2] = [0.25, 0.625];

/// Friction coefficient that no lubricated contact reaches: the upper end of its bracket.
const MOST_FRICTION: f64 = 1.0;
/// Least share that is solved for directly: below it the spots are single cells.
const LEAST_DIRECT_SHARE: f64 = 1e-6;

/// Range in which the inlet supply was compared with mixed-EHL solutions.
const COMPARED: FittedRange = FittedRange::new(
    "attenuated roughness over film",
    0.0,
    3.0,
    "-",
    "mixed-EHL solutions of the load share",
);

/// The film of one line contact at one temperature, for all its windows.
///
/// ```no_run
/// # use asperity_mixed_film::*;
/// # use asperity_ehl_regime::{PairSpectrum, TraceSpectrum};
/// # fn example(contact: asperity_core::line_contact::LineContact, rheology: &asperity_oil::FilmRheology,
/// #     tables: &[ContactTable], spectra: [&TraceSpectrum; 2], starts: &[[usize; 2]],
/// #     points: usize) -> Result<(), Box<dyn std::error::Error>> {
/// let settings = LoadShareSettings::default();
/// let mut film = PositionFilm::new(rheology, &contact, "90 °C".parse()?, &settings)?;
/// let flattening = film.flattening(&PairSpectrum::from_traces(spectra))?;
/// let traces = AttenuatedTraces::new(spectra, &flattening);
/// for (table, starts) in tables.iter().zip(starts) {
///     let window = traces.window(*starts, points)?;
///     println!("mu {:.4}", film.share(table, &window)?.value.coefficient);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct PositionFilm<'a> {
    rheology: &'a FilmRheology,
    settings: LoadShareSettings,
    contact: LineContact,
    bulk: f64,
    /// Gap of smooth flanks h_g, which supplies and shears.
    gap: Length,
    /// Central film of smooth flanks h_c as a mass flow, over which s is taken.
    mass_flow: Length,
    /// Ratio by which roughness raises the gap more than at full load.
    flow_rise: f64,
    thermal_factor: f64,
    nabla: f64,
    /// Computed flow through the patches of both flanks, instead of the second order in σ_d over the gap.
    flow: Option<FlowTable>,
    /// σ_d of both whole traces by the smooth inlet, over the smooth mass-flow film.
    roughness_over_film: Option<f64>,
    hertz: HertzLine,
    film: LoadedFilm<'a>,
    outside: Vec<OutOfRange>,
    /// μ of the window before, from which the next one's iteration starts, with its slope there.
    before: Option<[f64; 2]>,
}

/// State of the contact at the solved share.
struct Touching<'s> {
    share: Solved,
    mean_gap: Length,
    spots: Vec<(&'s [Spot], f64)>,
    area: f64,
    max_pressure: Pressure,
    dissipated: LineEnergy,
    /// Worst load error and duality gap of the contacts behind it.
    worst: [f64; 2],
}

/// Friction at the solved share.
struct WindowFriction {
    shared: SharedFriction,
    /// Mean film of the spots \[m\].
    spot_film: f64,
    /// Solution of the friction coefficient.
    evidence: Solved,
}

/// Film and spots at a rise of the surface temperature \[K\].
#[derive(Debug, Clone, Copy)]
struct AtRise {
    rise: f64,
    /// Friction coefficient of the film.
    film: f64,
    spot: SpotFriction,
}

/// Smooth film: h_g and h_c.
impl<'a> PositionFilm<'a> {
    /// The film of a contact whose flanks and oil have the temperature `bulk`.
    ///
    /// # Errors
    /// When a quantity is outside its domain, or the oil has no viscosity at the temperature.
    pub fn new(
        rheology: &'a FilmRheology,
        contact: &LineContact,
        bulk: Temperature,
        settings: &LoadShareSettings,
    ) -> Result<Self, LoadShareError> {
        let state = rheology.state(bulk)?;
        let [u1, u2] = contact.speeds;
        let conditions = conditions(rheology, contact, bulk)?;
        let hertz = HertzLine::new(contact.load, contact.radius, contact.modulus)?;
        let formula = settings.film_law.film(&conditions)?;
        let mut outside = formula.outside;
        let loading = thermal_loading(
            state.viscosity,
            state.temperature_coefficient,
            conditions.entrainment,
            state.conductivity,
        )?;
        let slide_to_roll = (u1 - u2) / conditions.entrainment;
        let thermal = settings.thermal.reduction(
            hertz.max_pressure,
            contact.modulus,
            loading,
            slide_to_roll,
        )?;
        outside.extend(thermal.outside);
        let film = SmoothFilm {
            central: formula.value.central * thermal.value,
            thermal_factor: thermal.value,
        };
        let mut of_film = Self::with_film(rheology, contact, bulk, settings, film)?;
        outside.append(&mut of_film.outside);
        of_film.outside = outside;
        Ok(of_film)
    }

    /// The film with a smooth film that is known; `film_law` and `thermal` of `settings` are ignored.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_film(
        rheology: &'a FilmRheology,
        contact: &LineContact,
        bulk: Temperature,
        settings: &LoadShareSettings,
        smooth: SmoothFilm,
    ) -> Result<Self, LoadShareError> {
        settings.check()?;
        let conditions = conditions(rheology, contact, bulk)?;
        let hertz = HertzLine::new(contact.load, contact.radius, contact.modulus)?;
        let gap = CentralFilm::Gap.thickness(smooth.central, hertz.max_pressure)?;
        let numbers = MoesNumbers::from_groups(&conditions.line_groups()?)?;
        let sheared = FilmLineContact {
            line: *contact,
            film: gap,
            temperature: bulk,
        };
        let film = loaded_film(rheology, &sheared, settings.film, &numbers)?;
        Ok(Self {
            rheology,
            settings: *settings,
            contact: *contact,
            bulk: bulk.si(),
            gap,
            mass_flow: smooth.central,
            flow_rise: match settings.supply {
                InletSupply::Rough => flow_rise(&numbers),
                InletSupply::Grubin | InletSupply::Starved | InletSupply::Smooth => 1.0,
            },
            thermal_factor: smooth.thermal_factor,
            nabla: numbers.nabla_per_length(hertz.half_width)?,
            flow: None,
            roughness_over_film: None,
            hertz,
            outside: film.outside().to_vec(),
            film,
            before: None,
        })
    }

    /// Dimensionless wavelength of a metre in the smooth inlet of this contact.
    #[must_use]
    pub fn nabla_per_length(&self) -> f64 {
        self.nabla
    }

    /// Central film of smooth flanks h_c.
    #[must_use]
    pub fn smooth_film(&self) -> Length {
        self.mass_flow
    }

    /// Gap of smooth flanks h_g, in which the film shears.
    #[must_use]
    pub fn sheared_film(&self) -> Length {
        self.gap
    }
}

/// Supply: Ψ by the roughness that the inlet leaves.
impl PositionFilm<'_> {
    /// Smooth film in the supply: h_g of a flooded inlet, h_c of a starved one and of `jgp`.
    #[must_use]
    pub fn supply_film(&self) -> Length {
        match self.settings.supply.gap_law() {
            GapLaw::Inlet => self.gap,
            GapLaw::Power => self.mass_flow,
        }
    }

    /// Film over which roughness counts in Ψ: the one of the supply, or thinner where roughness raises the gap more than at full load.
    #[must_use]
    pub fn roughness_film(&self) -> Length {
        self.supply_film() / self.flow_rise.sqrt()
    }

    /// Flattening of the roughness in the inlet of this contact, for [`AttenuatedTraces`](crate::AttenuatedTraces). The
    /// gap law `inlet` solves Ψ of both whole traces for it.
    ///
    /// # Errors
    /// When the film is not positive.
    pub fn flattening(&mut self, traces: &PairSpectrum) -> Result<Flattening, LoadShareError> {
        self.flow = None;
        let smooth = Attenuation::new(self.settings.supply.gap_law(), self.nabla)?;
        let attenuation = match self.settings.supply.gap_law() {
            GapLaw::Power => smooth,
            GapLaw::Inlet => {
                self.roughness_over_film = Some(traces.roughness(&smooth) / self.mass_flow);
                self.inlet(traces)?.attenuation
            }
        };
        Ok(self.flattening_by(attenuation))
    }

    /// Flattening of the patches of both flanks in the inlet of this contact. From here on the gap supplied is by their
    /// computed flow, with the standard deviation of all heights: the flow knows which heights are in its way.
    ///
    /// # Errors
    /// When the film is not positive, the gap law is `power` or a flow has no solution.
    pub fn patch_flattening(&mut self, patches: &PatchPair) -> Result<Flattening, LoadShareError> {
        if self.settings.supply.gap_law() == GapLaw::Power {
            return Err(LoadShareError::flow_without_inlet());
        }
        let smooth = Attenuation::new(self.settings.supply.gap_law(), self.nabla)?;
        self.roughness_over_film = Some(patches.waves().roughness(&smooth) / self.mass_flow);
        let inlet = patches.inlet(self.nabla, self.roughness_film())?;
        self.flow = Some(patches.flow(&inlet.attenuation)?);
        Ok(Flattening {
            peak_weight: 0.0,
            ..self.flattening_by(inlet.attenuation)
        })
    }

    fn flattening_by(&self, attenuation: Attenuation) -> Flattening {
        let [of_all, of_peaks] = PEAK_LAYS;
        let lay = (self.settings.lay.factor() - of_all) / (of_peaks - of_all);
        Flattening {
            attenuation,
            peak_weight: lay.clamp(0.0, 1.0),
            reach: self.hertz.half_width * CORE,
            ripple: Some(self.contact.modulus),
        }
    }

    fn inlet(&self, traces: &PairSpectrum) -> Result<RoughInlet, LoadShareError> {
        let lay = self.settings.lay;
        Ok(RoughInlet::new(
            traces,
            self.nabla,
            self.roughness_film(),
            lay,
        )?)
    }

    fn inlet_factor(&self, attenuated_rms: Length) -> Result<f64, LoadShareError> {
        let by_lay = || inlet_factor(attenuated_rms, self.roughness_film(), self.settings.lay);
        let by_flow = |flow: &FlowTable| flow.inlet_factor(attenuated_rms, self.roughness_film());
        Ok(
            match (self.settings.supply, &self.flow, self.settings.patch_gap) {
                (InletSupply::Smooth, ..) => 1.0,
                (_, Some(flow), PatchGap::Computed) => by_flow(flow)?,
                (_, Some(flow), PatchGap::Times(factor)) => factor * by_flow(flow)?,
                _ => by_lay()?,
            },
        )
    }

    /// Slope of ln Ψ over σ_d \[1/m\].
    fn inlet_slope(&self, attenuated_rms: Length, psi: f64) -> Result<f64, LoadShareError> {
        let sigma = attenuated_rms.si();
        if sigma == 0.0 {
            return Ok(0.0);
        }
        if self.flow.is_none() {
            return Ok((1.0 - 1.0 / (psi * psi)) / sigma);
        }
        let at = |part: f64| self.inlet_factor(attenuated_rms * part);
        let quotient = at(1.0 + INLET_STEP)? / at(1.0 - INLET_STEP)?;
        Ok(quotient.ln() / (2.0 * INLET_STEP * sigma))
    }

    /// Flow through the roughness left in the contact over the flow of a smooth gap: of traces by their lay, of patches as computed.
    #[must_use]
    pub fn flow_factor(&self, gap: Length, attenuated_rms: Length) -> f64 {
        match &self.flow {
            Some(flow) => flow.factor(gap, attenuated_rms),
            None => flow_of_lines(gap, attenuated_rms, self.settings.lay),
        }
    }
}

/// Gap supplied to a window.
impl PositionFilm<'_> {
    /// h̄(φ) of a window \[m\] with its inputs checked once.
    fn supply_of(
        &self,
        psi: f64,
        window: &WindowRoughness,
    ) -> Result<impl Fn(f64) -> f64 + use<>, LoadShareError> {
        let (law, film) = (self.settings.supply.gap_law(), self.supply_film());
        supplied_gap(law, film, psi, 0.0)?;
        let middle = self.middle(window);
        Ok(move |phi: f64| {
            let gap =
                supplied_gap(law, film, psi, phi.clamp(0.0, 1.0)).map_or(f64::NAN, Length::si);
            gap_under(gap, middle).0
        })
    }

    /// Height of the middle of a window, as far as it counts in the gap.
    fn middle(&self, window: &WindowRoughness) -> f64 {
        match self.settings.supply {
            InletSupply::Rough => window.middle,
            InletSupply::Grubin | InletSupply::Starved | InletSupply::Smooth => 0.0,
        }
    }
}

/// Share: where the gap of the contact is the one supplied.
impl PositionFilm<'_> {
    /// Solves the missing rows of a window's table that [`share`](Self::share) needs; `contact` gives the window if any is
    /// missing.
    ///
    /// # Errors
    /// When σ_d is negative, `contact` fails or a contact does not converge.
    pub fn solve_rows<E: From<LoadShareError>>(
        &self,
        table: &ContactTable,
        window: &WindowRoughness,
        contact: impl FnOnce() -> Result<RoughContact, E>,
    ) -> Result<(), E> {
        let supply = self.supply_of(self.inlet_factor(window.deviation)?, window)?;
        table.solve_for(&supply, contact)
    }

    /// Load share and friction of a window known by its table.
    ///
    /// # Errors
    /// When σ_d is negative, a row of the table is needed and not solved or an iteration does not end.
    pub fn share(
        &mut self,
        table: &ContactTable,
        window: &WindowRoughness,
    ) -> Result<Checked<LoadShareSolution>, LoadShareError> {
        let psi = self.inlet_factor(window.deviation)?;
        let supply = self.supply_of(psi, window)?;
        let found = table.at_supply(&supply)?;
        let touching = match &found {
            None => self.untouched(supply(0.0)),
            Some(at) => Touching {
                share: at.share,
                mean_gap: at.mean_gap(),
                spots: at
                    .weighted()
                    .map(|(row, weight)| (row.spots.as_slice(), weight))
                    .collect(),
                area: at.mean(|row| row.area),
                max_pressure: Pressure::from_si(at.mean(|row| row.max_pressure.si())),
                dissipated: LineEnergy::from_si(at.mean(|row| row.dissipated.si())),
                worst: [
                    at.worst(|row| row.load_error),
                    at.worst(|row| row.duality_gap),
                ],
            },
        };
        self.conclude(&touching, window, psi)
    }

    /// Load share and friction of a window by direct contact solves, with the contact at the solved share.
    ///
    /// # Errors
    /// When σ_d is negative, a contact does not converge or an iteration does not end.
    pub fn share_by_direct_solves(
        &mut self,
        contact: &mut RoughContact,
        window: &WindowRoughness,
    ) -> Result<(Checked<LoadShareSolution>, Option<ContactState>), LoadShareError> {
        let psi = self.inlet_factor(window.deviation)?;
        let supply = self.supply_of(psi, window)?;
        let share = direct_share(contact, &supply)?;
        if share.value == 0.0 {
            let touching = self.untouched(supply(0.0));
            let solution = self.conclude(&touching, window, psi)?;
            return Ok((solution, None));
        }
        let state = contact.at(share.value)?;
        let touching = Touching {
            share,
            mean_gap: state.mean_gap,
            spots: vec![(state.spots.as_slice(), 1.0)],
            area: state.area,
            max_pressure: state.max_pressure,
            dissipated: state.dissipated,
            worst: [
                state.solution.certificate.load_error,
                state.solution.certificate.duality_gap,
            ],
        };
        let solution = self.conclude(&touching, window, psi)?;
        Ok((solution, Some(state)))
    }

    fn untouched(&self, gap: f64) -> Touching<'static> {
        Touching {
            share: Solved {
                value: 0.0,
                residual: 0.0,
                iterations: 0,
            },
            mean_gap: Length::from_si(gap),
            spots: Vec::new(),
            area: 0.0,
            max_pressure: self.hertz.max_pressure,
            dissipated: LineEnergy::from_si(0.0),
            worst: [0.0; 2],
        }
    }

    /// Friction at the share found: the root of μ against the surface temperature that it makes.
    ///
    /// ```text
    /// μ = (1 − φ) μ_f + φ [(1 − β) μ_a + β μ_b], all at T_s(μ)
    /// ```
    fn conclude(
        &mut self,
        touching: &Touching<'_>,
        window: &WindowRoughness,
        psi: f64,
    ) -> Result<Checked<LoadShareSolution>, LoadShareError> {
        let phi = touching.share.value * self.settings.share_factor;
        self.load_film(1.0 - phi, window, touching.mean_gap)?;
        let friction = if phi == 0.0 {
            self.film_alone()?
        } else {
            self.friction_of(phi, &touching.spots)?
        };
        let mut outside = self.outside.clone();
        COMPARED.check(self.roughness_over_film(window), &mut outside);
        let value = self.solution(touching, window, psi, &friction)?;
        Ok(Checked { value, outside })
    }

    /// s: σ_d of both whole traces over the mass-flow film, or of the window where the flattening has none.
    fn roughness_over_film(&self, window: &WindowRoughness) -> f64 {
        (self.roughness_over_film).unwrap_or(window.deviation / self.mass_flow)
    }

    fn solution(
        &self,
        touching: &Touching<'_>,
        window: &WindowRoughness,
        psi: f64,
        friction: &WindowFriction,
    ) -> Result<LoadShareSolution, LoadShareError> {
        let WindowFriction {
            shared, evidence, ..
        } = friction;
        let parts = shared.parts()?;
        let phi = shared.asperity_share;
        Ok(LoadShareSolution {
            asperity_share: phi,
            boundary_of_asperities: shared.boundary_share,
            boundary_share: phi * shared.boundary_share,
            coefficient: evidence.value,
            film_coefficient: shared.film,
            asperity_coefficient: shared.asperities,
            parts,
            losses: self.losses(&parts),
            smooth_film: self.mass_flow,
            thermal_factor: self.thermal_factor,
            attenuated_rms: window.deviation,
            roughness_over_film: self.roughness_over_film(window),
            inlet_factor: psi,
            mean_gap: touching.mean_gap,
            spot_film: Length::from_si(friction.spot_film),
            area: touching.area,
            max_pressure: touching.max_pressure,
            dissipated: touching.dissipated,
            surface_rise: self.film.surface_rise(evidence.value),
            evidence: ShareEvidence {
                share: touching.share,
                friction: *evidence,
                load_error: touching.worst[0],
                duality_gap: touching.worst[1],
            },
        })
    }

    /// Sliding losses of the parts of the friction per metre of face.
    fn losses(&self, parts: &FrictionParts) -> LineLosses {
        let [u1, u2] = self.contact.speeds;
        let force = self.contact.load.si() * (u1.si() - u2.si()).abs();
        LineLosses {
            film: parts.film * force,
            lubricated_asperities: parts.lubricated_asperities * force,
            boundary: parts.boundary * force,
        }
    }
}

/// Spots.
impl<'a> PositionFilm<'a> {
    /// The spots at a rise of the surface temperature.
    fn spot_conditions(&self, rise: f64) -> SpotConditions<'a> {
        let [u1, u2] = self.contact.speeds.map(Speed::si);
        let sliding = (u1 - u2).abs();
        let entrainment = 0.5 * (u1 + u2);
        // A spot without sliding keeps the least speed that a film can be computed for.
        let half_sliding = (0.5 * sliding).max(1e-6);
        let feed = match self.settings.spot_speed {
            SpotSpeed::Carried => Feed::Carried {
                entrainment,
                half_sliding,
                half_width: self.hertz.half_width.si(),
                inner_boundary: self.settings.inner_boundary,
            },
            SpotSpeed::Entrainment => Feed::At(entrainment),
            SpotSpeed::HalfSliding => Feed::At(half_sliding),
        };
        SpotConditions {
            rheology: self.rheology,
            wall: Temperature::from_si(self.bulk + rise),
            modulus: self.contact.modulus.si(),
            feed,
            sliding,
            boundary_layer: self.settings.boundary_layer,
        }
    }

    /// Sliding loss of each of some spots per metre of face \[W/m\], at the surface temperature of `solution`.
    ///
    /// # Errors
    /// When a spot has no film.
    pub fn losses_of_spots(
        &self,
        spots: &[Spot],
        solution: &LoadShareSolution,
    ) -> Result<Vec<f64>, LoadShareError> {
        self.spot_conditions(solution.surface_rise)
            .losses(spots, self.settings.boundary_friction)
    }
}

/// Friction of film and spots.
impl PositionFilm<'_> {
    /// Lets the film carry its share of the load in a window with a mean gap.
    ///
    /// ```text
    /// h = max(0.2, (g − y_f)/h_g) h_s                                       [Ripple-film]
    /// ```
    ///
    /// y_f is the height of a part of the window in the film over its mean line, g the mean gap, h_g the gap of smooth flanks.
    fn load_film(
        &mut self,
        share: f64,
        window: &WindowRoughness,
        gap: Length,
    ) -> Result<(), LoadShareError> {
        if !window.is_rippled() {
            self.film.carry(share)?;
            return Ok(());
        }
        cite!("Ripple-film");
        let [sheared, supplied] = [self.gap.si(), self.supply_film().si()];
        let of_parts = window.ripple.iter().map(|part| FilmRipple {
            area: part.length,
            pressure: part.pressure,
            film: sheared * ((gap.si() - part.height) / supplied).max(THINNEST_RIPPLE),
        });
        self.film
            .carry_rippled(share, &of_parts.collect::<Vec<_>>())?;
        Ok(())
    }

    /// The film without asperities, by the routine of film friction.
    fn film_alone(&mut self) -> Result<WindowFriction, LoadShareError> {
        let solution = self.film.solve()?.value;
        Ok(WindowFriction {
            shared: SharedFriction {
                asperity_share: 0.0,
                boundary_share: 0.0,
                film: solution.coefficient,
                asperities: 0.0,
                boundary: self.settings.boundary_friction,
            },
            spot_film: 0.0,
            evidence: solution.evidence,
        })
    }

    /// Friction of film and spots with the heat that it makes.
    fn friction_of(
        &mut self,
        phi: f64,
        spots: &[(&[Spot], f64)],
    ) -> Result<WindowFriction, LoadShareError> {
        let unit_rise = self.film.surface_rise(1.0);
        let is_cold = unit_rise == 0.0 || self.film.heat() == FilmHeat::Isothermal;
        // Other windows at a position rub alike; the first starts from the friction of cold surfaces.
        let begun = self.before.filter(|_| !is_cold);
        let mut spots = SpotList::new(spots);
        let begin = unit_rise * begun.map_or(0.0, |[mu, _]| mu);
        let (first, slope) = self.at_rise(begin, &mut spots)?;
        if is_cold {
            let evidence = Solved {
                value: self.total(phi, &first)?,
                residual: 0.0,
                iterations: 1,
            };
            return Ok(self.friction(phi, &first, evidence));
        }
        // Slope of μ − G(T_s(μ)): of the window before, or of the film's part.
        let begun = begun.unwrap_or([0.0, 1.0 - unit_rise * (1.0 - phi) * slope]);
        let (evidence, last) = self.heated(phi, first, begun, &mut spots)?;
        let mu = evidence.value;
        let (at, steepness) = self.along(phi, last, unit_rise * mu, begun[1])?;
        self.before = Some([mu, steepness]);
        let residual = mu - self.total(phi, &at)?;
        let evidence = Solved {
            residual,
            ..evidence
        };
        Ok(self.friction(phi, &at, evidence))
    }

    /// The root of μ − G(T_s(μ)), and the last two evaluations; `begun` is the friction with which it starts, with the slope there.
    fn heated(
        &mut self,
        phi: f64,
        first: AtRise,
        begun: [f64; 2],
        spots: &mut SpotList,
    ) -> Result<(Solved, [AtRise; 2]), LoadShareError> {
        let unit_rise = self.film.surface_rise(1.0);
        let found = self.total(phi, &first)?;
        let [from, steepness] = begun;
        let mut last = [first; 2];
        let mut known = Some(from - found);
        let mut failed = None;
        let excess = |mu| match known.take() {
            Some(at_from) => at_from,
            None => {
                let total = self.at_rise(unit_rise * mu, spots).and_then(|(at, _)| {
                    last = [last[1], at];
                    self.total(phi, &at)
                });
                total.map_or_else(
                    |error| {
                        failed = Some(error);
                        f64::NAN
                    },
                    |total| mu - total,
                )
            }
        };
        // Warmer spots have thinner films and more boundary friction: μ may exceed its cold value.
        let bracket = [0.0, MOST_FRICTION.max(2.0 * found).max(from)];
        let root = secant_root(excess, bracket, from, steepness, TOLERANCE);
        match failed {
            Some(error) => Err(error),
            None => root
                .map(|evidence| (evidence, last))
                .map_err(|source| LoadShareError::no_root("friction coefficient", source)),
        }
    }

    /// Film and spots at a rise along the line through the last two evaluations, as the step from the last leaves its square; and
    /// the slope of μ − G(T_s(μ)) there, `steepness` where they are one.
    fn along(
        &self,
        phi: f64,
        [before, after]: [AtRise; 2],
        rise: f64,
        steepness: f64,
    ) -> Result<(AtRise, f64), LoadShareError> {
        if after.rise == before.rise {
            return Ok((after, steepness));
        }
        let unit_rise = self.film.surface_rise(1.0);
        let totals = [self.total(phi, &after)?, self.total(phi, &before)?];
        let steepness = 1.0 - unit_rise * (totals[0] - totals[1]) / (after.rise - before.rise);
        let part = (rise - after.rise) / (after.rise - before.rise);
        let mut at = after;
        at.film += part * (after.film - before.film);
        at.spot.add(&after.spot, part);
        at.spot.add(&before.spot, -part);
        Ok((at, steepness))
    }

    fn friction(&self, phi: f64, at: &AtRise, evidence: Solved) -> WindowFriction {
        WindowFriction {
            shared: self.shared(phi, at),
            spot_film: at.spot.film,
            evidence,
        }
    }

    /// Friction coefficient of film and spots.
    fn total(&self, phi: f64, at: &AtRise) -> Result<f64, LoadShareError> {
        Ok(self.shared(phi, at).parts()?.total())
    }

    /// Film and spots at a rise of the surface temperature, and the slope of the film's friction over it.
    fn at_rise(
        &mut self,
        rise: f64,
        spots: &mut SpotList,
    ) -> Result<(AtRise, f64), LoadShareError> {
        let conditions = self.spot_conditions(rise);
        // Film and spots have the same walls: their points fill the lanes of a vector.
        let film = &mut self.film;
        let shear = |points: &mut [ShearedPoint]| Ok(film.friction_beside(rise, points)?);
        let (spot, [film, slope]) = conditions.friction_of(spots, shear)?;
        Ok((AtRise { rise, film, spot }, slope))
    }

    fn shared(&self, phi: f64, at: &AtRise) -> SharedFriction {
        SharedFriction {
            asperity_share: phi,
            boundary_share: at.spot.boundary_share.clamp(0.0, 1.0),
            film: at.film,
            asperities: at.spot.asperity_coefficient(),
            boundary: self.settings.boundary_friction,
        }
    }
}

/// Inputs of the film formulas from a contact.
fn conditions(
    rheology: &FilmRheology,
    contact: &LineContact,
    bulk: Temperature,
) -> Result<FilmConditions, LoadShareError> {
    let state = rheology.state(bulk)?;
    let [u1, u2] = contact.speeds;
    Ok(FilmConditions {
        entrainment: (u1 + u2) * 0.5,
        radius: contact.radius,
        load: contact.load,
        modulus: contact.modulus,
        viscosity: state.viscosity,
        pressure_viscosity: state.pressure_viscosity,
        contact_length: None,
    })
}

/// The film with its pressures at light load, which belong to its gap.
fn loaded_film<'a>(
    rheology: &'a FilmRheology,
    contact: &FilmLineContact,
    settings: FilmSettings,
    numbers: &MoesNumbers,
) -> Result<LoadedFilm<'a>, LoadShareError> {
    let mut film = LoadedFilm::new(rheology, contact, settings)?;
    let LightLoad { excess, inlet } = LightLoad::new(numbers);
    film.reach_beyond(&excess, inlet)?;
    Ok(film)
}

/// The share at which the contact's gap is the one supplied, by direct solves.
fn direct_share(
    contact: &mut RoughContact,
    supply: &impl Fn(f64) -> f64,
) -> Result<Solved, LoadShareError> {
    cite!("Load-share");
    let first_touch = contact.first_touch_gap().si();
    let mut failed = None;
    let mut gap = |phi: f64| match contact.at(phi) {
        Ok(state) => state.mean_gap.si(),
        Err(error) => {
            failed = Some(error);
            f64::NAN
        }
    };
    let scale = supply(0.0);
    let found = match end_share(first_touch, supply, &mut gap) {
        Some(end) => Ok(end),
        None => secant_root(
            |s: f64| {
                let phi = s.powi(4);
                (supply(phi) - gap(phi)) / scale
            },
            [
                LEAST_DIRECT_SHARE.sqrt().sqrt(),
                LARGEST_SHARE.sqrt().sqrt(),
            ],
            0.7,
            first_touch / scale,
            DIRECT_TOLERANCE,
        )
        .map(|root| Solved {
            value: root.value.powi(4),
            ..root
        }),
    };
    if let Some(error) = failed {
        return Err(error);
    }
    found.map_err(|source| LoadShareError::no_root("asperity share", source))
}

/// The share at the ends, if gap and supply are not equal between them.
fn end_share(
    first_touch: f64,
    supply: &impl Fn(f64) -> f64,
    gap: impl FnOnce(f64) -> f64,
) -> Option<asperity_core::numerics::Solved> {
    let at = |value: f64, residual: f64| asperity_core::numerics::Solved {
        value,
        residual,
        iterations: 0,
    };
    if first_touch <= supply(0.0) {
        return Some(at(0.0, 0.0));
    }
    let excess = gap(LARGEST_SHARE) / supply(LARGEST_SHARE) - 1.0;
    (excess > 0.0).then(|| at(LARGEST_SHARE, excess))
}
