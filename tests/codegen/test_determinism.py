"""The same bytes for every hash seed and every Python."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import mpmath
import pytest
import sympy

ROOT = Path(__file__).resolve().parents[2]
SEEDS = ("0", "1", "12345")
SCRIPT = """
import hashlib, json, os, sys
os.environ["SYMPY_GROUND_TYPES"] = "python"
from derivations.generate import generate
files = generate().files
hashes = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
print(json.dumps([sys.version_info[:2], list(hashes.items())]))
"""


def generated_by(python: str, seed: str, path: tuple[Path, ...] = ()) -> str:
    """Version, and name and hash of every file, as JSON."""
    environment = {
        **os.environ,
        "PYTHONHASHSEED": seed,
        "PYTHONPATH": os.pathsep.join(map(str, [ROOT, *path])),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    command = [python, "-c", SCRIPT]
    run = subprocess.run(
        command, cwd=ROOT, env=environment, text=True, capture_output=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


def packages() -> Path:
    """Where the pure Python packages that derivations need are installed."""
    return Path(sympy.__file__).resolve().parents[1]


def other_pythons() -> list[str]:
    """Interpreters of other supported versions, one a version."""
    places = [Path(place) for place in os.environ.get("PATH", "").split(os.pathsep)]
    places += sorted(Path.home().glob(".pyenv/versions/*/bin"))
    found: dict[str, str] = {}
    own = ".".join(map(str, sys.version_info[:2]))
    for version in ("3.11", "3.12", "3.13", "3.14"):
        for place in places:
            candidate = place / f"python{version}"
            if version not in (own, *found) and runs(candidate):
                found[version] = str(candidate)
    return list(found.values())


def runs(python: Path) -> bool:
    """A shim of pyenv is there for versions that are not active, and fails."""
    if not python.exists():
        return False
    return subprocess.run([python, "-c", ""], capture_output=True, check=False).returncode == 0


@pytest.fixture(scope="module")
def by_seed() -> dict[str, str]:
    """What this Python generates, by hash seed."""
    with ThreadPoolExecutor(max_workers=2) as pool:
        outputs = pool.map(lambda seed: generated_by(sys.executable, seed), SEEDS)
        return dict(zip(SEEDS, outputs, strict=True))


def test_hash_seeds(by_seed: dict[str, str]) -> None:
    """Contents and order of all files."""
    assert len(set(by_seed.values())) == 1


def test_other_pythons(by_seed: dict[str, str]) -> None:
    others = other_pythons()
    if not others:
        pytest.skip("no other supported Python is installed")
    # SymPy and mpmath are pure Python: other versions can import them from here.
    assert {packages()} == {Path(m.__file__).resolve().parents[1] for m in (sympy, mpmath)}
    _, here = json.loads(by_seed["0"])
    with ThreadPoolExecutor(max_workers=2) as pool:
        outputs = pool.map(lambda python: generated_by(python, "7", (packages(),)), others)
        versions = [sys.version_info[:2]]
        for output in outputs:
            version, there = json.loads(output)
            assert there == here, version
            versions.append(tuple(version))
    assert len(set(versions)) == 1 + len(others)
