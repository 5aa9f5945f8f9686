"""Measures what the Python module costs.

    python crates/python/measure.py

Run it with the module installed, on an idle machine; the load is printed with the figures. It builds the example that
times the same contact in Rust.
"""

import json
import multiprocessing
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

import asperity

ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT / "fixtures" / "cases" / "e-drive.toml"
SPACING, MODULUS, LOAD = 1e-7, 115e9, 2e5
TIMES, SOLUTIONS = 41, 5


def rough_gap(points=100_000):
    """A parabola with noise: a contact of many patches."""
    x = (np.arange(points) - points / 2) * SPACING
    return x**2 / 0.02 + 2e-8 * np.random.default_rng(1).standard_normal(points)


def timed(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def contact():
    """Times of a contact of 1e5 points by the module and by the library, and the ratio of both: medians over turns in
    which each solves it once to warm up and takes the shortest of the next solutions."""
    gap = rough_gap()
    built = subprocess.run(
        ["cargo", "build", "--release", "--locked", "-p", "asperity-contact", "--example", "time_of_a_contact",
         "--message-format", "json"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    messages = [json.loads(line) for line in built.splitlines()]
    program = next(m["executable"] for m in messages if m.get("executable"))
    turns = []
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "gap.f64"
        gap.astype("<f8").tofile(file)
        for _ in range(TIMES):
            said = subprocess.run([program, file, str(SPACING), str(MODULUS), str(LOAD), str(SOLUTIONS)],
                                  check=True, capture_output=True, text=True).stdout.split()
            ours = min(timed(lambda: asperity.solve_contact(gap, SPACING, MODULUS, LOAD)) for _ in range(SOLUTIONS))
            assert asperity.solve_contact(gap, SPACING, MODULUS, LOAD).p_max_pa == float(said[2]), "another solution"
            turns.append((ours, float(said[0]), ours / float(said[0])))
    return tuple(map(statistics.median, zip(*turns)))


def start_time():
    """Median time of `asperity --version`, started anew, by the clock, in s."""
    program = Path(sys.executable).parent / "asperity"
    return statistics.median(timed(lambda: subprocess.run([program, "--version"], check=True, capture_output=True)) for _ in range(15))


def import_time():
    """Median time on the processor of importing the module after numpy, in s."""
    script = ("import numpy, time; t = time.process_time(); import asperity; print(time.process_time() - t)")
    runs = [subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True) for _ in range(15)]
    return statistics.median(float(run.stdout) for run in runs)


def two_threads():
    """Time of two solutions on two threads at once over that of one."""
    gap = rough_gap(400_000)
    solve = lambda: asperity.solve_contact(gap, SPACING, MODULUS, LOAD)

    def both():
        threads = [threading.Thread(target=solve) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    solve()
    return min(timed(both) for _ in range(7)) / min(timed(solve) for _ in range(7))


def _solve_when_told(barrier, times):
    gap = rough_gap(400_000)
    for _ in range(8):
        barrier.wait()
        times.put(timed(lambda: asperity.solve_contact(gap, SPACING, MODULUS, LOAD)))


def two_processes():
    """The same of two processes, which share nothing: what the machine itself allows."""
    barrier, times = multiprocessing.Barrier(2), multiprocessing.Queue()
    workers = [multiprocessing.Process(target=_solve_when_told, args=(barrier, times)) for _ in range(2)]
    for worker in workers:
        worker.start()
    both = [times.get() for _ in range(16)]
    for worker in workers:
        worker.join()
    gap = rough_gap(400_000)
    return statistics.median(both) / min(timed(lambda: asperity.solve_contact(gap, SPACING, MODULUS, LOAD)) for _ in range(7))


def interrupted():
    """Longest time from Ctrl-C to the end of a long run, in s."""
    script = (f"import asperity; case = asperity.Case({str(CASE)!r}).replace({{'model.positions': 1000, 'model.offsets': 200}})\n"
              "print('begun', flush=True)\ntry:\n    case.run()\nexcept KeyboardInterrupt:\n    print('ended', flush=True)\n")
    longest = 0.0
    for wait in (0.5, 1.0, 1.5, 2.0, 2.5):
        run = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        assert run.stdout.readline() == "begun\n"
        time.sleep(wait)
        run.send_signal(signal.SIGINT)
        begin = time.perf_counter()
        assert run.stdout.readline() == "ended\n"
        longest = max(longest, time.perf_counter() - begin)
        run.wait()
    return longest


def main():
    load = os.getloadavg()[0]
    ours, theirs, over = contact()
    imported, started, ratio, ended = import_time(), start_time(), two_threads(), interrupted()
    rows = [
        (f"contact of 10⁵ points, module over library, medians of {TIMES} turns", f"{1e3 * ours:.1f} ms over {1e3 * theirs:.1f} ms: {100 * (over - 1):+.1f} %", "5 %", over <= 1.05),
        ("import besides numpy, time on the processor", f"{1e3 * imported:.1f} ms", "20 ms", imported <= 0.020),
        ("`asperity --version`, by the clock", f"{1e3 * started:.0f} ms", "100 ms", started <= 0.1),
        ("two threads solving at once over one", f"{ratio:.2f}", "1.3", ratio <= 1.3),
        ("two processes at once over one, to compare with", f"{two_processes():.2f}", "-", True),
        ("from Ctrl-C to the end of a run", f"{ended:.2f} s", "1 s", ended <= 1.0),
    ]
    table = "| measured | | at most |\n|---|---|---|\n" + "".join(f"| {name} | {value} | {most} |\n" for name, value, most, _ in rows)
    text = f"Measured by `crates/python/measure.py` on {os.cpu_count()} cores (load {load:.1f} before):\n\n{table}"
    print(text)
    failed = [name for name, _, _, holds in rows if not holds]
    sys.exit("does not hold: " + "; ".join(failed) if failed else 0)


if __name__ == "__main__":
    main()
