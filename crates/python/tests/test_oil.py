"""Oils: traction, constants from curves, plans, boundary friction."""

import json

import pytest

import asperity
from asperity import AsperityError
from conftest import json_of, small

COLUMNS = ("load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction")


@pytest.fixture(scope="module")
def curves():
    """Predicted curves as measured ones."""
    predicted = asperity.oil_traction("m100")
    return {name: list(predicted.over_slide[name]) for name in COLUMNS}


def rubbed(speed):
    return {
        "load_n": [50.0] * len(speed), "mean_speed_m_s": speed, "slide_roll_percent": [50.0] * len(speed),
        "temperature_c": [120.0] * len(speed), "traction": [0.117] * len(speed), "rubbing_s": [7200.0] * len(speed),
    }


def test_traction_is_that_of_the_command(command, tmp_path):
    ours = asperity.oil_traction("m100", temperature_c=[40, 100])
    theirs = json_of(command, "oil", "traction", "m100", "--temperature", "40,100", "-o", tmp_path / "out")
    assert ours.to_dict() == theirs and "m100" in repr(ours) and "film over" in str(ours) and "<table" in ours._repr_html_()
    ours.write(tmp_path / "ours")
    assert (tmp_path / "ours" / "traction.html").is_file()
    assert "m100" in asperity.oils().name


def test_curves_give_the_constants_back(curves):
    found = asperity.oil_fit(curves, "m100")
    for one in found.constants:
        assert one.value == pytest.approx(one.prior, rel=1e-3, abs=1e-5)
    assert found.pressure_law == "barus" and "errors are too large" in str(found) and "<table" in found._repr_html_()
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(curves)
    cold = frame[frame.temperature_c == 40.0]
    both = asperity.oil_fit([cold, frame[frame.temperature_c > 40.0]], "m100", zero="none")
    assert len(both.to_pandas()) == len(frame)
    assert [name for name, _ in both["sources"]] == ["curves 1", "curves 2"]
    table = asperity.Table([dict(zip(curves, row)) for row in zip(*curves.values())])
    assert asperity.oil_fit(table, "m100") == found == asperity.oil_fit(table[list(COLUMNS)], "m100")


def test_a_plan_narrows_the_loss_of_a_case(command, tmp_path):
    plan = asperity.oil_plan(asperity.Case(small()))
    loss = list(plan.stages.loss_sd_ln)
    assert loss[0] > 3 * loss[1] > 3 * loss[3] and len(plan.chosen) == 10
    assert len(plan.to_pandas()) == 100 and "<table" in plan._repr_html_()
    same = json_of(command, "oil", "plan", "--oil", "m100", "-o", tmp_path / "out")
    assert asperity.oil_plan("m100").to_dict() == same


def test_stribeck_curves_give_a_boundary_friction():
    slow = rubbed([0.002, 0.003, 0.004, 0.005])
    found = asperity.stribeck(slow, "m100")
    assert found.boundary_friction == pytest.approx(0.117) and found.range[0] < 0.117 < found.range[1]
    without = {name: values for name, values in slow.items() if name != "rubbing_s"}
    assert asperity.stribeck([without], "m100", rubbing=["2 h"]).states.to_dict() == found.states.to_dict()
    case = found.apply(small())
    assert json.loads(json.dumps(case.to_dict()))["calibration"]["boundary_friction"]["value"] == pytest.approx(0.117)
    assert "boundary friction" in found._repr_html_() and len(found.to_pandas()) == 4


def test_a_column_that_is_not_read_is_named(curves):
    unread = "W454 columns of .* that are not read: Remark"
    with pytest.warns(asperity.AsperityWarning, match=unread):
        asperity.oil_fit({**curves, "Remark": ["a"] * len(curves["load_n"])}, "m100")
    slow = rubbed([0.002, 0.003, 0.004, 0.005])
    with pytest.warns(asperity.AsperityWarning, match=unread):
        found = asperity.stribeck({**slow, "Remark": ["a"] * 4}, "m100")
    assert [warning["code"] for warning in found["warnings"]].count("W454") == 1


def test_what_gives_no_constants_is_named(curves):
    def refused(code, says, function, *given, **more):
        with pytest.raises(AsperityError, match=says) as error:
            function(*given, **more)
        # The message of E205 says itself what to do.
        assert error.value.code == code and (error.value.help or code == "E205")

    refused("E317", "traction is missing", asperity.oil_fit, {"load_n": [30], "mean_speed_m_s": [2], "slide_roll_percent": [1], "temperature_c": [40]}, "m100")
    refused("E317", "differ in length", asperity.oil_fit, {**curves, "load_n": [30.0]}, "m100")
    refused("E318", "at least 6", asperity.oil_fit, {name: values[:3] for name, values in curves.items()}, "m100")
    refused("E204", "zero: unknown variant `some`, expected one of `curve`, `common`, `none`", asperity.oil_fit, curves, "m100", zero="some")
    refused("E204", "temperature_column: unknown variant `air`, expected `lube` or `pot`", asperity.oil_fit, curves, "m100", temperature_column="air")
    refused("E209", "below 1", asperity.oil_fit, curves, "m100", point_sd=0)
    refused("E209", "at least one", asperity.oil_traction, "m100", temperature_c=[])
    refused("E319", "machine would have to", asperity.oil_fit, {**curves, "traction": [3 * mu for mu in curves["traction"]]}, "m100")
    refused("E205", "one time for each", asperity.stribeck, curves, "m100", rubbing=["1 s", "2 s"])
    refused("E322", "time of rubbing", asperity.stribeck, curves, "m100")
