"""A debugging session of a run that is there already: executed again, so that it can go on."""

from pathlib import Path

from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.files import Files
from vrts.debug.marks.marks import SUFFIX, Marks
from vrts.debug.opening import Asked, Opened, opener_of
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.files import read_bytes
from vrts.run_files.loading import executed_again, load_run


def opened_run(path: Path) -> Opened:
    """Open a run that `vrts run --save` has written.

    Raises:
        CannotRead: The file is not there.
        Refused: It is not sound, or its programs and scene cannot be made again.
    """
    opener = opener_of(Asked(path))
    path = path.resolve()
    loaded = load_run(read_bytes(path), path.name, path.parent)
    assert loaded.origin is not None
    run = executed_again(loaded)
    programs = loaded.origin.programs
    debugger = Debugger(run, DIALECTS[programs.dialect])
    sources = tuple(
        {p.span.source.name: p.span.source for p in run.module.programs.values()}.values()
    )
    console = Console(debugger, path.parent, sources)
    console.goals.marks = Marks(path.with_name(path.name + SUFFIX))
    console.marking.opener = opener
    return Opened(debugger, console, sources, loaded.diagnostics, Files([path]))
