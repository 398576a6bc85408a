"""Every future of a program explored: as a request asks, or as a task does of its programs."""

from collections.abc import Mapping
from itertools import islice
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.diagnostic import Datum, Diagnostic
from vrts.base.workers import ALONE, Workers
from vrts.check.judge import judge
from vrts.check.verdict import Verdict
from vrts.check.verdicts.every_future import CHECK
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.environments import usual_environment
from vrts.pipeline.execution import compiled_for, entry_in
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Proof
from vrts.prove.prove import prove
from vrts.prove.telling.replays import replay, run_until
from vrts.report.assessment import Assessment
from vrts.report.proof_words import of_verdict, sentence
from vrts.scene.model import Scenario
from vrts.why.chain import Chain, shortened
from vrts.why.elsewhere import in_that_future
from vrts.why.losses import chains

METHOD = "every future, tick by tick"
AFTERWARDS_S = 1.5  # that is shown after something went wrong


class Proved(NamedTuple):
    """A program as far as it could be compiled and explored."""

    compiled: Compiled
    module: Module | None
    proof: Proof | None  # None: there is nothing to execute
    diagnostics: tuple[Diagnostic, ...]
    entry: str | None = None  # the program that was executed


def proved(request: Request, environment: Environment, asking: Asking) -> Proved:
    """Compile the program of a request and look at every future of it.

    Args:
        request: What is asked for; its checks do not matter.
        environment: What may come from outside.
        asking: How far to look, and who is told.
    """
    compiled = compiled_for(request)
    module = None if compiled.compilation is None else compiled.compilation.module
    if module is None or module.main is None:
        return Proved(compiled, None, None, compiled.diagnostics)
    entry, said = entry_in(module, request)
    told = (*compiled.diagnostics, *said)
    if entry is None:
        return Proved(compiled, module, None, told)
    setting = request.setting
    found = prove(module, setting.scene, environment, asking, entry=entry, task=setting.task)
    request.step_done("prove")
    return Proved(compiled, module, found, told, entry)


def replays(request: Request, found: Proved, most: int) -> tuple[Assessment, ...]:
    """Return the runs in which something goes wrong, up to shortly after it, and their contacts.

    Args:
        request: What was asked for.
        found: What was found.
        most: How many at most, the shortest futures first.
    """
    if found.proof is None or found.module is None or found.entry is None:
        return ()
    made: list[Assessment] = []
    for wronged in found.proof.found[:most]:
        run = replay(found.module, request.setting.scene, wronged, found.entry, AFTERWARDS_S)
        made.append(_shown(request, found, run, collisions=True))
    return tuple(made)


def leaf_replays(
    request: Request, found: Proved, leaves: Mapping[int, tuple[Scenario, float]], most: int
) -> dict[int, Assessment]:
    """Return the runs of futures in which nothing goes wrong, up to shortly after they end.

    Args:
        request: What was asked for.
        found: What was found.
        leaves: The scenario of each by a number, and when it ends [s].
        most: How many at most, the first of them.
    """
    if found.module is None or found.entry is None:
        return {}
    made: dict[int, Assessment] = {}
    for number, (scenario, end_s) in islice(leaves.items(), most):
        until_s = end_s + AFTERWARDS_S
        run = run_until(found.module, request.setting.scene, scenario, found.entry, until_s)
        made[number] = _shown(request, found, run, collisions=False)
    return made


def _shown(request: Request, found: Proved, run: Run, *, collisions: bool) -> Assessment:
    scene = request.setting.scene
    return Assessment(
        request.identifier,
        request.title or request.program.name,
        found.compiled.source,
        (),
        module=found.module,
        scene=scene,
        task=request.setting.task,
        run=run,
        judgement=judge(scene, run, None, collisions=collisions),
    )


class Proven(NamedTuple):
    """What is known of every future of a program under a task."""

    verdict: Verdict
    proof: Proof


def proven(
    setting: Setting,
    module: Module,
    entry: str,
    *,
    collisions: bool,
    workers: Workers = ALONE,
) -> Proven | None:
    """Look at every future of a program as far as its task asks; None: it does not.

    The answer is the same on every machine: only the number of states ends the search.

    Args:
        setting: Scene, task and environment.
        module: The programs.
        entry: The one that is executed.
        collisions: Whether they are checked.
        workers: Who replays what seems wrong.
    """
    task = setting.task
    if task is None or task.proof is None:
        return None
    environment = usual_environment(setting)
    asking = Asking(
        states=task.proof.states,
        collisions=collisions,
        answers=workers.answers,
        beside=workers.beside,
    )
    proof = prove(module, setting.scene, environment, asking, entry=entry, task=task)
    evidence: dict[str, Datum] = {
        "method": METHOD,
        "points": float(task.proof.points),
        "states": proof.covered.states,
        "decisions": proof.covered.decisions,
        "environment": environment.title,
    }
    findings = of_verdict(proof, task.proof.environment if task.proof.hidden else None)
    verdict = Verdict(CHECK, proof.answer, sentence(proof), findings, MappingProxyType(evidence))
    return Proven(verdict, proof)


def causes(request: Request, a: Assessment, entry: str | None) -> tuple[Chain, ...]:
    """Return a chain for each loss of an assessment, in their order, of futures not shown too.

    Args:
        request: What was asked for.
        a: A program that was executed and judged.
        entry: The program that was executed.
    """
    assert a.run is not None
    assert a.judgement is not None
    found = chains(a.run, a.judgement, a.task, a.grade)
    if a.proof is None or not a.proof.found or a.grade is None or a.module is None or entry is None:
        return found
    first = a.proof.found[0]
    scene, checks = request.setting.scene, request.checks
    run = replay(a.module, scene, first, entry, AFTERWARDS_S)
    judgement = judge(scene, run, None, collisions=checks.collisions, proposer=checks.proposer)
    links = list(in_that_future(run, judgement, first.time_s))
    return tuple(
        shortened(loss.sentence, links, loss.kind) if loss.check == CHECK else chain
        for loss, chain in zip(a.grade.losses, found, strict=True)
    )
