"""Colour as a layer over text that is complete without it."""

from enum import Enum

from vrts.base.diagnostic import Severity
from vrts.report.plain import plain_text


class Style(Enum):
    """What a piece of text is; the value is its ANSI attribute list."""

    ERROR = "1;31"
    WARNING = "1;33"
    NOTE = "1;36"
    GOOD = "1;32"
    STRONG = "1"
    GUTTER = "1;34"
    SECONDARY = "34"
    FAINT = "2"


BY_SEVERITY = {
    Severity.ERROR: Style.ERROR,
    Severity.WARNING: Style.WARNING,
    Severity.NOTE: Style.NOTE,
}


class Palette:
    """Paints, or does not."""

    def __init__(self, *, color: bool) -> None:
        """Choose whether `paint` adds anything."""
        self._color = color

    def paint(self, style: Style, text: str) -> str:
        """Return the text in a style; without colour, or empty, as it is."""
        return f"\x1b[{style.value}m{text}\x1b[0m" if self._color and text else text


def worded(word: str, text: str, style: Style, palette: Palette) -> str:
    """Return `word: text`, further lines of the text indented below the first."""
    first, *rest = plain_text(text).split("\n")
    indent = " " * (len(word) + 2)
    return "\n".join(
        [palette.paint(style, word) + f": {first}", *(f"{indent}{line}" for line in rest)]
    )
