"""Comparisons, maps, sweeps."""

import json
import pickle

import numpy as np
import pytest

import asperity
from conftest import CASES, PROFILES, trace

GROUND, FINE = PROFILES / "ground_pinion.csv", PROFILES / "superfinished.csv"


@pytest.fixture(scope="module")
def drive():
    return asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 2})


def test_variants_are_keys_tables_and_cases(drive):
    # The variant is checked with all its keys, not while only some are taken away.
    mineral = {"lubricant.oil": "m100", "lubricant.viscosity": None}
    found = asperity.compare(drive, {"pao": {"lubricant.oil": "pao100"}, "mineral": mineral, "as is": drive})
    assert found.names == ["pao", "mineral", "as is"]
    common = {row.name: row.correlation for row in found.finishes[1].difference.common}
    assert common["Eyring stress"] == 0 and common["lay"] == 1
    assert {row.key for row in found.finishes[1].changes} >= {"lubricant.oil"}
    # A single one is compared with the case itself.
    warm = asperity.compare(drive, {"warm": {"operation.bulk_temperature": "110 °C"}})
    assert warm.names == ["as is", "warm"] and len(warm.finishes[1].deciding)
    assert asperity.compare(drive, {"a": drive, "b": drive}).finishes[1].difference.verdict == "equal"
    for keys, code in (({"operation.torque": "145 N m"}, "E205"), ({"operation.torqe": "145 N m"}, "E203")):
        with pytest.raises(asperity.AsperityError, match="variant x") as error:
            asperity.compare(drive, {"x": keys})
        assert error.value.code == code
    # The files of both flanks are taken away before the first value is set.
    rough = {f"surface.{flank}": {"file": None, "mirrored": None, "rq": "0.3 um"} for flank in ("pinion", "wheel")}
    values = asperity.compare(drive, {"values": rough})
    assert values.names == ["as is", "values"] and values.finishes[0].loss_w != values.finishes[1].loss_w
    axes = {"torque_nm": [50, 145], "speed_rpm": [3000, 9000]}
    losses = asperity.map(drive, finishes={"thick": {"lubricant.oil": "pao100"}}, **axes)
    assert losses.finishes == ["as is", "thick"]
    # An axis would take the place of the key.
    with pytest.raises(asperity.AsperityError, match="those of its axes"):
        asperity.map(drive, finishes={"warm": {"operation.torque": "100 N m"}}, **axes)


def test_a_comparison_of_files_profiles_pairs_and_cases(drive, tmp_path):
    fine = asperity.read_profile(FINE)
    found = asperity.compare(
        drive,
        {"ground": GROUND, "profile": fine, "pair": (FINE, fine.mirrored()), "case": drive},
        offsets=2,
    )
    assert found.names == ["ground", "profile", "pair", "case"]
    assert found.finishes.loss_w[1] < found.finishes.loss_w[0]
    assert len(found.offsets["pair"]) == 2
    first, *others = found.finishes
    assert first.difference is None and len(found.verdicts) == 3
    difference = others[0].difference
    assert difference.quantiles_w[0] < difference.median_w < difference.quantiles_w[1]
    assert 0.5 <= difference.probability <= 1 and len(difference.models) and difference.verdict
    assert found.verdicts[0].startswith("With profile ") and others[-1].uncertainty.loss.median_w == others[-1].loss_w
    assert str(found).startswith("e-drive") and "ground" in repr(found) and "<table" in found._repr_html_()
    found.write(tmp_path / "out")
    assert asperity.read_result(tmp_path / "out").title == found.title
    pytest.importorskip("pandas")
    frame = found.to_pandas()
    assert list(frame.index) == found.names and frame.loss_w["profile"] == found.finishes.loss_w[1]
    assert frame.difference_median_w["profile"] == difference.median_w and frame.loss_p05_w["ground"] < frame.loss_w["ground"]
    assert frame.loss_at_medians_w["ground"] == first.loss_at_medians_w != first.loss_w
    pytest.importorskip("xarray")
    assert found.to_xarray().loss_w.sizes == {"finish": 4, "offset": 2}


