"""Friction of a smooth film in a line contact, with the heat of film and surfaces. Needs numpy and scipy.

Barus viscosity, Eyring stress, limiting stress, film heated by itself, surfaces by a fast semi-elliptic source.
"""

import json

import numpy as np
from scipy.optimize import brentq

from held import ROOT, agree, report

GOLDEN = ROOT / "crates/tribo-friction/tests/golden/film_friction.json"
FAMILIES = json.loads((ROOT / "crates/oil/data/oil_families.json").read_text(encoding="utf-8"))["families"]
# Kinematic viscosity at 40 and 100 deg C [mm2/s], density at 15 deg C [kg/m3], family.
OILS = {
    "e-fluid-70w75w": (30.8, 5.9, 845.0, "pao"),
    "M100": (96.0, 10.6, 882.0, "mineral"),
    "PAO100": (94.1, 14.0, 840.0, "pao"),
}
# Factor and exponent of Gold's pressure-viscosity coefficient.
GOLD = {"mineral": (9.904, 0.1390), "pao": (7.382, 0.1335)}
# Constants of the conditions that the golden file holds, where the defaults have changed since.
HELD = {
    "mineral": {"eyring_stress": 5e6, "conductivity": 0.137, "conductivity_rise": 1.72, "conductivity_bend": 0.54},
    "pao": {"eyring_stress": 4e6},
}
E_STAR = 210e9 / (2 * 0.91)
STEEL = dict(k=45.0, rho=7830.0, c=465.0)
TAU_L0 = 2e6


class Oil:
    def __init__(self, name):
        nu40, nu100, self.rho, family = OILS[name]
        w = [np.log10(np.log10(nu + 0.7)) for nu in (nu40, nu100)]
        t = [np.log10(313.15), np.log10(373.15)]
        self.b = (w[0] - w[1]) / (t[1] - t[0])
        self.a = w[0] + self.b * t[0]
        row = next(row for row in FAMILIES if row["name"] == family)
        self.gold = GOLD[family]
        self.of = {key: value["value"] for key, value in row.items() if isinstance(value, dict)}
        self.of |= HELD[family]

    def nu(self, t):
        return 10 ** 10 ** (self.a - self.b * np.log10(t)) - 0.7

    def eta(self, t):
        return 1e-6 * self.nu(t) * (self.rho - 0.63 * (t - 288.15))

    def alpha(self, t):
        """Gold's value at 80 deg C, elsewhere by the same power of the dynamic viscosity."""
        at, (factor, power) = 353.15, self.gold
        return 1e-9 * factor * self.nu(at) ** power * (self.eta(t) / self.eta(at)) ** power

    def stress(self, p, t, rate):
        viscosity = self.eta(t) * np.exp(min(self.alpha(t) * p, 40.0))
        eyring = self.of["eyring_stress"]
        free = eyring * np.arcsinh(viscosity * rate / eyring)
        limit = TAU_L0 + self.of["limiting_shear"] * p
        return free * (1 + (free / limit) ** 4) ** -0.25

    def conductivity(self, p):
        gpa = p * 1e-9
        return self.of["conductivity"] * (1 + self.of["conductivity_rise"] * gpa / (1 + self.of["conductivity_bend"] * gpa))


def source_constant():
    """Mean rise under a fast semi-elliptic source, weighted with the pressure, as the factor C in
    C mu w |V_s| / ((B1 sqrt u1 + B2 sqrt u2) sqrt(2 a))."""
    n, m = 600, 400
    x, wx = np.polynomial.legendre.leggauss(n)
    s, ws = np.polynomial.legendre.leggauss(m)
    total = 0.0
    # x = sin of an angle takes the root of the pressure out; x' = x - t^2 that of the source.
    for angle, weight in zip(x * np.pi / 2, wx * np.pi / 2):
        at = np.sin(angle)
        top = np.sqrt(1 + at)
        # t = top sin phi takes the root at the leading edge out.
        phi = (s + 1) * np.pi / 4
        t = top * np.sin(phi)
        inner = 2 * np.sqrt(np.maximum(1 - (at - t * t) ** 2, 0)) * top * np.cos(phi)
        total += weight * np.cos(angle) ** 2 * float((ws * np.pi / 4) @ inner)
    # q = (2 mu w V / (pi a)) sqrt(1 - x^2), rise = integral q / sqrt(pi a (x - x')) dx' a / (B sqrt u).
    return total * 2 / np.pi * (2 / np.pi) * np.sqrt(2 / np.pi)


def friction(case, constant, heated=True, nodes=96):
    oil, bulk = Oil(case["oil"]), case["T_C"] + 273.15
    w, radius, speed = case["w_N_per_m"], case["R_m"], case["Ve"]
    sliding = case["SRR"] * speed
    a = np.sqrt(4 * w * radius / (np.pi * E_STAR))
    p0 = 2 * w / (np.pi * a)
    h = case["h_m"]
    u = [speed * (1 + sign * case["SRR"] / 2) for sign in (1, -1)]
    b = np.sqrt(STEEL["k"] * STEEL["rho"] * STEEL["c"])
    diffusivity = STEEL["k"] / (STEEL["rho"] * STEEL["c"])
    slow = [max(v, 2 * diffusivity / a) for v in u]
    rise_per_mu = constant * w * abs(sliding) / (b * (np.sqrt(slow[0]) + np.sqrt(slow[1])) * np.sqrt(2 * a))
    x, weights = np.polynomial.legendre.leggauss(nodes)
    angles, weights = (x + 1) * np.pi / 4, weights * np.pi / 4
    rate = abs(sliding) / h
    hottest = 0.0

    def of_surface(surface):
        nonlocal hottest
        hottest, total = 0.0, 0.0
        for angle, weight in zip(angles, weights):
            p = p0 * np.cos(angle)
            if heated:
                per = abs(sliding) * h / (12 * oil.conductivity(p))
                # Heat only thins: the cold stress is the most.
                most = 1.0 + 1.001 * oil.stress(p, surface, rate)
                of_stress = lambda tau: tau - oil.stress(p, surface + per * tau, rate)
                tau = brentq(of_stress, 0.0, most, xtol=1e-6, rtol=1e-14)
                hottest = max(hottest, per * tau)
            else:
                tau = oil.stress(p, surface, rate)
            total += weight * tau * np.cos(angle)
        return 2 * a / w * total

    if not heated:
        return of_surface(bulk), 0.0, 0.0
    mu = brentq(lambda mu: mu - of_surface(bulk + rise_per_mu * mu), 1e-9, 0.2, xtol=1e-15, rtol=1e-12)
    mu = of_surface(bulk + rise_per_mu * mu)
    return mu, rise_per_mu * mu, hottest


def main():
    constant = source_constant()
    print(f"mean of the rise over the contact, weighted with the pressure: {constant:.12f}")
    for case in json.loads(GOLDEN.read_text(encoding="utf-8"))["conditions"]:
        oil, bulk = Oil(case["oil"]), case["T_C"] + 273.15
        agree(f"{case['case']}: viscosity", oil.eta(bulk), case["eta0"], 1e-9)
        agree(f"{case['case']}: pressure coefficient", oil.alpha(bulk), case["alpha"], 1e-9)
        mu, surface, film = friction(case, constant)
        agree(f"{case['case']}: friction", mu, case["mu_n96"], 1e-8)
        agree(f"{case['case']}: surface", surface, case["dT_surface"], 1e-6)
        cold, _, _ = friction(case, constant, heated=False, nodes=32)
        agree(f"{case['case']}: isothermal", cold, case["mu_isothermal"], 1e-8)
    report()


if __name__ == "__main__":
    main()
