"""A run of another text is forked where it differs: it is as a fresh run of that text."""

from collections.abc import Iterator
from random import Random

import pytest

from tests.laws import examples
from tests.mutants.hunks import applied
from tests.mutants.mutating import KINDS, mutated
from tests.support_programs import ALONE, compiled
from tests.unit.debug.editing.programs import LONG, WAITS
from tests.unit.debug.test_debugger import TEXT
from vrts.base.source import SourceFile
from vrts.debug.editing.fork import Forked, edited
from vrts.engine.controller import AFTERWARDS, advance, execute, start
from vrts.engine.run import Run
from vrts.ir.commands import Execute, SetVariable, TimedCommand
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS

LATER = (" q = 7", ' TYPE "new"', "; note", "")


def told(run: Run) -> Iterator[str]:
    """Yield all that a run tells, byte by byte: events, states, segments, motions, its end."""
    yield from map(repr, zip(run.events, run.event_numbers, strict=True))
    for number in range(run.statements + 1):
        state = run.at_statement(number)
        seen = (sorted(state.variables.items()), sorted(state.locals.items()))
        place = (state.call_stack, state.process_stack, sorted(state.signals), state.output)
        yield repr((state.time_s, state.configuration, *seen, *place))
    yield from map(repr, run.timeline.segments)
    yield from map(repr, run.motions)
    yield repr((run.ending, run.horizon_s, run.until_s, run.statements))


def changed(text: str, chance: Random) -> Module | None:
    """Return a program with a mistake, and lines more; None where it does not compile."""
    kind, seed, is_wrong = chance.choice(list(KINDS)), chance.randrange(1000), chance.random() < 0.5
    rows = (applied(text, mutated(text, kind, seed)) if is_wrong else text).splitlines()
    for _ in range(chance.randrange(3)):
        rows.insert(chance.randrange(1, text.count("\n") - 12), chance.choice(LATER))
    found = compile_source(SourceFile("main.v2", "\n".join(rows)), Options(DIALECTS["val2+"]))
    return found.module


def same(old: Module, new: Module) -> Forked:
    found = edited(execute(old, ALONE), new, "main")
    assert list(told(found.run)) == list(told(execute(new, ALONE)))
    return found


@pytest.mark.parametrize("text", [LONG, WAITS, TEXT], ids=["long", "waits", "two programs"])
def test_it_is_as_a_fresh_run_whatever_was_changed(text: str) -> None:
    chance = Random(len(text))
    old = compiled(text, "val2+")
    for _ in range(examples(24)):
        new = changed(text, chance)
        if new is not None and new.main == "main":
            same(old, new)
            same(new, old)


def test_what_is_before_the_first_difference_is_not_executed_again() -> None:
    found = same(compiled(LONG, "val2+"), compiled(LONG.replace("z = y/w", "z = y"), "val2+"))
    before = execute(compiled(LONG, "val2+"), ALONE)
    assert found.differs is not None
    assert before.horizon_s - found.differs.time_s < 0.5
    assert before.horizon_s - found.again_s < 6.0


def test_a_comment_changes_nothing_but_the_lines_that_are_told() -> None:
    text = LONG.replace(" x = 0", "; first\n\n x  =  0")
    found = same(compiled(LONG, "val2+"), compiled(text, "val2+"))
    assert found.differs is None
    assert found.again_s > 0.0
    assert [motion.cause.span.line for motion in found.run.motions][:2] == [8, 39]


def test_a_location_counts_where_it_is_first_named() -> None:
    text = LONG.replace("last 700", "last 710")
    found = same(compiled(LONG, "val2+"), compiled(text, "val2+"))
    run = execute(compiled(LONG, "val2+"), ALONE)
    assert found.differs is not None
    cause = run.at_statement(found.differs.finished).call_stack[-1]
    assert cause.span.text == "MOVE last"
    assert found.again_s > 0.0


def test_a_branch_that_was_never_taken_may_be_anything() -> None:
    text = LONG.replace("x > 5", "x > 500")
    other = text.replace('TYPE "over", x', 'TYPE "over all"\n q = 3')
    assert same(compiled(text, "val2+"), compiled(other, "val2+")).differs is None


def test_what_was_done_by_hand_before_is_done_again_and_what_came_later_is_not() -> None:
    old = compiled(WAITS)
    entry = TimedCommand(0.0, Execute("main"))
    early = TimedCommand(0.7, SetVariable("n", (), 2.0))
    late = TimedCommand(3.0, SetVariable("m", (), 50.0))
    limit = execute(old, ALONE).scenario.limits.time_s + AFTERWARDS
    run = advance(start(old, ALONE), limit, (entry, early, late), closed=True)
    new = compiled(WAITS.replace("20 m = m+1", "20 m = m+2"))
    found = edited(run, new, "main")
    assert found.forgotten == (late,)
    fresh = advance(start(new, ALONE), limit, (entry, early), closed=True)
    assert list(told(found.run)) == list(told(fresh))


@pytest.mark.thorough
def test_it_is_as_a_fresh_run_for_mistakes_in_programs_of_tasks() -> None:
    from tests.mutants.given import mutants
    from vrts.pipeline.setting import scenario_of
    from vrts.pipeline.settings import load_task

    chance = Random(24)
    for mutant in chance.sample(mutants(), 12):
        setting = load_task(mutant.task)
        one, other = compiled(mutant.original.text), compiled(mutant.text)
        assert one.main is not None
        scenario = scenario_of(setting)
        run = execute(one, setting.scene, scenario)
        found = edited(run, other, other.main or "")
        assert list(told(found.run)) == list(told(execute(other, setting.scene, scenario)))
