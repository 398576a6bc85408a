"""Every future of a program: does it hold in all of them, and if not, in which it does not."""

from collections.abc import Iterator, Sequence
from contextlib import closing

from vrts.base.stack import deep_stack
from vrts.check.task.task import Task
from vrts.check.verdict import Answer
from vrts.engine.futures.timers import ever_new
from vrts.engine.memory.events import Cause
from vrts.ir.module import Module
from vrts.prove.asking import Asking, Told, first_here
from vrts.prove.collecting import fewer_collections
from vrts.prove.environment.environment import Environment
from vrts.prove.explore.executed import dead_steps
from vrts.prove.explore.search import Search
from vrts.prove.graph.past import story
from vrts.prove.graph.suspects import End
from vrts.prove.proof import Proof, Wronged
from vrts.prove.telling.confirm import Replays
from vrts.prove.telling.covered import covered
from vrts.prove.telling.goals import MOST_ENDS, Missed, is_asked, missed, suspect
from vrts.prove.telling.scenarios import scenario_of
from vrts.prove.telling.tell import Teller
from vrts.prove.telling.unasked import unasked
from vrts.scene.model import Scene

__all__ = ["Asking", "Told", "prove"]

USUAL = Asking()
NOT_REPLAYED = "of what seems to go wrong {} was not replayed to its end"
AFTERWARDS_S = 1.0  # a replay goes on behind the end of the program


@deep_stack()
def prove(
    module: Module,
    scene: Scene,
    environment: Environment,
    asking: Asking = USUAL,
    *,
    entry: str,
    task: Task | None = None,
) -> Proof:
    """Look at every future of a program.

    Args:
        module: The programs.
        scene: Where the robot stands.
        environment: What may come from outside.
        asking: How far to look, and who is told.
        entry: The program that is executed.
        task: What is asked of it; None: that nothing goes wrong.

    Raises:
        KeyError: There is no such program.
    """
    if entry not in module.programs:
        raise KeyError(entry)
    search = Search(module, scene, environment, collisions=asking.collisions)
    search.begin(entry)
    replays = Replays(module, scene, environment, entry, task)
    with fewer_collections(), closing(search):
        search.go_on(asking, patiently=False)
        teller, found, left = _told(search, replays, asking)
        if not (found or search.is_over or search.was_enough):
            search.go_on(asking)
            teller, found, left = _told(search, replays, asking)
    loaded = search.first.system.programs.loaded
    left += (f"not confirmed by a replay: {one}" for one in teller.doubtful)
    dead = () if left else dead_steps(module, loaded, search.executed, entry)
    return Proof(
        _answer(found, left),
        found,
        covered(search, dead),
        tuple(left),
        unbounded=tuple(search.grows.found.values()),
        tree=tuple(search.tree.branches),
    )


def _told(
    search: Search, replays: Replays, asking: Asking
) -> tuple[Teller, tuple[Wronged, ...], list[str]]:
    """Return who tells, what goes wrong as far as the search has come, and what is left.

    Who is told that replays have begun may raise KeyboardInterrupt when it is enough: then what is
    known so far is told. What was enough before they began is not looked at again.
    """
    left, was_enough = list(_left(search)), asking.enough()
    teller = Teller(replays, search.environment, search.tick_s)
    try:
        asking.told(search.so_far._replace(replaying=True))
        left += _judge(search, replays, asking)
        teller.tell(search.suspects.in_order(), asking.answers)
    except KeyboardInterrupt:
        if was_enough or not asking.enough():
            raise
        search.was_enough = True
        left.append(NOT_REPLAYED.format(f"{len(search.suspects) - teller.asked:,}"))
    finally:
        asking.told(search.so_far)
    return teller, tuple(teller.found), left


def _answer(found: Sequence[Wronged], left: Sequence[str]) -> Answer:
    if found:
        return Answer.VIOLATED
    return Answer.UNDETERMINED if left else Answer.HOLDS


def _judge(search: Search, replays: Replays, asking: Asking) -> Iterator[str]:
    """Judge what the task asks for where futures end; yield what nobody can tell."""
    task = replays.task
    if task is None:
        return

    def judged(end: End) -> list[Missed]:
        scenario = scenario_of(search.environment, story(end.past), search.first.tick)
        return list(missed(replays.run(scenario, end.time_s + AFTERWARDS_S), task))

    asked = [end for end in search.endings.values() if is_asked(end)]
    some = asked[:MOST_ENDS]
    for end, found in zip(some, first_here(asking.answers, judged, some), strict=True):
        for one in found:
            if one.verdict.answer is Answer.VIOLATED:
                search.suspects.add(suspect(end, one))
            else:
                yield f"{one.verdict.check}: {one.verdict.summary}"
    if len(asked) > MOST_ENDS:
        yield f"of {len(asked)} ends that leave things differently {MOST_ENDS} were judged"


def _left(search: Search) -> tuple[str, ...]:
    """Return what was not looked at."""
    left: list[str] = []
    if not search.is_over:
        left.append(f"{len(search.frontier)} futures were left after {search.counts.states} states")
        left += [
            f"step {step} of `{program}` makes a state of its own of each reading of TIMER: compare"
            " TIMER(n) with a number, or a variable that holds it and nothing else"
            for program, step in ever_new(search.module, search.keys.since)
        ]
    left += [
        f"`{one.name}` grows without bound: nobody knows what it comes to"
        for one in search.grows.looked_at
    ]
    for cause in search.unanswered:
        assert isinstance(cause, Cause)
        left.append(
            f"nothing says what is typed at step {cause.step} of `{cause.program}`, and the program"
            " goes on with whatever it is: give answers in the environment, or let the program"
            " ask whether the number is right"
        )
    left += unasked(search.first.system.programs.loaded, search.executed.numbers)
    return tuple(left)
