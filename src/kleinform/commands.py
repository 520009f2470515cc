"""The commands of ``kleinform``, one function each; plain text, so that pipes stay clean."""

from __future__ import annotations

from typing import Annotated

import typer

from kleinform.formulas import Formulas, UnknownFormulaError

__all__ = ["app"]

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


@app.callback()
def kleinform() -> None:
    """Kinematics and singularities of the uncoupled parallel manipulator 3-RPRRC+RRPRU."""


@app.command()
def latex(
    name: Annotated[str | None, typer.Argument(help="The formula, such as J_q or e_i.")] = None,
    components: Annotated[
        bool, typer.Option("--components", help="Print the entries instead of vectors.")
    ] = False,
) -> None:
    """Print one formula as LaTeX (amsmath); without a name, list the names."""
    formulas = Formulas()
    if name is None:
        typer.echo(formulas.listing())
        return
    try:
        typer.echo(formulas.latex(name, components=components))
    except UnknownFormulaError as error:
        typer.echo(f"{formulas.listing()}\n\n{error}", err=True)
        raise typer.Exit(2) from None
