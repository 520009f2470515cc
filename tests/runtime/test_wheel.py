"""The wheel itself, in an environment of its own, installed as a user would."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import pytest

import kleinform

ROOT = Path(__file__).resolve().parents[2]
#: Modules that are compiled into the wheel.
EXTENSIONS = {
    "kleinform/_checks",
    "kleinform/forward/_compiled",
    "kleinform_kernels/uncoupled/_compiled",
}
needs_compiler = pytest.mark.skipif(
    kleinform.backend().name != "compiled", reason="there is no compiler here"
)
SCRIPT = """
import json, sys
from importlib import metadata
from importlib.resources import files

import numpy as np
import kleinform
from kleinform_kernels import uncoupled

turn = kleinform.rotation_from_rpy(
    roll=np.deg2rad(10.0), pitch=np.deg2rad(3.0), yaw=np.deg2rad(6.0)
)
robot = kleinform.UncoupledManipulator(1.0)
joints = robot.inverse_displacement([0.25, 0.2, 1.0], turn)
kernel = uncoupled.inverse_displacement(1.0, [0.25, 0.2, 1.0], turn)
positions, _ = robot.track(joints[np.newaxis], turn)
latex = files("kleinform_kernels") / "uncoupled" / "latex"
print(json.dumps({
    "version": [kleinform.__version__, metadata.version("kleinform")],
    "backend": kleinform.backend().name,
    "joints": joints.tolist(),
    "kernel": kernel.joints.tolist(),
    "position": positions[0].tolist(),
    "from": [kleinform.__file__, uncoupled.__file__],
    "installed": sorted(d.metadata["Name"].lower() for d in metadata.distributions()),
    "sympy": "sympy" in sys.modules,
    "latex": len([entry for entry in latex.iterdir() if entry.name.endswith(".tex")]),
}))
"""


def clean_environment() -> dict[str, str]:
    """Without what makes the source tree importable."""
    return {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}


def run(*command: object, cwd: Path, **more: str) -> str:
    result = subprocess.run(
        list(map(str, command)),
        cwd=cwd,
        env={**clean_environment(), **more},
        text=True,
        capture_output=True,
        check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def built(place: Path, **more: str) -> Path:
    """A wheel of the checkout."""
    command = [sys.executable, "-m", "pip", "wheel", ROOT, "--no-deps", "--quiet", "-w", place]
    run(*command, cwd=place, **more)
    (wheel,) = place.glob("kleinform-*.whl")
    return wheel


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("dist"))


@pytest.fixture(scope="module")
def pure_wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of a machine on which there is no compiler."""
    return built(tmp_path_factory.mktemp("pure"), CC=str(ROOT / "no-compiler"))


def names_in(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


@pytest.fixture(scope="module")
def names(wheel: Path) -> set[str]:
    return names_in(wheel)


def source_files() -> set[str]:
    """All of both packages."""
    found = set()
    for source in (ROOT / "src", ROOT / "generated"):
        files = [path for path in source.rglob("*") if path.is_file()]
        found |= {path.relative_to(source).as_posix() for path in files}
    return {name for name in found if "__pycache__" not in name}


def packaged(names: set[str]) -> set[str]:
    return {name for name in names if ".dist-info/" not in name}


@needs_compiler
def test_everything_is_in_the_wheel(names: set[str]) -> None:
    """All of both packages, the extension modules, and nothing else."""
    compiled = packaged(names) - source_files()
    assert source_files() <= packaged(names)
    assert {name.split(".")[0] for name in compiled} == EXTENSIONS
    assert {"kleinform/py.typed", "kleinform_kernels/py.typed"} <= names
    assert "kleinform_kernels/manifest.json" in names
    assert any(name.startswith("kleinform_kernels/uncoupled/latex/") for name in names)


def test_without_a_compiler_the_wheel_is_pure(pure_wheel: Path) -> None:
    assert packaged(names_in(pure_wheel)) == source_files()
    assert pure_wheel.name.endswith("-py3-none-any.whl")


def test_the_manifest_lists_the_wheels_kernels(wheel: Path, names: set[str]) -> None:
    prefix = "kleinform_kernels/"
    with zipfile.ZipFile(wheel) as archive:
        manifest = json.loads(archive.read(prefix + "manifest.json"))
    packaged = {name.removeprefix(prefix) for name in names if name.startswith(prefix)}
    modules = {name for name in packaged if name.endswith((".so", ".pyd"))}
    assert set(manifest["files"]) == packaged - {"manifest.json"} - modules


def test_metadata(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        (entry,) = [name for name in archive.namelist() if name.endswith("dist-info/METADATA")]
        lines = archive.read(entry).decode().splitlines()
    needed = [line for line in lines if line.startswith("Requires-Dist") and "extra" not in line]
    assert needed == ["Requires-Dist: numpy>=2.0"]
    assert "License-Expression: BSD-3-Clause" in lines
    assert (
        "none-any" in wheel.name
        or f"cp{sys.version_info.major}{sys.version_info.minor}" in wheel.name
    )


@pytest.mark.parametrize(
    ("kind", "backend"),
    [
        pytest.param("wheel", "compiled", marks=needs_compiler),
        pytest.param("pure_wheel", "numpy"),
    ],
    ids=["compiled", "pure"],
)
def test_in_a_clean_environment(
    kind: str, backend: str, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    wheel = request.getfixturevalue(kind)
    place = tmp_path / "environment"
    venv.create(place, with_pip=True)
    python = place / ("Scripts" if os.name == "nt" else "bin") / "python"
    run(python, "-m", "pip", "install", "--quiet", wheel, cwd=tmp_path)
    found = json.loads(run(python, "-c", SCRIPT, cwd=tmp_path))
    assert set(found["installed"]) <= {"kleinform", "numpy", "pip", "setuptools"}
    assert not found["sympy"]
    assert len(set(found["version"])) == 1
    assert found["backend"] == backend
    assert all(str(place) in origin for origin in found["from"])
    assert found["latex"] > 10
    # The paper's Section VI: joint values of its reference pose.
    paper = [1.000131, 1.191422, 0.869715, 0.674741, 1.260952, 1.05]
    assert found["joints"] == pytest.approx(paper, abs=1e-6)
    assert found["kernel"] == found["joints"]
    assert found["position"] == pytest.approx([0.25, 0.2, 1.0], abs=1e-15)
