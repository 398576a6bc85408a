"""What the terminal shows while a program is debugged: rows of styled text, for any size."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from vrts.base.oat import components
from vrts.base.source import SourceFile
from vrts.base.units import deg, mm
from vrts.debug.alarms import Filter
from vrts.debug.breakpoints import resolve
from vrts.debug.debugger import Debugger, Stop, Why
from vrts.engine.memory.events import Cause
from vrts.ir.values import Value
from vrts.monitor.listings import name_order, value_text
from vrts.report.plain import one_line, visible

Piece: TypeAlias = tuple[str, str]  # style class, text
Row: TypeAlias = list[Piece]

SIDE = 46  # columns of the values beside the source
LEAST_WIDTH, LEAST_HEIGHT = 72, 20
TERMINAL_ROWS = 5
HELP = " n s o c t: forward   N S C T: back   b breakpoint   : command   ? all keys   q end"
KEYS = """\
Forward                         Backward
  n  next step, over calls        N  back to where the last step came from
  s  next step, into calls        S  the same
  o  out of this program
  c  to the next stop             C  to the last stop before
  t  one set point of the arm     T  one set point back
  right  0.1 s                    left  0.1 s
  end  the end                    home  the beginning

  up, down    choose a line       b  breakpoint at the line
  g           run to the line     j  go on with the line next (another future)
  a           which alarms stop   w  stop when a variable or signal changes
  y           why the arm does what it does
  :           a command of the monitor, an expression, `x = 5`, or `why x`
  p           robot program or process control program
  v           see this moment in 3D   V  in the Rerun viewer
  r           again from the beginning, with the files as they are now
  q           end
