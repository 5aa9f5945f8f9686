"""One unit for each name, in and out, and warnings as Python's warnings."""

import pickle
import warnings

import numpy as np
import pytest

import asperity
from asperity import AsperityError, AsperityWarning
from conftest import CASES, small


@pytest.fixture(scope="module")
def drive():
    return asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 2})


@pytest.fixture(scope="module")
def a_map(drive):
    return asperity.map(drive, torque_nm=[50, 145], speed_rpm=[1000, 9000], temperature_c=[60, 90], band="none")


def test_a_number_has_the_unit_of_its_name(drive, a_map):
    assert a_map.torque_nm.tolist() == [50, 145] and a_map.temperature_c.tolist() == [60, 90]
    assert a_map.speed_rpm.tolist()[-2:] == [1000, 9000]
    again = asperity.map(drive, torque_nm=a_map.torque_nm, speed_rpm=a_map.speed_rpm, temperature_c=a_map.temperature_c, band="none")
    assert np.array_equal(again.loss_w, a_map.loss_w), "what goes out can go in"
    torques = a_map.loss_torque(torque_nm=a_map.torque_nm[:, None], speed_rpm=a_map.speed_rpm, temperature_c=90)
    assert np.array_equal(torques, a_map.loss_torque_nm[0, 1])


def test_text_ranges_and_pint_mean_the_same(drive, a_map):
    texts = asperity.map(
        drive, torque=["50 N m", "0.145 kN m"], speed="1000..9000:2 1/min", temperature=["333.15 K", "90 °C"], band="none"
    )
    assert np.allclose(texts.loss_w, a_map.loss_w, rtol=1e-12)
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    same = asperity.map(
        drive, torque=unit.Quantity([50, 145], "N m"), speed=unit.Quantity([1000, 9000], "rpm"),
        temperature=[unit.Quantity(60, "degC"), unit.Quantity(90, "degC")], band="none",
    )
    assert np.allclose(same.loss_w, a_map.loss_w, rtol=1e-12)
    at = a_map.loss_torque(torque=unit.Quantity(50, "N m"), speed=unit.Quantity([1000, 9000], "rpm"), temperature="90 °C")
    assert np.allclose(at, a_map.loss_torque(torque_nm=50, speed_rpm=[1000, 9000], temperature_c=90), rtol=1e-12)


def test_a_speed_of_pint_without_an_angle_counts_turns_as_text_does(drive, a_map):
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    speeds = [9000 / unit.minute, 150 / unit.s, 150 * unit.Hz, unit.Quantity(9000, "rpm"), 300 * np.pi * unit.rad / unit.s, 54000 * unit.degree / unit.s]
    for speed in speeds:
        case = drive.replace(speed=speed)
        assert abs(asperity.sweep(drive, {"speed": [speed]}).run()["speed_rpm"][0] - 9000) < 1e-9, speed
        assert case.run("losses").loss_w == pytest.approx(drive.replace(speed="9000 1/min").run("losses").loss_w, rel=1e-12), speed
    at = a_map.loss_torque(torque=50 * unit.N * unit.m, speed=3000 / unit.minute)
    assert at.shape == () and at == pytest.approx(a_map.loss_torque(torque_nm=50, speed_rpm=3000), rel=1e-12)
    with pytest.raises(AsperityError, match="a temperature difference"):
        drive.replace(temperature=unit.Quantity(363.15, "delta_degC"))
    deviation = drive.replace({"operation.temperature_deviation": unit.Quantity(3, "delta_degC")})
    assert deviation == drive.replace({"operation.temperature_deviation": "3 K"}) and 'temperature_deviation = "3 K"' in deviation.to_toml()
    columns = {"time_s": [0.0, 1.0], "torque_nm": [50.0, 60.0], "speed_rpm": [2000.0, 3000.0]}
    quantities = {"time_s": [0.0, 1.0], "torque_nm": unit.Quantity([0.05, 0.06], "kN*m"), "speed_rpm": unit.Quantity([2000.0, 3000.0], "1/minute")}
    lost = [asperity.cycle(a_map, trace).finishes.lost_wh[0] for trace in (columns, quantities)]
    assert lost[0] == pytest.approx(lost[1], rel=1e-9)
    jet = {"flow": 2.5 * unit.liter / unit.minute, "speed": "20 m/s"}
    assert drive.replace({"gearbox.jet": jet}).inputs.gearbox.jet.speed == "20 m/s"


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"speed": [1000, 9000]}, "E204"),
        ({"torque": 145}, "E204"),
        ({"temperature": [90]}, "E204"),
        ({"torque_nm": "145"}, "E204"),
        ({"torque_nm": ["145 N m"]}, "E204"),
        ({"torque": "10..150:8"}, "E204"),
        ({"torque": "10..150:8 kN m"}, "E204"),
        ({"torque": "1000 1/min"}, "E204"),
        ({"torque": "145 N m", "torque_nm": 145}, "E205"),
        ({"torque_nm": True}, "E204"),
        ({"torque_nm": [[1, 2], [3, 4]]}, "E209"),
        ({"torque_nm": np.nan}, "E209"),
        ({"torque_nm": []}, "E209"),
    ],
)
def test_what_has_no_unit_or_two_is_refused(drive, given, code):
    with pytest.raises(AsperityError) as refused:
        asperity.map(drive, **given)
    assert refused.value.code == code and refused.value.help


