"""Shakedown limit of repeated sliding line contact. Needs nothing. A few seconds.

A contact that passes over a half-plane again and again leaves residual stresses that depend on the depth alone: along and
across the motion, but no shear in the planes of the surface. They can cancel every difference of normal stresses (Melan), so the
passes stay elastic while the shear stress in these planes, anywhere below the contact, does not exceed the yield stress k in
shear (Johnson 1985, section 9.2; Johnson 1990 as a drawing). Under a Hertz pressure p0 with the traction mu p:

    p_s/k = p0/max |tau_xz|.

Stresses are integrals of point forces over the contact (Flamant), not the closed form of the program. 4 without friction;
1/mu above mu = 0.37, where the surface flows.
"""

from math import cos, pi, sin, sqrt

from held import agree, held, report

NODES = 400
#: Angles and weights of integrals of sqrt(1 - s^2) f(s) over the contact, Gauss-Chebyshev of the second kind.
RULE = [
    (cos(pi * i / (NODES + 1)), pi / (NODES + 1) * sin(pi * i / (NODES + 1)) ** 2) for i in range(1, NODES + 1)
]


def shear(friction, x, z):
    """tau_xz over p0 at (x, z) in half widths."""
    total = 0.0
    for s, weight in RULE:
        d = x - s
        common = d * z / (d * d + z * z) ** 2
        total -= weight * 2 / pi * (common * z + friction * common * d)
    return total


def largest(friction):
    """Largest |tau_xz| over p0 below the surface: a grid, then smaller ones about its best point."""
    best, at, reach = 0.0, (0.0, 0.6), (1.5, 0.5)
    for level in range(7):
        parts = 24 if level == 0 else 8
        (x0, z0), (dx, dz) = at, reach
        for i in range(parts + 1):
            for j in range(parts + 1):
                x = x0 + dx * (2 * i / parts - 1)
                z = max(z0 + dz * (2 * j / parts - 1), 0.05)
                value = abs(shear(friction, x, z))
                if value > best:
                    best, at = value, (x, z)
        reach = (2.5 * dx / parts, 2.5 * dz / parts)
    return best, at


def main():
    value, (x, z) = largest(0.0)
    agree("frictionless", value, 0.25, 1e-6)
    agree("its place", abs(x), sqrt(0.75), 1e-2)
    agree("its depth", z, 0.5, 1e-2)
    for friction in (0.0, 0.05, 0.09, 0.2, 0.3):
        value, _ = largest(friction)
        held("crates/contact/src/shakedown.rs", f"limit at friction {friction}", 1 / value, 2e-5)
    # Where the surface flows first.
    low, high = 0.3, 0.45
    while high - low > 1e-4:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if middle > largest(middle)[0] else (middle, high)
    held("crates/contact/src/shakedown.rs", "friction at which the surface flows", low, 2e-3)
    # Yield stress in shear of a metal of hardness H = 3 Y by von Mises.
    held("crates/contact/src/shakedown.rs", "yield in shear over hardness", 1 / (3 * sqrt(3)), 1e-6)
    report()


main()
