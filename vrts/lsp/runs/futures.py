"""What goes wrong for some inputs only: every future of a program, as far as an editor waits."""

import time
from collections.abc import Collection, Iterator
from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Label, Severity
from vrts.engine.machine.forever.nodes import tops
from vrts.engine.machine.forever.touches import looks_of
from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.ir.ranges import INPUTS
from vrts.lsp.channel.findings import Found
from vrts.pipeline.environments import usual_environment, without_example
from vrts.pipeline.futures import proved
from vrts.pipeline.request import Request
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Proof, Wrong
from vrts.report.proof_words import diagnostic, scenario_of

STATES = 20_000
MOST = 20  # that are told of one program


def for_some_inputs(
    request: Request, module: Module, known: Collection[Diagnostic], cpu_s: float
) -> list[Found]:
    """Return what may go wrong depending on what comes from outside, with a scenario of each.

    What goes wrong whatever comes is left out: the run of the program has shown it.

    Args:
        request: Program and setting.
        module: The program compiled.
        known: What its run has shown.
        cpu_s: Processor time of this process at which the search ends [s].
    """
    environment = _environment(request)
    if not _depends(module, environment):
        return []
    asking = Asking(states=STATES, enough=lambda: time.process_time() >= cpu_s)
    proof = proved(request, environment, asking).proof
    if proof is None:
        return []
    asked = request.setting.task is not None and request.setting.task.proof is not None
    return list(_told(proof, known, Severity.ERROR if asked else Severity.WARNING))


def _environment(request: Request) -> Environment:
    """Return the environment of the task, if students may know it; else everything is free."""
    setting = request.setting
    if setting.task is not None and setting.task.proof is not None and setting.task.proof.hidden:
        return without_example(Environment(), setting)
    return usual_environment(setting)


def _depends(module: Module, environment: Environment) -> bool:
    """Return whether something from outside may decide what a program does."""
    code = [one for program in module.programs.values() for one in program.instructions]
    looks = looks_of((top for one in code for top in tops(one)), frozenset())
    return (
        bool(looks.signals.intersection(INPUTS))
        or looks.any_signal
        or looks.clock
        or any(isinstance(one, ir.Prompt | ir.React) for one in code)
        or bool(environment.stops)
        or environment.misses
        or environment.again.most != 0
        or len(environment.speeds) > 1
    )


def _told(proof: Proof, known: Collection[Diagnostic], severity: Severity) -> Iterator[Found]:
    errors = [one for one in known if one.severity is Severity.ERROR]
    shown = {_place(one) for one in errors if one.primary is not None}
    goals_missed = any(one.primary is None for one in known)  # its example misses one already
    for wronged in proof.found[:MOST]:
        if wronged.wrong is Wrong.GOAL and goals_missed:
            continue
        found = diagnostic(wronged)
        if found.primary is None or _place(found) not in shown:
            label = None if wronged.cause is None else Label(wronged.cause.span)
            found = replace(found, severity=severity, primary=label)
            yield Found(found, scenario=scenario_of(wronged))


def _place(diagnostic: Diagnostic) -> tuple[str, int] | None:
    primary = diagnostic.primary
    return None if primary is None else (primary.span.source.name, primary.span.start)
