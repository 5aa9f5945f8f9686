"""Cases from files, tables and keywords, and their changes."""

import concurrent.futures
import json
import multiprocessing
import pickle
import warnings
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity._quantity import in_numbers
from conftest import CASES, PROFILES, SETS, small, trace


def test_three_ways_to_the_same_case():
    file = asperity.Case(CASES / "e-drive.toml")
    tables = file.to_dict()
    for flank in ("pinion", "wheel"):
        tables["surface"][flank]["file"] = str(PROFILES / f"ground_{flank}.csv")
    assert asperity.Case(tables).run("losses").loss_w == file.run("losses").loss_w
    by_keywords = asperity.Case(**tables)
    assert by_keywords.to_dict() == asperity.Case(tables).to_dict()


def test_the_operating_point_is_given_by_numbers_in_the_unit_of_their_names():
    text = asperity.Case(small())
    bare = {key: value for key, value in small().items() if key != "operation"}
    for numbers in (asperity.Case(bare, torque_nm=145, speed_rpm=np.float64(9000), temperature_c=90),
                    asperity.Case({**bare, "torque_nm": 145, "speed_rpm": 9000, "temperature_c": 90.0}),
                    asperity.Case(small(operation={"torque": "1 N m", "speed": "9000 1/min"}), torque_nm=145, temperature_c=90)):
        assert numbers.to_dict() == text.to_dict()
    assert text.replace(torque_nm=20.5).inputs.operation.torque == "20.5 N m"
    assert asperity.Case.load(CASES / "e-drive.toml", {"speed_rpm": 1000}).inputs.operation.speed == "1000 1/min"


@pytest.mark.parametrize("keys", [{"operation.torque": 145}, {"operation": {"speed": 942.5}}, {"gears.module": np.float64(1.8e-3)},
                                  {"torque_nm": "145 N m"}, {"torque_nm": [1, 2]}, {"speed_rpm": "9000"}])
def test_a_number_without_a_unit_and_a_unit_too_many_are_refused(case, keys):
    with pytest.raises(asperity.AsperityError) as refused:
        case.replace(keys)
    assert refused.value.code == "E204" and ("has no unit" in str(refused.value) or "number" in str(refused.value))


def test_pint_is_taken():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    quantities = {
        "torque": 145 * unit.newton * unit.meter,
        "speed": unit.Quantity(9000, "revolution/minute"),
        "bulk_temperature": unit.Quantity(90, "degC"),
    }
    found = asperity.Case(small(operation=quantities))
    assert found.run("losses").loss_w == pytest.approx(asperity.Case(small()).run("losses").loss_w, rel=1e-12)
    widths = unit.Quantity([35, 32], "mm")
    wide = asperity.Case(small()).replace({"gears.face_width": widths})
    assert wide.inputs.gears.face_width == ["35 mm", "32 mm"]
    assert asperity.Profile(trace().heights, unit.Quantity(0.5, "um")).spacing == 0.5e-6
    with pytest.raises(asperity.AsperityError) as refused:
        asperity.Case(small(operation={**quantities, "torque": 3 * unit.meter}))
    assert refused.value.code == "E204"


def test_a_change_leaves_the_case_as_it_was(case):
    before = case.to_dict()
    hot = case.replace({"operation.bulk_temperature": "110 °C"}, model={"boundary_friction": 0.1})
    assert case.to_dict() == before
    assert hot.inputs.operation.bulk_temperature == "110 °C" and hot.inputs.model.boundary_friction == 0.1
    assert hot.inputs.operation.torque == "145 N m", "the other keys of a table stay"
    assert hot.replace({"model.boundary_friction": None}).inputs.model.boundary_friction is None


def test_a_case_takes_other_flanks(case):
    fine = asperity.read_profile(PROFILES / "superfinished.csv")
    smooth = case.replace({"surface.pinion": fine, "surface.wheel": fine.mirrored()})
    assert smooth.run("losses").loss_w < case.run("losses").loss_w
    by_value = case.replace(surface={"pinion": {"file": None, "rq": "0.2 um"}, "wheel": {"file": None, "rq": "200 nm"}})
    assert by_value.inputs.surface.wheel["rq"] == "200 nm"


