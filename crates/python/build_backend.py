"""Builds the wheel: the command with cargo, then the module with maturin, which puts both into it.

Where ASPERITY_GLIBC is set, as 2.28, both are linked by zig against that version of glibc.
"""

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
from maturin import get_requires_for_build_sdist, get_requires_for_build_wheel  # noqa: F401

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "target" / "asperity.data"
# Folders that neither command nor module is built from.
LEFT_OUT = (".ci/", ".github/", "docs/", "fuzz/", "references/", "crates/profile-io/fuzz/")


def _glibc():
    return os.environ.get("ASPERITY_GLIBC")


def _cargo(*arguments):
    subprocess.run(["cargo", *arguments], cwd=ROOT, check=True)


def _place_command():
    """Builds the command and puts it where maturin takes the data of the wheel from."""
    os.environ.setdefault("CARGO_TARGET_DIR", str(ROOT / "target"))
    target = Path(os.environ["CARGO_TARGET_DIR"])
    common = ("--profile", "dist", "--locked", "--package", "asperity-cli")
    triple = os.environ.get("CARGO_BUILD_TARGET")
    if _glibc():
        triple = triple or "x86_64-unknown-linux-gnu"
        os.environ["CARGO_BUILD_TARGET"] = triple
        _cargo("zigbuild", *common, "--target", f"{triple}.{_glibc()}")
    else:
        _cargo("build", *common)
    built = (target / triple if triple else target) / "dist"
    name = "asperity.exe" if (built / "asperity.exe").is_file() else "asperity"
    shutil.rmtree(DATA, ignore_errors=True)
    (DATA / "scripts").mkdir(parents=True)
    shutil.copy2(built / name, DATA / "scripts" / name)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    _place_command()
    arguments = os.environ.get("MATURIN_PEP517_ARGS", "")
    if _glibc():
        arguments += f" --zig --compatibility manylinux_{_glibc().replace('.', '_')}"
    os.environ["MATURIN_PEP517_ARGS"] = f"--locked {arguments}"
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    _place_command()
    return maturin.build_editable(wheel_directory, config_settings, metadata_directory)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    (DATA / "scripts").mkdir(parents=True, exist_ok=True)
    return maturin.prepare_metadata_for_build_wheel(metadata_directory, config_settings)


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
    """The whole workspace but its documents: the command is built from it as well as the module."""
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
