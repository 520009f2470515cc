"""``python -m kleinform``."""

from kleinform.cli import main

main()
