"""Module and command give the same numbers to the last digit."""

import json
import subprocess

import numpy as np
import pytest

import asperity
from asperity._quantity import in_numbers, si
from conftest import CASES, PROFILES, SETS, json_of

FIXTURES = sorted(file.stem for file in CASES.glob("*.toml"))
TRACES = sorted(file.name for file in PROFILES.iterdir())
assert len(FIXTURES) >= 4 and len(TRACES) >= 7


@pytest.mark.parametrize("name", FIXTURES)
def test_a_run_is_that_of_the_command(name, command):
    case = CASES / f"{name}.toml"
    expected = json_of(command, "run", case, "--no-output")
    found = asperity.Case(case).run()
    assert found.loss_w == expected["summary"]["loss_w"]
    assert json.loads(found.to_json()) == expected


@pytest.mark.parametrize("name", FIXTURES)
def test_the_losses_alone_are_those_of_the_run(name, command):
    case = CASES / f"{name}.toml"
    expected = json_of(command, "run", case, "--no-output", "--no-band")["summary"]["loss_w"]
    assert asperity.Case(case).run("losses").loss_w == expected
    assert asperity.Case(case).run("contacts").loss_w == expected


def test_every_face_of_a_case_states_one_loss():
    pytest.importorskip("pandas")
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 4})
    run = case.run()
    loss, at_medians = run.loss_w, run.summary.loss_at_medians_w
    assert at_medians == pytest.approx(case.run("losses").loss_w, rel=1e-12) and abs(loss / at_medians - 1) > 1e-4
    path = run.path
    per_m = path.film_w_per_m + path.lubricated_asperity_w_per_m + path.boundary_w_per_m + path.rolling_w_per_m
    power = (1 - run.efficiency) * run.summary.power_in_w
    for found in (run.uncertainty.loss.median_w, run.offsets.loss_w.mean(), (path.weight_m * per_m).sum(), power):
        assert found == pytest.approx(loss, rel=1e-9)
    both = asperity.compare(case, {"a": case, "b": case})
    assert both.offsets["a"].loss_w.mean() == pytest.approx(loss, rel=1e-9)
    compared = both.to_pandas()
    rows = asperity.sweep(case, {"torque_nm": [145]}, columns=["loss_w", "loss_at_medians_w", "loss_p05_w"]).to_pandas()
    losses = asperity.map(case, torque_nm=[20, 145], speed_rpm=[1000, 9000]).to_pandas().xs((145.0, 9000.0), level=("torque_nm", "speed_rpm"))
    for frame in (compared, rows, losses):
        assert frame.loss_w.iloc[0] == pytest.approx(loss, rel=1e-9) and frame.loss_at_medians_w.iloc[0] == pytest.approx(at_medians, rel=1e-9)
        assert frame.loss_p05_w.iloc[0] == pytest.approx(run.uncertainty.loss.quantiles_w[0], rel=1e-9)
    changes = asperity.sensitivity(case)
    assert (changes.loss_w, changes.loss_at_medians_w) == pytest.approx((loss, at_medians), rel=1e-9)


@pytest.mark.parametrize("kind", SETS)
def test_a_run_of_several_meshes_is_that_of_the_command(kind, command, tmp_path):
    file = tmp_path / f"{kind}.json"
    file.write_text(json.dumps(SETS[kind]))
    expected = json_of(command, "run", file, "--no-output")
    found = asperity.Case(file).run()
    assert found.loss_w == expected["loss_w"] and json.loads(found.to_json()) == expected


@pytest.mark.parametrize("name", TRACES)
def test_the_parameters_of_a_profile_are_those_of_the_command(name, command):
    file = PROFILES / name
    expected = json_of(command, "profile", "info", file)
    found = asperity.read_profile(file)
    assert dict(found.parameters()) == {
        **expected["iso4287"],
        **expected["material_ratio"],
        **expected["spectral"],
        "section_um": expected["section_um"],
    }
    newer = found.parameters(standard="iso21920")
    assert {key: newer[key] for key in expected["iso21920"]} == expected["iso21920"]
    assert {row.code for row in [*found.warnings, *found.parameters().warnings]} == {
        row["code"] for row in expected["warnings"]
    }


def test_the_regime_is_that_of_a_run():
    case = asperity.Case(CASES / "e-drive.toml")
    rows, path = case.regime(), case.run(band=False).path
    for key in ("path_fraction", "film_central_um", "lambda_star", "film_share", "mixed_share"):
        # The same sums in another order.
        np.testing.assert_allclose([getattr(row, key) for row in rows], [getattr(row, key) for row in path], rtol=1e-12)


def test_the_gears_are_those_of_the_command(command):
    case = CASES / "fzg-c.toml"
    found, printed = asperity.Case(case).gear().to_dict(), json_of(command, "gear", case)
    error, expected = found.pop("transmission_error"), printed.pop("transmission_error")
    assert found == in_numbers(printed)
    curve = [[row["phase"], row["transmission_error_um"]] for row in error["curve"]]
    np.testing.assert_allclose(curve, [[phase, 1e6 * si(text, "Length")] for phase, text in expected["curve"]], rtol=1e-14)


