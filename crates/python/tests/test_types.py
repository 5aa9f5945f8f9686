"""Types: the package by mypy --strict, the compiled part by stubtest, a program that uses them."""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

import asperity

pytest.importorskip("mypy")
PLACE = Path(asperity.__file__).parents[1]
CONFIGURATION = Path(__file__).parents[3] / "pyproject.toml"


@pytest.fixture
def checked(tmp_path):
    """A tool of mypy, run where nothing else lies; a package that is not installed is named to it."""
    is_installed = "site-packages" in PLACE.parts
    environment = {**os.environ, **({} if is_installed else {"MYPYPATH": str(PLACE)})}

    def run(*arguments, status=0):
        command = [sys.executable, "-m", *arguments]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, env=environment)
        assert done.returncode == status, done.stdout + done.stderr
        return done.stdout

    return run


def test_the_package_is_typed(checked):
    checked("mypy", "--strict", "--config-file", str(CONFIGURATION), "-p", "asperity")


def test_the_stub_is_that_of_the_compiled_part(checked):
    checked("mypy.stubtest", "asperity._asperity", "--ignore-disjoint-bases", "--mypy-config-file", str(CONFIGURATION))


def test_a_program_that_uses_the_package_is_typed(checked, tmp_path):
    (tmp_path / "program.py").write_text(
        "import asperity\n"
        "import numpy as np\n"
        "def loss(file: str) -> float:\n"
        "    case = asperity.Case(file).replace({'operation.torque': '20 N m'}, model={'offsets': 4}, speed_rpm=1000)\n"
        "    result: asperity.RunResult = case.run('losses', progress=lambda done, total: None)\n"
        "    heights = asperity.read_profile(file).prepare(cutoff='0.25 mm').heights\n"
        "    found = asperity.solve_contact(heights, '0.5 um', 115e9, load='200 N/mm')\n"
        "    for row in asperity.sweep(case, {'operation.speed': ['1000 1/min']}):\n"
        "        print(row.loss_w)\n"
        "    return result.loss_w + float(np.max(found.pressure))\n"
    )
    checked("mypy", "--strict", "--config-file", str(CONFIGURATION), "program.py")


MISTAKES = {
    "r.loss_watt": "attr-defined",
    'r.path["sliding_watts"]': "call-overload",
    'case.replace(**{"operation.torqe": "3 N m"})': "arg-type",
    'asperity.Case("case.toml", formulation="papr")': "arg-type",
    "asperity.map(case, speed=[1000, 9000])": "list-item",
    'asperity.map(case, torque_nm="145")': "arg-type",
    'case.replace(surface={"finish": "grinded"})': "arg-type",
    "m.loss_torque(torque_nm=3, speed_rad_s=3)": "call-arg",
    'case.replace({"operation.torqe": "3 N m"})': "arg-type",
    "case.replace(torque=3)": "call-arg",
    'asperity.calibrate("rig.csv", hold=["friction"])': "list-item",
}
BEGIN = 'import asperity\ncase = asperity.Case("case.toml")\nr = case.run()\nm = asperity.map(case)\n'


def test_mistakes_in_names_units_and_choices_are_type_errors(checked, tmp_path):
    (tmp_path / "mistakes.py").write_text(BEGIN + "".join(f"{line}\n" for line in MISTAKES))
    strict = ("mypy", "--strict", "--config-file", str(CONFIGURATION), "mistakes.py")
    first = BEGIN.count("\n") + 1
    found = {}
    for line in checked(*strict, status=1).splitlines():
        if ": error: " in line:
            found.setdefault(int(line.split(":")[1]) - first, set()).add(line.rsplit("[", 1)[1].rstrip("]"))
    assert found == {number: {kind} for number, kind in enumerate(MISTAKES.values())}


def test_the_types_of_keys_choices_and_columns_are_those_of_the_compiled_part():
    script = Path(__file__).parents[1] / "typed.py"
    specification = importlib.util.spec_from_file_location("typed", script)
    typed = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(typed)
    assert typed.written() == (PLACE / "asperity" / "keys.py").read_text(encoding="utf-8"), "run crates/python/typed.py"


def test_everything_public_is_documented():
    for name in asperity.__all__:
        thing = getattr(asperity, name)
        assert name == "__version__" or thing.__doc__, name
        if isinstance(thing, type):
            members = {key: value for key, value in vars(thing).items() if not key.startswith("_")}
            for key, value in members.items():
                assert not callable(value) and not isinstance(value, property) or value.__doc__, f"{name}.{key}"