"""
_WHY = {
    Why.ENTRY: "at the beginning",
    Why.STEP: "step",
    Why.BREAKPOINT: "breakpoint",
    Why.CHANGE: "change",
    Why.ALARM: "ALARM",
    Why.GOTO: "another step",
    Why.BEGIN: "at the beginning",
    Why.END: "at the end",
}


@dataclass(slots=True)
class View:
    """What the user looks at."""

    cursor: int | None = None  # line chosen; None: the one that is executed
    process: bool = False  # which program the steps are of
    said: list[str] = field(default_factory=list[str])  # by the console, the last lines
    asked: str | None = None  # what stands before a line that is being typed
    typed: str = ""
    help: bool = False


def panel(debugger: Debugger, view: View, width: int, height: int) -> list[Row]:
    """Return the rows of the screen."""
    if width < LEAST_WIDTH or height < LEAST_HEIGHT:
        return [[("alarm", f"at least {LEAST_WIDTH} x {LEAST_HEIGHT} characters are needed")]]
    body = height - 4 - TERMINAL_ROWS
    if view.help:
        left = [[("", line)] for line in KEYS.split("\n")][:body]
    else:
        left = source_rows(debugger, view, width - SIDE - 1, body)
    right = value_rows(debugger, body)
    rows = [_title(debugger, view, width)]
    for k in range(body):
        row = _fitted(left[k] if k < len(left) else [], width - SIDE - 1)
        rows.append([*row, ("frame", "│"), *_fitted(right[k] if k < len(right) else [], SIDE)])
    rows.append([("frame", "─" * width)])
    rows += _terminal(debugger, view, width)
    rows.append(time_bar(debugger, width))
    if view.asked is not None:
        rows.append([("prompt", view.asked), ("", view.typed[-(width - 20) :]), ("cursor", " ")])
    else:
        rows.append(_fitted([("help", HELP)], width))
    return rows


def current(debugger: Debugger, *, process: bool) -> Cause | None:
    """Return the step that a program executes next, or executed last."""
    state = debugger.state
    stack = state.process_stack if process else state.call_stack
    if stack:
        return stack[-1]
    passages = debugger.passages(process=process)
    return passages.cause(passages.count - 1) if passages.count else None


def source_of(debugger: Debugger, view: View) -> SourceFile | None:
    """Return the source that is shown."""
    cause = current(debugger, process=view.process) or current(debugger, process=False)
    return None if cause is None else cause.span.source


def source_rows(debugger: Debugger, view: View, width: int, height: int) -> list[Row]:
    """Return the lines around the one that is executed next, or was chosen."""
    cause = current(debugger, process=view.process) or current(debugger, process=False)
    if cause is None:
        return [[("dim", "nothing was executed")]]
    source = cause.span.source
    count = len(source.line_starts)
    chosen = view.cursor or cause.span.line
    first = max(1, min(chosen - height // 2, count - height + 1))
    code = debugger.run.history.code
    points = {
        found.line: bool(point.log or point.condition or point.hits)
        for point in debugger.wishes.lines
        if point.source == source.name and (found := resolve(code, source.name, point.line))
    }
    motion = debugger.state.cause
    moving = motion.span.line if motion is not None and motion.span.source is source else None
    rows: list[Row] = []
    for line in range(first, min(first + height, count + 1)):
        mark = " " if line not in points else "◆" if points[line] else "●"
        here = "▶" if line == cause.span.line else "~" if line == moving else " "
        text = visible(source.line_text(line).replace("\t", "    "))
        style = "here" if line == cause.span.line else "chosen" if line == view.cursor else ""
        rows.append(
            [("point", mark), ("dim", f"{line:4d} "), (style, f"{here} {text}"[: width - 6])]
        )
    return rows


def value_rows(debugger: Debugger, height: int) -> list[Row]:
    """Return arm, signals and variables, as many as there is room for."""
    state = debugger.state
    joints = [f"{deg(q):8.2f}" for q in state.configuration]
    X = components(state.base @ state.X_WT)
    rows: list[Row] = [
        [("head", "JT1-3 "), ("", "".join(joints[:3])), ("dim", "  deg")],
        [("head", "JT4-6 "), ("", "".join(joints[3:]))],
        [("head", "X Y Z "), ("", "".join(f"{v:8.1f}" for v in X[:3])), ("dim", "  mm")],
        [("head", "O A T "), ("", "".join(f"{v:8.1f}" for v in X[3:]))],
        [
            ("head", "hand  "),
            ("", f"{mm(state.hand_opening):8.1f}"),
            ("dim", " mm "),
            ("", _held(state.held)),
        ],
        [("head", "on    "), ("", _signals(state.signals))],
    ]
    rows += _variables("arguments, AUTO", state.locals, height - len(rows))
    rows += _variables("variables", state.variables, height - len(rows))
    return rows[:height]


def time_bar(debugger: Debugger, width: int) -> Row:
    """Return the run as a bar, with marks where alarms were looked for and found."""
    run = debugger.run
    label = f" {debugger.at.time_s:8.3f} s of {run.horizon_s:.3f} s "
    length = width - len(label) - 2
    cells = ["─"] * length
    for alarm in debugger.alarms.of(debugger.wishes.filters):
        cells[_column(alarm.instant.time_s, run.horizon_s, length)] = "!"
    at = _column(debugger.at.time_s, run.horizon_s, length)
    pieces: Row = [("frame", "["), ("bar", "".join(cells[:at])), ("here", "█")]
    return [*pieces, ("bar", "".join(cells[at + 1 :])), ("frame", "]"), ("", label)]


def time_at(column: int, horizon_s: float, width: int, label: int = 0) -> float:
    """Return the time [s] that a column of the time bar stands for."""
    length = max(width - label - 2, 2)
    return horizon_s * min(max(column - 1, 0), length - 1) / (length - 1)


def _column(time_s: float, horizon_s: float, length: int) -> int:
    return round(time_s / horizon_s * (length - 1)) if horizon_s > 0.0 else 0


def _title(debugger: Debugger, view: View, width: int) -> Row:
    cause = current(debugger, process=view.process)
    where = (
        "" if cause is None else f"{one_line(cause.program)} {cause.step}, line {cause.span.line}"
    )
    thread = "process control program " if view.process else ""
    stop = debugger.stop
    style = "alarm" if stop.why is Why.ALARM else "title"
    text = f" {thread}{where}  {_words(stop)}"
    return _fitted([(style, text.ljust(width))], width)


def _words(stop: Stop) -> str:
    text = f": {one_line(stop.text)}" if stop.text else ""
    return f"{_WHY[stop.why]}{text}"


def _terminal(debugger: Debugger, view: View, width: int) -> list[Row]:
    """Return the last lines of the program's terminal, or what the console has said."""
    if view.said:
        lines = [("said", line) for line in view.said[-(TERMINAL_ROWS - 1) :]]
    else:
        written = visible(debugger.state.output.replace("\r\n", "\n")).split("\n")
        lines = [("", line) for line in written[-(TERMINAL_ROWS - 1) :]]
    rows = [_fitted([piece], width) for piece in lines]
    return [*rows, *([[]] * (TERMINAL_ROWS - 1 - len(rows)))]


def _variables(title: str, values: Mapping[str, Value], room: int) -> list[Row]:
    if not values or room < 2:
        return []
    names = sorted(values, key=name_order)
    rows: list[Row] = [[("dim", f"── {title} ")]]
    for name in names[: room - 1]:
        text = " ".join(value_text(values[name]).split())
        rows.append([("head", f"{one_line(name)[:12]:<12} "), ("", one_line(text)[: SIDE - 14])])
    if len(names) > room - 1:
        rows[-1] = [("dim", f"and {len(names) - room + 2:,} more")]
    return rows


def _held(held: str | None) -> str:
    return f"holds {one_line(held)}" if held else ""


def _signals(on: Iterable[int]) -> str:
    return ", ".join(map(str, sorted(on)))[: SIDE - 8] or "no signal"


def _fitted(row: Row, width: int) -> Row:
    """Return a row cut or filled to a width."""
    left = width
    found: Row = []
    for style, text in row:
        if left <= 0:
            break
        found.append((style, text[:left]))
        left -= len(text)
    if left > 0:
        found.append(("", " " * left))
    return found


ALARM_KEYS: Sequence[tuple[str, Filter]] = (
    ("c", Filter.CONTACT),
    ("n", Filter.NEAR_MISS),
    ("j", Filter.JOINT_LIMIT),
    ("s", Filter.SINGULARITY),
    ("v", Filter.SPEED),
    ("e", Filter.ERROR),
    ("d", Filter.DROPPED),
)
