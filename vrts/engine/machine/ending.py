"""How a program ends, whatever the reason, and what arm and hand do then."""

from vrts.base.diagnostic import Diagnostic
from vrts.engine.code.steps.motion_steps import CUT_SHORT
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import Ending
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import end as end_program
from vrts.engine.programs.cycles import note_progress, place, rest


def end(machine: Machine, c: Context, ending: Ending, diagnostic: Diagnostic | None) -> None:
    """End a program; after an error the arm slows down along its path."""
    planner = machine.system.planner
    if diagnostic is not None:
        c.events.append(Found(c.now, diagnostic, place(c)))
    if c.is_robot:
        if ending in (Ending.ERROR, Ending.LIMIT, Ending.ABORTED):
            planner.brake(c.now)
        else:
            planner.take_back(c.now)
        machine.system.hand.path_changed(c.now)
        machine.ended_s = max(c.now, machine.tick_of(planner.settled_at) * machine.tick)
        end_program(c, ending, machine.ended_s)
        _give_back(machine)
    else:
        end_program(c, ending, c.now)


def _give_back(machine: Machine) -> None:
    """After the monitor's DO, put the program that stopped before it back in its place."""
    if machine.stopped is None:
        return
    machine.robot.finished = machine.finished
    machine.robot.restore(machine.stopped)
    rest(machine.robot, machine.finished)
    machine.stopped = None
    note_progress(machine.robot, machine.ended_s)


def abort(machine: Machine, c: Context) -> None:
    """End a program from outside."""
    c.step_was_cut = c.phase == CUT_SHORT
    end(machine, c, Ending.ABORTED, None)


def fail(machine: Machine, c: Context, fault: RuntimeFault) -> None:
    """End a program with a run-time error at the step that it is at."""
    cause = place(c)
    assert cause is not None
    end(machine, c, Ending.ERROR, fault.diagnostic(cause.span))
