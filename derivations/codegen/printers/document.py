"""All formulas in one place: a LaTeX article and a self-contained HTML page."""

from __future__ import annotations

import re
from dataclasses import dataclass
from html import escape
from itertools import groupby

from latex2mathml.converter import convert

__all__ = ["NOTICE", "Entry", "html_page", "mathml", "tex_document"]

NOTICE = 'Generated from derivations/ by "make derive"; do not edit.'

#: A letter with an index, as words write it: n_i, B_1, v_C, q4.
INDEXED = re.compile(
    r"([A-Za-zΑ-ω])_([A-Za-z0-9]+?)(?=[A-Z]_|[^A-Za-z0-9]|$)|\b(q)(\d)(?![A-Za-z0-9])"
)
#: Greek letters that words spell out.
SPELLED = {"lambda": "λ", "omega": "ω", "nu": "ν", "theta": "θ", "phi": "φ"}
#: What is set as mathematics: a letter with its index, a sign, a power.
IN_MATH = re.compile(r"[A-Za-zΑ-ω]_\{\w+\}|√\d/\d|[⁰¹²³⁴-⁹]+|[°·×−∗|$Α-ω]")
POWER = re.compile("[⁰¹²³⁴-⁹]+")
DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
IN_TEX = {
    "°": r"{}^{\circ}",
    "·": r"\cdot",
    "×": r"\times",
    "−": "-",
    "∗": r"\ast ",
    "√3": r"\sqrt{3}",
    "λ": r"\lambda ",
    "μ": r"\mu ",
    "ε": r"\epsilon ",
    "η": r"\eta ",
    "θ": r"\theta ",
    "ν": r"\nu ",
    "σ": r"\sigma ",
    "τ": r"\tau ",
    "φ": r"\varphi ",
    "ω": r"\omega ",
    "$": r"\$",
}

TEX_HEAD = r"""\documentclass[11pt,a4paper]{article}
\usepackage[margin=2cm]{geometry}
\usepackage{amsmath}
\allowdisplaybreaks
\setcounter{MaxMatrixCols}{12}
\renewcommand{\arraystretch}{1.45}
\setlength{\parindent}{0pt}
\setlength{\parskip}{3pt}
"""

STYLE = """
body { font: 17px/1.5 Georgia, "DejaVu Serif", serif; color: #1b1b1b; background: #fff;
  max-width: 68rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.3rem; margin-top: 3rem; border-bottom: 1px solid #bbb; }
article { margin: 1.6rem 0; }
h3 { font: inherit; margin: 0; display: flex; gap: 1rem; align-items: baseline; }
h3 code { margin-left: auto; color: #666; font-size: .85rem; }
.unit, .note { color: #555; } .note { margin: 0; font-size: .95rem; }
.formula { display: flex; align-items: center; gap: 1rem; overflow-x: auto; padding: .5rem 0; }
.formula math { margin: 0 auto; } .number { white-space: nowrap; }
math { font-family: "Latin Modern Math", "STIX Two Math", "DejaVu Math TeX Gyre",
  "Cambria Math", math; font-size: 1.1em; }
mtd { padding-top: .25em; padding-bottom: .25em; }
mtd[columnalign] { padding-left: 0; padding-right: .15em; }
mtd[columnalign="right"] { text-align: right; text-align: -webkit-right; }
mtd[columnalign="left"] { text-align: left; text-align: -webkit-left; }
details { margin: .2rem 0; } summary { color: #555; cursor: pointer; font-size: .95rem; }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #181818; }
  .unit, .note, summary, h3 code { color: #aaa; } }
"""


@dataclass(frozen=True)
class Entry:
    """One formula with its words; ``section`` and ``title`` say where it stands."""

    name: str
    section: str
    title: str
    words: str
    note: str
    number: str
    unit: str
    latex: str
    components: str


def tex_document(title: str, entries: list[Entry]) -> str:
    """An article that pdflatex compiles: vector forms by section, then components."""
    lines = [
        f"% {NOTICE}",
        TEX_HEAD + rf"\title{{{title}}}",
        r"\author{}",
        r"\date{}",
        r"\begin{document}",
    ]
    lines += [r"\maketitle", r"\tableofcontents"]
    for (number, heading), group in groupby(
        entries, key=lambda entry: (entry.section, entry.title)
    ):
        lines.append(rf"\section*{{{number}. {heading}}}")
        lines.append(rf"\addcontentsline{{toc}}{{section}}{{{number}. {heading}}}")
        lines += [_tex_entry(entry, entry.latex) for entry in group]
    lines += [r"\clearpage", r"\section*{Components}"]
    lines.append(r"\addcontentsline{toc}{section}{Components}")
    lines += [_tex_entry(entry, entry.components) for entry in entries if entry.components]
    return "\n".join([*lines, r"\end{document}", ""])


