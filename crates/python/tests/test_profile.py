"""Profiles: read, made, prepared, written."""

import numpy as np
import pytest

import asperity
from conftest import PROFILES, heights, trace


def test_heights_are_in_metres_and_owned():
    profile = asperity.read_profile(PROFILES / "ground_pinion.csv")
    assert profile.heights.dtype == np.float64 and profile.heights.flags.writeable
    assert profile.spacing == 0.5e-6 and profile.unit == "um" and len(profile) == 6001
    changed = profile.heights
    changed[:] = 0.0
    assert np.any(profile.heights), "a copy was changed"


def test_arrays_of_any_layout_are_taken():
    twice = np.repeat(heights(1000) * 1e-6, 2)[::2]
    assert not twice.flags.c_contiguous
    assert np.array_equal(asperity.Profile(twice, "0.5 um").heights, twice)
    assert np.array_equal(asperity.Profile(twice.tolist(), 0.5e-6).heights, twice)
    assert np.array_equal(np.asarray(asperity.Profile(twice, 0.5e-6)), twice)


def test_primary_profile_minus_waviness_is_roughness():
    parts = trace().filter(cutoff="0.25 mm")
    first = parts.roughness.about.first_index
    primary = parts.primary.heights[first : first + len(parts.roughness)]
    assert np.allclose(primary, parts.waviness.heights + parts.roughness.heights, atol=1e-18)


def test_preparation_is_on_record():
    rough = trace().prepare(cutoff=0.25e-3, noise_cutoff=0, robust=True, form="poly2")
    recipe = rough.about.preparation["recipe"]
    assert recipe["form"] == "poly2" and recipe["lambda-s"] is None
    assert rough.about.preparation.filter == "robust-gaussian"


def test_parameters_of_sections():
    whole = trace().prepare(cutoff=0.25e-3)
    assert whole.parameters().sections == 11
    assert whole.parameters(sections=3).sections == 3
    assert whole.parameters().to_pandas()["ra_um"] == whole.parameters()["ra_um"]
    with pytest.raises(AttributeError, match="ra_um"):
        whole.parameters().ra


@pytest.mark.parametrize("ending", ["csv", "x3p", "smd"])
def test_what_is_written_reads_back(tmp_path, ending):
    file = tmp_path / f"flank.{ending}"
    trace().write(file)
    # Micrometres of a table round the last bit of metres.
    rounding = 4e-16 if ending == "csv" else 0.0
    np.testing.assert_allclose(asperity.read_profile(file).heights, trace().heights, rtol=rounding, atol=0.0)


def test_options_of_the_reader(tmp_path):
    file = tmp_path / "odd.txt"
    file.write_text("\n".join(f"{z:.4f}".replace(".", ",") for z in heights(500)))
    profile = asperity.read_profile(file, dx=0.5e-6, z_unit="um", decimal="comma", columns=1)
    assert np.allclose(profile.heights, heights(500) * 1e-6, atol=1e-10)


def test_a_recipe_and_its_seed_give_the_same_profile():
    recipe = dict(points=4096, spacing="0.5 um", rq=0.3e-6, hurst=0.8, roll_off="100 um", short_cut=2e-6)
    first, again, other = (asperity.generate("self-affine", seed=seed, **recipe) for seed in (1, 1, 2))
    assert np.array_equal(first.heights, again.heights) and not np.array_equal(first.heights, other.heights)
    assert first.about.synthetic and first.about.achieved.rq_um == pytest.approx(0.3, rel=1e-9)
    pitted = asperity.generate("self-affine", seed=1, pits=dict(count=3, width=2e-5, depth=1e-6, seed=4), **recipe)
    assert pitted.heights.min() < first.heights.min()


def test_profiles_leave_for_other_packages():
    pandas = pytest.importorskip("pandas")
    xarray = pytest.importorskip("xarray")
    series, array = trace().to_pandas(), trace().to_xarray()
    assert isinstance(series, pandas.Series) and series.index[1] == 0.5e-6
    assert isinstance(array, xarray.DataArray) and array.attrs["units"] == "m"
    assert trace().to_dict()["heights"][3] == trace().heights[3]


def test_no_peak_is_lost_in_a_chart():
    heights = np.zeros(20_000)
    heights[12_345] = 1e-6
    drawn = str(asperity.Profile(heights, 0.5e-6).plot())
    flat = str(asperity.Profile(np.linspace(0, 1e-6, 20_000), 0.5e-6).plot())
    low = min(float(point.split(" ")[1]) for point in drawn.split('d="M')[-1].split('"')[0].split("L"))
    assert low == min(float(point.split(" ")[1]) for point in flat.split('d="M')[-1].split('"')[0].split("L"))


def test_a_chart_is_svg_and_matplotlib_takes_its_axes(tmp_path):
    chart = trace().plot()
    assert str(chart).startswith("<svg") and "height in µm" in str(chart)
    chart.save(tmp_path / "chart.svg")
    assert (tmp_path / "chart.svg").read_text(encoding="utf-8") == str(chart)
    pyplot = pytest.importorskip("matplotlib.pyplot")
    axes = pyplot.figure().subplots()
    assert trace().plot(axes) is axes and len(axes.lines) == 1
