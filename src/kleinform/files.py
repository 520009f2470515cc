"""The one way to write a file: whole or not at all, and nothing beside it is touched."""

from __future__ import annotations

import errno
import os
import signal
import stat
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from os import PathLike
from types import FrameType
from typing import BinaryIO, NoReturn

from kleinform.errors import InputError

__all__ = ["check_target", "folder_of", "write_bytes", "written"]

#: Where names of devices and of open files are, which are written as they come.
DEVICES = ("/dev", "/dev/fd", "/proc/self/fd")
#: The disk, the quota or the largest file is full: an error without the name of the file.
FULL = {getattr(errno, name, None) for name in ("ENOSPC", "EDQUOT", "EFBIG")}
#: What ends a process from outside, without a chance to take away what it has begun.
ENDINGS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]


def check_target(path: str | PathLike[str]) -> None:
    """Refuse a file that cannot be written, before the work is done.

    Raises
    ------
    InputError
        It is a folder, or write-protected, or its folder is missing or may not be written to.
    """
    if _is_stream(path):
        return
    target = _target(path)
    folder = os.path.dirname(target)
    if not os.path.isdir(folder):
        raise InputError(f"{path}: there is no folder {folder}")
    if os.path.isdir(target) or os.path.islink(target):  # a link to itself
        raise InputError(f"{path}: not a file")
    if os.path.exists(target) and not os.access(target, os.W_OK):
        raise InputError(f"{path}: the file may not be written to")
    if not os.access(folder, os.W_OK):
        raise InputError(f"{path}: the folder {folder} may not be written to")


def folder_of(path: str | PathLike[str]) -> str | None:
    """The folder of a file to write; None for a device or a pipe, which have no place on a disk."""
    return None if _is_stream(path) else os.path.dirname(_target(path))


@contextmanager
def written(path: str | PathLike[str]) -> Iterator[BinaryIO]:
    """A stream of bytes that is the file of this name when everything is written.

    Until then it has a name beside it that nobody else can have. A link stays, and what it
    points to is replaced. Devices and pipes are written as it comes.

    Raises
    ------
    InputError
        As `check_target`.
    OSError
        It cannot be written, as on a full disk; then nothing has changed.
    """
    check_target(path)
    try:
        if _is_stream(path):
            with open(os.open(path, os.O_WRONLY | os.O_APPEND), "wb") as stream:
                yield stream
        else:
            with _unwound(), _replaced(_target(path)) as stream:
                yield stream
    except OSError as error:
        if error.errno in FULL and error.filename is None:
            error.filename = os.fspath(path)
        raise


def write_bytes(path: str | PathLike[str], data: bytes) -> None:
    """Write a file whole or not at all."""
    with written(path) as stream:
        stream.write(data)


@contextmanager
def _replaced(target: str) -> Iterator[BinaryIO]:
    """A file beside the target, in its place at the end and gone after an error."""
    mode = _mode_of(target)

    def create(path: str, flags: int) -> int:
        return os.open(path, flags, 0o666 if mode is None else mode)

    # Nobody guesses 128 random bits: what has this name is ours to take away.
    aside = os.path.join(os.path.dirname(target), f".kleinform-{os.urandom(16).hex()}")
    try:
        with open(aside, "xb", opener=create) as stream:
            if mode is not None:
                os.chmod(aside, mode)  # what the umask took away
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(aside, target)
    except BaseException:
        with suppress(OSError):
            os.unlink(aside)
        raise


@contextmanager
def _unwound() -> Iterator[None]:
    """Signals that would end the process at once unwind it, so that nothing is left."""
    replaced = []
    if threading.current_thread() is threading.main_thread():  # no other may set them
        replaced = [number for number in ENDINGS if signal.getsignal(number) is signal.SIG_DFL]
    try:
        for number in replaced:
            signal.signal(number, _leave)
        yield
    finally:
        for number in replaced:
            signal.signal(number, signal.SIG_DFL)


def _leave(number: int, _: FrameType | None) -> NoReturn:
    sys.exit(128 + number)


def _mode_of(path: str) -> int | None:
    """The permissions of a file, None where there is none."""
    try:
        return stat.S_IMODE(os.stat(path).st_mode)
    except FileNotFoundError:
        return None


def _target(path: str | PathLike[str]) -> str:
    """The file itself, behind links."""
    return os.path.realpath(os.fspath(path))


def _is_stream(path: str | PathLike[str]) -> bool:
    """Whether it is a device or a pipe, or a name of a file that is open, as /dev/stdout."""
    try:
        mode = os.stat(path).st_mode
    except OSError:
        return False
    if not stat.S_ISREG(mode):
        return not stat.S_ISDIR(mode)
    named = os.path.abspath(path)
    while os.path.dirname(named) not in DEVICES and os.path.islink(named):
        named = os.path.normpath(os.path.join(os.path.dirname(named), os.readlink(named)))
    return os.path.dirname(named) in DEVICES
