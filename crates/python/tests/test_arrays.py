"""Arrays in: every unit counts. Arrays out: no result changes by them."""

import copy
import inspect
import pickle
import warnings

import numpy as np
import pytest

import asperity
from asperity import AsperityError, Profile
from asperity._record import same
from conftest import heights, small, trace

X = (np.arange(801) - 400) * 0.5e-6
GAP = X**2 / 0.02
P = 1e9 * np.sqrt(np.maximum(0, 1 - (X / 150e-6) ** 2))
Z = heights(2000) * 1e-6

# Every parameter of a public function that takes an array: its values in SI units, the unit and what it stands for, and the call.
FILM = dict(entrainment=5.0, radius=0.01, load=2e5, modulus=230e9, viscosity=0.01, pressure_viscosity=2e-8)
ARRAYS = {
    ("Profile", "heights"): (Z, "um", 1e-6, lambda v: Profile(v, 0.5e-6).heights),
    ("solve_contact", "gap"): (GAP, "um", 1e-6, lambda v: asperity.solve_contact(v, 0.5e-6, 115e9, 2e5).pressure),
    ("solve_contact", "prescribed_pressure"): (
        P / 100, "MPa", 1e6, lambda v: asperity.solve_contact(GAP, 0.5e-6, 115e9, 2e5, prescribed_pressure=v).pressure,
    ),
    ("solve_contact", "start"): (P, "MPa", 1e6, lambda v: asperity.solve_contact(GAP, 0.5e-6, 115e9, 2e5, start=v, cascade=False).iterations),
    ("subsurface_stress", "pressure"): (P, "MPa", 1e6, lambda v: asperity.subsurface_stress(v, 0.5e-6, [1e-4]).von_mises),
    ("subsurface_stress", "traction"): (P / 20, "MPa", 1e6, lambda v: asperity.subsurface_stress(P, 0.5e-6, [1e-4], traction=v).sigma_xx),
    ("subsurface_stress", "depths"): (np.array([1e-5, 1e-4]), "um", 1e-6, lambda v: asperity.subsurface_stress(P, 0.5e-6, v).von_mises),
    ("hertz", "load"): (np.array([1e5, 2e5]), "N/mm", 1e3, lambda v: asperity.hertz(v, 0.01, 115e9).half_width),
    ("hertz", "radius"): (np.array([0.01, 0.02]), "mm", 1e-3, lambda v: asperity.hertz(1e5, v, 115e9).half_width),
    ("hertz", "modulus"): (np.array([1e11, 2e11]), "GPa", 1e9, lambda v: asperity.hertz(1e5, 0.01, v).half_width),
    **{
        ("film_thickness", name): (
            np.array([1.0, 1.5]) * FILM[name], unit, factor, lambda v, name=name: asperity.film_thickness(**{**FILM, name: v}).central,
        )
        for name, unit, factor in (
            ("entrainment", "mm/s", 1e-3), ("radius", "mm", 1e-3), ("load", "N/mm", 1e3), ("modulus", "GPa", 1e9),
            ("viscosity", "mPa*s", 1e-3), ("pressure_viscosity", "1/GPa", 1e-9),
        )
    },
    ("film_thickness", "contact_length"): (
        np.array([0.01, 0.02]), "mm", 1e-3, lambda v: asperity.film_thickness("hamrock-dowson", **FILM, contact_length=v).central,
    ),
    **{
        ("thermal_reduction", name): (
            values, unit, factor,
            lambda v, name=name: asperity.thermal_reduction(
                **{"max_pressure": 1e9, "modulus": 230e9, "loading": 0.3, "slide_to_roll": 0.2, name: v}
            ).factor,
        )
        for name, values, unit, factor in (
            ("max_pressure", np.array([1e9, 1.2e9]), "GPa", 1e9), ("modulus", np.array([2.1e11, 2.3e11]), "GPa", 1e9),
            ("loading", np.array([0.1, 0.3]), "percent", 1e-2), ("slide_to_roll", np.array([0.1, 0.2]), "percent", 1e-2),
        )
    },
}
# Those of which the operating point, cases and tables are the tests of test_units.py and test_same_numbers.py.
OTHERS = {"friction_coefficient", "calibrate", "cycle", "design", "map", "oil_fit", "oil_plan", "oil_traction", "stribeck"}