def test_a_trace_by_itself_is_a_flank_and_as_a_file_leaves_the_other_keys(tmp_path):
    for name in ("ground_pinion.csv", "ground_wheel.csv", "superfinished.csv"):
        (tmp_path / name).write_bytes((PROFILES / name).read_bytes())
    surface = {"cutoff": "0.25 mm", "pinion": "ground_pinion.csv", "wheel": {"file": "ground_wheel.csv", "mirrored": True, "range": "0 mm .. 2.5 mm"}}
    case = asperity.Case(small(surface=surface), folder=tmp_path)
    flank = asperity.read_profile(tmp_path / "superfinished.csv")
    loss = {}
    for kind, trace_of in (("memory", flank), ("text", "superfinished.csv"), ("path", Path("superfinished.csv"))):
        alone, file = case.replace({"surface.wheel": trace_of}), case.replace({"surface.wheel.file": trace_of})
        assert alone == case.replace(surface={"wheel": trace_of}) and file == case.replace(surface={"wheel": {"file": trace_of}})
        stated = {key: value for key, value in alone.to_dict()["surface"]["wheel"].items() if value is not None}
        assert [*stated] == ["file"]
        kept = file.to_dict()["surface"]["wheel"]
        assert kept["mirrored"] and kept["range"] == case.to_dict()["surface"]["wheel"]["range"]
        loss[kind] = [of.run("losses").loss_w for of in (alone, case.replace({"surface.wheel": {"file": trace_of, "mirrored": True}}))]
    assert loss["memory"] == loss["text"] == loss["path"] and loss["text"][0] != loss["text"][1]
    assert asperity.Case(small(surface={**surface, "wheel": flank}), folder=tmp_path).run("losses").loss_w == loss["memory"][0]
    train = asperity.Case(SETS["train"]).replace({"mesh.z.surface.pinion": flank})
    assert train.to_dict()["mesh"]["z"]["surface"]["pinion"]["file"].startswith("superfinished")


def test_text_of_a_case_reads_back():
    text = asperity.Case(CASES / "fzg-c.toml").to_toml()
    assert 'module = "4.5 mm"' in text


def test_keys_are_set_past_the_text_of_a_file():
    case = asperity.Case.load(CASES / "e-drive.toml", {"torque_nm": 20.0, "model": {"offsets": 4}})
    assert case.inputs.operation.torque == "20 N m" and case.inputs.model.offsets == 4
    paper = asperity.Case(CASES / "e-drive.toml", formulation="paper")
    assert "paper" in json.dumps(paper.to_dict())


def test_a_case_tells_its_defaults(case):
    defaults = dict(zip(case.defaults.key, case.defaults.value))
    assert float(defaults["model.boundary_friction"]) == 0.09
    assert case.title == "small" and "model.positions" in case._repr_html_()


def test_places_name_key_and_line(tmp_path):
    file = tmp_path / "case.toml"
    file.write_text((CASES / "e-drive.toml").read_text().replace('"1.8 mm"', "1.8"))
    with pytest.raises(asperity.AsperityError) as refused:
        asperity.Case(file)
    place = refused.value.place
    assert (place.key, place.line, place.file) == ("gears.module", 7, str(file))
    assert "mm" in str(refused.value)


def test_film_and_regime(case):
    regime = case.regime()
    assert len(regime) == 4 and np.all(regime.film_minimum_um > 0) and "<svg" in regime._repr_html_()
    film = case.film(0.25)
    assert film.rows.thickness_m[0] == pytest.approx(1e-9) and film.path_fraction == 0.25
    assert case.contact(0.25).hertz_p_max_pa > 0
    assert case.gear().title == "small"


def test_cases_and_results_go_to_other_processes(case):
    changed = case.replace({"surface.pinion": trace(5000), "operation.torque": "100 N m"})
    again = pickle.loads(pickle.dumps(changed))
    assert again.to_dict() == changed.to_dict()
    with concurrent.futures.ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        there = pool.submit(losses_of, again).result()
    here = changed.run("losses")
    assert there.loss_w == here.loss_w and there == here
    flank = asperity.read_profile(PROFILES / "ground_pinion.csv")
    same = pickle.loads(pickle.dumps(flank))
    assert same.name == flank.name and same.parameters() == flank.parameters()
    assert pickle.loads(pickle.dumps(case.regime())) == case.regime()


@pytest.fixture
def on_disk(tmp_path):
    """A case file with its traces, which a test may edit."""
    for name in ("ground_pinion.csv", "ground_wheel.csv"):
        (tmp_path / name).write_bytes((PROFILES / name).read_bytes())
    text = (CASES / "e-drive.toml").read_text().replace("../profiles/", "")
    (tmp_path / "case.toml").write_text(text + "\n[model]\npositions = 4\noffsets = 2\n")
    return tmp_path / "case.toml"


def edit_case(file):
    file.write_text(file.read_text().replace("145 N m", "90 N m"))


def edit_trace(file):
    other = PROFILES / "superfinished.csv"
    (file.parent / "ground_pinion.csv").write_bytes(other.read_bytes())


