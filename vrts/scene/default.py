"""The robot alone: the scene of programs that name none."""

from types import MappingProxyType

from vrts.base.pose import IDENTITY, translation
from vrts.controllers.models import USUAL
from vrts.robots.catalog import robot
from vrts.robots.model import Robot
from vrts.robots.timed import timed
from vrts.scene.colors import NAMED, color
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.things.forms import floor


def robot_alone(name: str = "puma761") -> Scene:
    """Return a scene with a robot on the floor and nothing else; TOOL is NULL.

    Raises:
        KeyError: No robot has this name.
    """
    chosen = timed(robot(name), USUAL)
    return Scene(
        name=f"{name} alone",
        title=f"{chosen.arm.title} alone",
        robot=chosen,
        X_FT=IDENTITY,
        bodies=(floor_body(chosen),),
        locations=MappingProxyType({}),
        digest="",
    )


def floor_body(chosen: Robot) -> Body:
    """Return the floor on which a robot stands."""
    form = floor()
    return Body(
        name="floor",
        title="the floor",
        kind="floor",
        mobility=Mobility.FIXED,
        pieces=form.pieces,
        X_WO=translation(0.0, 0.0, -chosen.arm.shoulder_height),
        color=color(NAMED["concrete"]) or (0.5, 0.5, 0.5),
        centre_of_mass=form.centre_of_mass,
    )
