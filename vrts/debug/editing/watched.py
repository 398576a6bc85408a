"""The state with which a machine compares later ones, told in numbers of other programs."""

from collections.abc import Callable
from typing import Any, cast

from vrts.debug.editing.retelling import Retelling
from vrts.engine.code.executable import Executable
from vrts.engine.machine.forever.idle import idle
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.watcher import Kept
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Content, cells_of

_FRAME = 4  # parts of a frame in a state: kind, counts, what slots hold, loops


def watch_on(
    machine: Machine,
    before: Executable,
    after: Executable,
    tell: Retelling,
    place: Callable[[int], int],
) -> None:
    """Let a machine that has other programs watch for states that come again.

    Args:
        machine: The machine, whose memory is that of the new programs already.
        before: The old programs.
        after: The new ones.
        tell: What is told of places, of the new text.
        place: Of an instruction of the old ones by number: that of the new ones.
    """
    watcher = machine.watcher
    unread = idle(after)
    watcher.idle = (after, unread)
    kept = watcher.kept
    if kept is None:
        return
    names = before.layout.names
    numbers = {k: after.layout.numbers.get(name, -1) for k, name in enumerate(names)}

    def there(known: Any) -> tuple[Any, ...]:
        """Return where a program is: how it goes, and the instruction of each frame."""
        *how, stack = known
        mine, theirs = before.programs.loaded, after.programs.loaded
        found: list[tuple[int, int]] = []
        for program, index in cast("tuple[tuple[int, int], ...]", stack):
            to = place(mine[program].base + index) - theirs[program].base
            found.append((program, to))
        return (*how, tuple(found))

    def state(known: Any) -> tuple[Any, ...]:
        first, *rest = tell.of(known)
        return (there(first), *(_held(part, numbers) for part in rest))

    robot, process = kept.places
    watcher.kept = Kept(
        (there(robot), there(process)),
        state(kept.robot),
        state(kept.process),
        kept.arm,
        kept.outside,
        kept.signals,
        tuple(
            () if k in unread else _contents(item, kept.finished)
            for k, item in enumerate(machine.system.memory.bound)
        ),
        *kept[7:],
    )


def _held(part: Any, numbers: dict[int, int]) -> Any:
    """Return a part of a state; frames tell which global variable a slot stands for."""
    if not isinstance(part, tuple) or not part or not _is_frame(part[0]):
        return part  # pyright: ignore[reportUnknownVariableType]
    frames = cast("Any", part)
    return tuple(
        (kind, counts, tuple(((numbers.get(k, k), n), value) for (k, n), value in held), inside)
        for kind, counts, held, inside in frames
    )


def _is_frame(part: Any) -> bool:
    return isinstance(part, tuple) and len(part) == _FRAME and isinstance(part[3], tuple)  # pyright: ignore[reportUnknownArgumentType]


def _contents(bound: Bound, finished: int) -> tuple[Content, ...]:
    """Return what a variable held after so many statements, as states hold it."""
    if not isinstance(bound, Array):
        return (bound.at(finished),)
    held = [cell.at(finished) for cell in cells_of(bound)]
    while held and held[-1] is UNDEFINED:
        held.pop()
    return tuple(held)
