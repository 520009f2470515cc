"""Meshes as files, and the options that ask for them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kleinform.errors import InputError
from kleinform.files import check_target

if TYPE_CHECKING:
    from kleinform.maps.mesh import Mesh

__all__ = ["MeshFile", "Resolution", "check_mesh_file", "write_mesh"]

SUFFIXES = (".stl", ".ply")

MeshFile = Annotated[
    Path | None,
    typer.Option("--mesh", metavar="FILE", help="Write the surface to a .stl or .ply [m]."),
]
Resolution = Annotated[
    int, typer.Option(min=1, max=500, help="With --mesh: cells along the longest side.")
]


def check_mesh_file(path: Path | None) -> None:
    """Refuse a file that cannot be written, before the work is done.

    Raises
    ------
    InputError
    """
    if path is None:
        return
    if path.suffix.lower() not in SUFFIXES:
        raise InputError(f"{path}: the name must end in one of {', '.join(SUFFIXES)}")
    check_target(path)


def write_mesh(mesh: Mesh, path: Path) -> None:
    """Write a mesh in the format that the file's name tells."""
    if path.suffix.lower() == ".stl":
        mesh.write_stl(path)
    else:
        mesh.write_ply(path)
