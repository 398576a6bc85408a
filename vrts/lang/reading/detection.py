"""Which language of the family a file is written in, where nobody says.

Strict VAL-II is the default; another dialect is taken only where the file name says so, or where
several words that only it has stand in the text and hardly one that it lacks.
"""

import re

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import SourceFile
from vrts.lang.dialect import AS, VAL, VAL2, VPLUS, Dialect
from vrts.lang.joined import span_in
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

DIALECT_DETECTED = Rule("V157", "dialect-detected")

_BY_SUFFIX = {".as": AS, ".pg": VAL2, ".lc": VAL2, ".rv": VAL2, ".st": VAL2}
_FIRST_WORDS = re.compile(
    r"^[ \t]*(?:\d+[ \t]+)?([A-Za-z][\w.]*)(?![\w.]|[ \t]*[=\[])", re.MULTILINE
)
_AS_SECTION = re.compile(
    r"^[ \t]*\.(TRANS|JOINTS|ROBOTDATA\d*|SYSDATA|AUXDATA)\b", re.MULTILINE | re.IGNORECASE
)
_ENOUGH = 2  # words that only one dialect has
_OUTWEIGHS = 3  # times as many as words that it lacks: real files hold a slip or two


def detect(source: SourceFile) -> tuple[Dialect, Diagnostic | None]:
    """Return the dialect of a source, and a note where it is not VAL-II."""
    suffix = source.name[source.name.rfind(".") :].lower() if "." in source.name else ""
    named = _BY_SUFFIX.get(suffix)
    if named is not None:
        return named, _note(source, named, 0, 0, f"files that end in `{suffix}` are {named.title}")
    section = _AS_SECTION.search(source.text)
    if section is not None:
        words = f"only AS has the section {section.group().strip().upper()}"
        return AS, _note(source, AS, section.start(), section.end(), words)
    first: dict[str, re.Match[str]] = {}
    for match in _FIRST_WORDS.finditer(source.text):
        first.setdefault(match.group(1).upper(), match)
    used = [word for text in first if (word := INSTRUCTIONS.get(text)) is not None]
    counts: list[tuple[int, Dialect, list[str]]] = []
    for dialect in (VPLUS, AS, VAL):
        own = [w.text for w in used if w.dialects == dialect.letters]
        lacking = [w for w in used if not dialect.has(w.dialects)]
        if len(own) >= _ENOUGH and len(own) > _OUTWEIGHS * len(lacking):
            counts.append((len(own), dialect, own))
    if not counts:
        return VAL2, None
    _, dialect, own = max(counts, key=lambda entry: entry[0])
    shown = sorted(own, key=lambda text: first[text].start())[:3]
    at = first[shown[0]]
    words = f"only {dialect.title} has {', '.join(shown[:-1])} and {shown[-1]}"
    return dialect, _note(source, dialect, at.start(1), at.end(1), words)


def _note(
    source: SourceFile, dialect: Dialect, start: int, end: int, why: str
) -> Diagnostic | None:
    if dialect is VAL2:
        return None
    return Diagnostic(
        DIALECT_DETECTED,
        Severity.NOTE,
        f"this is read as {dialect.title}",
        Label(span_in(source, start, end), "") if end else None,
        notes=(why,),
        help=("`--dialect val2` reads it as VAL-II",),
        data={"dialect": dialect.name},
    )