def units():
    return pytest.importorskip("pint").UnitRegistry()


def test_every_array_of_a_public_function_is_walked():
    found = set()
    for name in {*asperity.__all__} | {"map"}:
        function = getattr(asperity, name)
        if not callable(function) or name in OTHERS or inspect.isclass(function) and name != "Profile":
            continue
        for parameter in inspect.signature(function).parameters.values():
            kind = str(parameter.annotation)
            if "ArrayLike" in kind or "Values" in kind or "NDArray" in kind:
                found.add((name, parameter.name))
    assert found == set(ARRAYS)


@pytest.mark.parametrize("of", ARRAYS, ids="-".join)
def test_an_array_of_pint_keeps_its_unit(of):
    registry = units()
    values, unit, factor, call = ARRAYS[of]
    given = registry.Quantity(values / factor, unit)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.AsperityWarning)
        expected = call(values)
        assert np.allclose(call(given), expected, rtol=1e-6)
        assert np.allclose(call([registry.Quantity(value, unit) for value in (values / factor).tolist()]), expected, rtol=1e-6)
    with pytest.raises(AsperityError) as refused:
        call(registry.Quantity(values, "kg**3"))
    assert refused.value.code == "E204" and len(refused.value.message) < 400


@pytest.mark.parametrize("law", ["friction", "own"])
def test_laws_of_friction_keep_the_unit(law):
    registry = units()
    if law == "friction":
        given = dict(load=2e5, radius=0.01, entrainment=5.0, sliding=1.0, max_pressure=1e9, viscosity=0.01, contact_viscosity=0.01, combined_roughness=0.4e-6)
        expected = asperity.friction_coefficient("xu", **given).coefficient
        micro = asperity.friction_coefficient("xu", **{**given, "combined_roughness": registry.Quantity([0.4], "um")})
        assert np.allclose(micro.coefficient, expected)
        return
    case = asperity.Case(small())
    percent = case.with_laws(film_friction=lambda at: registry.Quantity(np.full(at.load.shape, 3.0), "percent"))
    assert percent.run("losses").loss_w == pytest.approx(case.with_laws(film_friction=lambda at: 0.03).run("losses").loss_w, rel=1e-9)
    with pytest.raises(AsperityError, match="E204"):
        case.with_laws(film_friction=lambda at: registry.Quantity(0.03, "m")).run("losses")


def test_axes_of_pint_keep_their_unit(case):
    registry = units()
    torques = registry.Quantity([0.05, 0.1], "kN*m")
    for key in ("torque", "operation.torque"):
        assert asperity.sweep(case, {key: torques}).run().torque_nm.tolist() == pytest.approx([50.0, 100.0])
    for call in (lambda: asperity.sweep(case, {"torque_nm": torques}), lambda: case.replace(torque_nm=torques[0])):
        with pytest.raises(AsperityError) as refused:
            call()
        assert refused.value.code == "E204"


@pytest.mark.parametrize("values", [["1", "2"], np.array([1 + 2j]), np.array(["2026-01-01"], dtype="datetime64[s]"), {1, 2}, b"1", object()])
def test_an_array_holds_numbers(values):
    for call in (lambda: Profile(values, 0.5e-6), lambda: asperity.solve_contact(values, 1e-6, 1e11, 1e5)):
        with pytest.raises(AsperityError, match="array of numbers") as refused:
            call()
        assert refused.value.code == "E204"


def test_a_unit_of_another_package_is_refused():
    class Astropy(np.ndarray):
        unit = "um"

        def to(self, unit):
            return self

    with pytest.raises(AsperityError, match="unit of another package"):
        Profile((Z * 1e6).view(Astropy), 0.5e-6)


