"""By what points were lost, so that all who lost the same by the same can be dealt with at once.

Losses have one cause where kind, points and sentence are the same, but for when and in which line
it was, and for numbers: who lets a can go 19 mm above its base did what who lets go at 21 mm did.
Points for speed, which are lost by whoever has lost anything else, are a consequence: of no use to
tell programs apart, and behind all others.
"""

import re
from collections.abc import Iterable
from hashlib import sha256

from vrts.desk.book.book import found_out
from vrts.desk.told import CauseTold
from vrts.marking.result import Loss, Result
from vrts.marking.row import Row

SPEED = "time"  # kind of the loss
_WHERE = re.compile(r"^(?:at \d[\d.]* s, )?(?:line \d+(?: `[^`]*`)?, )?", re.IGNORECASE)
_PARTS = re.compile(r"(`[^`]*`)|\d+(?:\.\d+)?")  # names stay as they are
_LONGEST = 400  # characters of a sentence
_KEY = 12  # digits


def cause_key(loss: Loss) -> str:
    """Return a short name of the cause of a loss."""
    same = f"{loss.kind}\n{loss.points_exact}\n{same_words(loss)}"
    return sha256(same.encode()).hexdigest()[:_KEY]


def keys_of(result: Result) -> tuple[str, ...]:
    """Return the causes of all losses of a result, each once: those that cost most first."""
    return tuple(dict.fromkeys(map(cause_key, weighed(result))))


def weighed(result: Result) -> list[Loss]:
    """Return the losses of a result, those that cost most first, and what follows from others last.

    What costs the same stays in the order of the result.
    """
    return sorted(result.losses, key=lambda loss: (_follows(loss, result), -abs(loss.points)))


def causes_of(rows: Iterable[Row]) -> tuple[CauseTold, ...]:
    """Return every cause with whom it cost points: those of most rows first, consequences last."""
    found: dict[str, tuple[Loss, str, dict[str, None]]] = {}
    own: set[str] = set()  # causes that are no consequence, at least in one row
    for row in rows:
        result = found_out(row)
        for loss in result.losses:
            key = cause_key(loss)
            if key not in found:
                found[key] = loss, _check(result, loss), {}
            found[key][2][row.id] = None
            if not _follows(loss, result):
                own.add(key)
    told = [
        CauseTold(key, loss.kind, check, same_words(loss), loss.points, len(who), tuple(who))
        for key, (loss, check, who) in found.items()
    ]
    return tuple(
        sorted(told, key=lambda one: (one.key not in own, -one.count, -one.points, one.key))
    )


def same_words(loss: Loss) -> str:
    """Return the sentence of a loss without what differs among those who lost by the same."""
    return same_sentence(loss.sentence)


def same_sentence(sentence: str) -> str:
    """Return a sentence about a loss without time, line and numbers; names stay."""
    said = _WHERE.sub("", sentence[:_LONGEST])
    return _PARTS.sub(lambda match: match[1] or "…", said)


def _follows(loss: Loss, result: Result) -> bool:
    """Return whether points were lost because others were: those for speed."""
    return loss.kind == SPEED and any(other.kind != SPEED for other in result.losses)


def _check(result: Result, loss: Loss) -> str:
    """Return the check that a loss is about; "" where that is not one alone."""
    fits = [one.id for one in result.checks if one.kind == loss.kind and one.answer != "holds"]
    return fits[0] if len(fits) == 1 else ""
