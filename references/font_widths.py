"""Widest advance of the ASCII characters in DejaVu Sans, Liberation Sans and Noto Sans, in thousandths of an em.

    python references/font_widths.py [FOLDER OF FONTS]      # /usr/share/fonts/truetype

Reads the tables `cmap` and `hmtx` of the fonts themselves. Held in `crates/report/src/chart/text_width.rs`.
"""
import re
import struct
import sys
from pathlib import Path

FONTS = ("dejavu/DejaVuSans.ttf", "liberation/LiberationSans-Regular.ttf", "noto/NotoSans-Regular.ttf")
HELD = Path(__file__).resolve().parents[1] / "crates/report/src/chart/text_width.rs"


def advances(file):
    """Advance of the characters of the basic plane by `cmap` format 4 [em]."""
    data = file.read_bytes()
    word = lambda at, form=">H": struct.unpack_from(form, data, at)[0]
    tables = {data[at : at + 4]: word(at + 8, ">L") for at in range(12, 12 + 16 * word(4), 16)}
    units, last = word(tables[b"head"] + 18), word(tables[b"hhea"] + 34) - 1
    advance = lambda glyph: word(tables[b"hmtx"] + 4 * min(glyph, last)) / units
    found = {}
    cmap = tables[b"cmap"]
    for index in range(word(cmap + 2)):
        start = cmap + word(cmap + 8 + 8 * index, ">L")
        if word(start) != 4:
            continue
        size = word(start + 6)
        ends, begins = start + 14, start + 16 + size
        for at in range(0, size, 2):
            delta, offset_at = word(begins + size + at), begins + 2 * size + at
            offset = word(offset_at)
            for code in range(word(begins + at), word(ends + at) + 1):
                glyph = word(offset_at + offset + 2 * (code - word(begins + at))) if offset else code
                found[chr(code)] = advance((glyph + delta) % 65536)
    return found


fonts = [advances(Path(*sys.argv[1:2] or ["/usr/share/fonts/truetype"]) / name) for name in FONTS]
widths = [round(1000 * max(font[chr(code)] for font in fonts)) for code in range(32, 127)]
held = [int(text) for text in re.findall(r"\d+", re.search(r"\[u16; 95\] = \[(.*?)\]", HELD.read_text(), re.S)[1])]
print(sum(a == b for a, b in zip(widths, held, strict=True)), "of", len(held))
sys.exit(widths != held)
