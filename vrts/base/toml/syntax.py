"""Why a text is not TOML, in the words of somebody who edits it."""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile, Span
from vrts.base.toml.places import Layout

TOML_SYNTAX = Rule("V600", "toml-syntax")
GIVEN_TWICE = Rule("V601", "given-twice")

LONGEST = 1_000_000  # characters; a description of a workspace has a few thousand

_PLACE = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")
_BARE = re.compile(r"[^,\]}#\n]*[^,\]}#\s]")
_NUMBER_BEFORE = re.compile(r"[-+]?[0-9][0-9._]*$")
NUMBERS = "numbers are written like 30, -300 or 12.5, without a unit"
_CURLY = "\u201c\u201d\u201e\u201f\u2018\u2019\u201a\u2032\u2033"


class _Cause(NamedTuple):
    headline: str
    help: str = ""


def too_long(source: SourceFile) -> Diagnostic:
    """Return the diagnostic for a file that is too long to be a description."""
    length = len(source.text)
    return error(
        TOML_SYNTAX,
        f"file is too long: {length:,} characters; at most {LONGEST:,} are read",
        Label(Span(source, 0, 0)),
        data={"characters": length},
    )


def too_deep(source: SourceFile, at: int) -> Diagnostic:
    """Return the diagnostic for brackets or dots nested beyond reason, seen at an offset."""
    return error(TOML_SYNTAX, "nested too deeply", Label(Span(source, at, at + 1)))


def refused(source: SourceFile, message: str, layout: Layout) -> Diagnostic:
    """Return the one diagnostic for a text that `tomllib` refuses.

    Args:
        source: The text.
        message: What `tomllib` says, with its place at the end.
        layout: What could be seen of the text before it stops making sense.
    """
    words = _PLACE.sub("", message)
    if layout.twice is not None and words.startswith("Cannot"):
        name, first, second = layout.twice
        return error(
            GIVEN_TWICE,
            f"`{name}` is given twice",
            Label(Span(source, *second), "given again here"),
            secondary=(Label(Span(source, *first), "first given here"),),
            help=("keep one of the two",),
            data={"name": name},
        )
    at = _offset(source, message)
    cause = _cause(source, words, at)
    secondary: tuple[Label, ...] = ()
    if layout.open_at is not None and layout.open_at < at:
        opened = Span(source, layout.open_at, layout.open_at + 1)
        if opened.line != source.line_of(at) or "not closed" in cause.headline:
            secondary = (Label(opened, "opened here"),)
    return error(
        TOML_SYNTAX,
        cause.headline,
        Label(_marked(source, at)),
        secondary=secondary,
        help=(cause.help,) if cause.help else (),
        data={"tomllib": words},
    )


def _offset(source: SourceFile, message: str) -> int:
    found = _PLACE.search(message)
    if found is None or found[1] is None:
        return len(source.text.rstrip())
    line, column = int(found[1]), int(found[2])
    return min(source.line_starts[line - 1] + column - 1, len(source.text))


def _marked(source: SourceFile, at: int) -> Span:
    """Return what to underline: the value or word at an offset, else one character."""
    found = _BARE.match(source.text, at)
    if found:
        return Span(source, at, found.end())
    return Span(source, at, min(at + 1, len(source.text)))


def _cause(source: SourceFile, words: str, at: int) -> _Cause:
    rest = source.line_text(source.line_of(at))[source.column_of(at) - 1 :]
    if any(c in rest[:1] for c in _CURLY):
        return _Cause("curly quotation mark", 'write straight quotes: "')
    if words.startswith("Expected '=' after a key"):
        return _Cause("`=` is missing after the key", "write `key = value`")
    if words.startswith("Expected newline or end of document"):
        if rest.startswith(","):
            return _Cause(
                "a comma after a single value",
                "write a decimal number with a point (30.5), several numbers in brackets: [1, 2]",
            )
        number = _NUMBER_BEFORE.search(source.text[:at])
        if number and rest[:1].strip():
            word = number[0] + rest.split()[0].rstrip(",]}")
            return _Cause(f"invalid number `{word}`", NUMBERS)
        return _Cause("more text after the end of the value", "one `key = value` to a line")
    if words.startswith("Invalid value"):
        return _invalid_value(rest)
    if words.startswith(("Invalid initial character for a key", "Invalid statement")):
        return _Cause(
            "a key must stand here", "write `key = value`; keys have letters, digits, - and _"
        )
    if words.startswith(("Illegal character '\\n'", "Unterminated string", 'Expected "\'"')):
        return _Cause("text is not closed", "close it with the quotation mark it begins with")
    if words.startswith("Unclosed array"):
        return _Cause(
            "list is not closed, or a comma is missing", "write [1, 2, 3], with commas between"
        )
    if words.startswith("Unclosed inline table"):
        return _Cause("braces are not closed", "write {x = 1, y = 2} on one line")
    if words.startswith(("Expected ']' at the end", "Expected ']]' at the end")):
        return _Cause("header is not closed", "write [name] for a table, [[name]] for one of many")
    if words.startswith("Unescaped"):
        return _Cause("a backslash begins an unknown escape", r"write \\ for a backslash")
    if "integer string conversion" in words:
        return _Cause("number has too many digits", NUMBERS)
    return _Cause("invalid TOML: " + words[:1].lower() + words[1:].replace("'", "`"))


def _invalid_value(rest: str) -> _Cause:
    found = _BARE.match(rest)
    word = found[0] if found else ""
    if rest.startswith(","):
        return _Cause("a value is missing before the comma", "remove the comma")
    if not word:
        return _Cause("value is missing after `=`", "write `key = value`")
    if word.lower() in ("true", "false"):
        return _Cause(f"invalid value `{word}`", f"write {word.lower()} in small letters")
    if word[0].isalpha():
        return _Cause(f"invalid value `{word}`", f'text needs quotation marks: "{word}"')
    return _Cause(f"invalid value `{word}`", NUMBERS)
