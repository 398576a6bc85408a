"""What every student handed in, one after the other: from the table of the intake."""

from collections.abc import Mapping

from vrts.desk.told import Attempt
from vrts.marking.intake.tables.intake_table import UNKNOWN_TIME
from vrts.marking.intake.tables.table_text import read_text, table
from vrts.marking.layout import Layout
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused

LARGEST = 64_000_000  # bytes of the table


def read_attempts(layout: Layout) -> Mapping[str, tuple[Attempt, ...]]:
    """Return by id the hand-ins of those who have several; marks are not known of them.

    A table that people have edited may be any: what cannot be read of it tells nothing.
    """
    place = layout.intake
    try:
        if not place.is_file() or place.stat().st_size > LARGEST:
            return {}
        lines = table(read_text(read_bytes(place), place.name), ("id", "attempts"))
    except (OSError, CannotRead, Refused):  # marking again tells what is wrong with it
        return {}
    heads = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    if "id" not in heads or "attempts" not in heads:
        return {}
    name, several = heads.index("id"), heads.index("attempts")
    found: dict[str, tuple[Attempt, ...]] = {}
    for line in lines[1:]:
        if len(line) > max(name, several) and line[several].text.strip():
            told = (_attempt(text) for text in line[several].text.splitlines() if text.strip())
            found[line[name].text.strip()] = tuple(told)
    return found


def _attempt(text: str) -> Attempt:
    at, _, file = text.strip().partition(" ")
    return Attempt(None if at == UNKNOWN_TIME else at, None, file)
