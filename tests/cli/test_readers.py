"""Tables that somebody has damaged: an answer, or one line and the exit code 2."""

from __future__ import annotations

import io
import warnings
import zipfile
from pathlib import Path

import numpy as np
import pytest

from tests.cli.support import random_poses, write
from tests.cli.test_refusals import refused
from tests.support import many

ODD_TEXTS = (
    *(
        "",
        " ",
        "NA",
        "nan",
        "inf",
        "1e400",
        "-0",
        "1_0",
        "0x1p3",
        "1e",
        "--1",
        "1,2",
        '"',
        '""',
        "'",
    ),
    *(
        "\x00",
        "\ufeff",
        "\x85",
        "\u2028",
        "１",
        "٣",
        "#",
        "\\",
        "\r",
        "\n",
        "\n\n",
        "\t",
        "1;2",
        ";",
    ),
    *("null", "true", "[1]", "{}", '"1"', "NaN", "Infinity", "9" * 5000, "1" + "0" * 400, "\ud7ff"),
    *(
        '"x": 1',
        "[",
        "]",
        "{",
        "}",
        ":",
        '{"x": 1}',
        "[[[[",
        "1e308",
        "5e-324",
        "\x1c",
        "a" * 200_000,
    ),
)


def mutated_text(text: str, rng: np.random.Generator) -> bytes:
    """Cells, keys or any bytes replaced, doubled or removed."""
    kind = rng.integers(4)
    start = int(rng.integers(len(text)))
    stop = min(len(text), start + int(rng.integers(1, 25)))
    odd = ODD_TEXTS[rng.integers(len(ODD_TEXTS))]
    if kind == 0:
        return (text[:start] + odd + text[stop:]).encode("utf-8", "surrogatepass")
    if kind == 1:
        return (text[:stop] + text[start:]).encode()
    if kind == 2:  # a whole cell
        ends = [i for i, letter in enumerate(text) if letter in ",:}\n"]
        first = int(rng.integers(len(ends) - 1))
        changed = text[: ends[first] + 1] + odd + text[ends[first + 1] :]
        return changed.encode("utf-8", "surrogatepass")
    return mutated_bytes(text.encode(), rng)


def mutated_bytes(data: bytes, rng: np.random.Generator) -> bytes:
    """Some bytes changed, or a part cut out or doubled."""
    changed = bytearray(data)
    kind = rng.integers(3)
    start = int(rng.integers(len(data)))
    if kind == 0:
        for place in rng.integers(0, len(data), rng.integers(1, 5)):
            changed[place] = rng.integers(256)
    elif kind == 1:
        del changed[start : start + int(rng.integers(1, 200))]
    else:
        changed[start:start] = changed[start : start + int(rng.integers(1, 200))]
    return bytes(changed)


HEADERS = (
    *("'<f8'", "'>f8'", "'<i4'", "'|b1'", "'<c16'", "'|O'", "'<U3'", "'<M8[s]'", "'<f2'", "'<f16'"),
    *("[('a', '<f8')]", "'3<f8'", "None", "7", "'<f8', 'more': 1", "''", "'<V8'", "'<f8,<f8'"),
)
SHAPES = (
    *("(20,)", "(-3,)", "(19,)", "(21,)", "(True,)", "(20.0,)", "(10**30,)", "()", "(4, 5)", "20"),
    *("(20, 1)", "None", "(2**63,)", "(-1,)", "(0,)", "(20,),", "(1e3,)", "('20',)", "(20L,)"),
)


def mutated_npz(table: dict[str, np.ndarray], rng: np.random.Generator) -> bytes:
    """An archive with a member whose header, data or packing is another one."""
    data = io.BytesIO()
    victim = list(table)[rng.integers(len(table))]
    methods = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a name that is there twice
        with zipfile.ZipFile(data, "w", methods[rng.integers(4)]) as archive:
            for name, column in table.items():
                content = column.tobytes()
                header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (20,), }"
                if name == victim:
                    header, content = odd_member(header, content, rng)
                size = len(header).to_bytes(2, "little")
                archive.writestr(f"{name}.npy", b"\x93NUMPY\x01\x00" + size + header + content)
                if name == victim and rng.random() < 0.1:
                    archive.writestr(f"{name}.npy", b"twice")
    return mutated_bytes(data.getvalue(), rng) if rng.random() < 0.4 else data.getvalue()


def odd_member(header: bytes, content: bytes, rng: np.random.Generator) -> tuple[bytes, bytes]:
    kind = rng.integers(5)
    if kind == 0:
        return header.replace(b"'<f8'", HEADERS[rng.integers(len(HEADERS))].encode()), content
    if kind == 1:
        return header.replace(b"(20,)", SHAPES[rng.integers(len(SHAPES))].encode()), content
    if kind == 2:
        return mutated_bytes(header, rng), content
    if kind == 3:
        return header, content + bytes(int(rng.integers(1, 30)))
    return header, content[: -int(rng.integers(1, len(content)))]


