"""The RECORD button: a location where the arm is now."""

import re

from vrts.ir.commands import SetVariable
from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.monitor.desk import Refused, Situation, cell, is_name
from vrts.monitor.listings import location_row
from vrts.monitor.values import fits, here_pose

_TITLE = re.compile(r"(?P<name>#?[A-Za-z][\w.]*)(?:\[(?P<index>\d{1,5})\])?", re.ASCII)


class Unrecordable(Exception):  # noqa: N818 -- names the situation
    """The name cannot be given to a location."""


def recorded(title: str, now: Situation) -> tuple[SetVariable, str]:
    """Return what gives a location the present value, and what the terminal shows of it.

    Raises:
        Unrecordable: It is no name of a location.
    """
    match = _TITLE.fullmatch(title)
    if match is None or not is_name(match["name"]):
        raise Unrecordable(f"`{title}` is no name of a location")
    name = key(match["name"])
    indices = (int(match["index"]),) if match["index"] else ()
    joints = name[0] == "#"
    try:
        fits(name, Type.JOINTS if joints else Type.POSE, now)
    except Refused as refused:
        raise Unrecordable(f"`{name}` is in use for something else") from refused
    value = now.state.configuration if joints else here_pose(now)
    return SetVariable(name, indices, value), f"{cell(name, indices):<12}{location_row(value)}\n"
