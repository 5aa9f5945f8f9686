"""Newest symbols of glibc that the modules of wheels need; fails where they are newer than allowed.

    python3 .ci/glibc.py 2.28 asperity.whl ...

The versions stand as text in the dynamic section.
"""

import re
import sys
import zipfile


def needed(content):
    """Versions of glibc that an ELF file names, as numbers."""
    found = {match.group(1) for match in re.finditer(rb"\0GLIBC_(\d+(?:\.\d+)+)(?=\0)", content)}
    return {tuple(map(int, version.split(b"."))) for version in found}


def main(allowed, wheels):
    most = tuple(map(int, allowed.split(".")))
    failed = False
    for wheel in wheels:
        with zipfile.ZipFile(wheel) as archive:
            binaries = {name: archive.read(name) for name in archive.namelist()}
        binaries = {name: content for name, content in binaries.items() if content.startswith(b"\x7fELF")}
        if len(binaries) != 1:
            print(f"{wheel}: one module expected, found {', '.join(binaries) or 'none'}")
            failed = True
        for name, content in binaries.items():
            newest = max(needed(content), default=(0,))
            fits = newest <= most
            failed |= not fits
            text = ".".join(map(str, newest))
            print(f"{name}: {len(content) / 1e6:.1f} MB, GLIBC {text}{'' if fits else f', newer than {allowed}'}")
    return 1 if failed or not wheels else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
