"""Lay factor, slope of the inlet factor and amplitudes of waves in the inlet of a line contact. Needs numpy and scipy.

1. Flow through a rough gap to second order, div((h + z)^3 grad p) = 0: phi = 1 + 3 s^2/h^2 (1 - 3 <k_x^2/k^2>). Over an
   elliptical spectrum of the ratio gamma the mean of k_x^2/k^2 is 1/(1 + gamma), so phi = 1 - 6 t s^2/h^2 with
   t = (3/(1 + gamma) - 1)/2: by quadrature, and by direct solutions on generated surfaces.
2. Grubin's inlet with <h^-3> = h^-3 (1 + 6 s^2/h^2): slope of the square of the film ratio over (s/h_c)^2.
3. Amplitude that a small wave keeps in rolling: steady smooth contact by Newton's method (Roelands, Dowson and Higginson's
   density), linearised at the frequency of the wave's passing. Compared with table 1 of Venner, Couhier, Lubrecht and
   Greenwood 1997 (M 100, L 11) as printed there, and with their equation 5, 1/(1 + 0.17 n + 0.03 n^2).

Two minutes: the amplitudes are on 600 cells.
"""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import k0
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from held import agree, held, report

INLET = "crates/ehl-regime/src/inlet_flow.rs"
LAW = "crates/ehl-regime/src/gap_law.rs"
PATCH = "crates/ehl-regime/src/patch.rs"


def spectral_mean(gamma):
    """Mean of cos^2/(cos^2 + gamma^2 sin^2) over the angle."""
    part = lambda angle: np.cos(angle) ** 2 / (np.cos(angle) ** 2 + (gamma * np.sin(angle)) ** 2)
    return quad(part, 0, np.pi / 2)[0] / (np.pi / 2)


def surface(points, lengths, seed):
    """A Gaussian surface with an elliptical spectrum, of unit standard deviation."""
    k = np.fft.fftfreq(points) * 2 * np.pi
    k_x, k_y = np.meshgrid(k, k, indexing="ij")
    keep = np.exp(-((k_x * lengths[0]) ** 2 + (k_y * lengths[1]) ** 2) / 8)
    z = np.real(np.fft.ifft2(keep * np.fft.fft2(np.random.default_rng(seed).standard_normal((points, points)))))
    spectrum = np.abs(np.fft.fft2(z - z.mean())) ** 2
    square = k_x**2 + k_y**2
    square[0, 0] = 1
    return (z - z.mean()) / z.std(), float((spectrum * k_x**2 / square).sum() / spectrum.sum())


def flow(z, s):
    """Mean flow in x through the periodic gap 1 + s z under a unit pressure gradient."""
    n = len(z)
    c = (1 + s * z) ** 3
    faces = [2 / (1 / c + 1 / np.roll(c, -1, axis)) for axis in (0, 1)]
    index = np.arange(n * n).reshape(n, n)
    rows, columns, values = [], [], []
    for face, axis in zip(faces, (0, 1)):
        next_ = np.roll(index, -1, axis)
        for a, b, v in ((index, index, face), (next_, next_, face), (index, next_, -face), (next_, index, -face)):
            rows.append(a.ravel()), columns.append(b.ravel()), values.append(v.ravel())
    matrix = coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))).tocsc()
    drive = (faces[0] - np.roll(faces[0], 1, 0)).ravel()
    q = np.zeros(n * n)
    q[1:] = splu(matrix[1:, 1:], permc_spec="MMD_AT_PLUS_A").solve(drive[1:])
    q = q.reshape(n, n)
    return float((faces[0] * (1 + np.roll(q, -1, 0) - q)).mean())