def _tex_entry(entry: Entry, latex: str) -> str:
    unit = "" if entry.unit == "1" else rf" [{_tex_words(entry.unit)}]"
    words = _tex_words(_sentence(entry.words))
    name = entry.name.replace("_", r"\_")
    text = rf"{words}{unit} \hfill {{\small\texttt{{{name}}}}}"
    if entry.note and latex == entry.latex:
        text += rf"\\{{\small {_tex_words(entry.note)}}}"
    tag = rf" \tag*{{{_tex_words(entry.number)}}}" if entry.number.startswith("(") else ""
    return f"\n\\pagebreak[2]\n{text}\n\\begin{{equation*}}\n{latex}{tag}\n\\end{{equation*}}"


def _sentence(words: str) -> str:
    """Words as the beginning of a line, which a symbol leaves as it is."""
    return words if re.match(r"\w(_|\d)", words) else words[:1].upper() + words[1:]


def _tex_words(words: str) -> str:
    """Words with their letters and signs in mathematical type."""
    text = re.sub(r"(\d\))-(\(\d)", r"\1--\2", _spelled(words))
    text = INDEXED.sub(lambda m: f"{m[1] or m[3]}_{{{m[2] or m[4]}}}", text)
    text = IN_MATH.sub(lambda match: f"${_commands(match[0])}$", text)
    return re.sub(r"(?<!\\)\$\$", " ", text)


def _commands(letters: str) -> str:
    letters = POWER.sub(lambda match: f"{{}}^{{{match[0].translate(DIGITS)}}}", letters)
    for letter, command in IN_TEX.items():
        letters = letters.replace(letter, command)
    return letters


def _spelled(words: str) -> str:
    for name, letter in SPELLED.items():
        words = re.sub(rf"\b{name}\b", letter, words)
    return words


def html_page(title: str, entries: list[Entry]) -> str:
    """One page with MathML, without scripts and without anything from elsewhere."""
    sections = groupby(entries, key=lambda entry: (entry.section, entry.title))
    lines = [f"<!-- {NOTICE} -->", "<!DOCTYPE html>", '<html lang="en">', "<head>"]
    lines += ['<meta charset="utf-8">', f"<title>{escape(title)}</title>"]
    lines += ['<meta name="viewport" content="width=device-width">']
    lines += [f"<style>{STYLE}</style>", "</head>", "<body>", f"<h1>{escape(title)}</h1>"]
    for (number, heading), group in sections:
        lines.append(f'<h2 id="section-{number}">{number}. {escape(heading)}</h2>')
        lines += [_html_entry(entry) for entry in group]
    return "\n".join([*lines, "</body>", "</html>", ""])


def _html_entry(entry: Entry) -> str:
    unit = "" if entry.unit == "1" else f' <span class="unit">[{escape(entry.unit)}]</span>'
    heading = f"<span>{_html_words(_sentence(entry.words))}{unit}</span>"
    number = entry.number if entry.number.startswith("(") else ""
    lines = [f'<article id="{entry.name}">', f"<h3>{heading} <code>{entry.name}</code></h3>"]
    if entry.note:
        lines.append(f'<p class="note">{_html_words(entry.note)}</p>')
    lines.append(_html_formula(entry.latex, _html_words(number)))
    if entry.components:
        formula = _html_formula(entry.components, "")
        lines.append(f"<details><summary>components</summary>{formula}</details>")
    return "\n".join([*lines, "</article>"])


def _html_formula(latex: str, number: str) -> str:
    tag = f'<span class="number">{number}</span>' if number else ""
    return f'<div class="formula">{mathml(latex)}{tag}</div>'


def _html_words(words: str) -> str:
    words = re.sub(r"(\d\))-(\(\d)", "\\1–\\2", escape(_spelled(words), quote=False))
    return INDEXED.sub(lambda m: f"<i>{m[1] or m[3]}<sub>{m[2] or m[4]}</sub></i>", words)


def mathml(latex: str) -> str:
    """MathML that browsers show as LaTeX does.

    They know no bold variant of Greek letters and digits, so the letters themselves are
    the bold ones; and latex2mathml reads no digit in the name of an operator.
    """
    words = re.sub(r"\\(operatorname|mathrm)\{(\w+)\}", r"\\text{\2}", latex)
    words = re.sub(r"(?<=\}) (?=\\(?:cos|sin) )", r" \\, ", words)
    words = re.sub(r"(\\(?:cos|sin)) ", r"\1 \\, ", words)
    text = convert(words, display="block")
    text = re.sub(r'<mi mathvariant="bold-italic">&#x0*3([0-9A-F]{2});</mi>', _bold_greek, text)
    return text.replace('<mn mathvariant="bold">0</mn>', "<mn>&#x1D7CE;</mn>")


def _bold_greek(match: re.Match[str]) -> str:
    code = 0x1D736 + int(match[1], 16) - 0xB1
    return f"<mi>&#x{code:X};</mi>"
