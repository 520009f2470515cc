"""Every figure, by the name of its file."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from kleinform.motion import JointMotion, PlatformStates
from kleinform.plots import histories, maps, regions, robots
from kleinform.plots.drawing import Figure, write
from kleinform.verification import by_pinocchio
from kleinform.verification.report import EXAMPLES, ours, start_of

__all__ = ["figures", "followed", "write_figures"]

SAMPLES = 321
#: Along the axes of a map, and along a side of the box that a surface is meshed in.
RESOLUTION = 121
#: Fig. 5 and 6 are of Example 1, Fig. 7 and 8 of Example 2.
NUMBERS = {"Example 1": (5, 6), "Example 2": (7, 8)}


def figures(samples: int = SAMPLES) -> dict[str, Callable[[], Figure]]:
    """The functions that draw the figures; the motions are followed when it is called.

    Raises
    ------
    MissingExtraError
        Pinocchio is not installed.
    """
    found = {"fig-2": robots.diagram, "fig-4": robots.screws, "modes": robots.modes}
    resolution = min(samples, RESOLUTION)
    found |= {"mode-maps": partial(maps.mode_maps, resolution), "joined": maps.joined}
    found |= {
        "fig-3": partial(regions.fig_3, resolution),
        "loci": partial(regions.loci, resolution),
    }
    for name, motion in EXAMPLES.items():
        own, theirs = followed(motion, samples)
        pose, rate = NUMBERS[name]
        found[f"fig-{pose}"] = partial(histories.poses, own, theirs, "Pinocchio", name)
        found[f"fig-{rate}"] = partial(histories.rates, own, theirs, "Pinocchio", name)
    return found


def followed(motion: JointMotion, samples: int) -> tuple[PlatformStates, PlatformStates]:
    """A motion of the platform by kleinform and by Pinocchio."""
    states = motion.sampled(samples)
    own = ours(states)
    return own, by_pinocchio.follow(start_of(own), states).platform


def write_figures(folder: Path, samples: int = SAMPLES) -> list[Path]:
    """Write every figure as SVG into a folder, which is created if need be."""
    drawn = figures(samples)
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, draw in sorted(drawn.items()):
        paths.append(folder / f"{name}.svg")
        write(draw, paths[-1])
    return paths
