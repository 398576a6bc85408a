"""A robot under a controller model."""

from dataclasses import replace

from vrts.controllers.model import ControllerModel
from vrts.robots.model import Robot


def timed(robot: Robot, model: ControllerModel) -> Robot:
    """Return a robot with the tick of a controller, and with what was fitted of its pace.

    What a model leaves to the robot's data stays as it is.
    """
    arm, pace, whole = robot.arm, model.pace, model.corners.whole_s
    acceleration = arm.acceleration_time if pace.acceleration_s is None else pace.acceleration_s
    blend = arm.blend_time if whole is None else whole
    if (arm.tick, arm.acceleration_time, arm.blend_time) == (pace.tick_s, acceleration, blend):
        return robot
    arm = replace(arm, tick=pace.tick_s, acceleration_time=acceleration, blend_time=blend)
    return replace(robot, arm=arm)
