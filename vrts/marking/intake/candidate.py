"""The files of one hand-in as candidates: what each holds, zips opened one level deep."""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.lang.reading.decoding import EMPTY_FILE, FILE_TOO_LARGE, MAX_BYTES, decode
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.marking.intake.row import Kind, Problem
from vrts.marking.intake.tree.content import (
    HEAD,
    ITSELF,
    PACK,
    Content,
    archive,
    document,
    document_in_zip,
    is_zip,
)
from vrts.marking.intake.tree.file_names import clashes
from vrts.marking.intake.tree.store import Tree, Unreadable
from vrts.marking.intake.tree.zip_tree import zip_tree

LARGEST_ARCHIVE = 64_000_000  # bytes of a zip that was handed in
MOST_MEMBERS = 1_000  # files in it
MOST_UNPACKED = 512_000_000  # bytes its files have, as it says
MOST_READ = 32_000_000  # bytes of it that are unpacked to choose from
RATIO, RATIO_FROM = 200, 4_000_000  # from so many bytes on, so many times the zip's size is a bomb
MOST_FILES = 2_000  # of one hand-in
INSIDE = "!"  # between a zip and a file in it

_PROGRAM = re.compile(r"^[ \t]*\.?PROGRAM[ \t]+([A-Za-z][\w.]*)", re.MULTILINE | re.IGNORECASE)
_FIRST_WORD = re.compile(r"(?:\d+[ \t]+)?([A-Za-z][\w.]*)(?=$|[ \t;(\"#$]|[ \t]*[\[=:])")
_ASSIGNMENT = re.compile(r"(?:SET[ \t]+)?[$#]?[A-Za-z][\w.]*(?:\[[^\]]*\])?[ \t]*=", re.IGNORECASE)
_ENOUGH = 0.5  # share of lines that begin as steps do, in what reads as a program


class Candidate(NamedTuple):
    """One file of a hand-in."""

    file: str  # as in the download; `work.zip!pick.v2` for a file in a zip
    text: str  # "" when it is none
    programs: frozenset[str]  # names after `.PROGRAM`, in lower case
    plausible: bool  # reads as VAL-II
    problem: Problem | None  # why it cannot be marked


def candidates(tree: Tree, files: Sequence[str]) -> tuple[Candidate, ...]:
    """Return the files of a hand-in, those in zips among them."""
    found: list[Candidate] = []
    for file in files[:MOST_FILES]:
        found += _of_file(tree, file)
    return tuple(found)


def inspect(tree: Tree, file: str) -> Candidate | None:
    """Return one file, by the name it has as a candidate; None when there is none of the name."""
    if file in tree.files:
        return _of_file(tree, file)[0]
    for outer, _ in _splits(file):
        if outer in tree.files:
            return next((c for c in _of_file(tree, outer) if c.file in (file, outer)), None)
    return None


def data_of(tree: Tree, file: str) -> bytes:
    """Return the bytes of a file that was chosen, exactly as handed in.

    Raises:
        Unreadable: They cannot be had, or not safely.
    """
    if file in tree.files:
        if tree.store.size(file) > MAX_BYTES:
            raise Unreadable("is too large for a program")
        return tree.store.read(file)
    for outer, inner in _splits(file):
        if outer not in tree.files:
            continue
        inside = _opened(tree, outer)
        if isinstance(inside, Problem):
            raise Unreadable(f"cannot be read: {inside.sentence}")
        if inner not in inside.files or inside.store.size(inner) > MAX_BYTES:
            raise Unreadable("is not there, or too large for a program")
        return inside.store.read(inner)
    raise Unreadable("is not there")


def shown(file: str) -> str:
    """Return the name of a file without folders: what is said of it may go to its student."""
    return re.split(rf"[/{INSIDE}]", file)[-1] or file


def _splits(file: str) -> Iterator[tuple[str, str]]:
    """Yield what may be a zip and the name in it; names may hold the sign between them too."""
    for k, character in enumerate(file):
        if character == INSIDE:
            yield file[:k], file[k + 1 :]


def _of_file(tree: Tree, file: str) -> list[Candidate]:
    """Return a file as one candidate, or what a zip holds."""
    try:
        head = tree.store.start(file, HEAD)
        if not is_zip(head):
            return [_plain(tree, file, head, file)]
    except Unreadable as flaw:
        return [_none(file, Kind.UNREADABLE, f"`{shown(file)}` {flaw}")]
    inside = _opened(tree, file)
    if isinstance(inside, Problem):
        return [Candidate(file, "", frozenset(), plausible=False, problem=inside)]
    found: list[Candidate] = []
    budget = MOST_READ
    for member in inside.files:
        name = f"{file}{INSIDE}{member}"
        budget -= min(inside.store.size(member), MAX_BYTES)
        if budget < 0:
            sentence = f"`{shown(file)}` unpacks to more than {MOST_READ // 1_000_000} MB; {PACK}"
            return [_none(file, Kind.ARCHIVE, sentence)]
        try:
            head = inside.store.start(member, HEAD)
            if is_zip(head):
                found.append(_nested(name, member, inside))
            else:
                found.append(_plain(inside, member, head, name))
        except Unreadable as flaw:
            return [_none(file, Kind.ARCHIVE, f"`{shown(file)}` {flaw}; {PACK}")]
    return found or [_none(file, Kind.EMPTY, f"`{shown(file)}` is a zip without files")]


