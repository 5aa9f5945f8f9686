"""Calibrations from the losses of a rig."""

import csv
import json
import math
import subprocess

import numpy as np
import pytest

import asperity
from conftest import PROFILES, json_of

CASE = {
    "title": "test gears",
    "gears": {"teeth": [16, 24], "module": "4.5 mm", "face_width": "14 mm", "profile_shift": [0.182, 0.172]},
    "operation": {"torque": "183.4 N m", "speed": "2166 1/min", "bulk_temperature": "90 °C"},
    "lubricant": {"oil": "m100"},
    "surface": {
        "cutoff": "0.25 mm",
        "pinion": {"file": str(PROFILES / "ground_pinion.csv")},
        "wheel": {"file": str(PROFILES / "ground_wheel.csv"), "mirrored": True},
    },
    "model": {"positions": 4, "offsets": 2, "depths": 0},
}


@pytest.fixture(scope="module")
def rig(tmp_path_factory, command):
    """A table of SIMULATED losses beside the case, and what the command finds from them."""
    folder = tmp_path_factory.mktemp("rig")
    case = folder / "case.json"
    case.write_text(json.dumps(CASE))
    axes = ("--torque", "60,183.4", "--speed", "25..4400:7:log", "--simulate", "4")
    subprocess.run([command, "design", case, *axes, "-o", folder / "design"], check=True, capture_output=True)
    table = folder / "design" / "simulated.csv"
    return table, case, json_of(command, "calibrate", table, case, "-o", folder / "found")


@pytest.fixture(scope="module")
def columns(rig):
    """The table as columns."""
    with open(rig[0], encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return {name: [row[name] for row in rows] for name in rows[0]}


@pytest.fixture(scope="module")
def found(rig):
    return asperity.calibrate(*rig[:2])


def test_a_column_that_is_not_read_is_named(rig, columns):
    with pytest.warns(asperity.AsperityWarning, match="W454 columns of .* that are not read: Remark"):
        found = asperity.calibrate({**columns, "Remark": ["cold"] * len(columns["order"])}, rig[1])
    assert "W454" in {warning["code"] for warning in found["warnings"]}


def test_tables_are_measurements(rig, columns, found):
    table = asperity.Table([dict(zip(columns, row)) for row in zip(*columns.values())])
    same = asperity.calibrate(table, rig[1])
    assert same.points == asperity.calibrate(columns, rig[1]).points and len(same.points) == len(table)


def test_a_table_gives_the_same_parameters_as_the_command(rig, found):
    ours, theirs = found.to_dict(), rig[2]
    assert ours.pop("table") == theirs.pop("table")
    assert ours == theirs and found.is_simulated
    assert list(found.parameters.key)[:2] == ["boundary_friction", "boundary_layer"]
    assert "boundary friction" in str(found) and "identified" in repr(found) and "<table" in found._repr_html_()


def test_columns_and_frames_are_taken_as_tables(rig, columns, found):
    given = {**columns, "simulated": [True] * len(columns["loss_w"])}
    told = []
    same = asperity.calibrate(given, CASE, progress=lambda done, total: told.append(done / total))
    assert same.parameters.to_dict() == found.parameters.to_dict() and same.is_simulated
    assert told and told == sorted(told)
    pandas = pytest.importorskip("pandas")
    frame = pandas.read_csv(rig[0], comment="#")
    frame["case"] = "pair"
    held = asperity.calibrate(frame, cases={"pair": CASE}, hold=["limiting_shear"])
    assert "limiting_shear" not in held.parameters.key and held.is_simulated, "pandas leaves out comments"
    assert len(held.to_pandas()) == len(frame)


def test_a_calibrated_case_has_a_narrower_band(found):
    case = asperity.Case(CASE)
    before, after = [of.run().uncertainty for of in (case, found.apply(case))]
    assert after.loss.sd_ln < before.loss.sd_ln
    old, new = [dict(zip(of.loss.parts.name, of.loss.parts.sd_ln)) for of in (before, after)]
    drawn = {row.name: row for row in after.constants if row.is_calibrated}
    written = [row for row in found.parameters if f"{row.key} = " in found.block]
    assert {"boundary_friction", "eyring_stress"} <= {row.key for row in written} and drawn.keys() == {row.name for row in written}
    for row in written:
        ends = math.log(row.range_high / row.range_low)
        assert math.log(drawn[row.name].high / drawn[row.name].low) == pytest.approx(ends, rel=0.03), row.name
        width = ends / math.log(row.default_range_high / row.default_range_low)
        # The part of a constant is its range times its slope, which moves with the values: in the logarithm the part lies
        # nearer to what the new range makes of it than to what it was. The draws do not resolve a smaller part than their error.
        is_resolved = old[row.name] > before.interpolation_error
        assert width < 1 and (new[row.name] < math.sqrt(width) * old[row.name] or not is_resolved), row.name
    assert sum(old[row.name] > before.interpolation_error for row in written) >= 2


def test_a_calibration_is_written_as_by_the_command(found, tmp_path):
    found.write(tmp_path / "out")
    assert (tmp_path / "out" / "calibration.toml").read_text() == found.block
    assert asperity.read_result(tmp_path / "out").to_dict() == found.to_dict()


def test_what_a_table_lacks_is_named(rig, columns, tmp_path):
    def refused(code, says, *given, **more):
        with pytest.raises(asperity.AsperityError, match=says) as error:
            asperity.calibrate(*given, **more)
        assert error.value.code == code and error.value.help

    refused("E103", "cannot be read", tmp_path / "no.csv", CASE)
    refused("E134", "names no case", rig[0])
    refused("E134", "sigma_w", {name: values for name, values in columns.items() if name != "sigma_w"}, CASE)
    refused("E134", "differ in length", {**columns, "run": ["1"]}, CASE)
    refused("E204", "hold: unknown variant `friction`, expected one of `boundary_friction`", rig[0], CASE, hold=["friction"])
    far = [str(3 * float(loss)) if line == 0 else loss for line, loss in enumerate(columns["loss_w"])]
    refused("E135", "ten sigma", {**columns, "loss_w": far}, CASE)
    two = {name: values[:2] for name, values in columns.items()}
    refused("E316", "2 rows for 3 parameters", two, CASE)
    others = ["boundary_friction", "limiting_shear", "eyring_stress"]
    refused("E310", "these 2 points do not identify the boundary layer", two, CASE, hold=others)


def test_points_at_one_temperature_hold_the_boundary_layer(rig, columns):
    cold = [row for row, at in enumerate(columns["temperature_c"]) if at == columns["temperature_c"][0]]
    one = {name: [values[row] for row in cold] for name, values in columns.items()}
    with pytest.warns(asperity.AsperityWarning, match="W436 the boundary layer is fixed, .* temperature: only"):
        found = asperity.calibrate(one, CASE)
    assert list(found.parameters.key) == ["boundary_friction", "limiting_shear", "eyring_stress"]
    assert found.parameters.unit.tolist() == ["", "", "Pa"]


def test_the_table_of_a_design_is_measurements_marked_as_simulated(rig):
    case = asperity.Case(rig[1])
    axes = {"torque_nm": [60, 183.4], "speed": "25..4400:7:log 1/min"}
    table = asperity.design(case, **axes, simulate=4).table
    assert table.simulated.all() and np.isfinite(table.loss_w).all()
    found = asperity.calibrate(table, case)
    assert found.is_simulated and found.parameters == asperity.calibrate(rig[0], rig[1]).parameters
    empty = asperity.design(case, **axes).table
    assert len(empty) == len(table) and np.isnan(empty.loss_w).all() and not empty.simulated.any()
