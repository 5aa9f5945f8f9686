"""Laws over arrays."""

import numpy as np
import pytest

import asperity

FILM = dict(entrainment=4.567909, radius="11.62688 mm", load="113.409 N/mm", modulus="115.3846 GPa",
            viscosity="97.5 mPa s", pressure_viscosity="20 1/GPa")


def test_hertz_is_broadcast():
    found = asperity.hertz([[1e5], [4e5]], ["10 mm", "20 mm", "40 mm"], "115 GPa")
    assert found.half_width.shape == (2, 3)
    # b goes with the root of load times radius.
    assert found.half_width[1, 2] == pytest.approx(4 * found.half_width[0, 0], rel=1e-14)
    assert np.allclose(found.mean_pressure, np.pi / 4 * found.max_pressure)
    assert isinstance(asperity.hertz(1e5, 0.01, 115e9).half_width, float)


def test_the_film_of_the_reference_pitch_point():
    # Doc test of FilmLaw::film: 1.366 um with the load on the whole contact length.
    paper = asperity.film_thickness("hamrock-dowson", contact_length="50 mm", **FILM)
    assert paper.central == pytest.approx(1.366e-6, abs=1e-9) and paper.outside and paper.notes


@pytest.mark.parametrize("law", ["steady", "dowson-toyoda", "moes", "ertel-grubin", "hamrock-dowson-line"])
def test_films_grow_with_speed(law):
    found = asperity.film_thickness(law, **{**FILM, "entrainment": np.linspace(1, 20, 30)})
    assert np.all(np.diff(found.central) > 0) and np.all(found.minimum < found.central)


def test_heat_thins_films():
    found = asperity.thermal_reduction(
        max_pressure="1 GPa", modulus="115 GPa", loading=[0.0, 0.5, 5.0], slide_to_roll=0.2
    )
    assert found.factor[0] == 1.0 and np.all(np.diff(found.factor) < 0)


def test_friction_laws():
    assert np.all(asperity.friction_coefficient("constant", settings={"constant": 0.05}).coefficient == 0.05)
    rollers = asperity.friction_coefficient(
        "benedict-kelley", load="300 N/mm", viscosity="10 mPa s", sliding=[0.0, 1.0, 4.0], entrainment=10.0,
        mean_ra="0.4 um",
    )
    assert rollers.coefficient[0] == 0.0 and rollers.coefficient[1] > rollers.coefficient[2] > 0


def test_what_a_law_lacks_is_refused():
    with pytest.raises(asperity.AsperityError) as refused:
        asperity.friction_coefficient("benedict-kelley", sliding=1.0)
    assert refused.value.code == "E205" and "requires load, entrainment, viscosity, mean_ra" in refused.value.message
    with pytest.raises(asperity.AsperityError, match="unknown variant"):
        asperity.film_thickness("nobody", **FILM)
    with pytest.raises(TypeError, match="speed"):
        asperity.friction_coefficient(speed=1.0)
    with pytest.raises(asperity.AsperityError, match="fit each other"):
        asperity.hertz([1.0, 2.0], [1.0, 2.0, 3.0], 1e9)
