"""Reads every export of a map with its consumer, as it was written, and compares 100 points of four quadrants with the map."""
import csv, ctypes, importlib.util, os, re, shutil, subprocess, sys
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


def modelica():
    """The C functions of the Modelica Standard Library in the folder MODELICA_LIBRARY, as a library of this machine."""
    sources = Path(os.environ.get("MODELICA_LIBRARY", ".")) / "Modelica" / "Resources" / "C-Sources"
    if not sources.is_dir() or not shutil.which("cc"):
        return None
    tool = place / "tool.c"
    said = 'void NAME(const char *s) { fputs(s, stderr); END }\nvoid VNAME(const char *s, va_list a) { vfprintf(stderr, s, a); END }\n' \
        'void FNAME(const char *s, ...) { va_list a; va_start(a, s); VNAME(s, a); END }\n'
    parts = ["#include <stdarg.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n"]
    for end, name in (("", "Message"), ("", "Warning"), ("abort();", "Error")):
        named = said.replace("VNAME", f"ModelicaVFormat{name}").replace("FNAME", f"ModelicaFormat{name}")
        parts.append(named.replace("NAME", f"Modelica{name}").replace("END", end))
    for name in ("", "WithErrorReturn"):
        parts.append(f"char *ModelicaAllocateString{name}(size_t n) {{ return calloc(n + 1, 1); }}\n")
        parts.append(f"char *ModelicaDuplicateString{name}(const char *s) {{ return strcpy(malloc(strlen(s) + 1), s); }}\n")
    tool.write_text("".join(parts))
    files = [sources / f"{file}.c" for file in ("ModelicaStandardTables", "ModelicaStandardTablesUsertab", "ModelicaIO", "ModelicaMatIO", "snprintf")]
    made = place / "modelica.so"
    flags = ["-shared", "-fPIC", "-O1", "-w", "-DDUMMY_FUNCTION_USERTAB", "-DTABLE_SHARE=0"]
    subprocess.run(["cc", *flags, "-I", sources, "-o", made, tool, *files, "-lm"], check=True)
    return ctypes.CDLL(str(made))


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

# Wide CSV, as numpy and a spreadsheet take it
with open(out / f"{name}_loss_torque_nm.csv") as file:
    across = [float(cell) for cell in next(csv.reader(file))[1:]]
    grid = np.loadtxt(file, delimiter=",")
check("wide", np.abs(RegularGridInterpolator((grid[:, 0], across), grid[:, 1:])(points) - exact).max(), 1e-12)

# MAT-file of level 5 by scipy, of one temperature and of two
mat = scipy.io.loadmat(out / f"{name}.mat")
again = RegularGridInterpolator((mat["torque_nm"][:, 0], mat["speed_rpm"][0]), mat["loss_torque_nm"])
check("matlab, scipy", np.abs(again(points) - exact).max(), 1e-12)
warm = scipy.io.loadmat(place / "warm" / "export" / f"{name}.mat")
rows = list(csv.DictReader(open(place / "warm" / "map.csv")))
shape = [len(np.unique([float(r[key]) for r in rows])) for key in ("temperature_c", "torque_nm", "speed_rpm")]
expected = np.array([float(r["loss_torque_nm"]) for r in rows]).reshape(shape).transpose(1, 2, 0)
check("matlab, scipy, two temperatures", np.abs(warm["loss_torque_nm"] - expected).max(), 1e-12)
numbers = [value for value in (*mat.values(), *warm.values()) if getattr(value, "dtype", None) == float]
print("matlab: arrays", len(numbers), "all finite", all(np.isfinite(value).all() for value in numbers))
if not all(np.isfinite(value).all() for value in numbers):
    failed.append("matlab, finite")

# Octave's interp2 and, over the temperature, interpn
if shutil.which("octave"):
    listed = lambda v: "[" + " ".join(repr(float(x)) for x in v) + "]"
    script = f"""d = load('{out}/{name}.mat'); v = interp2(d.speed_rpm, d.torque_nm, d.loss_torque_nm, {listed(np.abs(speed))}, {listed(torque)});
printf('%.17g\\n', v); w = load('{place}/warm/export/{name}.mat');
printf('%.17g\\n', interpn(w.torque_nm, w.omega_rad_s, w.temperature_c, w.loss_torque_nm, w.torque_nm(2), w.omega_rad_s(2), mean(w.temperature_c)));"""
    said = subprocess.run(["octave", "--no-gui", "--quiet", "--eval", script], capture_output=True, text=True, check=True).stdout.split()
    said = np.array(said, float)
    check("matlab, octave interp2", np.abs(said[:100] - exact).max(), 1e-12)
    check("matlab, octave interpn", abs(said[100] - expected[1, 1].mean()), 1e-12)
