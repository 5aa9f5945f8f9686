"""Every command has a function in Python, with the numbers of the command."""

import json
import pickle
import subprocess

import numpy as np
import pytest

import asperity
from asperity import AsperityError, _asperity
from conftest import CASES, PROFILES, ROOT, json_of, small

FEW = {"positions": 4, "offsets": 4}
KEYS = [f"--set=model.{name}={value}" for name, value in FEW.items()]

TWINS = {
    "run": "Case", "report": "read_result", "check": "Case", "list": "oils",
    "case": "from_rexs", "sweep": "sweep", "gear": "Case", "contact": "solve_contact",
    "ehl": "ehl", "film": "Case", "profile": "read_profile", "explain": "explain", "demo": "demo", "schema": "schema",
    **{study["command"].split()[0]: study["function"] for study in json.loads(_asperity.studies())},
}
WITHOUT = {"new", "figures", "completions", "equations"}


def test_every_command_has_a_twin_or_needs_none(command):
    text = subprocess.run([command, "--help"], capture_output=True, text=True, check=True).stdout
    listed = text.split("Usage:")[1].split("Options:")[0].splitlines()
    commands = {line.split()[0] for line in listed if line.startswith("  ") and not line.startswith("   ")}
    assert commands == set(TWINS) | WITHOUT
    import asperity.keys  # noqa: F401

    assert all(hasattr(asperity, name) for name in TWINS.values())


@pytest.mark.parametrize("library", ["gears", "steels", "oils"])
def test_the_library_is_that_of_the_command(library, command):
    expected = json_of(command, "list", library)[library]
    rows = getattr(asperity, library)()
    assert rows.to_dict() == expected and len(rows) > 3
    first = expected[0]["name"]
    assert getattr(asperity, library)(first.upper()).to_dict() == expected[0]
    with pytest.raises(AsperityError, match="the library has no") as refused:
        getattr(asperity, library)(first + "x")
    assert refused.value.code == "E220" and "Did you mean" in str(refused.value)


@pytest.mark.parametrize(("options", "given"), [([], {}), (["--paper"], {"paper": True}), (["--gears", "fzg-c"], {"gears": "fzg-c"})])
def test_a_demo_is_that_of_the_command(options, given, command, tmp_path):
    subprocess.run([command, "demo", tmp_path / "theirs", *options, "--quiet"], check=True)
    case = asperity.demo(tmp_path / "ours", **given)
    assert case == tmp_path / "ours" / "case.toml" and asperity.Case(case).title
    ours, theirs = ({file.name: file.read_bytes() for file in (tmp_path / name).iterdir()} for name in ("ours", "theirs"))
    assert ours == theirs
    assert asperity.demo(tmp_path / "ours", **given) == case, "it is there as it is written"
    with pytest.raises(AsperityError) as refused:
        asperity.demo(tmp_path / "third", gears="fzg-q")
    assert refused.value.code == "E220"


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    """The demo with a map that was drawn, in its folder."""
    folder = tmp_path_factory.mktemp("cycle") / "demo"
    case = asperity.Case(asperity.demo(folder), model=FEW)
    found = asperity.map(case, torque_nm=[-200, -60, -20, 20, 60, 200], speed_rpm=[500, 4000, 16000])
    found.write(folder / "map")
    return folder, found


