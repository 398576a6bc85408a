"""A place of a run as links: what opens it at a terminal, in a page, and in an editor."""

import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple
from urllib.parse import quote

from vrts.debug.marks.same import comes_to, sign_of
from vrts.debug.passages import Instant, at_time
from vrts.engine.memory.events import Cause
from vrts.engine.run import Run

_EXACT = (3, 6)  # decimals that are tried before all
OTHER = "this future comes of changes, so no link leads here: `--record FILE` keeps what you do"


class Opener(NamedTuple):
    """How a run was opened: words of a command line behind `vrts debug`."""

    words: Sequence[str]
    viewed: Sequence[str] | None  # behind `vrts view`; None: that shows something else


def time_text(time_s: float) -> str:
    """Return a time [s] as short as it can be and still be the same number."""
    shorter = (f"{time_s:.{decimals}f}" for decimals in _EXACT)
    return next((text for text in shorter if float(text) == time_s), repr(time_s))


def anchor(time_s: float) -> str:
    """Return what stands behind the address of a page to open it at a time [s], to every digit."""
    return f"#t={time_text(time_s)}"


def options_of(run: Run, instant: Instant) -> list[str]:
    """Return the options that lead to an instant: with `--step` where a time alone does not."""
    found = ["--at", time_text(instant.time_s)]
    if at_time(run, instant.time_s) != instant:
        found += ["--step", str(instant.finished)]
    return found


def links(
    opener: Opener | None, first: Run, run: Run, instant: Instant, cause: Cause | None
) -> list[str]:
    """Return what opens a place: a command, a page and its anchor, the line in an editor.

    Args:
        opener: How the run was opened; None: nobody knows.
        first: The run as it was opened.
        run: The run as it goes now.
        instant: The place.
        cause: The step there; None: there is none.
    """
    found: list[str] = []
    at = time_text(instant.time_s)
    if run is not first and not (
        comes_to(first, instant) and sign_of(first, instant) == sign_of(run, instant)
    ):
        found.append(OTHER)
    elif opener is not None:
        found.append(shlex.join(["vrts", "debug", *opener.words, *options_of(first, instant)]))
        if opener.viewed is not None:
            found.append(shlex.join(["vrts", "view", *opener.viewed, "--at", at]))
            found.append(f"{anchor(instant.time_s)} behind the address of a page of this run")
    if cause is not None and Path(cause.span.source.name).is_absolute():
        line, column = cause.span.line, cause.span.column
        found.append(f"vscode://file{quote(cause.span.source.name)}:{line}:{column}")
    return found