def remove_all(file):
    for other in list(file.parent.iterdir()):
        other.unlink()


@pytest.mark.parametrize("edit", [edit_case, edit_trace, remove_all])
def test_a_pickled_case_is_its_content_and_not_its_path(on_disk, edit):
    case = asperity.Case(on_disk)
    loss = case.run("losses").loss_w
    stored = pickle.dumps(case)
    edit(on_disk)
    again = pickle.loads(stored)
    assert again == case and hash(again) == hash(case)
    assert again.run("losses").loss_w == loss
    hot = {"operation.bulk_temperature": "110 °C", "surface.cutoff": "0.2 mm"}
    assert pickle.loads(pickle.dumps(again)).replace(hot).run("losses").loss_w == again.replace(hot).run("losses").loss_w


@pytest.mark.parametrize("flank", [{"traces": "ground_*.csv"}, {"like": "ground_*.csv"}, {"like": "ground_*.csv", "after": [{"file": "ground_*.csv", "engagements": 1e4}]}])
def test_a_pickled_case_has_the_files_of_its_patterns(on_disk, flank):
    case = asperity.Case(on_disk).replace({"surface.pinion": {"file": None, **flank}})
    assert pickle.loads(pickle.dumps(case)) == case


@pytest.mark.parametrize("edit", [edit_trace, remove_all])
def test_a_case_whose_files_have_changed_is_not_pickled(on_disk, edit):
    case = asperity.Case(on_disk)
    edit(on_disk)
    with pytest.raises(asperity.AsperityError) as refused:
        pickle.dumps(case)
    assert refused.value.code == "E140"


def test_caches_tell_edited_cases_apart(on_disk, tmp_path):
    base = pytest.importorskip("dask.base")
    joblib = pytest.importorskip("joblib")
    cached = joblib.Memory(tmp_path / "cache", verbose=0).cache(loss_of)
    first = asperity.Case(on_disk)
    assert base.tokenize(first) == base.tokenize(asperity.Case(on_disk)) and cached(first) == loss_of(first)
    edit_case(on_disk)
    other = asperity.Case(on_disk)
    assert base.tokenize(first) != base.tokenize(other) and first != other
    assert cached(other) == loss_of(other) != loss_of(first)


def loss_of(case):
    return case.run("losses").loss_w


@pytest.mark.parametrize("kind", SETS)
def test_a_pickled_train_is_its_content(kind):
    case = asperity.Case(SETS[kind])
    again = pickle.loads(pickle.dumps(case))
    assert again == case and again.is_planetary == case.is_planetary
    changed = {"operation.bulk_temperature": "100 °C"}
    assert again.replace(changed) == case.replace(changed) != case
    mesh = case.mesh(case.meshes[0])
    assert pickle.loads(pickle.dumps(mesh)) == mesh


def test_short_ways_warn_as_a_run_does(case):
    hot = case.replace({"operation.bulk_temperature": "250 °C"})

    def codes(work):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            work()
        return {found.message.code for found in told if isinstance(found.message, asperity.AsperityWarning)}

    whole = codes(lambda: hot.run("contacts"))
    assert {"W401", "W409"} <= whole
    assert codes(lambda: hot.run("losses")) == whole
    finishes = {"ground": PROFILES / "ground_pinion.csv", "fine": PROFILES / "superfinished.csv"}
    assert "W401" in codes(lambda: asperity.compare(hot, finishes, offsets=2))
    assert "W401" in codes(lambda: asperity.map(hot, torque_nm=[100], speed_rpm=[9000], band="none"))
    assert "W401" in codes(lambda: asperity.sweep(hot, {"torque_nm": [100]}).run())
    rows = asperity.sweep(hot, {"torque_nm": [100]}).run()
    assert "W401" in rows.outside[0].split()


def test_losses_have_no_interval_and_say_so(case):
    with pytest.raises(ValueError) as refused:
        case.run("losses", band=True)
    assert refused.value.code == "E205"
    assert "uncertainty" in case.run("contacts", band=True)


def losses_of(case):
    return case.run("losses")


def test_a_planetary_set_has_the_results_of_its_meshes():
    case = asperity.Case(SETS["planetary"])
    result = case.run()
    assert case.is_planetary and len(result.meshes) == 2 and 0.9 < result.efficiency < 1
    assert result.loss_w > sum(mesh.loss_w for mesh in result.meshes), "three planets"
    assert len(case.regime().meshes) == 2
    faster = case.replace({"operation.speed": "4000 1/min"}).run()
    assert faster.loss_w > result.loss_w
    with pytest.raises(asperity.AsperityError) as refused:
        case.contact()
    assert refused.value.code == "E205"


