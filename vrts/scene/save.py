"""Adds a location to the text of a VAL-II file, losing nothing."""

import re

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.pose import Pose
from vrts.base.source import SourceFile, Span
from vrts.scene.block import NAME_WIDTH, location_line

LOCATION_EXISTS = Rule("V620", "location-exists")
LOCATION_NAME = Rule("V621", "location-name")

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.]*(\[\d+\])?")
_SECTION = re.compile(r"[ \t]*(\.[A-Za-z]+)")
_DATA_NAME = re.compile(r"[ \t]*([A-Za-z][A-Za-z0-9_.]*(?:\[\d+\])?)")
_LINE = re.compile(r"[^\r\n]*(?:\r\n|\n|\r|$)")  # form feeds and the like stay inside lines
_HEADERS = (".locations", ".trans")


def with_location(
    text: str, name: str, X_WT: Pose, *, replace: bool = False, file_name: str = "program"
) -> str | Diagnostic:
    """Return the text with a location in its `.LOCATIONS` section, made when there is none.

    Args:
        text: The whole file.
        name: Of the location, as VAL-II writes it.
        X_WT: Its pose.
        replace: Whether a location of this name is given the new pose. Otherwise it is refused.
        file_name: What a diagnostic calls the file.
    """
    if not _NAME.fullmatch(name) or len(name.partition("[")[0]) > NAME_WIDTH:
        return error(
            LOCATION_NAME,
            f"invalid location name `{name}`",
            help=(
                f"a name begins with a letter, has letters, digits, _ and ., at most {NAME_WIDTH}",
            ),
        )
    lines = [line for line in _LINE.findall(text) if line]
    line_end = "\r\n" if "\r\n" in text else "\r" if "\r" in text and "\n" not in text else "\n"
    new = location_line(name, X_WT) + line_end
    section = ""
    insert_at: int | None = None
    in_first = False
    for index, line in enumerate(lines):
        header = _SECTION.match(line)
        if header:
            if in_first:  # .END, or the next section where .END was left out
                insert_at, in_first = index, False
            section = header[1].lower()
            in_first = section in _HEADERS and insert_at is None
            continue
        known = _DATA_NAME.match(line)
        if section in _HEADERS and known and _same(known[1], name):
            if replace:
                lines[index] = new
                return "".join(lines)
            return _exists(text, name, sum(map(len, lines[:index])) + known.start(1), file_name)
    if in_first:
        insert_at = len(lines)
    if insert_at is not None:
        before = "".join(lines[:insert_at])
        return _ended(before, line_end) + new + "".join(lines[insert_at:])
    body, tail = _without_end_marks(text)
    gap = line_end if body.strip() else ""
    block = f".LOCATIONS{line_end}{new}.END{line_end}"
    return _ended(body, line_end) + gap + block + tail


def _same(a: str, b: str) -> bool:
    return _significant(a) == _significant(b)


def _significant(name: str) -> str:
    word, bracket, index = name.lower().partition("[")
    return word[:NAME_WIDTH] + bracket + index


def _ended(text: str, line_end: str) -> str:
    return text if not text or text.endswith(("\n", "\r")) else text + line_end


def _without_end_marks(text: str) -> tuple[str, str]:
    """Return the text and the end-of-file marks (SUB, NUL) behind it."""
    body = text.rstrip("\x1a\x00")
    return body, text[len(body) :]


def _exists(text: str, name: str, at: int, file_name: str) -> Diagnostic:
    span = Span(SourceFile(file_name, text), at, at + len(name))
    return error(
        LOCATION_EXISTS,
        f"`{name}` is already in the file",
        Label(span, "here"),
        help=("choose another name, or say that it may be replaced",),
        data={"name": name},
    )
