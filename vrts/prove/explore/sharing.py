"""Whether it may matter which of two programs goes on first in a tick.

It does not where neither changes anything that the other looks at or changes. That is told from
their texts, rather too often than too seldom.
"""

from collections.abc import Iterable, Iterator

from vrts.engine.code.values.operands import number_of
from vrts.engine.machine.forever.nodes import tops
from vrts.engine.machine.forever.touches import Changes, Looks, changes_of, looks_of, passed
from vrts.ir import instructions as ir
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Module

STOPS = (ir.AbortProcess, ir.EndProcess)


def may_differ(module: Module, entry: str) -> bool:
    """Return whether the order of the turns of two programs may make a difference.

    Args:
        module: The programs.
        entry: The robot program; process control programs are those that it begins.
    """
    robot = _reached(module, (entry,))
    begun = [one for _, _, one in _of(module, robot) if isinstance(one, ir.StartProcess)]
    if not begun:
        return False
    names = [one.program for one in begun]
    known = [name for name in names if name is not None]
    process = _reached(module, known if len(known) == len(names) else module.programs)
    return (
        _begins_again(module, robot, entry)
        or any(isinstance(one, STOPS) for _, _, one in _of(module, robot))
        or _share(module, robot, process)
    )


def _share(module: Module, robot: frozenset[str], process: frozenset[str]) -> bool:
    aliases = passed(module)
    r_code, p_code = (tuple(one for _, _, one in _of(module, names)) for names in (robot, process))
    r_changes, p_changes = changes_of(r_code, aliases), changes_of(p_code, aliases)
    r_looks, p_looks = _looks(r_code, aliases), _looks(p_code, aliases)
    return (
        r_changes.touch(p_looks)
        or p_changes.touch(r_looks)
        or _both(r_changes, p_changes)
        or p_looks.arm
        or any(isinstance(one, ir.AssignHere) for one in p_code)
        or p_changes.arm
        or r_looks.other
        or p_looks.other
        or (r_looks.clock and p_looks.clock)
        or _sets_timers(r_code, p_looks)
        or _sets_timers(p_code, r_looks)
    )


def _both(one: Changes, other: Changes) -> bool:
    return (
        bool(one.names & other.names)
        or bool(one.signals & other.signals)
        or (one.any_signal and (other.any_signal or bool(other.signals)))
        or (other.any_signal and bool(one.signals))
    )


def _looks(code: tuple[ir.Instruction, ...], aliases: frozenset[str]) -> Looks:
    """Return what instructions look at, signals of reactions included."""
    found = looks_of((top for one in code for top in tops(one)), aliases)
    watched = [number_of(one.signal) for one in code if isinstance(one, ir.React)]
    signals = found.signals.union(abs(number) for number in watched if number is not None)
    return found._replace(signals=signals, any_signal=found.any_signal or None in watched)


def _sets_timers(code: Iterable[ir.Instruction], looks: Looks) -> bool:
    return looks.clock and any(isinstance(one, ir.SetTimer) for one in code)


def _begins_again(module: Module, robot: frozenset[str], entry: str) -> bool:
    """Return whether PCEXECUTE may come while the process control program still executes."""
    places = [
        (name, at) for name, at, one in _of(module, robot) if isinstance(one, ir.StartProcess)
    ]
    ((name, at), *others) = places
    if others or name != entry:
        return True
    code = module.programs[entry].instructions
    back = (target for k in range(at, len(code)) for target in jumps_of(code[k]) if target <= at)
    called = any(
        isinstance(one, ir.CallNamed) or (isinstance(one, ir.Call) and one.program == entry)
        for _, _, one in _of(module, robot)
    )
    return called or any(True for _ in back)


def _reached(module: Module, names: Iterable[str]) -> frozenset[str]:
    """Return programs and those that they may come to."""
    found: set[str] = set()
    left = list(names)
    while left:
        name = left.pop()
        if name in found or name not in module.programs:
            continue
        found.add(name)
        for one in module.programs[name].instructions:
            if isinstance(one, ir.CallNamed):
                return frozenset(module.programs)
            if isinstance(one, ir.Call | ir.React | ir.ReactError):
                called = one.program
                left += [called] if called is not None else []
    return frozenset(found)


def _of(module: Module, names: Iterable[str]) -> Iterator[tuple[str, int, ir.Instruction]]:
    """Yield the instructions of programs: program, index, instruction."""
    for name in sorted(names):
        for at, one in enumerate(module.programs[name].instructions):
            yield name, at, one
