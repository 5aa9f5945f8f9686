"""What an installation says, and what the documentation says about it."""

import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


def test_a_build_says_that_it_compiles_and_how_long(capsys, monkeypatch):
    pytest.importorskip("maturin")
    specification = importlib.util.spec_from_file_location("build_backend", ROOT / "crates" / "python" / "build_backend.py")
    backend = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(backend)
    done = []
    monkeypatch.setenv("MATURIN_PEP517_ARGS", "")
    monkeypatch.setattr(backend.maturin, "build_wheel", lambda *arguments: done.append(arguments) or "a.whl")
    assert backend.build_wheel("folder") == "a.whl" and done == [("folder", None, None)]
    said = capsys.readouterr().out.strip()
    assert said == backend.NOTE and "compiling" in said
    assert len(re.findall(r"(\d+) minutes", said)) == 2


def test_the_page_is_short():
    assert len((ROOT / "docs" / "PYTHON.md").read_text(encoding="utf-8").split()) <= 1300
