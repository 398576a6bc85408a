"""The layouts in which the monitor shows values. Each ends with a line end.

See [manual language/monitor#layouts].
"""

from collections.abc import Iterable, Mapping

from vrts.base.oat import Components, components, plain_angles
from vrts.base.pose import Pose
from vrts.base.units import deg, mm
from vrts.engine.code.values.formats import free
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.values import Joints, Value
from vrts.lang.dialect import Angles

COMPONENTS = " X/JT1     Y/JT2     Z/JT3     O/JT4     A/JT5     T/JT6"
_NAME = 12  # columns of the name of a location
_REAL_NAME = 10  # of a number or a string
_GROUP = 4  # signals
_BLOCK = 32
_FIRST_INPUT, _FIRST_INTERNAL = 1001, 2001
_LABEL, _VALUE = 21, 24  # columns of STATUS: where words begin, where numbers end


def printed(X: Pose, angles: Angles) -> Components:
    """Return X Y Z in mm and three angles in degrees, as a dialect means them."""
    x, y, z, o, a, t = components(X)
    if angles is Angles.OAT:
        return x, y, z, o, a, t
    return x, y, z, *plain_angles(o, a, t)


def pose_row(X: Pose, angles: Angles = Angles.OAT) -> str:
    """Return X Y Z in mm with two decimals, three angles in degrees with three."""
    values = printed(X, angles)
    lengths = "".join(f"{_tidy(value, 2):10.2f}" for value in values[:3])
    return lengths + "".join(f"{_tidy(value, 3):10.3f}" for value in values[3:])


def joints_row(joints: Joints) -> str:
    """Return six joints in degrees with three decimals."""
    return "".join(f"{_tidy(deg(joint), 3):10.3f}" for joint in joints)


def location_row(value: Pose | Joints, angles: Angles = Angles.OAT) -> str:
    """Return a location of either kind."""
    return pose_row(value, angles) if isinstance(value, Pose) else joints_row(value)


def where_text(X_WT: Pose, joints: Joints, opening_m: float, angles: Angles = Angles.OAT) -> str:
    """Return what WHERE shows: pose and hand, then joints."""
    hand = f"{_tidy(mm(opening_m), 2):10.2f}"
    return f"{COMPONENTS}     HAND\n{pose_row(X_WT, angles)}{hand}\n{joints_row(joints)}\n"


def where_of_as_text(X_WT: Pose, joints: Joints, *, block: int = 0) -> str:
    """Return what WHERE of AS shows: joints (1), pose (2) or both (0), with three decimals."""
    names = "".join(f"{f'JT{n}':>10}" for n in range(1, 7))
    first = f"{names}\n{joints_row(joints)}\n"
    letters = "".join(f"{letter:>10}" for letter in "XYZOAT")
    values = "".join(f"{_tidy(value, 3):10.3f}" for value in printed(X_WT, Angles.ZYZ))
    return ("" if block == 2 else first) + ("" if block == 1 else f"{letters}\n{values}\n")


def locations_text(values: Mapping[str, Pose | Joints], angles: Angles = Angles.OAT) -> str:
    """Return what LISTL shows: poses by name, then precision points by name."""
    header = " " * _NAME + "".join(f"{name:>10}" for name in COMPONENTS.split())
    names = sorted(values, key=lambda name: (name[0] == "#", name_order(name)))
    rows = (f"{name:<{_NAME}}{location_row(values[name], angles)}" for name in names)
    return _lines((header, *rows)) if names else ""


def values_text(values: Iterable[tuple[str, float | str]]) -> str:
    """Return what LISTR and LISTS show: a name or an expression, and its value."""
    return _lines(f"{_padded(name)}{_value(value)}" for name, value in values)


def signals_text(on: frozenset[int], block: int, installed: Mapping[int, int]) -> str:
    """Return what IO shows: outputs, inputs, internal signals, the highest number on the left.

    Args:
        on: The signals that are on.
        block: Which 32 of each kind, from 1.
        installed: How many there are of each kind, by the number of its first.
    """
    rows: list[str] = []
    for first, count in installed.items():
        low = first + (block - 1) * _BLOCK
        high = low + _BLOCK - 1
        signs = ["-" if n >= first + count else str(int(n in on)) for n in range(high, low - 1, -1)]
        groups = ["".join(signs[at : at + _GROUP]) for at in range(0, _BLOCK, _GROUP)]
        rows.append(f"{high:4d} - {low:4d}    {'   '.join(groups)}")
    return _lines(rows)


def status_text(
    speeds: tuple[float, float],
    title: str,
    status: str,
    cycles: tuple[int, int],
    frames: Iterable[tuple[str, int, int, str]],
) -> str:
    """Return what STATUS shows.

    Args:
        speeds: Of the monitor and of the program, in percent.
        title: "Robot program" or "PC program".
        status: Its state in a word.
        cycles: Completed and remaining; negative is endless.
        frames: Program, priority, step and its text.
    """
    done, left = cycles
    remaining = "Remaining cycles: Infinite" if left < 0 else _number("Remaining cycles:", left)
    return _lines(
        (
            _number("Monitor speed:", speeds[0]),
            _number("Program speed:", speeds[1]),
            f"{title + ':':<{_LABEL}}{status}",
            _number("Completed cycles:", done),
            remaining,
            "Program name      Prio   Step",
            *(
                f"{name:<16}{priority:6d}{step:7d}   {text}".rstrip()
                for name, priority, step, text in frames
            ),
        )
    )


def directory_text(rows: Iterable[tuple[str, bool, bool]]) -> str:
    """Return what DIRECTORY shows: `?` not executable, `M` modified, and the name."""
    return _lines(f" {'?' if bad else ' '}{'M' if new else ' '} {name}" for name, bad, new in rows)


def switches_text(states: Iterable[tuple[str, bool]]) -> str:
    """Return what SWITCH shows: two in a row, `*` before those that only show something."""
    cells = [
        f"{'*' if SWITCHES[name].read_only else ' '}{name:<16}{'ON' if on else 'OFF':<6}"
        for name, on in states
    ]
    return _lines("".join(cells[at : at + 2]).rstrip() for at in range(0, len(cells), 2))


def parameters_text(values: Iterable[tuple[str, float]]) -> str:
    """Return what PARAMETER shows: name, value and unit."""
    return _lines(
        f"{cell:<16}{free(value)} {PARAMETERS[cell.partition('[')[0]].unit}".rstrip()
        for cell, value in values
    )


def name_order(name: str) -> tuple[str, tuple[int, ...]]:
    """Return a key that sorts `a[2]` before `a[10]`."""
    base, _, index = name.rstrip("]").partition("[")
    return base, tuple(int(part) for part in index.split(",")) if index else ()


def value_text(value: Value) -> str:
    """Return a value of any kind in one line."""
    return location_row(value) if isinstance(value, tuple) else _value(value)


def _value(value: float | str) -> str:
    return f'"{value}"' if isinstance(value, str) else free(value)


def _padded(name: str) -> str:
    return f"{name:<{_REAL_NAME}}" if len(name) < _REAL_NAME else f"{name} "


def _number(label: str, value: float) -> str:
    return f"{label}{free(value):>{_VALUE - len(label)}}"


def _tidy(value: float, decimals: int) -> float:
    return round(value, decimals) + 0.0


def _lines(rows: Iterable[str]) -> str:
    return "".join(f"{row}\n" for row in rows)
