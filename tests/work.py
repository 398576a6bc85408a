"""How much work Python does in a call: counted, so that a busy machine changes nothing."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any


def work(call: Callable[[], object]) -> int:
    """Return how many lines of Python a call executes, and how many functions it calls.

    Copies that C makes of a whole list or dict count as one call: only where Python goes through
    things itself does work show.
    """
    count = 0

    def local(_frame: FrameType, event: str, _arg: Any) -> Any:
        nonlocal count
        count += event == "line"
        return local

    def called(_frame: FrameType, _event: str, _arg: Any) -> Any:
        nonlocal count
        count += 1
        return local

    before = sys.gettrace()
    sys.settrace(called)
    try:
        call()
    finally:
        sys.settrace(before)
    return count


def growth(make: Callable[[int], Callable[[], object]], size: int) -> float:
    """Return by how much the work grows when the size doubles, beyond what is there for size 0."""
    base, once, twice = (work(make(number)) for number in (0, size, 2 * size))
    return (twice - base) / (once - base)
