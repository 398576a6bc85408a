"""How somebody who waits is heard while something is worked out."""

from collections.abc import Callable
from typing import TypeAlias

Hear: TypeAlias = Callable[[], None]
"""Returns at once, or raises `Interrupted`: whoever works long calls it now and then."""


class Interrupted(Exception):  # noqa: N818 -- names the situation
    """Somebody wants no answer any more; everything is as it was."""


def nobody() -> None:
    """Hear nobody: at a terminal Ctrl-C raises KeyboardInterrupt by itself."""
