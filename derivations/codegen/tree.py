"""The written tree: rendered aside, compared, swapped in whole."""

from __future__ import annotations

import difflib
import hashlib
import json
import os
import shutil
from collections.abc import Mapping
from pathlib import Path

__all__ = ["SCHEMA", "compare", "difference", "manifest", "recover", "replace"]

SCHEMA = 1

Tree = Mapping[str, str]


def manifest(files: Tree, facts: Mapping[str, object]) -> str:
    """The manifest: schema, facts of the derivation, and a hash of every file."""
    hashes = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
    return (
        json.dumps(
            {"schema": SCHEMA, **facts, "files": dict(sorted(hashes.items()))},
            indent=1,
            ensure_ascii=False,
        )
        + "\n"
    )


def compare(root: Path, files: Tree) -> dict[str, str]:
    """How the tree at ``root`` differs: name to "missing", "extra" or "changed"."""
    present = {
        path.relative_to(root).as_posix(): path
        for path in sorted(root.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    found = {name: "missing" for name in files if name not in present}
    found |= {name: "extra" for name in present if name not in files}
    found |= {
        name: "changed"
        for name, text in files.items()
        if name in present and present[name].read_bytes() != text.encode()
    }
    return dict(sorted(found.items()))


def difference(root: Path, files: Tree, name: str) -> str:
    """A unified diff of one file, from what is there to what should be."""
    path = root / name
    before = _lines(path.read_bytes()) if path.exists() else []
    after = _lines(files[name].encode()) if name in files else []
    lines = difflib.unified_diff(before, after, f"generated/{name}", "regenerated", lineterm="")
    return "\n".join(lines)


def _lines(content: bytes) -> list[str]:
    """Lines to show, with what is not plain text spelled out: ``\\r``, ``\\xff``."""
    text = content.decode("utf-8", errors="backslashreplace").replace("\r", "\\r")
    return text.split("\n")[:-1] if text.endswith("\n") else text.split("\n")


def replace(root: Path, files: Tree) -> dict[str, str]:
    """Make the tree at ``root`` exactly these files; leave it alone when it is.

    The new tree is written aside and renamed into place, so that an interrupted run leaves
    the old one whole and no file of an older run survives.
    """
    recover(root)
    changes = compare(root, files)
    if not changes:
        return {}
    aside, old = _aside(root), _old(root)
    for name, text in files.items():
        path = aside / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    if root.exists():
        os.rename(root, old)
    os.rename(aside, root)
    shutil.rmtree(old, ignore_errors=True)
    return changes


def recover(root: Path) -> None:
    """Clean up after an interrupted run: half a new tree, or a swap between its renames."""
    shutil.rmtree(_aside(root), ignore_errors=True)
    old = _old(root)
    if old.exists():
        if root.exists():
            shutil.rmtree(old)
        else:
            os.rename(old, root)


def _aside(root: Path) -> Path:
    return root.with_name(f".{root.name}.new")


def _old(root: Path) -> Path:
    return root.with_name(f".{root.name}.old")
