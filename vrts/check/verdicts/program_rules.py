"""Whether a program keeps to `[[rule]]`: instructions that it must or must not use, and its length.

Every program of the file counts; comments do not. What must be used must be carried out, too: a
step that is never reached helps nobody.
"""

from collections.abc import Iterator
from types import MappingProxyType

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.check.task.demands import DEMAND, Demand, Keeps
from vrts.check.verdict import Answer, Verdict
from vrts.engine.run import Run
from vrts.lang.typed.written_steps import WrittenStep, written_steps

PROGRAM = Rule("V436", "program-rule")


def check_rule(run: Run, demand: Demand) -> Verdict:
    """Return the verdict on a rule about the text of the program."""
    steps = tuple(_steps(run))
    evidence = MappingProxyType({"method": "every step read", "steps": len(steps)})
    found = _broken(run, demand, steps)
    if found is None:
        return Verdict(DEMAND + demand.name, Answer.HOLDS, f"{demand.name}: kept", (), evidence)
    return Verdict(DEMAND + demand.name, Answer.VIOLATED, found.headline, (found,), evidence)


def _steps(run: Run) -> Iterator[WrittenStep]:
    """Return the steps of all programs in memory."""
    programs = run.module.programs
    for source in dict.fromkeys(program.span.source for program in programs.values()):
        yield from (step for step in written_steps(source) if step.program in programs)


def _broken(run: Run, demand: Demand, steps: tuple[WrittenStep, ...]) -> Diagnostic | None:
    where = [step for step in steps if demand.word in step.words]
    match demand.keeps:
        case Keeps.USES:
            done = _executed(run)
            if any((step.program, step.number) in done for step in where):
                return None
            headline = f"the program does not use {demand.word}"
            label, notes = None, ()
            if where:
                label = Label(where[0].span, "never reached")
                notes = ("only what is carried out counts",)
            remedy = f"the task wants {demand.word} to be used"
        case Keeps.AVOIDS:
            if not where:
                return None
            headline = f"the program uses {demand.word}"
            label, notes = Label(where[0].span, "used here"), ()
            remedy = f"the task wants another way than {demand.word}"
        case _:
            if len(steps) <= demand.limit:
                return None
            headline = f"the program has {len(steps)} steps; {demand.limit:g} are allowed"
            label, notes = None, _lengths(steps)
            remedy = "look for steps that repeat each other"
    return Diagnostic(PROGRAM, Severity.ERROR, headline, label, notes=notes, help=(remedy,))


def _executed(run: Run) -> set[tuple[str, int]]:
    """Return program and number of every step that was carried out."""
    causes = run.history.code.causes
    traces = (run.history.robot.trace, run.history.process.trace)
    known = run.statements
    done = {i for trace in traces for i in trace.instructions[: trace.executed(known)]}
    return {(causes[index].program, causes[index].step) for index in done}


def _lengths(steps: tuple[WrittenStep, ...]) -> tuple[str, ...]:
    """Return how many steps each program has, where there are several."""
    counts: dict[str, int] = {}
    for step in steps:
        counts[step.program] = counts.get(step.program, 0) + 1
    if len(counts) < 2:
        return ()
    return (", ".join(f"{count} in `{name}`" for name, count in counts.items()),)
