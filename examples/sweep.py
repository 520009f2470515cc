"""A sweep over more poses than fit in memory: Dask over the compiled kernels, chunk by chunk.

python examples/sweep.py [POSES] counts, over a box of positions with the platform tilted, how
many poses the joints can reach and how near the nearest of them is to a direct singularity.
Nothing larger than a chunk is ever in memory. Needs Dask and the compiled kernels.
"""

from __future__ import annotations

import resource
import sys
import time

import dask
import dask.array as da
import numpy as np

import kleinform
from kleinform_kernels.uncoupled import gufuncs

CHUNK = 200_000
TILTED = kleinform.rotation_from_rpy(roll=0.2, pitch=-0.1, yaw=0.15)
#: Ranges of q1, q2, q3 and of q6 [m].
LEGS, CENTRAL = (0.4, 1.6), (0.6, 1.4)


def surveyed(position: da.Array, rotation: np.ndarray) -> list[da.Array]:
    """What the kernel ``survey`` gives, lazily, in the order of ``Survey``'s fields."""
    kernel = gufuncs.survey
    return da.apply_gufunc(
        kernel,
        kernel.signature,
        1.0,
        position,
        rotation,
        output_dtypes=[float] * kernel.nout,
        output_sizes={"6": 6},
    )


def main(poses: int) -> None:
    start = time.perf_counter()
    box = da.random.default_rng(1).uniform(-0.6, 0.6, size=(poses, 3), chunks=(CHUNK, 3))
    joints, _, _, direct, *_ = surveyed(box + np.array([0.0, 0.0, 1.0]), TILTED)
    legs, length = joints[:, :3], joints[:, 5]
    inside = (legs > LEGS[0]).all(axis=1) & (legs < LEGS[1]).all(axis=1)
    inside &= (length > CENTRAL[0]) & (length < CENTRAL[1])
    nearest = da.where(inside, abs(direct), np.inf).min()
    count, least = dask.compute(inside.sum(), nearest, scheduler="threads")
    seconds = time.perf_counter() - start
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{poses} poses, {count} within the limits, |det J_v| at least {least:.3g} m³ there")
    print(f"{seconds:.1f} s, {memory:.0f} MB at most")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000_000)
