"""Share of the load that touching roughness carries, and the friction with it. Needs numpy and scipy. Half a minute.

Computes the 18 windows of `crates/mixed-film/tests/golden/load_share.json` from the traces in `fixtures/profiles`:
preparation by Gaussian filters (2.5 um, 0.25 mm); attenuation of the waves 1/(1 + 0.125 N + 0.04 N^2), N = (l/a) M^(3/4)
L^(-1/2); inlet factor sqrt(1 + 2.342 (s/h_c)^2); contact of the flanks under (1 - phi) of Hertz' pressure from the film by
the conjugate gradients of `rough_contact.py`; phi where the mean gap over 0.8 a is h_c Psi (1 - phi)^(-0.16); films by
Moes of the spots, one for each peak of the pressure, with the load and the width 32 (int p dx)^2/(3 pi^2 int p^2 dx) of the
pressure around the peak, as a mean over the levels up to it; friction (1 - phi) mu_f + phi ((1 - beta) mu_a + beta mu_b)
with the heat of `film_friction.py`.
"""

import json

import numpy as np
from scipy.optimize import brentq

from film_friction import E_STAR, STEEL, Oil, source_constant
from held import ROOT, compare, report
from rough_contact import Free, solve, strip_kernel
from table_2 import gupta, moes

GOLDEN = ROOT / "crates/mixed-film/tests/golden/load_share.json"
FILES = {"ground": ("ground_pinion.csv", "ground_wheel.csv"),
         "superfinished": ("superfinished.csv", "superfinished_wheel.csv")}
SPACING, FLOW, BULK, LAYER = 0.5e-6, 7e9, 363.15, 10e-9


def gaussian(z, cutoff):
    reach = int(cutoff / SPACING + 1e-9)
    x = np.arange(-reach, reach + 1) * SPACING
    weight = np.exp(-np.pi * (x / cutoff) ** 2 / (np.log(2) / np.pi))
    return np.convolve(z, weight, "same") / np.convolve(np.ones_like(z), weight, "same")


def heights(text):
    for line in text.splitlines():
        separator = ";" if ";" in line else ","
        try:
            yield 1e-6 * float(line.split(separator, 1)[1].strip().replace(",", "."))
        except (IndexError, ValueError):
            continue


def prepared(file, mirrored):
    z = np.array(list(heights((ROOT / "fixtures/profiles" / file).read_text(encoding="utf-8"))))
    z = z[::-1] if mirrored else z
    x = np.arange(len(z))
    z = gaussian(z - np.polyval(np.polyfit(x, z, 1), x), 2.5e-6)
    edge = round(0.125e-3 / SPACING)
    return (z - gaussian(z, 0.25e-3))[edge:-edge]