def lay():
    for gamma in (0.0, 1 / 12, 1 / 6, 1 / 3, 1.0):
        agree(f"mean of k_x^2/k^2, gamma {gamma:.3f}", spectral_mean(gamma), 1 / (1 + gamma), 1e-9)
    for gamma, length in ((1 / 9, 16.2), (1 / 3, 10.4), (1.0, 6.0)):
        s = 0.05
        z, mean = surface(128, (length * gamma, length), 1)
        # Odd orders cancel between +s and -s.
        direct = (1 - 0.5 * (flow(z, s) + flow(z, -s))) / (6 * s * s)
        print(f"gamma {gamma:.3f}: t by direct flow {direct:.4f}, by the spectrum of the surface {(3 * mean - 1) / 2:.4f}")
        agree("lay factor by direct flow", direct, (3 * mean - 1) / 2, 0.03)


def slope():
    def inlet(film, s):
        def part(t):
            x = 1 + t * t
            root = np.sqrt(x * x - 1)
            h = film + 0.5 * (x * root - np.log(x + root))
            return (h - film) / h**3 * (1 + 6 * s * s / h**2) * 2 * t

        return quad(part, 0, 60, limit=400, points=[0.05, 0.1, 0.3, 1, 3])[0]

    slopes = []
    for film in (1e-3, 5e-3, 2e-2, 5e-2, 1e-1):
        s, base = 0.02 * film, inlet(film, 0)
        rough = brentq(lambda h: inlet(h, s) - base, film, 1.2 * film)
        slopes.append(((rough / film) ** 2 - 1) / (s / film) ** 2)
    print("slope of the square of the film ratio:", " ".join(f"{value:.4f}" for value in slopes))
    held(INLET, "middle of the slopes", sorted(slopes)[2], 1e-3)


