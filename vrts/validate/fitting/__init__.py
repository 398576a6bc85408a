"""Speeds, acceleration and corners of a real robot, found in its logs: a door to scipy.

In: a run and a log of the same program. Out: the numbers with which both agree best.
Every motion keeps its path; only its time along it is fitted.
"""

from vrts.validate.fitting.robot import fit_robot

__all__ = ["fit_robot"]
