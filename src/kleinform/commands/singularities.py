"""``kleinform singularities``: the surfaces of direct singularities at one orientation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from kleinform.commands import options
from kleinform.commands.columns import Table
from kleinform.commands.inverse import rotation_of
from kleinform.commands.meshes import MeshFile, check_mesh_file, write_mesh
from kleinform.commands.progress import spinner
from kleinform.commands.streams import Streams
from kleinform.commands.terminal import WIDTH, word
from kleinform.manipulator import UncoupledManipulator

if TYPE_CHECKING:
    from kleinform.maps.loci import DirectLocus

__all__ = ["singularities"]

CUBIC = "orientation"
#: In the order of the coefficients; those of a plane are the first four.
MONOMIALS = (
    *("1", "x", "y", "z"),
    *("x²", "xy", "xz", "y²", "yz", "z²"),
    *("x³", "x²y", "x²z", "xy²", "xyz", "xz²", "y³", "y²z", "yz²", "z³"),
)
#: Of the cubic's coefficients, by degree.
UNITS = ("m³",) + 3 * ("m²",) + 6 * ("m",) + 10 * ("1",)

Box = Annotated[
    options.Six | None,
    typer.Option(
        metavar="XMIN XMAX YMIN YMAX ZMIN ZMAX",
        help="With --mesh: the box that it fills [m]; two radii around (0, 0, radius) unless "
        "given.",
    ),
]
Resolution = Annotated[
    int, typer.Option(min=1, max=256, help="With --mesh: cells along each edge of the box.")
]


def singularities(
    rpy: options.Orientation,
    mesh: MeshFile = None,
    box: Box = None,
    resolution: Resolution = 64,
    format: options.AnswerFormat = None,
    degrees: options.Degrees = False,
    radius: options.Radius = 1.0,
) -> None:
    """Surfaces of direct singularities at one orientation.

    Polynomials in the position c that vanish where a factor does: a cubic for orientation, and
    planes. --mesh writes the cubic's surface.

    Columns out: surface (orientation, extension_1, extension_2, extension_3, wrist), kind (of
    the cubic: cubic, plane and quadric, double plane, so many planes, or identically zero; of
    the others: plane), monomial (1, x, y, z, x², ...), coefficient [m³, m², m, 1 by degree; of
    planes m, 1].

    \b
    Examples:
      kleinform singularities --rpy 10 3 6 --degrees
      kleinform singularities --rpy 10 3 6 --degrees --mesh cubic.ply \\
          --box -1 1 -1 1 0 2 --resolution 40
    """
    check_mesh_file(mesh)
    from kleinform.maps.loci import direct_locus
    from kleinform.maps.mesh import Mesh

    locus = direct_locus(UncoupledManipulator(radius), rotation_of(rpy, degrees))
    if mesh is not None:
        with spinner("mesh"):
            write_mesh(Mesh(*locus.mesh(_bounds(box, radius), resolution)), mesh)
    streams = Streams(None, None, format, degrees)
    if streams.aligned:
        _print_aligned(locus)
    else:
        with streams.writer(one_answer=True) as write:
            write(_table(locus))


def _bounds(box: options.Six | None, radius: float) -> list[list[float]]:
    """The lowest and the highest corner."""
    if box is None:
        reach = 2.0 * radius
        return [[-reach, -reach, radius - reach], [reach, reach, radius + reach]]
    return [list(box[0::2]), list(box[1::2])]


def _table(locus: DirectLocus) -> Table:
    """A row for each coefficient of each surface."""
    surfaces = {CUBIC: locus.coefficients, **locus.planes}
    sizes = list(map(len, surfaces.values()))
    kinds = [locus.kind] + ["plane"] * len(locus.planes)
    return {
        "surface": np.repeat(list(surfaces), sizes),
        "kind": np.repeat(kinds, sizes),
        "monomial": np.concatenate([MONOMIALS[:size] for size in sizes]),
        "coefficient": np.concatenate(list(surfaces.values())) + 0.0,
    }


def _print_aligned(locus: DirectLocus) -> None:
    """The cubic a line a coefficient, then the planes a line each."""
    print(f"{CUBIC}: {locus.kind}")
    for monomial, unit, value in zip(MONOMIALS, UNITS, locus.coefficients.tolist(), strict=True):
        print(f"{monomial + f' [{unit}]':{WIDTH}} {word(value + 0.0):>{WIDTH}}")
    print(f"\n{'planes':{WIDTH}}", *(f"{name:>{WIDTH}}" for name in ("1 [m]", *"xyz")))
    for name, plane in locus.planes.items():
        print(f"{name:{WIDTH}}", *(f"{word(value + 0.0):>{WIDTH}}" for value in plane.tolist()))
