"""Tables as NPZ: an array (rows,) for each column, read and written in blocks."""

from __future__ import annotations

import lzma
import shutil
import warnings
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from tempfile import TemporaryFile
from tokenize import TokenError
from typing import IO, Any, BinaryIO

import numpy as np

from kleinform.commands.columns import Array, Table
from kleinform.commands.source import ROWS, Block, numbered, shown
from kleinform.errors import InputError
from kleinform.screening import as_float64

__all__ = ["NpzSource", "npz_writer"]

#: What reading an archive that is none, or is cut off, raises.
BROKEN = (
    *(zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, OSError),
    *(ValueError, RuntimeError, SyntaxError, TokenError, MemoryError),
)


class NpzSource:
    """An archive of NumPy that is read in blocks, all columns side by side."""

    def __init__(self, stream: BinaryIO, name: str) -> None:
        self.name = name
        try:
            self._archive = zipfile.ZipFile(stream)
        except BROKEN as error:
            raise InputError(f"{self.name}: not an NPZ: {error}") from None
        members = self._archive.namelist()
        self.columns = [name.removesuffix(".npy") for name in members if name.endswith(".npy")]

    def blocks(self, names: Sequence[str]) -> Iterator[Block]:
        with ExitStack() as stack:
            members = [Member(self._archive, name, self.name, stack) for name in names]
            rows = members[0].rows
            for member in members:
                if member.rows != rows:
                    raise InputError(
                        f"{self.name}: {names[0]} has {rows} rows, {member.name} {member.rows}"
                    )
            for first in range(0, max(rows, 1), ROWS):
                count = min(ROWS, rows - first)
                table: Table = {member.name: member.read(count) for member in members}
                done = (first + count) / max(rows, 1)
                yield Block(table, numbered(self.name, first), shown(table), done)
            for member in members:
                member.close()


class Member:
    """One array of an archive, read from its start to its end."""

    def __init__(self, archive: zipfile.ZipFile, name: str, source: str, stack: ExitStack) -> None:
        self.name = name
        self._source = source
        try:
            self._stream = stack.enter_context(archive.open(f"{name}.npy"))
            shape, _, self._dtype = _header(self._stream)
        except BROKEN as error:
            raise InputError(f"{source}: {name}: not an array: {error}") from None
        if len(shape) != 1 or self._dtype.kind not in "fiu" or self._dtype.itemsize > 8:
            raise InputError(
                f"{source}: {name}: an array (rows,) of real numbers up to float64 is needed, "
                f"{self._dtype} {shape} arrived"
            )
        self.rows: int = shape[0]
        if self.rows < 0:
            raise InputError(f"{source}: {name}: not an array: {self.rows} rows arrived")

    def read(self, count: int) -> Array:
        """The next rows."""
        size = count * self._dtype.itemsize
        try:
            data = self._stream.read(size)
            return as_float64(np.frombuffer(data, self._dtype, count))
        except BROKEN as error:
            raise InputError(f"{self._source}: {self.name}: cut off: {error}") from None

    def close(self) -> None:
        """After the last row there is nothing more."""
        try:
            more = self._stream.read(1)
        except BROKEN as error:
            raise InputError(f"{self._source}: {self.name}: damaged: {error}") from None
        if more:
            raise InputError(
                f"{self._source}: {self.name}: more data than the {self.rows} rows of its header"
            )


def _header(stream: IO[bytes]) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    version = np.lib.format.read_magic(stream)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of headers that Python 2 wrote, which are read
        if version == (1, 0):
            return np.lib.format.read_array_header_1_0(stream)
        if version in ((2, 0), (3, 0)):
            return np.lib.format.read_array_header_2_0(stream)
    raise ValueError(f"its format has the version {version}")


@contextmanager
def npz_writer(stream: BinaryIO, folder: str | None) -> Iterator[Callable[[Table], None]]:
    """Write tables to an archive, one below the other.

    How many rows there are is known at the end: until then the columns grow in files of
    their own, without names, in a folder or where the system has such files.
    """
    with ExitStack() as stack:
        columns: dict[str, tuple[IO[bytes], np.dtype[Any]]] = {}

        def write(table: Table) -> None:
            for name, column in table.items():
                if name not in columns:
                    file = stack.enter_context(TemporaryFile(dir=folder))
                    columns[name] = file, column.dtype
                spool, dtype = columns[name]
                spool.write(column.astype(dtype).tobytes())

        yield write
        with zipfile.ZipFile(stream, "w") as archive:
            for name, (spool, dtype) in columns.items():
                info = zipfile.ZipInfo(f"{name}.npy")
                # Words are stored at the width of the longest: most of it is empty.
                info.compress_type = (
                    zipfile.ZIP_DEFLATED if dtype.kind == "U" else zipfile.ZIP_STORED
                )
                with archive.open(info, "w", force_zip64=True) as member:
                    _copy(spool, dtype, member)


def _copy(spool: IO[bytes], dtype: np.dtype[Any], member: IO[bytes]) -> None:
    """A column with its header."""
    rows = spool.tell() // dtype.itemsize
    header = {"descr": dtype.str, "fortran_order": False, "shape": (rows,)}
    np.lib.format.write_array_header_1_0(member, header)
    spool.seek(0)
    shutil.copyfileobj(spool, member)
