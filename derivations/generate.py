"""From the mechanism to the text of every generated file; nothing is written here."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zlib import crc32

import sympy

from derivations.codegen.lower import Program, lower, prove_lowering
from derivations.codegen.printers import arb, c, compiled, mpmath, numpy
from derivations.codegen.printers.python import class_name
from derivations.codegen.tree import SCHEMA, manifest
from derivations.sources import equation_sources, numbers_in, printed_equation, source_of
from derivations.uncoupled.counterexamples import counterexamples
from derivations.uncoupled.identities import identities
from derivations.uncoupled.kernels import kernels
from derivations.uncoupled.rendering import latex_files

__all__ = ["Generated", "generate"]

NOTICE = """\
# Generated from derivations/ by "make derive"; do not edit.
# SPDX-License-Identifier: BSD-3-Clause
"""
#: A package's own module, at its end: the modules that it does not need itself.
LAZY = '''

def __getattr__(name: str) -> ModuleType:
    """Modules that are loaded when somebody asks for them."""
    if name in {names}:
        return import_module(f"{{__name__}}.{{name}}")
    raise AttributeError(f"module {{__name__!r}} has no attribute {{name!r}}")
'''
SUPPORT = Path(__file__).parent / "codegen" / "support"
#: What is compiled besides the kernels.
C_SUPPORT = ("simd.h", "table.h", "extension.c")


@dataclass(frozen=True)
class Generated:
    """Every file's text by its path in the package, and what the table reports."""

    files: dict[str, str]
    equations: int
    identities: int
    proven: int
    counterexamples: int
    lowered: int
    programs: tuple[Program, ...]


def generate() -> Generated:
    """Derive, prove and print everything.

    Raises
    ------
    DerivationError
        An equation uses what is not defined, or lowering changed it.
    IdentityError
        A claim does not reduce to zero, or a counter-example does not contradict its claim.
    """
    programs = tuple(lower(kernel) for kernel in kernels())
    lowered = sum(prove_lowering(program) for program in programs)
    proofs, proven = _prove()
    files = _package(programs)
    files["uncoupled/proofs.json"] = (
        json.dumps(proofs, indent=1, ensure_ascii=False, sort_keys=False) + "\n"
    )
    files |= {f"uncoupled/latex/{name}": text for name, text in latex_files().items()}
    files["manifest.json"] = manifest(files, _facts(programs))
    return Generated(
        files=files,
        equations=len(_equation_names(programs)),
        identities=len(proofs["identities"]),
        proven=proven,
        counterexamples=len(proofs["counterexamples"]),
        lowered=lowered,
        programs=programs,
    )


def _prove() -> tuple[dict[str, Any], int]:
    """Prove every identity, check every counter-example, and record both."""
    proven = [(identity, identity.prove()) for identity in identities()]
    claims = [
        {
            "name": identity.name,
            "number": identity.number,
            "equations": numbers_in(identity.number),
            "claim": identity.claim,
            "file": source_of(identity.difference),
            "expressions": count,
        }
        for identity, count in proven
    ]
    refuted = [
        {
            "name": example.name,
            "number": example.number,
            "equations": printed_equation(example.number),
            "claim": example.claim,
            "correction": example.correction,
            "file": source_of(example.check),
            "facts": {name: str(value) for name, value in example.check().items()},
        }
        for example in counterexamples()
    ]
    sources = {str(number): places for number, places in equation_sources().items()}
    record = {"identities": claims, "counterexamples": refuted, "sources": sources}
    return record, sum(count for _, count in proven)


