"""The written tree is swapped in whole, or not at all."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from pathlib import Path

import pytest

from derivations.codegen import tree

FILES = {"__init__.py": "", "a/one.py": "x = 1\n", "a/two.tex": "√3/2\n"}
OTHER = {"__init__.py": "", "a/one.py": "x = 2\n", "b/three.py": "y = 3\n"}


def contents(root: Path) -> dict[str, str]:
    files = [path for path in root.rglob("*") if path.is_file()]
    return {path.relative_to(root).as_posix(): path.read_bytes().decode() for path in files}


def stamps(root: Path) -> dict[Path, tuple[int, int]]:
    """When each file was written, and which file it is."""
    return {path: (path.stat().st_mtime_ns, path.stat().st_ino) for path in root.rglob("*")}


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A tree with FILES."""
    path = tmp_path / "generated"
    tree.replace(path, FILES)
    return path


def test_a_new_tree(tmp_path: Path) -> None:
    root = tmp_path / "deep" / "generated"
    assert tree.replace(root, FILES) == dict.fromkeys(sorted(FILES), "missing")
    assert contents(root) == FILES
    assert [path.name for path in root.parent.iterdir()] == ["generated"]


def test_an_unchanged_tree_is_left_alone(root: Path) -> None:
    before = stamps(root)
    assert tree.replace(root, FILES) == {}
    assert stamps(root) == before


def test_a_changed_tree(root: Path) -> None:
    expected = {"a/one.py": "changed", "a/two.tex": "extra", "b/three.py": "missing"}
    assert tree.compare(root, OTHER) == expected
    assert contents(root) == FILES
    assert tree.replace(root, OTHER) == expected
    assert contents(root) == OTHER
    assert tree.compare(root, OTHER) == {}
    assert [path.name for path in root.parent.iterdir()] == ["generated"]


def test_compare_is_by_bytes(root: Path) -> None:
    (root / "a/one.py").write_bytes(b"x = 1\r\n")
    (root / "a/two.tex").write_bytes("√3/2\n".encode("utf-16"))
    assert tree.compare(root, FILES) == {"a/one.py": "changed", "a/two.tex": "changed"}


def test_caches_of_python_are_not_extra(root: Path) -> None:
    cache = root / "a" / "__pycache__"
    cache.mkdir()
    (cache / "one.cpython-311.pyc").write_bytes(b"\0")
    assert tree.compare(root, FILES) == {}
    (root / "a" / "stray.pyc").write_bytes(b"\0")
    assert tree.compare(root, FILES) == {"a/stray.pyc": "extra"}


class Interrupted(Exception):
    """Stands for the end of the process."""


def test_failing_while_writing_aside(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The old tree is whole, and the next run does not stumble over what is left."""
    written = []

    def full(self: Path, data: bytes) -> None:
        if len(written) == 2:
            raise OSError("no space left on device")
        written.append(self)
        with self.open("wb") as file:
            file.write(data)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full)
        with pytest.raises(OSError, match="no space left"):
            tree.replace(root, OTHER)
    assert len(written) == 2
    assert contents(root) == FILES
    leftover = root.parent / ".generated.new" / "stale.py"
    leftover.write_text("")
    tree.replace(root, OTHER)
    assert contents(root) == OTHER
    assert [path.name for path in root.parent.iterdir()] == ["generated"]


@pytest.mark.parametrize("renames", [0, 1])
def test_interrupted_at_a_rename(root: Path, monkeypatch: pytest.MonkeyPatch, renames: int) -> None:
    """Before or between the two renames: `recover` brings the old tree back."""
    done: list[int] = []
    rename = os.rename

    def stop(source: Path, target: Path) -> None:
        if len(done) == renames:
            raise Interrupted
        done.append(1)
        rename(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "rename", stop)
        with pytest.raises(Interrupted):
            tree.replace(root, OTHER)
    assert root.exists() == (renames == 0)
    tree.recover(root)
    assert contents(root) == FILES
    tree.replace(root, OTHER)
    assert contents(root) == OTHER
    assert [path.name for path in root.parent.iterdir()] == ["generated"]


def test_interrupted_after_both_renames(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The new tree stands; what is left of the old one is cleared away."""
    remove, calls = shutil.rmtree, []

    def stop(path: Path, **options: object) -> None:
        calls.append(path)
        if path.name == ".generated.old":
            raise Interrupted
        remove(path, **options)

    with monkeypatch.context() as patch:
        patch.setattr(shutil, "rmtree", stop)
        with pytest.raises(Interrupted):
            tree.replace(root, OTHER)
    assert contents(root) == OTHER
    tree.recover(root)
    assert contents(root) == OTHER
    assert [path.name for path in root.parent.iterdir()] == ["generated"]


def test_replace_recovers_first(root: Path) -> None:
    """A tree that an interrupted run moved away counts as there: nothing has changed."""
    os.rename(root, root.parent / ".generated.old")
    assert tree.replace(root, FILES) == {}
    assert contents(root) == FILES


def test_recover_without_a_swap(root: Path, tmp_path: Path) -> None:
    before = stamps(root)
    tree.recover(root)
    assert stamps(root) == before
    tree.recover(tmp_path / "nothing")
    assert not (tmp_path / "nothing").exists()


def test_difference(root: Path) -> None:
    changed = tree.difference(root, OTHER, "a/one.py").splitlines()
    assert changed[:2] == ["--- generated/a/one.py", "+++ regenerated"]
    assert changed[-2:] == ["-x = 1", "+x = 2"]
    assert tree.difference(root, OTHER, "b/three.py").splitlines()[-1] == "+y = 3"
    assert tree.difference(root, OTHER, "a/two.tex").splitlines()[-1] == "-√3/2"
    assert tree.difference(root, FILES, "a/one.py") == ""


def test_difference_shows_line_ends(root: Path) -> None:
    """A file that is "changed" has a difference to show."""
    (root / "a/one.py").write_bytes(b"x = 1\r\n")
    assert tree.compare(root, FILES) == {"a/one.py": "changed"}
    assert tree.difference(root, FILES, "a/one.py") != ""


def test_difference_of_what_is_no_text(root: Path) -> None:
    """A stray binary file is named as extra; showing it must not end the check."""
    (root / "stray.pyc").write_bytes(b"\xff\xfe\x00")
    assert tree.compare(root, FILES) == {"stray.pyc": "extra"}
    assert tree.difference(root, FILES, "stray.pyc") != ""


def test_manifest() -> None:
    text = tree.manifest(FILES, {"sympy": "1.14.0"})
    found = json.loads(text)
    assert found["schema"] == tree.SCHEMA
    assert found["sympy"] == "1.14.0"
    expected = {name: hashlib.sha256(body.encode()).hexdigest() for name, body in FILES.items()}
    assert found["files"] == expected
    assert list(found["files"]) == sorted(expected)
    assert tree.manifest(dict(reversed(FILES.items())), {"sympy": "1.14.0"}) == text
