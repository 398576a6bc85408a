"""Names of rooms, and texts; names of people are in `people`."""

import unicodedata

from vrts.report.plain import one_line, visible

LONGEST = 40


def display_name(given: str) -> str:
    """Return a name that can be shown: visible characters only.

    Empty when nothing of it can be shown.
    """
    name = one_line(unicodedata.normalize("NFKC", given))[:LONGEST].strip()
    return name if any(character.isalnum() for character in name) else ""


def readable(text: str) -> str:
    """Return a text of somebody as others are shown it: every character visible."""
    return visible(unicodedata.normalize("NFC", text)).strip()
