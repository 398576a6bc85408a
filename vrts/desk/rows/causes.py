"""By what points were lost, so that all who lost the same by the same can be dealt with at once.

Losses have one cause where kind, points and sentence are the same, but for when and in which line
it was, and for numbers: who lets a can go 19 mm above its base did what who lets go at 21 mm did.
"""

import re
from collections.abc import Iterable
from hashlib import sha256

from vrts.desk.book.book import found_out
from vrts.desk.told import CauseTold
from vrts.marking.result import Loss, Result
from vrts.marking.row import Row

_WHERE = re.compile(r"^(?:at \d[\d.]* s, )?(?:line \d+(?: `[^`]*`)?, )?", re.IGNORECASE)
_PARTS = re.compile(r"(`[^`]*`)|\d+(?:\.\d+)?")  # names stay as they are
_LONGEST = 400  # characters of a sentence
_KEY = 12  # digits


def cause_key(loss: Loss) -> str:
    """Return a short name of the cause of a loss."""
    return sha256(f"{loss.kind}\n{loss.points_exact}\n{_same(loss)}".encode()).hexdigest()[:_KEY]


def keys_of(result: Result) -> tuple[str, ...]:
    """Return the causes of all losses of a result, each once."""
    return tuple(dict.fromkeys(map(cause_key, result.losses)))


def causes_of(rows: Iterable[Row]) -> tuple[CauseTold, ...]:
    """Return every cause with whom it cost points, those of most rows first."""
    found: dict[str, tuple[Loss, str, dict[str, None]]] = {}
    for row in rows:
        for loss in found_out(row).losses:
            key = cause_key(loss)
            if key not in found:
                found[key] = loss, _check(found_out(row), loss), {}
            found[key][2][row.id] = None
    told = [
        CauseTold(key, loss.kind, check, _same(loss), loss.points, len(who), tuple(who))
        for key, (loss, check, who) in found.items()
    ]
    return tuple(sorted(told, key=lambda one: (-one.count, -one.points, one.key)))


def _same(loss: Loss) -> str:
    said = _WHERE.sub("", loss.sentence[:_LONGEST])
    return _PARTS.sub(lambda match: match[1] or "…", said)


def _check(result: Result, loss: Loss) -> str:
    """Return the check that a loss is about; "" where that is not one alone."""
    fits = [one.id for one in result.checks if one.kind == loss.kind and one.answer != "holds"]
    return fits[0] if len(fits) == 1 else ""
