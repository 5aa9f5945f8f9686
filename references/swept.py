"""Powers of deformation swept over the flanks of three gears. Needs numpy. Runs in a second.

The front half of a Hertz pressure works on the surface that comes in: per metre of face and metre rolled
    W = int_0^a p(x) x/R dx = 2 f a/(3 pi R)   (Johnson 1985, section 9.1)   [Swept-Elastic],
here by quadrature of the pressure, not by the closed form. Over the lines of contact P_el = sum W V_e l; hysteresis is 1 %
of it. The first pass of plastic work D [J per metre of face] of a window 2 a long is P_pl = sum D/(2 a) V_e l and D/(2 a)
per area of flank. Places (l, f, R, a, V_e, D) are inputs of the golden file, its powers are computed anew.
"""

import json

import numpy as np

from held import ROOT, compare, report

GOLDEN = ROOT / "crates/efficiency/tests/golden/swept.json"
# The places are typed with nine digits; so the tests.
TOLERANCE = 1e-7


def front_half(load, radius, half_width):
    """Work on the approaching surface per metre rolled; x = a sin t takes the root out of the pressure."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    t, weights = (nodes + 1) * np.pi / 4, weights * np.pi / 4
    pressure = 2 * load / (np.pi * half_width) * np.cos(t)
    x = half_width * np.sin(t)
    return weights @ (pressure * x / radius * half_width * np.cos(t))


def main():
    for name, case in json.loads(GOLDEN.read_text(encoding="utf-8"))["cases"].items():
        elastic = plastic = densest = 0.0
        for length, load, radius, half_width, speed, work in case["places"]:
            elastic += front_half(load, radius, half_width) * speed * length
            plastic += work / (2 * half_width) * speed * length
            densest = max(densest, work / (2 * half_width))
        print(f"{name}: {elastic:.6f} W cycled, {plastic:.6f} W plastic in the first pass, {densest:.6f} J/m2 at most")
        compare("cycled power", name, elastic, case["elastic_cycled_w"], TOLERANCE)
        compare("plastic power", name, plastic, case["plastic_first_pass_w"], TOLERANCE)
        compare("plastic work per area", name, densest, case["max_area_density_j_per_m2"], TOLERANCE)
    report()


if __name__ == "__main__":
    main()
