"""How far interpolation on a map is off, and whether a map is what `asperity run` gives.

    python references/map_interpolation.py fixtures/cases/e-drive.toml [asperity]

Draws 1000 points evenly over both signs of torque from 5 % of the largest on and over all speeds, solves each as a case of
a sweep, and interpolates them bilinearly in loss torque on maps of several axes. Then 40 nodes of the map of default axes
are run one by one and compared to the last digit. Needs nothing but the command; half an hour of one core.
"""
import bisect
import csv
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

POINTS, NODES, SEED = 1000, 40, 7
# Numbers of torques of one sign and of speeds above 1 1/min; None is the default.
AXES = [(4, 16), (6, 16), (8, 16), (None, None), (24, 16), (12, 4), (12, 8), (12, 32)]


def asperity(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, arguments))}\n{done.stderr}")
    return done.stdout


def grid(case, folder, torques, speeds, most):
    """Loss torque by torque and speed on a map."""
    given = []
    if torques:
        step = 0.01 ** (-1 / (torques - 1))
        up = [most[0] * 0.01 * step**k for k in range(torques)]
        given += ["--torque=" + ",".join(f"{t:.4f}" for t in [-t for t in up] + [0] + up)]
        given += ["--speed=" + ",".join(f"{n:.4f}" for n in [0, 1] + [most[1] * (k / speeds) ** 2 for k in range(1, speeds + 1)])]
    asperity("map", case, "-o", folder, "--band", "none", "--quiet", *given)
    with open(folder / "map.csv") as file:
        return {(float(row["torque_nm"]), float(row["speed_rpm"])): row for row in csv.DictReader(line for line in file if not line.startswith("#"))}


def interpolated(rows, axes, torque, speed):
    def cell(axis, at):
        k = min(max(bisect.bisect_right(axis, at) - 1, 0), len(axis) - 2)
        return k, (at - axis[k]) / (axis[k + 1] - axis[k])

    (i, s), (j, t) = cell(axes[0], torque), cell(axes[1], speed)
    at = lambda a, b: float(rows[axes[0][i + a], axes[1][j + b]]["loss_torque_nm"])
    return (1 - s) * ((1 - t) * at(0, 0) + t * at(0, 1)) + s * ((1 - t) * at(1, 0) + t * at(1, 1))


def main():
    case = Path(sys.argv[1]).resolve()
    draw = random.Random(SEED)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        maps = {}
        default = grid(case, folder / "default", None, None, None)
        most = [max(key[k] for key in default) for k in (0, 1)]
        points = []
        for _ in range(POINTS):
            torque = draw.choice([-1, 1]) * draw.uniform(0.05, 1) * most[0]
            points.append((torque, draw.uniform(1, most[1])))
        (folder / "points.csv").write_text("operation.torque [N m],operation.speed [1/min]\n" + "".join(f"{t!r},{n!r}\n" for t, n in points))
        study = folder / "study.toml"
        study.write_text(f'case = "{case}"\ncolumns = ["loss_w"]\n[sample]\nmethod = "list"\nfile = "points.csv"\n')
        asperity("sweep", "run", study, "--quiet")
        asperity("sweep", "merge", study, "-o", folder / "solved", "--quiet")
        with open(folder / "solved" / "sweep.csv") as file:
            losses = [float(row["loss_w"]) for row in csv.DictReader(file)]
        solved = [loss / (speed * math.pi / 30) for loss, (_, speed) in zip(losses, points)]

        print("| torques of one sign | speeds above 1 1/min | nodes | rms % | 95 % of the points within % | largest % |")
        print("|---|---|---|---|---|---|")
        for torques, speeds in AXES:
            rows = default if torques is None else grid(case, folder / f"{torques}-{speeds}", torques, speeds, most)
            axes = [sorted({key[k] for key in rows}) for k in (0, 1)]
            errors = sorted(abs(interpolated(rows, axes, *point) / value - 1) for point, value in zip(points, solved))
            rms = (sum(e * e for e in errors) / len(errors)) ** 0.5
            named = ("12 (default)", "16 (default)") if torques is None else (torques, speeds)
            of95 = errors[int(0.95 * len(errors))]
            print(f"| {named[0]} | {named[1]} | {len(rows)} | {1e2 * rms:.2f} | {1e2 * of95:.2f} | {1e2 * errors[-1]:.2f} |", flush=True)

        equal = 0
        nodes = [key for key, row in default.items() if key[1] and "extended" not in row["outside"]]
        for torque, speed in draw.sample(sorted(nodes), NODES):
            told = asperity("run", case, "--set", f"operation.torque={torque} N m", "--set", f"operation.speed={speed} 1/min", "--no-output", "--json")
            loss = json.loads(told)["summary"]["loss_w"]
            equal += loss == float(default[torque, speed]["loss_w"])
            if loss != float(default[torque, speed]["loss_w"]):
                print(f"{torque} N m, {speed} 1/min: run {loss!r}, map {default[torque, speed]['loss_w']}")
        print(f"{equal} of {NODES} nodes equal a run to the last digit")
        sys.exit(equal != NODES)


PROGRAM = sys.argv[2] if len(sys.argv) > 2 else "asperity"
main()
