"""The locations of a program as a viewer shows them: handles, some of which can be dragged."""

from collections.abc import Callable, Mapping, Sequence

from vrts.base.pose import Pose
from vrts.base.units import mm
from vrts.engine.run import Run
from vrts.ir.expressions import Constant, Expression, Global, Load, Place
from vrts.ir.module import Datum, Module
from vrts.ir.motion import SetBase, SetBaseFrame
from vrts.ir.values import Value
from vrts.report.locations.uses import Uses, uses_of
from vrts.report.page.viewer_data import Json, pose_numbers
from vrts.report.plain import one_line
from vrts.robots.kinematics.kinematics import hand_pose

MOST_ROWS = 200
LONGEST = 60  # characters of a name, or of what a location is relative to

JOINTS = "it holds six joint angles, not X, Y and Z"
BASE = "a BASE step of the program moves what its numbers mean"


def location_rows(module: Module, run: Run, unwritable: Callable[[str], str]) -> list[Json]:
    """Return every location with a place, as a viewer takes it.

    Each has its name and subscripts, the file and line of its numbers, its pose in the world
    (twelve numbers), X Y Z as its line gives them [mm], and why it cannot be dragged; that is
    empty where it can. Tools, and what stands behind a
    frame that the run does not know, are left out.

    Args:
        module: Programs and data.
        run: What they did; values are those of its end.
        unwritable: Returns why a file cannot be written, or nothing.
    """
    state = run.at_statement(run.statements)
    values = state.variables
    uses = uses_of(module)
    moved = any(
        isinstance(step, SetBase | SetBaseFrame)
        for program in module.programs.values()
        for step in program.instructions
    )
    X_WV = state.base.inverse()  # of what numbers are relative to
    rows: list[Json] = []
    given: set[str] = set()
    last = {(datum.name, datum.subscripts): datum for datum in module.data}
    for datum in last.values():
        if not isinstance(datum.value, tuple) or datum.name.startswith("$"):
            continue
        shown = element(datum.name, datum.subscripts)
        given.add(shown)
        use = uses.get(datum.name, Uses())
        value = values.get(shown, datum.value) if use.written else datum.value
        X_WT = _world(value, use, values, run, X_WV)
        if X_WT is not None:
            why = _why(datum, use, moved=moved) or unwritable(datum.span.source.name)
            rows.append(_row(shown, datum, X_WT, why))
    for name, value in values.items():
        use = uses.get(name.partition("[")[0], Uses())
        if name in given or use.written is None or not isinstance(value, tuple):
            continue
        worked = _world(value, use, values, run, X_WV)
        if worked is not None:
            line = use.written.line
            rows.append(_row(name, None, worked, f"line {line} works it out", line))
    return rows[:MOST_ROWS]


def element(name: str, subscripts: Sequence[int]) -> str:
    """Return how a variable or an element of an array is written."""
    return f"{name}[{','.join(map(str, subscripts))}]" if subscripts else name


def _row(shown: str, datum: Datum | None, X_WT: Pose, why: str, line: int = 0) -> Json:
    value = None if datum is None else datum.value
    return {
        "name": one_line(shown)[:LONGEST],
        "of": "" if datum is None else datum.name,
        "subscripts": [] if datum is None else list(datum.subscripts),
        "file": "" if datum is None else datum.span.source.name,
        "line": line if datum is None else datum.span.line,
        "X": pose_numbers(X_WT),
        "numbers": [round(mm(x), 4) for x in value.translation] if isinstance(value, Pose) else [],
        "why": why,
    }


def _why(datum: Datum, use: Uses, *, moved: bool) -> str:
    """Return why the numbers of a line cannot be dragged; nothing where they can."""
    if not isinstance(datum.value, Pose):
        return JOINTS
    if use.written is not None:
        return f"line {use.written.line} of the program gives it another value"
    if use.behind and not use.as_place:
        return f"it is relative to {_written(use.behind)}"
    return BASE if moved else ""


def _world(
    value: Value, use: Uses, values: Mapping[str, Value], run: Run, X_WV: Pose
) -> Pose | None:
    """Return where a location stands in the world; None where nothing tells."""
    if not isinstance(value, Pose):
        assert isinstance(value, tuple)
        return hand_pose(run.scene.robot.arm, value) @ run.scene.X_FT
    if use.as_tool and not use.as_place:
        return None
    frames = [] if use.as_place else [_value(part, values) for part in use.behind]
    placed = X_WV
    for frame in frames:
        if frame is None:
            return None
        placed = placed @ frame
    return placed @ value


def _value(part: Expression, values: Mapping[str, Value]) -> Pose | None:
    name = _name(part)
    value = None if name is None else values.get(name)
    return value if isinstance(value, Pose) else None


def _name(part: Expression) -> str | None:
    match part:
        case Load(Place(Global(name), subscripts)):
            numbers = [s.value for s in subscripts if isinstance(s, Constant)]
            inside = [int(n) for n in numbers if isinstance(n, float)]
            return element(name, inside) if len(inside) == len(subscripts) else None
        case _:
            return None


def _written(behind: tuple[Expression, ...]) -> str:
    names = [_name(part) for part in behind]
    known = ":".join(name for name in names if name is not None)
    return f"`{one_line(known)[:LONGEST]}`" if all(names) else "a frame"
