"""Measures the page: its size, and its time for e-drive beside that of the command on one thread.

    python crates/web/measure.py [--write]

ASPERITY_PAGE and ASPERITY_PROGRAM as for the tests; --write puts a picture of the page into docs/figures. The size has a
limit; times are printed with the load of the machine.
"""

import gzip
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import brotli

sys.path.insert(0, str(Path(__file__).parent / "tests"))
from page import browser, ended, open_page, served

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path(os.environ.get("ASPERITY_PAGE", ROOT / "target/web"))
PROGRAM = os.environ.get("ASPERITY_PROGRAM", str(ROOT / "target/release/asperity"))
PICTURE = ROOT / "docs/figures/web.png"
CASE = ROOT / "fixtures/cases/e-drive.toml"
TIMES = 7
LARGEST = 3e6
TIMES_NATIVE = 3


def sizes():
    """Bytes of the page without its worked cases: as it is, by gzip -9, by brotli."""
    files = [path.read_bytes() for path in sorted(FOLDER.iterdir()) if path.is_file()]
    return [sum(map(len, map(by, files))) for by in (bytes, lambda data: gzip.compress(data, 9), brotli.compress)]


def native():
    """Seconds of the command, by the clock and on the processor."""
    spent = lambda: sum(os.times()[2:4])
    begin, before = time.perf_counter(), spent()
    run = [PROGRAM, "run", str(CASE), "--threads", "1", "--no-output", "--json"]
    subprocess.run(run, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - begin, spent() - before


def in_page(page, session):
    """The same of the page, on the processor with all that the browser does for it meanwhile."""
    spent = lambda: {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}["ProcessTime"]
    before = spent()
    page.click("#demo")
    page.wait_for_selector("form[data-run=running]")
    assert ended(page) == "done"
    return float(re.search(r"([\d.]+) s", page.inner_text("#time"))[1]), spent() - before


def main():
    plain, gzipped, brotlied = sizes()
    load = os.getloadavg()[0]
    with browser() as chromium, served(FOLDER) as (address, _):
        page = open_page(chromium.new_context(viewport={"width": 1280, "height": 840}), address)
        session = page.context.new_cdp_session(page)
        session.send("Performance.enable")
        # In turn, so that what else the machine does weighs on both.
        runs = [(*in_page(page, session), *native()) for _ in range(TIMES)]
        version = chromium.version
        if "--write" in sys.argv:
            page.frame_locator("#report").locator("h1").wait_for()
            page.evaluate("() => scrollTo(0, 0)")
            page.wait_for_timeout(500)
            page.screenshot(path=PICTURE)
    wall, cpu, wall_native, cpu_native = map(min, zip(*runs))
    table = "\n".join([
        f"Measured by `crates/web/measure.py` in Chromium {version} (load {load:.1f} on {os.cpu_count()} cores before), best of {TIMES}:",
        "",
        "| measured | | at most |",
        "|---|---|---|",
        f"| the page, by `gzip -9` | {gzipped / 1e6:.2f} MB | {LARGEST / 1e6:.0f} MB |",
        f"| by brotli | {brotlied / 1e6:.2f} MB | - |",
        f"| not compressed | {plain / 1e6:.1f} MB | - |",
        f"| e-drive by the clock: first run of the page, best, the command on one thread | {runs[0][0]:.2f}, {wall:.2f}, {wall_native:.2f} s | - |",
        f"| page over command | {wall / wall_native:.2f} | {TIMES_NATIVE} |",
        f"| e-drive on the processor: page with its browser, the command | {cpu:.2f}, {cpu_native:.2f} s | - |",
        f"| page over command | {cpu / cpu_native:.2f} | {TIMES_NATIVE} |",
    ])
    print(table)
    if gzipped > LARGEST:
        sys.exit("the page is too large")
    if cpu / cpu_native > TIMES_NATIVE:
        print("NOTICE: the page takes longer than it should; was the machine idle?", file=sys.stderr)


if __name__ == "__main__":
    main()