def _package(programs: tuple[Program, ...]) -> dict[str, str]:
    """The files that run."""
    listed = list(programs)
    modules = {
        "_apply.py": _support("apply.py"),
        "_backend.py": _support("backend.py"),
        "_threads.py": _support("threads.py"),
        "uncoupled/__init__.py": _choice(listed),
        "uncoupled/numpy_kernels.py": numpy.print_module(listed),
        "uncoupled/compiled_kernels.py": compiled.print_module(listed),
        "uncoupled/gufuncs.py": compiled.print_gufuncs(listed),
        "uncoupled/_compiled.pyi": compiled.print_stub(listed),
        "uncoupled/mpmath_kernels.py": mpmath.print_module(listed),
        "uncoupled/arb_kernels.py": arb.print_module(listed),
    }
    files = {name: NOTICE + text for name, text in modules.items()}
    checksum, sources = _sources(listed)
    return {**files, **sources, "__init__.py": NOTICE + _root(files, checksum), "py.typed": ""}


def _choice(programs: list[Program]) -> str:
    """The subpackage's own module: the kernels of the backend that is in use."""
    names = [program.kernel.name for program in programs]
    exported = sorted([*names, *map(class_name, names)])

    def imported(module: str, names: list[str]) -> str:
        entries = "\n".join(f"        {name}," for name in sorted(names))
        return f"    from kleinform_kernels.uncoupled.{module} import (\n{entries}\n    )"

    classes = "\n".join(f"    {class_name(name)}," for name in sorted(names, key=class_name))
    quoted = "\n".join(f'    "{name}",' for name in ["BACKEND", *exported])
    return (
        '"""Kernels of the uncoupled manipulator 3-RPRRC+RRPRU, on arrays."""\n\n'
        "from importlib import import_module\n"
        "from types import ModuleType\n\n"
        "from kleinform_kernels._backend import BACKEND\n"
        f"from kleinform_kernels.uncoupled.numpy_kernels import (\n{classes}\n)\n\n"
        f'if BACKEND == "compiled":\n{imported("compiled_kernels", names)}\n'
        f"else:\n{imported('numpy_kernels', names)}\n\n"
        f"__all__ = [\n{quoted}\n]\n"
        + LAZY.format(names='("arb_kernels", "compiled_kernels", "gufuncs", "mpmath_kernels")')
    )


def _sources(programs: list[Program]) -> tuple[int, dict[str, str]]:
    """The C files, and a checksum that the extension has if it was compiled from them."""
    sources = {name: c.LICENSE + _support(name) for name in C_SUPPORT}
    sources["kernels.h"] = c.print_header(programs)
    sources["kernels.c"] = c.print_source(programs)
    checksum = crc32("".join(sources.values()).encode())
    sources["lanes.c"] = c.print_lanes(programs, checksum)
    return checksum, {f"uncoupled/{name}": text for name, text in sources.items()}


def _support(name: str) -> str:
    return (SUPPORT / name).read_text(encoding="utf-8")


def _root(files: dict[str, str], compiled: int) -> str:
    """The package's own module: what the runtime checks before it uses the kernels."""
    sums = [f'    "{name}": {crc32(text.encode())},' for name, text in files.items()]
    return "\n".join(
        [
            '"""Generated kernels, one subpackage a mechanism; NumPy is all they need."""',
            "",
            "from importlib import import_module",
            "from types import ModuleType",
            "",
            "#: Version of the interface between the kernels and the runtime.",
            f"SCHEMA = {SCHEMA}",
            "#: CRC-32 of each module, so that no edited kernel runs unnoticed.",
            "CHECKSUMS = {",
            *sums,
            "}",
            "#: CRC-32 of the C sources: an extension that was compiled from others is not used.",
            f"COMPILED = {compiled}",
            LAZY.format(names='("uncoupled",)'),
        ]
    )


def _facts(programs: tuple[Program, ...]) -> dict[str, object]:
    """What the manifest says of the derivation."""
    listed = {
        program.kernel.name: {
            "inputs": {entry.name: list(entry.shape) for entry in program.kernel.inputs},
            "outputs": {entry.name: list(entry.shape) for entry in program.kernel.outputs},
            "operations": program.operations,
        }
        for program in programs
    }
    return {"sympy": sympy.__version__, "kernels": listed}


def _equation_names(programs: Iterable[Program]) -> set[str]:
    """Equations that kernels stand on, each counted once."""
    return {equation.name for program in programs for equation in program.kernel.graph}
