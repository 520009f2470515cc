"""The audit of the paper as a page: every verdict comes from a proof or a computed number."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from importlib.resources import files
from typing import Any

from kleinform.paper.report import Row

__all__ = ["audit", "equation_verdicts", "proofs"]

LAST_EQUATION = 27
#: Equations that only say what a symbol means.
DEFINITIONS = (13, 14, 18, 20, 21)
#: Equations that the paper's text lacks.
LOST = (19,)
PROVEN_IN = "tests/derivations/test_identities.py"

HEAD = """\
# The paper, audited

Written by `make paper`; do not edit. Identities are reduced to exactly 0 by SymPy in \
`make derive`, counter-examples are computed in exact numbers there, and printed numbers are \
compared with the runtime's. `{test}` proves each identity by its name.

Verdicts: **confirmed**: proven as printed. **corrected**: a counter-example refutes what is \
printed, and what is true stands beside it. **definition**: it says what a symbol means, and \
identities prove what follows. **reconstructed**: missing in the paper's text, built from (22) \
to (24).
"""


def proofs() -> dict[str, Any]:
    """What ``make derive`` has proven and refuted, as it recorded it."""
    path = files("kleinform_kernels").joinpath("uncoupled", "proofs.json")
    record: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return record


def audit(parts: Mapping[str, list[Row]]) -> str:
    """The page, from the record of proofs and the rows of `kleinform.paper.report`."""
    record = proofs()
    sections = [
        HEAD.format(test=PROVEN_IN),
        "## Numbered equations\n",
        *_equations(record),
        "\n## What is wrong or incomplete, each with a counter-example in exact numbers\n",
        *_refuted(record["counterexamples"]),
        "## Identities\n",
        *_identities(record["identities"]),
        "\n## Printed numbers\n",
        *_numbers(parts),
    ]
    return "\n".join(sections).rstrip() + "\n"


def equation_verdicts(record: Mapping[str, Any]) -> dict[int, str]:
    """The verdict on each numbered equation."""
    # A counter-example to the text around an equation bears on no equation.
    refuted = {number for entry in record["counterexamples"] for number in entry["equations"]}
    proven = {number for entry in record["identities"] for number in entry["equations"]}
    verdicts = dict.fromkeys(range(1, LAST_EQUATION + 1), "unproven")
    verdicts |= dict.fromkeys(sorted(proven), "confirmed")
    verdicts |= dict.fromkeys(DEFINITIONS, "definition") | dict.fromkeys(LOST, "reconstructed")
    return verdicts | dict.fromkeys(sorted(refuted), "corrected")


def _equations(record: Mapping[str, Any]) -> Iterator[str]:
    yield "| equation | verdict | derived in | identities that bear on it |"
    yield "|---|---|---|---|"
    for number, verdict in equation_verdicts(record).items():
        places = record["sources"].get(str(number), [])
        names = [entry["name"] for entry in record["identities"] if number in entry["equations"]]
        shown = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
        derived = "<br>".join(f"`{place}`" for place in places)
        yield f"| ({number}) | {verdict} | {derived} | {shown} |"


def _refuted(entries: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    for entry in entries:
        where = "" if entry["equations"] else f", {entry['number']}"
        yield f"### {entry['name'][0].upper()}{entry['name'][1:]}{where}\n"
        yield f"Printed: {entry['claim']}\n"
        yield f"True: {entry['correction']}\n"
        yield f"Counter-example, `{entry['file']}`:\n"
        yield from (f"- {name} = `{value}`" for name, value in entry["facts"].items())
        yield ""


def _identities(entries: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    yield "| name | equation | claim, reduced to exactly 0 | in |"
    yield "|---|---|---|---|"
    for entry in entries:
        claim = entry["claim"].replace("|", "\\|")
        yield f"| {entry['name']} | {entry['number']} | {claim} | `{entry['file']}` |"


def _numbers(parts: Mapping[str, list[Row]]) -> Iterator[str]:
    for title, rows in parts.items():
        yield f"### {title}\n"
        yield "| number | printed | computed | difference | verdict |"
        yield "|---|---|---|---|---|"
        for row in rows:
            # Rounding differs between machines; what is at its level is shown as such.
            difference = f"{row.difference:.0e}" if abs(row.difference) > 1e-9 else "< 1e-9"
            yield f"| {row.item} | {row.printed} | {row.computed} | {difference} | {row.verdict} |"
        yield ""
