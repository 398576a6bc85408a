"""Programs begin, go through their cycles and end, the robot program as the other one."""

from vrts.engine.memory.events import Cause, ProgramEnded, ProgramProgressed, ProgramStarted
from vrts.engine.memory.facts import Executed
from vrts.engine.memory.records import Ending
from vrts.engine.motion.settings import InForce
from vrts.engine.programs.context import Context
from vrts.ir.module import Program


def begin(c: Context, name: str, cycles: int, step: int, now: float) -> None:
    """Begin a program at a step of its first cycle."""
    c.now = now
    c.program = name
    c.cycles_left, c.cycles_done = cycles or 1, 0
    c.started_s, c.ending = now, Ending.RUNNING
    c.steps_left = None
    c.finishing = c.at_once = False
    c.clear()
    _begin_cycle(c, step)
    c.wake = now
    c.events.append(ProgramStarted(now, name, process=not c.is_robot))
    note_progress(c)


def tell(c: Context) -> None:
    """Note what a program tells others of itself, where that changes."""
    facts, error = c.system.facts, c.last_error
    if facts is not None:
        kept = bool(c.frames) and c.ending is not Ending.COMPLETED
        number = 0 if error is None else error.number
        told = Executed(c.program, c.running, kept, c.priority, number)
        facts.executes(told, robot=c.is_robot)


def note_blocked(c: Context, now: float, number: int) -> None:
    """Note that a program is blocked amid a step.

    Args:
        c: The program.
        now: Time of the tick [s].
        number: Statements that will be finished when that step is.
    """
    facts = c.system.facts
    if facts is not None:
        wakes = facts.robot_wakes if c.is_robot else facts.process_wakes
        wakes.note(now, number, c.wake)


def note_progress(c: Context, time_s: float | None = None) -> None:
    """Note cycles and priority of a program, where they change; by default now."""
    tell(c)
    c.events.append(
        ProgramProgressed(
            c.now if time_s is None else time_s,
            c.program,
            c.cycles_done,
            c.cycles_left,
            c.priority,
            c.running,
            process=not c.is_robot,
        )
    )


def next_cycle(c: Context) -> bool:
    """End a cycle; return whether another one begins."""
    c.cycles_done += 1
    if c.cycles_left > 0:
        c.cycles_left -= 1
    frame = c.frames[-1]
    causes = c.system.programs.loaded[frame.program].causes
    c.last_step = causes[max(min(frame.index, len(causes) - 1) - 1, 0)]
    c.clear()
    if c.cycles_left != 0:
        _begin_cycle(c, 1)
    note_progress(c)
    return c.cycles_left != 0


def end(c: Context, ending: Ending, time_s: float) -> None:
    """End a program; what it waits for is forgotten, its place is kept."""
    c.ending, c.finishing = ending, False
    c.phase, c.operands, c.fault = 0, None, None
    c.steps_left = None
    c.events.append(ProgramEnded(time_s, ending.value, place(c), process=not c.is_robot))
    tell(c)


def abort(c: Context, now: float) -> None:
    """Stop a process control program where it is."""
    if c.running:
        end(c, Ending.ABORTED, now)


def end_later(c: Context, *, on: bool) -> None:
    """Let a program stop at the end of its cycle, or take that back.

    PCEND waits for the end of the cycle, PCEND -1 takes that back [assumed, manual
    language/processes#end].
    """
    if on and c.cycles_left != 1:
        c.kept_cycles, c.cycles_left = c.cycles_left, 1
    elif not on and c.kept_cycles is not None:
        c.cycles_left, c.kept_cycles = c.kept_cycles, None


def go_on(c: Context, now: float) -> bool:
    """Begin the cycles that PCEND or CYCLE.END kept; return whether there are any."""
    if c.ending is not Ending.COMPLETED or c.kept_cycles is None:
        return False
    left = c.kept_cycles - 1 if c.kept_cycles > 0 else c.kept_cycles
    if left == 0:
        return False
    c.now = c.wake = now
    c.cycles_left, c.ending = left, Ending.RUNNING
    _begin_cycle(c, 1)
    note_progress(c)
    return True


def place(c: Context) -> Cause | None:
    """Return the step that comes next, or that failed; of a program that is over its last one."""
    if not c.frames:
        return c.last_step if c.finishing else None
    frame = c.frames[-1]
    causes = c.system.programs.loaded[frame.program].causes
    return causes[min(frame.index, len(causes) - 1)]


def rest(c: Context, finished: int) -> None:
    """Note where a program rests, after a number of finished statements of both programs."""
    following = next_instruction(c)
    if following is not None:
        c.trace.rest(finished, following)


def next_instruction(c: Context) -> int | None:
    """Return the number of the instruction that comes next, of those of all programs."""
    if not c.frames:
        return None
    program = c.system.programs.loaded[c.frames[-1].program]
    return program.base + min(c.frames[-1].index, len(program.causes) - 1)


def after_step(program: Program, index: int) -> int:
    """Return the first instruction of the step after that of an instruction."""
    step = program.origins[min(index, len(program.origins) - 1)].step
    is_last = step >= len(program.steps)  # what follows is the end of the program
    return len(program.instructions) - 1 if is_last else program.steps[step]


def _begin_cycle(c: Context, step: int) -> None:
    programs = c.system.programs
    number = programs.numbers[c.program]
    c.enter(programs.frame(number))
    steps = programs.loaded[number].program.steps
    c.frames[0].index = steps[min(max(step, 1), len(steps)) - 1] if steps else 0
    c.phase, c.operands, c.fault, c.next_hand = 0, None, None, []
    c.priority, c.watches, c.error_program, c.last_error = 0, [], None, None
    c.kept_cycles = None
    if c.is_robot:
        c.planner.settings = InForce()
        c.planner.tell_settings()
    elif c.robot.phase:  # from now on somebody may ask whether it waits
        note_blocked(c.robot, c.now, c.events.counted() + 1)
