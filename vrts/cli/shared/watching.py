"""Waits until files change, by looking at them again and again."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeAlias

LOOK_EVERY_S = 0.3

Look: TypeAlias = Callable[[Path], bytes | None]  # the bytes of a file; None: not there


def look(path: Path) -> bytes | None:
    """Return the bytes of a file; None while it is not there, as editors make it for a moment."""
    try:
        return path.read_bytes()
    except OSError:
        return None


def watch(
    paths: Sequence[Path],
    redraw: Callable[[], None],
    *,
    clock: Callable[[], float],
    sleep: Callable[[float], None],
    until: float | None = None,
    seen: Look = look,
) -> int:
    """Call `redraw` once, and again whenever a file has other bytes.

    Args:
        paths: The files.
        redraw: Told that something is new.
        clock: Tells the time [s].
        sleep: Waits for some time [s].
        until: When to end [s]; None: never.
        seen: Looks at a file.

    Returns:
        How often was drawn.
    """
    before = [seen(path) for path in paths]
    redraw()
    drawn = 1
    while until is None or clock() < until:
        sleep(LOOK_EVERY_S)
        now = [seen(path) for path in paths]
        if now != before and None not in now:
            before = now
            redraw()
            drawn += 1
    return drawn