class Smooth:
    """Steady smooth contact of Moes' numbers on [-3, 1.5] half widths."""

    ALPHA, Z, P_R = 1.8e-8, 0.6, 1.96e8

    def __init__(self, load, material, cells=600):
        self.load, self.material = load, material
        self.pressure = material * np.sqrt(load / (2 * np.pi)) / self.ALPHA
        self.factor = 3 * np.pi**2 / (8 * load**2)
        self.x = np.linspace(-3.0, 1.5, cells + 1)
        self.dx = self.x[1] - self.x[0]
        n = cells + 1
        d = (np.arange(n)[None, :] - np.arange(n)[:, None]) * self.dx
        primitive = lambda s: np.where(s == 0, 0, s * (np.log(np.abs(np.where(s == 0, 1, s))) - 1))
        self.kernel = -(primitive(d + self.dx / 2) - primitive(d - self.dx / 2)) / np.pi
        # Third order, upwind: short waves are hardly damped.
        self.wedge = np.zeros((n, n))
        for i in range(1, n):
            if 2 <= i < n - 1:
                self.wedge[i, i - 2 : i + 2] = np.array([1, -6, 3, 2]) / (6 * self.dx)
            else:
                self.wedge[i, i - 1 : i + 1] = np.array([-1, 1]) / self.dx
        self.solve()

    def lead_kernel(self, k):
        """Displacement by a pressure that varies as cos(k y) along the lead: K0 instead of the logarithm."""
        d = np.arange(len(self.x)) * self.dx
        nodes, weights = np.polynomial.legendre.leggauss(8)
        primitive = lambda s: np.where(s == 0, 0, s * (np.log(np.abs(np.where(s == 0, 1, s))) - 1))
        logarithm = -(primitive(d + self.dx / 2) - primitive(d - self.dx / 2))
        places = np.abs(d[:, None] + nodes[None, :] * self.dx / 2)
        column = (logarithm + (k0(k * places) + np.log(places)) @ (weights * self.dx / 2)) / np.pi
        index = np.arange(len(d))
        return column[np.abs(index[:, None] - index[None, :])]

    def linear(self, p, h0, kernel=None, lead=0.0):
        """Residual of Reynolds' equation with its derivatives, and what a change of the film alone does; of changes with the wavenumber
        `lead` along the lead, whose displacement is by `kernel`."""
        kernel = self.kernel if kernel is None else kernel
        film = np.maximum(h0 + self.x**2 / 2 + self.kernel @ p, 1e-9)
        real = p * self.pressure
        rho = 1 + 0.6e-9 * real / (1 + 1.7e-9 * real)
        rho_p = 0.6e-9 / (1 + 1.7e-9 * real) ** 2 * self.pressure
        c = self.ALPHA * self.P_R / self.Z
        log_eta = c * ((1 + real / self.P_R) ** self.Z - 1)
        eta_p = c * self.Z / self.P_R * (1 + real / self.P_R) ** (self.Z - 1) * self.pressure
        eps = rho * film**3 * np.exp(-log_eta) / self.factor
        eps_p, eps_h = eps * (rho_p / rho - eta_p), 3 * eps / film
        n = len(p)
        half = (p[1:] - p[:-1]) / self.dx * 0.5
        face = 0.5 * (eps[1:] + eps[:-1])
        by_film = lambda change: half * (eps_h[1:] * change[1:] + eps_h[:-1] * change[:-1])
        divergence = lambda flux: np.concatenate([np.zeros((1,) + flux.shape[1:]), flux[1:] - flux[:-1], np.zeros((1,) + flux.shape[1:])]) / self.dx
        rows = np.arange(n - 1)
        whole = np.diag(eps_p) + eps_h[:, None] * kernel
        flux = half[:, None] * (whole[1:] + whole[:-1])
        flux[rows, rows] -= face / self.dx
        flux[rows, rows + 1] += face / self.dx
        mass = np.diag(rho_p * film) + rho[:, None] * kernel
        inner = np.zeros(n)
        inner[1:-1] = 1
        residual = divergence(2 * half * face) - inner * (self.wedge @ (rho * film))
        jacobian = divergence(flux) - inner[:, None] * (self.wedge @ mass) - np.diag(inner * lead**2 * eps)
        return residual, jacobian, mass, rho, lambda change: divergence(by_film(change)) - inner * (self.wedge @ (rho * change)), inner

    def solve(self):
        x, n = self.x, len(self.x)
        p = np.sqrt(np.maximum(0, 1 - x**2))
        h0 = 0.1 - (self.kernel @ p + x**2 / 2)[np.abs(x) < 0.9].mean()
        for _ in range(300):
            residual, jacobian, _, _, by_film, _ = self.linear(p, h0)
            free = (p > 0) | (residual > 0)
            free[[0, -1]] = False
            cavitated = np.where(~free & (x > 0.2))[0]
            free[cavitated[0] :] = False
            free[1 : np.searchsorted(x, -0.5)] = True
            matrix = np.zeros((n + 1, n + 1))
            matrix[:n, :n] = np.where(free[:, None], jacobian, np.eye(n))
            matrix[:n, n] = np.where(free, by_film(np.ones(n)), 0)
            matrix[n, :n] = self.dx
            right = np.append(np.where(free, -residual, -p), np.pi / 2 - p.sum() * self.dx)
            step = np.linalg.solve(matrix, right)
            length = min(1.0, 0.2 / max(1e-12, np.abs(step).max()))
            p, h0 = np.maximum(p + length * step[:n], 0), h0 + length * step[n]
            if length == 1.0 and np.abs(step).max() < 1e-9:
                self.p, self.h0, self.free = p, h0, free
                return
        raise SystemExit("the smooth contact does not converge")

    def amplitude(self, wave):
        """Amplitude in the middle of a wave of `wave` half widths over its amplitude outside, in rolling."""
        _, jacobian, mass, rho, by_film, inner = self.linear(self.p, self.h0)
        n, omega = len(self.x), 2 * np.pi / wave
        shape = np.exp(-1j * omega * self.x)
        storage = lambda change: 1j * omega * inner * rho * change
        matrix = np.zeros((n + 1, n + 1), complex)
        of_pressure = jacobian - 1j * omega * inner[:, None] * mass
        matrix[:n, :n] = np.where(self.free[:, None], of_pressure, np.eye(n))
        matrix[:n, n] = np.where(self.free, by_film(np.ones(n)) - storage(np.ones(n)), 0)
        matrix[n, :n] = self.dx
        right = np.append(np.where(self.free, -(by_film(shape) - storage(shape)), 0), 0)
        found = np.linalg.solve(matrix, right)
        film = found[n] + self.kernel @ found[:n] + shape
        return abs(np.interp(0, self.x, film.real) + 1j * np.interp(0, self.x, film.imag))

    def amplitude_on_patch(self, along, lead):
        """The same of a wave with these lengths along rolling and along the lead; the contact does not move as a whole."""
        omega, k = 2 * np.pi / along, 2 * np.pi / lead
        kernel = self.lead_kernel(k)
        _, jacobian, mass, rho, by_film, inner = self.linear(self.p, self.h0, kernel, k)
        shape = np.exp(-1j * omega * self.x)
        of_pressure = jacobian - 1j * omega * inner[:, None] * mass
        matrix = np.where(self.free[:, None], of_pressure, np.eye(len(self.x)))
        right = np.where(self.free, -(by_film(shape) - 1j * omega * inner * rho * shape), 0)
        film = kernel @ np.linalg.solve(matrix, right) + shape
        return abs(np.interp(0, self.x, film.real) + 1j * np.interp(0, self.x, film.imag))

    def nabla(self, wave):
        return wave * self.load**0.75 / np.sqrt(self.material)


