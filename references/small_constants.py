"""Constants that follow from theory, or that printed data confirm. Needs numpy and scipy. A few seconds.

1. Foundation of a tooth: a half-plane under the linear stress of a moment M over the chord s turns, work-conjugate, by
   -(288/pi) J (1 - nu^2)/E M/s^2 with J = int int t u ln|t - u| over the chord, -1/16: 18/pi.
2. Flattening: strain under a Hertz pressure from the surface to the depth h, (1 - nu^2)/(pi E) [ln(4 h^2/a^2) - nu/(1 - nu)].
3. Micropitting: G, U, W of the rating are Dowson and Higginson's groups in mm, N, m/s, 1600 is their 1.6; sqrt(pi)/2 is the
   largest rise under a fast semi-elliptic source, within 1.5 %.
4. Least difference of the tooth numbers of a ring and its pinion whose tips stay clear of each other.
5. Pressure-viscosity of polyalphaolefins by Gold against viscosities measured under pressure. Data of PAO 4, 10, 40, 100
   (viscosity Pa s, density kg/m3, tangent 1/Pa) as printed in an open thermal program for line contacts
   (DausdasKreuz/Thermoelastohydrodynamics_time_transient). Gold's coefficient is the mean to 0.2 GPa.
"""

import numpy as np
from scipy.integrate import quad

from held import agree, held, report

POISSON = 0.3


def tooth():
    """The moment of the chord with itself, and the flattening."""
    overlap = lambda d: 2 * quad(lambda t: t * (t + d), -0.5, 0.5 - d)[0]
    moment = quad(lambda d: np.log(d) * overlap(d), 0, 1)[0]
    agree("J of the chord", moment, -1 / 16, 1e-8)
    held("crates/gear/src/tooth_compliance.rs", "foundation", -288 * moment, 1e-7)

    # Stresses under the middle of the pressure sqrt(1 - x^2), half width 1 (Johnson 1985, 4.46), plane strain.
    def strain(z):
        root = np.sqrt(1 + z * z)
        across, down = -((1 + 2 * z * z) / root - 2 * z), -1 / root
        return -(1 - POISSON**2) * (down - POISSON / (1 - POISSON) * across)

    for depth in (30.0, 100.0):
        approach = quad(strain, 0, 1)[0] + quad(lambda log: strain(np.exp(log)) * np.exp(log), 0, np.log(depth))[0]
        formula = (1 - POISSON**2) / np.pi * (np.log(4 * depth**2) - POISSON / (1 - POISSON))
        agree("flattening", approach / (np.pi / 2), formula, 2e-4)


def micropitting():
    radius, pressure, speed, viscosity, alpha, modulus = 10e-3, 1e9, 8.0, 10e-3, 16e-9, 226e9
    load = 2 * np.pi * pressure**2 * radius / modulus
    g, u, w = alpha * modulus, viscosity * speed / 2 / (modulus * radius), load / (modulus * radius)
    agree("G", 1e6 * alpha * (modulus * 1e-6), g, 1e-12)
    agree("U", viscosity * speed / (2000 * (modulus * 1e-6) * (radius * 1e3)), u, 1e-12)
    agree("W", 2 * np.pi * (pressure * 1e-6) ** 2 / (modulus * 1e-6) ** 2, w, 1e-12)
    held("crates/ehl-regime/src/micropitting.rs", "1.6 R in um per mm", 1.6e3, 0.0)
    rises = []
    for at in np.linspace(0.3, 0.8, 101):
        t = np.linspace(0, np.sqrt(at + 1), 4001)
        source = 2 * np.sqrt(np.maximum(0, 1 - (at - t * t) ** 2))
        rises.append(((source[1:] + source[:-1]) / 2 * np.diff(t)).sum())
    print(f"largest rise of a fast source: {max(rises) * 2 * np.sqrt(2) / np.pi**1.5:.4f}, of the rating {2 / np.sqrt(np.pi):.4f}")
    agree("factor of the flash", 2 / np.sqrt(np.pi), max(rises) * 2 * np.sqrt(2) / np.pi**1.5, 0.016)


def rings():
    angle = np.radians(20)
    involute = lambda at: np.tan(at) - at

    def is_clear(z1, z2):
        r1, r2 = z1 / 2, z2 / 2
        b1, b2, distance = r1 * np.cos(angle), r2 * np.cos(angle), r2 - r1
        tip1 = r1 + 1
        # The tip of the ring stays on the involute that the pinion has.
        tip2 = max(r2 - 1, np.hypot(b2, distance * np.sin(angle)))
        if tip1 + distance <= tip2:
            return True
        at1 = np.arccos((tip2**2 - distance**2 - tip1**2) / (2 * distance * tip1))
        at2 = np.arccos(np.clip((tip2**2 + distance**2 - tip1**2) / (2 * distance * tip2), -1, 1))
        to1, to2 = np.arccos(b1 / tip1), np.arccos(min(1.0, b2 / tip2))
        return z1 * (involute(to1) + at1) - z2 * (involute(to2) + at2) + (z2 - z1) * involute(angle) > 0

    least = []
    for teeth in (15, 20, 25, 30, 40, 60, 80):
        least.append(next(d for d in range(2, 40) if all(is_clear(teeth, teeth + k) for k in range(d, 40))))
    print("least differences of a ring:", least)
    agree("least difference that is safe", max(least) + 1, 10, 0.0)
    held("crates/gear/src/pair.rs", "least difference of a ring", max(least) + 1, 0.0)


def gold():
    factor, power = 7.382, 0.1335
    for constant in (factor, power):
        held("crates/oil/src/base_oil.rs", "Gold, polyalphaolefin", constant, 0.0)
    ratios = []
    for viscosity, density, tangent in ((13.62e-3, 815.8, 14.8e-9), (52.52e-3, 835.0, 17.1e-9), (345.8e-3, 843.4, 23.89e-9), (1068e-3, 854.2, 23.06e-9)):
        # Roelands' law with the measured tangent, its mean from 0 to 0.2 GPa.
        g = np.log(viscosity) + 9.67
        mean = g * ((1 + 5.1e-9 * 0.2e9) ** (tangent / (5.1e-9 * g)) - 1) / 0.2
        ratios.append(factor * (viscosity / density * 1e6) ** power / mean)
    print("Gold over measured:", " ".join(f"{ratio:.2f}" for ratio in ratios))
    agree("Gold's coefficient, mean of four oils", np.mean(ratios), 1.0, 0.15)


def main():
    tooth()
    micropitting()
    rings()
    gold()
    report()


if __name__ == "__main__":
    main()
