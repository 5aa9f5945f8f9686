"""Load over the elastic teeth of gear pairs. Needs numpy and scipy. Runs in about a minute.

Loss factors, transmission errors, tooth compliances and shares of `crates/gear/tests/golden/load_map.json`, from
- compliance of a tooth by Weber and Banaschek (1953): bending, shear and compression of the outline (involute and the
  trochoid of a rounded rack), the foundation, and Hertz' flattening;
- coupling along the face: u = sqrt(q) w, w - lambda^2 w'' = sqrt(q) f, free ends;
- one approach delta of all lines of contact, f >= 0, sum of the loads = F_bn.
The project solves the coupling with tridiagonal finite differences on cells of the face. Here w is the integral of f with
the closed Green function of that equation, over cells of each line of contact itself, and the systems are dense.
Edge contact, width errors and iso-stiffness, which tests hold too, are not in this script.
"""

import json

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from held import ROOT, compare, report

GOLDEN = ROOT / "crates/gear/tests/golden/load_map.json"
E, NU, C_M, COUPLING = 206e9, 0.3, 0.8, 1.55
RACK = dict(addendum=1.0, dedendum=1.25, fillet=0.38)
PRESSURE_ANGLE = np.radians(20.0)
GAUSS = np.polynomial.legendre.leggauss(40)
PLAIN = (0.0, 1.0, 1)


def inv(angle):
    return np.tan(angle) - angle


class Tooth:
    """A tooth of the virtual spur gear (z_n of the normal section), with its two compliances."""

    def __init__(self, module, teeth, shift, ring):
        self.module, self.teeth, self.shift, self.ring = module, abs(teeth), shift, ring
        self.pitch = module * self.teeth / 2
        self.base = self.pitch * np.cos(PRESSURE_ANGLE)
        if not ring:
            self._outline()

    def half_angle(self, radius):
        """Half the angle of the involute tooth at a radius; that of a ring is what the space leaves."""
        across = np.arccos(np.minimum(self.base / radius, 1.0))
        sign = -1 if self.ring else 1
        space = (np.pi / 2 + sign * 2 * self.shift * np.tan(PRESSURE_ANGLE)) / self.teeth + inv(PRESSURE_ANGLE) - inv(across)
        return np.pi / self.teeth - space if self.ring else space

    def _outline(self):
        """Height and half thickness along the trochoid: the normal of the rack's rounding goes through the pitch point."""
        m, a = self.module, PRESSURE_ANGLE
        rho = RACK["fillet"] * m
        depth = (RACK["dedendum"] - self.shift) * m - rho
        centre = np.pi * m / 4 - RACK["dedendum"] * m * np.tan(a) - (1 - np.sin(a)) * rho / np.cos(a)
        t = np.linspace(0, 1 / np.tan(a), 4001)
        root = np.sqrt(1 + t * t)
        x, y = depth * t + rho * t / root, self.pitch - depth - rho / root
        radius = np.hypot(x, y)
        angle = np.pi / self.teeth - (np.arctan2(x, y) - (depth * t - centre) / self.pitch)
        self.t_end, self.r_end = t[-1], radius[-1]
        self.fillet = [CubicSpline(t, radius * np.cos(angle)), CubicSpline(t, radius * np.sin(angle))]
        self.foot = float(self.fillet[0](0.0))
        self.chord = 2 * float(self.fillet[1](0.0))

    def _pieces(self, top, contact):
        """Heights, thicknesses and weights of a quadrature from the root chord to the height `top`."""
        if top <= self.foot:
            return
        nodes, weights = GAUSS
        height, half = self.fillet
        end = self.t_end if top >= height(self.t_end) else brentq(lambda t: height(t) - top, 0, self.t_end)
        t = (nodes + 1) / 2 * end
        yield height(t), 2 * half(t), weights / 2 * end * height(t, 1)
        if top > height(self.t_end):
            at = lambda r: r * np.cos(self.half_angle(r))
            last = brentq(lambda r: at(r) - top, self.r_end * (1 - 1e-9), contact)
            r = self.r_end + (nodes + 1) / 2 * (last - self.r_end)
            g = self.half_angle(r)
            # d(angle)/dr of an involute is -sqrt(r^2 - r_b^2)/(r r_b).
            slope = np.cos(g) + np.sin(g) * np.sqrt(np.maximum(r * r - self.base**2, 0)) / self.base
            yield at(r), 2 * r * np.sin(g), weights / 2 * (last - self.r_end) * slope

    def _pieces_of_ring(self, load_height):
        """The same, from the root circle inwards; involute flanks all the way."""
        m = self.module
        root = self.pitch + m * (RACK["dedendum"] - self.shift)
        at = lambda r: r * np.cos(self.half_angle(r))
        self.foot, self.chord = at(root), 2 * root * np.sin(self.half_angle(root))
        if load_height >= self.foot:
            return
        nodes, weights = GAUSS
        r_load = brentq(lambda r: at(r) - load_height, self.base, root)
        r = r_load + (nodes + 1) / 2 * (root - r_load)
        g = self.half_angle(r)
        slope = np.cos(g) - np.sin(g) * np.sqrt(r * r - self.base**2) / self.base
        yield at(r), 2 * r * np.sin(g), weights / 2 * (root - r_load) * slope

    def compliance(self, rho):
        """q of bending and of the foundation [m2/N], and the distance of the contact from the centre line, where the
        involute has the radius of curvature `rho`."""
        radius, across = np.hypot(self.base, rho), np.arctan2(rho, self.base)
        g = self.half_angle(radius)
        load_angle = across + g if self.ring else across - g
        top = self.base / np.cos(load_angle)
        pieces = list(self._pieces_of_ring(top) if self.ring else self._pieces(top, radius))
        arm = (self.foot - top) if self.ring else (top - self.foot)
        plane, tangent = (1 - NU**2) / E, np.tan(load_angle) ** 2
        bent = sum(float(w @ ((top - y) ** 2 / s**3)) for y, s, w in pieces)
        sheared = sum(float(w @ (1 / s)) for y, s, w in pieces)
        cos2 = np.cos(load_angle) ** 2
        of_tooth = cos2 * (12 * plane * bent + (2.4 * (1 + NU) / E + tangent * plane) * sheared)
        part = arm / self.chord
        of_foundation = cos2 * plane * (
            18 / np.pi * part**2 + 2 * (1 - 2 * NU) / (1 - NU) * part + 4.8 / np.pi * (1 + (1 - NU) / 2.4 * tangent)
        )
        return of_tooth, of_foundation, radius * np.sin(g) / np.cos(load_angle)


