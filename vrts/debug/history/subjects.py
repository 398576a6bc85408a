"""What a typed name stands for: a variable, a signal, a thing, the arm, the hand."""

import re
from collections.abc import Iterator

from vrts.debug.evaluating import CannotTell
from vrts.debug.frames import Frame, frames
from vrts.debug.history.arm import of_arm, of_here, of_joint, of_opening
from vrts.debug.history.cells import of_bound
from vrts.debug.history.outputs import of_analog, of_signal, of_speed, of_switch
from vrts.debug.history.things import of_held, of_thing
from vrts.debug.history.track import Track
from vrts.debug.near import near_words
from vrts.debug.passages import Instant
from vrts.engine.memory.cells import Array, Bound
from vrts.engine.run import Run
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.ir.system import SWITCHES
from vrts.lang.names import key

_SIGNAL = re.compile(r"(?:sig|signal)?\s*\(?\s*(\d{1,5})\s*\)?", re.IGNORECASE)
_ANALOG = re.compile(r"analog(?:\s+output)?\s+(\d{1,4})", re.IGNORECASE)
_JOINT = re.compile(r"(?:jt|joint)\s*([1-6])", re.IGNORECASE)
_ELEMENT = re.compile(r"([^\[\]]+)\[(-?\d{1,6}(?:,-?\d{1,6})*)\]")
_MADE = {
    "arm": of_arm,
    "here": of_here,
    "opening": of_opening,
    "hand": of_opening,
    "holds": of_held,
    "held": of_held,
    "speed": of_speed,
}
_MOST = 80  # characters of a name


def tracks(run: Run, name: str, at: Instant, frame: Frame | None = None) -> list[Track]:
    """Return the changes of all that a name stands for at an instant.

    Args:
        run: What happened.
        name: `x`, `a[3]`, `a`, `SIG(5)`, `can1`, `HERE`, `JT3`, `opening`, `holds`, `CP`.
        at: Where it is asked.
        frame: Whose arguments and automatic variables are meant; None: the robot's innermost.

    Raises:
        CannotTell: Nothing has this name; the text says what is nearly so called.
    """
    text = " ".join(name.split())[:_MOST]
    found = list(_found(run, text, at, frame))
    if found:
        return found
    known = {b.name for b in run.history.memory.bound} | set(run.placements) | set(_MADE)
    meant = near_words(key(text).partition("[")[0], known)
    raise CannotTell(f"nothing here is called `{text}`{meant}")


def _found(run: Run, text: str, at: Instant, frame: Frame | None) -> Iterator[Track]:
    signal, analog, joint = (p.fullmatch(text) for p in (_SIGNAL, _ANALOG, _JOINT))
    if signal is not None:
        number = int(signal[1])
        if not any(number in known for known in (INPUTS, OUTPUTS, INTERNAL)):
            raise CannotTell(f"there is no signal {number}")
        yield of_signal(run, number)
        return
    if analog is not None:
        yield of_analog(run, int(analog[1]))
        return
    wanted = key(text.replace(" ", ""))
    element = _ELEMENT.fullmatch(wanted)
    base = element[1] if element else wanted
    bound = _bound(run, base, at, frame)
    if bound is not None:
        yield from _of_bound(run, bound, base, element[2] if element else "")
    for body in run.placements:
        if body.lower() == text.lower():
            yield of_thing(run, body)
    if bound is not None:
        return
    if joint is not None:
        yield of_joint(run, int(joint[1]) - 1)
    elif wanted in _MADE:
        yield _MADE[wanted](run)
    elif wanted in ("tool", "base"):
        memory = run.history.memory
        yield of_bound(run, memory.tool if wanted == "tool" else memory.base, wanted.upper())
    elif wanted.upper() in SWITCHES:
        yield of_switch(run, wanted.upper())
    elif wanted.upper() in run.history.memory.parameters:
        cell = run.history.memory.parameters[wanted.upper()]
        yield of_bound(run, cell, wanted.upper())


def _of_bound(run: Run, bound: Bound, base: str, subscripts: str) -> Iterator[Track]:
    if not isinstance(bound, Array):
        if not subscripts:
            yield of_bound(run, bound, base)
        return
    if not subscripts:
        yield of_bound(run, bound, base)
        return
    cell = bound.elements.get(tuple(map(int, subscripts.split(","))))
    if cell is not None:
        yield of_bound(run, cell, f"{base}[{subscripts}]")


def _bound(run: Run, name: str, at: Instant, frame: Frame | None) -> Bound | None:
    """Return what a name stands for: what is local hides what is global."""
    frame = frame or next(iter(frames(run, at, process=False)), None)
    if frame is not None and frame.activation is not None:
        declared = frame.declared(run)
        if name in declared:
            return frame.activation.slots[declared.index(name)]
    return next((item for item in run.history.memory.bound if item.name == name), None)
