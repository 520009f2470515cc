"""LaTeX of vector expressions, as a paper writes them.

Vectors stay vectors and are bold, sums begin with a positive term, compound arguments of
products are parenthesised, a product is one fraction. What is printed is read by amsmath
and by latex2mathml alike. Which letter a name has is the business of a `Notation`.
"""

from __future__ import annotations

import re

from sympy import Abs, Add, Basic, Expr, MatAdd, MatMul, Mul, S, Symbol, cos, sin
from sympy.matrices.expressions import MatrixExpr
from sympy.matrices.expressions.matexpr import MatrixElement
from sympy.printing.latex import LatexPrinter

from derivations.algebra.vectors import Cross, Dot, component_symbols
from derivations.codegen.printers.letters import Notation

__all__ = ["VectorLatex", "brace_group", "width"]

#: A sum wider than this leaves its fraction, so that it can go over several lines.
WIDE_SUM = 62
#: What makes a text higher than a line.
TALL = (r"\frac", r"\sqrt", r"\begin", r"\left")
SILENT = re.compile(r"\\(left|right|mathbf|boldsymbol|mathrm|operatorname|det|dot)\b")


def width(latex: str) -> int:
    """About how many letters wide a formula is; of a fraction the wider half counts."""
    before, found, after = latex.partition(r"\frac")
    count = len(re.findall(r"\\[A-Za-z]+|[^{}\s_^\\]", SILENT.sub("", before)))
    if not found:
        return count
    over, after = brace_group(after)
    under, after = brace_group(after)
    return count + max(width(over), width(under)) + width(after)


def brace_group(text: str) -> tuple[str, str]:
    """The braced group that a text begins with, and what follows it."""
    depth = 0
    for place, letter in enumerate(text):
        depth += (letter == "{") - (letter == "}")
        if depth == 0:
            return text[1:place], text[place + 1 :]
    raise ValueError(f"unbalanced braces in {text}")