AXES = {"torque_nm": [50, 145], "speed_rpm": [1000, 9000]}
RESULTS = {
    "RunResult": lambda case: case.run(),
    "losses": lambda case: case.run("losses"),
    "Fields": lambda case: case.run(band=False).fields(),
    "Regime": lambda case: case.regime(),
    "Contact": lambda case: case.contact(),
    "solve_contact": lambda case: asperity.solve_contact(GAP, 0.5e-6, 115e9, 2e5),
    "Stress": lambda case: asperity.subsurface_stress(P, 0.5e-6, [1e-4, 2e-4]),
    "EhlRecord": lambda case: asperity.ehl(case, 0.25, cells=128, half_widths=2, start=0),
    "hertz": lambda case: asperity.hertz([1e5, 2e5], 0.01, 115e9),
    "gear": lambda case: case.gear(),
    "film": lambda case: case.film(),
    "Map": lambda case: asperity.map(case, **AXES, band="none"),
    "Comparison": lambda case: asperity.compare(case, {"a": trace(), "b": trace(5990)}),
    "Sensitivity": lambda case: asperity.sensitivity(case),
    "Evidence": lambda case: asperity.evidence(case),
    "Sweep": lambda case: asperity.sweep(case, {"torque_nm": [50, 100]}),
    "Profile": lambda case: trace(),
    "Parts": lambda case: trace().filter().roughness,
    "psd": lambda case: trace().psd(),
    "oils": lambda case: asperity.oils(),
}


def parts(value):
    """What is reached from a value by attributes, items and exports."""
    yield value
    if isinstance(value, (np.ndarray, list, dict)):
        return
    for name in dir(value):
        if not name.startswith("_") and name not in ("map", "meshes") and not callable(found := getattr(value, name, None)):
            yield from parts(found) if type(found).__module__.startswith("asperity") else [found]
    for name in ("to_xarray", "to_pandas", "to_dict"):
        export = getattr(value, name, None)
        if export is not None and not (name == "to_xarray" and not hasattr(type(value), "to_xarray")):
            yield export()


def written_to(value):
    """Changes a value in place wherever it can be changed."""
    if isinstance(value, np.ndarray):
        if value.flags.writeable and value.size and value.dtype != np.bool_:
            value[...] = 0
    elif isinstance(value, list):
        for one in value:
            written_to(one)
        value.clear()
    elif isinstance(value, dict):
        value.clear()
    elif hasattr(value, "data_vars"):
        for name in value.data_vars:
            if value[name].dtype.kind == "f":
                value[name] /= 1000
                value[name].values[...] = 0
    elif hasattr(value, "select_dtypes"):
        for name in value.select_dtypes("number"):
            value[name] *= 0
            written_to(value[name].to_numpy())


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("of", RESULTS)
def test_what_a_result_gives_does_not_change_it(case, of):
    pytest.importorskip("pandas"), pytest.importorskip("xarray")
    result = RESULTS[of](case)
    for one in (result, pickle.loads(pickle.dumps(result))):
        before = copy.deepcopy(one.to_dict())
        for part in parts(one):
            written_to(part)
        assert same(one.to_dict(), before)


def test_arrays_of_a_result_are_read_only(case):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        losses, contact, fields = asperity.map(case, **AXES, band="none"), case.contact(), case.run(band=False).fields()
    for result, names in ((losses, ["loss_w", "regime"]), (contact, ["gap", "pressure", "x"]), (fields, ["gap", "x"]), (asperity.hertz([1e5], 0.01, 1e11), ["half_width"])):
        for name in names:
            with pytest.raises(ValueError, match="read-only"):
                getattr(result, name)[...] = 0


def test_a_law_may_change_its_conditions_in_place(case):
    def law(at):
        load = at.load
        load *= 0
        return 0.03 + load

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert case.with_laws(film_friction=law).run("losses").loss_w == case.with_laws(film_friction=lambda at: 0.03).run("losses").loss_w


def test_a_key_in_pint_is_read_in_its_unit(case):
    registry = units()
    given = {"gears.module": (1.8, "mm", "1.8 mm"), "operation.torque": (0.145, "kN*m", "145 N m"), "operation.bulk_temperature": (90, "degC", "90 °C")}
    for key, (value, unit, text) in given.items():
        table, name = key.split(".")
        assert case.replace({key: registry.Quantity(value, unit)}).to_dict()[table][name] == text
