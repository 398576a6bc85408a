"""Programs and data as they will stand in the controller: text that is typed, values as printed.

What is verified for the real robot is this text, read again: nothing that printing loses is left.
"""

from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.oat import components, plain_angles, pose_from_components
from vrts.base.pose import Pose
from vrts.base.units import deg
from vrts.dispatch.bundle import files_of
from vrts.dispatch.profile import Profile
from vrts.dispatch.steps import typed
from vrts.ir.module import Datum, Module
from vrts.ir.values import Joints
from vrts.lang.compiler import Compilation, Options, compile_sources
from vrts.lang.decimals import single_text
from vrts.lang.dialect import Angles, Precedence
from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.writing.layout import NAME_WIDTH, program_text

MOST_ROUNDS = 10  # of printing and reading until a location stays as it is


class Printed(NamedTuple):
    """Texts of a bundle."""

    programs: Mapping[str, str]  # by name, in alphabetical order
    locations: str  # a whole section; "" where there are none
    reals: str
    strings: str


def printed(compilation: Compilation, profile: Profile) -> Printed:
    """Return what a compilation that succeeded is sent as.

    Args:
        compilation: Of the program and what was compiled with it.
        profile: Says how many decimals the controller prints.
    """
    assert compilation.module is not None
    assert compilation.source is not None
    texts = program_text(compilation.source, compilation.dialect)
    data = placed_data(compilation.module)
    poses = [d for d in data if isinstance(d.value, Pose)]
    joints = [d for d in data if isinstance(d.value, tuple) and not isinstance(d.value, Pose)]
    reals = [d for d in data if isinstance(d.value, float)]
    strings = [d for d in data if isinstance(d.value, str)]
    return Printed(
        {name: _plain(texts[name], profile.line_length) for name in sorted(texts)},
        _section(".LOCATIONS", [*poses, *joints], profile),
        _section(".REALS", reals, profile),
        _section(".STRINGS", strings, profile),
    )


def placed_data(module: Module) -> list[Datum]:
    """Return the data of a module in order of name; of several with one name the last one holds."""
    data = {(datum.name, datum.subscripts): datum for datum in module.data}
    return [data[place] for place in sorted(data)]


def name_of(datum: Datum) -> str:
    """Return the name of a datum with its subscripts."""
    if not datum.subscripts:
        return datum.name
    return f"{datum.name}[{','.join(map(str, datum.subscripts))}]"


def read_back(texts: Printed, entry: str, profile: Profile, precedence: str | None) -> Compilation:
    """Return what a controller makes of the texts: each is a file of its own, `entry` first."""
    sources = files_of(texts.programs, entry, texts.locations, texts.reals, texts.strings)
    binds = None if precedence is None else Precedence(precedence)
    return compile_sources(sources, Options(profile.language, binds))


def _plain(text: str, most: int) -> str:
    """Return the text of a program without tabs and blanks at line ends.

    The comment of a line with more than `most` characters moves nearer to its step.
    """
    lines = [line.expandtabs(8).rstrip() for line in text.split("\n")[:-1]]
    return "".join(f"{line if len(typed(line)) <= most else _closer(line)}\n" for line in lines)


def _closer(line: str) -> str:
    at = comment_start(line)
    return line if at < 0 else f"{line[:at].rstrip()}  {line[at:]}"


def _section(title: str, data: list[Datum], profile: Profile) -> str:
    rows = [f"{name_of(d):<{NAME_WIDTH - 1}} {_value(d, profile)}\n" for d in data]
    return "".join((f"{title}\n", *rows, ".END\n")) if rows else ""


def _value(datum: Datum, profile: Profile) -> str:
    value = datum.value
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, Pose):
        return pose_numbers(value, profile)
    if isinstance(value, tuple):
        return _joints(value, profile)
    return single_text(value)


def _joints(value: Joints, profile: Profile) -> str:
    return " ".join(_fixed(deg(joint), profile.angle_decimals) for joint in value)


def pose_numbers(pose: Pose, profile: Profile) -> str:
    """Return X Y Z and the angles, such that what is read is printed the same again."""
    rounded = _rounded(pose, profile)
    for _ in range(MOST_ROUNDS):  # a tool that is vertical only after rounding loses an angle
        again = _rounded(pose_from_components(*rounded), profile)
        if again == rounded:
            break
        rounded = again
    x, y, z, o, a, t = rounded
    if profile.language.angles is Angles.ZYZ:
        o, a, t = plain_angles(o, a, t)
    lengths = (_fixed(number, profile.length_decimals) for number in (x, y, z))
    angles = (_fixed(number, profile.angle_decimals) for number in (o, a, t))
    return " ".join((*lengths, *angles))


def _rounded(pose: Pose, profile: Profile) -> tuple[float, float, float, float, float, float]:
    x, y, z, *turns = components(pose)
    lengths = profile.length_decimals
    o, a, t = (round(turn, profile.angle_decimals) + 0.0 for turn in turns)
    return (
        round(x, lengths) + 0.0,
        round(y, lengths) + 0.0,
        round(z, lengths) + 0.0,
        180.0 if o == -180.0 else o,
        a,
        180.0 if t == -180.0 else t,
    )


def _fixed(number: float, decimals: int) -> str:
    return f"{round(number, decimals) + 0.0:.{decimals}f}"
