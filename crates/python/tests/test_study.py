"""The study of docs/PYTHON.md runs as it is written."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("dask")
pytest.importorskip("pandas")
pytest.importorskip("xarray")
PAGE = Path(__file__).parents[3] / "docs" / "PYTHON.md"


def test_the_study_of_the_docs_runs_as_it_is_written(tmp_path):
    text = PAGE.read_text(encoding="utf-8").split("<!-- study -->\n```python\n")[1].split("```")[0]
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
