"""Whatever writes a file: whole or not at all, and nothing beside it is touched."""

from __future__ import annotations

import os
import resource
import signal
import stat
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from kleinform import InputError
from kleinform.files import write_bytes
from tests.cli.outputs import OUTPUTS
from tests.support import many

pytestmark = pytest.mark.skipif(os.name != "posix", reason="limits and signals of POSIX")

#: What somebody, or another program, may keep beside a file.
BESIDE = (
    *("{}.new", ".{}.new", "{}.tmp", ".{}.tmp", "{}.part", "{}~", ".{}.swp", "{}.bak", "{}.old"),
    *("#{}#", "{}.orig", "{}.temp", "tmp{}", "new.{}", "{}.1", "{}.lock", ".{}", "{}.column"),
    *("q1.column", "x.column", "code.column", "row.column", "t.column", "wx.column"),
)


def skip_without_extras(name: str) -> None:
    if name.startswith("workspace"):
        pytest.importorskip("flint")
    if name.endswith(".svg"):
        pytest.importorskip("matplotlib")


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def prepared(name: str, folder: Path) -> tuple[Path, dict[str, bytes], bytes]:
    """A file that is there among others, all of them, and what a complete run makes of it."""
    skip_without_extras(name)
    assert OUTPUTS[name](folder / name) == 0
    whole = (folder / name).read_bytes()
    for other in (name, *(beside.format(name) for beside in BESIDE)):
        (folder / other).write_bytes(b"kept: " + other.encode())
    return folder / name, contents(folder), whole


def check_folder(before: dict[str, bytes], path: Path, whole: bytes) -> bool:
    """Everything as it was, and the file as it was or whole; whether it is new."""
    after = contents(path.parent)
    found = after.pop(path.name)
    old = before.pop(path.name)
    assert after == before
    assert found in (old, whole)
    return found != old


