"""``kleinform workspace``: volume, its error, pieces, a mesh; a spinner for who waits."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from kleinform import Limits, UncoupledManipulator
from kleinform.commands import progress
from kleinform.commands.inverse import rotation_of
from kleinform.maps import Volume, Workspace, constant_orientation_workspace

PAPER = ("--rpy", 10, 3, 6, "--degrees")
MARGINS = (
    "margins are not bounded by quadrics, wrist arrived: "
    "a workspace takes ranges alone, robot.watch takes margins too"
)
RANGES = """[ranges]
q1 = [0.6, 1.5]
q2 = [0.6, 1.5]
q3 = [0.6, 1.5]
q6 = [0.7, 1.4]
"""


def flint() -> None:
    pytest.importorskip("flint", reason="the extra kleinform[certify] is not installed")


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """A volume at once, and what tolerance was asked for; 1e-8 is not reached."""
    asked = []

    def volume(_: Workspace, relative: float) -> Volume:
        asked.append(relative)
        return Volume(1.0, 1e-7, relative > 1e-8, 1)

    monkeypatch.setattr(Workspace, "volume", volume)
    return asked


def test_the_numbers(run) -> None:
    flint()
    ran = run("workspace", *PAPER, "--tolerance", 1e-4, "--format", "json")
    assert (ran.code, ran.err) == (0, "")
    space = constant_orientation_workspace(
        UncoupledManipulator(), rotation_of((10, 3, 6), True), Limits.typical()
    )
    volume = space.volume(1e-4)
    assert json.loads(ran.out) == {
        "volume": volume.value,
        "volume_error": volume.error,
        "components": 1,
    }


def test_typical_limits_grow_with_the_radius(run) -> None:
    flint()
    volumes = []
    for radius in (1, 2):
        ran = run("workspace", *PAPER, "--tolerance", 1e-4, "--radius", radius)
        volumes.append(float(ran.out.splitlines()[1].split(",")[0]))
    assert volumes[1] == pytest.approx(8 * volumes[0], rel=1e-3)


def test_limits_in_degrees(run, tmp_path: Path) -> None:
    flint()
    ranges = RANGES + "q5 = [{}, {}]\n"
    (tmp_path / "deg.toml").write_text('unit = "deg"\n' + ranges.format(40, 90))
    (tmp_path / "rad.toml").write_text(ranges.format(*np.radians([40.0, 90.0]).tolist()))
    first, second = (
        run("workspace", *PAPER, "--limits", name, "--tolerance", 1e-3)
        for name in ("deg.toml", "rad.toml")
    )
    assert (first.code, first.err) == (0, "")
    assert first.out == second.out


@pytest.mark.parametrize(("degrees", "angle"), [((), "0.1 rad"), (("--degrees",), "5.72958 deg")])
def test_an_empty_workspace_says_why(run, tmp_path: Path, degrees: tuple, angle: str) -> None:
    """That there is no position is an answer, and not a silent one."""
    flint()
    text = "[ranges]\nq1 = [0.9, inf]\nq2 = [0.1, 9]\nq4 = [-0.1, 0.1]\nq5 = [-0.1, 0.1]\n"
    (tmp_path / "limits.toml").write_text(text + "q6 = [0.5, 1.0]\ne1 = [-5, 5]\n")
    ran = run("workspace", "--rpy", 0, 0, 0, "--limits", "limits.toml", *degrees)
    assert ran.code == 0
    assert ran.out.startswith("volume,volume_error,components\n0.0,")
    ends = f"q1 >= 0.9 m, q4 >= -{angle}, q4 <= {angle}, q5 >= -{angle}, q5 <= {angle}, q6 <= 1 m"
    assert ran.err == (
        f"kleinform: the workspace is empty: at this orientation {ends} exclude each other\n"
    )


@pytest.mark.parametrize("suffix", [".stl", ".PLY"])
def test_the_mesh(run, tmp_path: Path, quick, suffix: str) -> None:
    (tmp_path / "limits.toml").write_text(RANGES)
    path = tmp_path / f"space{suffix}"
    limits = ("--limits", "limits.toml", "--resolution", 12)
    assert run("workspace", *PAPER, *limits, "--mesh", path).code == 0
    space = constant_orientation_workspace(
        UncoupledManipulator(),
        rotation_of((10, 3, 6), True),
        Limits.from_toml(tmp_path / "limits.toml"),
    )
    mesh, data = space.mesh(12), path.read_bytes()
    if suffix == ".stl":
        assert np.frombuffer(data[80:84], "<u4") == len(mesh.triangles)
    else:
        assert f"element face {len(mesh.triangles)}\n".encode() in data
    assert quick == [1e-6]


def test_a_tolerance_that_is_not_reached(run, quick) -> None:
    """Exit code 1: the bound holds, it is only larger than asked for."""
    ran = run("workspace", *PAPER, "--tolerance", 1e-8)
    assert ran.code == 1
    assert ran.out == "volume,volume_error,components\n1.0,1e-07,1\n"
    assert ran.err == "kleinform: the error is larger than --tolerance asks for\n"


@pytest.mark.parametrize(
    ("toml", "message"),
    [
        ("[ranges", "limits.toml: not TOML: "),
        ("[range]", "limits.toml: [ranges], [margins], unit are known, 'range' arrived"),
        ("[ranges]\nq7 = [0, 1]", "limits.toml: ranges: one of q1, "),
        ("[ranges]\nq1 = [1, 0]", "limits.toml: q1: (low, high) with low < high is needed"),
        ("[ranges]\nq5 = [0, 1]", "--limits: the workspace is unbounded"),
        ("[ranges]\nq5 = [40, 90]", "limits.toml: q5: within a full turn is needed, [40, 90] "),
        ("unit = 'grad'", 'limits.toml: unit: "rad" or "deg" is needed'),
        ("[ranges]\nq1 = " + 5000 * "[", "limits.toml: not TOML of limits: nested too deep"),
        ("[margins]\nwrist = 0.1", f"--limits: {MARGINS}"),
    ],
)
def test_bad_limits(run, tmp_path: Path, toml: str, message: str) -> None:
    (tmp_path / "limits.toml").write_text(toml)
    ran = run("workspace", *PAPER, "--limits", "limits.toml")
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert ran.err.startswith(f"kleinform: {message}")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((), "Missing option '--rpy'"),
        ((*PAPER, "--limits", "none.toml"), "none.toml: No such file"),
        ((*PAPER, "--mesh", "space.obj"), "space.obj: the name must end in one of .stl, .ply"),
        ((*PAPER, "--mesh", "none/space.stl"), "none/space.stl: there is no folder "),
        ((*PAPER, "--mesh", "folder.stl"), "folder.stl: not a file"),
        ((*PAPER, "--resolution", 0), "Invalid value for '--resolution'"),
        ((*PAPER, "--tolerance", 1e-12), "--tolerance: from 1e-9 to 1 is needed"),
        (("--rpy", 0, 0, 90, "--degrees"), "n_1·u_1 = 0, B_1 is not defined"),
    ],
)
def test_bad_options(run, tmp_path: Path, arguments: tuple[object, ...], message: str) -> None:
    (tmp_path / "folder.stl").mkdir()
    ran = run("workspace", *arguments)
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert ran.err.startswith(f"kleinform: {message}")


def test_without_the_extra(run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flint", None)
    ran = run("workspace", *PAPER)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.endswith("install kleinform[certify]\n")


@pytest.mark.parametrize("terminal", [False, True])
@pytest.mark.parametrize("patience", [0.0, 60.0])
def test_the_spinner(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    terminal: bool,
    patience: float,
) -> None:
    """At a terminal, after a while."""
    monkeypatch.setattr(progress, "PATIENCE", patience)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal)
    monkeypatch.setenv("TERM", "xterm")
    with progress.spinner("workspace"):
        time.sleep(0.3)
    captured = capsys.readouterr()
    assert captured.out == ""
    assert ("workspace" in captured.err) == (terminal and not patience)