class VectorLatex(LatexPrinter):
    """Print scalars, vectors and matrices with the letters of ``notation``."""

    def __init__(self, notation: Notation) -> None:
        super().__init__()
        self.notation = notation

    def _print_Symbol(self, expr: Symbol, style: str = "plain") -> str:
        return self.notation.latex(expr.name)

    def _print_MatrixSymbol(self, expr: Basic) -> str:
        return self.notation.latex(expr.name, bold=True)

    def _print_MatrixElement(self, expr: MatrixElement) -> str:
        return self.notation.latex(_element_name(expr))

    # products of vectors

    def _print_Dot(self, expr: Basic) -> str:
        return r" \cdot ".join(map(self._argument, expr.args))

    def _print_Cross(self, expr: Basic) -> str:
        if any(argument.is_ZeroMatrix for argument in expr.args):
            return r"\mathbf{0}"
        coefficient, vectors = S.One, []
        for argument in expr.args:
            factor, (vector, *_) = _coefficient(argument)
            coefficient *= factor
            vectors.append(vector)
        if coefficient != 1:
            return self._print(MatMul(coefficient, Cross(*vectors)))
        return r" \times ".join(map(self._argument, vectors))

    def _argument(self, vector: Basic) -> str:
        """A factor of a product of vectors, in parentheses unless it is a letter."""
        text = self._print(vector)
        return text if vector.is_symbol or not vector.args else _parentheses(text)

    def _print_Convolution(self, expr: Basic) -> str:
        return r" \ast ".join(map(self._argument, expr.args))

    def _print_Norm(self, expr: Basic) -> str:
        return rf"\left|{self._print(expr.args[0])}\right|"

    _print_Abs = _print_Norm

    def _print_Klein(self, expr: Basic) -> str:
        first, second = map(self._print, expr.args)
        return _fenced(rf"{first};\, {second}", r"\{", r"\}")

    def _print_Lie(self, expr: Basic) -> str:
        first, second = map(self._print, expr.args)
        return _fenced(rf"{first} \; {second}", "[", "]")

    # matrices

    def _print_ZeroMatrix(self, expr: Basic) -> str:
        return r"\mathbf{0}"

    def _print_Stack(self, expr: Basic) -> str:
        return _matrix([[self._print(part)] for part in expr.args])

    def _print_Columns(self, expr: Basic) -> str:
        return _matrix([[self._print(column) for column in expr.args]])

    def _print_Rows(self, expr: Basic) -> str:
        rows = []
        for row in expr.args:
            parts = row.args if hasattr(row, "expanded") else (row,)
            rows.append([self._transposed(part) for part in parts])
        return _matrix(rows)

    def _print_Transpose(self, expr: Basic) -> str:
        return self._transposed(expr.args[0])

    def _transposed(self, vector: Basic) -> str:
        if vector.is_ZeroMatrix:
            return r"\mathbf{0}"
        coefficient, (factor, *_) = _coefficient(vector)
        text = self._print(factor)
        if not factor.is_symbol or text.startswith((r"\nabla", "{}")) or "^" in text:
            text = _parentheses(text)
        text += r"^{\mathrm{T}}"
        if coefficient == 1:
            return text
        return f"-{text}" if coefficient == -1 else f"{self._print(coefficient)} {text}"

    def _print_MatrixBase(self, expr: Basic) -> str:
        rows, columns = expr.shape
        return _matrix([[self._print(expr[r, k]) for k in range(columns)] for r in range(rows)])

    _print_ImmutableDenseMatrix = _print_MatrixBase

    # sums

    def _print_Add(self, expr: Basic, order: str | None = None) -> str:
        return " ".join(self._terms(expr))

    _print_MatAdd = _print_Add

    def _terms(self, expr: Basic) -> list[str]:
        """The terms of a sum with their signs, positive ones first."""
        texts = [self._print(term) for term in sorted(expr.args, key=self._term_key)]
        signed = [f"- {text[1:].lstrip()}" if text[0] == "-" else f"+ {text}" for text in texts]
        return [texts[0], *signed[1:]]

    def _term_key(self, term: Basic) -> tuple:
        scalar, vectors = _coefficient(term) if isinstance(term, MatrixExpr) else (term, [])
        coefficient, rest = scalar.as_coeff_Mul()
        keys = sorted(map(self._factor_key, Mul.make_args(rest))) if rest != 1 else []
        negative = bool(coefficient < 0) != _negative_sum(rest)
        factors = len(keys) + len(vectors)
        return negative, factors == 0, factors > 1, keys, [self._print(v) for v in vectors]

    # products of scalars, and of scalars with a vector

    def _factor_key(self, factor: Expr) -> tuple:
        base = factor.as_base_exp()[0]
        if base.is_number:
            return 0, [], 0, str(base)
        if base.is_Symbol:
            return 1, [self.notation.rank(base.name)], 0, ""
        if isinstance(base, MatrixElement):
            return 1, [self.notation.rank(_element_name(base))], 0, ""
        names = sorted(self.notation.rank(symbol.name) for symbol in base.free_symbols)
        kind = 2 if isinstance(base, (cos, sin)) else 3 if isinstance(base, Abs) else 4
        text = self._print(base)
        return kind, names if kind < 4 else [], width(text), text

    def _print_Mul(self, expr: Basic) -> str:
        return self._product(expr, [])

    def _print_MatMul(self, expr: Basic) -> str:
        return self._product(*_coefficient(expr))

    def _product(self, scalar: Expr, matrices: list[Basic]) -> str:
        sign, over, under = self._split(scalar)
        tail: list[Basic] = []
        if all(part.is_number for part in under):
            tail = [part for part in (*over, *matrices) if not part.is_number] if under else []
        else:
            wide = [part for part in (*over, *matrices) if self._is_wide(part)]
            tail = wide or [part for part in matrices if part.is_symbol and over]
        top = [part for part in (*over, *matrices) if part not in tail]
        if not under:
            return sign + self._factors(top)
        text = rf"{sign}\frac{{{self._factors(top)}}}{{{self._factors(under)}}}"
        return " ".join([text, *(self._factor(part) for part in tail)])

    def _is_wide(self, part: Basic) -> bool:
        """Whether a factor is a sum that may need more than one line."""
        return isinstance(part, (Add, MatAdd)) and width(self._print(part)) > WIDE_SUM

    def _split(self, scalar: Expr) -> tuple[str, list[Expr], list[Expr]]:
        """The sign, the factors over and the factors under the line."""
        coefficient, rest = scalar.as_coeff_Mul()
        over: list[Expr] = []
        under: list[Expr] = []
        negative = bool(coefficient < 0)
        for factor in sorted(Mul.make_args(rest), key=self._factor_key):
            if _negative_sum(factor):
                negative, factor = not negative, -factor
            power = factor.as_base_exp()[1]
            below = power.is_Rational and power < 0
            if factor != 1:
                (under if below else over).append(1 / factor if below else factor)
        p, q = abs(coefficient).as_numer_denom()
        over = [p, *over] if p != 1 else over
        under = [q, *under] if q != 1 else under
        return "-" if negative else "", over, under

    def _factors(self, parts: list[Basic]) -> str:
        if len(parts) == 1:
            return self._print(parts[0])
        text = ""
        for part, follower in zip(parts, [*parts[1:], None], strict=False):
            open_ended = isinstance(part, (cos, sin)) and follower is not None
            space = r" \, " if open_ended and not isinstance(follower, (cos, sin)) else " "
            text += self._factor(part) + space
        return text.rstrip() or "1"

    def _factor(self, part: Basic) -> str:
        text = self._print(part)
        return _parentheses(text) if isinstance(part, (Add, MatAdd, Dot, Cross)) else text

    # functions

    def _print_Pow(self, expr: Basic) -> str:
        base, exponent = expr.args
        if exponent == S.Half:
            return rf"\sqrt{{{self._print(base)}}}"
        if exponent.is_Rational and exponent < 0:
            return rf"\frac{{1}}{{{self._print(1 / expr)}}}"
        text = self._print(base)
        simple = base.is_number or isinstance(base, Abs) or base.is_symbol
        if "^" in text or not simple:
            text = _parentheses(text)
        return f"{text}^{{{self._print(exponent)}}}"

    def _print_cos(self, expr: Basic, exp: str | None = None) -> str:
        name = rf"\{type(expr).__name__}" + (f"^{{{exp}}}" if exp else "")
        text = self._print(expr.args[0])
        return f"{name} {text if expr.args[0].is_Symbol else _parentheses(text)}"

    _print_sin = _print_cos

    def _print_atan2(self, expr: Basic) -> str:
        arguments = r",\, ".join(map(self._print, expr.args))
        return rf"\operatorname{{atan2}}{_fenced(arguments, '(', ')')}"


def _element_name(element: MatrixElement) -> str:
    """The name of an entry's component symbol: ``c[0, 0]`` is ``c_x``."""
    parent, row, column = element.args
    return component_symbols(parent)[row, column].name


def _parentheses(text: str) -> str:
    """A text in parentheses, in brackets if it holds parentheses."""
    brackets = "(" in text and "[" not in text
    return _fenced(text, "[", "]") if brackets else _fenced(text, "(", ")")


def _fenced(text: str, left: str, right: str) -> str:
    """A text between delimiters, which grow if it is higher than a line."""
    if any(command in text for command in TALL):
        return rf"\left{left}{text}\right{right}"
    return f"{left}{text}{right}"


def _matrix(rows: list[list[str]]) -> str:
    body = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"


def _coefficient(vector: Basic) -> tuple[Expr, list[Basic]]:
    """The scalar in front of a vector, and the matrices that it multiplies."""
    if isinstance(vector, MatMul):
        return vector.as_coeff_matrices()
    return S.One, [vector]


def _negative_sum(expr: Basic) -> bool:
    """Whether every term of a sum is negative."""
    return isinstance(expr, Add) and all(term.as_coeff_Mul()[0] < 0 for term in expr.args)