def test_a_cycle_is_that_of_the_command(drive, command, tmp_path):
    folder, found = drive
    expected = json_of(command, "cycle", folder / "map", folder / "urban.csv", "--set", "vehicle.mass=1700 kg", "-o", tmp_path / "out")
    energies = asperity.cycle(found, folder / "urban.csv", vehicle={"mass": "1700 kg"})
    assert energies.to_dict() == expected and energies.finishes.name[0]
    energies.write(tmp_path / "ours")
    assert (tmp_path / "ours" / "cycle.json").read_bytes() == (tmp_path / "out" / "cycle.json").read_bytes()
    header, *rows = [line.split(",") for line in (folder / "urban.csv").read_text().splitlines() if not line.startswith("#")]
    columns = {name: [row[number] for row in rows] for number, name in enumerate(header)}
    by_columns = asperity.cycle(found, columns, vehicle={"mass": "1700 kg"})
    assert by_columns.to_dict()["finishes"] == expected["finishes"]
    assert [[row.lost_p05_wh, row.lost_p95_wh] for row in by_columns.finishes] == [row["lost_quantiles_wh"] for row in expected["finishes"]]
    table = asperity.Table([dict(zip(header, row)) for row in rows])
    assert asperity.cycle(found, table, vehicle={"mass": "1700 kg"}) == by_columns
    with pytest.raises(AsperityError) as refused:
        asperity.cycle(found, {"time_s": [0, 1, 2], "torque_nm": [900, 900, 900], "speed_rpm": [3000, 3000, 3000]})
    assert refused.value.code == "E314"
    with pytest.raises(AsperityError) as refused:
        asperity.cycle(found, {"time_s": [0, 1], "torque": [1, 2]})
    assert refused.value.code == "E101"


def test_measurements_and_designs_are_those_of_the_command(command, tmp_path):
    file = CASES / "e-drive.toml"
    case = asperity.Case(file, model=FEW)
    expected = json_of(command, "evidence", file, *KEYS, "--hours", "traction-plan=3", "-o", tmp_path / "evidence")
    table = asperity.evidence(case, hours={"traction-plan": 3})
    assert table.to_dict() == expected and len(table.rows) > 2
    with pytest.raises(AsperityError, match='no measurement is called "guess"') as refused:
        asperity.evidence(case, hours={"guess": 1})
    assert refused.value.code == "E209"
    with pytest.raises(AsperityError, match="no interval") as refused:
        asperity.evidence(asperity.Case(file, formulation="paper"))
    assert refused.value.code == "E205"
    found = asperity.ridges(case)
    assert found.to_dict() == json_of(command, "ridges", file, *KEYS, "-o", tmp_path / "ridges")
    assert found.rows[0]["low_w"] < found.rows[0]["mean_gradient_w"] < found.rows[0]["high_w"]
    assert found.rows[0]["first_order_w"] >= found.rows[1]["first_order_w"] and len(found.octaves) > 5
    assert pickle.loads(pickle.dumps(found)) == found
    with pytest.raises(AsperityError) as refused:
        asperity.ridges(asperity.Case(file, formulation="paper"))
    assert refused.value.code == "E205"
    given = {"lots": 20, "parameter": "rq", "traces": 3, "confidence": 0.8}
    stated = [f"--{name}={value}" for name, value in given.items()]
    few = asperity.Case(file, model={"positions": 2})
    found = asperity.callout(few, "600 W", **given)
    output = ["-o", tmp_path / "callout"]
    assert found.to_dict() == json_of(command, "callout", file, "--set=model.positions=2", "--loss", "600 W", *stated, *output)
    assert found.traces == 3 and found.limits[0]["limit"] < found.limits[0]["recipe"]
    for loss, wrong, code in ("300 W", {}, "E323"), ("3 kW", {}, "E323"), ("600 W", {"scatter": 0.9}, "E209"):
        with pytest.raises(AsperityError) as refused:
            asperity.callout(few, loss, **wrong)
        assert refused.value.code == code
    limits = ["--hours", "4", "--torque-max", "180", "--speed-max", "3000", "--temperature", "40,90"]
    expected = json_of(command, "design", file, *KEYS, *limits, "-o", tmp_path / "design")
    plan = asperity.design(case, hours=4, torque_max_nm=180, speed_max_rpm=3000, temperature_c=[40, 90])
    assert plan.to_dict() == expected and len(plan.to_pandas()) == len(plan.points)
    for wrong in ({"torque_max_nm": -1}, {"sigma": float("nan")}, {"hours": 0}, {"speed_rpm": [[1, 2]]}):
        with pytest.raises(AsperityError) as refused:
            asperity.design(case, **wrong)
        assert refused.value.code == "E209"


def test_differences_name_the_changed_key_and_what_follows():
    case = asperity.Case(CASES / "e-drive.toml", model=FEW)
    results = [case.replace(torque_nm=torque).run(band=False) for torque in (100, 145)]
    found = results[0].diff(results[1]).to_dict()
    assert [change["key"] for change in found["inputs"]] == ["operation.torque"]
    assert {"loss_w", "efficiency"} <= {change["key"] for change in found["summary"]} and found["path"]


