"""JSON for the page in which every character has a shape.

Names, programs and comments come from anybody. Marks of direction would turn around what stands
beside them, and let a program or a reason read differently from what it is; control characters
would vanish. Each is told as a stand-in, wherever it comes from: no field can be forgotten.
"""

import re
from typing import Final

from vrts.report.plain import visible

_ESCAPED: Final = re.compile(r"\\(?:u00([01][0-9a-f])|.)")  # each escape, so none begins inside one
_PICTURES: Final = {"b": "\b", "f": "\f", "r": "\r"}  # line ends and tabs stay as they are


def with_shapes(data: bytes) -> bytes:
    """Return JSON, as msgspec writes it, with a stand-in for each character without a shape."""
    text = data.decode()
    if not text.isprintable():  # nearly never
        odd = (character for character in set(text) if not character.isprintable())
        text = text.translate({ord(one): visible(one) for one in odd})
    elif "\\u00" not in text and not any(f"\\{letter}" in text for letter in _PICTURES):
        return data
    return _ESCAPED.sub(_picture, text).encode()


def _picture(found: re.Match[str]) -> str:
    if found[1]:
        return visible(chr(int(found[1], 16)))
    control = _PICTURES.get(found[0][1])
    return found[0] if control is None else visible(control)
