"""ENABLE and DISABLE: switches of the controller, and what turning one of them does at once."""

from vrts.engine.code.closures import SWITCHED, Step
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause, SwitchChanged
from vrts.engine.programs.context import Context
from vrts.engine.programs.locks import Wish, refused
from vrts.ir import instructions as ir
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.system import SWITCHES
from vrts.ir.taken import TAKEN_SWITCHES


def switch_step(instruction: ir.Switch, following: int, cause: Cause) -> Step:
    """Return the closure of ENABLE or DISABLE."""
    names, on = instruction.names, instruction.on

    def switch(c: Context) -> int:
        for name in names:
            known = SWITCHES.get(name)
            if name in TAKEN_SWITCHES:
                c.system.switches[name] = on
                continue
            if known is None or known.read_only:
                raise RuntimeFault(
                    RuntimeErrorKind.INVALID_SWITCH,
                    f"there is no switch `{name}`",
                    cause.span,
                    help=(f"switches are {', '.join(SWITCHES)}",),
                )
            if c.system.is_on(name) is not on and name in c.system.locks.names:
                keeps = f"it stays {'off' if on else 'on'}"
                refused(c, Wish(name, f"{'ENABLE' if on else 'DISABLE'} {name}", keeps), cause)
                continue
            if c.system.is_on(name) is not on:
                c.events.append(SwitchChanged(c.now, name, on, cause))
            c.system.switches[name] = on
            if name == "POWER":
                c.system.powered = on
                if not on:
                    c.planner.brake(c.now)
                    c.hand.path_changed(c.now)
                    c.look_again()
            elif name == "TRACE":
                c.system.tracing = on
            elif name == "DRY.RUN" and not on:
                c.planner.end_dry_run()
        c.frames[-1].index = following
        return SWITCHED  # TRACE acts from the next step on

    return switch
