"""Results: attributes, arrays, folders, other packages, notebooks."""

import json
import pickle
import shutil

import numpy as np
import pytest

import asperity
from asperity import AsperityError, AsperityWarning
from conftest import CASES, SETS, small, trace


def test_numbers_have_names_and_columns_are_arrays(result):
    assert result.loss_w == result.summary.loss_w == result["summary"]["loss_w"]
    path = result.path
    assert path.lambda_star.shape == (4,) and path.position.dtype == np.int64
    assert path[2].film_minimum_um == path.film_minimum_um[2]
    assert sum(row.weight_m for row in path) == pytest.approx(path.weight_m.sum())
    assert len(result.offsets) == 2 and result.offsets.loss_w.mean() == pytest.approx(result.loss_w)
    assert [row.source for row in result.defaults] == result.defaults.source.tolist() and len(dir(result)) == len({*dir(result)})
    assert "loss_w" in dir(result.summary) and "film_minimum_um" in dir(path)
    with pytest.raises(AttributeError, match="lambda_star"):
        path.lamda_star
    with pytest.raises(AttributeError, match="loss_w"):
        result.summary.loss


def test_sums_of_the_losses_balance(result):
    of = result.summary
    assert of.loss_w == pytest.approx(of.sliding_w + of.rolling_w, rel=1e-12)
    assert of.sliding_w == pytest.approx(of.film_w + of.lubricated_asperity_w + of.boundary_w, rel=1e-12)


def test_a_result_is_plain_data(result):
    again = json.loads(json.dumps(result.to_dict()))
    assert again["summary"]["loss_w"] == result.loss_w
    held = json.loads(result.to_json())
    assert held["lubricant"]["temperature"] == "90 °C" and again["lubricant"]["temperature_c"] == 90
    assert all(held[name] == again[name] for name in ("summary", "path", "inputs"))


def test_fields_of_a_position(result):
    assert result.positions == [1, 2, 3, 4]
    fields = result.fields(2)
    assert fields.von_mises.shape == (len(fields.depths), len(fields.x))
    load = (fields.pressure_solid + fields.pressure_fluid).sum() * (fields.x[1] - fields.x[0])
    assert load == pytest.approx(result.path.line_load_n_per_mm[1] * 1e3, rel=1e-3)
    highest = result.fields()
    assert highest.pressure_solid.max() >= fields.pressure_solid.max()
    with pytest.raises(asperity.AsperityError) as refused:
        result.fields(9)
    assert refused.value.code == "E402" and "only of 1, 2, 3, 4" in refused.value.message


def test_a_result_goes_into_a_folder_and_comes_back(result, tmp_path):
    result.write(tmp_path / "out")
    assert (tmp_path / "out" / "report.html").is_file()
    back = asperity.read_result(tmp_path / "out")
    assert back == result and str(back) == str(result)
    assert asperity.read_result(tmp_path / "out" / "result.json").loss_w == result.loss_w
    result.write(tmp_path / "all", fields=True)
    assert (tmp_path / "all" / "position_01").is_dir()


def test_results_leave_for_other_packages(result):
    pytest.importorskip("pandas")
    xarray = pytest.importorskip("xarray")
    frame = result.to_pandas()
    assert frame.shape[0] == 4 and frame.attrs["loss_w"] == result.loss_w
    data = result.to_xarray()
    assert isinstance(data, xarray.Dataset) and data.sizes == {"path_fraction": 4}
    assert float(data.film_minimum_um.sel(path_fraction=data.path_fraction[1])) == result.path.film_minimum_um[1]
    assert result.fields().to_xarray().von_mises.dims == ("depth", "x")


def test_a_notebook_shows_summary_and_chart(result):
    page = result._repr_html_()
    assert "efficiency" in page and "<svg" in page and "boundary layer" in page
    assert f"{result.loss_w:.6g} W" in repr(result)
    assert str(result).startswith("small\nefficiency (mesh only)")
    assert "<table" in result.path._repr_html_() and "<table" in result.summary._repr_html_()


