"""A value of a study is one value in Python, on the terminal, on the page, and in the JSON and tables of the command."""

import json
import subprocess

import jsonschema
import numpy as np
import pytest

import asperity
from asperity import _asperity
from conftest import CASES, PROFILES

E_DRIVE = CASES / "e-drive.toml"
FEW = {"positions": 3, "offsets": 2}
KEYS = [f"--set=model.{name}={value}" for name, value in FEW.items()]
LOAD_SHARE = "--set=model.load_share=zhu-hu"
FINISHES = {name: (PROFILES / f"{name}_pinion.csv", PROFILES / f"{name}_wheel.csv") for name in ("ground", "ground_fine")}
OPTIONS = [f"--finish={name}={pinion},{wheel}" for name, (pinion, wheel) in FINISHES.items()]
MAP = ["--torque=-100,40,100", "--speed=500,9000", "--temperature=60,90"]
TRACE = "time_s,torque_nm,speed_rpm\n0,40,500\n30,90,4000\n60,60,3000\n"
RIG = """
title = "test gears"
gears = { teeth = [16, 24], module = "4.5 mm", face_width = "14 mm", profile_shift = [0.182, 0.172] }
operation = { torque = "183.4 N m", speed = "2166 1/min", bulk_temperature = "90 °C" }
lubricant = { oil = "m100" }
model = { positions = 4, offsets = 2, depths = 0 }
[surface]
cutoff = "0.25 mm"
pinion = { file = "%s" }
wheel = { file = "%s", mirrored = true }
"""
TORQUES, SPEEDS = [60.0, 183.4], "25..4400:7:log"
STRIBECK = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,rubbing_s,traction\n" + "".join(
    f"50,{0.002 * 1.5**k},50,120,{rubbing},{0.11 - 0.02 * rubbing / 3600 - 0.0005 * k}\n" for rubbing in (0, 3600) for k in range(12)
)


def few(**model):
    return asperity.Case(E_DRIVE, model={**FEW, **model})


STUDIES = {
    "compare": ([E_DRIVE, *OPTIONS, *KEYS], lambda at: asperity.compare(few(), FINISHES)),
    "map": (
        [E_DRIVE, *OPTIONS, *KEYS, *MAP, "--cycle", "trace.csv", "--export", "csv,fastsim"],
        lambda at: asperity.map(
            few(), finishes=FINISHES, torque_nm=[-100, 40, 100], speed_rpm=[500, 9000], temperature_c=[60, 90],
            cycle=at / "trace.csv", export=["csv", "fastsim"],
        ),
    ),
    "cycle": (
        ["map", "trace.csv", "--temperature", "90"],
        lambda at: asperity.cycle(asperity.read_map(at / "map"), at / "trace.csv", temperature="363.15 K"),
    ),
    "callout": (
        [E_DRIVE, *KEYS, LOAD_SHARE, "--loss", "600 W", "--lots", "20"],
        lambda at: asperity.callout(few(load_share="zhu-hu"), "600 W", lots=20),
    ),
    "running_in": (
        [E_DRIVE, *KEYS, "--torque=60 N m,145 N m", "--engagements=50"],
        lambda at: asperity.running_in(few(), torque_nm=[60, 145], engagements=50),
    ),
    "evidence": ([E_DRIVE, *KEYS, "--hours", "traction-plan=3"], lambda at: asperity.evidence(few(), hours={"traction-plan": 3})),
    "design": (
        ["rig.toml", "--torque", "60,183.4", "--speed", SPEEDS, "--simulate", "4"],
        lambda at: asperity.design(at / "rig.toml", torque_nm=TORQUES, speed=f"{SPEEDS} 1/min", simulate=4),
    ),
    "calibrate": (
        ["design/simulated.csv", "rig.toml", "--hold", "limiting-shear"],
        lambda at: asperity.calibrate("design/simulated.csv", at / "rig.toml", hold=["limiting_shear"]),
    ),
    "profile_change": (
        [PROFILES / "ground_pinion.csv", "worn.csv", "--case", E_DRIVE, *KEYS, "--engagements", "1e6"],
        lambda _: asperity.profile_change(PROFILES / "ground_pinion.csv", "worn.csv", few(), engagements=1e6),
    ),
    "oil_traction": (["m100", "--load", "20 N"], lambda at: asperity.oil_traction("m100", load="20 N")),
    "oil_plan": (["--oil", "m100", "--simulate", "1"], lambda at: asperity.oil_plan("m100", simulate=1)),
    "oil_fit": (["oil_plan/simulated.csv", "--oil", "m100"], lambda at: asperity.oil_fit("oil_plan/simulated.csv", "m100")),
    "stribeck": (["stribeck.csv", "--oil", "m100"], lambda at: asperity.stribeck("stribeck.csv", "m100")),
}
"""Arguments of the command, and the same study in Python; a study may read what one before it wrote. A study of a case that needs
no settings is run without any."""
REGISTRY = {study["function"]: study for study in json.loads(_asperity.studies())}


def test_no_entry_is_of_another_study():
    assert STUDIES.keys() <= REGISTRY.keys()


@pytest.fixture(scope="module")
def at(tmp_path_factory):
    """A folder of inputs, in which each study writes a folder of its name."""
    folder = tmp_path_factory.mktemp("faces")
    (folder / "trace.csv").write_text(TRACE)
    (folder / "stribeck.csv").write_text(STRIBECK)
    ground = asperity.read_profile(PROFILES / "ground_pinion.csv")
    around = np.convolve(np.pad(ground.heights, 250, mode="edge"), np.full(501, 1 / 501), mode="valid")
    worn = np.minimum(ground.heights, around + 0.3e-6)
    asperity.Profile(worn[200:], ground.spacing).write(folder / "worn.csv")
    (folder / "rig.toml").write_text(RIG % (PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"))
    return folder


@pytest.mark.filterwarnings("ignore::asperity.AsperityWarning")
@pytest.mark.parametrize("name", sorted(REGISTRY, key=[*STUDIES, *REGISTRY].index))
def test_a_study_has_one_value_on_every_face(name, at, command, monkeypatch):
    monkeypatch.chdir(at)
    arguments, call = STUDIES.get(name, ([E_DRIVE, *KEYS], lambda _: getattr(asperity, name)(few())))
    words = [command, *REGISTRY[name]["command"].split(), *map(str, arguments), "-o", name, "--notes"]
    printed = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    stated, run = [], _asperity.study

    def noted(name, given, settings, *more):
        stated.append({name: json.loads(settings)})
        return run(name, given, settings, *more)

    monkeypatch.setattr(_asperity, "study", noted)
    found = call(at)
    # The settings that the package writes are those of the schema.
    schema = asperity.schema("settings")
    jsonschema.validators.validator_for(schema).check_schema(schema)
    jsonschema.validate(stated[-1], schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({name: {**stated[-1][name], "unknown": 1}}, schema)
    # The terminal has the digits of the summary.
    assert printed.endswith(f"{found}wrote {name}\n")
    # Page, tables and JSON are the same to the last digit, and the values are those of the JSON.
    ours = at / f"{name} of Python"
    found.write(ours)
    files = {place: {file.relative_to(place): file.read_bytes() for file in place.rglob("*") if file.is_file()} for place in (ours, at / name)}
    assert files[ours] == files[at / name]
    (json_file,) = [content for file, content in files[ours].items() if file.suffix == ".json" and file.with_suffix(".html") in files[ours]]
    values = json.loads(json_file)
    assert {key: value for key, value in found.to_dict().items() if key in values} == values
    back = asperity.read_result(ours).to_dict()
    assert {key: back[key] for key in values} == values