class Pair:
    def __init__(self, row, helix=None):
        self.ring = row.get("internal", False)
        z1, z2 = row["teeth"]
        z2 = -z2 if self.ring else z2
        x = row.get("shift") or [0.0, 0.0]
        self.module, self.width = row.get("module", 1.5e-3), row.get("width", 20e-3)
        self.torque = row.get("torque", 40.0)
        self.helix = helix = np.radians(row["helix"] if helix is None else helix)
        m_t = self.module / np.cos(helix)
        a_t = np.arctan(np.tan(PRESSURE_ANGLE) / np.cos(helix))
        inv_wt = inv(a_t) + 2 * (x[0] + x[1]) * np.tan(PRESSURE_ANGLE) / (z1 + z2)
        a_wt = brentq(lambda a: inv(a) - inv_wt, 1e-3, 1.2, xtol=1e-15)
        self.base = [m_t * z / 2 * np.cos(a_t) for z in (z1, z2)]
        tips = row.get("tip_radius") or [m_t * z / 2 + self.module * (RACK["addendum"] + s) for z, s in zip((z1, z2), x)]
        sign = -1 if self.ring else 1
        self.t1t2 = sum(self.base) * np.tan(a_wt)
        reach = [np.sqrt(tip**2 - base**2) for tip, base in zip(tips, self.base)]
        self.a, self.c, self.e = self.t1t2 - sign * reach[1], self.base[0] * np.tan(a_wt), reach[0]
        self.pitch = 2 * np.pi * self.base[0] / z1
        self.eps_alpha = (self.e - self.a) / self.pitch
        self.eps_beta = self.width * np.sin(helix) / (np.pi * self.module)
        self.b_b = np.arcsin(np.sin(helix) * np.cos(PRESSURE_ANGLE))
        self.force = self.torque / (self.base[0] * np.cos(self.b_b))
        self.gear_ratio = 1 + z1 / z2
        section = np.cos(self.b_b) ** 2 * np.cos(helix)
        self.virtual = [z / section for z in (z1, z2)]
        self.shift = x
        self.teeth = [Tooth(self.module, z / section, s, r) for z, s, r in zip((z1, z2), x, (False, self.ring))]
        xi = self.eps_alpha * (1 - np.cos(np.linspace(0, np.pi, 161))) / 2
        parts = np.array([self.of(at) for at in xi])
        self.q_b = CubicSpline(xi, (parts[:, 0] + parts[:, 1]) / C_M) if parts[:, 2].min() > 0 else (
            lambda at, s=parts[:, 0] + parts[:, 1], xi=xi: np.interp(at, xi, s) / C_M)
        self.log_h = CubicSpline(xi, parts[:, 3])

    def of(self, xi):
        """q of both teeth, the smaller bending part and the logarithms of the distances of Hertz' approach."""
        s = self.a + xi * self.pitch
        rho = [s / np.cos(self.b_b), abs(self.t1t2 - s) / np.cos(self.b_b)]
        first, second = (tooth.compliance(r) for tooth, r in zip(self.teeth, rho))
        return sum(first[:2]), sum(second[:2]), min(first[0], second[0]), np.log(first[2]) + np.log(abs(second[2]))

    def radius(self, xi):
        s = self.a + xi * self.pitch
        return s * (self.t1t2 - s) / self.t1t2 / np.cos(self.b_b)

    HERTZ = (1 - NU**2) / (np.pi * E)

    def flattening(self, xi, load):
        """q_H of both bodies without the factor C_M."""
        modulus = E / (2 * (1 - NU**2))
        a2 = 4 * load * self.radius(xi) / (np.pi * modulus)
        return 2 * self.HERTZ * (np.log(4) - np.log(a2) - NU / (1 - NU)) + 2 * self.HERTZ * self.log_h(xi)

    def lines(self, phase, per_face):
        """Cells (xi, y, width along y) of each line of contact at a phase."""
        found = []
        spur = self.eps_beta < 1e-9
        first = -int(np.ceil(self.eps_beta)) - 1
        for j in range(first, int(np.ceil(self.eps_alpha)) + 1):
            at = phase + j
            if spur:
                if 0 <= at <= self.eps_alpha:
                    found.append((np.array([at]), np.array([self.width / 2]), self.width))
                continue
            low, high = (np.clip((end - at) / self.eps_beta, 0, 1) for end in (0.0, self.eps_alpha))
            if high - low > 1e-12:
                # A line that runs over a part of the face has that many over its own length, times 1/2.
                n = max(6, int(np.ceil(per_face * (high - low) * max(1.0, self.eps_beta / 2))))
                share = low + (np.arange(n) + 0.5) / n * (high - low)
                found.append((at + self.eps_beta * share, share * self.width, (high - low) / n * self.width))
        return found

    def coupling(self, y, cell):
        """Integral of the Green function of w - lambda^2 w'' = g, w' = 0 at both ends, over the cell of each y."""
        scale = COUPLING * self.module
        # Sources and their mirror images in both ends; further images are below 1e-9 on these faces.
        far = lambda d: np.sign(d) * -np.expm1(-np.abs(d) / scale) / 2
        total = np.zeros((len(y), len(y)))
        for image in range(-3, 4):
            for centre in (y + 2 * image * self.width, -y + 2 * image * self.width):
                d = y[:, None] - centre[None, :]
                total += far(d + cell / 2) - far(d - cell / 2)
        return total

    def relief(self, xi, amount):
        c, length, power = amount
        if c == 0:
            return np.zeros_like(xi)
        part = length / self.pitch
        one = np.maximum(xi - (self.eps_alpha - part), 0) / part
        two = np.maximum(part - xi, 0) / part
        return c * (one**power + two**power)

    def elastic(self, phase, amount, per_face, coupled=True):
        """Loads of the lines at a phase and the common approach."""
        lines = self.lines(phase, per_face)
        mean = self.force * np.cos(self.b_b) / (self.width * self.eps_alpha)
        known = []
        for xi, y, cell in lines:
            root = np.sqrt(self.q_b(xi))
            flexible = (root[:, None] * self.coupling(y, cell) * root[None, :]
                        if coupled and len(y) > 1 else np.diag(root**2))
            known.append([flexible, self.relief(xi, amount), np.full(len(xi), mean), np.ones(len(xi), bool)])
        slope = 2 * self.HERTZ / C_M
        for _ in range(100):
            carried = given = 0.0
            solved = []
            for (xi, _, cell), (flexible, gap, load, active) in zip(lines, known):
                held = np.maximum(load, 1e-4 * mean)
                g = self.flattening(xi, held) / C_M - slope
                i = np.flatnonzero(active)
                system = flexible[np.ix_(i, i)] + np.diag(g[i])
                # f q_H is linear about the last load: g f + slope f_last.
                both = np.linalg.solve(system, np.column_stack([np.ones(len(i)), gap[i] + slope * held[i]]))
                dl = cell / np.cos(self.b_b)
                given, carried = given + both[:, 0].sum() * dl, carried + both[:, 1].sum() * dl
                solved.append((i, both))
            delta = (self.force + carried) / given
            change, moved = 0.0, False
            for line, (i, both) in zip(known, solved):
                flexible, gap, load, active = line
                fresh = np.zeros(len(load))
                fresh[i] = delta * both[:, 0] - both[:, 1]
                now = np.where(active, fresh > 0, delta - gap - flexible @ fresh > 0)
                moved |= bool((now != active).any())
                change = max(change, np.abs(np.maximum(fresh, 0) - load).max())
                line[2], line[3] = np.maximum(fresh, 0), now
            if not moved and change < 1e-10 * mean:
                break
        else:
            raise SystemExit(f"no solution at phase {phase}")
        return [(xi, load, cell) for (xi, _, cell), (_, _, load, _) in zip(lines, known)], delta

    def rigid(self, phase, law, per_face):
        lines = self.lines(phase, per_face)
        b0 = 1 / np.sqrt(0.5 * (1 + self.eps_alpha / 2) ** 2 - 1)
        v = lambda xi: np.cos(b0 * (xi - self.eps_alpha / 2)) if law == "min_potential" else np.ones_like(xi)
        total = sum(v(xi).sum() * cell / np.cos(self.b_b) for xi, _, cell in lines)
        return [(xi, self.force * v(xi) / total, cell) for xi, _, cell in lines]

    def phases(self, amount, pieces=14):
        """Gauss phases between those at which a line begins, ends, or passes C or a start of relief."""
        part = amount[1] / self.pitch
        knots = [0.0, self.eps_alpha, (self.c - self.a) / self.pitch]
        knots += [part, self.eps_alpha - part] if amount[0] else []
        breaks = sorted({round((k - shift) % 1.0, 14) for k in knots for shift in (0, self.eps_beta)} | {0.0, 1.0})
        nodes, weights = np.polynomial.legendre.leggauss(2)
        for low, high in zip(breaks, breaks[1:]):
            n = int(np.ceil((high - low) * pieces))
            for k in range(n):
                for node, weight in zip(nodes, weights):
                    yield low + (high - low) * (k + (node + 1) / 2) / n, weight / 2 * (high - low) / n

    def loss_factor(self, law, amount=PLAIN, per_face=96):
        total = 0.0
        for phase, weight in self.phases(amount):
            loads = (self.elastic(phase, amount, per_face, law == "elastic")[0]
                     if law in ("elastic", "slices") else self.rigid(phase, law, 2 * per_face))
            for xi, load, cell in loads:
                sliding = self.gear_ratio * np.abs(self.a + xi * self.pitch - self.c)
                total += weight * float(load @ sliding) * cell / np.cos(self.b_b)
        return total / self.torque

    def transmission_error(self):
        found = np.array([self.elastic((n + 0.5) / 64, PLAIN, 96)[1] for n in range(64)]) / np.cos(self.b_b)
        stiffness = np.mean(self.force * np.cos(self.b_b) / (self.width * found))
        return found.mean(), np.ptp(found), stiffness

    def single_stiffness(self):
        """c'_th of ISO 6336-1; a ring counts as a rack without shift."""
        z = [1 / self.virtual[0], 0.0 if self.ring else 1 / self.virtual[1]]
        x = [self.shift[0], 0.0 if self.ring else self.shift[1]]
        q = (0.04723 + 0.15551 * z[0] + 0.25791 * z[1] - 0.00635 * x[0] - 0.11654 * x[0] * z[0] - 0.00193 * x[1]
             - 0.24188 * x[1] * z[1] + 0.00529 * x[0] ** 2 + 0.00182 * x[1] ** 2)
        return 1e9 / q


