"""Compares the surfaces that asperity-profile-io reads with those of public readers.

    pip install numpy scipy SurfaceTopography surfalize prysm x3pio
    cargo build -p asperity-profile-io --example surface
    python references/readers.py target/debug/examples/surface FOLDER

FOLDER holds files of instruments, which are not part of the project. A line a file is printed: what
was read or the code of the refusal, and how it compares with every public reader that takes the file. Heights are compared in metres, after the same division by 1e3, 1e6 or 1e9 where the other reader has
another unit. "Shape" means equal after the mean of both is taken off.
"""

import io
import pathlib
import subprocess
import sys
import tempfile
import warnings

import numpy as np

warnings.simplefilter("ignore")
PER_METRE = {"m": 1.0, "mm": 1e3, "µm": 1e6, "μm": 1e6, "um": 1e6, "nm": 1e9, "pm": 1e12, None: 1.0}


def of_surface_topography(path):
    from SurfaceTopography.IO import open_topography

    reader = open_topography(str(path))
    kwargs = {} if reader.channels[0].physical_sizes is not None else {"physical_sizes": (1, 1)}
    found = reader.topography(**kwargs)
    heights = np.ma.filled(np.ma.array(found.heights(), dtype=float), np.nan)
    return np.atleast_2d(heights.T) / PER_METRE[found.unit]


def of_surfalize(path):
    from surfalize import Surface

    found = Surface.load(str(path))
    return np.asarray(found.data, dtype=float) / 1e6


def of_prysm(path):
    from prysm.io import read_zygo_dat

    return np.asarray(read_zygo_dat(str(path))["phase"], dtype=float) / 1e9


def of_x3pio(path):
    import x3pio

    layer = x3pio.read(str(path)).layers[0]
    if not layer.is_regular_grid:
        raise ValueError("no even grid")
    heights = np.array(layer.z, dtype=float)
    if layer.valid is not None:
        heights[~np.asarray(layer.valid, dtype=bool)] = np.nan
    return np.atleast_2d(heights)


def of_scipy(path):
    from scipy.io import loadmat

    (heights,) = [value for key, value in loadmat(path).items() if not key.startswith("__")]
    return heights.T.astype(float) if 1 in heights.shape else heights.astype(float)


def of_numpy(path):
    return np.atleast_2d(np.loadtxt(path))


READERS = {
    "SurfaceTopography": of_surface_topography,
    "surfalize": of_surfalize,
    "prysm": of_prysm,
    "x3pio": of_x3pio,
    "scipy": of_scipy,
    "numpy": of_numpy,
}
TAKEN = {
    ".mat": ["scipy"],
    ".txt": ["numpy", "SurfaceTopography"],
    ".dat": ["SurfaceTopography", "prysm", "surfalize"],
    ".x3p": ["x3pio", "SurfaceTopography", "surfalize"],
}


def verdict(ours, theirs):
    if theirs.shape != ours.shape:
        return f"{theirs.shape[1]} × {theirs.shape[0]} points"
    if (np.isnan(ours) != np.isnan(theirs)).any():
        return f"{int((np.isnan(ours) != np.isnan(theirs)).sum())} points missing in one only"
    known = ~np.isnan(ours)
    a, b = ours[known], theirs[known]
    if (a == b).all():
        return "bit-exact"
    span = np.ptp(a) or 1.0
    ulps = np.abs(a - b) / np.spacing(np.abs(a).max())
    if ulps.max() <= 8:
        return f"equal to {int(np.ceil(ulps.max()))} units in the last place"
    shape = np.abs((a - a.mean()) - (b - b.mean())).max() / span
    if shape < 1e-9:
        return "equal in shape"
    ratio = (b @ b / (a @ b)) if a @ b else np.nan
    return f"differs: theirs is {ratio:.6g} times ours"


def compared(path, ours):
    names = TAKEN.get(path.suffix.lower(), ["SurfaceTopography", "surfalize"])
    for name in names:
        try:
            sink, sys.stdout = sys.stdout, io.StringIO()
            try:
                theirs = READERS[name](path)
            finally:
                sys.stdout = sink
        except Exception as error:  # whatever the other reader raises is its refusal
            yield f"{name} refuses ({type(error).__name__})"
            continue
        turned = {
            "": theirs,
            " with the rows turned round": theirs[::-1],
            " with the columns turned round": theirs[:, ::-1],
            " as its transpose": theirs.T,
        }
        found = {how: verdict(ours, other) for how, other in turned.items()}
        best = next((how for how, said in found.items() if said == "bit-exact"), None)
        best = best or next((how for how, said in found.items() if said.startswith("equal")), "")
        yield f"{name}: {found[best]}{best}"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    files = sorted(path for path in folder.iterdir() if path.is_file())
    with tempfile.TemporaryDirectory() as raw:
        command = [program, "--raw", raw, *map(str, files)]
        lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
        for path, line in zip(files, lines, strict=True):
            said = line.split("\t")
            if said[1] == "refused":
                code, _, text = said[2].partition(" ")
                text = text.removeprefix(f"{path}: ")
                print(f"| {path.name} | refused, {code}: {text} | |", flush=True)
                continue
            shape = int(said[4]), int(said[3])
            ours = np.fromfile(pathlib.Path(raw) / f"{path.name}.f64").reshape(shape)
            other = "; ".join(compared(path, ours))
            print(f"| {path.name} | {said[2]}, {shape[1]} × {shape[0]} | {other} |", flush=True)


if __name__ == "__main__":
    main()
