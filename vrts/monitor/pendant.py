"""The teach pendant: keys in, motions and recorded locations out. Reads no terminal.

Each press moves the arm by one step: a joint, along or about an axis of the world, or of the tool.
Moves are instructions that the controller carries out, so limits are its own.
"""

import re
from enum import Enum
from typing import NamedTuple

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile, Span
from vrts.base.units import DEG, deg, mm
from vrts.engine.run import State
from vrts.ir.commands import SetVariable
from vrts.ir.module import Datum, Module
from vrts.ir.values import Joints
from vrts.lang.dialect import VAL2
from vrts.lang.names import key
from vrts.lang.writing.store import store_text
from vrts.monitor.commands.teaching import successor
from vrts.monitor.desk import is_name
from vrts.robots.model import Arm


class Frame(Enum):
    """What the axis keys move."""

    JOINT = "joint"
    WORLD = "world"
    TOOL = "tool"


_TITLE = re.compile(r"(?P<name>#?[A-Za-z][\w.]*)(?:\[(?P<index>\d{1,5})\])?", re.ASCII)
_LONGEST_NAME = 24  # characters, with sigil and index
_NEAR = 1.0 * DEG  # of a limit, from which on it is pointed out
_SHOWN = 8  # recorded locations

STEPS_MM = (0.1, 1.0, 5.0, 10.0, 50.0, 100.0)
STEPS_DEG = (0.1, 1.0, 2.0, 5.0, 15.0, 45.0)
_AXES = {  # keys: an axis, and which way
    **{key_: (axis, 1) for axis, key_ in enumerate("qwerty")},
    **{key_: (axis, -1) for axis, key_ in enumerate("asdfgh")},
}
KEYS = """\
q w e r t y  joint 1 to 6, or X Y Z and turns about them, plus     a s d f g h  minus
1 joint   2 world   3 tool     - +  smaller, larger steps
o c  open, close the hand      SPACE  record     u  undo     j k  choose     RETURN  go there
x  write and quit              ESC  quit without writing
"""


class Recorded(NamedTuple):
    """A location that was recorded."""

    name: str
    indices: tuple[int, ...]
    value: Pose | Joints

    @property
    def title(self) -> str:
        """The name with its index."""
        return f"{self.name}[{','.join(map(str, self.indices))}]" if self.indices else self.name


class Pendant(NamedTuple):
    """The state of the pendant; `press` returns the next one."""

    frame: Frame = Frame.JOINT
    size: int = 3  # index of the steps
    recorded: tuple[Recorded, ...] = ()
    chosen: int = 0  # of the recorded ones
    following: str = "p1"  # the name offered for the next one
    naming: str | None = None  # what has been typed of a name; None: no name is asked for
    message: str = ""
    done: str = ""  # "write" or "quit" when the session is over


class Press(NamedTuple):
    """What a key leads to."""

    pendant: Pendant
    instruction: str = ""  # to be carried out by the controller
    value: SetVariable | None = None  # a location for the controller's memory


def press(pendant: Pendant, key_: str, state: State) -> Press:
    """Take a key: a character, or "enter", "escape", "backspace", "space"."""
    if pendant.naming is not None:
        return _name(pendant, key_, state)
    pendant = pendant._replace(message="")
    match key_:
        case "1" | "2" | "3":
            frame = (Frame.JOINT, Frame.WORLD, Frame.TOOL)[int(key_) - 1]
            return Press(pendant._replace(frame=frame))
        case "+" | "=":
            return Press(pendant._replace(size=min(pendant.size + 1, len(STEPS_MM) - 1)))
        case "-":
            return Press(pendant._replace(size=max(pendant.size - 1, 0)))
        case "o":
            return Press(pendant, "OPENI")
        case "c":
            return Press(pendant, "CLOSEI")
        case "space":
            return Press(pendant._replace(naming=""))
        case "u":
            return Press(_undone(pendant))
        case "j":
            return Press(pendant._replace(chosen=min(pendant.chosen + 1, _last(pendant))))
        case "k":
            return Press(pendant._replace(chosen=max(pendant.chosen - 1, 0)))
        case "enter":
            return _go(pendant)
        case "x":
            return Press(pendant._replace(done="write"))
        case "escape":
            return Press(pendant._replace(done="quit"))
        case _ if key_ in _AXES:
            return Press(pendant, motion(pendant, *_AXES[key_]))
        case _:
            return Press(pendant._replace(message=f"there is no key {key_!r}"))


def motion(pendant: Pendant, axis: int, way: int) -> str:
    """Return the instruction of an axis key; axes from 0."""
    length = f"{way * STEPS_MM[pendant.size]:g}"
    turn = f"{way * STEPS_DEG[pendant.size]:g}"
    match pendant.frame:
        case Frame.JOINT:
            return f"DRIVE {axis + 1},{turn},100"
        case Frame.WORLD if axis < 3:
            offsets = ["0", "0", "0"]
            offsets[axis] = length
            return f"MOVES SHIFT(HERE BY {','.join(offsets)})"
        case Frame.WORLD:
            function = ("RX", "RY", "RZ")[axis - 3]
            here = "TRANS(DX(HERE),DY(HERE),DZ(HERE),90,-90,0)"
            return f"MOVES {here}:{function}({turn}):INVERSE({here}):HERE"
        case Frame.TOOL if axis < 3:
            offsets = ["0", "0", "0"]
            offsets[axis] = length
            return f"MOVES HERE:TRANS({','.join(offsets)},90,-90,0)"
        case Frame.TOOL:
            function = ("RX", "RY", "RZ")[axis - 3]
            return f"MOVES HERE:{function}({turn})"


