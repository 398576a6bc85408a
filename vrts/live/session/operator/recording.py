"""The RECORD button: a location where the arm is now."""

import re

from vrts.base.source import SourceFile, Span
from vrts.ir.commands import SetVariable
from vrts.ir.module import Datum, Module
from vrts.ir.values import Type
from vrts.lang.dialect import VAL2
from vrts.lang.names import key
from vrts.lang.writing.store import store_text
from vrts.monitor.commands.values import fits, here_pose
from vrts.monitor.desk import Refused, Situation, cell, is_name
from vrts.monitor.listings import location_row

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


def stored_row(command: SetVariable) -> str:
    """Return the line of `.LOCATIONS` that STORE writes for a location."""
    assert command.value is not None
    span = Span(SourceFile("recorded", ""), 0, 0)
    datum = Datum(command.name, command.subscripts, command.value, span)
    return store_text(span.source, Module({}, (datum,)), VAL2).splitlines()[1]
