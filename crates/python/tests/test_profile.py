"""Profiles: read, made, prepared, written."""

import pickle

import numpy as np
import pytest

import asperity
from conftest import PROFILES, heights, small, trace


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


def test_a_prepared_profile_says_so_in_a_case_and_in_its_file(tmp_path):
    rough = trace().prepare()
    with pytest.warns(asperity.AsperityWarning, match="W118 .*filtering them again"):
        case = asperity.Case(small()).replace({"surface.pinion.file": rough})
    result = case.run("losses")
    for found in (case, result, pickle.loads(pickle.dumps(case))):
        assert "W118" in found.warnings.code
    unfiltered = case.replace(surface={"cutoff": "0 mm", "noise_cutoff": "0 mm"})
    assert "W118" not in unfiltered.warnings.code, "nothing filters it again"
    assert "W118" not in case.replace({"surface.pinion": trace()}).warnings.code
    rough.write(tmp_path / "rough.csv")
    assert "# filter: roughness, lambda_c 250 um" in (tmp_path / "rough.csv").read_text()
    with pytest.warns(asperity.AsperityWarning, match="W118"):
        again = asperity.read_profile(tmp_path / "rough.csv")
    assert again == rough and again.about.filter_state == "roughness"


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


def test_parts_of_a_profile_are_profiles():
    whole = asperity.read_profile(PROFILES / "ground_pinion.csv")
    part = whole[1000:3001]
    assert np.array_equal(part.heights, whole.heights[1000:3001]) and part.spacing == whole.spacing
    assert part.unit == whole.unit and part.name == whole.name, "what the file says stays"
    assert whole[-500:] == whole[5501:] and whole[:] == whole
    assert whole.crop("0.5 mm", 1.5e-3) == part and whole.crop(end="1 mm") == whole[:2001]
    read = asperity.read_profile(PROFILES / "ground_pinion.csv", range="0.5 mm .. 1.5 mm")
    assert np.array_equal(read.heights, part.heights), "as the reader cuts"
    rough = whole.prepare(cutoff="0.25 mm")
    # Sections are as long as the cut-off that the heights have been through.
    assert rough[:2000].parameters().section_um == rough.parameters().section_um == 250.0
    for wrong, code in (
        (lambda: whole[3], "E204"), (lambda: whole[::2], "E204"), (lambda: whole[:50], "E106"), (lambda: whole[10:10], "E209"),
        (lambda: whole.crop("1 mm", "9 mm"), "E209"), (lambda: whole.crop("2 mm", "1 mm"), "E209"),
    ):
        with pytest.raises(asperity.AsperityError) as refused:
            wrong()
        assert refused.value.code == code


def test_spectrum_autocorrelation_and_material_ratio_are_those_of_one_wave():
    amplitude, period, spacing = 1e-6, 50, 1e-6
    waves = asperity.Profile(amplitude * np.sin(2 * np.pi * np.arange(1000) / period), spacing)
    spectrum = waves.psd()
    step = spectrum.frequency_per_m[1]
    assert step == pytest.approx(1 / (1000 * spacing)) and len(spectrum) == 501
    assert spectrum.density_m3.sum() * step == pytest.approx(amplitude**2 / 2, rel=1e-4)
    assert spectrum.frequency_per_m[spectrum.density_m3.argmax()] == pytest.approx(1 / (period * spacing))
    shifts = waves.autocorrelation()
    assert shifts.autocorrelation[0] == 1.0 and shifts.shift_m[period] == pytest.approx(period * spacing)
    assert shifts.autocorrelation[[25, 50]] == pytest.approx([-1.0, 1.0], abs=1e-2)
    curve = waves.material_ratio()
    assert np.all(np.diff(curve.height_m) <= 0) and sorted(curve.height_m) == sorted(waves.heights)
    # A sine has material up to arcsin: half of the length is above its mean.
    quarter = curve[np.isclose(curve.material_ratio_percent, 25, atol=0.06)]
    assert quarter.height_m == pytest.approx(amplitude * np.sin(np.pi / 4), rel=0.1)


def test_a_parameter_that_a_profile_lacks_is_not_a_number():
    slope = asperity.Profile(np.linspace(0, 1e-6, 2000), 1e-6).parameters(prepare=False)
    assert np.isnan(slope.rsm_um) and np.isnan(slope["rsm_um"]) and slope.ra_um > 0
    assert "<td" in slope._repr_html_()


@pytest.mark.parametrize(
    ("make", "code", "words"),
    [
        (lambda z: asperity.Profile(z, 0.5e-6), "E209", "in metres: multiply heights in µm by 1e-6"),
        (lambda z: asperity.Profile(z * 1e-3, 0.5e-6), "E209", "in metres: multiply"),
        (lambda z: asperity.Profile(z * 1e-6, 0.5), "E116", "in metres"),
        (lambda z: asperity.Profile(z * 1e-6, 0.5e-6)[10:50], "E106", "at least 100 points"),
        (lambda z: asperity.Profile(z[:50] * 1e-6, 0.5e-6), "E106", "at least 100 points"),
        (lambda z: list(asperity.Profile(z * 1e-6, 0.5e-6)), "E204", ".heights"),
        (lambda z: asperity.Profile(z * 1e-6, 0.5e-6)[3], "E204", ".heights"),
    ],
)
def test_an_error_of_points_in_memory_names_the_remedy(make, code, words):
    with pytest.raises(asperity.AsperityError) as refused:
        make(heights(2000))
    assert refused.value.code == code and words in refused.value.help
    assert "surface" not in refused.value.message and " file" not in refused.value.help


def test_a_profile_is_an_array_of_its_heights():
    waves = trace()
    assert np.array_equal(np.asarray(waves), waves.heights) and np.std(waves) == waves.heights.std() and len(waves[100:500]) == 400


def test_a_case_takes_a_profile_as_its_file(tmp_path):
    file = tmp_path / "stated.csv"
    rows = "".join(f"{0.5 * k:.1f},{z:.6f}\n" for k, z in enumerate(heights(6000)))
    file.write_text(f"# filter: primary, lambda_c 0.8 mm\nx_um,z_um,remark\n{rows.replace(chr(10), ',-' + chr(10))}")
    with pytest.warns(asperity.AsperityWarning, match="W454"):
        flank = asperity.read_profile(file)
    open_cutoff = {key: value for key, value in small().items() if key != "surface"}
    surface = {"wheel": trace().mirrored()}
    of_file = asperity.Case({**open_cutoff, "surface": {**surface, "pinion": {"file": str(file)}}})
    of_profile = asperity.Case({**open_cutoff, "surface": {**surface, "pinion": flank}})
    assert of_profile.run("losses").loss_w == of_file.run("losses").loss_w
    assert sorted(of_profile.warnings.code) == sorted(of_file.warnings.code) and "W454" in of_file.warnings.code
    cutoffs = [{row.value for row in case.defaults if row.key == "surface.cutoff"} for case in (of_file, of_profile)]
    assert cutoffs[0] == cutoffs[1]
    (tmp_path / "again.toml").write_text(of_profile.to_toml(tmp_path), encoding="utf-8")
    again = asperity.Case(tmp_path / "again.toml")
    assert again.run("losses").loss_w == of_file.run("losses").loss_w