def test_a_gear_train_has_the_results_of_its_meshes():
    case = asperity.Case(SETS["train"])
    result = case.run()
    assert not case.is_planetary and len(result.meshes) == 2
    assert result.loss_w == result.meshes[0].loss_w + result.meshes[1].loss_w
    assert case.meshes == ["a", "z"]
    assert list(result.path.mesh) == [name for name, mesh in zip(case.meshes, result.meshes) for _ in mesh.path]
    assert list(result.path.path_fraction) == [at for mesh in result.meshes for at in mesh.path.path_fraction]
    assert "mesh" not in result.meshes[0].path.columns and "path_fraction" in result.to_pandas()
    for of_one in (result.plot, result.fields, result.to_xarray):
        with pytest.raises(asperity.AsperityError) as refused:
            of_one()
        assert refused.value.code == "E402" and "meshes[0]" in str(refused.value)
    assert case.mesh("z").run("losses").loss_w == result.meshes[1].summary.loss_at_medians_w
    wider = case.replace({"mesh.a.gears.face_width": "30 mm"}).run()
    assert wider.loss_w != result.loss_w


def test_a_gear_train_is_compared_and_swept_as_a_whole():
    gears = {"teeth": [23, 68], "module": "2 mm", "face_width": "25 mm"}
    case = asperity.Case(
        train={"input": "in"},
        mesh={"a": {"shafts": ["in", "b"], "gears": gears}, "z": {"shafts": ["b", "out"], "gears": gears}},
        operation=SETS["planetary"]["operation"],
        lubricant=SETS["planetary"]["lubricant"],
        surface={"pinion": {"rq": "0.4 um"}},
    )
    finer = case.replace({"mesh.z.surface": {"pinion": {"rq": "0.2 um"}}})
    found = asperity.compare(case, {"rough": case, "fine": finer})
    rough, fine = found.finishes.to_dict()
    assert fine["loss_w"] == finer.run().loss_w
    assert [mesh["mesh"] for mesh in fine["meshes"]] == ["a", "z"]
    assert fine["meshes"][0]["difference"]["verdict"] == "equal"
    assert found.to_pandas().loc["fine", "loss_w"] < found.to_pandas().loc["rough", "loss_w"]
    rows = asperity.sweep(case, {"mesh.a.gears.face_width": ["25 mm", "30 mm"]}).to_dict()
    assert rows[0]["loss_w"] == pytest.approx(case.run(band=False).loss_w, rel=1e-12)
    assert rows[0]["mesh.z.loss_w"] == rows[1]["mesh.z.loss_w"] and rows[0]["mesh.a.loss_w"] != rows[1]["mesh.a.loss_w"]


def test_names_that_read_like_quantities_stay_text(case):
    titled = case.replace({"title": "50 N m"})
    assert titled.run("losses").title == "50 N m"
    finishes = {"0.1 um": PROFILES / "superfinished.csv", "0.3 um": PROFILES / "ground_pinion.csv"}
    found = asperity.compare(titled, finishes, offsets=2)
    assert [row["name"] for row in found.finishes.to_dict()] == [*finishes] and found.to_pandas().loc["0.3 um", "loss_w"] > 0.0
    several = in_numbers({"mixed": ["1 um", "2 N"], "films": ["1 um", "2 um"], "my key": "3 um"})
    assert several == {"mixed": ["1 um", "2 N"], "films_um": [1.0, 2.0], "my key": "3 um"}


def test_a_case_file_takes_its_files_from_another_folder(tmp_path):
    demo = Path(asperity.demo(tmp_path / "demo"))
    alone = tmp_path / "alone.toml"
    alone.write_text(demo.read_text(encoding="utf-8"), encoding="utf-8")
    with pytest.raises(asperity.AsperityError, match="cannot be opened"):
        asperity.Case(alone)
    case = asperity.Case(alone, folder=demo.parent)
    assert case.run("losses").loss_w == asperity.Case(demo).run("losses").loss_w
    with pytest.raises(asperity.AsperityError) as missing:
        asperity.Case(tmp_path / "none.toml", folder=demo.parent)
    assert missing.value.code == "E201"


def test_a_warning_says_what_to_do(tmp_path):
    with pytest.warns(asperity.AsperityWarning, match="W442") as warned:
        asperity.Case(asperity.demo(tmp_path / "demo")).replace({"lubricant.oil": "n100"})
    helps = [one.message.help for one in warned if one.message.code == "W442"]
    assert helps == [asperity.explain("W442").remedy]
