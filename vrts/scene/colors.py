"""Colours of a scene file: names that people use, or #rrggbb."""

import re
from typing import TypeAlias

Color: TypeAlias = tuple[float, float, float]  # linear RGB 0..1

NAMED = {
    "red": "#c8382e",
    "green": "#3f8f4f",
    "blue": "#2f6fb5",
    "yellow": "#e0b22c",
    "orange": "#dd7a28",
    "purple": "#7a559e",
    "white": "#f2f2ee",
    "grey": "#8a8f94",
    "black": "#2b2d30",
    "steel": "#a9b4bd",
    "wood": "#c9a878",
    "concrete": "#c9c9c4",
}

_HEX = re.compile(r"#[0-9a-fA-F]{6}")


def color(text: str) -> Color | None:
    """Return a colour, or None when the text names none."""
    code = NAMED.get(text, text)
    if not _HEX.fullmatch(code):
        return None
    red, green, blue = (int(code[at : at + 2], 16) / 255.0 for at in (1, 3, 5))
    return (_linear(red), _linear(green), _linear(blue))


def known_color(code: str) -> Color:
    """Return the colour of a #rrggbb or a name that is known to be right.

    Raises:
        ValueError: It is not.
    """
    found = color(code)
    if found is None:
        raise ValueError(code)
    return found


def hex_code(linear: Color) -> str:
    """Return the #rrggbb of a colour."""
    return "#" + "".join(f"{round(255 * _encoded(part)):02x}" for part in linear)


def _linear(part: float) -> float:
    """Return linear light of an sRGB component [IEC 61966-2-1]."""
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


def _encoded(part: float) -> float:
    return 12.92 * part if part <= 0.0031308 else 1.055 * part ** (1 / 2.4) - 0.055
