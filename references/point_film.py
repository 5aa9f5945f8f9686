"""Film and friction of smooth contacts at a point, with the heat of film and surfaces. Needs numpy and scipy.

Hertz ellipse by scipy's elliptic integrals, film by Hamrock and Dowson with Gupta's factor, friction by the laws of
`film_friction.py` at points over the pressure, every scalar equation by bisection (Brent).
"""

import json

import numpy as np
from scipy.optimize import brentq
from scipy.special import beta, ellipe, ellipk, gamma

from film_friction import E_STAR, STEEL, Oil
from held import ROOT, compare, report

GOLDEN = ROOT / "crates/mixed-film/tests/golden/point_film.json"
NODES = 96
LINE = np.sqrt(2 * np.pi) * gamma(2.5) * gamma(0.25) / (2**2.5 * gamma(1.75) ** 2 * gamma(2.75)) * (2 / np.pi) ** 1.5
POINT = 0.75 * beta(0.5, 2.75) / beta(0.5, 2.0) * LINE
# Names of the oils of `film_friction.py`.
NAMES = {"e-fluid": "e-fluid-70w75w"}


def hertz(load, along, across):
    """Half-axes, largest pressure and first integral of the ellipse."""
    ratio = max(along, across) / min(along, across)

    def excess(m):
        k, e = ellipk(m), ellipe(m)
        return (e / (1 - m) - k) / (k - e) - ratio

    m = 0.0 if ratio == 1.0 else brentq(excess, 1e-6, 1 - 1e-9, xtol=1e-16, rtol=1e-15)
    curvature = 0.5 / along + 0.5 / across
    long = (1.5 * load * ellipe(m) / (np.pi * E_STAR * (1 - m) * curvature)) ** (1 / 3)
    short = long * np.sqrt(1 - m)
    a, b = (short, long) if along <= across else (long, short)
    return a, b, 1.5 * load / (np.pi * a * b), ellipk(m)


def film(oil, c, p0):
    """Central film and thermal reduction."""
    t, speed, twice = c["T_C"] + 273.15, c["Ve"], 2 * E_STAR
    eta = oil.eta(t)
    slope = (np.log(oil.eta(t - 1e-3)) - np.log(oil.eta(t + 1e-3))) / 2e-3
    heat = eta * slope * speed**2 / oil.of["conductivity"]
    factor = max(1 - 13.2 * p0 / twice * heat**0.42, 0.3)
    factor /= 1 + 0.213 * (1 + 2.23 * abs(c["SRR"]) ** 0.83) * heat**0.64
    radius, ellipticity = c["Rx_m"], (c["Ry_m"] / c["Rx_m"]) ** (2 / np.pi)
    central = 2.69 * (eta * speed / (twice * radius)) ** 0.67 * (oil.alpha(t) * twice) ** 0.53
    central *= (c["F_N"] / (twice * radius**2)) ** -0.067 * (1 - 0.61 * np.exp(-0.73 * ellipticity)) * radius
    return factor * central, factor


def friction(oil, c, h, contact, heated):
    """Friction coefficient, rise of the surfaces and largest rise of the film."""
    a, b, p0, first = contact
    z, weight = np.polynomial.legendre.leggauss(NODES)
    z, weight = 0.5 * (z + 1), 0.5 * weight
    sliding = abs(c["SRR"]) * c["Ve"]
    conductance = 0.0
    for sign in (0.5, -0.5):
        u = c["Ve"] * (1 + sign * c["SRR"])
        fast = b * np.sqrt(STEEL["k"] * STEEL["rho"] * STEEL["c"]) * np.sqrt(2 * a * u) / POINT
        rest = np.pi * STEEL["k"] * max(a, b) / (0.6 * first)
        conductance += (fast**2.25 + rest**2.25) ** (1 / 2.25)

    def stresses(wall):
        return np.array([stress(oil, p0 * s, wall, sliding, h, heated) for s in z])

    def coefficient(rise):
        return 3 / p0 * np.sum(weight * z * stresses(c["T_C"] + 273.15 + rise))

    if not heated:
        return coefficient(0.0), 0.0, 0.0
    per_friction = c["F_N"] * sliding / conductance
    mu = brentq(lambda mu: mu - coefficient(per_friction * mu), 0.0, coefficient(0.0), xtol=1e-16, rtol=1e-13)
    wall = c["T_C"] + 273.15 + per_friction * mu
    rises = stresses(wall) * sliding * h / (12 * oil.conductivity(p0 * z))
    return mu, per_friction * mu, rises.max()


def stress(oil, p, wall, sliding, h, heated):
    cold = oil.stress(p, wall, sliding / h)
    if not heated:
        return cold
    per_stress = sliding * h / (12 * oil.conductivity(p))
    return brentq(lambda tau: tau - oil.stress(p, wall + per_stress * tau, sliding / h), 0.0, cold, xtol=1e-9, rtol=1e-13)


if __name__ == "__main__":
    for c in json.loads(GOLDEN.read_text(encoding="utf-8"))["conditions"]:
        oil = Oil(NAMES.get(c["oil"], c["oil"]))
        contact = hertz(c["F_N"], c["Rx_m"], c["Ry_m"])
        h, factor = film(oil, c, contact[2])
        mu, surface, inside = friction(oil, c, h, contact, True)
        cold, _, _ = friction(oil, c, h, contact, False)
        for kind, value, key in [
            ("half-axis", contact[0], "a_m"),
            ("half-axis", contact[1], "b_m"),
            ("pressure", contact[2], "p0_Pa"),
            ("reduction", factor, "phi_T"),
            ("film", h, "h_m"),
            ("friction", mu, "mu"),
            ("friction", cold, "mu_isothermal"),
            ("surface rise", surface, "dT_surface"),
            ("film rise", inside, "dT_film_max"),
        ]:
            # The golden temperature coefficient is a difference over 0.02 K.
            compare(kind, c["case"], value, c[key], 3e-9)
    report()
