"""One program compiled, executed, checked and marked: the stages composed, each at most once."""

from dataclasses import replace

from vrts.check.judge import judge
from vrts.check.mark.grade import Status
from vrts.check.mark.mark import grade, ungraded
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.curve import with_curve
from vrts.pipeline.execution import executed
from vrts.pipeline.futures import causes, proven
from vrts.pipeline.request import Request
from vrts.report.assessment import Assessment
from vrts.report.audience import as_allowed


def assess(request: Request, compiled: Compiled | None = None) -> Assessment:
    """Compile, run, check and mark one program; without hints where the task allows none.

    Args:
        request: What is asked for.
        compiled: The program compiled already; None: it is not.
    """
    return as_allowed(_assessed(request, compiled), request.setting.stamps)


def _assessed(request: Request, compiled: Compiled | None) -> Assessment:
    setting, checks = request.setting, request.checks
    scene, task = setting.scene, setting.task
    found = executed(request, compiled)
    run = found.run
    a = Assessment(
        request.identifier,
        request.title or request.program.name,
        found.compiled.source,
        (*setting.stamps, *found.diagnostics),
        module=found.module,
        scene=scene,
        task=task,
        run=run,
    )
    if run is None:
        return _ungraded(a)
    if not checks.judged:
        return a
    futures = None
    if found.module is not None and found.entry is not None:
        futures = proven(
            setting,
            found.module,
            found.entry,
            collisions=checks.collisions,
            workers=checks.workers,
        )
    if futures is not None:
        request.step_done("prove")
    judgement = judge(
        scene,
        run,
        task,
        collisions=checks.collisions,
        proposer=checks.proposer,
        second=checks.second,
        also=() if futures is None else (futures.verdict,),
    )
    request.step_done("check")
    marked = None if task is None else grade(task, run, judgement, found.diagnostics)
    proof = None if futures is None else futures.proof
    a = replace(a, judgement=judgement, grade=marked, proof=proof)
    if checks.causes:
        a = replace(a, chains=causes(request, a, found.entry))
    return with_curve(a) if checks.curve and checks.collisions else a


def _ungraded(a: Assessment) -> Assessment:
    if a.task is None:
        return a
    status = Status.UNREADABLE if a.source is None else Status.DOES_NOT_COMPILE
    return replace(a, grade=ungraded(a.task, status, a.diagnostics))