def components(above):
    """First cells and ends of the runs of true cells."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], above, [0]]).astype(int)))
    return zip(edges[::2], edges[1::2])


def peaks(p, low=0.0, content=None, below=(0.0, 0.0)):
    """Load, and load and int p^2 dx of the contact around it, of every peak of the run `p`: one level after the other, in
    the order of the pressures. `content` is load and int p^2 dx of the part of the run above `low`, `below` the sums over
    the levels up to `low`."""
    power = np.array([1, 2])
    content = (p[:, None] ** power).sum(axis=0) * SPACING if content is None else content
    for level in np.unique(p):
        parts = [p[a:b] for a, b in components(p > level)]
        if len(parts) > 1:
            excess = np.array([((part[:, None] ** power) - level**power).sum(axis=0) for part in parts])
            shares = content * excess / excess.sum(axis=0)
            below = below + (level - low) * content
            return [peak for part, share in zip(parts, shares) for peak in peaks(part, level, share, below)]
    top = p.max()
    return [(content[0], *((below + (top - low) * content) / top))]


class Window:
    def __init__(self, row, traces, constant):
        self.oil = Oil(row["oil"])
        self.w, self.radius, u = row["w"], row["R"], (row["u1"], row["u2"])
        self.speed, self.slide, self.mu_b = sum(u) / 2, abs(u[0] - u[1]), row["mu_b"]
        self.a = np.sqrt(4 * self.w * self.radius / (np.pi * E_STAR))
        self.p0 = 2 * self.w / (np.pi * self.a)
        b = np.sqrt(STEEL["k"] * STEEL["rho"] * STEEL["c"])
        slow = [max(v, 2 * STEEL["k"] / (STEEL["rho"] * STEEL["c"]) / self.a) for v in u]
        self.rise = constant * self.w * self.slide / (b * sum(np.sqrt(slow)) * np.sqrt(2 * self.a))
        twice = 2 * E_STAR
        eta, alpha = self.oil.eta(BULK), self.oil.alpha(BULK)
        speed, load, g = eta * self.speed / (twice * self.radius), self.w / (twice * self.radius), alpha * twice
        thinning = -(np.log(self.oil.eta(BULK + 0.01)) - np.log(self.oil.eta(BULK - 0.01))) / 0.02
        loading = eta * thinning * self.speed**2 / self.oil.of["conductivity"]
        thermal = gupta(self.p0, E_STAR, loading, self.slide / self.speed)
        self.h_c = 3.06 * speed**0.69 * g**0.56 * load**-0.1 * self.radius * thermal
        n = 2 * int(np.ceil(3 * self.a / SPACING)) + 1
        nabla = (load / np.sqrt(2 * speed)) ** 0.75 / np.sqrt(g * (2 * speed) ** 0.25) / self.a
        cut = [slice(start, start + n) for start in row["starts"]]
        attenuated = sum(self.attenuate(z, nabla)[s] for z, s in zip(traces, cut))
        self.rms = np.std(attenuated)
        self.psi = np.sqrt(1 + 2.342 * (self.rms / self.h_c) ** 2)
        self.x = (np.arange(n) - n // 2) * SPACING
        self.z = sum(z[s] for z, s in zip(traces, cut))
        self.operator = Free(n, SPACING, E_STAR)
        self.column = strip_kernel(n, SPACING / 2) / (np.pi * E_STAR)
        far = np.maximum(np.abs(self.x) / self.a, 1.0)
        flat = far * np.sqrt(far**2 - 1) - np.log(far + np.sqrt(far**2 - 1))
        self.hertz_gap = self.a**2 / (2 * self.radius) * flat

    @staticmethod
    def attenuate(z, nabla):
        q = np.fft.rfftfreq(len(z), SPACING)
        n = nabla / np.maximum(q, q[1])
        keep = np.where(q > 0, 1 / (1 + 0.125 * n + 0.04 * n * n), 0.0)
        return np.fft.irfft(keep * np.fft.rfft(z), len(z))

    def contact(self, phi):
        """Pressures of the solids and the mean gap when they carry `phi` of the load."""
        parabola = self.x**2 / (2 * self.radius)
        gap = phi * parabola + (1 - phi) * self.hertz_gap - self.z
        p = np.zeros_like(gap)
        if phi > 0:
            p, approach = self.capped(gap, phi * self.w / SPACING, FLOW - (1 - phi) * self.p0)
            gap = np.maximum(gap + self.operator(p) - approach, 0)
        else:
            gap = gap - gap.min()
        # The part of each cell within 0.8 a.
        part = np.clip((0.8 * self.a - np.abs(self.x)) / SPACING + 0.5, 0, 1)
        return p, part @ gap / part.sum()

    def capped(self, gap, load, limit):
        """Pressures between 0 and `limit` that carry `load`, and the approach: the elastic contact by conjugate
        gradients, then sets of free, flowing and open cells until nothing changes."""
        p, _, _ = solve(self.operator, gap, load, tolerance=1e-9)
        free, flowing = (p > 0) & (p < limit), p >= limit
        for _ in range(60):
            i = np.flatnonzero(free)
            known = np.where(flowing, limit, 0.0)
            system = np.ones((len(i) + 1,) * 2)
            system[:-1, :-1], system[:-1, -1], system[-1, -1] = self.column[np.abs(np.subtract.outer(i, i))], -1.0, 0.0
            solved = np.linalg.solve(system, np.append(-(gap + self.operator(known))[i], load - known.sum()))
            p, approach = known, solved[-1]
            p[i] = solved[:-1]
            open_by = gap + self.operator(p) - approach
            now_flowing = (free & (p > limit)) | (flowing & (open_by < 0))
            now_free = (free & (p > 0) & (p <= limit)) | (flowing & (open_by >= 0)) | (~free & ~flowing & (open_by < 0))
            if (now_free == free).all() and (now_flowing == flowing).all():
                return p, approach
            free, flowing = now_free, now_flowing
        raise SystemExit("the contact does not settle")

    def share(self):
        over = lambda phi: self.contact(phi)[1] - self.h_c * self.psi * (1 - phi) ** -0.16
        if over(0.0) <= 0:
            return 0.0
        return brentq(over, 1e-5, 0.99, xtol=1e-6)

    def stress(self, p, film, surface):
        rate, per = self.slide / film, self.slide * film / (12 * self.oil.conductivity(p))
        most = 1 + 1.001 * self.oil.stress(p, surface, rate)
        return brentq(lambda t: t - self.oil.stress(p, surface + per * t, rate), 0, most, xtol=1e-3, rtol=1e-13)

    def film(self, surface):
        nodes, weights = np.polynomial.legendre.leggauss(32)
        t, weights = (nodes + 1) * np.pi / 4, weights * np.pi / 4
        tau = np.array([self.stress(self.p0 * np.cos(at), self.h_c, surface) for at in t])
        return 2 * self.a / self.w * float(weights @ (tau * np.cos(t)))

    def spots(self, p, surface):
        """Boundary part, friction of the lubricated part, and the mean film of the spots."""
        eta, alpha, twice = self.oil.eta(surface), self.oil.alpha(surface), 2 * E_STAR
        total = boundary = wet = sheared = film = 0.0
        for load, joint, squares in (peak for low, high in components(p > 0) for peak in peaks(p[low:high])):
            width = 32 * joint**2 / (3 * np.pi**2 * squares)
            radius = np.pi * E_STAR * (width / 2) ** 2 / (4 * joint)
            h = radius * moes(alpha * twice, eta * self.speed / (twice * radius), joint / (twice * radius))
            beta = 1 / (1 + h / LAYER)
            total, boundary, film = total + load, boundary + load * beta, film + load * h
            wet += load * (1 - beta)
            sheared += load * (1 - beta) * self.stress(joint / width, h, surface) / (joint / width)
        return boundary / total, sheared / wet, film / total

    def friction(self, phi):
        p, _ = self.contact(phi)

        def at(mu):
            surface = BULK + self.rise * mu
            mu_f = self.film(surface)
            beta, mu_a, film = self.spots(p, surface) if phi > 0 else (0.0, 0.0, 0.0)
            return (1 - phi) * mu_f + phi * ((1 - beta) * mu_a + beta * self.mu_b), mu_f, beta, mu_a, film

        mu = brentq(lambda mu: mu - at(mu)[0], 1e-4, 0.1, xtol=1e-9)
        inside = np.abs(self.x) < self.a
        return at(mu), np.count_nonzero(p[inside]) / np.count_nonzero(inside)


def main():
    constant = source_constant()
    traces = {name: [prepared(file, k == 1) for k, file in enumerate(files)] for name, files in FILES.items()}
    for row in json.loads(GOLDEN.read_text(encoding="utf-8"))["windows"]:
        window = Window(row, traces[row["profile"]], constant)
        name = f"{row['profile']} {row['oil']} {row['starts']} R {row['R']:.5f}"
        compare("smooth film", name, window.h_c, row["hc"], 1e-8)
        compare("attenuated rms", name, window.rms, row["Sqd"], 1e-8)
        compare("inlet factor", name, window.psi, row["psi"], 1e-8)
        phi = window.share()
        (mu, mu_f, beta, mu_a, film), area = window.friction(phi)
        print(f"{name}: share {phi:.5f}, friction {mu:.6f}; held {row['phi']:.5f}, {row['mu']:.6f}")
        compare("share", name, phi, row["phi"], 0.0, 1e-4)
        compare("friction", name, mu, row["mu"], 0.0, 2e-5)
        compare("film friction", name, mu_f, row["mu_f"], 0.0, 2e-6)
        if row["phi"] > 0:
            compare("boundary part", name, beta, row["beta"], 0.0, 2e-3)
            compare("friction of spots", name, mu_a, row["mu_a"], 0.0, 1e-4)
            # The held share stops at 1e-4, and the film of a single spot turns with the share.
            moved = abs(window.friction(row["phi"])[0][4] - film)
            compare("film of spots", name, film, row["h_a"], 0.0, 0.2e-9 + moved)
            compare("area", name, area, row["area"], 0.0, 2e-3)
    report()


if __name__ == "__main__":
    main()
