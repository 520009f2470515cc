"""``python -m kleinform.paper [FILE]``: print the report, and write the audit to FILE."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from kleinform.paper.audit import audit
from kleinform.paper.report import Row, report


def show(parts: dict[str, list[Row]]) -> None:
    """Print every row, and how many are confirmed."""
    for title, rows in parts.items():
        print(f"\n{title}")
        print(f"  {'item':36}{'printed':28}{'computed':>12}{'difference':>12}  verdict")
        for row in rows:
            numbers = f"{row.printed:28}{row.computed:>12}{row.difference:12.1e}"
            print(f"  {row.item:36}{numbers}  {row.verdict}")
    rows = [row for part in parts.values() for row in part]
    confirmed = sum(row.confirmed for row in rows)
    print(f"\n{len(rows)} rows: {confirmed} confirmed, {len(rows) - confirmed} corrected or missed")


def write(path: Path, text: str) -> None:
    """Write a file whole or not at all."""
    aside = path.with_name(path.name + ".new")
    aside.write_text(text, encoding="utf-8", newline="\n")
    os.replace(aside, path)


def main(arguments: list[str]) -> int:
    """Run the command."""
    if len(arguments) > 1:
        print("usage: python -m kleinform.paper [FILE]", file=sys.stderr)
        return 2
    parts = report()
    text = audit(parts)
    show(parts)
    if arguments:
        write(Path(arguments[0]), text)
        print(f"audit written to {arguments[0]}")
    else:
        print(f"\n{text}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