def geometry(name, row, pair):
    found = dict(eps_alpha=pair.eps_alpha, eps_beta=pair.eps_beta, force=pair.force, c_th=pair.single_stiffness())
    for key, value in found.items():
        if row.get(key) is not None:
            compare("geometry", f"{name} {key}", value, row[key], 1e-8, 1e-15)
    for value, expected in zip((pair.a, pair.c, pair.e), row["a_c_e"]):
        compare("geometry", f"{name} path", value, expected, 1e-8)


def compliances(name, row, pair):
    for k, xi in enumerate(row["xi"]):
        s = pair.a + xi * pair.pitch
        for gear, rho in enumerate((s, pair.t1t2 - s)):
            bending, foundation, _ = pair.teeth[gear].compliance(rho / np.cos(pair.b_b))
            expected = row["bending_foundation"][gear][k]
            compare("bending", f"{name} {gear} {xi}", bending, expected[0], 1e-4, 1e-16)
            compare("foundation", f"{name} {gear} {xi}", foundation, expected[1], 1e-4)
        compare("flattening", f"{name} {xi}", float(pair.flattening(xi, 2e5)), row["hertz_200"][k], 1e-4)


def laws(name, row, pair):
    compare("uniform", name, pair.loss_factor("uniform"), row["uniform"], 2e-4)
    if row["min_potential"] is not None:
        compare("min-potential", name, pair.loss_factor("min_potential"), row["min_potential"], 2e-4)
    compare("slices", name, pair.loss_factor("slices"), row["slices"], 2e-4)
    compare("elastic", name, pair.loss_factor("elastic"), row["elastic"], 1e-3)


