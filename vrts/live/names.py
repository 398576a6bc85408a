"""Names and texts that people give themselves and one another."""

import unicodedata
from collections.abc import Container

from vrts.report.plain import one_line, visible

LONGEST = 40


def display_name(given: str, taken: Container[str] = ()) -> str:
    """Return a name that can be shown: visible characters only, and nobody else's.

    Empty when nothing of it can be shown.
    """
    name = one_line(unicodedata.normalize("NFKC", given))[:LONGEST].strip()
    if not any(character.isalnum() for character in name):
        return ""
    if name not in taken:
        return name
    number = 2
    while f"{name} ({number})" in taken:
        number += 1
    return f"{name} ({number})"


def readable(text: str) -> str:
    """Return a text of somebody as others are shown it: every character visible."""
    return visible(unicodedata.normalize("NFC", text)).strip()
