"""Where a debugger stands, as data and in words."""

from typing import NamedTuple

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.debug.debugger import Debugger, Why
from vrts.engine.memory.events import Cause
from vrts.ir.values import Value
from vrts.report.plain import bare_name, one_line

WORDS = {
    Why.ENTRY: "at the beginning",
    Why.STEP: "step",
    Why.BREAKPOINT: "breakpoint",
    Why.CHANGE: "change",
    Why.ALARM: "ALARM",
    Why.GOTO: "another step",
    Why.GO: "gone to",
    Why.BEGIN: "at the beginning",
    Why.END: "at the end",
}
NAMES = {
    Why.ENTRY: "begin",
    Why.STEP: "step",
    Why.BREAKPOINT: "breakpoint",
    Why.CHANGE: "change",
    Why.ALARM: "alarm",
    Why.GOTO: "jump",
    Why.GO: "go",
    Why.BEGIN: "begin",
    Why.END: "end",
}


class Place(NamedTuple):
    """Where it stands."""

    time_s: float
    statements: int  # finished by then
    why: Why
    text: str  # more about why
    file: str = ""
    program: str = ""
    step: int = 0
    line: int = 0
    source: str = ""  # the line

    @property
    def sentence(self) -> str:
        """Return it in words."""
        about = f": {one_line(self.text)}" if self.text else ""
        line = f"{self.program} {self.step}, line {self.line}: {self.source}" if self.line else ""
        return f"{self.time_s:.3f} s  {WORDS[self.why]}{about}" + (f"\n  {line}" if line else "")


def place_of(debugger: Debugger, *, process: bool) -> Place:
    """Return where a debugger stands."""
    stop = debugger.stop
    bare = Place(stop.instant.time_s, stop.instant.finished, stop.why, stop.text)
    cause = current(debugger, process=process)
    if cause is None:
        return bare
    span = cause.span
    return bare._replace(
        file=bare_name(span.source.name),
        program=one_line(cause.program),
        step=cause.step,
        line=span.line,
        source=one_line(span.source.line_text(span.line)),
    )


def current(debugger: Debugger, *, process: bool) -> Cause | None:
    """Return the step that a program executes next, or executed last."""
    return debugger.current(process=process)


def source_of(debugger: Debugger, *, process: bool) -> SourceFile | None:
    """Return the text of the program that is looked at."""
    cause = current(debugger, process=process) or current(debugger, process=False)
    return None if cause is None else cause.span.source


def as_data(value: Value) -> dict[str, object]:
    """Return a value with its kind: numbers as they are, places in mm and degrees."""
    if isinstance(value, int | float):
        return {"kind": "real", "value": float(value)}
    if isinstance(value, str):
        return {"kind": "string", "value": value}
    if isinstance(value, Pose):
        return {"kind": "pose", "value": [round(float(number), 9) for number in components(value)]}
    return {"kind": "joints", "value": [deg(joint) for joint in value]}
