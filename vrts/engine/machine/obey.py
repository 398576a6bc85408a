"""What the machine does when it is given a command."""

from vrts.engine.code.executable import Executable
from vrts.engine.code.steps.setting_steps import change_monitor_speed
from vrts.engine.faults import RuntimeFault
from vrts.engine.hand.tidying import put_back, take_away
from vrts.engine.machine.ending import abort as abort_robot
from vrts.engine.machine.ending import end
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import UNDEFINED, Array, cells_of
from vrts.engine.memory.events import CommandRefused, SignalChanged
from vrts.engine.memory.records import Ending
from vrts.engine.motion.requests import to_joints, to_line
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import (
    abort,
    after_step,
    begin,
    end_later,
    go_on,
    note_progress,
    tell,
)
from vrts.engine.programs.outside import as_known
from vrts.engine.programs.signals import known
from vrts.ir import commands as k
from vrts.ir.instructions import Interpolation
from vrts.ir.module import Module

RESUMABLE = (Ending.PAUSED, Ending.ABORTED, Ending.STEPPED, Ending.ERROR, Ending.LIMIT)


class _Refused(Exception):  # noqa: N818 -- names the situation
    """A command cannot be carried out now; the argument is VAL's words."""


EXECUTING = "Illegal when program executing"
NOT_EXECUTING = "No program is executing"
UNKNOWN = "Undefined program or variable name"
CANNOT_PROCEED = "Program cannot be resumed"


def obey(command: k.Command, machine: Machine, now: float) -> None:
    """Carry a command out at a tick."""
    try:
        _obey(command, machine, now)
    except _Refused as refusal:
        machine.system.events.append(CommandRefused(now, str(refusal)))
    except RuntimeFault as fault:
        machine.system.events.append(CommandRefused(now, fault.words))


def _obey(command: k.Command, machine: Machine, now: float) -> None:
    robot, process, system = machine.robot, machine.process, machine.system
    match command:
        case k.Execute(program=program, cycles=cycles, step=step):
            _needs_idle(robot)
            _start(machine, robot, program, cycles, step, now)
        case k.StartProcess(program=program, cycles=cycles, step=step):
            if process.running:
                raise _Refused("Process control program executing")
            _start(machine, process, program or process.program, cycles, step, now)
        case k.Abort():
            _needs_running(robot)
            abort_robot(machine, robot)
        case k.Panic():
            _panic(machine)
        case k.Proceed():
            _resume(machine, robot, now, retry=False)
        case k.Retry():
            _resume(machine, robot, now, retry=True)
        case k.RunSteps(steps=count, over_calls=over):
            _resume(machine, robot, now, retry=robot.ending is Ending.ERROR)
            robot.steps_left = (max(count, 1), len(robot.frames) if over else None)
        case k.EndCycle():
            _needs_running(robot)
            end_later(robot, on=True)
        case k.Kill():
            _needs_idle(robot)
            robot.clear()
            robot.ending = Ending.NOT_STARTED
            note_progress(robot)
        case k.Do(module=module):
            _needs_idle(robot)
            _do(machine, module, now)
        case k.AbortProcess():
            _needs_running(process)
            abort(process, now)
        case k.EndProcess(on=on):
            end_later(process, on=on)
        case k.ProceedProcess():
            _resume(machine, process, now, retry=False)
        case k.RetryProcess():
            _resume(machine, process, now, retry=True)
        case k.MonitorSpeed(percent=percent):
            change_monitor_speed(robot, percent, None)
        case k.Answer(text=text):
            system.answers.append(text)
        case k.ForceSignals(signals=signals):
            for number in signals:
                known(number, None)
                on = number > 0
                if number and system.signals.turn(abs(number), on=on):
                    system.events.append(SignalChanged(now, abs(number), on, None))
        case k.SetVariable(name=name, subscripts=subscripts, value=value):
            cell = machine.executable.layout.variable(system.memory, name, subscripts)
            cell.assign(UNDEFINED if value is None else value, machine.finished)
            machine.tell_memory()
        case k.SetLocal(process=of_process):
            _set_local(machine, process if of_process else robot, command)
        case k.GoTo(step=step, process=of_process):
            _go_to(machine, process if of_process else robot, step, now)
        case k.DeleteVariables(names=names):
            for name in names:
                _forget(machine, name)
        case k.Load(module=module):
            _load(machine, module)
        case k.DeletePrograms(names=names):
            _delete(machine, names)
        case k.PutBack():
            put_back(system.hand, now, system.events)
        case k.TakeAway():
            take_away(system.hand, now, system.events)


def _needs_idle(c: Context) -> None:
    if c.running:
        raise _Refused(EXECUTING)


def _needs_running(c: Context) -> None:
    if not c.running:
        raise _Refused(NOT_EXECUTING)


def _start(machine: Machine, c: Context, program: str, cycles: int, step: int, now: float) -> None:
    if program not in machine.system.programs.numbers:
        raise _Refused(UNKNOWN)
    c.finished = machine.finished
    begin(c, program, cycles, step, now)
    if c.is_robot:
        machine.started_s, machine.ended_s = now, None


