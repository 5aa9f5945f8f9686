"""What users of numpy, xarray and matplotlib expect."""

import copy
import io
import pickle
import warnings

import numpy as np
import pytest

import asperity
from asperity import AsperityError
from conftest import CASES, PROFILES, small, trace

LOAD, RADIUS, MODULUS = np.array([1e5, 2e5, 3e5]), 0.01, 115e9


@pytest.mark.parametrize("load", [np.array([1e5, np.nan, 3e5]), np.ma.array(LOAD, mask=[False, True, False])])
def test_laws_leave_out_what_is_missing(load):
    whole, found = asperity.hertz(LOAD, RADIUS, MODULUS), asperity.hertz(load, RADIUS, MODULUS)
    assert np.isnan(found.max_pressure).tolist() == [False, True, False]
    assert found.max_pressure[2] == whole.max_pressure[2]
    given = {"radius": RADIUS, "modulus": MODULUS, "entrainment": 5.0, "viscosity": 0.01, "pressure_viscosity": 18e-9}
    film = asperity.film_thickness(load=load, **given)
    assert np.isnan(film.central).tolist() == [False, True, False] and not film.outside[1]
    assert film.central[0] == asperity.film_thickness(load=LOAD, **given).central[0]
    assert np.isnan(asperity.hertz(np.full(2, np.nan), RADIUS, MODULUS).half_width).all()


def test_arrays_that_must_be_whole_name_the_first_place_that_is_not():
    heights = trace().heights
    heights[[77, 90]] = np.nan
    for call in (lambda: asperity.Profile(heights, 0.5e-6), lambda: asperity.solve_contact(heights, 0.5e-6, 115e9, 1e5),
                 lambda: asperity.Profile(np.ma.array(trace().heights, mask=np.isnan(heights)), 0.5e-6)):
        with pytest.raises(AsperityError, match="nan at index 77; 2 of 6000 values") as refused:
            call()
        assert refused.value.code == "E209"


def test_objects_are_read_like_files():
    path = PROFILES / "ground_pinion.csv"
    from_path = asperity.read_profile(path)
    for file in (io.BytesIO(path.read_bytes()), io.StringIO(path.read_text()), open(path, "rb")):
        with file:
            assert asperity.read_profile(file) == from_path
    case = CASES / "e-drive.toml"
    with open(case) as file:
        assert asperity.Case(file, folder=CASES) == asperity.Case(case)
    changed = asperity.Case(io.BytesIO(case.read_bytes()), folder=CASES, torque_nm=20)
    assert changed == asperity.Case(case, torque_nm=20) and changed != asperity.Case(case)


def test_a_text_that_is_no_text_is_refused():
    with pytest.raises(AsperityError, match="cannot be read") as refused:
        asperity.Case(io.BytesIO(b"\xff\xfe\x00"))
    assert refused.value.code == "E202"


def law(at):
    return 0.05


def test_a_name_that_there_is_not_is_answered_with_one_that_there_is(case, result):
    table = result.path
    for error, call in (
        (AttributeError, lambda: result.losses_w),
        (KeyError, lambda: result.summary["losses_w"]),
        (AttributeError, lambda: table.mixed_shar),
        (KeyError, lambda: table["mixed_shar"]),
        (KeyError, lambda: table[["position", "mixed_shar"]]),
        (AsperityError, lambda: case.replace(torqe_nm=3)),
        (AsperityError, lambda: case.replace(temprature="90 °C")),
        (AsperityError, lambda: case.replace({"gears.modul": "3 mm"})),
        (AsperityError, lambda: case.replace(temp_c=90)),
        (AsperityError, lambda: asperity.Case(small(temp_c=90))),
        (AsperityError, lambda: asperity.sweep(case, {"temp_c": [90]})),
        (KeyError, lambda: trace().parameters()["Rq"]),
        (AttributeError, lambda: trace().parameters().Rq),
    ):
        with pytest.raises(error, match="Did you mean ['\"](loss_w|mixed_share|torque_nm|temperature|temperature_c|module|rq_um)['\"]"):
            call()
    assert "it is an attribute, .loss_w" in str(pytest.raises(KeyError, lambda: result["loss_w"]).value)
    assert trace().parameters().get("Rq") is None
    assert "sliding_m_per_s" in str(pytest.raises(KeyError, lambda: table["nothing"]).value)
    assert "no interval drawn" in repr(case.run("losses")) and case.replace(surface=small()["surface"]) == case


def test_a_range_is_the_same_text_in_maps_and_sweeps(case):
    text = "20..90:3:log N m"
    nodes = asperity.map(case, torque=text, speed_rpm=[1000, 9000], band="none").torque_nm.tolist()
    for axis in ("torque", "operation.torque"):
        assert [row.torque_nm for row in asperity.sweep(case, {axis: text})] == nodes
    with pytest.raises(AsperityError, match="20..90.*is not an axis"):
        asperity.sweep(case, {"torque": "20..90 N m"})


