"""The paper's letter for every name of this mechanism, in one table.

Vectors are printed bold and their components italic, both with the letter given here. The
order of the table is the order in which factors and terms are written.
"""

from __future__ import annotations

from derivations.algebra.vectors import AXES, SCREW_AXES
from derivations.codegen.printers.letters import Letter, Notation

__all__ = ["LETTERS", "NOTATION"]

#: The columns of the minors of two rows, in the order of a column of six.
PAIRS = ("12", "13", "14", "23", "24", "34")

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
    # half angles
    "half_step": "h",
    "side": r"\epsilon_{i}",  # 1 for limb 2, −1 for limb 3
    "x": "x",
    "y": "y",
    "t": "t",
    "s": "s",
    # joint rates come before what they multiply
    "dq#": Letter("q", accent=r"\dot"),
    "dq": Letter("q", accent=r"\dot"),
    **{
        f"dq_{suffix}": Letter("q", sub=str(joint), accent=r"\dot")
        for joint, suffix in enumerate(SCREW_AXES, start=1)
    },
    "ddq#": Letter("q", accent=r"\ddot"),
    "ddq": Letter("q", accent=r"\ddot"),
    **{
        f"ddq_{suffix}": Letter("q", sub=str(joint), accent=r"\ddot")
        for joint, suffix in enumerate(SCREW_AXES, start=1)
    },
    "bias#": Letter("q", sup="0", accent=r"\ddot"),  # the part that the rates alone make
    # rates of all joints, with the paper's letters
    **{f"rate#{joint}": rf"{{}}_{{{joint - 1}}}\omega_{{{joint}}}^{{#}}" for joint in range(1, 7)},
    # forces come before what they multiply
    "force#": "f",
    "load#": r"\varphi",  # force along S_i
    "share#": Letter(r"\varphi", sup="0"),
    # displacement
    "p#": "p",  # n_i · u_i
    "h#": "h",  # a − c · u_i
    "de#": Letter("e", accent=r"\dot"),
    "e#": "e",
    "c": "c",
    "b#": "b",
    "db#": Letter("b", accent=r"\dot"),
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
    "ht#": Letter("h", sup="t"),  # g^t_i = h^t_i · n_i
    "hz#": Letter("h", sup="z"),
    "hp#": Letter("h", sup="p"),  # p_i q_i = h^p_i · n_i
    "M#": "M",  # F_i = n_i · M_i n_i
    "F#": "F",
    "dF#": Letter("F", before=r"\nabla ", upright=True),
    **{f"dF#_{axis}": rf"\partial F_{{#}}/\partial n_{{#{axis}}}" for axis in AXES},
    "F": "F",
    "dF": Letter("J", sub="F"),
    # one unknown: the angle of leg 1
    "cos_theta": r"\cos\theta",
    "sin_theta": r"\sin\theta",
    "arm": "r",
    "reference": "z",
    "f": "f",
    "g": "g",
    **{f"h{form}x#": Letter(r"\xi", sup=form) for form in "tzp"},  # forms at x², xy, y²
    "K#": "K",
    "brackets": "W",
    "Z": "Z",
    "upper": "U",
    "lower": "L",
    **{f"upper_{axis}": f"U_{{{pair}}}" for axis, pair in zip(SCREW_AXES, PAIRS, strict=True)},
    **{f"lower_{axis}": f"L_{{{pair}}}" for axis, pair in zip(SCREW_AXES, PAIRS, strict=True)},
    "eliminant": r"\det \mathbf{Z}",
    "bound": "H",
    "adj#": r"\alpha",
    # two unknowns: the angles of legs 1 and 2
    "cos_start#": r"\cos\theta_{#}",
    "sin_start#": r"\sin\theta_{#}",
    "center#": Letter("r", sup="A"),  # a_i − c
    "near#": Letter("w", sup="0"),
    "up#": Letter("w", sup=r"\perp"),
    "arm#": "r",  # b_i − c
    "va#": Letter("r", sup="1"),  # (1 + t²)(b_i − c) at 1, t, t²
    "vb#": Letter("r", sup="t"),
    "vc#": Letter("r", sup="tt"),
    "V#": "V",
    **{f"h{form}v#": Letter(r"\zeta", sup=form) for form in "tzp"},  # V_i h_3
    "N#": "N",
    "C#": "C",
    "N12": Letter("N", sub="12"),
    "C12": Letter("C", sub="12"),
    "angle": "A",
    "cone": "B",
    # Newton's method
    "G#": "G",
    "G": "G",
    "volume": r"\det \mathbf{G}",
    "turn": r"\psi",
    "half_turn": r"\chi",
    "cayley": r"\Gamma",
    "next#": Letter("n", sup="+"),
    "across#": Letter("G", sup=r"\times"),
    "slide#": r"\upsilon",
    "bend#": r"\beta",
    "dvolume": Letter(r"\det \mathbf{G}", before=r"\nabla ", upright=True),
    "dlambda#": r"\lambda",  # ∂λ/∂q_4, ∂λ/∂q_5
    "cF#": Letter("F", before=r"\nabla_{c} ", upright=True),
    **{f"cF#_{axis}": rf"\partial F_{{#}}/\partial c_{{{axis}}}" for axis in AXES},
    "qF": Letter("J", sub=r"\ln q"),
    "span": r"|e_{1}|",
    "tangent": Letter("b", sub="1", sup=r"\prime"),
    "by_angle": Letter(r"\omega", sup=r"\theta"),
    "side_part": Letter("n", sup=r"\perp"),
    "guess": Letter("n", sub="2", accent=r"\tilde"),
    "next_guess": Letter("n", sub="2", sup="+", accent=r"\tilde"),
    "Ft#": Letter("F", sub=r"\theta"),
    "Fp#": Letter("F", sub=r"\varphi"),
    "det_leg": r"\det \mathbf{J}_{\theta\varphi}",
    "dtheta": r"\delta\theta",
    "dphi": r"\delta\varphi",
    "next_arm": Letter("v", sub="1", sup="+"),
    "next_span": r"|e_{1}^{+}|",
    "next_n1": Letter("n", sub="1", sup="+"),
    "next_side": Letter("n", sup=r"\perp+"),
    "next_n2": Letter("n", sub="2", sup="+"),
    "next_leg": Letter("w", sub="1", sup="+"),
    "next_leg_1": r"\cos\theta^{+}",
    "next_leg_2": r"\sin\theta^{+}",
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
    "ddrive#": Letter(r"\psi", sup="A"),  # (τ_i ν − σ_i m_i) · dω/dt
    "domega": Letter(r"\omega", accent=r"\dot"),
    "dv": Letter("v", sub="C", accent=r"\dot"),
    "dV": Letter("V", accent=r"\dot"),
    "spin": Letter(r"\omega", sup="P"),  # what the passive joints of the central limb make of ω
    "foot#": "Y",  # the line through A_i along n_i × w_i
    "guide#": "U",  # the line through B_i along u_i
    "reduced": Letter("A", sub="R"),
    "lie#": "L",
    # statics
    "force": Letter("f", sub="C"),
    "moment": Letter("m", sub="C"),
    "wrench": "W",
    "grad_q#": Letter("q", before=r"\nabla ", upright=True),
    "central_force": Letter("f", sub="C", sup=r"\prime"),
    "forces": "f",
    # singularity
    "tau_part#": Letter(r"\tau", sup="c"),  # coefficients in c = (x, y, z)
    "sigma_part#": Letter(r"\sigma", sup="c"),
    "tau23": Letter(r"\tau", sub="23", sup="c"),
    "sigma23": Letter(r"\sigma", sub="23", sup="c"),
    "cubic": Letter(r"\Theta", sup="c"),
    "tau_turn#": Letter(r"\tau", sup=r"\psi"),  # by a turn of the platform
    "sigma_turn#": Letter(r"\sigma", sup=r"\psi"),
    "tilt_turn": Letter(r"\Theta", sup=r"\psi"),
    "tau_shift#": Letter(r"\tau", sub="c"),  # by the position
    "sigma_shift#": Letter(r"\sigma", sub="c"),
    "tilt_shift": Letter(r"\Theta", sub="c"),
    "lever#": Letter("c", sup=r"\times"),  # u_i × c
    "sigma_pair#": Letter(r"\sigma", sup=r"\prime\prime"),
    "tilt_part#": r"\Theta",
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
