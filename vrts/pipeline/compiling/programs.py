"""Programs compiled from their bytes."""

from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.compiler import Compilation, Options, compile_sources
from vrts.lang.dialect import DIALECTS, Precedence
from vrts.lang.reading.decoding import decode
from vrts.pipeline.compiling.reading import STRICT, ProgramFile, Reading


class Compiled(NamedTuple):
    """A program as far as it could be read and compiled."""

    source: SourceFile | None  # None for what is no text
    compilation: Compilation | None
    diagnostics: tuple[Diagnostic, ...]


def compile_bytes(data: bytes, name: str, reading: Reading = STRICT) -> Compiled:
    """Return source, compilation and diagnostics; the first two are None for what is no text."""
    found = [decode(file.data, file.name) for file in (ProgramFile(data, name), *reading.others)]
    unread = tuple(source for source in found if isinstance(source, Diagnostic))
    sources = [source for source in found if isinstance(source, SourceFile)]
    if isinstance(found[0], Diagnostic):
        return Compiled(None, None, unread)
    options = Options(
        None if reading.dialect is None else DIALECTS[reading.dialect],
        None if reading.precedence is None else Precedence(reading.precedence),
        reading.replace,
    )
    compilation = compile_sources(sources, options)
    if unread:
        compilation = replace(compilation, module=None)
    return Compiled(found[0], compilation, (*unread, *compilation.diagnostics))
