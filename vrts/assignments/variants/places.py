"""Values of the scene's locations in a program: read, and put in place of those of another variant.

Programs are taken as bytes whose letters beyond ASCII stay as they are.
"""

import re
from collections.abc import Collection, Iterator, Mapping
from typing import TypeAlias

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.scene.block import DECIMALS, location_line

Values: TypeAlias = tuple[float, ...]  # X Y Z in mm, O A T in degrees, as programs show them

LARGEST = 1_000_000  # bytes that are looked at
HEADERS = (".locations", ".trans")
_LINE = re.compile(r"[^\r\n]*(?:\r\n|\n|\r|$)")
_SECTION = re.compile(r"[ \t]*(\.[A-Za-z]+)")
_NUMBER = r"[-+]?\d+(?:\.\d*)?|[-+]?\.\d+"
_VALUES = re.compile(rf"[ \t]*([A-Za-z][A-Za-z0-9_.]*)((?:[ \t,]+(?:{_NUMBER})){{6}})[ \t]*(;.*)?$")


def shown(X_WT: Pose) -> Values:
    """Return a pose as programs show it."""
    return tuple(round(value, DECIMALS) + 0.0 for value in components(X_WT))


def taught(program: bytes) -> dict[str, Values]:
    """Return the locations that a program gives in its `.LOCATIONS`, by name in small letters."""
    text = program[:LARGEST].decode("latin-1")
    return {name: values for _, name, values in _given(_LINE.findall(text))}


def with_places(
    program: bytes,
    before: Mapping[str, Pose],
    now: Mapping[str, Pose],
    leave_out: Collection[str] = (),
) -> bytes:
    """Return a program with the locations of another scene.

    A value that is not exactly that of the scene before is its writer's own, and stays.

    Args:
        program: Its `.LOCATIONS` have values of the scene before.
        before: Locations of the scene before, by name in small letters.
        now: Those of the scene that it is for.
        leave_out: Names that get no value at all.
    """
    if len(program) > LARGEST:
        return program
    lines = _LINE.findall(program.decode("latin-1"))
    for index, name, values in tuple(_given(lines)):
        if name in leave_out:
            lines[index] = ""
        elif name in now and name in before and values == shown(before[name]):
            written = lines[index].split()[0]
            end = lines[index][len(lines[index].rstrip("\r\n")) :]
            lines[index] = location_line(written, now[name]) + end
    return "".join(lines).encode("latin-1")


def _given(lines: list[str]) -> Iterator[tuple[int, str, Values]]:
    """Yield every location with its line."""
    inside = False
    for index, line in enumerate(lines):
        header = _SECTION.match(line)
        if header is not None:
            inside = header[1].lower() in HEADERS
            continue
        found = _VALUES.match(line.rstrip("\r\n")) if inside else None
        if found is not None:
            numbers = found[2].replace(",", " ").split()
            values = tuple(round(float(number), DECIMALS) + 0.0 for number in numbers)
            yield index, found[1].lower(), values
