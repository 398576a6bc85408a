"""A compilation as the controller's STORE writes it [manual language/files#store].

Programs in alphabetical order, then locations, reals and strings. What is read back is the same:
programs, strings and reals exactly, locations rounded to 4 decimals, or exactly too if asked for.
"""

from collections.abc import Iterable

from vrts.base.oat import components, plain_angles, pose_from_components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.ir.module import Datum, Module
from vrts.ir.values import Joints
from vrts.lang.decimals import degrees_text, millimetres_text, single_text
from vrts.lang.dialect import Angles, Dialect
from vrts.lang.writing.layout import NAME_WIDTH, program_text

DECIMALS = 4


def store_text(source: SourceFile, module: Module, dialect: Dialect, *, exact: bool = False) -> str:
    """Return what STORE writes for the programs and data of a compilation."""
    programs = program_text(source, dialect)
    rows = [programs[name] for name in sorted(programs)]
    return "".join(rows) + data_text(module.data, dialect, exact=exact)


def data_text(given: Iterable[Datum], dialect: Dialect, *, exact: bool = False) -> str:
    """Return the data sections of a file of a dialect, each in alphabetical order."""
    data = {(datum.name, datum.subscripts): datum for datum in given}  # the last one holds
    ordered = [data[place] for place in sorted(data)]
    poses = [d for d in ordered if isinstance(d.value, Pose)]
    joints = [d for d in ordered if isinstance(d.value, tuple) and not isinstance(d.value, Pose)]
    reals = [d for d in ordered if isinstance(d.value, float)]
    texts = [d for d in ordered if isinstance(d.value, str)]
    if dialect.is_as:
        rows = _section(".TRANS", poses, dialect, exact=exact)
        rows += _section(".JOINTS", joints, dialect, exact=exact)
    else:
        rows = _section(".LOCATIONS", [*poses, *joints], dialect, exact=exact)
    rows += _section(".REALS", reals, dialect, exact=exact)
    rows += _section(".STRINGS", texts, dialect, exact=exact)
    return "".join(rows)


def _section(title: str, data: Iterable[Datum], dialect: Dialect, *, exact: bool) -> list[str]:
    rows = [_row(d, dialect, exact=exact) for d in data]
    return [f"{title}\n", *rows, ".END\n"] if rows else []


def _row(datum: Datum, dialect: Dialect, *, exact: bool) -> str:
    """Return a line of data; AS puts `=` behind the names of numbers and strings [ASPrograms]."""
    value = _value(datum, dialect, exact=exact)
    if dialect.is_as and isinstance(datum.value, float | str):
        return f"{_name(datum)} = {value}\n"
    return f"{_name(datum):<{NAME_WIDTH - 1}} {value}\n"


def _name(datum: Datum) -> str:
    if not datum.subscripts:
        return datum.name
    return f"{datum.name}[{','.join(map(str, datum.subscripts))}]"


def _value(datum: Datum, dialect: Dialect, *, exact: bool) -> str:
    value = datum.value
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, Pose):
        return _exact_pose(value) if exact else _pose(value, dialect)
    if isinstance(value, tuple):
        return _joints(value, exact=exact)
    return single_text(value)


def _joints(value: Joints, *, exact: bool) -> str:
    if exact:
        return " ".join(degrees_text(joint) for joint in value)
    return " ".join(_fixed(deg(joint)) for joint in value)


def _pose(pose: Pose, dialect: Dialect) -> str:
    """Return X Y Z O A T with 4 decimals, such that what is read is written the same again."""
    rounded = _rounded(pose)
    again = _rounded(pose_from_components(*rounded))
    while again != rounded:  # a tool that is vertical only after rounding loses an angle
        rounded, again = again, _rounded(pose_from_components(*again))
    x, y, z, o, a, t = rounded
    if dialect.angles is Angles.ZYZ:
        o, a, t = plain_angles(o, a, t)
    return " ".join(_fixed(number) for number in (x, y, z, o, a, t))


def _rounded(pose: Pose) -> tuple[float, float, float, float, float, float]:
    x, y, z, o, a, t = (round(number, DECIMALS) + 0.0 for number in components(pose))
    return (x, y, z, 180.0 if o == -180.0 else o, a, 180.0 if t == -180.0 else t)


def _exact_pose(pose: Pose) -> str:
    """Return the columns n, o, a and the position, with all their digits."""
    nx, ox, ax, ny, oy, ay, nz, oz, az = pose.rotation
    turn = (repr(number + 0.0) for number in (nx, ny, nz, ox, oy, oz, ax, ay, az))
    return " ".join((*turn, *(millimetres_text(length) for length in pose.translation)))


def _fixed(number: float) -> str:
    return f"{round(number, DECIMALS) + 0.0:.{DECIMALS}f}"
