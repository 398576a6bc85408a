"""Every future of a program as the controller will hold it: what goes wrong in one is refused.

It takes the place of scenarios: a way that no scenario takes is taken by a future. What a proof
does not speak about, as what the controller's memory held before, stays with `dependence`.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Label, error
from vrts.base.workers import ALONE, Workers
from vrts.check.verdict import Answer
from vrts.dispatch.manifest import Futures
from vrts.dispatch.planning.reasons.coverage import MOVING
from vrts.dispatch.planning.reasons.refusals import (
    FAILS_IN_A_FUTURE,
    NOT_ALL_FUTURES,
    NOT_EXECUTED,
)
from vrts.ir.module import Module
from vrts.pipeline.setting import Setting, scenario_of
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Again, Environment
from vrts.prove.explore.answers import Free
from vrts.prove.proof import Proof
from vrts.prove.prove import prove
from vrts.report.proof_words import counted, diagnostic
from vrts.scene.model import Parts

STATES = 50_000  # a budget that gives the same answer on every machine
EXECUTED = 10  # times, with the memory that the last execution left
USUAL = Environment(
    title=f"every input is free, EXECUTE {EXECUTED} times",
    again=Again(EXECUTED - 1, Parts.PUT_BACK),
)
ANALOG = "analog input"  # tried in every way, or told as sampled
TRIED = ("input", "TIMER", "internal signal")  # what begins so is tried in every way


def asked_of(setting: Setting) -> Environment:
    """Return the environment of the task, if it asks for every future; else the usual one.

    A controller keeps its memory, so the program is executed again also where a task says nothing
    of that.
    """
    found = setting.environment
    if found is None:
        return USUAL
    return replace(found, again=USUAL.again) if found.again.most == 0 else found


def proofs_of(
    module: Module,
    settings: Sequence[Setting],
    environment: Environment,
    entry: str,
    workers: Workers = ALONE,
) -> list[Proof]:
    """Return what was found of all futures of a program, for each setting.

    Scenarios that differ in their inputs and answers alone have the same futures.
    """
    found: dict[tuple[str, str], Proof] = {}
    proofs: list[Proof] = []
    for setting in settings:
        scenario = replace(scenario_of(setting), inputs=(), answers=())
        key = (setting.scene.digest, repr(scenario))
        if key not in found:
            outside = replace(environment, scenario=scenario)
            asking = Asking(states=STATES, answers=workers.answers)
            task = setting.task
            found[key] = prove(module, setting.scene, outside, asking, entry=entry, task=task)
        proofs.append(found[key])
    return proofs


def refused(module: Module, proof: Proof) -> Iterator[Diagnostic]:
    """Yield a refusal for what goes wrong in some future, and for what was not looked at."""
    for wronged in proof.found:
        found = diagnostic(wronged)
        yield replace(
            found,
            rule=FAILS_IN_A_FUTURE,
            help=("look at it with `vrts prove`; if it cannot come, say so in an `--environment`",),
        )
    if proof.answer is Answer.UNDETERMINED:
        yield error(
            NOT_ALL_FUTURES,
            "not every future of the program could be looked at",
            notes=proof.open[:4],
            help=("say in an `--environment` what may come, or make the program simpler",),
        )
    if proof.answer is Answer.HOLDS:  # otherwise steps may be missed behind what goes wrong
        yield from _dead(module, proof)


def _dead(module: Module, proof: Proof) -> Iterator[Diagnostic]:
    """Yield a refusal for every step that moves something and that no future executes."""
    reasons = {(one.program, one.step): one.reason for one in proof.covered.dead}
    for program in module.programs.values():
        told: set[int] = set()
        pairs = zip(program.instructions, program.origins, strict=True)
        for instruction, origin in pairs:
            reason = reasons.get((program.name, origin.step))
            if reason is None or origin.step in told or not isinstance(instruction, MOVING):
                continue
            told.add(origin.step)
            yield error(
                NOT_EXECUTED,
                f"step {origin.step} of `{program.name}` moves the arm or the hand, and no future "
                "executes it",
                Label(origin.span),
                notes=(reason,),
                help=("take the step out, or say in an `--environment` how it comes to it",),
                data={"program": program.name, "step": origin.step},
            )


def is_tried(
    environment: Environment, module: Module, proofs: Sequence[Proof], source: str
) -> bool:
    """Return whether futures of the programs try a source of values in every way.

    Args:
        environment: What may come from outside.
        module: The programs.
        proofs: What was found of all futures.
        source: Where values come from, as `dependence` names it.
    """
    if source == ANALOG:
        return not any(one.startswith(ANALOG) for it in proofs for one in it.covered.sampled)
    if source == "operator":
        answers = environment.answers
        if answers is None:
            return Free(module).is_whole
        return bool(answers.texts) or answers.whole
    return source.startswith(TRIED) or (source == "hand" and environment.misses)


def told(environment: Environment, proof: Proof) -> Futures:
    """Return what a manifest says of a proof."""
    covered = proof.covered
    return Futures(
        environment=environment.title,
        sha256=environment.digest or None,
        answer=proof.answer.value,
        summary=f"{counted(covered.states, 'state')}, {counted(covered.decisions, 'decision')}",
        quantified=covered.quantified,
        bounded=covered.bounded,
        sampled=covered.sampled,
        assumed=covered.assumed,
    )