def main():
    golden = json.loads(GOLDEN.read_text(encoding="utf-8"))
    rows = {row["name"]: row for row in golden["cases"]}
    pairs = {name: Pair(row) for name, row in rows.items()}
    for name, row in rows.items():
        pair = pairs[name]
        geometry(name, row, pair)
        compliances(name, row, pair)
        laws(name, row, pair)
        mean, peaks, stiffness = pair.transmission_error()
        compare("mean transmission error", name, mean, row["te_mean"], 1e-2)
        compare("peak to peak", name, peaks, row["te_peak_to_peak"], 5e-2, 0.05e-6)
        compare("mesh stiffness", name, stiffness, row["c_gamma"], 1e-2)
        for xi, share in row["share"]:
            at = min(max(xi, 1e-9), pair.eps_alpha - 1e-9)
            loads, _ = pair.elastic(at % 1.0, PLAIN, 1)
            load = next(f[0] for x, f, _ in loads if abs(x[0] - at) < 1e-6)
            compare("share", f"{name} {xi}", load * pair.width / pair.force, share, 2e-4)
    for name, amount, length, power, expected, _ in golden["relief"]:
        found = pairs[name].loss_factor("elastic", (amount, length, power))
        compare("relieved", f"{name} {amount} {length} {power}", found, expected, 1e-3)
    for name, factor, expected in golden["load"]:
        pair = Pair({**rows[name], "torque": factor * rows[name]["torque"]})
        whole = (pair.eps_alpha - 1) * pair.pitch
        compare("loaded", f"{name} {factor}", pair.loss_factor("elastic", (1e-5, whole, 1)), expected, 2e-3)
    for helix, uniform, least, slices, elastic in golden["helix"]:
        row = {**rows["e-drive"], "uniform": uniform, "min_potential": least, "slices": slices, "elastic": elastic}
        laws(f"e-drive at {helix} deg", row, Pair(row, helix))
    for row in golden["ring"]:
        pair = Pair(row)
        geometry(row["name"], row, pair)
        for gear, expected in enumerate(row["bending_foundation_c"]):
            rho = (pair.c, abs(pair.t1t2 - pair.c))[gear] / np.cos(pair.b_b)
            for value, number in zip(pair.teeth[gear].compliance(rho), expected):
                compare("compliance of ring pairs", f"{row['name']} {gear}", value, number, 1e-4)
        laws(row["name"], row, pair)
    report()


if __name__ == "__main__":
    main()
