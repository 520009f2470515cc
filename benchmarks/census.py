"""``make census``: how many assembly modes joint values have, as a table and a picture."""

from __future__ import annotations

import sys
from io import BytesIO
from pathlib import Path

import numpy as np

import kleinform
from benchmarks.joint_values import DISTRIBUTIONS, joint_values
from kleinform.files import check_target, write_bytes

ROWS = 100_000
#: The most modes that a search found: random steps from the best joint values of the census.
MOST = (67.612, 18.942, 2.281, -3.145, -0.77, 2.435)
ROBOT = kleinform.UncoupledManipulator(radius=1.0)


def counts(distribution: str, rows: int) -> tuple[np.ndarray, np.ndarray]:
    """Shares of joint values by their number of modes, and of feasible modes."""
    modes = ROBOT.forward_displacement_batch(joint_values(distribution, rows, seed=6))
    row = np.repeat(np.arange(rows), modes.count)
    feasible = np.bincount(row[modes.feasible], minlength=rows)
    undecided = int((modes.status_codes == modes.STATUS.index("undecided")).sum())
    if undecided:
        print(f"{distribution}: {undecided} of {rows} rows undecided, counted as 0 modes")
    shares = [np.bincount(number, minlength=33) / rows for number in (modes.count, feasible)]
    return shares[0], shares[1]


def table(rows: int) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Print the census, and return it."""
    found = {}
    for name, words in DISTRIBUTIONS.items():
        found[name] = counts(name, rows)
        for title, shares in zip(("modes", "feasible"), found[name], strict=True):
            listed = ", ".join(
                f"{number}: {share:.2%}" for number, share in enumerate(shares) if share
            )
            print(f"{name:9} {title:9} {listed}")
        print(f"{'':9} {words}; {rows} rows")
    return found


def picture(found: dict[str, tuple[np.ndarray, np.ndarray]], path: Path) -> None:
    """Bars of both numbers for every distribution, as SVG."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    mpl.rcParams.update({"svg.hashsalt": "kleinform", "font.size": 9})
    figure = Figure(figsize=(7, 6.5), layout="constrained")
    axes = figure.subplots(len(found), 1, sharex=True)
    for axis, (name, (modes, feasible)) in zip(axes, found.items(), strict=True):
        number = np.arange(22)
        axis.bar(number - 0.2, 100 * modes[:22], 0.4, label="real modes")
        axis.bar(number + 0.2, 100 * feasible[:22], 0.4, label="feasible modes")
        axis.set_ylabel("joint values [%]")
        axis.set_title(f"{name}: {DISTRIBUTIONS[name]}", fontsize=9)
    axes[0].legend()
    axes[-1].set_xlabel("number of modes, one of each pair ±n")
    axes[-1].set_xticks(np.arange(0, 22, 2))
    drawn = BytesIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None})
    write_bytes(path, drawn.getvalue())


def most() -> None:
    """The joint values with the most modes that are known, and their certificate."""
    modes = ROBOT.forward_displacement(MOST, certify=True)
    print(f"most modes found: {len(modes)}, {int(modes.feasible.sum())} feasible, at q = {MOST}")
    assert modes.certificate is not None
    print(modes.certificate.reason)


if __name__ == "__main__":
    for given in sys.argv[1:]:
        check_target(given)
    census = table(ROWS)
    most()
    if len(sys.argv) > 1:
        picture(census, Path(sys.argv[1]))
        print(f"written to {sys.argv[1]}")
