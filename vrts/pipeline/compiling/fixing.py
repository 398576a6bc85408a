"""Programs with every fix that is certain applied, in the bytes that they came in.

Only what a fix names changes. New lines end as the other lines of the file do.
"""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Edit
from vrts.base.mending import edits_of, mendable, with_edits
from vrts.lang.dialect import Dialect
from vrts.lang.reading.decoding import DROPPED
from vrts.lang.reading.encodings import Characters, characters, shown
from vrts.pipeline.compiling.programs import Compiled, compile_bytes
from vrts.pipeline.compiling.reading import STRICT, Reading

MOST_PASSES = 12  # one fix may uncover what the next one mends


class Fixed(NamedTuple):
    """A program after its fixes."""

    before: str
    after: str
    data: bytes  # of the file as it should be
    applied: tuple[Diagnostic, ...]  # in the order in which they were applied
    left: tuple[Diagnostic, ...]  # what is still to be said, at its places in `after`
    dialect: Dialect | None = None  # None for what is no text


def fix_bytes(
    data: bytes, name: str, reading: Reading = STRICT, *, passes: int = MOST_PASSES
) -> Fixed:
    """Return a program with every fix applied, pass after pass until nothing more is certain."""
    compiled = compile_bytes(data, name, reading)
    first = compiled.source
    if first is None or compiled.compilation is None:
        return Fixed("", "", data, (), compiled.diagnostics)
    dialect = compiled.compilation.dialect
    reading = reading._replace(dialect=dialect.name)
    applied: list[Diagnostic] = []
    for _ in range(passes):
        assert compiled.source is not None
        chosen = mendable(compiled.source, compiled.diagnostics)
        found = _applied(data, chosen, name, reading, _errors(compiled))
        if found is None:
            break
        data, compiled, done = found
        applied += done
    source = compiled.source
    assert source is not None
    return Fixed(first.text, source.text, data, tuple(applied), compiled.diagnostics, dialect)


def _applied(
    data: bytes, chosen: Sequence[Diagnostic], name: str, reading: Reading, errors: int
) -> tuple[bytes, Compiled, Sequence[Diagnostic]] | None:
    """Apply the fixes that are chosen; where that adds errors, the first that adds none."""
    for together in (chosen, *((one,) for one in chosen if len(chosen) > 1)):
        after = rewritten(data, edits_of(together))
        if after == data:
            continue
        compiled = compile_bytes(after, name, reading)
        if compiled.source is not None and _errors(compiled) <= errors:
            return after, compiled, together
    return None


def _errors(compiled: Compiled) -> int:
    return sum(d.is_error for d in compiled.diagnostics)


def rewritten(data: bytes, edits: Sequence[Edit]) -> bytes:
    """Return the bytes of a file after edits of its text as `decode` reads it."""
    found = characters(data)
    assert found is not None, "it was decoded"
    places = _places(found.text)
    end = _line_end(found)
    ended = [edit._replace(replacement=edit.replacement.replace("\n", end)) for edit in edits]
    return found.encoding.encode(with_edits(found.text, ended, places.__getitem__))


def _places(text: str) -> list[int]:
    """Return where each character that a program is read from stands in its file."""
    places: list[int] = []
    for at, sign in enumerate(text):
        if sign not in DROPPED and not (sign == "\n" and text[at - 1 : at] == "\r"):
            places.append(at)
    return [*places, len(text)]


def _line_end(found: Characters) -> str:
    """Return how most lines of a file end."""
    text = shown(found.text)
    pairs = text.count("\r\n")
    counts = Counter({"\n": text.count("\n") - pairs, "\r\n": pairs})
    counts["\r"] = text.count("\r") - pairs
    return max(counts, key=lambda end: counts[end])
