"""``python -m kleinform.paper [FILE]``: print the report, and write the audit to FILE."""

from __future__ import annotations

import sys

from kleinform.errors import KleinformError
from kleinform.files import check_target, write_bytes
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


def main(arguments: list[str]) -> int:
    """Run the command."""
    if len(arguments) > 1:
        print("usage: python -m kleinform.paper [FILE]", file=sys.stderr)
        return 2
    try:
        run(*arguments)
    except (KleinformError, OSError) as error:
        print(f"kleinform.paper: {error}", file=sys.stderr)
        return 2
    return 0


def run(path: str | None = None) -> None:
    """Print the report, and write or print the audit."""
    if path is not None:
        check_target(path)
    parts = report()
    text = audit(parts)
    show(parts)
    if path is None:
        print(f"\n{text}")
    else:
        write_bytes(path, text.encode())
        print(f"audit written to {path}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
