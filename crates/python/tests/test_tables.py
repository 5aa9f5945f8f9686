"""Columns of tables: their types, their units."""

import inspect

import numpy as np
import pytest

import asperity
from asperity import _values
from asperity._record import Table, TableOf, described, is_text
from conftest import CASES, SETS, quantities_as_text, small, trace

TABLES = {name: kind for name, kind in inspect.getmembers(_values, inspect.isclass) if issubclass(kind, TableOf) and kind is not TableOf}
PURE = set(
    "asperity_share asperity_share_p05 asperity_share_p95 boundary_friction boundary_of_asperities boundary_share change contact_fraction "
    "correlation count curve deviation done_engagements drive_efficiency efficiency efficiency_deviation elsewhere ends_at engagements "
    "expected_traction face_zone factor factor_p05 factor_p95 film_ratio film_ratio_p05 film_ratio_p95 film_share film_share_standard_error "
    "first_point fitted iterations k_times_hardness lambda_star last_point limit_over_recipe line load_error load_share mixed_share mu "
    "mu_equivalent mu_film of_traces pairs path_fraction plastic_engagements points position prior readings repeats residual_sigma "
    "roughness_over_film scatter sd_ln share_of_drive simulated_traction slide_to_roll sliding_error_freedom slope_per_decade thermal_reduction "
    "traces traction traction_p05 traction_p95 width with_loss within_finishes yield_share".split()
)
"""Columns of counts, and of numbers without a dimension."""


def columns_of(kind):
    return {name: declared for name, declared in kind._row.__annotations__.items() if not name.startswith("_")}


def types(table):
    """Types of the columns in numpy, pandas and Arrow."""
    pyarrow = pytest.importorskip("pyarrow")
    frame = table.to_pandas()
    schema = pyarrow.table(table).schema
    return {name: (table[name].dtype, frame[name].dtype, schema.field(name).type) for name in table.columns}


@pytest.mark.parametrize("kind", TABLES.values(), ids=TABLES)
def test_the_type_of_a_column_does_not_depend_on_its_values(kind):
    pytest.importorskip("pandas")
    examples = {"float": 1.5, "int": 2, "bool": True}
    plain = {name: declared for name, declared in columns_of(kind).items() if is_text(declared) or declared.removeprefix("Optional[").rstrip("]") in examples}
    full = {name: "text" if is_text(declared) else examples[declared.removeprefix("Optional[").rstrip("]")] for name, declared in plain.items()}
    may_lack = {name for name, declared in plain.items() if declared == "float" or declared.startswith("Optional") or name in kind._row._absent}
    may_lack -= {name for name, declared in plain.items() if declared in ("int", "bool")}
    empty = types(kind([]))
    assert [*empty] == [*columns_of(kind)]
    without = {name: value for name, value in full.items() if name not in kind._row._absent}
    for rows in ([full], [full, without], [{**full, **dict.fromkeys(may_lack)}], [full, {**full, **dict.fromkeys(may_lack)}]):
        found = types(kind(rows))
        for name in plain:
            assert found[name] == empty[name], name
        cut = types(kind(rows)[:0])
        assert {name: cut[name] for name in plain} == {name: empty[name] for name in plain}


@pytest.mark.parametrize("kind", TABLES.values(), ids=TABLES)
def test_a_column_of_numbers_says_its_unit(kind):
    columns = columns_of(kind)
    numbers = {name for name, declared in columns.items() if declared.removeprefix("Optional[").rstrip("]") in ("float", "int")}
    without = {name for name in numbers if described(name)["units"] == "1"}
    assert "unit" in columns or without <= PURE, without - PURE


def test_a_name_ends_with_the_whole_unit():
    for name, unit in (("mean_speed_m_s", "m/s"), ("tilt_um_per_mm", "um/mm"), ("hours", "h"), ("wh_per_100_km", "W h/(100 km)"), ("loss_w", "W")):
        assert described(name)["units"] == unit
    assert not {name for name in PURE if described(name)["units"] != "1"}


@pytest.mark.parametrize("of", [
    lambda case: case.run(),
    lambda case: case.run("losses"),
    lambda case: asperity.Case(SETS["train"]).run(),
    lambda case: case.regime(),
    lambda case: case.gear(),
    lambda case: case.film(),
    lambda case: asperity.steels(),
    lambda case: asperity.gears(),
    lambda case: trace(),
    lambda case: trace().prepare().about,
    lambda case: asperity.generate(points=4000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1).about,
])
def test_quantities_are_numbers_in_the_unit_of_their_names(case, of):
    assert [*quantities_as_text(of(case).to_dict())] == []


