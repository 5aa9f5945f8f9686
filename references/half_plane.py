"""Half planes under strips, waves and Hertz pressures, with 50 digits. Needs mpmath."""

import mpmath as mp

from held import agree, held, report

mp.mp.dps = 50
KERNEL = "crates/contact/src/strip_kernel.rs"
STRIP = "crates/contact/src/subsurface/strip.rs"
AXIS = "crates/contact/src/subsurface/axis.rs"
HERTZ_STRESS = "crates/contact/src/subsurface/hertz_stress.rs"
HERTZ_LINE = "crates/contact/src/hertz_line.rs"


def kernels():
    """Displacement by a strip of half width 1 at r: (r - 1) ln (r - 1)^2 - (r + 1) ln (r + 1)^2, from r = 0."""
    term = lambda u: mp.mpf(0) if u == 0 else u * mp.log(u * u)
    for r in ("0.5", "1", "2", "4", "63", "64", "130", "2e4", "2e6"):
        r = mp.mpf(r)
        held(KERNEL, f"strip at {r}", term(r - 1) - term(r + 1), 5e-16)
    for n, ks in ((16, (0, 1, 2, 5, 8)), (1024, (0, 1, 8, 512))):
        for k in ks:
            cell = mp.pi / n
            value = 2 * n / mp.pi * (mp.clsin(2, cell * (2 * k + 1)) - mp.clsin(2, cell * (2 * k - 1)))
            held(KERNEL, f"periodic {n}, {k}", value, 5e-16)


def strip_stress():
    """Stress below a unit strip, Flamant's solution integrated over |s| <= 1, for pressure and for traction."""
    for x, z in ((0.0, 0.5), (1.3, 0.2), (-2.0, 3.0)):
        def flamant(s, along, down):
            u, r2 = x - s, (x - s) ** 2 + z * z
            return u ** along * z ** down / r2 ** 2
        integral = lambda along, down: mp.quad(lambda s: flamant(s, along, down), [-1, min(max(x, -1), 1), 1])
        two = mp.mpf(2) / mp.pi
        # Pressure pushes into the body, tension is positive.
        normal = [-two * integral(2, 1), -two * integral(0, 3), -two * integral(1, 2)]
        for name, value in zip(("xx", "zz", "xz"), normal):
            if abs(value) > 1e-30:
                held(STRIP, f"pressure, sigma {name} at {x}, {z}", value, 1e-13)
        value = -two * integral(3, 0)
        if abs(value) > 1e-30:
            held(STRIP, f"traction, sigma xx at {x}, {z}", value, 1e-13)


def axis_stress(z):
    """Stress on the axis of a Hertz contact, over p0, half width 1."""
    root = mp.sqrt(1 + z * z)
    return -((1 + 2 * z * z) / root - 2 * z), -1 / root


def hertz_maxima():
    shear = lambda z: (lambda s: abs(s[0] - s[1]) / 2)(axis_stress(z))
    depth = mp.sqrt((mp.sqrt(5) - 1) / 2)
    held(AXIS, "largest shear", shear(depth), 2e-12)
    held(AXIS, "shear at z = a over root two", shear(mp.mpf(1)) / mp.sqrt(2), 1e-15)
    agree("slope of the shear at its maximum", float(mp.diff(shear, depth)) + 1, 1.0, 1e-12)
    for nu, tolerance in (("0.25", 2e-6), ("0.28", 2e-6), ("0.30", 2e-9), ("0.33", 2e-6)):
        nu = mp.mpf(nu)

        def mises(z):
            sx, sz = axis_stress(z)
            sy = nu * (sx + sz)
            return mp.sqrt(((sx - sz) ** 2 + (sz - sy) ** 2 + (sy - sx) ** 2) / 2)

        depth = mp.findroot(lambda z: mp.diff(mises, z), mp.mpf("0.7"))
        held(HERTZ_STRESS, f"depth of the largest von Mises stress, nu {nu}", depth, tolerance)
        held(HERTZ_STRESS, f"largest von Mises stress, nu {nu}", mises(depth), tolerance)


def hertz_lines():
    for w, r, e in (("113408.97060502256", "11.626875546138667e-3", "115.38461538461537e9"),
                    ("3e5", "3e-3", "115384615385")):
        w, r, e = mp.mpf(w), mp.mpf(r), mp.mpf(e)
        half = mp.sqrt(4 * w * r / (mp.pi * e))
        p0 = 2 * w / (mp.pi * half)
        held(HERTZ_LINE, "half width", half, 1e-11)
        held(HERTZ_LINE, "pressure", p0, 1e-11)
        if w > 2e5:
            approach = w / (mp.pi * e) * (2 * mp.log(2 * mp.mpf("1.2e-3") / half) + 1)
            held(HERTZ_LINE, "approach", approach, 1e-11)


def main():
    kernels()
    strip_stress()
    hertz_maxima()
    hertz_lines()
    report()


if __name__ == "__main__":
    main()
