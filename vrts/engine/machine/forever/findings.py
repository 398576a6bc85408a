"""What to say of a program that never ends."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.faults import NO_ANSWER, WAIT_NEVER_ENDS
from vrts.engine.machine.forever.blame import MOST, things, waits, why_never
from vrts.engine.machine.forever.repeats import Repetition, executed, instructions
from vrts.engine.machine.forever.touches import changes_of, looks_of, passed
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Cause
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import place
from vrts.engine.programs.signals import INPUTS
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression, Place

ENDLESS = Rule("V503", "endless-loop")
NOT_JUDGED = Rule("V505", "end-not-judged")

MOST_LOOKED_AT = 5000  # statements that are gone through for the steps of a loop


def stuck(machine: Machine, now: float, since: str = "", why: tuple[str, ...] = ()) -> Diagnostic:
    """Return what is wrong with a robot program that waits for something that never comes.

    Args:
        machine: The machine.
        now: Time of the tick [s].
        since: What goes on all the same; by default nothing.
        why: Who waits for whom.
    """
    c = machine.robot
    cause = _cause(c)
    since = since or f"nothing changes any more from {now:.3f} s on"
    if isinstance(_instruction(c), ir.Prompt):
        return Diagnostic(
            NO_ANSWER,
            Severity.ERROR,
            "this PROMPT waits for an answer that nobody gives",
            Label(cause.span),
            notes=(f"asked at {now:.3f} s, after {c.system.answers_read} answers",),
            help=("script the answers in a scenario: `[prompts]`, `answers = [...]`",),
        )
    return Diagnostic(
        WAIT_NEVER_ENDS,
        Severity.ERROR,
        "this WAIT never ends: nothing that is still to happen makes it true",
        Label(cause.span),
        notes=(*why, since),
        help=("wait for a signal that the scenario turns on, or set it in the program",),
    )


def goes_on(machine: Machine, now: float) -> str:
    """Return what the other program does while the robot program waits for ever."""
    name = machine.process.program
    if not machine.process.running:
        return f"nothing changes any more from {now:.3f} s on"
    return f"`{name}` goes on from {now:.3f} s on, but changes nothing that is waited for"


def repeated(machine: Machine, found: Repetition) -> Diagnostic:
    """Return what is wrong with a robot program whose state has come again."""
    if not found.round and isinstance(_instruction(machine.robot), ir.Wait | ir.Prompt):
        since = _other_round(machine, found)
        return stuck(machine, found.kept.time_s, since, waits(machine, machine.robot))
    cause = _cause(machine.robot)
    kept, now = found.kept, found.now_s
    period = now - kept.time_s
    steps = _steps(machine, found.round)
    everything = "everything that matters to it" if found.alone else "everything"
    return Diagnostic(
        ENDLESS,
        Severity.ERROR,
        "this loop never ends: it repeats its state",
        Label(cause.span, "reached again and again"),
        notes=(
            (
                f"from {kept.time_s:.3f} s to {now:.3f} s steps {steps} were executed,"
                f" and {everything} is as it was {period:.3f} s before"
            ),
            *_looked_at(machine, found),
        ),
        help=("change something in the loop that its condition depends on",),
        data={"period_s": round(period, 3), "since_s": round(kept.time_s, 3)},
    )


def not_judged(machine: Machine) -> Diagnostic:
    """Return that nobody knows whether the program ends: the judgement itself has failed."""
    cause = place(machine.robot)
    return Diagnostic(
        NOT_JUDGED,
        Severity.WARNING,
        "whether this program ever ends is undetermined: vrts failed to judge it",
        Label(cause.span) if cause is not None else None,
        notes=(
            "the program goes on to its end, or to the limits of the run",
            f"this is a fault in vrts: {machine.watcher.broken}",
        ),
        help=("report it, with the program and the scenario",),
    )


def _other_round(machine: Machine, found: Repetition) -> str:
    """Return which steps the other program goes through again and again, if it does."""
    process = machine.process
    passes = executed(machine, process, found.kept.finished)
    since = found.kept.time_s
    if not process.running or not passes:
        return f"nothing changes any more from {since:.3f} s on"
    steps = _steps(machine, passes)
    return f"from {since:.3f} s on `{process.program}` repeats steps {steps} again and again"


def _looked_at(machine: Machine, found: Repetition) -> tuple[str, ...]:
    """Return for what a loop looks at and does not change itself who could change it."""
    c = machine.robot
    code = instructions(machine, found.round)
    aliases = passed(machine.executable.module)
    tested = [node for one in code for node in _conditions(one)]
    own = changes_of(code, aliases)
    asked = [
        thing
        for thing in things(looks_of(tested, aliases))
        if not own.touch(thing.looks) and (machine.process.program or thing.signal in INPUTS)
    ]
    return tuple(f"it looks at {one.words}; {why_never(machine, c, one)}" for one in asked[:MOST])


def _conditions(instruction: ir.Instruction) -> tuple[Expression | Place, ...]:
    match instruction:
        case ir.JumpIf(condition=condition):
            return (condition,)
        case ir.TestFor(place=place):
            return (place,)
        case ir.BeginCase(selector=selector):
            return (selector,)
        case ir.Wait(condition=condition) if condition is not None:
            return (condition,)
        case _:
            return ()


def _instruction(c: Context) -> ir.Instruction | None:
    if not c.frames:
        return None
    frame = c.frames[-1]
    return c.system.programs.loaded[frame.program].program.instructions[frame.index]


def _cause(c: Context) -> Cause:
    cause = place(c)
    assert cause is not None
    return cause


def _steps(machine: Machine, passes: tuple[int, ...]) -> str:
    """Return which steps a program executed, by the numbers of its instructions."""
    causes = machine.system.programs.causes
    steps = sorted({causes[k].step for k in passes[-MOST_LOOKED_AT:]})
    return f"{steps[0]} to {steps[-1]}" if len(steps) > 1 else str(steps[0])
