"""From the paper's pose to a checked motion, in 30 lines: python examples/tutorial.py"""

import numpy as np

import kleinform
from kleinform.motion import rest_to_rest
from kleinform.verification.by_pinocchio import follow
from kleinform.verification.mechanism import assembled

robot = kleinform.UncoupledManipulator(radius=1.0)
roll, pitch, yaw = np.radians([10, 3, 6])
rotation = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
start = robot.inverse_displacement([0.25, 0.2, 1.0], rotation)
print("joints of the paper's pose", start.round(6))

roll, pitch, yaw = np.radians([12, 5, 10])
goal = kleinform.rotation_from_rpy(roll=roll, pitch=pitch, yaw=yaw)
end = robot.inverse_displacement([0.2, 0.1, 1.5], goal)
motion = rest_to_rest(start, end, duration=5.0)  # Example 2, seconds
platform = robot.forward_motion(motion.sampled(501), rotation)
print("C arrives at", platform.positions[-1].round(12), "m")
print("fastest turn", np.linalg.norm(platform.twists[:, :3], axis=1).max().round(6), "rad/s")
limits = kleinform.Limits({"q3": (0.5, 1.2)})
watch = robot.watch(motion, 501, start_rotation=rotation, limits=limits)
print("met first:", watch.first.name, "at", round(watch.first.time, 8), "s")

checked = follow(assembled(platform.positions[0], rotation), motion.sampled(501)).platform
for mine, theirs in zip(platform[1:], checked[1:], strict=True):
    assert np.abs(mine - theirs).max() < 1e-10
print("Pinocchio agrees in pose, twist and acceleration to 1e-10")