else:
    missing.append("octave")

# The readers of the Modelica Standard Library itself, compiled from its sources
if library := modelica():
    table = library.ModelicaStandardTables_CombiTable2D_init2
    table.restype = ctypes.c_void_p
    value = library.ModelicaStandardTables_CombiTable2D_getValue
    value.restype, value.argtypes = ctypes.c_double, [ctypes.c_void_p, ctypes.c_double, ctypes.c_double]
    linear, refuse = 1, 4
    opened = table(str(out / f"{name}.txt").encode(), b"lossTorque", (ctypes.c_double * 1)(), ctypes.c_size_t(0), ctypes.c_size_t(0), linear, refuse, 0)
    found = [value(opened, t, w) for t, w in zip(torque, np.abs(speed) * np.pi / 30)]
    check("modelica, CombiTable2Ds", np.abs(np.array(found) - exact).max(), 1e-9)
    file = str(out / f"{name}_lossy_gear.mat").encode()

    def matrix(of):
        sizes = (ctypes.c_int * 2)()
        library.ModelicaIO_readMatrixSizes(file, of, sizes)
        values = np.zeros(tuple(sizes))
        library.ModelicaIO_readRealMatrix(file, of, values.ctypes, *(ctypes.c_size_t(size) for size in sizes), 0)
        return values

    omega, eta1, eta2, tau1, tau2 = matrix(b"lossTable").T
    eta1, eta2, tau1, tau2 = (np.interp(np.abs(speed) * np.pi / 30, omega, column) for column in (eta1, eta2, tau1, tau2))
    # LossyGear: the torque less that of the bearing on the input side decides which flange drives.
    drives = torque - (tau1 - tau2) / (eta1 - 1 / eta2) >= 0
    loss = np.where(drives, (1 - eta1) * torque + tau1, (1 - 1 / eta2) * torque + tau2)
    print(f"lossy-gear: fit {matrix(b'fit_rms_nm')[0, 0]:.4f} N m rms, mean loss torque {L.mean():.4f} N m")
    # Between the nodes the lines leave no more than at them, but for 1/eta2 over the speed.
    check("lossy-gear", np.abs(loss - exact).max(), 1.01 * matrix(b"fit_max_nm")[0, 0])
else:
    missing.append("the Modelica Standard Library")

# VECTO, by the rules of its user manual ("VECTO CSV format", "Transmission Loss Map"): comments begin with #, one head of names
# with units in brackets, commas, decimal points; at least four rows; torques of both signs; losses not below 0.
lines = [line for line in open(out / f"{name}.vtlm", encoding="utf-8").read().splitlines() if not line.startswith("#")]
names = [re.sub(r"\[.*?\]", "", cell).strip() for cell in lines[0].split(",")]
data = np.array([line.split(",") for line in lines[1:]], float)
if names != ["Input Speed", "Input Torque", "Torque Loss"] or len(data) < 4 or np.isnan(data).any():
    failed.append("vecto, form")
if not (data[:, 1].min() < 0 < data[:, 1].max() and data[:, 2].min() >= 0):
    failed.append("vecto, signs")
# It looks up by triangles over input speed and output torque, which must not fold.
if np.min(np.diff((T[:, None] - L), axis=0)) <= 0:
    failed.append("vecto, output torque rises with input torque")
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

# FASTSim: the file is the transmission of a vehicle
if have("fastsim"):
    import fastsim
    import yaml

    part = yaml.safe_load(open(out / f"{name}_fastsim.yaml"))
    vehicle = fastsim.Vehicle.from_resource("2022_Renault_Zoe_ZE50_R135.yaml").to_dict()
    kind = next(iter(vehicle["pt_type"]))
    vehicle["pt_type"][kind]["transmission"] = part
    drive = fastsim.SimDrive(fastsim.Vehicle.from_dict(vehicle), fastsim.Cycle.from_resource("udds.csv"))
    drive.walk()
    ran = drive.to_dict()["veh"]["pt_type"][kind]["transmission"]
    state = ran["state"]
    print(f"fastsim ran UDDS: efficiency {ran['eff_interp']:.6f}, lost {state['energy_loss_joules'] / 3600:.2f} Wh")
    if ran["eff_interp"] != part["eff_interp"] or not state["energy_loss_joules"] > 0:
        failed.append("fastsim")

print("left out, not here:", ", ".join(missing) or "nothing")
sys.exit("failed: " + ", ".join(failed) if failed else 0)