def test_finishes_with_different_numbers_of_offsets_stand_in_one_array():
    pytest.importorskip("xarray")
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4})
    found = asperity.compare(case, {"ground": GROUND, "fine": FINE})
    counts = {name: len(rows) for name, rows in found.offsets.items()}
    assert counts["ground"] != counts["fine"]
    losses = found.to_xarray().loss_w
    assert losses.sizes["offset"] == max(counts.values())
    assert losses.count("offset").values.tolist() == [counts["ground"], counts["fine"]]


def test_a_point_of_a_map_is_a_run(drive, tmp_path):
    found = asperity.map(drive, torque="50..145:2 N m", speed=["3000 1/min", "9000 1/min"])
    run = drive.replace({"operation.torque": "50 N m", "operation.speed": "3000 1/min"}).run()
    at = found.torque_nm.tolist().index(50), found.speed_rpm.tolist().index(3000)
    assert found.loss_at_medians_w[0, 0, at[0], at[1]] == run.summary.loss_at_medians_w
    assert found.loss_w[0, 0, at[0], at[1]] == pytest.approx(run.loss_w, rel=1e-9)
    assert found.loss_torque(torque_nm=50, speed="3000 1/min") == found.loss_torque_nm[0, 0, at[0], at[1]]
    assert found.loss_torque(torque_nm=[50, 145], speed_rpm=5000).shape == (2,)
    with pytest.warns(asperity.AsperityWarning, match="1 of 2 places are outside"):
        edge, beyond = found.loss_torque(torque_nm=[145, 290], speed="9000 1/min")
    assert beyond == pytest.approx(2 * edge)
    found.write(tmp_path / "map")
    again = asperity.read_result(tmp_path / "map")
    assert isinstance(again, asperity.Map) and np.array_equal(again.loss_w, found.loss_w)
    assert "<svg" in found._repr_html_() and "points" in repr(found) and str(found)
    pytest.importorskip("xarray")
    data = found.to_xarray()
    assert float(data.loss_w.sel(torque_nm=50, speed_rpm=3000).squeeze()) == found.loss_w[0, 0, at[0], at[1]]
    assert found.to_pandas().loss_w.size == found.loss_w.size


def test_maps_are_exported(drive, tmp_path):
    found = asperity.map(drive, torque_nm=[-145, 145], speed=["100 1/min", "9000 1/min"], finishes={"a": GROUND, "b": FINE})
    assert found.finishes == ["a", "b"]
    files = found.export("matlab", tmp_path)
    assert [file.name for file in files] == ["a.mat", "b.mat"] and all(file.stat().st_size for file in files)
    scipy = pytest.importorskip("scipy.io")
    held = scipy.loadmat(files[1])
    assert np.array_equal(held["loss_torque_nm"], found.loss_torque_nm[1, 0]) and np.isfinite(held["efficiency"]).all()
    with pytest.raises(asperity.AsperityError) as refused:
        found.export("fastsim", tmp_path)
    assert refused.value.code == "E205"
    frame = pytest.importorskip("pandas").read_csv(found.export("wide", tmp_path)[0], index_col=0)
    assert np.array_equal(frame.to_numpy(), found.loss_torque_nm[0, 0]) and frame.index.tolist() == found.torque_nm.tolist()


def test_columns_of_arrow_and_of_xarray_are_taken(drive):
    pyarrow, xarray = pytest.importorskip("pyarrow"), pytest.importorskip("xarray")
    losses = asperity.map(drive, torque_nm=[50, 145], speed_rpm=[1000, 9000], band="none")
    columns = {"time_s": np.array([0.0, 1.0]), "torque_nm": np.array([50.0, 60.0]), "speed_rpm": np.array([2000.0, 3000.0])}
    expected = asperity.cycle(losses, columns).finishes.lost_wh
    dataset = xarray.Dataset({name: ("row", values) for name, values in columns.items()})
    for given in (pyarrow.table(columns), dataset):
        assert asperity.cycle(losses, given).finishes.lost_wh == expected