def test_the_loss_torque_of_a_map_takes_no_place_without_names(a_map):
    with pytest.raises(TypeError):
        a_map.loss_torque(50, a_map.speed_rpm)
    for given, code in (({"torque_nm": 50}, "E205"), ({"torque_nm": 50, "speed": 9000}, "E204"), ({"torque_nm": 50, "speed_rpm": 9000, "temperature_c": 75}, "E209"),
                        ({"torque_nm": [1, 2], "speed_rpm": [1, 2, 3]}, "E209"), ({"torque_nm": 50, "speed_rpm": 9000, "finish": "none"}, "E209"),
                        ({"torque_nm": 50, "speed_rpm": 9000, "finish": -1}, "E209")):
        with pytest.raises(AsperityError) as refused:
            a_map.loss_torque(**given)
        assert refused.value.code == code


def test_conditions_of_single_functions_are_stated(drive):
    for call in (
        lambda: asperity.oil_traction("m100", load=30),
        lambda: asperity.oil_traction("m100", rq=15e-9),
        lambda: asperity.ehl(drive, 0.25, eyring_stress=5e6),
        lambda: asperity.sweep(drive, {"operation.torque": [50.0]}),
        lambda: drive.replace(torque=50.0),
    ):
        with pytest.raises(AsperityError, match="has no unit") as refused:
            call()
        assert refused.value.code == "E204"


def test_the_operating_point_is_a_number_or_text(drive):
    by_number = drive.replace(torque_nm=120, speed_rpm=3000, temperature_c=80)
    assert drive.replace(torque="120 N m", speed="3000 1/min", temperature="80 °C") == by_number
    assert drive.replace(operation={"torque": "120 N m", "speed": "3000 1/min", "bulk_temperature": "80 °C"}) == by_number
    table = drive.to_dict()
    del table["operation"]["torque"]
    assert asperity.Case(table, torque="120 N m", folder=CASES).replace(speed_rpm=3000, temperature_c=80).inputs.operation == by_number.inputs.operation
    for twice in ({"torque_nm": 1, "torque": "1 N m"}, {"speed": "1 1/min", "speed_rpm": 1}):
        with pytest.raises(AsperityError, match="is given twice") as refused:
            drive.replace(**twice)
        assert refused.value.code == "E205"
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    assert drive.replace(torque=units.Quantity(0.12, "kN*m"), speed_rpm=3000, temperature_c=80).run("losses").loss_w == by_number.run("losses").loss_w



def test_results_warn_at_the_line_of_the_caller():
    case = asperity.Case(small())
    with pytest.warns(AsperityWarning) as seen:
        result = case.run(band=False)
    assert [warning.message.code for warning in seen] == list(result.warnings.code)
    assert {warning.filename for warning in seen} == {__file__}
    first = seen[0].message
    assert str(first) == f"{first.code} {first.text}" and asperity.explain(first.code)
    again = pickle.loads(pickle.dumps(first))
    assert (again.code, again.text, again.help) == (first.code, first.text, first.help)


def test_a_case_warns_of_its_files_once():
    fast = {"torque": "145 N m", "speed": "70000 1/min", "bulk_temperature": "90 °C"}
    with pytest.warns(AsperityWarning, match="W201"):
        named = asperity.Case(small(operation=fast))
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        result = named.replace(torque_nm=100).run(band=False)
    told = [warning.message.code for warning in seen]
    assert "W201" in list(result.warnings.code) and "W201" not in told and told


def test_a_map_warns_with_the_codes_of_its_points(drive):
    with pytest.warns(AsperityWarning) as seen:
        found = asperity.map(drive, torque_nm=[-145, 145], speed=["100 1/min", "9000 1/min"], band="none")
    assert "extended" in list(found.warnings.text), "points that are extrapolated are listed"
    warned = [warning.message for warning in seen]
    assert warned and all(one.text and asperity.explain(one.code) for one in warned)


def test_a_law_outside_its_range_warns():
    with pytest.warns(AsperityWarning, match="W401"):
        found = asperity.thermal_reduction("gupta", max_pressure=[1e9, 9e9], modulus=115e9, loading=1.0, slide_to_roll=0.2)
    assert found.notes and found.outside.tolist() == [False, True]
