//! The equations of the subsurface stress, for `docs/EQUATIONS.md`.

use asperity_core::material::JOHNSON_1985;
use asperity_core::{Equation, Reference};

const MCEWEN_1949: Reference = Reference {
    key: "mcewen_1949",
    text: "E. McEwen, Stresses in elastic cylinders in contact along a generatrix, Philosophical Magazine 40, 454-459, 1949",
};
const VON_MISES_1913: Reference = Reference {
    key: "von_mises_1913",
    text: "R. von Mises, Mechanik der festen Körper im plastisch-deformablen Zustand, Nachrichten der Gesellschaft der Wissenschaften zu Göttingen, 582-592, 1913",
};
const TRESCA_1864: Reference = Reference {
    key: "tresca_1864",
    text: "H. Tresca, Mémoire sur l'écoulement des corps solides soumis à de fortes pressions, Comptes rendus de l'Académie des sciences 59, 754-758, 1864",
};

const POINT: &str = "crates/contact/src/subsurface/point.rs";

/// Every equation of the subsurface stress.
pub const EQUATIONS: &[Equation] = &[
    Equation {
        tag: "P5",
        title: "Shear stress under the middle of the contact",
        formula: "Hertz: τ₁ = (p₀/b)·(z − z²/√(b² + z²)); uniform strip: τ₁ = (2·p/π)·a·z/(a² + z²)",
        file: "crates/contact/src/subsurface/axis.rs",
        test: "shear_under_hertz_peaks_at_0_786_half_widths_and_not_at_one",
        references: &[JOHNSON_1985],
        misprint: Some(
            "printed: maximum at z = a, 20.7 %; used: maximum 0.30028 p₀ at z = 0.78615 b under a Hertz contact, p/π at z = a under a uniform strip (both evaluated)",
        ),
    },
    Equation {
        tag: "Subsurface-1",
        title: "Stress under a uniformly loaded strip",
        formula: "A, B = −(2δθ ± δs)/2π, C = δc/2π, D = (4·ln(r₁/r₂) − δc)/2π",
        file: "crates/contact/src/subsurface/strip.rs",
        test: "the_unit_strip_equals_the_integrated_flamant_solution",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Subsurface-2",
        title: "Stress under a Hertz line contact with full sliding",
        formula: "σ_xx = −(p₀/b)·(m·(1 + s/d) − 2z), σ_zz = −(p₀/b)·m·(1 − s/d), τ_xz = −(p₀/b)·n·(m² − z²)/d, each with its share of μ",
        file: "crates/contact/src/subsurface/hertz_stress.rs",
        test: "mises_peaks_on_the_axis_where_johnson_says",
        references: &[MCEWEN_1949, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Subsurface-3",
        title: "Stress under any pressure and traction",
        formula: "σ(x, z) = Σⱼ K(x − xⱼ, z)·pⱼ + Σⱼ K'(x − xⱼ, z)·qⱼ",
        file: "crates/contact/src/subsurface/field.rs",
        test: "the_field_of_hertz_converges_with_the_square_of_the_cell",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Shear-1",
        title: "Largest shear stress in the plane",
        formula: "τ₁ = √(¼·(σ_xx − σ_zz)² + τ_xz²)",
        file: POINT,
        test: "the_axis_forms_agree_with_the_whole_fields",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Mises-1",
        title: "Equivalent stress of von Mises in plane strain",
        formula: "σ_M = √(½·((σ_xx − σ_zz)² + (σ_zz − σ_yy)² + (σ_yy − σ_xx)²) + 3·τ_xz²), σ_yy = ν·(σ_xx + σ_zz)",
        file: POINT,
        test: "equivalents_of_simple_states_are_the_textbook_ones",
        references: &[VON_MISES_1913],
        misprint: None,
    },
    Equation {
        tag: "Tresca-1",
        title: "Equivalent stress of Tresca in plane strain",
        formula: "σ_T = max(2·τ₁, |σ₁ − σ_yy|, |σ₂ − σ_yy|)",
        file: POINT,
        test: "equivalents_of_simple_states_are_the_textbook_ones",
        references: &[TRESCA_1864],
        misprint: None,
    },
];
