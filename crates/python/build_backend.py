"""Builds the wheel with maturin, and the source distribution from the files that git knows.

Where ASPERITY_GLIBC is set, as 2.28, the module is linked by zig against that version of glibc.
"""

import contextlib
import gzip
import io
import json
import os
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import maturin
from maturin import (  # noqa: F401
    get_requires_for_build_editable,
    get_requires_for_build_sdist,
    get_requires_for_build_wheel,
    prepare_metadata_for_build_editable,
    prepare_metadata_for_build_wheel,
)

ROOT = Path(__file__).resolve().parents[2]
# Folders that the module is not built from.
LEFT_OUT = (".ci/", ".github/", "docs/", "fuzz/", "references/", "crates/profile-io/fuzz/", "crates/web/")
NOTE = "asperity: compiling the module, some 10 minutes of processor time (3 minutes on 4 cores); pip install -v shows the progress"


def _say_that_it_compiles():
    """Prints the note, on the terminal too: pip shows the output of a build only with -v or if it fails."""
    print(NOTE, flush=True)
    with contextlib.suppress(OSError), open("/dev/tty", "w", encoding="utf-8") as terminal:
        terminal.write(f"\n{NOTE}\n")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    _say_that_it_compiles()
    arguments = f"--locked --compression-level 9 {os.environ.get('MATURIN_PEP517_ARGS', '')}"
    if glibc := os.environ.get("ASPERITY_GLIBC"):
        arguments += f" --zig --compatibility manylinux_{glibc.replace('.', '_')}"
    os.environ["MATURIN_PEP517_ARGS"] = arguments
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    _say_that_it_compiles()
    return maturin.build_editable(wheel_directory, config_settings, metadata_directory)


def _files():
    """The files that the wheel is built from: those that git knows, or all where there is no git."""
    try:
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True).stdout
        names = [name for name in listed.decode().split("\0") if name and (ROOT / name).is_file()]
    except (OSError, subprocess.CalledProcessError):
        names = [
            path.relative_to(ROOT).as_posix()
            for path in ROOT.rglob("*")
            if path.is_file() and not {"target", ".venv", "__pycache__"} & set(path.relative_to(ROOT).parts)
        ]
    return sorted(name for name in names if not name.startswith(LEFT_OUT) and not name.endswith(".abi3.so"))


def build_sdist(sdist_directory, config_settings=None):
    """The files of the workspace that the module is built from."""
    metadata = Path(sdist_directory) / "metadata"
    prepare_metadata_for_build_wheel(str(metadata))
    information = next(metadata.glob("*.dist-info/METADATA")).read_bytes()
    shutil.rmtree(metadata)
    described = ["cargo", "metadata", "--no-deps", "--format-version", "1", "--manifest-path", "crates/python/Cargo.toml"]
    found = json.loads(subprocess.run(described, cwd=ROOT, check=True, capture_output=True).stdout)
    name = f"asperity-{found['packages'][0]['version']}"
    archive = Path(sdist_directory) / f"{name}.tar.gz"
    with open(archive, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed:
        with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as tar:
            for path in _files():
                entry = tar.gettarinfo(ROOT / path, f"{name}/{path}")
                entry.uid = entry.gid = entry.mtime = 0
                entry.uname = entry.gname = ""
                with open(ROOT / path, "rb") as content:
                    tar.addfile(entry, content)
            entry = tarfile.TarInfo(f"{name}/PKG-INFO")
            entry.size = len(information)
            tar.addfile(entry, io.BytesIO(information))
    return archive.name


if __name__ == "__main__":
    sys.exit(__doc__)
