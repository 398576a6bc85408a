"""What pure functions gave, remembered while the same is asked for again and again.

Nothing is remembered unless somebody says where: `with memory.in_use(): ...`. What comes out is
the same with it and without, but for the time that it takes, and the sign of a zero.
"""

from collections import OrderedDict
from collections.abc import Callable, Generator, Hashable
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar, cast

MOST = 6000  # results kept: those that were asked for last

T = TypeVar("T")


class Memory:
    """What functions gave while it was in use."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self.kept: OrderedDict[Hashable, tuple[object, object]] = OrderedDict()

    @contextmanager
    def in_use(self) -> Generator[None]:
        """Let functions look here first, until the block ends."""
        token = _memory.set(self)
        try:
            yield
        finally:
            _memory.reset(token)


_memory: ContextVar[Memory | None] = ContextVar("memory", default=None)


def is_remembering() -> bool:
    """Return whether it is worth making a key."""
    return _memory.get() is not None


def remembered(
    key: Hashable,
    make: Callable[[], T],
    *,
    alive: object = None,
    worth: Callable[[T], bool] = lambda _: True,
) -> T:
    """Return what was made for a key before, else make it.

    Args:
        key: All that the result depends on.
        make: Makes it.
        alive: What the key names by its address: kept as long as the result is.
        worth: Whether a result may be given again: one that its user changes may not.
    """
    memory = _memory.get()
    if memory is None:
        return make()
    kept = memory.kept
    found = kept.get(key)
    if found is not None:
        kept.move_to_end(key)
        return cast("T", found[0])
    made = make()
    if worth(made):
        kept[key] = (made, alive)
        if len(kept) > MOST:
            kept.popitem(last=False)
    return made
