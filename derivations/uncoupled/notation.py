"""The paper's letter for every name of this mechanism, in one table.

Vectors are printed bold and their components italic, both with the letter given here. The
order of the table is the order in which factors and terms are written.
"""

from __future__ import annotations

from derivations.algebra.vectors import AXES, SCREW_AXES
from derivations.codegen.printers.letters import Letter, Notation

__all__ = ["LETTERS", "NOTATION"]

#: ``#`` is the index of a limb. Where the paper has no letter, the comment says what it is.
LETTERS: dict[str, Letter | str] = {
    # base and platform
    "a": "a",
    "i": "i",
    "j": "j",
    "k": "k",
    "a#": "a",
    "u#": "u",
    "t#": "t",  # horizontal normal of u_i
    "n#": "n",
    "m#": "m",  # platform direction normal to n_i
    "nu": r"\nu",  # normal of the platform
    "R": "R",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "gamma": r"\gamma",
    "gap": r"\varepsilon",  # n_1 × m_1 − ν
    "defect": Letter(r"\varepsilon", sub="R"),
    # joint rates come before what they multiply
    "dq#": Letter("q", accent=r"\dot"),
    "dq": Letter("q", accent=r"\dot"),
    **{
        f"dq_{suffix}": Letter("q", sub=str(joint), accent=r"\dot")
        for joint, suffix in enumerate(SCREW_AXES, start=1)
    },
    # displacement
    "p#": "p",  # n_i · u_i
    "h#": "h",  # a − c · u_i
    "e#": "e",
    "c": "c",
    "b#": "b",
    "gt#": Letter("g", sup="t"),  # p_i (b_i − a_i), its part along t_i
    "gz#": Letter("g", sup="z"),  # and along k
    "ng#": Letter("g", sup="n"),  # and along n_i
    "l#": r"\ell",  # and its length
    "q#": "q",
    "w#": "w",
    "delta#": r"\delta",  # d_i = δ_i u_i
    "d#": "d",
    "lambda": r"\lambda",
    "r": "r",  # distance of C from the Z axis
    # closure
    "F#": "F",
    "dF#": Letter("F", before=r"\nabla ", upright=True),
    **{f"dF#_{axis}": rf"\partial F_{{#}}/\partial n_{{#{axis}}}" for axis in AXES},
    "F": "F",
    "dF": Letter("J", sub="F"),
    # screws and lines
    "heading_1": Letter(r"\eta", sub="x"),
    "heading_2": Letter(r"\eta", sub="y"),
    "heading": r"\eta",  # a horizontal vector at the azimuth q_4
    "axis": r"\mu",  # axis of the second joint of the central limb
    "nw#": "y",  # n_i × w_i
    **{
        f"screw#{joint}": Letter(
            r"\$", before=f"{{}}^{{{joint - 1}}}", sup=str(joint), upright=True
        )
        for joint in range(1, 7)
    },
    "screw": Letter(r"\$", upright=True),  # any screw
    "tau#": r"\tau",  # p_i² (d_i − b_i) = τ_i m_i + σ_i ν
    "sigma#": r"\sigma",
    "rho#": r"\rho",
    "s#": "s",
    "so#": Letter("s", sub="O"),
    "S#": "S",
    "limb#": r"\kappa",  # {S_i; ¹$_i²}
    "J_v": Letter("J", sub="v"),
    "J_q": Letter("J", sub="q"),
    "Delta": Letter(r"\Delta", upright=True),
    # velocity
    "drive#": r"\psi",  # (τ_i ν − σ_i m_i) · ω
    "omega": r"\omega",
    "v": Letter("v", sub="C"),
    "V": "V",
    # singularity
    "tilt": r"\Theta",
    "reach": "L",
    "central": Letter("f", sub=r"\mathrm{central}"),
    "wrist": Letter("f", sub=r"\mathrm{wrist}"),
    "orientation": Letter("f", sub=r"\mathrm{orientation}"),
    "condition25": Letter("f", sub="(25)"),
    "condition26": Letter("f", sub="(26)"),
    "det_J_q": r"\det \mathbf{J}_{q}",
    "det_J_v": r"\det \mathbf{J}_{v}",
    "det_moments": r"\det\left[\mathbf{s}_{O,1}\;\mathbf{s}_{O,2}\;\mathbf{s}_{O,3}\right]",
    "e_scale#": r"\operatorname{scale}(e_{#})",
    "limb_scale#": r"\operatorname{scale}(\kappa_{#})",
    "central_scale": r"\operatorname{scale}(f_{\mathrm{central}})",
    "wrist_scale": r"\operatorname{scale}(f_{\mathrm{wrist}})",
    "orientation_scale": r"\operatorname{scale}(f_{\mathrm{orientation}})",
}

NOTATION = Notation(LETTERS)
