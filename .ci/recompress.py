"""Writes wheels anew with the smallest deflate that zopfli finds, and fails where one is larger than allowed.

    python3 .ci/recompress.py asperity.whl ...

The files of a wheel, and with them the sums of its RECORD, stay as they are.
"""

import struct
import sys
import zipfile
from pathlib import Path

from zopfli import zlib as zopfli

# A wheel above this size is refused.
LARGEST_MB = 9
DEFLATED, VERSION = 8, 20


def smallest(content):
    """The content as a deflate stream, without the frame of zlib."""
    return zopfli.compress(content, numiterations=5)[2:-4]


def fields(entry, packed):
    """What the header of an entry and its row in the directory both have."""
    year, month, day, hour, minute, second = entry.date_time
    date, time = (year - 1980) << 9 | month << 5 | day, hour << 11 | minute << 5 | second // 2
    return VERSION, 0, DEFLATED, time, date, entry.CRC, len(packed), entry.file_size


def written_anew(wheel):
    """The bytes of the wheel with every entry deflated anew."""
    written, directory = bytearray(), bytearray()
    with zipfile.ZipFile(wheel) as archive:
        entries = [(entry, archive.read(entry)) for entry in archive.infolist()]
    for entry, content in entries:
        packed, name = smallest(content), entry.filename.encode("ascii")
        both, start = fields(entry, packed), len(written)
        written += struct.pack("<4s5H3L2H", b"PK\3\4", *both, len(name), 0) + name + packed
        unix = 3 << 8 | VERSION
        directory += struct.pack("<4s6H3L5H2L", b"PK\1\2", unix, *both, len(name), 0, 0, 0, 0, entry.external_attr, start) + name
    count = len(entries)
    end = struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, count, count, len(directory), len(written), 0)
    return bytes(written + directory + end)


def contents(wheel):
    """Name, permissions and content of every entry; reading checks the sums."""
    with zipfile.ZipFile(wheel) as archive:
        return [(entry.filename, entry.external_attr, archive.read(entry)) for entry in archive.infolist()]


def main(wheels):
    failed = not wheels
    for wheel in map(Path, wheels):
        before, own = wheel.stat().st_size, contents(wheel)
        again = wheel.with_suffix(".new")
        again.write_bytes(written_anew(wheel))
        if contents(again) != own:
            sys.exit(f"{wheel}: written anew it has another content")
        again.replace(wheel)
        size = wheel.stat().st_size / 1e6
        print(f"{wheel}: {size:.2f} MB, {before / 1e6:.2f} MB before")
        if size > LARGEST_MB:
            print(f"{wheel}: at most {LARGEST_MB} MB")
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
