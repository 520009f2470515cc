"""Commands without rows: ``kleinform paper``, ``kleinform verify``, ``kleinform latex``."""

from __future__ import annotations

from typing import Annotated

import typer

from kleinform.formulas import Formulas

__all__ = ["latex", "paper", "verify"]

Name = Annotated[str | None, typer.Argument(help="The formula, such as J_q or e_i.")]
Components = Annotated[
    bool, typer.Option("--components", help="Print the entries instead of vectors.")
]


def latex(name: Name = None, components: Components = False) -> None:
    """A formula as LaTeX, or the list of formulas.

    For amsmath, as it stands in a display.

    \b
    Example:
      kleinform latex J_q --components
    """
    formulas = Formulas()
    if name is None:
        print(formulas.listing())
    else:
        print(formulas.latex(name, components=components))


def paper() -> None:
    """The paper's numbers beside the computed ones.

    \b
    Example:
      kleinform paper
    """
    from kleinform.paper.__main__ import show
    from kleinform.paper.report import report

    show(report())


def verify() -> None:
    """Both examples of the paper by other engines.

    Pinocchio and Exudyn, joint by joint (extra kleinform[verify]); exit code 1 where they
    disagree with kleinform.

    \b
    Example:
      kleinform verify
    """
    from kleinform.verification.__main__ import main

    raise typer.Exit(main())
