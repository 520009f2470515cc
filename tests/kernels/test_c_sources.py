"""kernels.h and kernels.c as a controller takes them: without a warning, in C and C++."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import kleinform
import kleinform_kernels
from derivations.uncoupled.kernels import kernels

SOURCES = Path(kleinform_kernels.__file__).parent / "uncoupled"
EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "controller.c"
STRICT = ("-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror")
COMPILERS = {
    "gcc": ("gcc", "-std=c99"),
    "clang": ("clang", "-std=c99"),
    "g++": ("g++", "-x", "c++", "-std=c++11"),
    "clang++": ("clang++", "-x", "c++", "-std=c++11"),
}


def run(*command: object) -> str:
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout


def needed(compiler: str) -> str:
    if not shutil.which(compiler):
        pytest.skip(f"{compiler} is not installed")
    return compiler


@pytest.mark.parametrize("compiler", COMPILERS)
def test_no_warning(compiler: str, tmp_path: Path) -> None:
    needed(compiler)
    run(*COMPILERS[compiler], *STRICT, "-O2", "-c", SOURCES / "kernels.c", "-o", tmp_path / "k.o")


def test_the_example_computes_what_numpy_does(tmp_path: Path) -> None:
    """The program in examples/, built as its comment says."""
    compiler = needed("gcc")
    program = tmp_path / "controller"
    run(
        *(compiler, "-std=c99", *STRICT, "-O2", f"-I{SOURCES}", EXAMPLE, SOURCES / "kernels.c"),
        *("-lm", "-o", program),
    )
    printed = re.findall(r"= (\S+), rate (\S+)", run(program))
    joints, rates = np.array(printed, dtype=float).T
    robot = kleinform.UncoupledManipulator(1.0)
    roll, pitch, yaw = np.radians([10.0, 3.0, 6.0])
    rotation = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
    position, twist = np.array([0.25, 0.2, 1.0]), np.array([0.0, 0.0, 0.1, 0.2, 0.0, 0.0])
    wanted = robot.inverse_displacement(position, rotation)
    np.testing.assert_allclose(joints, wanted, rtol=1e-15)
    np.testing.assert_allclose(rates, robot.inverse_velocity(position, rotation, twist), rtol=1e-14)


def test_every_kernel_is_documented() -> None:
    """What it does, the equation, and every argument with its shape and unit."""
    header = (SOURCES / "kernels.h").read_text(encoding="utf-8")
    for kernel in kernels():
        comment = header.split(f"KLEINFORM_API void kleinform_{kernel.name}(")[0].split("/* ")[-1]
        assert kernel.words in comment
        assert kernel.numbers in comment
        for field in (*kernel.inputs, *kernel.outputs):
            assert f"{field.words} [{field.unit}]" in comment


def test_nothing_but_libm() -> None:
    """No allocation, no globals, no other header."""
    source = (SOURCES / "kernels.c").read_text(encoding="utf-8")
    assert set(re.findall(r"#include (\S+)", source)) == {'"kernels.h"', "<math.h>", "<stddef.h>"}
    assert not re.search(r"\b(malloc|calloc|realloc|free|static double|static int)\b", source)
