"""What may be written at a place of a TOML file, and what the word there means."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.lsp.settings.cursor import Cursor, cursor_at, keys_of, tables_before
from vrts.lsp.settings.schema import Key, choices_at, key_at, keys_at

NAMES_A_BODY = frozenset(
    {
        *("object", "on", "left_of", "right_of", "farther_than", "nearer_than"),
        *("stacked_on", "aligned_with"),
    }
)


class Written(NamedTuple):
    """Something that may be written."""

    label: str
    text: str  # in place of the word
    is_value: bool
    detail: str = ""
    about: str = ""
    first: bool = False  # it has to be there


class Completed(NamedTuple):
    """All that may be written in place of a range."""

    start: int
    end: int
    proposals: tuple[Written, ...]


class Explained(NamedTuple):
    """What a word means, as Markdown."""

    start: int
    end: int
    text: str


def complete_setting(text: str, kind: str, offset: int, bodies: Sequence[str] = ()) -> Completed:
    """Return what may be written at an offset.

    Args:
        text: Of the file, as it is while somebody types.
        kind: Of file, one of `vrts.schemas.KINDS`.
        offset: Where the cursor stands.
        bodies: Names of what stands in the scene, as far as is known.
    """
    at = cursor_at(text, offset)
    if at.header:
        found = tuple(_headers(text, kind, at))
    elif at.key:
        found = tuple(_values(kind, at, bodies))
    else:
        given = keys_of(text, at.path, offset)
        found = tuple(_keys(text, kind, at, given))
    return Completed(at.start, at.end, found)


def explain_setting(text: str, kind: str, offset: int) -> Explained | None:
    """Return what the key at an offset means, or the key of the value there; None: nothing does."""
    at = cursor_at(text, offset)
    word = text[at.start : at.end]
    path, name = (at.path, at.key[0]) if at.key else (at.path, word)
    found = key_at(kind, path, name) if name else None
    if found is None:
        return None
    lines = [f"**{name}**: {found.kind or 'anything'}", found.about]
    if found.required:
        lines.append("It has to be there.")
    return Explained(at.start, at.end, "\n\n".join(line for line in lines if line))


def _headers(text: str, kind: str, at: Cursor) -> Iterator[Written]:
    there = set(tables_before(text, at.start))
    for key in keys_at(kind, at.path):
        if not (key.is_table or key.is_list) or (at.array and not key.is_list):
            continue
        if key.is_list or (*at.path, key.name) not in there:
            yield Written(key.name, key.name, is_value=False, detail=key.kind, about=key.about)


def _keys(text: str, kind: str, at: Cursor, given: frozenset[str]) -> Iterator[Written]:
    begun = text.find("=", at.end, text.find("\n", at.end) if "\n" in text[at.end :] else len(text))
    for key in keys_at(kind, at.path):
        if key.name in given:
            continue
        if (key.is_table or key.is_list) and not at.path:
            brackets = ("[[", "]]") if key.is_list else ("[", "]")
            written = f"{brackets[0]}{key.name}{brackets[1]}"
            yield _written(key, written, written)
        else:
            yield _written(key, key.name, key.name if begun >= 0 else f"{key.name} = {key.value}")


def _written(key: Key, label: str, text: str) -> Written:
    return Written(
        label, text, is_value=False, detail=key.kind, about=key.about, first=key.required
    )


def _values(kind: str, at: Cursor, bodies: Sequence[str]) -> Iterator[Written]:
    path = (*at.path, *at.key)
    known = key_at(kind, at.path, at.key[0])
    about = "" if known is None else known.about
    choices = choices_at(kind, path)
    for value in choices:
        yield Written(value, value, is_value=True, about=about)
    if at.key[0] in NAMES_A_BODY:
        for name in bodies:
            if f'"{name}"' not in choices:
                yield Written(f'"{name}"', f'"{name}"', is_value=True, detail="in the scene")
