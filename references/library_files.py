#!/usr/bin/env python3
"""Make the files of crates/profile-io/tests/made: HDF5 with h5py, which uses the library in C, and xls with xlwt.

The surface has 120 columns and 6 rows; height of column i in row j: (i + 100 j) nm, none at column 2 of row 3.
The workbook has 200 points at 0.5 um; height of point i: 0.1 (i % 7) + 0.025 (i % 3) um.

Usage: library_files.py FOLDER
"""

import sys
from pathlib import Path

import h5py
import numpy as np
import xlwt

COLUMNS, ROWS = 120, 6
NM = np.arange(COLUMNS)[None, :] + 100.0 * np.arange(ROWS)[:, None]
NO_DATA = np.finfo(np.float64).max


def own(path: Path) -> None:
    """Arrays of a script: heights in a group, chunked and packed, beside a text and a list of places."""
    with h5py.File(path, "w", libver="latest") as file:
        group = file.create_group("flank")
        group.create_dataset("z", data=NM.astype(np.float32), chunks=(5, 7), compression="gzip", shuffle=True)
        group.create_dataset("x", data=np.arange(COLUMNS) * 0.5)
        file["remark"] = "made for a test"
        # Links in a circle.
        for name in "abcdefghij":
            group[name] = group


def matlab(path: Path) -> None:
    """Level 7.3: HDF5 behind 512 bytes, a matrix with its sizes in reverse order."""
    with h5py.File(path, "w", userblock_size=512) as file:
        matrix = file.create_dataset("Z", data=NM.T.copy(), chunks=(COLUMNS, ROWS), compression="gzip")
        matrix.attrs["MATLAB_class"] = np.bytes_("double")
        name = file.create_dataset("name", data=np.frombuffer("flank".encode("utf-16-le"), dtype=np.uint16)[:, None])
        name.attrs["MATLAB_class"] = np.bytes_("char")
        file.create_group("#refs#").create_dataset("a", data=np.zeros((3, 3)))
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, made for a test".ljust(116) + bytes(8) + b"\x00\x02IM")


def datx(path: Path, unit: str, per_nm: float, mark: float = NO_DATA) -> None:
    """Zygo Mx: one surface with the converters of its axes; parameters 1 to 3 of Z give a fringe of 300 nm."""
    text = h5py.string_dtype()
    kind = np.dtype([("Category", text), ("BaseUnit", text), ("Parameters", h5py.vlen_dtype(np.float64))])

    def converter(category: str, base: str, parameters: list[float]) -> np.ndarray:
        row = np.empty(1, dtype=kind)
        row[0] = (category, base, np.array(parameters))
        return row

    with h5py.File(path, "w") as file:
        heights = NM * per_nm
        heights[3, 2] = mark
        surface = file.create_dataset("/Data/Surface/{00000000-0000-0000-0000-000000000001}", data=heights)
        surface.attrs["X Converter"] = converter("LateralCat", "Pixels", [0, 5e-7, 0, 0])
        surface.attrs["Y Converter"] = converter("LateralCat", "Pixels", [0, 2e-6, 0, 0])
        surface.attrs["Z Converter"] = converter("HeightCat", unit, [0, 6e-7, 0.5, 1])
        surface.attrs["Unit"] = np.array([unit], dtype=text)
        surface.attrs["No Data"] = np.array([mark])


def workbook(path: Path) -> None:
    """A sheet of remarks, whose texts fill several records, and a sheet with whole numbers, hundredths and doubles."""
    book = xlwt.Workbook()
    remarks = book.add_sheet("remarks")
    for row in range(300):
        remarks.write(row, 0, f"remark {row} " + "äµλ"[row % 3] * (row % 30) + "Ω" * (row % 2))
    sheet = book.add_sheet("profile")
    sheet.write(0, 0, "Part")
    sheet.write(0, 1, "flank 7")
    for column, label in enumerate(["Position (mm)", "Height (µm)", "Temperature"]):
        sheet.write(1, column, label)
    for i in range(200):
        for column, value in enumerate([0.0005 * i, 0.1 * (i % 7) + 0.025 * (i % 3), 20 + i % 2]):
            sheet.write(i + 2, column, value)
    book.save(str(path))


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    own(folder / "own.h5")
    matlab(folder / "level_7_3.mat")
    datx(folder / "nanometres.datx", "NanoMeters", 1.0)
    datx(folder / "fringes.datx", "Fringes", 1 / 300)
    datx(folder / "furlongs.datx", "Furlongs", 1.0)
    workbook(folder / "workbook.xls")
