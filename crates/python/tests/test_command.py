"""The command asperity runs in the compiled part of the module: one program in the wheel."""

import importlib.metadata
import os
import signal
import subprocess
import sys
import time

import pytest

import asperity
from conftest import CASES

OURS = [sys.executable, "-m", "asperity"]


def ran(program, *arguments, **options):
    """Exit status, standard output and standard error of a command line."""
    done = subprocess.run([*program, *map(str, arguments)], capture_output=True, **options)
    return done.returncode, done.stdout, done.stderr


def test_the_entry_point_of_the_package_is_the_command():
    (entry,) = importlib.metadata.entry_points(group="console_scripts", name="asperity")
    assert entry.value == "asperity.__main__:main"
    assert ran(OURS, "--version")[1].decode() == f"asperity {asperity.__version__}\n"


@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        (["--help"], 0),
        (["run", "--help"], 0),
        (["run", CASES / "fzg-c.toml", "--no-output"], 0),
        (["run", CASES / "table2.toml", "--no-output", "--json"], 0),
        (["gear", CASES / "e-drive.toml", "--set", "operation.torque=20 N m"], 0),
        (["explain", "E301"], 0),
        (["run", "absent.toml"], 2),
        (["check", CASES / "e-drive.toml", "--set", "operation.torqe=1 N m"], 2),
        (["rn"], 2),
        ([], 2),
    ],
)
def test_it_prints_what_the_program_prints(arguments, status, command, tmp_path):
    ours, theirs = ran(OURS, *arguments, cwd=tmp_path), ran([command], *arguments, cwd=tmp_path)
    assert ours == theirs and ours[0] == status and (ours[1] or ours[2])


def test_it_imports_no_numpy_and_starts_at_once():
    script = (
        "import sys, time; sys.argv = ['asperity', '--version']\n"
        "from asperity.__main__ import main\n"
        "status = main()\n"
        "print(sorted({'numpy', 'pandas', 'json'} & set(sys.modules)), time.process_time(), file=sys.stderr)\n"
        "sys.exit(status)"
    )
    runs = [ran([sys.executable, "-c", script]) for _ in range(5)]
    assert all(status == 0 and said.startswith(b"[] ") for status, _, said in runs), runs
    # Time on the processor, which other programs on the machine lengthen less than the time of the clock.
    assert min(float(said.split()[-1]) for _, _, said in runs) < 0.1


def test_a_file_name_of_any_bytes_is_taken(command, tmp_path):
    name = os.fsencode(tmp_path) + b"/caf\xe9.toml"
    with open(name, "wb") as file:
        file.write((CASES / "fzg-c.toml").read_bytes())
    arguments = [os.fsdecode(name), "--json"]
    assert ran(OURS, "check", *arguments) == ran([command], "check", *arguments)


@pytest.mark.skipif(os.name != "posix", reason="signals and pipes of POSIX")
def test_ctrl_c_and_a_closed_pipe_end_it(tmp_path):
    long = ["run", str(CASES / "e-drive.toml"), "--set", "model.positions=1000", "--set", "model.offsets=200", "-o", str(tmp_path / "out")]
    run = subprocess.Popen([*OURS, *long], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(2.0)
    assert run.poll() is None, "the work was not long"
    run.send_signal(signal.SIGINT)
    assert run.wait(timeout=10) == 130
    assert not list(tmp_path.iterdir())
    equations = subprocess.Popen([*OURS, "equations"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    equations.stdout.close()
    assert equations.wait(timeout=30) == 0 and equations.stderr.read() == b""
