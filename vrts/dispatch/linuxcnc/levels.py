"""How deep subroutines may call one another: LinuxCNC keeps ten levels with the main one."""

import re
from collections.abc import Mapping
from functools import cache
from importlib.resources import files

from vrts.dispatch.saying.cannot import CannotSay
from vrts.ir import instructions as ir
from vrts.ir.module import Module

LIBRARY = "library"  # the folder of subroutines
LEVELS = 9  # of calls below the main program: INTERP_SUB_ROUTINE_LEVELS is 10 in 2.9
CALLED = re.compile(r"o<(v_\w+)> call")


@cache
def depths() -> Mapping[str, int]:
    """Return how many levels each subroutine of the library takes, by the texts of its files."""
    found = files("vrts.dispatch.linuxcnc").joinpath(LIBRARY).iterdir()
    texts = {source.name.removesuffix(".ngc"): source.read_text("utf-8") for source in found}
    called = {name: set(CALLED.findall(text)) for name, text in texts.items()}
    known: dict[str, int] = {}

    def depth(name: str) -> int:
        if name not in known:
            known[name] = 1 + max((depth(c) for c in called.get(name, ())), default=0)
        return known[name]

    return {name: depth(name) for name in called}


def levels(module: Module, names: list[str], entry: str) -> dict[str, int]:
    """Return at which level each program is called at most; the main one has 0.

    Args:
        module: The programs.
        names: Those that are executed, each after those that it calls.
        entry: The main one.
    """
    found = {entry: 0}
    for name in reversed(names):
        for instruction in module.programs[name].instructions:
            if isinstance(instruction, ir.Call) and instruction.program in module.programs:
                below = found.get(name, 0) + 1
                found[instruction.program] = max(found.get(instruction.program, 0), below)
    return found


def shallow(lines: list[str], level: int) -> None:
    """Refuse lines that call the library too deep.

    Raises:
        CannotSay: LinuxCNC would stop there.
    """
    called = (name for line in lines for name in CALLED.findall(line))
    deepest = max((depths().get(name, 1) for name in called), default=0)
    if level + deepest > LEVELS:
        raise CannotSay(
            f"calls are {level} deep here, this takes {deepest} more, and LinuxCNC has {LEVELS}",
            "write what the program called last does in its caller",
        )
