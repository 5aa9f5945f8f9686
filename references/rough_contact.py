"""Rough contacts of half planes by projected conjugate gradients (Polonsky and Keer 1999). Needs numpy.

Another algorithm than that of the project, which has an active set with a coarse space.
"""

import numpy as np

from held import held, report

TESTS = "crates/contact/tests/validation.rs"
MASK = (1 << 64) - 1


def splitmix(seed, k):
    """The k-th number of a seed, below one."""
    state = (seed * 1_099_511_628_211 + k) & MASK
    state = (state + 0x9E3779B97F4A7C15) & MASK
    z = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
    return ((z ^ (z >> 31)) >> 11) / (1 << 53)


def waves(x, ks, seed):
    """Sum of k^-1.3 cos(2 pi k x + phase), x over the length."""
    return sum(k ** -1.3 * np.cos(2 * np.pi * (k * x + splitmix(seed, k))) for k in ks)


def strip_kernel(n, half):
    """Displacement of cell 0 by a unit pressure on cell k, times pi E*, zero in the cell itself."""
    r = 2.0 * np.arange(n)
    term = lambda u: np.where(u == 0, 0.0, u * np.log(np.maximum(u * u, 1e-300)))
    return half * (term(r - 1) - term(r + 1))


class Free:
    """Free ends: the kernel embedded in a period twice as long."""

    def __init__(self, n, spacing, modulus):
        column = strip_kernel(n, spacing / 2) / (np.pi * modulus)
        self.n = n
        self.spectrum = np.fft.rfft(np.concatenate([column, [0.0], column[:0:-1]]))

    def __call__(self, p):
        return np.fft.irfft(self.spectrum * np.fft.rfft(p, 2 * self.n), 2 * self.n)[: self.n]


class Spectral:
    """A period of length 1 with waves of pressure: u = 2 p / (E* q)."""

    def __init__(self, n, modulus):
        q = 2 * np.pi * np.arange(n // 2 + 1)
        self.n, self.spectrum = n, np.concatenate([[0.0], 2 / (modulus * q[1:])])

    def __call__(self, p):
        return np.fft.irfft(self.spectrum * np.fft.rfft(p), self.n)


def solve(operator, gap, load, limit=np.inf, tolerance=1e-13, most=40_000):
    """Pressures that carry `load` (their sum), nowhere negative nor above `limit`, and the approach."""
    n = len(gap)
    p = np.full(n, load / n)
    direction, g_old, fresh = np.zeros(n), 1.0, 0.0
    for step in range(most):
        r = operator(p) + gap
        inner = (p > 0) & (p < limit)
        alpha = r[inner].mean()
        r -= alpha
        wrong = max(-(r[p == 0]).min(initial=0.0), r[p == limit].max(initial=0.0) if np.isfinite(limit) else 0.0)
        error = max(np.abs(r[inner]).max(), wrong)
        if error < tolerance * np.ptp(gap):
            return p, alpha, step
        g = float(r[inner] @ r[inner])
        direction = np.where(inner, r + fresh * g / g_old * direction, 0.0)
        fresh, g_old = 1.0, g
        moved = operator(direction)
        moved -= moved[inner].mean()
        tau = float(r[inner] @ direction[inner]) / float(moved[inner] @ direction[inner])
        p = np.where(inner, p - tau * direction, p)
        p = np.clip(p, 0.0, limit)
        opened = (p == 0) & (r < 0)
        released = (p == limit) & (r > 0) if np.isfinite(limit) else np.zeros(n, bool)
        if opened.any() or released.any():
            fresh = 0.0
            p = p - np.where(opened | released, tau * r, 0.0)
            p = np.clip(p, 0.0, limit)
        # The load, by the cells between the bounds alone.
        for _ in range(50):
            free = (p > 0) & (p < limit)
            missing = load - p.sum()
            if abs(missing) < 1e-15 * load:
                break
            if np.isfinite(limit):
                p = np.where(free, np.clip(p + missing / max(free.sum(), 1), 0.0, limit), p)
            else:
                p = p * (load / p.sum())
    raise SystemExit(f"no solution after {most} steps: {error:e}")


def rough_cylinders(points=10_000):
    length, radius, modulus = 600e-6, 3e-3, 210e9 / 1.82
    spacing = length / points
    x = (np.arange(points) + 0.5) * spacing - length / 2
    along = (np.arange(points) + 0.5) / points
    ks = range(6, 301)
    scale = 0.4e-6 / np.sqrt(2) / np.sqrt(sum(0.5 * k ** -2.6 for k in ks))
    gap = x ** 2 / (2 * radius) - scale * (waves(along, ks, 11) + waves(along, ks, 22))
    operator, load = Free(points, spacing, modulus), 3e5 / spacing
    p, alpha, steps = solve(operator, gap, load)
    print(f"elastic: {steps} steps, {np.count_nonzero(p)} cells touch")
    held(TESTS, "cells in contact", np.count_nonzero(p), 0.0)
    held(TESTS, "largest pressure", p.max(), 1e-9)
    # The datum of the tests is twice the window.
    datum = lambda d: -strip_kernel_at(2 * d / spacing) * spacing / 2 / (np.pi * modulus) * load
    held(TESTS, "approach", alpha + datum(2 * length), 1e-9)
    p, alpha, steps = solve(operator, gap, load, limit=4e9)
    touching = np.count_nonzero(p)
    print(f"limited: {steps} steps, {touching} cells touch")
    held(TESTS, "cells in contact under a limit", touching, 0.0)
    held(TESTS, "approach under a limit", alpha + datum(2 * length), 1e-9)
    plastic = np.where(p == 4e9, np.maximum(-(operator(p) + gap - alpha), 0.0), 0.0)
    held(TESTS, "dissipated energy", 4e9 * plastic.sum() * spacing, 1e-8)
    held(TESTS, "plastic displacement", plastic.max(), 1e-8)


def strip_kernel_at(r):
    return (r - 1) * np.log((r - 1) ** 2) - (r + 1) * np.log((r + 1) ** 2)


def self_affine(points=4096):
    x, ks = np.arange(points) / points, range(16, 513)
    slope = np.sqrt(sum(0.5 * (2 * np.pi * k ** -0.3) ** 2 for k in ks))
    gap = -waves(x, ks, 20_240_601) / slope
    p, _, steps = solve(Spectral(points, 1.0), gap, 0.015 * points)
    print(f"periodic: {steps} steps, {np.count_nonzero(p)} cells touch")
    held(TESTS, "largest pressure of a period", p.max(), 1e-9)


if __name__ == "__main__":
    rough_cylinders()
    self_affine()
    report()