def test_a_map_is_that_of_the_command(command, tmp_path):
    case = CASES / "e-drive.toml"
    small = ["--set", "model.positions=4", "--set", "model.offsets=2"]
    axes = ["--torque", "20,145", "--speed", "1000,9000", "--temperature", "60,90"]
    subprocess.run([command, "map", case, *small, *axes, "-o", tmp_path / "map", "--quiet"], check=True)
    expected = asperity.read_map(tmp_path / "map").to_pandas()
    changed = asperity.Case(case, model={"positions": 4, "offsets": 2})
    found = asperity.map(
        changed,
        torque_nm=[20, 145],
        speed=["1000 1/min", "9000 rpm"],
        temperature_c=(60, 90),
        finishes=None,
    ).to_pandas()
    for name in expected.columns:
        assert found[name].equals(expected[name].set_axis(found.index)), name


def test_a_comparison_is_that_of_the_command(command, tmp_path):
    case, ground, fine = CASES / "e-drive.toml", PROFILES / "ground_pinion.csv", PROFILES / "superfinished.csv"
    finishes = [f"--finish=ground={ground}", f"--finish=fine={fine}"]
    few = ["--offsets", "4", "--set", "model.positions=4"]
    expected = json_of(command, "compare", case, *finishes, *few, "-o", tmp_path / "out")
    changed = asperity.Case(case, model={"positions": 4})
    found = asperity.compare(changed, {"ground": ground, "fine": fine}, offsets=4)
    assert found.to_dict() == expected


def test_a_sensitivity_study_is_that_of_the_command(command, tmp_path):
    few = {"positions": 4, "offsets": 4}
    keys = [f"--set=model.{name}={value}" for name, value in few.items()]
    case = CASES / "e-drive.toml"
    expected = json_of(command, "sensitivity", case, *keys, "-o", tmp_path / "out")
    found = asperity.sensitivity(asperity.Case(case, model=few))
    assert found.to_dict() == expected
    assert asperity.read_result(tmp_path / "out").to_dict() == expected
    table = found.to_pandas()
    assert len(table) == len(expected["rows"]) and table["code"].isna().all()
    assert (table["difference_w"] / expected["loss_w"] - table["change"]).abs().max() < 1e-12
    found.write(tmp_path / "again")
    assert (tmp_path / "again" / "sensitivity.csv").read_text() == (tmp_path / "out" / "sensitivity.csv").read_text()
    assert "heights of both flanks" in str(found)


def test_a_sweep_is_that_of_the_command(command, tmp_path):
    study = tmp_path / "study.toml"
    study.write_text(
        f'case = {json.dumps(str(CASES / "e-drive.toml"))}\ncolumns = ["loss_w"]\n'
        '[[axis]]\nkey = "operation.speed"\nvalues = ["3000 1/min", "9000 1/min"]\n'
        '[[axis]]\nkey = "model.positions"\nvalues = [4, 8]\n'
    )
    subprocess.run([command, "sweep", "run", study, "--quiet"], check=True)
    subprocess.run([command, "sweep", "merge", study, "-o", tmp_path / "out", "--quiet"], check=True)
    lines = (tmp_path / "out" / "sweep.csv").read_text().splitlines()
    expected = [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]
    found = list(asperity.sweep(study=study))
    assert [str(row.id) for row in found] == [row["id"] for row in expected]
    assert [row.loss_w for row in found] == [float(row["loss_w"]) for row in expected]
    alike = asperity.sweep(
        CASES / "e-drive.toml",
        {"operation.speed": ["3000 1/min", "9000 1/min"], "model.positions": [4, 8]},
        columns=["loss_w"],
    )
    assert [row.id for row in alike] == [row["id"] for row in expected]


def test_a_contact_of_the_case_is_that_of_the_command(command):
    case = CASES / "e-drive.toml"
    expected = json_of(command, "contact", case, "--position", "0.25")
    found = asperity.Case(case).contact(0.25)
    assert (found.p_max_pa, found.approach_m, found.iterations) == tuple(
        expected[key] for key in ("p_max_pa", "approach_m", "iterations")
    )


def test_the_lubricated_contact_in_time_is_that_of_the_command(command):
    case = CASES / "e-drive.toml"
    short = ["--position", "0.25", "--cells", "128", "--half-widths", "2", "--start", "0"]
    expected = json_of(command, "ehl", case, *short)
    found = asperity.ehl(case, 0.25, cells=128, half_widths=2, start=0)
    for key in ("solid_share", "mean_film_um", "central_film_um", "max_pressure_pa", "steps", "load_error"):
        assert found[key] == expected[key], key
    assert len(found["warnings"]) == len(expected["warnings"]) == 0


def test_ridges_that_cannot_leak_are_warned_about_as_by_the_command(command):
    case = CASES / "e-drive.toml"
    slow = ["--position", "0.25", "--cells", "128", "--half-widths", "1", "--start", "0"]
    expected = json_of(command, "ehl", case, *slow, "--set", "operation.speed=1000 1/min")["warnings"]
    slow_case = asperity.Case(case).replace({"operation.speed": "1000 1/min"})
    found = asperity.ehl(slow_case, 0.25, cells=128, half_widths=1, start=0)
    assert [warning["code"] for warning in found["warnings"]] == ["W415"]
    assert [warning["text"] for warning in found["warnings"]] == [expected[0]["text"]]


@pytest.mark.parametrize("name", FIXTURES)
def test_the_warnings_of_a_case_are_those_of_check(name, command):
    case = CASES / f"{name}.toml"
    assert asperity.Case(case).warnings.to_dict() == [{"code": row["code"], "text": row["text"]} for row in json_of(command, "check", case)["warnings"]]
