"""kernels.h and kernels.c as a controller takes them: without a warning, in C and C++."""

from __future__ import annotations

import re
import shutil
import string
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


#: What headers of controllers, of the C library and of Windows define, beside single letters.
MACROS = (
    *("PI", "TWO_PI", "HALF_PI", "EPS", "EPSILON", "NULL", "TRUE", "FALSE", "BIT", "B0", "F_CPU"),
    *("min", "max", "abs", "round", "sq", "constrain", "radians", "degrees", "lowByte", "bit"),
    *("near", "far", "small", "interface", "IN", "OUT", "in", "out", "input", "output", "INPUT"),
    *("A0", "A1", "D1", "N", "DT", "Kp", "R0", "R1", "n1", "n2", "J", "M_PI", "_I", "complex"),
    *("unix", "linux", "major", "minor", "signals", "slots", "emit", "assert", "errno", "stdin"),
)
HOSTILE = """
#include "kernels.h"
int main(void) { return 0; }
"""


def words_of_kernels() -> set[str]:
    """Names that somebody who writes about this robot may define, all cases of them."""
    fields = [field for kernel in kernels() for field in (*kernel.inputs, *kernel.outputs)]
    names = {field.name for field in fields}
    for field in fields:
        names |= {str(symbol) for symbol in field.entries.free_symbols}
        names |= set(re.findall(r"[A-Za-z]\w*", field.words))
    parts = {part for name in names for part in name.split("_") if part}
    forms = {form for name in names | parts for form in (name, name.lower(), name.upper())}
    return {form for form in forms if form.isascii() and form.isidentifier()}


@pytest.mark.parametrize("compiler", COMPILERS)
def test_no_macro_breaks_the_header(compiler: str, tmp_path: Path) -> None:
    """Every letter, common macros, and every word of the kernels, defined before the header."""
    needed(compiler)
    keywords = {"const", "double", "extern", "void", "int", "main", "return", "and", "or", "not"}
    macros = {*string.ascii_letters, *MACROS, *words_of_kernels()} - keywords
    assert {"R", "a", "I", "joints", "J_v", "pitch", "next"} <= macros
    assert len(macros) > 300
    file = tmp_path / "hostile.c"
    includes = "" if "++" in compiler else "#include <complex.h>\n"
    lines = [f"#undef {name}\n#define {name} 5 +" for name in sorted(macros)]
    file.write_text(includes + "\n".join(lines) + HOSTILE, encoding="utf-8")
    run(*COMPILERS[compiler], "-Wall", "-Wextra", "-Werror", f"-I{SOURCES}", "-fsyntax-only", file)


def test_what_a_macro_could_replace_in_the_header() -> None:
    """Names that begin with kleinform_, KLEINFORM_, in_ or out_, and nothing else."""
    header = (SOURCES / "kernels.h").read_text(encoding="utf-8")
    code = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    code = re.sub(r"^#.*$", "", code, flags=re.MULTILINE).replace('extern "C"', "")
    names = set(re.findall(r"[A-Za-z_]\w*", code)) - {"const", "double", "void"}
    assert {"in_R", "out_joints"} <= names
    assert {name for name in names if not re.match("(kleinform|KLEINFORM|in|out)_", name)} == set()


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
