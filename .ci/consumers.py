"""Reads every export of a map with its consumer and compares 100 points of four quadrants with the map."""
import csv, importlib.util, json, re, shutil, subprocess, sys
from pathlib import Path

program, place = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
out, name = place / "map" / "export", "case"
missing, failed = [], []


def have(module):
    found = importlib.util.find_spec(module) is not None
    if not found:
        missing.append(module)
    return found


def check(what, worst, limit):
    print(f"{what:<44} largest error {worst:.3e} N m, limit {limit:.1e}")
    if not worst <= limit:
        failed.append(what)


if not (have("numpy") and have("scipy")):
    sys.exit("numpy and scipy are needed to compare with")
import numpy as np
import scipy.io
from scipy.interpolate import LinearNDInterpolator, RegularGridInterpolator

rows = list(csv.DictReader(open(place / "map" / "map.csv")))
T = np.unique([float(r["torque_nm"]) for r in rows])
n = np.unique([float(r["speed_rpm"]) for r in rows])
L = np.array([float(r["loss_torque_nm"]) for r in rows]).reshape(len(T), len(n))
surface = RegularGridInterpolator((T, n), L)
k = np.arange(1, 101)
torque = T[0] + (T[-1] - T[0]) * (0.618034 * k % 1)
speed = n[-1] * (2 * (0.754878 * k % 1) - 1)
points = np.c_[torque, np.abs(speed)]
exact = surface(points)

# CSV
table = list(csv.DictReader(open(out / f"{name}.csv")))
value = np.array([float(r["loss_torque_nm"]) for r in table]).reshape(len(T), len(n))
check("csv", np.abs(RegularGridInterpolator((T, n), value)(points) - exact).max(), 1e-12)

# MAT-file level 4 by scipy
mat = scipy.io.loadmat(out / f"{name}.mat")
again = RegularGridInterpolator((mat["torque_nm"][:, 0], mat["speed_rpm"][0]), mat["loss_torque_nm"])
check("matlab, scipy", np.abs(again(points) - exact).max(), 1e-12)
table2d = mat["lossTorque"]
modelica = RegularGridInterpolator((table2d[1:, 0], table2d[0, 1:]), table2d[1:, 1:])
check("matlab lossTorque as CombiTable2Ds", np.abs(modelica(np.c_[torque, np.abs(speed) * np.pi / 30]) - exact).max(), 1e-9)

# Octave, interp2 and ADVISOR's variables
if shutil.which("octave"):
    listed = lambda v: "[" + " ".join(repr(float(x)) for x in v) + "]"
    script = f"""d = load('{out}/{name}.mat'); v = interp2(d.speed_rpm, d.torque_nm, d.loss_torque_nm, {listed(np.abs(speed))}, {listed(torque)});
printf('%.17g\\n', v); source('{out}/TX_{name}.m'); printf('%d %d %.17g %.17g\\n', size(tx_eff_map), min(tx_eff_map(:)), max(tx_eff_map(:)));"""
    said = subprocess.run(["octave", "--no-gui", "--quiet", "--eval", script], capture_output=True, text=True, check=True).stdout.split("\n")
    check("matlab, octave interp2", np.abs(np.array([float(x) for x in said[:100]]) - exact).max(), 1e-12)
    print("advisor, octave: rows, columns, least, most", said[100])
else:
    missing.append("octave")

# Modelica text
text = [line for line in open(out / f"{name}.txt").read().splitlines() if not line.startswith("#")]
size = re.match(r"double lossTorque\((\d+),(\d+)\)", text[0])
grid = np.array(" ".join(text[1:]).split(), float).reshape(int(size[1]), int(size[2]))
again = RegularGridInterpolator((grid[1:, 0], grid[0, 1:]), grid[1:, 1:])
check("modelica text", np.abs(again(np.c_[torque, np.abs(speed) * np.pi / 30]) - exact).max(), 1e-9)

