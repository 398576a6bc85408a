"""A program that is executed, with what a file of its run has to tell."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.engine.run import Run
from vrts.engine.storage.origin import Origin, Programs, SceneText
from vrts.lang.compiler import Compilation
from vrts.lang.joined import Joined
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
    found, reading = executed(request), request.reading
    compilation = found.compiled.compilation
    if found.run is None or compilation is None:
        return Simulated(None, None, found.diagnostics)
    programs = Programs(
        _files(compilation), compilation.dialect.name, reading.precedence, reading.replace
    )
    origin = Origin(programs, _scene_text(request.setting))
    return Simulated(found.run, origin, (*found.diagnostics, *found.run.findings))


def _scene_text(setting: Setting) -> SceneText:
    source = setting.scene_source
    if source is None:
        return SceneText(setting.scene.name.removesuffix(" alone"), None, setting.scene.digest)
    return SceneText(source.name, source.text, setting.scene.digest)


def _files(compilation: Compilation) -> tuple[SourceFile, ...]:
    """Return every text that was compiled."""
    source = compilation.source
    assert source is not None
    return source.files if isinstance(source, Joined) else (source,)
