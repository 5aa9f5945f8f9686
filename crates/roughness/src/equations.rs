//! The equations of this crate: the file, the formula and the test of each.

use asperity_core::{Equation, Reference};

/// The linear Gaussian filter.
pub const ISO_16610_21: Reference = Reference {
    key: "iso_16610_21_2011",
    text: "ISO 16610-21:2011, Geometrical product specifications - Filtration - Linear profile filters: Gaussian filters",
};

/// The robust filter.
pub const ISO_16610_31: Reference = Reference {
    key: "iso_16610_31_2016",
    text: "ISO 16610-31:2016, Geometrical product specifications - Filtration - Robust profile filters: Gaussian regression filters",
};

/// Treatment of the ends by the filters.
pub const ISO_16610_28: Reference = Reference {
    key: "iso_16610_28_2016",
    text: "ISO 16610-28:2016, Geometrical product specifications - Filtration - Profile filters: End effects",
};

/// Parameters per sampling length.
pub const ISO_4287: Reference = Reference {
    key: "iso_4287_1997",
    text: "ISO 4287:1997, Geometrical product specifications - Surface texture: Profile method - Terms, definitions and surface texture parameters",
};

/// Parameters over the evaluation length.
pub const ISO_21920_2: Reference = Reference {
    key: "iso_21920_2_2021",
    text: "ISO 21920-2:2021, Geometrical product specifications - Surface texture: Profile - Part 2: Terms, definitions and surface texture parameters",
};

/// The Rk family.
pub const ISO_13565_2: Reference = Reference {
    key: "iso_13565_2_1996",
    text: "ISO 13565-2:1996, Geometrical product specifications - Surface texture: Profile method; Surfaces having stratified functional properties - Part 2: Height characterization using the linear material ratio curve",
};

/// Spectral moments and summits of Gaussian surfaces.
pub const NAYAK_1971: Reference = Reference {
    key: "nayak_1971",
    text: "P. R. Nayak, Random process model of rough surfaces, Journal of Lubrication Technology 93 (1971) 398-407, doi:10.1115/1.3451608",
};

/// Spectra by windowed transforms.
pub const WELCH_1967: Reference = Reference {
    key: "welch_1967",
    text: "P. D. Welch, The use of fast Fourier transform for the estimation of power spectra, IEEE Transactions on Audio and Electroacoustics 15 (1967) 70-73, doi:10.1109/TAU.1967.1161901",
};

/// Spectra of self-affine surfaces.
pub const JACOBS_2017: Reference = Reference {
    key: "jacobs_2017",
    text: "T. D. B. Jacobs, T. Junge and L. Pastewka, Quantitative characterization of surface topography using spectral analysis, Surface Topography: Metrology and Properties 5 (2017) 013001, doi:10.1088/2051-672X/aa51f8",
};

/// Share of a volume from that of its cuts.
pub const DELESSE_1847: Reference = Reference {
    key: "delesse_1847",
    text: "A. Delesse, 1847, the share of a volume is that of its cuts, as told by University of Iowa, Central Microscopy, Methodology - Stereology, uiowa.edu/~cemrf",
};

/// Lower envelopes of parabolas in linear time.
pub const FELZENSZWALB_2012: Reference = Reference {
    key: "felzenszwalb_2012",
    text: "P. F. Felzenszwalb and D. P. Huttenlocher, Distance transforms of sampled functions, Theory of Computing 8 (2012) 415-428, doi:10.4086/toc.2012.v008a019",
};

/// The film over an asperity, for which the radius is needed.
pub const HANSEN_2021: Reference = Reference {
    key: "hansen_2021",
    text: "J. Hansen, M. Björling and R. Larsson, A new film parameter for rough surface EHL contacts with anisotropic and isotropic structures, Tribology Letters 69 (2021) 37, doi:10.1007/s11249-021-01411-3",
};

/// The model this project follows.
pub const RODRIGUEZ_2022: Reference = Reference {
    key: "rodriguez_2022",
    text: "I. Victoria Rodríguez, Modelling of gear surface roughness impact on gear meshing efficiency, manuscript and thesis, KTH and Volvo, 2022",
};

/// Estimates of correlation.
pub const BENDAT_2010: Reference = Reference {
    key: "bendat_2010",
    text: "J. S. Bendat and A. G. Piersol, Random Data: Analysis and Measurement Procedures, 4th edition, Wiley 2010",
};

/// Outliers by the running median.
pub const HAMPEL_1974: Reference = Reference {
    key: "hampel_1974",
    text: "F. R. Hampel, The influence curve and its role in robust estimation, Journal of the American Statistical Association 69 (1974) 383-393, doi:10.2307/2285666",
};

