"""Laws written in Python: called with arrays, named in results, their exceptions raised."""

import pickle
import threading
import traceback

import numpy as np
import pytest

import asperity
from asperity import AsperityError
from conftest import CASES, SETS, small


@pytest.fixture(scope="module")
def drive():
    return asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 3})


class Xu:
    """The law of Xu by the package's own function, as another law."""

    name = "xu again"

    def __init__(self):
        self.calls = []
        self.threads = set()

    def __call__(self, at):
        self.calls.append(len(at.load))
        self.threads.add(threading.get_ident())
        names = ("load", "radius", "entrainment", "sliding", "max_pressure", "viscosity", "contact_viscosity",
                 "kinematic_viscosity", "pressure_viscosity", "central_film", "minimum_film", "combined_roughness",
                 "mean_ra", "sum_rz", "boundary_coefficient")
        return asperity.friction_coefficient("xu", **{name: at[name] for name in names}).coefficient


@pytest.mark.filterwarnings("ignore::asperity.AsperityWarning")
def test_a_friction_law_is_called_once_at_a_position_for_all_offsets(drive):
    law = Xu()
    own = drive.with_laws(film_friction=law)
    published = drive.replace({"model.film_friction": "xu"})
    assert own.run("losses").loss_w == pytest.approx(published.run("losses").loss_w, rel=1e-13)
    assert law.calls == [3] * 4
    law.calls.clear()
    result = own.run(band=False)
    rows = {row.key: row for row in result.defaults}
    assert rows["model.film_friction"].value == "xu again" and rows["model.film_friction"].source == "user-defined law"
    assert np.allclose(result.path.mu_film, published.run(band=False).path.mu_film, rtol=1e-13)


def film(at):
    """Martin's rigid isoviscous film, h = 2.45 η 2u R/w."""
    return 2.45 * at.viscosity * 2.0 * at.entrainment * at.radius / at.load


film.speed_exponent = 1.0


def test_a_film_law_and_a_load_share_have_closed_forms(drive):
    result = drive.replace({"model.thermal": "none"}).with_laws(film_thickness=film).run(band=False)
    path, viscosity = result.path, 1e-3 * result.lubricant.dynamic_viscosity_mpa_s
    expected = 2.45 * viscosity * 2 * path.entrainment_m_per_s * path.radius_mm * 1e-3 / (path.line_load_n_per_mm * 1e3)
    assert np.allclose(path.film_minimum_um * 1e-6, expected, rtol=1e-9)
    half = drive.with_laws(load_share=lambda at: np.where(at.film_ratio > 0, 0.25, 1.0)).run("losses")
    assert np.allclose(half.path.film_share, 0.25, rtol=1e-14)
    mixed = drive.with_laws(load_share=lambda at: {"film_share": 0.25, "boundary_part": 0.0, "lubricated_coefficient": 0.05})
    lubricated = mixed.run("losses")
    assert lubricated.summary.boundary_w == 0 and lubricated.loss_w < half.loss_w
    defaults = mixed.run(band=False).defaults
    assert "<lambda>" in list(defaults.value)


def test_a_load_distribution_moves_the_load(drive):
    seen = []

    def uniform(at):
        seen.append(len(at.s))
        assert at.path_fraction[0] >= 0 and at.path_fraction[-1] <= 1 and np.all(np.diff(at.s) > 0)
        return at.uniform

    own = drive.with_laws(load_distribution=uniform)
    named = drive.replace({"model.load_distribution": "uniform"}).gear()
    assert own.gear().law == "uniform" and own.gear().loss_factor_local == pytest.approx(named.loss_factor_local, rel=2e-3)
    reduced = drive.with_laws(load_distribution=lambda at: at.uniform * (1 - 0.5 * np.abs(2 * at.path_fraction - 1)))
    full, relieved = own.run("losses"), reduced.run("losses")
    assert seen and set(seen) == {256}
    assert relieved.path.line_load_n_per_mm[0] < full.path.line_load_n_per_mm[0]


def test_a_load_distribution_without_load_is_refused_by_its_name(drive):
    def empty(at):
        return 0.0

    own = drive.with_laws(load_distribution=empty)
    for work in (lambda: own.run("losses"), own.run, own.gear):
        with pytest.raises(AsperityError, match='"empty" returns no load at any position') as refused:
            work()
        assert refused.value.code == "E305"