def test_the_transmission_error_is_a_curve_of_numbers(case):
    gear, load = case.gear(), case.run("contacts").load
    error = gear.transmission_error
    assert error.mean_um == pytest.approx(load.transmission_error_um, rel=1e-12)
    assert error.mesh_stiffness_n_per_mm_um == pytest.approx(load.mesh_stiffness_n_per_mm_um, rel=1e-12)
    curve = error.curve
    assert curve.columns == ["phase", "transmission_error_um"] and curve.transmission_error_um.mean() == pytest.approx(error.mean_um, rel=1e-9)
    assert gear.gears.path.length_mm == pytest.approx(gear.gears.path.e_mm - gear.gears.path.a_mm)
    assert "transmission_error.curve = 64 values" in repr(gear) and "{" not in repr(gear)


def test_stages_of_a_plan_say_their_units():
    stages = asperity.oil_plan("m100").stages
    assert {name for name in stages.columns if described(name)["units"] == "1" and not name.endswith("_sd_ln")} == {"name", "points"}
    assert types(stages) == types(stages[:0])


def test_columns_without_an_error_are_text():
    pandas = pytest.importorskip("pandas")
    text = pandas.Series(["text"]).dtype
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 3, "offsets": 2})
    rows = asperity.sweep(case, {"torque_nm": [50, 100]}).run()
    losses = asperity.map(case, torque_nm=[50, 100], speed_rpm=[1000, 9000], band="none")
    for frame in (rows.to_pandas(), losses.rows.to_pandas(), losses.to_pandas(), asperity.sensitivity(case).rows[:3].to_pandas()):
        assert frame["code"].dtype == text and frame["code"].isna().all()
    assert types(rows) == types(rows[:0]) and (rows.case.dtype, rows.loss_w.dtype) == (np.int64, np.float64)
    two = asperity.compare(case, {"a": case, "b": case.replace(formulation="paper")}).to_pandas()
    assert two.difference_p05_w.dtype == np.float64 and two.difference_verdict.dtype == text
    assert Table([{"seen": None}]).seen.dtype == object, "nothing says that it is a number"


def test_frames_of_nested_rows_are_written_to_parquet(tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 2, "offsets": 2})
    finishes = asperity.compare(case, {"a": case, "b": case.replace(temperature="60 °C")}).finishes
    finishes.to_pandas().to_parquet(tmp_path / "finishes.parquet")
    again = pandas.read_parquet(tmp_path / "finishes.parquet")
    assert list(again.columns) == finishes.columns
    assert again.difference[1]["median_w"] == finishes[1].difference.median_w


def test_a_case_with_a_profile_is_written_with_its_file(tmp_path):
    case = asperity.Case(small())
    with pytest.raises(asperity.AsperityError, match="waves .* no file has them") as refused:
        case.to_toml()
    assert refused.value.code == "E205" and "to_toml(folder)" in refused.value.help
    (tmp_path / "case.toml").write_text(case.to_toml(tmp_path))
    again = asperity.Case(tmp_path / "case.toml")
    assert again.run("losses").loss_w == case.run("losses").loss_w and again.to_toml() == (tmp_path / "case.toml").read_text()
    ground = asperity.Case(CASES / "e-drive.toml").replace({"surface.pinion": trace()})
    (tmp_path / "below").mkdir()
    (tmp_path / "below" / "case.toml").write_text(ground.to_toml(tmp_path / "below"))
    assert asperity.Case(tmp_path / "below" / "case.toml").run("losses").loss_w == ground.run("losses").loss_w


def test_a_profile_in_a_csv_has_its_heights_to_the_last_bit(tmp_path):
    flank = asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1)
    flank.write(tmp_path / "flank.csv")
    again = asperity.read_profile(tmp_path / "flank.csv")
    assert (again.heights == flank.heights).all() and again.spacing == flank.spacing


@pytest.mark.parametrize("call, says", [
    (lambda case: case.replace({"surface.pinion": trace().heights}), "surface.pinion: .* not an array of shape"),
    (lambda case: asperity.Case(small(surface={"pinion": trace().heights})), "surface.pinion: .* not an array of shape"),
    (lambda case: asperity.compare(case, {"a": trace().heights}), "finishes.* not an array of shape"),
    (lambda case: case.replace(torque_nm=np.nan), "torque_nm: nan: must be a finite number"),
    (lambda case: case.replace({"model.boundary_friction": np.nan}), "model.boundary_friction: nan: must be"),
    (lambda case: asperity.Case(small(model={"boundary_friction": np.inf})), "model.boundary_friction: inf: must be"),
    (lambda case: case.run("loses"), "Did you mean `losses`"),
    (lambda case: asperity.sweep(case, {"surface.pinion": [trace()]}), "a sweep reads files"),
])
def test_a_wrong_value_is_named(case, call, says):
    with pytest.raises(asperity.AsperityError, match=says) as refused:
        call(case)
    assert refused.value.help