def test_a_gearbox_file_makes_the_case_of_the_command(command, tmp_path):
    rexs = ROOT / "crates" / "rexs" / "tests" / "gearboxes" / "chain.rexs"
    trace = PROFILES / "ground_pinion.csv"
    subprocess.run([command, "case", "from-rexs", rexs, "--stage", "1", "--pinion", trace, "-o", tmp_path / "case.toml", "--quiet"], check=True)
    made = asperity.from_rexs(rexs, pinion=trace)
    assert made.toml == (tmp_path / "case.toml").read_text()
    assert made.case.run("losses").loss_w == asperity.Case(tmp_path / "case.toml").run("losses").loss_w
    assert pickle.loads(pickle.dumps(made)).case.to_dict() == made.case.to_dict()
    with pytest.raises(AsperityError) as refused:
        asperity.from_rexs(rexs, stage=99)
    assert refused.value.code == "E133"
    (tmp_path / "bad.rexs").write_text("gears")
    with pytest.raises(AsperityError) as refused:
        asperity.from_rexs(tmp_path / "bad.rexs")
    assert refused.value.code == "E132"


def test_the_contents_of_a_gearbox_file_are_those_of_the_command(command, tmp_path):
    folder = ROOT / "crates" / "rexs" / "tests" / "gearboxes"
    files = sorted(folder.glob("*.rexs*"))
    assert len(files) > 1
    for rexs in files:
        assert asperity.rexs_contents(rexs).to_dict() == json_of(command, "case", "from-rexs", rexs), rexs.name
    stages = asperity.rexs_contents(folder / "chain.rexs").stages
    assert list(stages.kind) == ["pair", "pair", "bevel_stage"]
    made = asperity.from_rexs(folder / "chain.rexs", stage=int(stages.stage[1]), pinion=PROFILES / "ground_pinion.csv")
    assert list(made.case.inputs.gears.teeth) == list(stages[1].teeth)
    with pytest.raises(AsperityError) as refused:
        asperity.rexs_contents(tmp_path / "absent.rexs")
    assert refused.value.code == "E103"


def test_the_oil_of_a_fit_goes_into_a_case(tmp_path):
    columns = ("load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction")
    predicted = asperity.oil_traction("m100")
    fit = asperity.oil_fit({name: list(predicted.over_slide[name]) for name in columns}, "m100")
    case = fit.apply(small(lubricant={"oil": "m100"}), tmp_path / "fit")
    by_file = asperity.Case(small(lubricant={"oil_file": str(tmp_path / "fit" / "oil.toml")}))
    assert case.run("losses").loss_w == by_file.run("losses").loss_w
    assert json.loads(json.dumps(case.to_dict()))["lubricant"]["oil_file"].endswith("oil.toml")


def test_studies_go_to_other_processes(drive, tmp_path):
    folder, found = drive
    again = pickle.loads(pickle.dumps(found))
    assert np.array_equal(again.loss_w, found.loss_w, equal_nan=True)
    place = {"torque_nm": 30, "speed_rpm": 2000}
    assert again.loss_torque(**place) == found.loss_torque(**place)
    case = asperity.Case(CASES / "e-drive.toml", model=FEW)
    ground, fine = PROFILES / "ground_pinion.csv", PROFILES / "superfinished.csv"
    for study in (asperity.compare(case, {"a": ground, "b": fine}, offsets=2), asperity.sensitivity(case),
                  asperity.cycle(found, folder / "urban.csv"), asperity.evidence(case)):
        copy = pickle.loads(pickle.dumps(study))
        assert copy == study and str(copy) == str(study) and type(copy) is type(study)
        name = type(study).__name__
        study.write(tmp_path / name)
        copy.write(tmp_path / f"{name} again")
        files = [{file.name: file.read_bytes() for file in place.iterdir()} for place in (tmp_path / name, tmp_path / f"{name} again")]
        assert set(files[0]) == set(files[1]) and sum(files[0][key] != files[1][key] for key in files[0]) <= 1
