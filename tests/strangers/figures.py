"""What is measured of programs of strangers: who is accepted, and which damage is noticed."""

import random
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from tests.strangers.damage import Damage, damages
from vrts.base.diagnostic import Diagnostic, Severity
from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.splitter import split

ELSEWHERE = ("undefined-program", "undefined-variable", "undefined-location")  # in another file


class Stranger(NamedTuple):
    """A file of somebody, and whether it is accepted."""

    name: str
    hash: str
    text: str
    errors: tuple[Diagnostic, ...]


class Noticed(NamedTuple):
    """A damage, and whether an error stands at its place."""

    damage: Damage
    there: bool


def strangers(folder: Path, dialect: Dialect) -> Iterator[Stranger]:
    """Yield the files of a folder."""
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        data = path.read_bytes()
        source = decode(data, path.name)
        if isinstance(source, SourceFile):
            errors = errors_of(source.text, dialect)
            yield Stranger(path.name, sha256(data).hexdigest(), source.text, errors)


def errors_of(text: str, dialect: Dialect) -> tuple[Diagnostic, ...]:
    """Return the errors of a program."""
    found = compile_source(SourceFile("stranger.v2", text), Options(dialect)).diagnostics
    return tuple(diagnostic for diagnostic in found if diagnostic.is_error)


def warned(text: str, dialect: Dialect) -> frozenset[str] | None:
    """Return the kinds of warnings about a program that stands alone; None where it has errors.

    What another file or the controller may hold is no kind, nor what is not simulated.
    """
    found = compile_source(SourceFile("stranger.v2", text), Options(dialect)).diagnostics
    if any(diagnostic.is_error for diagnostic in found):
        return None
    return frozenset(
        diagnostic.rule.slug
        for diagnostic in found
        if diagnostic.severity is Severity.WARNING
        and diagnostic.rule.slug not in ELSEWHERE
        and not diagnostic.headline.endswith("is not simulated")
    )


def programs(text: str, dialect: Dialect) -> Iterator[str]:
    """Yield the programs of a file, each with its first and last line."""
    source = SourceFile("stranger.v2", text)
    for section in split(Problems(source, dialect)):
        if section.kind == "program":
            yield text[section.header.start : section.finish[1]]


def noticed(text: str, dialect: Dialect, chance: random.Random, count: int) -> Iterator[Noticed]:
    """Yield damages of an accepted program, and whether each is told where it is."""
    for damage in damages(text, dialect, chance, count):
        lines = {
            label.span.source.line_of(label.span.start)
            for error in errors_of(damage.text, dialect)
            for label in (error.primary, *error.secondary)
            if label is not None
        }
        yield Noticed(damage, damage.line in lines or (damage.anywhere and bool(lines)))