def test_a_law_is_in_every_mesh_of_a_train():
    calls = []

    def limit(at):
        calls.append(len(at.load))
        return np.full_like(at.load, 0.03)

    train = asperity.Case(SETS["train"])
    own = train.with_laws(film_friction=limit)
    result = own.run(band=False)
    assert calls and result.loss_w != train.run(band=False).loss_w
    for mesh in result.meshes:
        assert np.allclose(mesh.path.mu_film, 0.03, rtol=1e-14)
    assert result.meshes[1].loss_w == own.mesh("z").run("losses").loss_w
    assert [row.value for row in own.defaults if row.get("source") == "user-defined law"] == ["limit"]
    slower = own.replace({"operation.speed": "1000 1/min"})
    assert np.allclose(slower.run(band=False).meshes[0].path.mu_film, 0.03, rtol=1e-14), "another key keeps the law"
    assert slower.defaults == slower.replace({"operation.speed": "1000 1/min"}).defaults


def test_an_exception_of_a_law_reaches_the_user_with_its_traceback(drive):
    def broken(at):
        return 1 / np.zeros(3)[at.nothing]

    for work in (lambda case: case.run("losses"), lambda case: case.run(), asperity.evidence,
                 lambda case: asperity.map(case, torque_nm=[100], speed_rpm=[1000], band="none")):
        with pytest.raises(AttributeError, match="nothing") as raised:
            work(drive.with_laws(film_friction=broken))
        assert "broken" in [frame.name for frame in traceback.extract_tb(raised.value.__traceback__)]
    assert drive.run("losses").loss_w > 0, "the next run is not concerned"


@pytest.mark.parametrize(
    ("law", "says"),
    [
        (lambda at: [0.05, 0.05], "2 values of coefficient for 3 conditions"),
        (lambda at: np.array([0.05, np.nan, 0.05]), "coefficient = nan at place 1"),
        (lambda at: -0.05, "coefficient = -0.05 at place 0"),
        (lambda at: {"mu": 0.05}, "returns mu"),
        (lambda at: {}, "no coefficient"),
        (lambda at: "much", "array of numbers"),
        (lambda at: None, "coefficient"),
    ],
)
def test_what_a_law_returns_is_checked(drive, law, says):
    with pytest.raises(AsperityError, match=says) as refused:
        drive.with_laws(film_friction=law).run("losses")
    assert refused.value.code in ("E204", "E209")


def test_a_law_that_lacks_something_is_refused(drive):
    with pytest.raises(AsperityError, match="speed_exponent") as refused:
        drive.with_laws(film_thickness=lambda at: at.load)
    assert refused.value.code == "E205"
    for exponent, code in (("x", "E204"), (np.nan, "E209"), (3, "E209")):
        wrong = lambda at: at.load  # noqa: E731
        wrong.speed_exponent = exponent
        with pytest.raises(AsperityError) as refused:
            drive.with_laws(film_thickness=wrong)
        assert refused.value.code == code
    with pytest.raises(AsperityError, match="callable"):
        drive.with_laws(film_friction=3)
    with pytest.raises(AsperityError):
        drive.with_laws(load_share=lambda at: 1.5).run("losses")


def constant(at):
    return np.full_like(at.load, 0.04)


def test_a_law_stays_in_changed_cases_maps_and_other_processes(drive):
    own = drive.with_laws(film_friction=constant)
    loss = own.replace(torque_nm=100).run("losses")
    assert np.allclose(loss.path.mu_film, 0.04, rtol=1e-14)
    again = pickle.loads(pickle.dumps(own.replace(torque_nm=100)))
    assert again.run("losses").loss_w == loss.loss_w
    found = asperity.map(own, torque_nm=[100], speed_rpm=[9000], band="none")
    assert found.loss_w[0, 0, -1, -1] == loss.loss_w
    rows = asperity.sweep(own, {"torque_nm": [100]}, columns=["loss_w"]).run()
    assert rows.loss_w[0] == loss.loss_w
    named = asperity.Case(small()).with_laws(film_friction=constant).run(band=False)
    assert "constant" in list(named.defaults.value)
