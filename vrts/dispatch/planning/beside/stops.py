"""A stop of the arm in any tick, and what the operator may type after it.

ABORT gives up the motion on the way. PROCEED then goes on with the next step, from wherever the arm
stands; RETRY executes the step again at which the program was, which may be one behind the motion.
Neither is free: the arm goes a way that the program never goes by itself. Some ticks are tried
first. Where nothing goes wrong in them, every tick is tried, so what holds is proven. What does not
hold refuses nothing: the sheet says what not to type.
"""

from dataclasses import replace
from typing import Literal

from vrts.base.workers import Workers
from vrts.check.verdict import Answer
from vrts.dispatch.manifest import Margin
from vrts.dispatch.planning.beside.trials import Subject
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Afterwards, Again, Environment
from vrts.prove.proof import Proof, What, Wronged
from vrts.prove.prove import prove

STATES = 20_000
EVERY = 6  # ticks, between those that are tried first
TYPED = {Afterwards.PROCEED: "PROCEED", Afterwards.RETRY: "RETRY"}
BEGINS = "stopped in any tick, then "


def stops(subject: Subject, environment: Environment, workers: Workers) -> tuple[Margin, ...]:
    """Return for everything that may be typed after a stop what becomes of it.

    Args:
        subject: The program.
        environment: What else may come from outside.
        workers: Who looks at worlds.
    """

    def ask(after: Afterwards) -> Margin:
        outside = replace(
            environment,
            scenario=subject.world.scenario,
            stops=frozenset((after,)),
            again=Again(),
            properties=(),
        )
        some = replace(outside, stop_every=EVERY)
        proof = _proven(subject, some)
        if proof.answer is Answer.HOLDS:
            proof = _proven(subject, outside)
        return _margin(TYPED[after], proof)

    return tuple(workers.answers(ask, list(TYPED)))


def typed_after(margin: Margin) -> str:
    """Return what is typed after the stop that a margin is about; "" for another margin."""
    if not margin.name.startswith(BEGINS):
        return ""
    return margin.name.removeprefix(BEGINS).partition(",")[0]


def _proven(subject: Subject, environment: Environment) -> Proof:
    scene, asking = subject.world.scene, Asking(states=STATES)
    return prove(subject.module, scene, environment, asking, entry=subject.entry)


def _margin(typed: str, proof: Proof) -> Margin:
    answer: Literal["holds", "violated", "undetermined"] = proof.answer.value
    stopped = tuple(one for one in proof.found if any(d.what is What.STOP for d in one.decisions))
    if proof.answer is Answer.VIOLATED and not stopped:
        answer, sentence = "undetermined", "what goes wrong without a stop hides it"
    elif proof.answer is Answer.VIOLATED:
        sentence = _worst(stopped)
    elif proof.answer is Answer.HOLDS:
        sentence = "nothing goes wrong"
    else:
        sentence = f"nothing went wrong in {proof.covered.states:,} states, but more are left"
    return Margin(f"{BEGINS}{typed}", answer, "proven", None, sentence)


def _worst(found: tuple[Wronged, ...]) -> str:
    """Return what goes wrong first, and after a stop in which step."""
    first = found[0]
    stop = next((d for d in first.decisions if d.what is What.STOP), None)
    where = ""
    if stop is not None and stop.cause is not None:
        where = f"stopped at step {stop.cause.step} of `{stop.cause.program}`, "
    more = len(found) - 1
    others = f"; {more} other thing{'' if more == 1 else 's'} can go wrong" if more else ""
    return f"{where}{first.headline}{others}"
