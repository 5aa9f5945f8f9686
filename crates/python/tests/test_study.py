"""The optimiser of docs/PYTHON.md and the study of docs/notebooks run as they are written."""

import os
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

import asperity
from conftest import CASES

pytest.importorskip("dask")
pytest.importorskip("pandas")
pytest.importorskip("xarray")
DOCS = Path(__file__).parents[3] / "docs"


def test_the_optimiser_of_the_docs_finds_its_temperature(tmp_path, monkeypatch, capsys):
    pytest.importorskip("scipy")
    text = (DOCS / "PYTHON.md").read_text(encoding="utf-8").split("<!-- optimiser -->\n```python\n")[1].split("```")[0]
    monkeypatch.chdir(tmp_path)
    names = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.AsperityWarning)
        exec(text, names)
        assert names["loss"](float(capsys.readouterr().out)) == pytest.approx(700.0, abs=0.01)


@pytest.mark.parametrize(("name", "value", "scatters"), [("temperature_c", 90.0, 5e-6), ("speed_rpm", 9000.0, 1e-6), ("torque_nm", 145.0, 1e-3)])
def test_a_loss_is_as_smooth_as_the_docs_say(name, value, scatters):
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 4})
    steps = np.arange(-6, 7)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.AsperityWarning)
        losses = np.array([case.replace(**{name: value * (1 + 1e-3 * step)}).run("losses").loss_w for step in steps])
    rest = losses - np.polyval(np.polyfit(steps, losses, 2), steps)
    assert rest.std() / losses[6] < scatters


def test_the_study_of_the_docs_runs_as_it_is_written(tmp_path):
    text = (DOCS / "notebooks" / "study.py").read_text(encoding="utf-8")
    assert len([line for line in text.splitlines() if line.strip()]) <= 80
    (tmp_path / "study.py").write_text(text, encoding="utf-8")
    environment = {**os.environ, "PYTHONWARNINGS": "ignore"}
    run = subprocess.run([sys.executable, "study.py"], cwd=tmp_path, capture_output=True, text=True, env=environment, timeout=500)
    assert run.returncode == 0, run.stderr
    lines = run.stdout.splitlines()
    own, usual = map(float, next(line for line in lines if len(line.split()) == 2 and "." in line and "[" not in line).split())
    assert own != usual and 0 < own < 2000
    low, middle, high = map(float, lines[-1].strip("()").split(","))
    assert low < middle < high and middle == own, "Dask and this process compute the same"
