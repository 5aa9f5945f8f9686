"""Types: the package by mypy --strict, the compiled part by stubtest, a program that uses them."""

import builtins
import importlib.util
import inspect
import json
import os
import re
import subprocess
import sys
import textwrap
import typing
from pathlib import Path

import pytest

import asperity
from test_doctests import examples

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
        "import asperity.keys\n"
        "import numpy as np\n"
        "def loss(file: str) -> float:\n"
        "    case = asperity.Case(file).replace({'operation.torque': '20 N m'}, model={'offsets': 4}, speed_rpm=1000)\n"
        "    result: asperity.RunResult = case.run('losses', progress=lambda done, total: None)\n"
        "    heights = asperity.read_profile(file).prepare(cutoff='0.25 mm').heights\n"
        "    found = asperity.solve_contact(heights, '0.5 um', 115e9, load='200 N/mm')\n"
        "    lubricant: asperity.keys.LubricantInput = {'viscosity': {'law': 'iso-vg', 'grade': 100, 'viscosity_index': 95}}\n"
        "    case.replace(lubricant=lubricant, gearbox={'seals': [{'shaft': 'pinion', 'diameter': '40 mm'}]})\n"
        "    case.replace(gearbox={'seals': [{'shaft': 'input shaft', 'diameter': '40 mm'}]})\n"
        "    for row in asperity.sweep(case, {'operation.speed': ['1000 1/min']}):\n"
        "        print(row.loss_w)\n"
        "    return result.loss_w + float(np.max(found.pressure))\n"
    )
    # The examples of the reference, each a function.
    bodies = ["".join(example.source for example in test.examples) for test in examples().values()]
    functions = [f"def example_{number}() -> None:\n{textwrap.indent(body, '    ')}" for number, body in enumerate(bodies)]
    (tmp_path / "examples.py").write_text("import asperity\nimport numpy as np\n" + "\n".join(functions))
    checked("mypy", "--strict", "--config-file", str(CONFIGURATION), "program.py", "examples.py")


MISTAKES = [
    "r.loss_watt",
    'r.path["sliding_watts"]',
    "r.path.film_minimum_mm",
    "r.path[0].lambda_stra",
    "r.summary.loss_kw",
    "r.loss_w = 3.0",
    'case.replace(**{"operation.torqe": "3 N m"})',
    'case.replace({"operation.torqe": "3 N m"})',
    'case.replace(surface={"finish": "grinded"})',
    "case.replace(torque=3)",
    'case.replace(torque_nm="3 N m")',
    'asperity.Case("case.toml", formulation="papr")',
    "asperity.map(case, speed=[1000, 9000])",
    'asperity.map(case, torque_nm="145")',
    "m.loss_torque(torque_nm=3, speed_rad_s=3)",
    'asperity.calibrate("rig.csv", hold=["friction"])',
    "drawn.loss.median_kw",
    "drawn.loss.interval_w",
    "drawn.loss.quantiles_w.high",
    "contact.p_max_mpa",
    'flank.parameters()["Ra"]',
    "flank.parameters().ra_nm",
    "flank[3]",
    "found.finishes.loss_watt",
    'found.finishes["losses"]',
    "found.finishes[0].loss_kw",
    "found.verdict",
    "change.rows.change_percent",
    "m.finishes.name",
    "m.rows.loss_watt",
    "energies.finishes[0].lost_kwh",
    "energies.distance_m",
    "asperity.evidence(case).rows.gain",
    "fit.constants[0].interval",
    "energies.finishes[0].lost_quantiles_wh",
    "worn.pairs[0].removed_um",
    'worn.parameters["before"]',
    "run_in.courses.loss_w",
    "run_in.courses[0].rows.loss_kw",
    "r.fields(1).von_mise",
    "contact.stress([1e-6]).sigma",
]
"""Faults: attributes and columns that there are not, assignments, misspelt keys and choices, wrong units, arguments and kinds."""
BEGIN = (
    'import asperity\ncase = asperity.Case("case.toml")\nr = case.run()\nm = asperity.map(case)\n'
    'drawn = r.uncertainty\nassert drawn is not None\ncontact = case.contact()\nfound = asperity.compare(case, {})\n'
    'change = asperity.sensitivity(case)\nenergies = asperity.cycle(m, "urban.csv")\nfit = asperity.oil_fit("curves.csv", "m100")\nflank = asperity.read_profile("flank.csv")\n'
    "worn = asperity.profile_change(flank, flank)\nrun_in = asperity.running_in(case)\n"
    "loss: float = drawn.loss.median_w + contact.p_max_pa + flank.parameters()['ra_um'] + r.path[0].film_minimum_um\n"
    "loss = found.finishes[0].loss_w + float(found.finishes.loss_w[0]) + float(m.rows['loss_w'][0]) + energies.finishes[0].lost_wh\n"
    "loss = run_in.courses[0].factor + run_in.courses[0].rows[0].loss_p05_w + float(run_in.courses[0].rows.loss_w[0])\n"
    "loss = energies.finishes[0].lost_p05_wh + worn.pairs[0].removed_p95_nm + float(worn.parameters.before_um[0])\n"
)


@pytest.fixture
def mistakes(tmp_path):
    """The file of the faults, a fault on each line after the first ones."""
    file = tmp_path / "mistakes.py"
    file.write_text(BEGIN + "".join(f"{line}\n" for line in MISTAKES))
    return file


def faults_of(lines):
    """The faults on these lines, numbered from 1."""
    first = BEGIN.count("\n") + 1
    return [MISTAKES[line - first] if line >= first else f"line {line}" for line in sorted(lines)]