def _nested(name: str, member: str, inside: Tree) -> Candidate:
    """Return a zip in a zip: a document, or an archive that is not opened any more."""
    held: tuple[str, ...] = ()
    if inside.store.size(member) <= MAX_BYTES:
        try:
            held = zip_tree(inside.store.read(member), member).files
        except Unreadable:
            held = ()  # whatever it is, it is not opened
    content = document_in_zip(held)
    if content is not None:
        return _foreign(name, content)
    sentence = f"`{shown(name)}` is an archive in an archive, which is not opened; {PACK}"
    return _none(name, Kind.ARCHIVE, sentence)


def _opened(tree: Tree, file: str) -> Tree | Problem:
    """Return what a zip that was handed in holds, or why it is refused."""
    size = tree.store.size(file)
    if size > LARGEST_ARCHIVE:
        sentence = f"`{shown(file)}` has {size / 1e6:.0f} MB; {PACK}"
        return Problem(Kind.TOO_LARGE, sentence)
    try:
        inside = zip_tree(tree.store.read(file), file)
    except Unreadable as flaw:
        return Problem(Kind.ARCHIVE, f"`{shown(file)}` {flaw}; {PACK}")
    content = document_in_zip(inside.files)
    if content is not None:
        return Problem(Kind.NOT_TEXT, f"`{shown(file)}` is {content.what}; {content.remedy}")
    flaw = _flaw(inside, size)
    return Problem(Kind.ARCHIVE, f"`{shown(file)}` {flaw}; {PACK}") if flaw else inside


def _flaw(inside: Tree, packed: int) -> str:
    """Return why a zip is not to be trusted, or ""."""
    for name, why in inside.refused.items():
        return f"is refused: `{name}` in it {why}"
    if len(inside.files) + len(inside.folders) > MOST_MEMBERS:
        return f"is refused: it has more than {MOST_MEMBERS:,} files"
    total = sum(inside.store.size(name) for name in inside.files)
    if total > MOST_UNPACKED or (total > RATIO_FROM and total > RATIO * packed):
        return f"is refused: it unpacks to {total / 1e6:.0f} MB"
    pair = clashes((*inside.files, *inside.folders))
    if pair is not None:
        return f"is refused: `{pair[0]}` and `{pair[1]}` in it are one name on some systems"
    return ""


def _plain(tree: Tree, member: str, head: bytes, name: str) -> Candidate:
    """Return a file that is no zip."""
    content = document(head)
    if content is not None:
        return _foreign(name, content)
    content = archive(head)
    if content is not None:
        sentence = f"`{shown(name)}` is {content.what}, which is not opened; {content.remedy}"
        return _none(name, Kind.ARCHIVE, sentence)
    size = tree.store.size(member)
    if size > MAX_BYTES:
        sentence = f"`{shown(name)}` has {size / 1e6:.1f} MB, more than any program; {ITSELF}"
        return _none(name, Kind.TOO_LARGE, sentence)
    return of_bytes(tree.store.read(member), name)


def of_bytes(data: bytes, name: str) -> Candidate:
    """Return bytes that may be program text as a candidate."""
    source = decode(data, shown(name))
    if isinstance(source, Diagnostic):
        kind = _KINDS.get(source.rule.code, Kind.NOT_TEXT)
        remedy = f"; {source.help[0]}" if source.help and kind is not Kind.EMPTY else ""
        return _none(name, kind, source.headline + remedy)
    programs = frozenset(found.lower() for found in _PROGRAM.findall(source.text))
    plausible = bool(programs) or _reads_as_steps(source.text)
    return Candidate(name, source.text, programs, plausible, None)


_KINDS = {EMPTY_FILE.code: Kind.EMPTY, FILE_TOO_LARGE.code: Kind.TOO_LARGE}


def _foreign(name: str, content: Content) -> Candidate:
    return _none(name, Kind.NOT_TEXT, f"`{shown(name)}` is {content.what}; {content.remedy}")


def _none(name: str, kind: Kind, sentence: str) -> Candidate:
    return Candidate(name, "", frozenset(), plausible=False, problem=Problem(kind, sentence))


def _reads_as_steps(text: str) -> bool:
    """Return whether most lines begin with an instruction or assign a value."""
    steps = lines = 0
    for line in text.split("\n")[:2000]:
        content = line.strip()
        if not content or content.startswith(";"):
            continue
        lines += 1
        word = _FIRST_WORD.match(content)
        known = word is not None and word[1].upper() in INSTRUCTIONS
        steps += known or _ASSIGNMENT.match(content) is not None
    return lines > 0 and steps > _ENOUGH * lines