def test_the_uncertainty_goes_with_a_run(result):
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 4})
    found = case.run()
    uncertainty = found.uncertainty
    assert f"loss {found.loss_w:.4g} (" in repr(found) and f"{100 * found.efficiency:.4f} %" in repr(found)
    low, high = uncertainty.loss.quantiles_w
    assert low < uncertainty.loss.median_w == found.loss_w < high and uncertainty.draws == 16_384
    assert result.summary.loss_at_medians_w is None
    parts = uncertainty.loss.parts
    widths = (parts.p95_w - parts.p05_w).tolist()
    assert widths == sorted(widths, reverse=True) and all(parts.name) and all(parts.remedy)
    assert result.uncertainty is None
    assert "5 to 95 %" in case.run()._repr_html_()


def test_progress_is_told(case):
    told = []
    case.run("losses", progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (4, 4) and told == sorted(told)
    tqdm = pytest.importorskip("tqdm")
    case.run("losses", progress=tqdm.tqdm)
    with tqdm.tqdm(desc="own") as bar:
        case.run("losses", progress=bar)
        assert (bar.n, bar.total) == (4, 4)


def test_what_progress_raises_ends_the_run():
    long = asperity.Case(small(model={"positions": 200, "offsets": 16}))

    def stop(done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        long.run("losses", progress=stop)


def test_tables_are_cut_by_masks_and_lists(result):
    path = result.path
    thin = path[path.film_minimum_um < np.median(path.film_minimum_um)]
    assert len(thin) == 2 and set(thin.position) < set(path.position)
    assert path[["position", "mu"]].columns[0] == "position"
    assert path[[3, 0]].position.tolist() == [4, 1] and path[-1].position == 4 and len(path[[]]) == 0
    for wrong, error in (([True], asperity.AsperityError), (["nothing"], KeyError), ([1.5], asperity.AsperityError), (["mu", 1], asperity.AsperityError)):
        with pytest.raises(error):
            path[wrong]


def test_programs_that_read_arrow_take_tables(result, tmp_path):
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table(result.path)
    assert table.column_names == result.path.columns and table["position"].to_pylist() == [1, 2, 3, 4]
    assert table["film_minimum_um"].to_pylist() == result.path.film_minimum_um.tolist()
    assert pyarrow.table(result.warnings).num_rows == len(result.warnings)
    parquet = pytest.importorskip("pyarrow.parquet")
    parquet.write_table(table, tmp_path / "path.parquet")
    assert parquet.read_table(tmp_path / "path.parquet").equals(table)


def test_assignments_that_would_do_nothing_are_refused(case, result):
    chart, parameters = result.plot(), trace().parameters()
    for thing, name in ((result, "loss_w"), (result, "note"), (result.path, "mu"), (case, "title"), (trace(), "heights"), (chart, "title"), (parameters, "ra_um")):
        before = getattr(thing, name, None)
        with pytest.raises(AttributeError, match=f"{name} cannot be assigned"):
            setattr(thing, name, 3.0)
        assert np.all(getattr(thing, name, None) == before)


def test_versions_are_shown(capsys):
    asperity.show_versions()
    lines = dict(line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines())
    assert lines["asperity"] == asperity.__version__ and lines["numpy"] == np.__version__


def test_losses_alone_say_what_they_do_not_have(case, result, tmp_path):
    losses = case.run("losses")
    assert losses.positions == []
    for call in (lambda: losses.diff(losses), lambda: result.diff(losses), lambda: losses.diff(result), lambda: losses.write(tmp_path / "r"), losses.fields):
        with pytest.raises(AsperityError, match="losses alone") as refused:
            call()
        assert refused.value.code == "E402" and "detail" in refused.value.help
    contacts = case.run("contacts")
    with pytest.raises(AsperityError, match="holds no fields") as refused:
        contacts.fields()
    assert refused.value.code == "E402" and "fields" in refused.value.help
    assert not contacts.diff(contacts).summary
    train = asperity.Case(SETS["train"]).run("contacts")
    with pytest.raises(AsperityError, match="of several meshes has no differences") as refused:
        train.diff(train)
    assert train.positions == [] and not train.meshes[0].diff(train.meshes[0]).summary
    train.write(tmp_path / "train")
    copies = [asperity.read_result(tmp_path / "train"), pickle.loads(pickle.dumps(train))]
    for copy in copies:
        assert copy == train and copy.meshes == train.meshes and copy.path == train.path and copy.warnings == train.warnings
    (tmp_path / "train" / "train.json").write_text("{")
    with pytest.raises(AsperityError, match="it is not JSON"):
        asperity.read_result(tmp_path / "train")


def test_a_run_of_several_meshes_warns_of_each():
    train = asperity.Case(SETS["train"])
    with pytest.warns(AsperityWarning) as seen:
        found = train.run("contacts")
    assert {one.message.code for one in seen} <= set(found.warnings.code) and set(found.warnings.mesh) == {"a", "z"}


def test_a_folder_of_another_version_is_refused(result, tmp_path):
    result.write(tmp_path / "run")
    file = tmp_path / "run" / "result.json"
    values = json.loads(file.read_text(encoding="utf-8"))
    file.write_text(json.dumps({**values, "schema_version": values["schema_version"] - 1}), encoding="utf-8")
    with pytest.raises(AsperityError, match="schema version 0, and this program reads 1; run the case again") as refused:
        asperity.read_result(tmp_path / "run")
    assert refused.value.code == "E402" and refused.value.message.count(str(file)) == 1
    values["summary"]["loss_factor"] = values["summary"].pop("loss_factor_ohlendorf")
    file.write_text(json.dumps(values), encoding="utf-8")
    with pytest.raises(AsperityError, match="summary.*loss_factor_ohlendorf"):
        asperity.read_result(tmp_path / "run")


def test_a_folder_of_a_train_is_read_whole_or_refused(tmp_path):
    train = asperity.Case(SETS["train"]).run("contacts")
    train.write(tmp_path / "train")
    file = tmp_path / "train" / "train.json"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace('"loss_factor_local"', '"loss_factor"'), encoding="utf-8")
    with pytest.raises(AsperityError, match="missing field `loss_factor_local`") as refused:
        asperity.read_result(tmp_path / "train")
    assert refused.value.code == "E402"
    file.write_text(text, encoding="utf-8")
    mesh = next(one for one in (tmp_path / "train").iterdir() if one.is_dir())
    shutil.rmtree(mesh)
    with pytest.raises(AsperityError, match="has the meshes a, z, and the folder the results of [az]\n"):
        asperity.read_result(tmp_path / "train")


def test_a_run_after_running_in_has_the_steps_of_it(case):
    run = case.replace({"operation.running_in": {"torque": "100 N m", "engagements": 4}}).run(band=False)
    steps = run.run_in.steps
    assert run.run_in.torque_nm == 100 and steps.engagements.tolist() == [1, 2, 4] and (steps.plastic_work_j_per_m > 0).all()
    assert np.array_equal(steps[-1].rq_um, run.run_in.run_in.rq_um) and (run.run_in.run_in.rq_um < run.run_in.measured.rq_um).all()
    assert (steps[-1].removed_nm > 0).all() and (steps[-1].rpk_um > 0).all()


def test_what_was_not_computed_is_none_and_each_name_is_described(case, result):
    import re
    import asperity._asperity as compiled

    for run in (result, case.run("losses")):
        assert run.scans is None and run.run_in is None and len(run.records) == 0 and "scans" not in run
    described = re.findall(r"``(\w+)``", asperity.RunResult.__doc__)
    names = next(of for name, _, of in compiled.choices() if name == "ResultName")
    assert {*names} - {*described} <= {"schema_version", "program", "title", "case_file", "mesh"}
