"""Contacts against closed forms."""

import numpy as np
import pytest

import asperity
from conftest import trace

MODULUS, RADIUS, LOAD = 115e9, 0.01, 2e5


def parabola(points: int = 4001, spacing: float = 0.25e-6) -> np.ndarray:
    x = (np.arange(points) - (points - 1) / 2) * spacing
    return x**2 / (2 * RADIUS)


def test_a_smooth_contact_is_that_of_hertz():
    found = asperity.solve_contact(parabola(), 0.25e-6, MODULUS, LOAD)
    hertz = asperity.hertz(LOAD, RADIUS, MODULUS)
    # Cells of constant pressure: the error falls with the square of their length, 1e-5 here.
    assert found.p_max_pa == pytest.approx(hertz.max_pressure, rel=1e-4)
    assert found.pressure.sum() * 0.25e-6 == pytest.approx(LOAD, rel=1e-8)
    assert found.certificate.duality_gap <= 1e-8 and not len(found.warnings)
    assert found.pressure.shape == found.gap.shape == found.x.shape == (4001,)


def test_a_contact_does_not_depend_on_those_solved_before():
    rough = parabola() + 2e-8 * np.random.default_rng(1).standard_normal(4001)
    asperity.solve_contact(parabola(2001), 0.25e-6, MODULUS, LOAD)
    first = asperity.solve_contact(rough, 0.25e-6, MODULUS, LOAD)
    # The stored solver has this shape from here on.
    asperity.solve_contact(parabola(), 0.25e-6, MODULUS, 0.2 * LOAD)
    again = asperity.solve_contact(rough, 0.25e-6, MODULUS, LOAD)
    assert np.array_equal(first.pressure, again.pressure) and np.array_equal(first.gap, again.gap)
    assert first.approach == again.approach


def test_a_load_gives_the_approach_that_gives_the_load():
    by_load = asperity.solve_contact(parabola(), 0.25e-6, MODULUS, LOAD)
    by_approach = asperity.solve_contact(
        parabola(), 0.25e-6, MODULUS, approach=by_load.approach, datum=by_load.approach_datum_m
    )
    # The load of an approach hangs on the tolerance of both solutions.
    assert by_approach.load_n_per_m == pytest.approx(LOAD, rel=1e-6)


def test_everything_that_the_solver_takes():
    gap, limit = parabola(), 0.8e9
    flowing = asperity.solve_contact(gap, 0.25e-6, MODULUS, LOAD, pressure_limit=limit)
    assert flowing.p_max_pa <= limit * (1 + 1e-12) and flowing.plastic_displacement.max() > 0
    again = asperity.solve_contact(gap, 0.25e-6, MODULUS, LOAD, start=flowing.pressure, cascade=False, window=False)
    assert again.p_max_pa > limit
    film = np.full(len(gap), 1e6)
    pressed = asperity.solve_contact(gap, 0.25e-6, MODULUS, LOAD, prescribed_pressure=film)
    assert pressed.load_n_per_m == pytest.approx(LOAD, rel=1e-8)
    wave = 1e-7 * (1 - np.cos(2 * np.pi * np.arange(512) / 512))
    for boundary in ("periodic", "periodic-spectral"):
        full = asperity.solve_contact(wave, 1e-6, MODULUS, 5e5, boundary=boundary)
        assert full.approach_datum_m == 0 and 0 < full.contact_fraction <= 1


def test_a_profile_is_pressed_by_a_plane():
    by_profile = asperity.solve_contact(trace(), modulus=MODULUS, load="50 N/mm")
    by_gap = asperity.solve_contact(-trace().heights, 0.5e-6, MODULUS, 5e4)
    assert np.array_equal(by_profile.pressure, by_gap.pressure)


def test_two_flanks_run_in():
    arguments = dict(radius="10 mm", load="100 N/mm", modulus="115 GPa", pressure_limit="3 GPa")
    fresh = asperity.press_flanks(trace(2001), trace(2001).mirrored(), **arguments)
    worn = asperity.press_flanks(trace(2001), trace(2001).mirrored(), run_in=4, **arguments)
    cycles = worn.running_in
    assert cycles.plastic_energy_j_per_m[-1] < cycles.plastic_energy_j_per_m[0]
    assert worn.plastic_energy_j_per_m < fresh.plastic_energy_j_per_m


def test_stress_below_a_hertz_contact():
    found = asperity.solve_contact(parabola(), 0.25e-6, MODULUS, LOAD)
    half_width = asperity.hertz(LOAD, RADIUS, MODULUS).half_width
    stress = found.stress(np.linspace(0.5, 1.0, 51) * half_width)
    assert stress.von_mises.shape == (51, 4001)
    # Johnson 1985, 4.3: for ν = 0.3 the largest von Mises stress is 0.558 p0 at 0.704 b.
    assert stress.von_mises_max_pa == pytest.approx(0.558 * found.p_max_pa, rel=2e-3)
    assert stress.von_mises_depth_m == pytest.approx(0.704 * half_width, rel=2e-2)
    slid = found.stress([half_width], traction=0.1 * found.pressure)
    assert abs(slid.tau_xz).max() > abs(found.stress([half_width]).tau_xz).max()


def test_a_patch_of_equal_rows_is_its_line():
    pandas, _ = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    gap = parabola(401, 2e-6) + 5e-8 * np.sin(np.arange(401))
    of_line = asperity.solve_contact(gap, 2e-6, MODULUS, LOAD, tolerance=1e-11)
    rows = np.tile(gap, (6, 1))
    patch = asperity.solve_contact(rows, 2e-6, MODULUS, LOAD, lead_spacing="3 um", tolerance=1e-11)
    assert patch.pressure.shape == patch.gap.shape == (6, 401) and patch.y[[0, -1]] == pytest.approx([-7.5e-6, 7.5e-6])
    assert patch.pressure == pytest.approx(np.tile(of_line.pressure, (6, 1)), abs=1e-8 * of_line.p_max_pa)
    assert patch.approach == pytest.approx(of_line.approach, rel=1e-9) and of_line.y.tolist() == [0.0]
    # The largest pressure is where the gap is deepest, not at the same place of every row.
    rows[2] -= 1e-7
    uneven = asperity.solve_contact(rows, 2e-6, MODULUS, LOAD, lead_spacing=3e-6, start=patch.pressure)
    assert uneven.pressure.argmax() // 401 == 2
    assert uneven.to_xarray().pressure.dims == ("y", "x") and isinstance(uneven.to_pandas(), pandas.DataFrame)
    assert uneven.to_pandas().shape == (2406, 7) and "<svg" in uneven._repr_html_()
    for call in (lambda: asperity.solve_contact(gap, 2e-6, MODULUS, LOAD, lead_spacing=3e-6),
                 lambda: asperity.solve_contact(rows, 2e-6, MODULUS, LOAD, lead_spacing=3e-6, start=gap)):
        with pytest.raises(asperity.AsperityError, match="rows of points") as refused:
            call()
        assert refused.value.code == "E209"
    with pytest.raises(asperity.AsperityError, match="one dimension"):
        uneven.stress([1e-6])


def test_contacts_leave_for_other_packages():
    pytest.importorskip("xarray")
    found = asperity.solve_contact(parabola(), 0.25e-6, MODULUS, LOAD)
    assert found.to_xarray().pressure.attrs["units"] == "Pa"
    assert found.to_pandas().shape == (4001, 6)
    assert found.to_dict()["pressure"] == found.pressure.tolist()
    assert "<svg" in found._repr_html_() and "MPa" in repr(found)
