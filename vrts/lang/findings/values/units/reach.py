"""Locations that no arm of the family reaches: data and TRANS, as far as they are written."""

import math

from vrts.lang.findings.values.complaints import OPERAND_RANGE
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.syntax.expressions import Application, Item

FARTHEST = 1900.0  # [mm] from the shoulder; the largest arm reaches 1500 mm, its tool some more
_COORDINATES = 3
_HELP = "write millimetres from the shoulder, where the arm can go; is a decimal point missing?"


def check_trans_reach(types: NameUses, node: Item | None) -> None:
    """Warn of `TRANS(2000, 0, -100, 90, 90, 0)` that the arm goes to as it is."""
    if not isinstance(node, Application) or node.name.text.lower() != "trans":
        return
    given = [argument for argument in node.arguments[:_COORDINATES] if argument is not None]
    values = [evaluate(argument, nothing_known) for argument in given]
    if len(values) < _COORDINATES or any(low != high for low, high in values):
        return
    distance = math.hypot(*(low for low, _ in values))
    if distance > FARTHEST:
        warn_of_reach(types, "this TRANS", given[0].start, given[-1].end, distance)


def warn_of_reach(types: NameUses, what: str, start: int, end: int, distance: float) -> None:
    """Warn of a place that is too far; `distance` in mm from the shoulder."""
    types.problems.warning(
        OPERAND_RANGE,
        f"{what} lies out of reach",
        start,
        end,
        f"{distance:.0f} mm from the middle of the robot",
        notes=("the controller stops with *Location out of range* when it goes there",),
        help=(_HELP,),
    )