def test_mypy_finds_every_fault(checked, mistakes):
    strict = ("mypy", "--strict", "--config-file", str(CONFIGURATION), mistakes.name)
    lines = {int(line.split(":")[1]) for line in checked(*strict, status=1).splitlines() if ": error: " in line}
    assert faults_of(lines) == MISTAKES


def test_pyright_finds_every_fault(mistakes):
    pytest.importorskip("pyright")
    place = {} if "site-packages" in PLACE.parts else {"extraPaths": [str(PLACE)]}
    settings = {"typeCheckingMode": "basic", "include": [mistakes.name], "reportMissingModuleSource": False, **place}
    (mistakes.parent / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable]
    done = subprocess.run(command, cwd=mistakes.parent, capture_output=True, text=True)
    found = json.loads(done.stdout)["generalDiagnostics"]
    lines = {one["range"]["start"]["line"] + 1 for one in found if one["severity"] == "error"}
    assert faults_of(lines) == MISTAKES


def test_types_are_there_at_run_time():
    hints = typing.get_type_hints(asperity.Case.run)
    assert hints["detail"] == typing.Literal["losses", "contacts", "fields"] and hints["return"] is asperity.RunResult
    optional = ("pandas", "xarray")
    for name in (*asperity.__all__, "map"):
        thing = getattr(asperity, name)
        members = {name: thing, **(vars(thing) if isinstance(thing, type) else {})}
        for function in filter(inspect.isfunction, members.values()):
            if not any(package in str(function.__annotations__.get("return")) for package in optional):
                typing.get_type_hints(function)


def test_values_of_a_run_have_their_types(case):
    found = case.run("contacts", band=True).uncertainty
    hints = {name: kind for name, kind in typing.get_type_hints(type(found)).items() if not name.startswith("_")}
    assert set(found) <= set(hints) and {name for name in hints if name not in found} <= set(found._absent)
    assert isinstance(found.loss.median_w, float) and found.loss.quantiles_w.shape == (2,)
    assert found.with_traces_w is None, "left out of the result"
    assert len(found.evidence) > 0, "as on the other faces"


def script(name):
    """A script of crates/python as a module."""
    sys.path.insert(0, str(Path(__file__).parents[1]))
    specification = importlib.util.spec_from_file_location(name, Path(__file__).parents[1] / f"{name}.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_the_types_of_keys_choices_and_columns_are_those_of_the_compiled_part():
    typed = script("typed")
    for file, text in typed.FILES.items():
        assert text() == (PLACE / "asperity" / file.name).read_text(encoding="utf-8"), "run crates/python/typed.py"


def test_tables_that_differ_by_the_kind_of_the_case_are_different_classes():
    from asperity import keys

    shafts = [table.__annotations__["shaft"].__forward_arg__ for table in (keys.BearingInput, keys.MeshBearingInput)]
    assert shafts == ["Optional[Literal['pinion', 'wheel']]", "Optional[str]"]


def test_the_reference_has_everything_public_under_its_own_heading():
    page = script("reference").written()
    outside = re.sub(r"^```.*?^```$", "", page, flags=re.DOTALL | re.MULTILINE)
    headings = re.findall(r"^#+ (.*)$", outside, flags=re.MULTILINE)
    assert {*asperity.__all__} - {"__version__"} <= {*headings}
    assert len(headings) == len({*headings})
    anchors = {re.sub(r"[^\w-]", "", heading.replace(" ", "-")).lower() for heading in headings}
    for link in re.findall(r"\]\(([^)]*)\)", re.sub(r"`[^`]*`", "", outside)):
        file, _, anchor = link.partition("#")
        assert anchor in anchors if not file else (CONFIGURATION.parent / "docs" / file).is_file(), link


def test_the_reference_explains_every_type_that_it_names():
    reference = script("reference")
    page = reference.written()
    for name in ("CaseLike", "Finish", "Quantity"):
        assert f"| `{name}` |" in page
    assert "### ProfileChangePairTable\n\n| column | what it is |" in page
    reference.NAMED.add("NeverExplained")
    with pytest.raises(ValueError, match="NeverExplained"):
        reference.types()


def test_every_column_is_described():
    columns = script("columns")
    assert all(text.strip() for table in columns.tables().values() for text in table.values())
    with pytest.raises(ValueError, match="EvidenceRow.never_described"):
        columns.meaning("EvidenceRow", "never_described", {})


def test_a_class_of_values_has_the_names_that_they_have():
    from asperity._values import MapFinish, MapFinishDifference

    assert typing.get_type_hints(MapFinish)["difference_w"] == typing.Optional[MapFinishDifference]
    assert [*MapFinishDifference.__annotations__] == ["value", "low", "high"]


def test_a_star_import_replaces_no_built_in_function():
    names = {}
    exec("from asperity import *", names)
    assert not set(names) & (set(dir(builtins)) - {"__builtins__", "__doc__", "__name__"})
    assert set(asperity.__all__) == set(names) - {"__builtins__"} and "Case" in names


def test_everything_public_is_documented():
    for name in [*asperity.__all__, "map"]:
        thing = getattr(asperity, name)
        assert name == "__version__" or thing.__doc__, name
        if isinstance(thing, type):
            members = {key: value for key, value in vars(thing).items() if not key.startswith("_")}
            for key, value in members.items():
                assert not callable(value) and not isinstance(value, property) or value.__doc__, f"{name}.{key}"
