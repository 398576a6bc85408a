"""Programs from their bytes: compiled, or laid out anew."""

from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile

if TYPE_CHECKING:
    from vrts.lang.compiler import Compilation


class Compiled(NamedTuple):
    """A program as far as it could be read and compiled."""

    source: SourceFile | None  # None for what is no text
    compilation: "Compilation | None"
    diagnostics: tuple[Diagnostic, ...]


class ProgramFile(NamedTuple):
    """The bytes of a program, and its name as shown."""

    data: bytes
    name: str


class Reading(NamedTuple):
    """How programs are read."""

    dialect: str | None = "val2"  # None: as file name and content tell
    precedence: str | None = None  # "A" or "B"; None: as the dialect has it
    replace: bool = False  # a program that comes again takes the place of the first
    others: tuple[ProgramFile, ...] = ()  # compiled together with the program


STRICT = Reading()


def compile_bytes(data: bytes, name: str, reading: Reading = STRICT) -> "Compiled":
    """Return source, compilation and diagnostics; the first two are None for what is no text."""
    from vrts.lang.compiler import Options, compile_sources
    from vrts.lang.dialect import DIALECTS, Precedence
    from vrts.lang.reading.decoding import decode

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


def store(compilation: "Compilation", *, exact: bool = False) -> str:
    """Return what STORE writes for a compilation that succeeded."""
    from vrts.lang.writing.store import store_text

    module, source = compilation.module, compilation.source
    assert module is not None
    assert source is not None
    return store_text(source, module, compilation.dialect, exact=exact)


class Formatted(NamedTuple):
    """A program in canonical layout."""

    before: str
    after: str
    data: bytes  # of the file as it should be
    changed: bool  # whether that is another than it is
    diagnostic: Diagnostic | None = None  # why the file cannot be read


def format_bytes(data: bytes, name: str, dialect: str | None) -> Formatted:
    """Return the canonical layout of a program, with LF line ends."""
    from vrts.lang.dialect import DIALECTS
    from vrts.lang.reading.decoding import decode
    from vrts.lang.reading.detection import detect
    from vrts.lang.writing.layout import layout

    source = decode(data, name)
    if isinstance(source, Diagnostic):
        return Formatted("", "", data, False, source)
    chosen = DIALECTS[dialect] if dialect is not None else detect(source)[0]
    after = layout(source, chosen)
    if not after.endswith("\n"):
        after += "\n"
    encoded = _encoded_like(after, data)
    return Formatted(source.text, after, encoded, encoded != data)


def _encoded_like(text: str, data: bytes) -> bytes:
    """Return text as UTF-8, or in the 8-bit code page of a file that is no UTF-8."""
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        try:
            return text.encode("cp1252")
        except UnicodeEncodeError:
            return text.encode()
    return text.encode()