def amplitudes():
    for coefficient in (0.17, 0.03):
        held(LAW, "equation 5", coefficient, 0.0)
    printed = {4.0: 0.030, 2.0: 0.073, 1.0: 0.183, 0.5: 0.394, 0.25: 0.660}
    contact = Smooth(100, 11)
    for wave, expected in printed.items():
        n, found = contact.nabla(wave), contact.amplitude(wave)
        law = 1 / (1 + 0.17 * n + 0.03 * n * n)
        print(f"wave {wave:5.3f} a, nabla {n:6.2f}: amplitude {found:.4f}, printed {expected:.3f}, equation 5 {law:.4f}")
        agree("amplitude of table 1", found, expected, 0.06)
        if n < 10:
            agree("equation 5", law, expected, 0.05)
    for load, material in ((20, 7), (26, 10.7), (40, 7), (200, 7)):
        contact = Smooth(load, material)
        for wave in (1.0, 2.0):
            n, found = contact.nabla(wave), contact.amplitude(wave)
            law = 1 / (1 + 0.17 * n + 0.03 * n * n)
            print(f"M {load}, L {material}, nabla {n:6.2f}: amplitude {found:.4f}, equation 5 {law:.4f} ({100 * (law / found - 1):+.0f} %)")
            # It is too low for short inlets and for amplitudes above a half.
            agree("equation 5 in other contacts", law, found, 0.35)


def equivalent(amplitude):
    """n of equation 5 for an amplitude."""
    return (np.sqrt(0.17**2 + 4 * 0.03 * (1 / amplitude - 1)) - 0.17) / 0.06


def patches():
    held(PATCH, "longest over the wave along the motion", 2.0, 0.0)
    ratios = (0.25, 0.5, 1.0, 2.0, 4.0, 16.0)
    seen = {ratio: [] for ratio in ratios}
    for load, material in ((100, 11), (26, 10.7), (40, 7), (200, 7)):
        contact = Smooth(load, material)
        for wave in (0.25, 0.5, 1.0, 2.0):
            across = contact.amplitude(wave)
            if across > 0.52:
                continue
            for ratio in ratios:
                lengths = (wave, wave / ratio) if ratio <= 1 else (wave * ratio, wave)
                seen[ratio].append(equivalent(contact.amplitude_on_patch(*lengths)) / equivalent(across))
    for ratio, found in seen.items():
        law = 1.0 if ratio <= 1 else 2 ** (1 - 1 / ratio)
        print(f"ratio {ratio}: effective length {min(found):.2f} to {max(found):.2f}, mean {np.mean(found):.2f}, rule {law:.2f}")
        agree("effective length of a wave", law, float(np.mean(found)), 0.12)


def main():
    lay()
    slope()
    amplitudes()
    patches()
    report()


if __name__ == "__main__":
    main()
