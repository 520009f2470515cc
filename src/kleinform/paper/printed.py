"""What the paper prints, digit by digit.

Strings keep the number of digits. Signs and points that the scan of Table 1 lost are put
back; `kleinform.paper.report` shows that each row then satisfies the closure equations.
"""

from __future__ import annotations

#: The pose of Section VI, first part.
RADIUS = 1.0
POSITION = (0.25, 0.2, 1.0)
ROLL_PITCH_YAW_DEGREES = (10.0, 3.0, 6.0)

#: Section VI: joint values of the pose (angles in degrees) and distances e_i.
JOINTS = {
    "q1": "1",
    "q2": "1.191",
    "q3": "0.869",
    "q4 [deg]": "38.657",
    "q5 [deg]": "72.247",
    "q6": "1.05",
}
EXTENSIONS = {"e1": "0.755", "e2": "0.972", "e3": "1.313"}

#: Table 1: coordinates of B_1, B_2, B_3 for each of the four real solutions.
TABLE_1 = (
    (
        ("1", ".092707", ".995825"),
        ("-.110200", "1.091076", "1.103129"),
        ("-.564114", "-.829009", ".866558"),
    ),
    (
        ("1", ".278828", ".960477"),
        ("-.311829", ".974665", "1.171441"),
        ("-.295581", "-.984046", ".837071"),
    ),
    (
        ("1", "-.921997", "-.387535"),
        ("-1.092186", ".524126", ".975656"),
        ("-1.033884", "-.557787", "-.613482"),
    ),
    (
        ("1", "-.541257", ".841013"),
        ("-1.494324", ".291952", "-.318190"),
        (".051153", "-1.184233", "-.592771"),
    ),
)

#: Example 2: the pose at the end, and its time in seconds.
END_POSITION = (0.2, 0.1, 1.5)
END_ROLL_PITCH_YAW_DEGREES = (12.0, 5.0, 10.0)
END_TIME = 5.0

#: Table 2: mu_0, mu_3, mu_4, mu_5 of q1 ... q6.
TABLE_2 = (
    ("1.00010", "0.035912", "-0.010774", "0.000862"),
    ("1.19140", "0.043552", "-0.013066", "0.001045"),
    ("0.86971", "0.040023", "-0.012007", "0.000961"),
    ("0.67470", "-0.016888", "0.005066", "-0.000405"),
    ("1.26090", "0.012888", "-0.003866", "0.000309"),
    ("1.05000", "0.037320", "-0.011196", "0.000896"),
)
