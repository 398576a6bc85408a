"""Another name for a program, a label or a variable, in every file that it belongs to."""

import re
from collections.abc import Sequence

from vrts.lang.names import SIGNIFICANT, is_truncated, key
from vrts.lang.vocabulary.functions import CONSTANTS
from vrts.lang.vocabulary.lookup import reserved_words
from vrts.lsp.answers.finding import Found, references
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Names, Occurrence, Target
from vrts.lsp.documents.uses import Kind

_NAME = re.compile(r"[$#]?\.?[A-Za-z][\w.]*", re.ASCII)
_NUMBER = re.compile(r"[1-9]\d{0,4}")
MAX_LABEL = 32767
_FIXED = {
    Kind.FUNCTION: "a function of the language",
    Kind.CONSTANT: "a constant of the language",
    Kind.SIGNAL: "the number of a signal",
}


class CannotRename(ValueError):  # noqa: N818 -- names the situation
    """A name that cannot be another one; the text says why."""


def renamable(document: Document, offset: int) -> Occurrence:
    """Return the name at an offset.

    Raises:
        CannotRename: There is none, or it belongs to the language.
    """
    occurrence = document.names.at(offset)
    if occurrence is None:
        raise CannotRename("only programs, labels, variables and locations have other names")
    written = document.source.text[occurrence.start : occurrence.end]
    if occurrence.kind in _FIXED:
        raise CannotRename(f"`{written}` is {_FIXED[occurrence.kind]}")
    return occurrence


def rename(document: Document, offset: int, new: str, group: Sequence[Document]) -> list[Found]:
    """Return every place where a new name has to be written.

    Raises:
        CannotRename: The name cannot be another one, or not this one.
    """
    occurrence = renamable(document, offset)
    target = occurrence.target
    if occurrence.kind is Kind.LABEL:
        _check_label(new, document, target)
    else:
        _check_name(new, document, target, group)
    return references(document, offset, group)


def _check_label(new: str, document: Document, target: Target) -> None:
    named = document.dialect.has("a") and _NAME.fullmatch(new)
    if not named and (not _NUMBER.fullmatch(new) or int(new) > MAX_LABEL):
        raise CannotRename(f"`{new}` is not a label: a whole number from 1 to {MAX_LABEL}")
    wanted = new if new.isdigit() else key(new)
    if wanted != target.name and target._replace(name=wanted) in document.names.by_target:
        raise CannotRename(f"there is a label `{new}` in `{target.program}` already")


def _check_name(new: str, document: Document, target: Target, group: Sequence[Document]) -> None:
    if not _NAME.fullmatch(new):
        raise CannotRename(f"`{new}` is not a name: a letter, then letters, digits, `_` and `.`")
    if _sigil(new) != _sigil(target.name):
        what = {"$": "a string", "#": "a precision point"}.get(target.name[0], "")
        begins = f"`{target.name}` is {what}" if what else f"`{target.name}` has no `$` or `#`"
        raise CannotRename(f"{begins}, and its name says so")
    if is_truncated(new):
        raise CannotRename(f"only {SIGNIFICANT} characters of a name count")
    if new.upper() in reserved_words(document.dialect) or new.lower() in CONSTANTS:
        raise CannotRename(f"{new.upper()} is a word of the language")
    wanted = key(new)
    if wanted == target.name:
        return
    for other in group[:1] if target.program else group:
        _check_free(other, target, wanted, new)


def _check_free(document: Document, target: Target, wanted: str, new: str) -> None:
    """Refuse a name that would then be taken for another: of the same program, or both shared."""
    names = document.names
    if target.program:  # only what that program itself uses can be meant there
        for known, found in names.by_target.items():
            if known.name != wanted or known.family != target.family or known == target:
                continue
            if known.program == target.program:
                what = f"`{target.program}` has a variable `{new}` of its own already"
                raise CannotRename(what)
            if not known.program and any(_within(names, o) == target.program for o in found):
                what = f"`{target.program}` uses the shared `{new}`, which it could not reach then"
                raise CannotRename(what)
        return
    for known in names.by_target:
        if known.name != wanted or known.family != target.family or known == target:
            continue
        if not known.program:
            raise CannotRename(f"there is a {target.family} `{new}` already")
        if any(_within(names, o) == known.program for o in names.by_target.get(target, ())):
            what = f"`{known.program}` uses it, and has a variable `{new}` of its own already"
            raise CannotRename(what)


def _within(names: Names, occurrence: Occurrence) -> str | None:
    program = names.program_at(occurrence.start)
    return None if program is None else program.name


def _sigil(name: str) -> str:
    return name[0] if name[:1] in ("$", "#") else ""
