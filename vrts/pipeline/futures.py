"""Every future of a program explored as a request asks."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.execution import compiled_for, entry_in
from vrts.pipeline.request import Request
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Proof
from vrts.prove.prove import prove


class Proved(NamedTuple):
    """A program as far as it could be compiled and explored."""

    compiled: Compiled
    module: Module | None
    proof: Proof | None  # None: there is nothing to execute
    diagnostics: tuple[Diagnostic, ...]


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
    return Proved(compiled, module, found, told)
