"""A program that is executed, with what a file of its run has to tell."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.verdicts.limits import check_limits
from vrts.controllers.values import digest
from vrts.engine.motion.remarks import without_forecasts
from vrts.engine.run import Run
from vrts.engine.storage.origin import Origin, Programs, SceneText
from vrts.lang.compiler import Compilation
from vrts.lang.joined import Joined
from vrts.pipeline.compiling.programs import Compiled
from vrts.pipeline.execution import executed
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting


class Simulated(NamedTuple):
    """A program that was executed, as far as it could be."""

    run: Run | None
    origin: Origin | None  # what a file of the run has to tell
    diagnostics: tuple[Diagnostic, ...]  # of the compiler, then of the run


def simulate(request: Request) -> Simulated:
    """Compile and execute a program, without judging it."""
    found = executed(request)
    return of_run(request, found.compiled, found.run, found.diagnostics)


def of_run(
    request: Request, compiled: Compiled, run: Run | None, diagnostics: tuple[Diagnostic, ...]
) -> Simulated:
    """Return what a file of a run has to tell, where the run is there already.

    Args:
        request: What was asked for.
        compiled: Its program.
        run: What came of it; None: nothing ran.
        diagnostics: All but those of the run.
    """
    reading, compilation = request.reading, compiled.compilation
    if run is None or compilation is None:
        return Simulated(None, None, diagnostics)
    programs = Programs(
        _files(compilation), compilation.dialect.name, reading.precedence, reading.replace
    )
    origin = Origin(programs, scene_text(request.setting))
    return Simulated(run, origin, (*diagnostics, *told_of(run)))


def told_of(run: Run) -> tuple[Diagnostic, ...]:
    """Return what a run found, and the joints that were too fast or went too far in it."""
    return (*without_forecasts(run.findings), *check_limits(run).findings)


def scene_text(setting: Setting) -> SceneText:
    """Return what a file of a run tells of the scene of a setting."""
    source, scene = setting.scene_source, setting.scene
    name = scene.name.removesuffix(" alone") if source is None else source.name
    text = None if source is None else source.text
    return SceneText(name, text, scene.digest, scene.controller.name, digest(scene.controller))


def _files(compilation: Compilation) -> tuple[SourceFile, ...]:
    """Return every text that was compiled."""
    source = compilation.source
    assert source is not None
    return source.files if isinstance(source, Joined) else (source,)
