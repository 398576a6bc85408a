"""Commands on variables: HERE, POINT, LISTL, LISTR, LISTS, DELETEL and its like.

See [manual language/monitor#values].
"""

from collections.abc import Iterable

from vrts.base.pose import IDENTITY, Pose
from vrts.ir.commands import Command, DeleteVariables, SetVariable
from vrts.ir.values import Joints, Type, Value, type_of_value
from vrts.lang.syntax.expressions import Element, FormatItem, Infix, Name
from vrts.lang.typed.commands import CommandLine, FileName
from vrts.monitor import words
from vrts.monitor.commands.change import show_and_ask
from vrts.monitor.desk import (
    Desk,
    Operand,
    Refused,
    Situation,
    Turn,
    cell,
    evaluated,
    place,
    written,
)
from vrts.monitor.listings import locations_text, name_order, values_text

_ZEROS: Joints = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
_KINDS = {"R": Type.REAL, "S": Type.STRING}


# --- giving values --------------------------------------------------------------------------------


def here(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """HERE location: where the arm is now; of a compound the last element gets the value."""
    operand = _only(line)
    name, indices, frame = target(line, operand, desk, now)
    return show_and_ask(name, indices, present(name, frame, now), desk.dialect.angles)


def target(
    line: CommandLine, operand: Operand, desk: Desk, now: Situation
) -> tuple[str, tuple[int, ...], Pose]:
    """Return the location that an operand names, and the frame that it is given in."""
    compound = isinstance(operand, Infix) and operand.operator == ":"
    if isinstance(operand, Infix) and compound:
        frame = evaluated(written(line, operand.left), Type.POSE, desk, now)
        assert isinstance(frame, Pose)
        last = operand.right
    else:
        frame, last = IDENTITY, operand
    name, indices = place(line, last, desk, now)
    if name[0] == "$" or (name[0] == "#" and compound):
        raise Refused(words.starred(words.MIXING, f"`{name}` is no transformation"))
    fits(name, Type.JOINTS if name[0] == "#" else Type.POSE, now)
    return name, indices, frame


def present(name: str, frame: Pose, now: Situation) -> Pose | Joints:
    """Return where the arm is, as a location of that name holds it."""
    if name[0] == "#":
        return now.state.configuration
    return frame.inverse() @ here_pose(now)


def here_pose(now: Situation) -> Pose:
    """Return the pose of the tool as programs see it, with BASE."""
    return now.state.base @ now.state.X_WT


def point(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """POINT location [= value]: a value to begin with, then the dialogue."""
    operand = _only(line)
    values = line.values
    name, indices, frame = target(line, operand, desk, now)
    kind = Type.JOINTS if name[0] == "#" else Type.POSE
    if values is not None:
        if len(values) != 1 or values[0] is None or isinstance(values[0], FileName):
            raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
        value = evaluated(written(line, values[0]), kind, desk, now)
        if isinstance(value, Pose):
            value = frame.inverse() @ value
    else:
        value = now.state.variables.get(cell(name, indices))
        if value is None:
            value = _ZEROS if name[0] == "#" else IDENTITY
    assert isinstance(value, tuple)  # a pose or joints, as the name says
    return show_and_ask(name, indices, value, desk.dialect.angles)


def fits(name: str, kind: Type, now: Situation) -> None:
    """Refuse a value of another kind than a variable has."""
    for known, value in now.state.variables.items():
        if known.partition("[")[0] == name and type_of_value(value) is not kind:
            is_ = "a number" if isinstance(value, float) else "a location"
            raise Refused(words.starred(words.MIXING, f"`{name}` is {is_}; delete it first"))


# --- listing --------------------------------------------------------------------------------------


def list_locations(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """LISTL: all locations, or those named, or the value of a compound."""
    found: dict[str, Pose | Joints] = {}
    if not line.operands:
        found = {n: v for n, v in now.state.variables.items() if _is_location(v)}  # type: ignore[misc]
    for operand in line.operands:
        for name, value in _listed(line, operand, desk, now, Type.POSE):
            if not isinstance(value, tuple):
                raise Refused(words.starred(words.MIXING, f"`{name}` is no location"))
            found[name] = value
    return Turn(locations_text(found, desk.dialect.angles))


def list_reals(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """LISTR: all numbers, or the value of expressions."""
    return Turn(values_text(_all_listed(line, desk, now, Type.REAL, float)))


def list_strings(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """LISTS: all strings, or those named."""
    return Turn(values_text(_all_listed(line, desk, now, Type.STRING, str)))


def _all_listed(
    line: CommandLine, desk: Desk, now: Situation, kind: Type, form: type[float] | type[str]
) -> list[tuple[str, float | str]]:
    variables = now.state.variables
    if not line.operands:
        names = sorted((n for n, v in variables.items() if isinstance(v, form)), key=name_order)
        return [(name, variables[name]) for name in names]  # type: ignore[misc]
    rows: list[tuple[str, float | str]] = []
    for operand in line.operands:
        for name, value in _listed(line, operand, desk, now, kind):
            if not isinstance(value, form):
                what = "number" if form is float else "string"
                raise Refused(words.starred(words.MIXING, f"`{name}` is no {what}"))
            rows.append((name, value))
    return rows


def _listed(
    line: CommandLine, operand: Operand, desk: Desk, now: Situation, kind: Type
) -> Iterable[tuple[str, Value]]:
    """Return names and values of an operand: a variable, all elements of an array, a result."""
    if operand is None or isinstance(operand, FileName | FormatItem):
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    if isinstance(operand, Name | Element):
        name, indices = place(line, operand, desk, now)
        known = _known(name, indices, now)
        if known:
            return [(each, now.state.variables[each]) for each in known]
        if isinstance(operand, Element) or name[0] in "$#":
            raise Refused(words.starred(words.UNDEFINED_VALUE, f"`{name}` has no value"))
    text = written(line, operand)
    kind = Type.JOINTS if kind is Type.POSE and text[0] == "#" else kind
    return [(text, evaluated(text, kind, desk, now))]


def _known(name: str, indices: tuple[int, ...], now: Situation) -> list[str]:
    """Return the variables of a name, in order: itself, or the elements of an array."""
    variables = now.state.variables
    if indices or name in variables:
        exact = cell(name, indices)
        return [exact] if exact in variables else []
    return sorted((n for n in variables if n.partition("[")[0] == name), key=name_order)


def _is_location(value: Value) -> bool:
    return isinstance(value, tuple)


# --- deleting -------------------------------------------------------------------------------------


def delete(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """DELETEL, DELETER, DELETES, DPOINT: an array without an index stands for its elements."""
    kind = _KINDS.get(line.word.text.removeprefix("DELETE"))
    commands: list[Command] = []
    if not line.operands:
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    for operand in line.operands:
        name, indices = place(line, operand, desk, now)
        known = _known(name, indices, now)
        if not known:
            raise Refused(words.starred(words.UNDEFINED, f"`{cell(name, indices)}` has no value"))
        found = type_of_value(now.state.variables[known[0]])
        if found is not kind and not (kind is None and found in (Type.POSE, Type.JOINTS)):
            raise Refused(words.starred(words.MIXING, f"`{name}` is of another kind"))
        gone = SetVariable(name, indices, None) if indices else DeleteVariables((name,))
        commands.append(gone)
    return Turn(commands=tuple(commands))


def _only(line: CommandLine) -> Operand:
    match line.operands:
        case () | (None,):
            raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
        case (operand,):
            return operand
        case _:
            raise Refused(words.starred(words.UNEXPECTED_TEXT, f"write `{line.word.usage}`"))