@pytest.mark.long
@pytest.mark.parametrize("form", ["csv", "json", "array.json", "npz"])
def test_damaged_tables(run, tmp_path: Path, form: str) -> None:
    table = random_poses(20)
    path = tmp_path / f"in.{form}"
    rng = np.random.default_rng(13)
    wrong = []
    for number in range(many(60, 1500)):
        if form == "npz":
            path.write_bytes(mutated_npz(table, rng))
        else:
            write(path, table)
            text = path.read_text()
            if form == "array.json":
                text = "[" + ",".join(text.splitlines()) + "]"
            path.write_bytes(mutated_text(text, rng))
        errors = ("--errors", "nan") if number % 2 else ()
        try:
            ran = run("inverse", "--input", path.name, "--degrees", *errors)
        except BaseException as error:
            wrong.append((number, repr(error)[:200]))
            continue
        lines = ran.err.count("\n")
        good = (ran.code == 2 and lines == 1) or (ran.code == 0 and lines <= len(errors) // 2)
        if not good or "Traceback" in ran.err:
            wrong.append((number, ran.code, ran.err[:200]))
    assert wrong == []


@pytest.mark.parametrize("command", ["inverse", "classify", "singularity"])
@pytest.mark.parametrize("width", [16, 32, 64])
def test_a_signalling_nan(run, tmp_path: Path, command: str, width: int) -> None:
    """Without a warning of NumPy's in degrees and of narrow arrays: a row that is refused."""
    table = {name: column.astype(f"f{width // 8}") for name, column in random_poses(20).items()}
    bits = {16: 0x7C01, 32: 0x7F800001, 64: 0x7FF0000000000001}[width]
    table["yaw"].view(f"u{width // 8}")[3] = bits
    np.savez(tmp_path / "in.npz", **table)
    ran = run(command, "--input", "in.npz", "--degrees")
    assert ran.code == 2
    assert "row 3" in ran.err
    assert "nan arrived" in ran.err


@pytest.mark.parametrize("member", ["trailing", "negative"])
def test_an_array_that_is_not_as_long_as_it_says(run, tmp_path: Path, member: str) -> None:
    table = random_poses(20)
    with zipfile.ZipFile(tmp_path / "in.npz", "w") as archive:
        for name, column in table.items():
            header = "{'descr': '<f8', 'fortran_order': False, 'shape': (20,), }"
            if name == "y":
                said = "(-3,)" if member == "negative" else "(19,)"
                header = header.replace("(20,)", said)
            elif member == "trailing":
                header = header.replace("(20,)", "(19,)")
            size = len(header).to_bytes(2, "little")
            content = b"\x93NUMPY\x01\x00" + size + header.encode() + column.tobytes()
            archive.writestr(f"{name}.npy", content)
    ran = run("inverse", "--input", "in.npz", "--degrees")
    expected = {
        "trailing": "in.npz: x: more data than the 19 rows of its header",
        "negative": "in.npz: y: not an array: -3 rows arrived",
    }[member]
    assert (ran.code, ran.err) == (2, f"kleinform: {expected}\n")


def npy(header: str, version: int = 1) -> bytes:
    """A file of NumPy with any header."""
    text = header.encode() + b"\n"
    size = len(text).to_bytes(2 if version == 1 else 4, "little")
    return b"\x93NUMPY" + bytes([version, 0]) + size + text + bytes(8)


@pytest.mark.parametrize(
    "member",
    [
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1,"),
        npy("(" * 9000),
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1,), }", version=9),
        npy("{'descr': '<f8'}"),
        npy("{'descr': '<f8', 'fortran_order': False, 'shape': (-3,), }"),
        b"junk",
    ],
)
def test_an_npz_with_a_member_that_is_no_array(run, tmp_path: Path, member: bytes) -> None:
    path = write(tmp_path / "good.npz", random_poses(1))
    with zipfile.ZipFile(path) as good, zipfile.ZipFile(tmp_path / "poses.npz", "w") as bad:
        for name in good.namelist():
            bad.writestr(name, member if name == "x.npy" else good.read(name))
    message = refused(run("inverse", "--input", "poses.npz"))
    assert message.startswith("poses.npz: x: not an array:")


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_an_npz_whose_packing_is_damaged(run, tmp_path: Path, method: int) -> None:
    path = write(tmp_path / "good.npz", random_poses(100))
    with (
        zipfile.ZipFile(path) as good,
        zipfile.ZipFile(tmp_path / "poses.npz", "w", method) as bad,
    ):
        for name in good.namelist():
            bad.writestr(name, good.read(name))
    data = bytearray((tmp_path / "poses.npz").read_bytes())
    data[60:75] = bytes(byte ^ 0x5A for byte in data[60:75])
    (tmp_path / "poses.npz").write_bytes(data)
    assert refused(run("inverse", "--input", "poses.npz")).startswith("poses.npz: x: ")
