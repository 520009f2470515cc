"""Meshes: closed, oriented, on the boundary; their files; connected components."""

from itertools import pairwise

import numpy as np
import pytest

from kleinform.maps.lines import room
from tests.maps.workspace_support import LEGS, PAPER, SPACES, workspace

SHELL = workspace(PAPER, {"q6": (0.5, 1.3)})


@pytest.mark.parametrize("name", SPACES)
def test_meshes_are_closed_and_oriented(name):
    mesh = SPACES[name].mesh(24)
    edges = np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(edges, axis=0)) == len(edges)
    forth, back = (np.unique(part, axis=0) for part in (edges, edges[:, ::-1]))
    assert (forth == back).all()
    assert len(np.unique(mesh.triangles)) == len(mesh.vertices)
    assert mesh.euler_characteristic % 2 == 0
    assert mesh.volume > 0.0


@pytest.mark.parametrize("name", SPACES)
def test_vertices_are_on_the_boundary(name):
    space = SPACES[name]
    least = room(space.constraints, space.mesh(16).vertices)
    assert abs(least).max() < 1e-13


def test_volumes_converge():
    exact = 4.0 / 3.0 * np.pi * (1.3**3 - 0.5**3)
    errors = [abs(SHELL.mesh(n).volume - exact) / exact for n in (12, 24, 48)]
    assert errors[0] < 0.05
    assert all(fine < coarse / 3.0 for coarse, fine in pairwise(errors))
    assert abs(SPACES["paper"].mesh(60).volume - 1.2037384) < 3e-3


def test_euler_characteristics():
    assert SHELL.mesh(24).euler_characteristic == 4
    assert SPACES["paper"].mesh(40).euler_characteristic == 2
    ring = workspace(np.eye(3), {"q1": (0.5, 1.1), "e1": (0.2, 1.8)})
    assert ring.mesh(40).euler_characteristic == 0


def test_files(tmp_path):
    mesh = SPACES["paper"].mesh(12)
    mesh.write_stl(tmp_path / "space.stl")
    mesh.write_ply(tmp_path / "space.ply")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["space.ply", "space.stl"]
    stl = (tmp_path / "space.stl").read_bytes()
    assert len(stl) == 84 + 50 * len(mesh.triangles)
    assert int.from_bytes(stl[80:84], "little") == len(mesh.triangles)
    first = np.frombuffer(stl[84:132], dtype="<f4").reshape(4, 3)
    corners = mesh.vertices[mesh.triangles[0]]
    assert np.allclose(first[1:], corners, atol=1e-6)
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assert np.allclose(first[0], normal / np.linalg.norm(normal), atol=1e-6)
    header, body = (tmp_path / "space.ply").read_bytes().split(b"end_header\n", 1)
    assert f"element vertex {len(mesh.vertices)}\n".encode() in header
    size = 24 * len(mesh.vertices)
    assert (np.frombuffer(body[:size]).reshape(-1, 3) == mesh.vertices).all()
    faces = np.frombuffer(body[size:], dtype=[("count", "u1"), ("corners", "<i4", 3)])
    assert (faces["count"] == 3).all()
    assert (faces["corners"] == mesh.triangles).all()


def test_nothing_has_no_mesh_and_no_components():
    nothing = workspace(PAPER, {"q1": (0.4, 0.5), "q2": (0.4, 0.5), "q6": (5.0, 9.0)})
    assert nothing.mesh(10).triangles.shape == (0, 3)
    assert nothing.mesh(10).volume == 0.0
    assert nothing.components().count == 0
    empty = workspace(PAPER, {**LEGS, "q6": (0.0, 0.1)})
    assert empty.components(16).count == 0
    assert empty.mesh(16).euler_characteristic == 0


def test_components():
    # Nearly level, and outside of a cylinder along the X axis: to the left and to the right.
    sides = workspace(np.eye(3), {"q1": (0.5, 2.0), "q6": (0.1, 1.3), "q5": (-0.1, 0.1)})
    for space, count in ((SHELL, 1), (SPACES["paper"], 1), (sides, 2)):
        for lines in (16, 40):
            found = space.components(lines)
            assert found.count == count
            assert space.contains(found.positions).all()
            assert (np.diff(found.volumes) <= 0.0).all()
    found = sides.components(100)
    assert abs(found.positions[:, 1]).min() > 0.5
    assert found.volumes[0] == pytest.approx(found.volumes[1], rel=1e-9)
    assert sides.mesh(60).euler_characteristic == 4
