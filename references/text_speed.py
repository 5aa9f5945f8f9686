"""Processor time of reading 10^6 points of each text format, beside the parsers that Python has for them.

    pip install pandas polars numpy; pip install .     # in the folder of the project
    python references/text_speed.py

The parsers in Python are told where the numbers stand and in which column; they look neither for units nor for the spacing,
and check nothing. The fastest of them counts, on one thread.
"""
import os

os.environ.setdefault("POLARS_MAX_THREADS", "1")
import math
import tempfile
import time
from pathlib import Path

import asperity
import numpy as np
import pandas as pd
import polars as pl

POINTS = 1_000_000
ROUNDS = 5


def heights():
    i = np.arange(POINTS)
    return 0.6 * np.sin(0.37 * i) + 0.3 * np.sin(0.011 * i)


def lines(form, values):
    return "".join(form % z for z in values)


def formats(z):
    """Name, text, keywords of the reader; for Python: lines before the numbers, separator, decimal sign, column of heights."""
    x = 0.5 * np.arange(POINTS)
    both = list(zip(x, z))
    yield "flank.csv", "x [um];z [um]\n" + "".join("%.1f;%.6f\n" % p for p in both), {}, (1, ";", ".", 1)
    comma = "".join("%.1f;%.6f\n" % p for p in both).replace(".", ",")
    yield "comma.csv", "x [um];z [um]\n" + comma, {}, (1, ";", ",", 1)
    yield "tabs.txt", "x [um]\tz [um]\n" + "".join("%.1f\t%.6f\n" % p for p in both), {}, (1, "\t", ".", 1)
    one = lines("%.6f\n", z)
    yield "column.txt", one, {"dx": 0.5e-6, "z_unit": "um"}, (0, ";", ".", 0)
    yield "npl.txt", "0.1\n" + one, {}, (1, ";", ".", 0)
    yield (
        "a.sig",
        "SigmaSurf_Data 1.0\nIDENTIFICATION: flank\nDATE: 20 Nov 2026 - 10:00\nSPACING_UM: 0.50000\n"
        f"NUMBER_OF_POINTS: {POINTS}\nPROFILE_UM:\n{one}",
        {},
        (6, ";", ".", 0),
    )
    yield (
        "a.pr",
        f"Profil a.pr\nX-len = {POINTS / 2000} X-resolution 2000.000000 points/scanline: {POINTS}\n{one}",
        {},
        (2, ";", ".", 0),
    )
    yield (
        "a.sdf",
        "aISO-1.0\nManufacID   = maker\nCreateDate  = 201120261000\n"
        f"NumPoints   = {POINTS}\nNumProfiles = 1\nXscale      = 5E-07\nYscale      = 0\nZscale      = 1.0E-6\n"
        f"Zresolution = -1\nCompression = 0\nDataType    = 7\nCheckType   = 0\n*\n{one}*\n",
        {},
        (13, ";", ".", 0),
    )
    yield (
        "a.prf",
        f"1 2\nSG2004 0.000000e+000 PRF\nCX M {POINTS} MM 1.000000e+000 D\nCZ M {POINTS} UM 1.000000e-006 L\nEOR\n"
        "STYLUS_RADIUS 2.0e-003 MM\nSPACING CX 5.000000e-004\nMAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\n"
        "MAP 2.000000e+000 CZ CX 1.000000e+000 0.000000e+000\nCOMMENT flank\nEOR\n"
        + lines("%.0f\n", 1e6 * z)
        + "EOR\nEOF\n",
        {},
        (11, ";", ".", 0),
    )
    yield (
        "a.smd",
        f"ISO 5436 - 2000 ground01\nPRF 1 ISO5436\nCX I {POINTS} mm 1.0e0 D 5.0e-4\nCZ A {POINTS} um 1.0e0 D\n\n"
        f"DATE 25-Nov-2004\nTIME 10:57\nCREATED_BY a laboratory\n\n{one}",
        {},
        (9, ";", ".", 0),
    )
    points = ("%d=%.9f 0.000000000 %.9f 0.000000000 0\n" % (i, 12 + 5e-4 * i, 1e-3 * h) for i, h in enumerate(z))
    yield (
        "mahr.txt",
        f"[PROFILE_HEADER]\nNAME=flank\nINTERVAL_LIN=0.000500000\nNO_POINTS={POINTS}\n[PROFILE_VALUES]\n// X,Y,Z,C,Lock\n"
        + "".join(points),
        {},
        (6, " ", ".", 2),
    )
    rows = 1000
    matrix = "\n".join("\t".join("%.6f" % h for h in row) for row in z.reshape(rows, -1))
    yield "matrix.txt", matrix + "\n", {"dx": 0.5e-6, "z_unit": "um", "row": 3}, (0, "\t", ".", None)


def pandas_c(path, skipped, separator, decimal, column):
    columns = None if column is None else [column]
    many = None if column is None else POINTS
    return pd.read_csv(
        path, sep=separator, decimal=decimal, skiprows=skipped, header=None, usecols=columns, nrows=many, engine="c"
    ).to_numpy()


def polars(path, skipped, separator, decimal, column):
    columns = None if column is None else [column]
    many = None if column is None else POINTS
    return pl.read_csv(
        path,
        separator=separator,
        decimal_comma=decimal == ",",
        skip_rows=skipped,
        has_header=False,
        columns=columns,
        n_rows=many,
    ).to_numpy()


def numpy_text(path, skipped, separator, decimal, column):
    if decimal == ",":
        raise ValueError("no decimal comma")
    many = None if column is None else POINTS
    return np.loadtxt(path, delimiter=separator, skiprows=skipped, usecols=column, max_rows=many)


def least(call):
    best = math.inf
    for _ in range(ROUNDS):
        start = time.process_time()
        call()
        best = min(best, time.process_time() - start)
    return best


def main():
    z = heights()
    print("| format | here, ms | fastest in Python, ms | | ratio |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, text, keywords, where in formats(z):
            path = Path(folder) / name
            path.write_text(text)
            profile = asperity.read_profile(path, **keywords)
            unit = 1e-3 if name.startswith("mahr") else 1e-12 if name.endswith(".prf") else 1e-6
            times = {}
            for parser in (pandas_c, polars, numpy_text):
                try:
                    found = np.asarray(parser(path, *where), dtype=float)
                except Exception as error:
                    print(f"<!-- {name}: {parser.__name__}: {str(error).splitlines()[0]} -->")
                    continue
                trace = found[2] if name.startswith("matrix") else found.ravel()
                # pandas rounds its last digit.
                assert np.allclose(unit * trace, profile.heights, rtol=1e-12, atol=1e-18), (name, parser.__name__)
                times[parser.__name__] = least(lambda: parser(path, *where))
            here = least(lambda: asperity.read_profile(path, **keywords))
            best = min(times, key=times.get)
            ratio = here / times[best]
            print(f"| {name} | {1e3 * here:.0f} | {1e3 * times[best]:.0f} | {best} | {ratio:.2f} |", flush=True)
            path.unlink()


if __name__ == "__main__":
    main()
