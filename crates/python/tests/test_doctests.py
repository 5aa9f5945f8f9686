"""Every public function has its parameters, result, errors and an example, which runs as it is printed."""

import doctest
import inspect
import re
import shutil
import warnings

import numpy as np
import pytest

import asperity
from conftest import PROFILES, ROOT

PUBLIC = {name: getattr(asperity, name) for name in (*asperity.__all__, "map") if name != "__version__"}
FUNCTIONS = sorted(name for name, thing in PUBLIC.items() if inspect.isfunction(thing))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_says_what_it_takes_gives_and_raises(name):
    function = PUBLIC[name]
    text = inspect.getdoc(function)
    sections = dict(re.findall(r"^(\w+):\n((?:(?: {4}.*)?\n?)+)", text, re.M))
    entries = re.findall(r"^ {4}(\w[\w, .]*): \S", sections.get("Parameters", ""), re.M)
    listed = {part.strip() for entry in entries for part in entry.split(",")}
    given = {one.name for one in inspect.signature(function).parameters.values() if one.kind != one.VAR_KEYWORD}
    # `load, ..., pitch_line_speed` names the first and the last of many.
    assert listed - {"..."} == given or "..." in listed and listed - {"..."} <= given
    assert sections["Returns"].strip() and re.match(r" {4}\w+Error: ", sections["Raises"])
    assert list(doctest.DocTestParser().get_examples(sections["Example"])), "an example"


def examples():
    """Examples of everything public, by name."""
    finder = doctest.DocTestFinder(exclude_empty=True)
    found = {test.name: test for name, thing in PUBLIC.items() for test in finder.find(thing, name, module=False)}
    return {name: test for name, test in found.items() if test.examples}


@pytest.mark.parametrize("test", examples().values(), ids=examples())
def test_an_example_runs(test, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for file in (PROFILES / "ground_pinion.csv", ROOT / "crates" / "rexs" / "tests" / "gearboxes" / "chain.rexs"):
        shutil.copy(file, tmp_path)
    test.globs = {"asperity": asperity, "np": np}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.AsperityWarning)
        reported = []
        failed, _ = doctest.DocTestRunner(verbose=False).run(test, out=reported.append)
    assert not failed, "".join(reported)
