"""What a benchmark prints, kept in a file, and the machine that it ran on."""

from __future__ import annotations

import contextlib
import io
import os
import platform
import sys
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

import kleinform
from benchmarks.peers import PACKAGES, missing
from kleinform.files import check_target, write_bytes

__all__ = ["machine", "saved"]


class Tee(io.StringIO):
    """Text that goes to another stream as well."""

    def __init__(self, stream: io.TextIOBase) -> None:
        super().__init__()
        self.stream = stream

    def write(self, text: str) -> int:
        """Write to both."""
        self.stream.write(text)
        self.stream.flush()
        return super().write(text)


@contextlib.contextmanager
def saved(path: Path) -> Iterator[None]:
    """What is printed goes into a Markdown file too, whole or not at all."""
    check_target(path)
    tee = Tee(sys.stdout)  # type: ignore[arg-type]
    with contextlib.redirect_stdout(tee):
        yield
    text = f"# Benchmarks\n\nWritten by `make bench`.\n\n```text\n{tee.getvalue()}```\n"
    write_bytes(path, text.encode())


def machine() -> str:
    """The processor, and the versions of what runs on it."""
    kernels = kleinform.backend()
    installed = [package for name, package in PACKAGES.items() if name not in missing()]
    versions = [f"{name} {metadata.version(name)}" for name in ("numpy", "sympy", *installed)]
    return (
        f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}, "
        f"{', '.join(versions)}; kernels {kernels.name} {kernels.instructions}".rstrip()
    )


def _processor() -> str:
    """Its name from /proc/cpuinfo, or else what Python knows."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()
