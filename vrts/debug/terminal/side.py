"""The rows beside the text: arm, hand, signals and variables, as many as there is room for."""

from collections.abc import Iterable, Mapping

from vrts.base.oat import components
from vrts.base.units import deg, mm
from vrts.debug.debugger import Debugger
from vrts.debug.terminal.fitting import Row, cut
from vrts.debug.values import variable
from vrts.ir.values import Value
from vrts.monitor.listings import name_order
from vrts.report.plain import one_line

LEAST, MOST = 35, 60  # columns
_SHARE = 0.42  # of the screen
_NAME = 12  # columns of a name


def side_width(width: int) -> int:
    """Return how many columns of a screen the values take."""
    return min(max(LEAST, int(width * _SHARE)), MOST)


def value_rows(debugger: Debugger, room: int, height: int) -> list[Row]:
    """Return the values that are seen here, in rows of at most `room` columns."""
    state = debugger.state
    joints = [f"{deg(q):8.2f}" for q in state.configuration]
    X = components(state.base @ state.X_WT)
    held = f"holds {one_line(state.held)}" if state.held else ""
    rows: list[Row] = [
        [("head", "JT1-3 "), ("", "".join(joints[:3])), ("dim", " deg")],
        [("head", "JT4-6 "), ("", "".join(joints[3:]))],
        [("head", "X Y Z "), ("", "".join(f"{v:8.1f}" for v in X[:3])), ("dim", " mm")],
        [("head", "O A T "), ("", "".join(f"{v:8.1f}" for v in X[3:]))],
        [("head", "hand  "), ("", f"{mm(state.hand_opening):8.1f}"), ("dim", " mm "), ("", held)],
        [("head", "on    "), ("", _signals(state.signals, room))],
    ]
    rows += _variables("arguments, AUTO", state.locals, room, height - len(rows))
    rows += _variables("variables", state.variables, room, height - len(rows))
    return rows[:height]


def _variables(title: str, values: Mapping[str, Value], room: int, height: int) -> list[Row]:
    if not values or height < 2:
        return []
    names = sorted(values, key=name_order)
    rows: list[Row] = [[("dim", f"── {title} ")]]
    for name in names[: height - 1]:
        text = " ".join(variable(name, values[name]).value.split())
        label = cut(one_line(name), _NAME)
        rows.append([("head", f"{label:<{_NAME}} "), ("", cut(one_line(text), room - _NAME - 1))])
    if len(names) > height - 1:
        rows[-1] = [("dim", f"and {len(names) - height + 2:,} more: the command `state`")]
    return rows


def _signals(on: Iterable[int], room: int) -> str:
    return cut(", ".join(map(str, sorted(on))), room - 6) or "no signal"