def test_a_worked_case_is_written_once(tmp_path):
    file = asperity.demo(tmp_path / "demo")
    assert asperity.demo(tmp_path / "demo") == file
    file.write_text(file.read_text().replace("145 N m", "140 N m"))
    with pytest.raises(AsperityError, match="Name another folder") as error:
        asperity.demo(tmp_path / "demo")
    assert error.value.code == "E401"


def test_one_code_is_silenced_as_the_docs_say(case):
    with pytest.warns(asperity.AsperityWarning) as told:
        case.run("losses")
    code = told[0].message.code
    with warnings.catch_warnings(record=True) as left:
        warnings.simplefilter("always")
        warnings.filterwarnings("ignore", code)
        case.run("losses")
    assert code not in {one.message.code for one in left} and len(left) < len(told)


def test_all_warnings_are_silenced_by_one_line(case):
    with warnings.catch_warnings(record=True) as left:
        warnings.simplefilter("always")
        warnings.filterwarnings("ignore", category=asperity.AsperityWarning)
        case.run("losses")
        warnings.warn("another")
    assert [str(one.message) for one in left] == ["another"]


def test_an_interval_is_two_columns_of_every_table():
    rows = [{"key": "a", "band": [1.0, 2.0], "lost_quantiles_wh": [3.0, 4.0], "at": [5, 6]}, {"key": "b", "band": None, "lost_quantiles_wh": None}]
    table = asperity.Table(rows)
    assert table.columns == ["key", "band_low", "band_high", "lost_p05_wh", "lost_p95_wh", "at"]
    assert table.band_high[0] == 2.0 and np.isnan(table.lost_p05_wh[1]) and table[0].lost_p95_wh == 4.0 and table[:1][0] == table[0]
    assert rows[0]["band"] == [1.0, 2.0], "the rows that were given are as they were"


def test_equal_things_are_equal():
    assert trace() == trace() and trace() != trace().mirrored() and len({trace(), trace()}) == 1
    case = asperity.Case(small())
    assert case == asperity.Case(small()) == pickle.loads(pickle.dumps(case)) == copy.deepcopy(case)
    assert case != case.replace(torque_nm=1) and case != "case"
    assert case.with_laws(film_friction=law) == case.with_laws(film_friction=law) != case
    assert case.regime() == case.regime()
    assert case.regime()[1:3] == case.regime()[1:3] and len(case.regime()[1:3]) == 2


def test_changes_in_a_row_are_one_case_of_another_process():
    case = asperity.Case(small())
    for number in range(50):
        case = case.replace(torque_nm=100 + number, model={"offsets": 2 + number % 2})
    again = pickle.loads(pickle.dumps(case))
    assert again == case and again.inputs.operation.torque == "149 N m"


@pytest.fixture(scope="module")
def results(request):
    drive = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 2})
    run = drive.run(band=False)
    return {
        "run": run, "fields": run.fields(), "regime": drive.regime(), "contact": drive.contact(0.25), "profile": trace(),
        "map": asperity.map(drive, torque_nm=[50, 145], speed_rpm=[1000, 9000], band="none"),
        "ehl": asperity.ehl(drive, 0.25, cells=128, half_widths=1, start=0),
    }


def test_datasets_have_units_and_long_names(results):
    xarray = pytest.importorskip("xarray")
    for name, result in results.items():
        data = result.to_xarray()
        data = data.to_dataset(name="height") if isinstance(data, xarray.DataArray) else data
        for key, variable in {**data.data_vars, **data.coords}.items():
            if variable.dtype.kind in "fi":
                assert variable.attrs["units"] and variable.attrs["long_name"], (name, key)
    of_map = results["map"].to_xarray()
    assert of_map.loss_torque_nm.attrs == {"units": "N m", "long_name": "loss torque"}
    assert of_map.speed_rpm.attrs["units"] == "1/min" and of_map.temperature_c.attrs["units"] == "degC"
    along = results["run"].to_xarray()
    assert along.film_minimum_um.attrs == {"units": "um", "long_name": "film minimum"}
    assert along.sliding_w_per_m.attrs["units"] == "W/m" and along.lambda_star.attrs["units"] == "1"
    assert results["fields"].to_xarray().pressure_solid.attrs["units"] == "Pa"


def test_results_are_drawn_on_axes_of_matplotlib(results):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    for name, result in results.items():
        figure, ax = pyplot.subplots()
        assert result.plot(ax) is ax and ax.lines and ax.get_xlabel() and ax.get_ylabel(), name
        drawn = ax.lines[0].get_ydata()
        assert len(drawn) > 1 and np.isfinite(drawn).any()
        assert "<svg" in str(result.plot()) and ("<svg" in result._repr_html_()) == (name != "fields")
        pyplot.close(figure)
