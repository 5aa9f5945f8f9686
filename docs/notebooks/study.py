"""A study in one script; its flanks and curves are synthetic."""

import dask
import numpy as np

import asperity


def flank(rq: float, seed: int) -> asperity.Profile:
    """A ground flank: filtered noise of rq in m, over 4 mm in steps of 0.5 um."""
    points, spacing = 8001, 0.5e-6
    noise = np.random.default_rng(seed).standard_normal(points)
    lengths = np.fft.rfftfreq(points, spacing)
    spectrum = np.fft.rfft(noise) / (1 + (lengths * 80e-6) ** 2) ** 0.65
    heights = np.fft.irfft(spectrum, points)
    return asperity.Profile(heights * rq / heights.std(), spacing, name=f"rq {rq * 1e6:g} um")


class Limited:
    """Film friction by a limiting shear stress that falls with the temperature of the flanks."""

    name = "limited"

    def __init__(self, limit: float = 0.045) -> None:
        self.limit = limit

    def __call__(self, at: asperity.Record) -> np.ndarray:
        cooled = self.limit * (1 - 0.002 * (at.bulk_temperature - 363.15))
        return cooled * np.tanh(np.abs(at.sliding) / (0.02 * at.entrainment))


def loss(case: asperity.Case, limit: float) -> float:
    """Loss in W with another limit; a task of Dask."""
    return case.with_laws(film_friction=Limited(limit)).run("losses", threads=1).loss_w


def main() -> None:
    ground, fine = flank(0.40e-6, seed=1), flank(0.12e-6, seed=2)
    print({flank.name: round(flank.parameters()["rk_um"], 2) for flank in (ground, fine)})

    case = asperity.Case(
        title="study",
        gears={"teeth": [23, 68], "module": "1.8 mm", "helix": "23.4 deg", "face_width": ["35 mm", "32 mm"]},
        torque_nm=145, speed_rpm=9000, temperature_c=90,
        lubricant={"oil": "m100"},
        surface={"pinion": ground, "cutoff": "0.25 mm"},
        model={"positions": 6, "offsets": 4},
    )
    found = asperity.compare(case, {"ground": ground, "fine": fine})
    print(found.verdicts)

    own = case.with_laws(film_friction=Limited())
    print(own.run("losses").loss_w, case.run("losses").loss_w)

    finishes = {"ground": ground, "fine": fine}
    map = asperity.map(case, torque_nm=[-150, -50, 50, 150], speed_rpm=[1000, 6000, 16000], finishes=finishes)
    losses = map.to_xarray().loss_w.sel(torque_nm=150, finish="fine")
    print(losses.attrs, losses.values)
    print(map.loss_torque(torque_nm=[60, 120], speed_rpm=4000, finish="fine"))

    seconds = np.arange(0.0, 61.0)
    trace = {"time_s": seconds, "torque_nm": 60 * np.sin(seconds / 9), "speed_rpm": 4000 + 60 * seconds}
    for finish in asperity.cycle(map, trace).finishes:
        print(finish)

    curves = asperity.oil_traction("m100", temperature_c=[40, 80])
    columns = ("load_n", "mean_speed_m_s", "slide_roll_percent", "temperature_c", "traction")
    fit = asperity.oil_fit({name: curves.over_slide[name] for name in columns}, "m100")
    print(fit.constants.to_pandas()[["name", "value", "unit"]])
    print(fit.apply(case, "m100-fit").run("losses").loss_w)

    tasks = [dask.delayed(loss)(case, limit) for limit in (0.03, 0.045, 0.06)]
    print(dask.compute(*tasks, scheduler="processes", num_workers=2))


if __name__ == "__main__":
    main()
