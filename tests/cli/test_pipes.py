"""Processes and pipes: constant memory, readers that leave, interrupts."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.cli.support import random_poses, write

COMMAND = [sys.executable, "-m", "kleinform"]
POSIX = pytest.mark.skipif(os.name != "posix", reason="pipes and signals of POSIX")
LINUX = pytest.mark.skipif(
    sys.platform != "linux", reason="peak memory in KiB and /dev/full of Linux"
)

#: Feeds a thousand rows again and again to a command, and prints its peak memory in KiB.
FEED = """
import os, subprocess, sys
rows, header, text, *command = sys.argv[1:]
process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
process.stdin.write(header.encode())
for _ in range(int(rows) // 1000):
    process.stdin.write(text.encode() * 1000)
process.stdin.close()
_, status, usage = os.wait4(process.pid, 0)
print(status, usage.ru_maxrss)
"""


def peak(rows: int, form: str, *arguments: str) -> float:
    """Peak memory in MiB of a command that reads so many rows from a pipe."""
    pose = {name: float(column[0]) for name, column in random_poses(1).items()}
    header, text = "", json.dumps(pose) + "\n"
    if form == "csv":
        header, text = ",".join(pose) + "\n", ",".join(map(repr, pose.values())) + "\n"
    command = [*COMMAND, *arguments, "--input", "-", "--format", form]
    ran = subprocess.run(
        [sys.executable, "-c", FEED, str(rows), header, text, *command],
        capture_output=True,
        check=True,
        text=True,
    )
    status, kibibytes = map(int, ran.stdout.split())
    assert status == 0, ran.stderr
    return kibibytes / 1024.0


@LINUX
@pytest.mark.parametrize(
    ("form", "arguments", "counts"),
    [
        ("csv", (), (100_000, 600_000)),
        ("json", (), (50_000, 250_000)),
        ("csv", ("--output", "q.npz"), (50_000, 250_000)),
    ],
)
def test_memory_is_constant(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    form: str,
    arguments: tuple[str, ...],
    counts: tuple[int, int],
) -> None:
    """200 000 rows more would be 10 MB as float64 and more as text, 500 000 rows 24 MB."""
    monkeypatch.chdir(tmp_path)
    few, many = (peak(rows, form, "inverse", *arguments) for rows in counts)
    assert many < few + 6.0


@LINUX
def test_memory_is_constant_for_npz(tmp_path: Path) -> None:
    script = (
        "import os, subprocess, sys\n"
        "process = subprocess.Popen(sys.argv[1:])\n"
        "_, status, usage = os.wait4(process.pid, 0)\n"
        "print(status, usage.ru_maxrss)"
    )
    peaks = []
    for rows in (100_000, 600_000):
        path = write(tmp_path / f"{rows}.npz", random_poses(rows))
        command = [*COMMAND, "inverse", "--input", str(path), "--output", str(tmp_path / "q.npz")]
        ran = subprocess.run(
            [sys.executable, "-c", script, *command], capture_output=True, check=True, text=True
        )
        status, kibibytes = map(int, ran.stdout.split())
        assert status == 0, ran.stderr
        peaks.append(kibibytes / 1024.0)
    assert peaks[1] < peaks[0] + 6.0


@POSIX
def test_one_command_feeds_another(tmp_path: Path) -> None:
    poses = write(tmp_path / "poses.csv", random_poses(100))
    line = (
        '"$0" -m kleinform inverse --input "$1" --degrees --format csv'
        ' | "$0" -m kleinform forward --input - --degrees | tail -n 1'
    )
    ran = subprocess.run(
        ["sh", "-c", line, sys.executable, str(poses)], capture_output=True, check=True, text=True
    )
    assert ran.stdout.startswith("99,")
    assert ran.stderr == ""


@POSIX
@pytest.mark.parametrize("arguments", ["inverse --input {}", "paper", "latex"])
def test_a_reader_that_leaves(tmp_path: Path, arguments: str) -> None:
    """As with ``| head``: no traceback, no complaint at exit."""
    path = write(tmp_path / "poses.csv", random_poses(30_000))
    read, written = os.pipe()
    os.close(read)
    ran = subprocess.run(
        [*COMMAND, *arguments.format(path).split()],
        stdout=written,
        stderr=subprocess.PIPE,
        check=False,
        text=True,
    )
    os.close(written)
    assert (ran.returncode, ran.stderr) == (1, "")


@POSIX
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_what_is_interrupted_leaves_nothing(tmp_path: Path, number: int) -> None:
    """Exit code 128 and the signal's number, no traceback, no file."""
    target = tmp_path / "q.csv"
    command = [*COMMAND, "inverse", "--input", "-", "--output", str(target)]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdin is not None
    assert process.stderr is not None
    process.stdin.write(b"x,y,z,roll,pitch,yaw\n" + 20_000 * b"0.25,0.2,1.0,0.1,0.2,0.3\n")
    process.stdin.flush()
    until = time.monotonic() + 30.0
    while not list(tmp_path.glob(".kleinform-*")) and time.monotonic() < until:
        time.sleep(0.05)
    process.send_signal(number)
    assert process.wait(timeout=30.0) == 128 + number
    assert process.stderr.read() == b""
    process.stdin.close()
    process.stderr.close()
    assert list(tmp_path.iterdir()) == []


def test_importing_kleinform_imports_no_typer() -> None:
    code = "import sys, kleinform; sys.exit('typer' in sys.modules or 'rich' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