/// Geometry of involute flanks.
pub const LITVIN_2004: Reference = Reference {
    key: "litvin_2004",
    text: "F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2nd edition, Cambridge University Press 2004",
};

/// Non-Gaussian surfaces.
pub const PEREZ_RAFOLS_2019: Reference = Reference {
    key: "perez_rafols_2019",
    text: "F. Pérez-Ràfols and A. Almqvist, Generating randomly rough surfaces with given height probability distribution and power spectrum, Tribology International 131 (2019) 591-604, doi:10.1016/j.triboint.2018.11.020",
};

macro_rules! equation {
    ($tag:literal, $title:literal, $formula:literal, $file:literal, $test:literal, [$($reference:ident),*]) => {
        Equation {
            tag: $tag,
            title: $title,
            formula: $formula,
            file: concat!("crates/roughness/src/", $file),
            test: $test,
            references: &[$($reference),*],
            misprint: None,
        }
    };
}

/// Equations of this crate.
pub const EQUATIONS: &[Equation] = &[
    equation!(
        "P8",
        "Composite root mean square height",
        "S = √(Rq₁² + Rq₂²)",
        "composite.rs",
        "heights_of_uncorrelated_flanks_add_in_squares",
        [RODRIGUEZ_2022]
    ),
    equation!(
        "Composite-1",
        "Composite profile",
        "z(x) = z₁(x) + z₂(x)",
        "composite.rs",
        "composing_resamples_only_when_asked",
        [RODRIGUEZ_2022]
    ),
    equation!(
        "Form-1",
        "Least-squares polynomial",
        "min Σ (zᵢ − Σₖ cₖ pₖ(tᵢ))²",
        "form.rs",
        "a_polynomial_is_removed_to_the_last_digits",
        []
    ),
    equation!(
        "Form-2",
        "Least-squares circle",
        "z(x) = c₀ + c₁ x ± (√(R² − x²) − R)",
        "form.rs",
        "a_steep_circle_is_removed_where_a_parabola_is_not",
        []
    ),
    equation!(
        "Gauss-1",
        "Constant of the Gaussian filter",
        "α = √(ln 2/π)",
        "gaussian_filter.rs",
        "the_filter_passes_half_the_amplitude_at_its_cutoff",
        [ISO_16610_21]
    ),
    equation!(
        "Gauss-2",
        "Transmission of the mean line",
        "a(λ) = exp(−π (α λ_c/λ)²)",
        "gaussian_filter.rs",
        "the_filter_passes_half_the_amplitude_at_its_cutoff",
        [ISO_16610_21]
    ),
    equation!(
        "Gauss-3",
        "Gaussian weights",
        "s(x) = exp(−π (x/(α λ_c))²)/(α λ_c)",
        "gaussian_filter.rs",
        "the_fast_filter_equals_direct_sums_with_every_treatment_of_the_ends",
        [ISO_16610_21]
    ),
    equation!(
        "Gauss-4",
        "Mean line and its ends",
        "w̄ᵢ = Σₖ w_k zᵢ₊ₖ",
        "gaussian_filter.rs",
        "the_fast_filter_equals_direct_sums_with_every_treatment_of_the_ends",
        [ISO_16610_21, ISO_16610_28]
    ),
    equation!(
        "Robust-1",
        "Robust mean line",
        "min Σ s_k δ_i+k (z_i+k − a − b u − c u²)², δ = (1 − (r/c)²)²",
        "robust_filter.rs",
        "the_robust_line_is_that_of_direct_sums_by_the_definition",
        [ISO_16610_31]
    ),
    equation!(
        "Prep-1",
        "Roughness profile",
        "P = S(z − form; λ_s),  R = P − w̄(P; λ_c)",
        "preparation.rs",
        "preparing_drops_half_a_cutoff_and_says_what_was_done",
        [ISO_21920_2]
    ),
    equation!(
        "Section-1",
        "Number of sections",
        "n = ⌊l_e/l_c⌋",
        "height_parameters.rs",
        "a_sine_has_its_textbook_heights_in_both_modes",
        [ISO_4287]
    ),
    equation!(
        "Section-2",
        "Heights of one section",
        "Ra = ⟨|z|⟩, Rq = √⟨z²⟩, Rz = max z − min z",
        "section_heights.rs",
        "one_section_has_the_heights_of_a_profile_of_one_section",
        [ISO_4287]
    ),
    equation!(
        "Height-1",
        "Moments of the heights",
        "Ra = ⟨|z|⟩, Rq = √⟨z²⟩, Rsk = ⟨z³⟩/Rq³, Rku = ⟨z⁴⟩/Rq⁴",
        "height_parameters.rs",
        "a_sine_has_its_textbook_heights_in_both_modes",
        [ISO_4287, ISO_21920_2]
    ),
    equation!(
        "Height-2",
        "Parameters per sampling length",
        "X = (1/n) Σ Xᵢ",
        "height_parameters.rs",
        "the_two_modes_differ_on_a_single_feature",
        [ISO_4287]
    ),
    equation!(
        "Height-3",
        "Parameters over the evaluation length",
        "Rp = mean over sections of the highest hill",
        "height_parameters.rs",
        "the_two_modes_differ_on_a_single_feature",
        [ISO_21920_2]
    ),
    equation!(
        "Rk-1",
        "Core, peak and pit heights",
        "Rk = c(0) − c(100), Rpk = 2 A₁/Mr1, Rvk = 2 A₂/(100 − Mr2)",
        "material_ratio.rs",
        "the_rk_family_of_a_sine_and_a_triangle_has_closed_forms",
        [ISO_13565_2]
    ),
    equation!(
        "Rk-2",
        "Material ratio curve",
        "Mr_k = (k + ½)/N at the k-th highest point",
        "material_ratio.rs",
        "areas_of_peaks_and_pits_are_those_of_their_triangles",
        [ISO_13565_2]
    ),
    equation!(
        "Rk-3",
        "Heights counted in steps",
        "s_j = s + q (½ − (j + ½)/n)",
        "quantised.rs",
        "rk_of_quantised_heights_is_that_of_the_heights",
        [ISO_13565_2]
    ),
    equation!(
        "Rmr-1",
        "Material ratio at a level",
        "Rmr(c) = Ml(c)/l_e",
        "material_levels.rs",
        "material_ratios_and_levels_of_a_sine_have_closed_forms",
        [ISO_4287, ISO_21920_2]
    ),
    equation!(
        "Rmr-2",
        "Level at a material ratio",
        "Rmr(Rmc(p)) = p",
        "material_levels.rs",
        "material_ratios_and_levels_of_a_sine_have_closed_forms",
        [ISO_21920_2]
    ),
    equation!(
        "Rmr-3",
        "Height between two material ratios",
        "Rdc(p, q) = Rmc(p) − Rmc(q)",
        "material_levels.rs",
        "material_ratios_and_levels_of_a_sine_have_closed_forms",
        [ISO_4287, ISO_21920_2]
    ),
    equation!(
        "Rmr-4",
        "Material ratio below a reference",
        "Rmr = Rmr(c₁), c₁ = Rmc(Rmr0) − Rδc",
        "material_levels.rs",
        "material_ratios_and_levels_of_a_sine_have_closed_forms",
        [ISO_4287]
    ),
    equation!(
        "Slope-1",
        "Seven-point slope",
        "z′ᵢ = (zᵢ₊₃ − 9 zᵢ₊₂ + 45 zᵢ₊₁ − 45 zᵢ₋₁ + 9 zᵢ₋₂ − zᵢ₋₃)/(60 dx)",
        "spectral.rs",
        "moments_of_a_sine_are_those_of_its_derivatives",
        [ISO_4287]
    ),
    equation!(
        "Moment-1",
        "Spectral moments",
        "m₀ = ⟨z²⟩, m₂ = ⟨z′²⟩, m₄ = ⟨z″²⟩",
        "spectral.rs",
        "moments_of_a_sine_are_those_of_its_derivatives",
        [NAYAK_1971]
    ),
    equation!(
        "PSD-1",
        "Power spectral density",
        "C(f_k) = 2 dx |Σ h_i (z_i − ⟨z⟩) e^(−2πi f_k x_i)|²/Σ h_i²",
        "spectral.rs",
        "the_spectrum_holds_the_power_of_the_profile_at_its_wavelength",
        [WELCH_1967]
    ),
    equation!(
        "Nayak-1",
        "Summit curvature of a Gaussian profile",
        "κ_s = √(π m₄/2)",
        "spectral.rs",
        "all_summits_of_a_gaussian_profile_have_nayaks_mean_curvature",
        [NAYAK_1971]
    ),
    equation!(
        "Summit-1",
        "Asperity radius",
        "R_xa = 1/⟨κ⟩",
        "summits.rs",
        "the_summits_of_parabolic_ridges_have_their_radius",
        [HANSEN_2021]
    ),
    equation!(
        "Summit-2",
        "Curvature of a summit",
        "κ = −2 c₂ of the least-squares parabola",
        "summits.rs",
        "the_summits_of_parabolic_ridges_have_their_radius",
        []
    ),
    equation!(
        "Affine-1",
        "Self-affine spectrum",
        "C(q) = C₀ (q/q_r)^−(1+2H) between q_r and q_s",
        "generate/self_affine.rs",
        "the_spectrum_falls_with_the_hurst_exponent_between_its_cut_offs",
        [JACOBS_2017]
    ),
    equation!(
        "Ground-1",
        "Ground flank",
        "z(x) = min (d_j + (x − x_j)²/(2ρ))",
        "generate/ground.rs",
        "the_envelope_is_the_least_of_all_grooves",
        [FELZENSZWALB_2012]
    ),
    equation!(
        "Pit-1",
        "Pit",
        "z − d cos²(π (x − x_c)/w)",
        "generate/damage.rs",
        "a_pit_and_a_scratch_have_their_depth_and_area",
        []
    ),
    equation!(
        "Pore-1",
        "Open pores of a sintered steel along a trace",
        "n = −ln(1 − P)/⟨c⟩",
        "generate/pores.rs",
        "the_share_of_the_trace_that_is_pore_is_the_porosity_in_the_mean",
        [DELESSE_1847]
    ),
    equation!(
        "Scratch-1",
        "Scratch with shoulders",
        "z − d (1 − 4|u|)",
        "generate/damage.rs",
        "a_pit_and_a_scratch_have_their_depth_and_area",
        []
    ),
    equation!(
        "Plateau-1",
        "Lower envelope",
        "z = min(z₁, z₂)",
        "generate/plateau.rs",
        "generated_profiles_have_the_asked_height_and_repeat_with_their_seed",
        []
    ),
    equation!(
        "Plateau-2",
        "Truncation",
        "z = min(z, s(Mr))",
        "generate/plateau.rs",
        "generated_profiles_have_the_asked_height_and_repeat_with_their_seed",
        []
    ),
    equation!(
        "ACF-1",
        "Autocorrelation over the overlap",
        "ρ_k = (1/(n − k)) Σ z_i z_{i+k} / ((1/n) Σ z_i²)",
        "autocorrelation.rs",
        "the_fast_autocorrelation_is_the_slow_sum",
        [BENDAT_2010]
    ),
    equation!(
        "ACF-2",
        "Autocorrelation lengths",
        "ρ(τ) = 0.2, 1/e",
        "autocorrelation.rs",
        "a_cosine_forgets_itself_after_its_arccosine",
        [BENDAT_2010]
    ),
    equation!(
        "Nayak-2",
        "Bandwidth",
        "α = m₀ m₄/m₂²",
        "spectral.rs",
        "two_waves_have_their_bandwidth",
        [NAYAK_1971]
    ),
    equation!(
        "Summit-3",
        "Density of summits",
        "D = √(m₄/m₂)/(2π)",
        "summits.rs",
        "summits_of_a_gaussian_profile_are_as_dense_as_its_moments_say",
        [NAYAK_1971]
    ),
    equation!(
        "Hurst-1",
        "Hurst exponent of a spectrum",
        "log C = a + b log f, H = −(b + 1)/2",
        "hurst.rs",
        "the_hurst_fit_finds_the_exponent_of_its_recipe",
        [JACOBS_2017]
    ),
    equation!(
        "Outlier-1",
        "Outliers by the running median",
        "|zᵢ − z̃ᵢ| > k d",
        "outliers.rs",
        "spikes_are_replaced_and_pits_stay",
        [HAMPEL_1974]
    ),
    equation!(
        "Form-3",
        "Involute about a point of its flank",
        "x = r_b (cos θ + ξ sin θ − 1), z = r_b (ξ cos θ − sin θ − ξ₀)",
        "involute.rs",
        "an_involute_traced_from_its_definition_is_removed",
        [LITVIN_2004]
    ),
    equation!(
        "Form-4",
        "Roll length fitted to a trace",
        "ρ̂ = argmin Σ (zᵢ − z(xᵢ; ρ₀, r_b) − line)²",
        "involute.rs",
        "a_wrong_roll_length_is_named_with_the_fitted_one",
        [LITVIN_2004]
    ),
    equation!(
        "NonGaussian-1",
        "Heights and spectrum in turn",
        "z ← h_(rank z) after |F z| ← √C",
        "generate/non_gaussian.rs",
        "heights_are_those_of_the_distribution_and_the_spectrum_is_near",
        [PEREZ_RAFOLS_2019]
    ),
    equation!(
        "Plateau-3",
        "Plateau-honed profile",
        "z = min(z₁, z₂ − d)",
        "generate/plateau.rs",
        "plateau_honed_profiles_have_the_heights_of_both_processes",
        [RODRIGUEZ_2022]
    ),
    equation!(
        "Prep-2",
        "Waviness and roughness",
        "P = W + R, W = w̄(P; λ_c)",
        "preparation.rs",
        "waviness_and_roughness_add_up_to_the_primary_profile",
        [ISO_21920_2]
    ),
];