# VECTO: Delaunay over (input speed, input torque - loss), the input torque found from the output torque
data = np.array([[float(c) for c in line.split(",")] for line in open(out / f"{name}.vtlm") if line[0] not in "#I"])
scale = np.array([data[:, 0].max(), np.ptp(data[:, 1] - data[:, 2])])
lookup = LinearNDInterpolator(np.c_[data[:, 0], data[:, 1] - data[:, 2]] / scale, data[:, 2])
inside = np.abs(torque) < 0.98 * T[-1]
output = torque - exact
loss = lookup(np.c_[np.abs(speed), output] / scale)
own = np.abs(loss - exact)[inside]
# Within the error of triangles against rectangles: half the twist of a cell.
i = np.clip(np.searchsorted(T, torque) - 1, 0, len(T) - 2)
j = np.clip(np.searchsorted(n, np.abs(speed)) - 1, 0, len(n) - 2)
cell = np.maximum.reduce([L[i, j], L[i + 1, j], L[i, j + 1], L[i + 1, j + 1]]) - np.minimum.reduce([L[i, j], L[i + 1, j], L[i, j + 1], L[i + 1, j + 1]])
share = (own / cell[inside]).max()
print(f"{'vecto, Delaunay as its lookup':<44} largest error {own.max():.3e} N m, {share:.2f} of the range of the cell")
if not share < 0.5:
    failed.append("vecto")

# FMU
if have("fmpy"):
    import fmpy
    from fmpy.validation import validate_fmu

    fmu = str(out / f"{name}.fmu")
    problems = validate_fmu(fmu)
    print("fmu, problems:", problems)
    if problems:
        failed.append("fmu description")
    signal = np.array([(float(t), a, b * np.pi / 30) for t, (a, b) in enumerate(zip(torque, speed))],
                      dtype=[("time", float), ("tau", float), ("omega", float)])
    # A step of co-simulation ends with the outputs of the inputs that it began with.
    for kind, later in (("CoSimulation", 1), ("ModelExchange", 0)):
        found = fmpy.simulate_fmu(fmu, fmi_type=kind, start_time=0, stop_time=99 + later, input=signal,
                                  output=["loss_torque", "outside"], output_interval=1, step_size=1)
        last = np.array([found["loss_torque"][np.isclose(found["time"], t + later)][-1] for t in range(100)])
        check(f"fmu, fmpy {kind}", np.abs(last - exact).max(), 1e-9)

# CO2MPAS: its own function where it is here, else the equation it has
fit = json.load(open(out / f"{name}_co2mpas.json"))
hot = fit["gear_box_efficiency_parameters_cold_hot"]["hot"]
node = [(t, s) for t in T if t > 0 for s in n if s > 0]
Tn, Sn = np.array(node).T
Ln = surface(np.c_[Tn, Sn])
found = (Tn - Ln + hot["gbp00"] + hot["gbp10"] * Sn) / hot["gbp01"]
check("co2mpas, equation", np.abs(found - Tn).max(), 1.001 * fit["fit"]["hot"]["residual_max_nm"] / hot["gbp01"])
if have("co2mpas"):
    from co2mpas.core.model.physical.gear_box import calculate_gear_box_powers_in_hot as powers_in
    w = Sn * np.pi / 30
    ratio = 68 / 23
    p_out = (Tn - Ln) * w / 1000
    p_in = powers_in({"hot": hot}, p_out, Sn / ratio, Sn)
    check("co2mpas, its function", np.abs(p_in * 1000 / w - Tn).max(), 1.001 * fit["fit"]["hot"]["residual_max_nm"] / hot["gbp01"])

# fastsim takes the number
number = json.load(open(out / f"{name}_fastsim.json"))["eff_interp"]["Interp0D"]
if have("fastsim"):
    import fastsim
    vehicle = fastsim.Vehicle.from_resource("2022_Renault_Zoe_ZE50_R135.yaml").to_pydict()
    kind = next(iter(vehicle["pt_type"]))
    before = vehicle["pt_type"][kind]["transmission"]["eff_interp"]
    vehicle["pt_type"][kind]["transmission"]["eff_interp"] = {"Interp0D": number} if isinstance(before, dict) else number
    drive = fastsim.SimDrive(fastsim.Vehicle.from_pydict(vehicle), fastsim.Cycle.from_resource("udds.csv"))
    drive.walk()
    print(f"fastsim ran UDDS with a transmission of {number:.6f}")

print("left out, not here:", ", ".join(missing) or "nothing")
sys.exit("failed: " + ", ".join(failed) if failed else 0)
