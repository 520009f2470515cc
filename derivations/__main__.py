"""``python -m derivations derive | check | where``: the only file that writes."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

# Exact arithmetic must not depend on which number library happens to be installed.
os.environ["SYMPY_GROUND_TYPES"] = "python"

from derivations.codegen.tree import compare, difference, recover, replace
from derivations.generate import Generated, generate

ROOT = Path(__file__).resolve().parent.parent / "generated" / "kleinform_kernels"
SHOWN = "generated/kleinform_kernels"


def derive() -> int:
    """Regenerate the tree and print what was derived, proven and written."""
    start = time.perf_counter()
    generated = generate()
    changes = replace(ROOT, generated.files)
    for name, change in changes.items():
        print(f"{change:8} {SHOWN}/{name}")
    print(table(generated, changes, time.perf_counter() - start))
    return 0


def check() -> int:
    """Compare the tree with what the derivations give now; 1 if they differ."""
    recover(ROOT)
    generated = generate()
    changes = compare(ROOT, generated.files)
    for name, change in changes.items():
        print(f"{change}: {SHOWN}/{name}")
        print(difference(ROOT, generated.files, name))
    if changes:
        print(f"{len(changes)} generated files are not up to date: run make derive")
        return 1
    print(f"{SHOWN}: {len(generated.files)} files, all as derived")
    return 0


def where() -> int:
    """Say where the formulas are."""
    latex = ROOT / "uncoupled" / "latex"
    count = len(list(latex.glob("*.tex"))) - 1
    print(f"{count} formulas    {SHOWN}/uncoupled/latex/NAME.tex")
    print(f"document       {SHOWN}/uncoupled/latex/equations.tex")
    print(f"page           {SHOWN}/uncoupled/latex/equations.html")
    print("one by name    kleinform latex J_q")
    return 0


def table(generated: Generated, changes: dict[str, str], seconds: float) -> str:
    """The summary that ends ``make derive``."""
    before = sum(program.operations_before for program in generated.programs)
    after = sum(program.operations for program in generated.programs)
    files = len(generated.files)
    written = sum(change != "extra" for change in changes.values())
    removed = len(changes) - written
    fate = f"{written} written, {removed} removed, {files - written} unchanged"
    rows = [
        ("equations", f"{generated.equations}"),
        ("identities", f"{generated.identities} proven ({generated.proven} expressions, all 0)"),
        ("refuted claims", f"{generated.counterexamples}, each by an exact counter-example"),
        (
            "kernels",
            f"{len(generated.programs)}, lowering proven ({generated.lowered} expressions)",
        ),
        ("operations", f"{before} before common subexpressions, {after} after"),
        ("files", fate if changes else f"{files}, nothing changed"),
        ("seconds", f"{seconds:.1f}"),
    ]
    return "\n".join(f"{name:15} {value}" for name, value in rows)


COMMANDS = {"derive": derive, "check": check, "where": where}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in COMMANDS:
        sys.exit(f"usage: python -m derivations {' | '.join(COMMANDS)}")
    sys.exit(COMMANDS[sys.argv[1]]())