def points_text(pendant: Pendant) -> str:
    """Return the `.LOCATIONS` section of what was recorded, as STORE writes it."""
    span = Span(SourceFile("pendant", ""), 0, 0)
    data = tuple(Datum(r.name, r.indices, r.value, span) for r in pendant.recorded)
    return store_text(span.source, Module({}, data), VAL2)


def screen(pendant: Pendant, state: State, arm: Arm, said: str = "") -> str:
    """Return everything the pendant shows; `said` is what the controller said last."""
    x, y, z, o, a, t = components(state.base @ state.X_WT)
    unit = "degrees" if pendant.frame is Frame.JOINT else "mm, degrees about an axis"
    step = STEPS_DEG if pendant.frame is Frame.JOINT else STEPS_MM
    rows = [
        f"{pendant.frame.value:<8} step {step[pendant.size]:g} {unit}",
        "",
        "         X         Y         Z         O         A         T      hand",
        f"{x:10.2f}{y:10.2f}{z:10.2f}{o:10.3f}{a:10.3f}{t:10.3f}{mm(state.hand_opening):10.2f}",
        "",
        "joint      is      from        to",
        *_joint_rows(state, arm),
        "",
        *_recorded_rows(pendant),
    ]
    if pendant.naming is not None:
        rows.append(f"name of the location [{pendant.following}]: {pendant.naming}")
    rows += [row for row in (pendant.message, said.rstrip("\n")) if row]
    return "\n".join([*rows, "", KEYS])


def _joint_rows(state: State, arm: Arm) -> list[str]:
    rows: list[str] = []
    for n, q, lower, upper in zip(
        range(1, 7), state.configuration, arm.lower, arm.upper, strict=True
    ):
        near = "  at its limit" if min(q - lower, upper - q) < _NEAR else ""
        rows.append(f"{n:5d}{deg(q):10.3f}{deg(lower):10.1f}{deg(upper):10.1f}{near}")
    return rows


def _recorded_rows(pendant: Pendant) -> list[str]:
    first = max(min(pendant.chosen - _SHOWN // 2, len(pendant.recorded) - _SHOWN), 0)
    shown = pendant.recorded[first : first + _SHOWN]
    rows = [f"{len(pendant.recorded)} recorded"]
    for at, recorded in enumerate(shown, first):
        mark = ">" if at == pendant.chosen else " "
        rows.append(f"{mark} {recorded.title}")
    return rows


def _last(pendant: Pendant) -> int:
    return max(len(pendant.recorded) - 1, 0)


def _undone(pendant: Pendant) -> Pendant:
    if not pendant.recorded:
        return pendant._replace(message="nothing is recorded")
    gone = pendant.recorded[-1]
    kept = pendant._replace(recorded=pendant.recorded[:-1], following=gone.title)
    return kept._replace(chosen=min(pendant.chosen, _last(kept)), message=f"{gone.title} is gone")


def _go(pendant: Pendant) -> Press:
    if not pendant.recorded:
        return Press(pendant._replace(message="nothing is recorded"))
    recorded = pendant.recorded[pendant.chosen]
    return Press(pendant._replace(message=f"to {recorded.title}"), f"MOVE {recorded.title}")


def _name(pendant: Pendant, key_: str, state: State) -> Press:
    typed = pendant.naming or ""
    match key_:
        case "escape":
            return Press(pendant._replace(naming=None))
        case "backspace":
            return Press(pendant._replace(naming=typed[:-1]))
        case "enter":
            return _record(pendant, typed or pendant.following, state)
        case _ if len(key_) == 1 and len(typed) < _LONGEST_NAME:
            return Press(pendant._replace(naming=typed + key_))
        case _:
            return Press(pendant)


def _record(pendant: Pendant, title: str, state: State) -> Press:
    pendant = pendant._replace(naming=None)
    match = _TITLE.fullmatch(title)
    if match is None or not is_name(match["name"]):
        return Press(pendant._replace(message=f"{title} is no name of a location"))
    name = key(match["name"])
    value = state.configuration if name[0] == "#" else state.base @ state.X_WT
    new = Recorded(name, (int(match["index"]),) if match["index"] else (), value)
    if any(r.title == new.title for r in pendant.recorded):
        return Press(pendant._replace(message=f"{new.title} is recorded already: undo it first"))
    following = successor(new.name, new.indices)
    recorded = (*pendant.recorded, new)
    pendant = pendant._replace(
        recorded=recorded,
        chosen=len(recorded) - 1,
        following=pendant.following if following is None else Recorded(*following, value).title,
        message=f"{new.title} recorded",
    )
    return Press(pendant, value=SetVariable(new.name, new.indices, value))
