"""A program compiled and executed as a request asks, each once; nothing is checked here."""

from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import Compiled, compile_bytes
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of

NO_SUCH_PROGRAM = Rule("V190", "no-such-program")


class Executed(NamedTuple):
    """A program as far as it could be compiled and executed."""

    compiled: Compiled
    module: Module | None  # None: there is nothing to execute
    run: Run | None
    diagnostics: tuple[Diagnostic, ...]  # all but those of the run


def compiled_for(request: Request) -> Compiled:
    """Compile the program of a request."""
    found = compile_bytes(request.program.data, request.program.name, request.reading)
    request.step_done("compile")
    return found


def executed(request: Request, compiled: Compiled | None = None) -> Executed:
    """Execute the program of a request.

    Args:
        request: What is asked for; its checks do not matter.
        compiled: The program compiled already; None: it is not.
    """
    if compiled is None:
        compiled = compiled_for(request)
    module = None if compiled.compilation is None else compiled.compilation.module
    if module is None or module.main is None:
        return Executed(compiled, None, None, compiled.diagnostics)
    entry = entry_of(request)
    if entry is not None and entry.lower() not in module.programs:
        missing = no_program(module, entry)
        return Executed(compiled, module, None, (*compiled.diagnostics, missing))
    scenario = scenario_of(request.setting)
    if request.limits is not None:
        scenario = replace(scenario, limits=request.limits)
    run = execute(module, request.setting.scene, scenario, entry and entry.lower())
    request.step_done("simulate")
    kept = without_repeats(compiled.diagnostics, run.findings)
    return Executed(compiled, module, run, kept)


def entry_of(request: Request) -> str | None:
    """Return the name of the program that a request executes, as it was given; None: the first."""
    task = request.setting.task
    return request.entry or (None if task is None else task.program)


def no_program(module: Module, name: str) -> Diagnostic:
    """Return what to say when a program to execute is not among those of a module."""
    return error(
        NO_SUCH_PROGRAM,
        f"there is no program `{name}` to execute",
        help=(f"programs in the file: {', '.join(module.programs)}",),
    )


def without_repeats(
    compiled: tuple[Diagnostic, ...], run: tuple[Diagnostic, ...]
) -> tuple[Diagnostic, ...]:
    """Drop warnings of the compiler about a name whose run-time error says the same."""
    named = {d.data["name"] for d in run if d.is_error and "name" in d.data}
    return tuple(d for d in compiled if d.is_error or d.data.get("name") not in named)