@contextmanager
def files_of_at_most(size: int) -> Iterator[None]:
    """As if the disk were full after so many bytes of a file."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@pytest.mark.parametrize("name", OUTPUTS)
def test_siblings_stay(tmp_path: Path, name: str) -> None:
    path, before, whole = prepared(name, tmp_path)
    assert OUTPUTS[name](path) == 0
    assert check_folder(before, path, whole)


@pytest.mark.long
@pytest.mark.parametrize("name", OUTPUTS)
def test_a_full_disk(tmp_path: Path, name: str, capsys) -> None:
    """At any byte: the file stays as it was, one line says why."""
    path, before, whole = prepared(name, tmp_path)
    rng = np.random.default_rng(12)
    capsys.readouterr()
    for size in [0, *rng.integers(1, len(whole), many(1, 40))]:
        with files_of_at_most(int(size)):
            said = refusal(OUTPUTS[name], path, capsys)
        assert str(path) in said
        assert "File too large" in said
        assert not check_folder(dict(before), path, whole)


def refusal(output: Callable[[Path], int], path: Path, capsys) -> str:
    """The line that a command says, or the error of a function."""
    try:
        code = output(path)
    except OSError as error:
        return str(error)
    err: str = capsys.readouterr().err
    assert (code, err.count("\n")) == (2, 1)
    return err


class Interrupter:
    """Raises a KeyboardInterrupt at some event on files, once."""

    def __init__(self) -> None:
        self.left = -1
        sys.addaudithook(self.hook)

    def hook(self, event: str, arguments: tuple[object, ...]) -> None:
        if self.left < 0 or event not in ("open", "os.rename", "os.mkdir", "os.chmod", "os.link"):
            return
        if event == "open" and "w" not in str(arguments[1]) and "x" not in str(arguments[1]):
            return
        self.left -= 1
        if self.left < 0:
            raise KeyboardInterrupt


INTERRUPTER = Interrupter()


@pytest.mark.parametrize("name", OUTPUTS)
def test_an_interrupt_at_any_event(tmp_path: Path, name: str) -> None:
    path, before, whole = prepared(name, tmp_path)
    for event in range(60):
        INTERRUPTER.left = event
        try:
            code = OUTPUTS[name](path)
        except KeyboardInterrupt:
            code = 130
        finally:
            ended, INTERRUPTER.left = INTERRUPTER.left >= 0, -1
        new = check_folder(dict(before), path, whole)
        assert (code, new) == ((0, True) if ended else (130, False))
        if ended:
            return
    raise AssertionError("it never ends")


def test_the_folder_of_a_file_is_named_before_the_work_is_done(tmp_path: Path, capsys) -> None:
    (tmp_path / "file").write_text("kept")
    for name, output in OUTPUTS.items():
        skip_without_extras(name)
        for folder in ("none", "file"):
            try:
                assert output(tmp_path / folder / name) == 2
                said = capsys.readouterr().err
            except InputError as error:
                said = str(error)
            assert f"there is no folder {tmp_path / folder}" in said
    assert list(tmp_path.iterdir()) == [tmp_path / "file"]


@pytest.mark.parametrize("denied", ["folder", "file"])
def test_what_may_not_be_written(tmp_path: Path, monkeypatch, denied: str) -> None:
    """Root may write everywhere, so that the answer of the system is replaced."""
    path = tmp_path / "m.stl"
    path.write_text("kept")
    refused = str(tmp_path if denied == "folder" else path)
    monkeypatch.setattr(os, "access", lambda name, _: name != refused)
    with pytest.raises(InputError, match=rf"m.stl: the {denied} .*may not be written to"):
        write_bytes(path, b"new")
    assert contents(tmp_path) == {"m.stl": b"kept"}


def test_permissions(tmp_path: Path) -> None:
    """Those of the umask, or of the file that is replaced."""
    before = os.umask(0o027)
    try:
        write_bytes(tmp_path / "new", b"")
        (tmp_path / "old").touch()
        for mode in (0o600, 0o666, 0o755, 0o444):
            (tmp_path / "old").chmod(mode)
            write_bytes(tmp_path / "old", b"new")
            assert stat.S_IMODE((tmp_path / "old").stat().st_mode) == mode
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o640


def test_links(tmp_path: Path) -> None:
    """What a link points to is replaced, wherever it is; a link to itself is no file."""
    (tmp_path / "far").mkdir()
    for name, target in (("a", "far/b"), ("b", "a"), ("self", "self"), ("folder", "far")):
        (tmp_path / name).symlink_to(target)
    for content in (b"one", b"two"):
        write_bytes(tmp_path / "b", content)
        assert (tmp_path / "far" / "b").read_bytes() == content
    for name in ("self", "folder"):
        with pytest.raises(InputError, match=f"{name}: not a file"):
            write_bytes(tmp_path / name, b"three")
        assert (tmp_path / name).is_symlink()
    assert [path.name for path in (tmp_path / "far").iterdir()] == ["b"]


def test_a_pipe(tmp_path: Path) -> None:
    """It is written, and stays what it is."""
    path = tmp_path / "pipe.csv"
    os.mkfifo(path)
    reader = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
    assert OUTPUTS["inverse.csv"](path) == 0
    assert os.read(reader, 1000).startswith(b"q1,q2,q3")
    os.close(reader)
    assert stat.S_ISFIFO(path.stat().st_mode)


@pytest.mark.skipif(sys.platform != "linux", reason="devices of Linux")
@pytest.mark.parametrize("name", ["table.csv", "table.npz", "singularities.stl"])
def test_devices(tmp_path: Path, name: str, capsys) -> None:
    """By a link, because of the name's end."""
    for device, said in (("null", ""), ("full", "No space left on device")):
        path = tmp_path / name
        path.symlink_to(f"/dev/{device}")
        (tmp_path / f"other-{name}").touch()
        code = OUTPUTS[name](path)
        err = capsys.readouterr().err
        assert (code, err) == ((2, f"kleinform: {path}: {said}\n") if said else (0, ""))
        assert path.is_symlink()
        path.unlink()


@pytest.mark.skipif(sys.platform != "linux", reason="devices of Linux")
def test_standard_output_by_its_name(tmp_path: Path) -> None:
    """What is in the file that it is redirected to stays."""
    code = "from kleinform.files import write_bytes; write_bytes('/dev/stdout', b'new')"
    log = tmp_path / "log"
    log.write_text("old ")
    with log.open("a") as stream:
        subprocess.run([sys.executable, "-c", code], stdout=stream, check=True)
    assert log.read_text() == "old new"


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_signals_in_a_program_of_somebody(tmp_path: Path, number: int) -> None:
    """A program without handlers of its own leaves nothing either, and its handlers stay."""
    code = (
        "import os, signal, sys\n"
        "from kleinform.files import written\n"
        "before = signal.getsignal(signal.SIGTERM)\n"
        "try:\n"
        "    with written(sys.argv[1]) as stream:\n"
        "        stream.write(b'half')\n"
        "        os.kill(os.getpid(), int(sys.argv[2]))\n"
        "except KeyboardInterrupt:\n"
        "    sys.exit(130)\n"
        "finally:\n"
        "    assert signal.getsignal(signal.SIGTERM) is before\n"
    )
    command = [sys.executable, "-c", code, str(tmp_path / "file"), str(int(number))]
    assert subprocess.run(command, check=False).returncode == 128 + number
    assert list(tmp_path.iterdir()) == []