def test_a_map_is_one_tidy_table(drive, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    pyarrow = pytest.importorskip("pyarrow")
    found = asperity.map(drive, torque_nm=[50, 145], speed_rpm=[3000, 9000], temperature_c=[60, 90], finishes={"a": GROUND, "b": FINE}, band="none")
    rows = found.rows
    assert rows.columns[:5] == ["finish", "temperature_c", "torque_nm", "speed_rpm", "loss_w"] and len(rows) == found.loss_w.size
    at = (rows.finish == "b") & (rows.temperature_c == 90) & (rows.torque_nm == 50) & (rows.speed_rpm == 9000)
    place = [axis.tolist().index(value) for axis, value in ((found.temperature_c, 90), (found.torque_nm, 50), (found.speed_rpm, 9000))]
    assert rows[at].loss_w.tolist() == [found.loss_w[(1, *place)]]
    parquet.write_table(pyarrow.table(rows), tmp_path / "map.parquet")
    again = parquet.read_table(tmp_path / "map.parquet")
    assert again.column_names == list(rows.columns) and again["loss_w"].to_pylist() == rows.loss_w.tolist()


def test_columns_of_tables_that_are_not_read_are_named(drive, tmp_path):
    losses = tmp_path / "losses.csv"
    losses.write_text("speed_rpm,loss_torque_nm,Remark\n0,0.1,a\n20000,0.3,b\n")
    unread = "W454 columns of losses.csv that are not read: Remark"
    with pytest.warns(asperity.AsperityWarning, match=unread):
        drive.replace({"gearbox": {"loss_table": str(losses)}})
    found = asperity.map(drive, torque_nm=[-145, 145], speed=["100 1/min", "9000 1/min"])
    with pytest.warns(asperity.AsperityWarning, match=unread):
        assert found.export("csv", tmp_path, added=losses)
    trip = {"time_s": [0, 1], "torque_nm": [50, 60], "speed_rpm": [1000, 2000], "gear": [1, 2]}
    with pytest.warns(asperity.AsperityWarning, match="W454 columns of the cycle that are not read: gear"):
        asperity.cycle(found, trip)


def test_a_sweep_is_an_iterator(drive):
    rows = asperity.sweep(drive, {"torque_nm": [50.0, 145], "operation.speed": {"from": "1000 1/min", "to": "9000 1/min", "count": 3}})
    assert len(rows) == 6
    first = next(rows)
    assert first.case == 0 and (first.torque_nm, first.speed_rpm) == (50.0, 1000.0) and first.loss_w > 0
    assert len(list(rows)) == 6, "it begins again"
    pytest.importorskip("pandas")
    frame = rows.to_pandas()
    assert frame.loss_w.notna().all() and (frame.code.isna()).all()
    single = drive.replace({"operation.torque": "50 N m", "operation.speed": "1000 1/min"}).run("losses")
    assert frame.loss_w[0] == single.loss_w
    pytest.importorskip("xarray")
    data = rows.to_xarray()
    assert dict(data.sizes) == {"torque_nm": 2, "speed_rpm": 3}
    assert data.loss_w.attrs["units"] == "W" and data.torque_nm.attrs["units"] == "N m"
    assert float(data.loss_w.sel(torque_nm=145, speed_rpm=5000)) == frame.loss_w[4]


def test_axes_are_numbers_with_their_unit_in_the_name(drive):
    axes = {"gears.module": ["1.8 mm", "2e-3 m"], "model.positions": [4, 5], "temperature": ["60 °C", "363.15 K"]}
    rows = asperity.sweep(drive, axes, columns=["loss_w"])
    assert rows.columns == ["case", "id", "gears.module_m", "model.positions", "temperature_c", "loss_w", "outside", "code"]
    pytest.importorskip("xarray")
    sampled = {"method": "sobol", "count": 2, "seed": 1, "vary": {"surface.cutoff": {"uniform": ["0.2 mm", "0.3 mm"]}}}
    data = asperity.sweep(drive, {"torque": ["50 N m", "100 N m", "145 N m"]}, sample=sampled, columns=["loss_w"]).to_xarray()
    assert dict(data.sizes) == {"torque_nm": 3, "sample": 2} and data["surface.cutoff_m"].dims == ("torque_nm", "sample")
    assert np.all((data["surface.cutoff_m"] >= 0.2e-3) & (data["surface.cutoff_m"] <= 0.3e-3))


@pytest.mark.parametrize(
    ("axes", "code"),
    [
        ({"torque_nm": [50], "operation.speed": ["1000 1/min", "9000 1/mn"]}, "E204"),
        ({"operation.torque": [50.0]}, "E204"),
        ({"operation.torque": 50.0}, "E204"),
        ({"model.positions": [4, 4.5]}, "E204"),
        ({"operation.torqe": ["50 N m"]}, "E203"),
    ],
)
def test_values_of_axes_are_read_before_the_first_case(drive, axes, code):
    with pytest.raises(asperity.AsperityError) as refused:
        asperity.sweep(drive, axes)
    assert refused.value.code == code and next(reversed(axes)) in str(refused.value)


def test_a_sweep_goes_to_other_processes(drive, tmp_path, monkeypatch):
    (tmp_path / "case.toml").write_text((CASES / "e-drive.toml").read_text().replace("../profiles", str(PROFILES)))
    (tmp_path / "study.toml").write_text('case = "case.toml"\n[[axis]]\nkey = "model.positions"\nvalues = [4, 5]\n')
    monkeypatch.chdir(tmp_path)
    for rows in (asperity.sweep(drive, {"torque_nm": [50, 145]}), asperity.sweep(study="study.toml")):
        first = next(rows)
        copy = pickle.loads(pickle.dumps(rows))
        assert repr(copy).startswith("<Sweep: 2 of 2"), "the rows that were run are there"
        fresh = pickle.loads(pickle.dumps(type(rows)(rows._source, 1)))
        monkeypatch.chdir("/")
        assert copy.run() == rows.run() == fresh.run() and next(iter(copy)) == first
        monkeypatch.chdir(tmp_path)


def test_choices_and_samples(drive):
    rows = asperity.sweep(
        drive,
        {"finish": {"a": {"surface.pinion.file": str(GROUND)}, "b": {"surface.pinion.file": str(FINE)}}},
        sample={"method": "sobol", "count": 4, "seed": 3, "vary": {"model.boundary_friction": {"uniform": [0.06, 0.1]}}},
        columns=["loss_w"],
    ).run()
    assert len(rows) == 8 and set(rows.finish) == {"a", "b"}
    frictions = rows["model.boundary_friction"]
    assert np.all((0.06 <= frictions) & (frictions <= 0.1)) and len(set(frictions)) == 4


def test_choices_and_values_stay_in_their_order(drive, tmp_path):
    fine, rough = ({"surface.pinion.file": str(file)} for file in (FINE, GROUND))
    axes = {"finish": {"z": rough, "a": fine, "m": rough}, "lubricant.oil": ["n100", "m100"]}
    rows = asperity.sweep(drive, axes, columns=["loss_w"])
    assert rows.to_xarray().finish.values.tolist() == ["z", "a", "m"] and list(dict.fromkeys(rows.run()["lubricant.oil"])) == ["n100", "m100"]
    losses = rows.run().loss_w
    assert losses[0] == losses[4] != losses[2]
    text = 'case = "%s"\ncolumns = ["loss_w"]\n[[axis]]\nname = "finish"\n' % (CASES / "e-drive.toml")
    table = '[axis.choice.z]\n"model.positions" = 4\n[axis.choice.a]\n"model.positions" = 5\n'
    for choices in (table, 'choice.z."model.positions" = 4\nchoice.a = { "model.positions" = 5 }\n'):
        (tmp_path / "study.toml").write_text(text + choices)
        assert [text for _, texts in asperity.sweep(study=tmp_path / "study.toml")._raw.axes for text in texts] == ["z", "a"]


def test_a_file_that_an_axis_names_is_read_before_the_first_case(drive, tmp_path):
    (tmp_path / "words.csv").write_text("no numbers\n")
    for axes, code in (
        ({"surface.pinion.file": [str(GROUND), str(tmp_path / "none.csv")]}, "E103"),
        ({"finish": {"a": {"surface.pinion.file": str(GROUND)}, "b": {"surface.pinion.file": str(tmp_path / "none.csv")}}}, "E103"),
        ({"torque_nm": [20, 50], "surface.wheel.file": [str(tmp_path / "words.csv")]}, "E102"),
    ):
        with pytest.raises(asperity.AsperityError, match=str(tmp_path)) as refused:
            asperity.sweep(drive, axes)
        assert refused.value.code == code


def test_an_oil_that_the_library_does_not_have_is_refused_before_the_first_case(drive):
    with pytest.raises(asperity.AsperityError, match='no oil "m101"'):
        asperity.sweep(drive, {"lubricant.oil": ["m100", "m101"]})


def test_an_oil_replaces_the_numbers_of_the_oil_of_the_case_and_its_calibration(drive, tmp_path):
    tables = drive.inputs.to_dict()
    named = asperity.Case({**tables, "lubricant": {"oil": "m100"}}, folder=CASES)
    expected = named.run("losses").loss_w
    own = drive.replace(calibration={"boundary_friction": {"value": 0.2, "low": 0.19, "high": 0.21}})
    assert own.run("losses").loss_w != drive.run("losses").loss_w
    for changed in ({"lubricant.oil": "m100"}, {"lubricant": {"oil": "m100"}}, {"lubricant.oil": "m100", "lubricant.viscosity": None}):
        found = own.replace(changed)
        assert found.run("losses").loss_w == expected
        assert any(row.code == "W442" and row.text.startswith("m100 replaces ") and "calibration" in row.text for row in found.warnings)
    kept = own.replace({"lubricant.oil": "m100", "lubricant.density": "900 kg/m3"}).inputs
    assert kept.lubricant.to_dict() == {"oil": "m100", "density": "900 kg/m3"}, "what is named together is one oil"
    rows = asperity.sweep(drive, {"lubricant.oil": ["m100", "n100"]}).run()
    assert rows.loss_w[0] == pytest.approx(expected, rel=1e-9)


def test_a_case_without_result_is_a_row_with_its_code(drive):
    rows = list(asperity.sweep(drive, {"model.window": [6, 99]}, columns=["loss_w"], detail="contacts"))
    assert rows[0].code is None and rows[1].code == "E122" and rows[1].loss_w is None


def test_a_name_tells_heights_apart(drive):
    other = asperity.Profile(trace().heights * 2, 0.5e-6, name="waves")
    losses = [drive.replace({"surface.pinion": flank}).run("losses").loss_w for flank in (trace(), other, trace())]
    assert losses[0] == losses[2] != losses[1]


def test_an_axis_takes_what_numpy_makes_an_array_of_and_no_profile_in_memory(drive):
    pandas = pytest.importorskip("pandas")
    listed, series = (asperity.sweep(drive, {"torque_nm": of}).run() for of in ([40, 90], pandas.Series([40, 90])))
    assert listed == series and np.isfinite(listed.loss_w).all()
    profile = asperity.read_profile(PROFILES / "superfinished.csv")
    for axes in ({"surface.pinion": [profile]}, {"finish": {"fine": {"surface.pinion": profile}}}):
        with pytest.raises(asperity.AsperityError, match="a profile in memory, and a sweep reads files") as raised:
            asperity.sweep(drive, axes)
        assert raised.value.code == "E204" and "compare or map" in raised.value.help


def test_a_map_with_values_that_there_are_not_is_equal_to_itself(drive):
    found = asperity.map(drive, torque_nm=[-40, 40], speed_rpm=[500, 9000], temperature_c=[90], band="none")
    assert "NaN" in json.dumps(found.to_dict())
    assert found == found and pickle.loads(pickle.dumps(found)) == found
    other = asperity.map(drive, torque_nm=[-40, 50], speed_rpm=[500, 9000], temperature_c=[90], band="none")
    assert found != other


def test_the_bar_of_a_sweep_is_closed(drive):
    tqdm = pytest.importorskip("tqdm")
    bars = []

    class Bar(tqdm.tqdm):
        def __init__(self, *given, **more):
            super().__init__(*given, **more)
            bars.append(self)

    asperity.sweep(drive, {"torque_nm": [50, 100]}, progress=Bar).run()
    for _ in asperity.sweep(drive, {"torque_nm": [50, 100]}, progress=Bar):
        pass
    assert [(bar.n, bar.disable) for bar in bars] == [(2, True), (2, True)], "a bar that is closed is disabled"


def test_a_sample_takes_the_operating_point_as_axes_do(drive):
    rows = {}
    for name, law in (
        ("torque_nm", {"uniform": [50, 150]}), ("torque", {"uniform": ["50 N m", "150 N m"]}), ("operation.torque", {"uniform": ["50 N m", "150 N m"]}),
    ):
        rows[name] = asperity.sweep(drive, sample={"method": "sobol", "count": 2, "seed": 1, "vary": {name: law}}).run()
    assert rows["torque_nm"] == rows["torque"] == rows["operation.torque"] and all(50 < at < 150 for at in rows["torque"].torque_nm)
    warm = asperity.sweep(drive, sample={"method": "random", "count": 8, "seed": 1, "vary": {"temperature_c": {"normal": [90, 2]}}}).run()
    assert np.all(np.abs(warm.temperature_c - 90) < 10) and np.ptp(warm.temperature_c) > 0.5
    for vary in ({"torque_nm": 50}, {"torque_nm": {"uniform": 50}}, {"torque_nm": {"uniform": ["50", "60"]}}, {"torque": {"uniform": [50, 60]}}):
        with pytest.raises(asperity.AsperityError) as refused:
            asperity.sweep(drive, sample={"method": "sobol", "count": 2, "vary": vary})
        assert refused.value.code == "E204"


def test_sweeps_are_equal_by_their_content(drive):
    one = asperity.sweep(drive, {"torque_nm": [50, 100]})
    assert one == asperity.sweep(drive, {"torque": ["50 N m", "100 N m"]}) and hash(one) == hash(asperity.sweep(drive, {"torque_nm": [50, 100]}))
    assert one != asperity.sweep(drive, {"torque_nm": [50, 101]}) and one != asperity.sweep(drive, {"torque_nm": [50, 100]}, columns=["loss_w"])
    assert one != asperity.sweep(drive.with_laws(film_friction=lambda at: 0.03), {"torque_nm": [50, 100]}) and one != 3


def test_flanks_run_in_at_several_torques(drive, tmp_path):
    found = asperity.running_in(drive, torque_nm=[60, 145], engagements=100)
    assert found.courses.torque_nm.tolist() == [60, 145] and found.test is None and found.engagements == 100
    for course in found.courses:
        rows = course.rows
        assert rows.engagements.tolist() == [0, 1, 2, 5, 10, 20, 50, 100]
        for name in ("loss{}_w", "pinion_rq{}_um", "wheel_rpk{}_um", "wheel_removed{}_nm", "asperity_share{}", "film_ratio{}"):
            low, middle, high = (rows[name.format(end)] for end in ("_p05", "", "_p95"))
            assert (low <= middle).all() and (middle <= high).all() and low[-1] < high[-1], name
        assert rows.loss_w[0] == pytest.approx(found.loss_w) and course.factor == pytest.approx(rows.loss_w[-1] / found.loss_w)
        assert course.factor_p05 < course.factor < course.factor_p95 and (course.removed_mg > 0).all()
        assert rows.pinion_rq_um[-1] < rows.pinion_rq_um[0] and 0 < course.done_engagements < 100 and course.ends_at is None
    assert found.courses[1].rows.pinion_rq_um[-1] < found.courses[0].rows.pinion_rq_um[-1]
    assert "60 N m" in repr(found) and "<table" in found._repr_html_() and pickle.loads(pickle.dumps(found)) == found
    found.write(tmp_path / "out")
    assert asperity.read_result(tmp_path / "out").courses[1].rows[0].loss_w == found.courses[1].rows[0].loss_w
    frame = pytest.importorskip("pandas").read_csv(tmp_path / "out" / "running_in.csv")
    ours = found.to_pandas()
    assert len(ours) == 16 and ours.torque_nm.tolist() == frame.torque_nm.tolist() and ours.loss_p95_w.tolist() == frame.loss_p95_w.tolist()


def test_a_test_states_the_wear_of_running_in(drive, tmp_path):
    before = asperity.read_profile(GROUND).prepare()
    files = [tmp_path / "before.csv", tmp_path / "after.csv"]
    for file, profile in zip(files, [before, asperity.Profile(before.heights.clip(max=0.1e-6), before.spacing)]):
        profile.write(file)
    given = {"before": files[0], "after": [files[1]], "test_engagements": 100}
    test = asperity.running_in(drive, **given, engagements=100).test
    assert test.flank == "pinion" and test.engagements == 100 and test.rq_ratio < test.plastic_rq_ratio < 1
    low, high = test.k_quantiles_mm3_per_n_m
    assert 0 <= low < test.k_mm3_per_n_m < high


def test_a_running_in_that_cannot_be_is_refused(drive):
    for given, code, text in (
        ({"torque_nm": 0}, "E209", "torque = 0 N m: must be finite and not zero"),
        ({"torque": "145"}, "E204", "145 has no unit"),
        ({"torque": 145}, "E204", "torque_nm"),
        ({"torque_nm": [np.nan]}, "E209", "torque_nm"),
        ({"torque": "60 N m", "torque_nm": 60}, "E205", "both are given"),
        ({"engagements": 0.5}, "E209", "engagements"),
        ({"test_engagements": 1e6}, "E205", "the test has no traces"),
        ({"before": GROUND, "test_engagements": 1e6}, "E205", "traces before and after the test do not pair: 1 and 0"),
        ({"before": asperity.read_profile(GROUND), "after": GROUND}, "E204", "before: a path"),
        ({"before": "missing.csv", "after": GROUND, "test_engagements": 1e6}, "E103", "missing.csv"),
    ):
        with pytest.raises(asperity.AsperityError, match=text) as refused:
            asperity.running_in(drive, **given)
        assert refused.value.code == code, given


def test_a_trace_that_is_bowed_is_matched_with_a_bow():
    flank = asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=2)
    bowed = asperity.Profile(flank.heights.clip(max=0.3e-6) + 0.5e-6 * np.linspace(-1, 1, 8000) ** 2, flank.spacing)
    level, bent = (asperity.profile_change(flank, bowed, form=form) for form in ("level", "poly2"))
    assert level.pairs.bow_um[0] != level.pairs.bow_um[0] and bent.pairs.bow_um[0] == pytest.approx(-0.5, rel=1e-3)
    assert level.mean_with_bow.removed_nm == pytest.approx(bent.mean.removed_nm) and bent.mean_with_bow is None
