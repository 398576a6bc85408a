"""A program verified before it is written for another controller."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.check.verdict import Answer
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.lang.compiler import Compilation
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.execution import compiled_for, entry_in
from vrts.pipeline.request import Request
from vrts.report.assessment import Assessment

NOT_VERIFIED = Rule("V862", "not-verified")


class Verified(NamedTuple):
    """A program in which nothing was found wrong."""

    compilation: Compilation
    module: Module
    entry: str  # the program of the file that is executed
    assessment: Assessment
    run: Run


class NotVerified(NamedTuple):
    """Why a program is not written for another controller."""

    diagnostics: tuple[Diagnostic, ...]


def verified(request: Request, compiled: Compiled | None = None) -> Verified | NotVerified:
    """Compile, execute and check a program, which may be compiled already."""
    compiled = compiled or compiled_for(request)
    _, compilation, found = compiled
    if compilation is None or compilation.module is None or compilation.module.main is None:
        return NotVerified(found)
    entry, chosen = entry_in(compilation.module, request)
    if entry is None:
        return NotVerified((*found, *chosen))
    judged = assess(request, compiled)
    wrong = any(d.is_error for d in judged.findings)
    if judged.judgement is None or wrong or judged.judgement.answer is not Answer.HOLDS:
        return NotVerified((*judged.findings, _refused(request.program.name)))
    assert judged.run is not None
    return Verified(compilation, compilation.module, entry, judged, judged.run)


def _refused(name: str) -> Diagnostic:
    return error(
        NOT_VERIFIED,
        f"`{name}` is not verified, so it is not exported",
        notes=("what is wrong here would be wrong on any robot",),
        help=(f"mend it first: `vrts verify {name}`",),
    )