def _resume(machine: Machine, c: Context, now: float, *, retry: bool) -> None:
    if c.running:
        raise _Refused(EXECUTING)
    c.finished = machine.finished
    if not retry and go_on(c, now):
        if c.is_robot:
            machine.ended_s = None
        return
    if not c.frames or c.ending not in RESUMABLE:
        raise _Refused(CANNOT_PROCEED)
    if not retry and (c.ending is Ending.ERROR or c.step_was_cut):  # go on with the next step
        frame = c.frames[-1]
        program = machine.system.programs.loaded[frame.program].program
        frame.index = after_step(program, frame.index)
    c.now = now
    for watch in c.watches:  # what changed meanwhile is lost
        watch.state = as_known(c.signals.on, watch.signal)
    if retry and c.is_robot and c.ending is Ending.ABORTED and not c.step_was_cut:
        _repeat_motion(machine)
    c.ending, c.wake, c.steps_left, c.step_was_cut = Ending.RUNNING, now, None, False
    note_progress(c)
    if c.is_robot:
        machine.ended_s = None


def _do(machine: Machine, module: Module, now: float) -> None:
    """Execute an instruction beside the program that stopped, which keeps its place."""
    name = next(iter(module.programs))
    depth = machine.scenario.limits.call_depth
    machine.take_over(Executable(Module(module.programs, ()), depth, machine.executable))
    machine.executable.layout.extend(machine.system.memory)
    machine.tell_memory()
    robot = machine.robot
    machine.stopped = robot.stop() if robot.frames else None
    robot.finished = machine.finished
    planner, next_hand = machine.system.planner, robot.next_hand
    settings = planner.settings
    begin(robot, name, 1, 1, now)
    robot.at_once = True
    planner.settings, robot.next_hand = settings, next_hand
    planner.tell_settings()
    machine.ended_s = None


def _load(machine: Machine, module: Module) -> None:
    busy = {
        machine.system.programs.loaded[frame.program].program.name
        for c in (machine.robot, machine.process)
        if c.running
        for frame in c.frames
    }
    if busy & set(module.programs):
        raise _Refused(EXECUTING)
    depth, memory = machine.scenario.limits.call_depth, machine.system.memory
    machine.take_over(Executable(module, depth, machine.executable))
    machine.executable.layout.extend(memory)
    machine.executable.load(module, memory, machine.finished)
    machine.tell_memory()


def _delete(machine: Machine, names: tuple[str, ...]) -> None:
    programs = machine.system.programs
    if not machine.process.running:  # where it stopped is forgotten
        machine.process.clear()
        tell(machine.process)
    used = {
        programs.loaded[frame.program].program.name
        for c in (machine.robot, machine.process)
        for frame in c.frames
    }
    if used & set(names):
        raise _Refused("Program is in use")
    if any(name not in programs.numbers for name in names):
        raise _Refused(UNKNOWN)
    machine.take_over(machine.executable.without(names))


def _panic(machine: Machine) -> None:
    """Stop both programs and the arm."""
    planner = machine.system.planner
    if machine.process.running:
        end(machine, machine.process, Ending.ABORTED, None)
    if machine.robot.running:
        end(machine, machine.robot, Ending.ABORTED, None)
    else:
        planner.brake(machine.now)
        machine.system.hand.path_changed(machine.now)


def _repeat_motion(machine: Machine) -> None:
    """Give the motion that was cut once more, as RETRY does."""
    planner = machine.system.planner
    motions = planner.given.motions
    if not motions or not motions[-1].cut:
        return
    cut = motions[-1]
    settings = planner.settings.always
    if cut.interpolation is Interpolation.LINEAR:
        intent = to_line(planner.stance, planner.destination, settings, cut.speed_fraction, None)
    else:
        intent = to_joints(planner.stance, planner.dest, settings, cut.speed_fraction, None)
    start = max(machine.robot.after(1), planner.free_at)
    planner.begin(intent, start, planner.destination, cut.cause)


def _set_local(machine: Machine, c: Context, command: k.SetLocal) -> None:
    if not c.frames:
        raise _Refused(NOT_EXECUTING)
    frame = c.frames[-1]
    program = machine.system.programs.loaded[frame.program].program
    names = [slot.name for slot in (*program.formals, *program.autos)]
    if command.name not in names:
        raise _Refused(UNKNOWN)
    bound = frame.slots[names.index(command.name)]
    if isinstance(bound, Array) != bool(command.subscripts):
        raise _Refused(UNKNOWN)
    made = machine.finished
    cell = bound.element(command.subscripts, made) if isinstance(bound, Array) else bound
    cell.assign(UNDEFINED if command.value is None else command.value, machine.finished)


def _go_to(machine: Machine, c: Context, step: int, now: float) -> None:
    if not c.frames:
        raise _Refused(NOT_EXECUTING)
    frame = c.frames[-1]
    steps = machine.system.programs.loaded[frame.program].program.steps
    if not 1 <= step <= len(steps):
        raise _Refused(UNKNOWN)
    frame.index = steps[step - 1]
    c.phase, c.operands, c.fault = 0, None, None
    c.wake = now
    tell(c)


def _forget(machine: Machine, name: str) -> None:
    """Delete a variable, or all elements of an array."""
    bound = machine.executable.layout.bound(machine.system.memory, name)
    if bound is not None:
        for cell in cells_of(bound):
            cell.assign(UNDEFINED, machine.finished)
