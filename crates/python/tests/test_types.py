"""Types: the package by mypy --strict, the compiled part by stubtest, a program that uses them."""

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

    def run(*arguments):
        command = [sys.executable, "-m", *arguments]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stdout + done.stderr

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
        "    case = asperity.Case(file).replace({'operation.torque': 20.0}, model={'offsets': 4})\n"
        "    result: asperity.RunResult = case.run('losses', progress=lambda done, total: None)\n"
        "    heights = asperity.read_profile(file).prepare(cutoff='0.25 mm').heights\n"
        "    found = asperity.solve_contact(heights, '0.5 um', 115e9, load='200 N/mm')\n"
        "    for row in asperity.sweep(case, {'operation.speed': ['1000 1/min']}):\n"
        "        print(row.loss_w)\n"
        "    return result.loss_w + float(np.max(found.pressure))\n"
    )
    checked("mypy", "--strict", "--config-file", str(CONFIGURATION), "program.py")


def test_everything_public_is_documented():
    for name in asperity.__all__:
        thing = getattr(asperity, name)
        assert name == "__version__" or thing.__doc__, name
        if isinstance(thing, type):
            members = {key: value for key, value in vars(thing).items() if not key.startswith("_")}
            for key, value in members.items():
                assert not callable(value) and not isinstance(value, property) or value.__doc__, f"{name}.{key}"
