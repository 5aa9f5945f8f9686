"""Python's lock, threads, Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import asperity
from conftest import CASES


def ticking(work):
    """Ticks of a thread of Python, a millisecond each, while `work` is done."""
    ticks, done = 0, threading.Event()

    def tick():
        nonlocal ticks
        while not done.is_set():
            time.sleep(1e-3)
            ticks += 1

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.perf_counter()
    try:
        work()
    finally:
        elapsed = time.perf_counter() - begin
        done.set()
        thread.join()
    return ticks, elapsed


def test_another_thread_runs_during_a_solve():
    rng = np.random.default_rng(1)
    x = (np.arange(200_000) - 1e5) * 1e-7
    gap = x**2 / 0.02 + 1e-7 * rng.standard_normal(len(x))
    ticks, elapsed = ticking(lambda: asperity.solve_contact(gap, 1e-7, 115e9, 2e5))
    # A lock that is held gives none; a machine under load gives far fewer than one per millisecond.
    assert ticks >= 10 and ticks >= 20 * elapsed


def test_another_thread_runs_during_a_run():
    case = asperity.Case(CASES / "e-drive.toml")
    ticks, elapsed = ticking(case.run)
    assert ticks >= 20 * elapsed


def test_cases_run_on_several_threads_at_once():
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 2})
    expected = case.run("losses").loss_w
    found = [0.0] * 4

    def work(number):
        found[number] = case.run("losses", threads=1).loss_w

    threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 4


def test_a_number_of_threads_is_positive_or_minus_one():
    case = asperity.Case(CASES / "e-drive.toml", model={"positions": 4, "offsets": 2})
    expected = case.run("losses").loss_w
    for threads in (None, -1, 1, 1000):
        assert case.run("losses", threads=threads).loss_w == expected
    for threads in (0, -2):
        with pytest.raises(asperity.AsperityError, match="threads = ") as refused:
            case.run("losses", threads=threads)
        assert refused.value.code == "E209"


LONG = {
    "run": "case.replace({'model.positions': 1000, 'model.offsets': 200}).run()",
    "map": "asperity.map(case, torque='1..145:200 N m', speed='10..9000:200 1/min')",
    "sweep": "list(asperity.sweep(case, sample={'method': 'sobol', 'count': 4096, "
    "'vary': {'operation.torque': {'uniform': ['50 N m', '150 N m']}}}))",
    "ehl": "asperity.ehl(case, 0.25, half_widths=4000)",
    "profile change": "a = asperity.generate(points=200000, spacing=.5e-6, rq=.4e-6, hurst=.8, roll_off=50e-6, short_cut=2e-6, seed=1); "
    "asperity.profile_change(a, asperity.Profile(a.heights.clip(max=.3e-6), a.spacing))",
    "contact": "asperity.solve_contact(np.random.default_rng(1).standard_normal(4_000_000) * 1e-6, 1e-7, 115e9, 1e4)",
}


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_ends_long_work_within_a_second(name):
    script = f"""
import numpy as np, asperity
case = asperity.Case({str(CASES / "e-drive.toml")!r})
print("begun", flush=True)
try:
    {LONG[name]}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""
    place = Path(asperity.__file__).parents[1]
    environment = {**os.environ, "PYTHONPATH": str(place)}
    run = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, env=environment)
    assert run.stdout.readline() == "begun\n"
    time.sleep(1.0)
    assert run.poll() is None, "the work was not long"
    run.send_signal(signal.SIGINT)
    begin = time.perf_counter()
    said = run.stdout.readline()
    run.wait(timeout=30)
    assert said == "interrupted\n" and run.returncode == 0
    assert time.perf_counter() - begin < 1.0
