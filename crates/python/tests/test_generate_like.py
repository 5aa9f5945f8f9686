"""Flanks generated like measured ones, and in states of a test."""

import numpy as np
import pytest

import asperity


def trace(seed: int, cut: float = np.inf) -> asperity.Profile:
    flank = asperity.generate(points=6000, spacing=0.5e-6, rq="0.4 um", hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=seed)
    return asperity.Profile(np.minimum(flank.heights, cut), flank.spacing)


def test_flanks_follow_the_traces_and_their_seed() -> None:
    plateaus = [trace(seed, cut=0.1e-6) for seed in (1, 2, 3)]
    made = asperity.generate_like(plateaus, seed=4)
    assert made.about.method == "pieces"
    assert len(made) == len(plateaus[0])
    assert np.array_equal(made.heights, asperity.generate_like(plateaus, seed=4).heights)
    assert not np.array_equal(made.heights, asperity.generate_like(plateaus, seed=5).heights)
    assert made.parameters()["rsk"] < -0.3
    spectrum = asperity.generate_like(plateaus, method="spectrum")
    assert spectrum.about.method == "spectrum" and spectrum.about.recipe is not None


def test_heights_are_lost_in_proportion_to_engagements() -> None:
    before = [trace(seed) for seed in (1, 2, 3)]
    after = {stage: [trace(seed, cut) for seed in (1, 2, 3)] for stage, cut in ((1e6, 0.1e-6), (1e4, 0.3e-6))}
    at = {n: asperity.generate_like(before, after=after, engagements=n).heights for n in (0, 1e4, 505e3, 1e6)}
    assert np.allclose(at[505e3], 0.5 * (at[1e4] + at[1e6]), atol=1e-12)
    assert np.array_equal(at[1e6], asperity.generate_like(before, after=after).heights)
    peaks = [heights.max() for heights in at.values()]
    assert peaks == sorted(peaks, reverse=True) and peaks[0] > 2 * peaks[-1]
    one_stage = asperity.generate_like(before, after=after[1e6], state=1)
    assert one_stage.heights.max() < 0.5 * peaks[0]


def test_what_does_not_fit_is_refused() -> None:
    before = [trace(1), trace(2)]
    for arguments, words in (
        ({"state": 0.5}, "of a test"),
        ({"after": before, "method": "pieces"}, "made of pieces"),
        ({"after": {1e4: before}, "state": 1.0}, "has engagements"),
        ({"after": before, "engagements": 1e4}, "no engagements"),
        ({"after": before[:1]}, "one for each trace"),
        ({"after": before, "state": 2.0}, "from 0 to 1"),
        ({"after": [trace(3), trace(4)]}, "not the same place"),
        ({"after": {1e4: before}, "engagements": 1e5}, "last stage"),
    ):
        with pytest.raises(asperity.AsperityError, match=words):
            asperity.generate_like(before, **arguments)
    with pytest.raises(asperity.AsperityError, match="profile"):
        asperity.generate_like([1.0, 2.0])
