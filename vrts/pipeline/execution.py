"""A program compiled and executed as a request asks, each once; nothing is checked here."""

from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity, error
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.entry import Entry
from vrts.ir.module import Module
from vrts.pipeline.compiling.programs import Compiled, compile_bytes
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of

NO_SUCH_PROGRAM = Rule("V190", "no-such-program")
WHICH_PROGRAM = Rule("V193", "which-program")

MOST_NAMED = 5  # programs, of those that may be meant


class Executed(NamedTuple):
    """A program as far as it could be compiled and executed."""

    compiled: Compiled
    module: Module | None  # None: there is nothing to execute
    run: Run | None
    diagnostics: tuple[Diagnostic, ...]  # all but those of the run
    entry: str | None = None  # the program that was executed


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
    entry, said = entry_in(module, request)
    if entry is None:
        return Executed(compiled, module, None, (*compiled.diagnostics, *said))
    scenario = scenario_of(request.setting)
    if request.limits is not None:
        scenario = replace(scenario, limits=request.limits)
    run = execute(module, request.setting.scene, scenario, entry)
    request.step_done("simulate")
    kept = (*without_repeats(compiled.diagnostics, run.findings), *said)
    return Executed(compiled, module, run, kept, entry)


def entry_in(module: Module, request: Request) -> tuple[str | None, tuple[Diagnostic, ...]]:
    """Return the program that a request executes, and what there is to say about the choice.

    It is the one asked for, else the task's, else the main one of the file. None: there is no
    such program, and the diagnostic says so.
    """
    task = request.setting.task
    asked = request.entry or (None if task is None else task.program)
    if asked is not None:
        name = asked.lower()
        return (name, ()) if name in module.programs else (None, (no_program(module, asked),))
    found = module.entry
    if found is None:
        return None, ()
    return found.name, (_guessed(module, found),) if found.rivals else ()


def no_program(module: Module, name: str) -> Diagnostic:
    """Return what to say when a program to execute is not among those of a module."""
    return error(
        NO_SUCH_PROGRAM,
        f"there is no program `{name}` to execute",
        help=(f"programs in the file: {', '.join(module.programs)}",),
    )


def _guessed(module: Module, found: Entry) -> Diagnostic:
    """Return that nothing tells which program is meant, and which was taken."""
    names = (found.name, *found.rivals)
    listed = ", ".join(f"`{name}`" for name in names[:MOST_NAMED])
    more = len(names) - MOST_NAMED
    others = f"{listed} and {more} more" if more > 0 else listed
    return Diagnostic(
        WHICH_PROGRAM,
        Severity.WARNING,
        f"nothing says which program to execute, so `{found.name}` is: the first that may be meant",
        Label(module.programs[found.name].span, "executed"),
        tuple(Label(module.programs[name].span, "not this one") for name in found.rivals[:1]),
        notes=(f"none is called `main`, and these may be meant: {others}",),
        help=("name the one to execute `main`, or call the others from it",),
    )


def without_repeats(
    compiled: tuple[Diagnostic, ...], run: tuple[Diagnostic, ...]
) -> tuple[Diagnostic, ...]:
    """Drop warnings of the compiler about a name whose run-time error says the same."""
    named = {d.data["name"] for d in run if d.is_error and "name" in d.data}
    return tuple(
        d for d in compiled if d.is_error or "names" in d.data or d.data.get("name") not in named
    )
