"""The variables of all programs, with what they hold at first."""

from vrts.base.pose import Pose
from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.arrays import largest_subscripts
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import constant, parts
from vrts.dispatch.saying.signals import FIRST_INTERNAL, read_outputs
from vrts.dispatch.saying.timers import timers
from vrts.dispatch.urscript.values import (
    NOTHING,
    joints_text,
    name_of,
    number,
    pose_text,
)
from vrts.ir.expressions import Global
from vrts.ir.module import Module
from vrts.ir.values import Type, Value

EMPTY = {Type.REAL: "0.0", Type.POSE: NOTHING, Type.JOINTS: "[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]"}
EMPTY[Type.STRING] = '""'
LISTS = (Type.REAL, Type.POSE)  # a list of lists is a matrix in URScript


def variables(module: Module) -> dict[str, str]:
    """Return every variable of a module with what it holds at first.

    Raises:
        CannotSay: Two names are spelt alike.
    """
    held: dict[str, str] = {}
    lists: dict[str, list[str]] = {}
    spelt: dict[str, str] = {}
    for name, (kind, largest) in largest_subscripts(module).items():
        if kind not in EMPTY or (largest is not None and kind not in LISTS):
            continue
        written = name_of(Global(name, kind))
        if spelt.setdefault(written, name) != name:
            raise CannotSay(f"`{spelt[written]}` and `{name}` are one name", "rename one")
        held[written] = EMPTY[kind]
        if largest is not None:
            lists[written] = [EMPTY[kind]] * (largest + 1)
    for datum in module.data:
        found = _text(datum.value)
        if found is None:
            continue
        kind, text = found
        name = name_of(Global(datum.name, kind))
        if datum.subscripts and name in lists:
            lists[name][datum.subscripts[0]] = text
        elif name in held and not datum.subscripts:
            held[name] = text
    held |= {name: f"[{', '.join(items)}]" for name, items in lists.items()}
    arguments = Arguments(module)
    for program in module.programs.values():
        for name, formal in arguments.back(program):
            if formal.type not in EMPTY:
                raise CannotSay(f"`{formal.name}` comes back and may be of any kind")
            held[name] = EMPTY[formal.type]
        for part in parts(program.instructions):
            signal = abs(round(constant(part) or 0.0))
            if FIRST_INTERNAL <= signal < FIRST_INTERNAL + 1000:
                held[f"signal_{signal}"] = "False"
    held |= {f"out_{signal}": "False" for signal in sorted(read_outputs(module))}
    held |= {f"timer_{number}": "0.0" for number in timers(module)}
    return held


def _text(value: Value) -> tuple[Type, str] | None:
    if isinstance(value, float):
        return Type.REAL, number(value)
    if isinstance(value, Pose):
        return Type.POSE, pose_text(value)
    return (Type.JOINTS, joints_text(value)) if isinstance(value, tuple) else None
