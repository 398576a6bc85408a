"""Speeds, acceleration and corners of a real robot, found in its logs: the only door to scipy.

Every motion goes along its path as `profile` has it, with a duration of its own; how long
acceleration and corners take, and how far the servos lag, is the same for all. `solve` finds these
by least squares; `speeds` tells from the durations how fast each joint is.
"""

from vrts.validate.fitting.robot import fit_robot

__all__ = ["fit_robot"]
