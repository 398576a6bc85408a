"""Programs of earlier years and other folders, to compare a class with."""

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.base.safe_names import safe
from vrts.marking.about import NAME as ABOUT
from vrts.marking.class_marks import entries
from vrts.marking.intake.take_in import take_in_tree
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.layout import Layout
from vrts.marking.privacy.others import called, is_nameless
from vrts.marking.privacy.pseudonyms import key_for
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.kept import is_kept, place_of, read_kept
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

NO_PROGRAMS = Rule("V776", "nothing-kept-to-compare")
ITSELF = Rule("V777", "corpus-is-the-class")
EMPTY = Rule("V778", "corpus-without-programs")
MOST = 20_000  # programs of all folders together


class Corpora(NamedTuple):
    """Programs to compare with, by the name of their folder and by identifier."""

    programs: dict[str, dict[str, Program]]
    places: dict[str, Path]  # of markings: their reports may be shown
    findings: tuple[Diagnostic, ...] = ()
    kept: Mapping[str, str] = {}  # SHA-256 of what a marking keeps, so that purging it is told


NONE = Corpora({}, {})


def read_corpora(paths: Sequence[Path], out: Path | None = None) -> Corpora:
    """Return the programs of folders and zips, each under its name.

    Args:
        paths: Outputs of `vrts grade`, what they keep, or folders and zips of programs.
        out: Where the class is marked into, which is no corpus of itself.

    Raises:
        CannotRead: There is nothing of the kind.
        Refused: One is damaged, or is the class itself.
    """
    programs: dict[str, dict[str, Program]] = {}
    places: dict[str, Path] = {}
    findings: list[Diagnostic] = []
    kept: dict[str, str] = {}
    for path in paths:
        if not path.exists():
            raise CannotRead(f"there is no `{path}`")
        if out is not None and path.resolve() in (out.resolve(), place_of(Layout(out)).resolve()):
            headline = f"`{path}` is the class itself: it cannot be its own corpus"
            raise Refused((error(ITSELF, headline, help=("name an earlier marking",)),))
        name = _name(path, programs)
        marked = path.is_dir() and (Layout(path).staff / ABOUT).is_file()
        found = _of_marking(path) if marked else _of_programs(path)
        if not found:
            headline = f"`{path}` holds no programs: nothing is compared with it"
            findings.append(warning(EMPTY, headline))
            continue
        programs[name] = found
        if sum(map(len, programs.values())) > MOST:
            raise CannotRead(f"the folders to compare with hold more than {MOST:,} programs")
        if marked:
            places[name] = path
        if marked or (path.is_file() and is_kept(path)):
            kept[name] = digest_of(place_of(Layout(path)) if marked else path)
    return Corpora(programs, places, tuple(findings), kept)


def nameless(corpora: Corpora, layout: Layout) -> tuple[Corpora, Mapping[str, str]]:
    """Return the programs as a marking may show them, and by `FOLDER/PSEUDONYM` whose they are.

    In a class that is marked without names, nobody of another folder is named either, and reports
    with names are not shown. In any other marking all stays as it is.

    Raises:
        Refused: The key of the marking is none.
    """
    if not corpora.programs or not is_nameless(layout):
        return corpora, {}
    key = key_for(layout)
    ids: dict[str, str] = {}
    programs: dict[str, dict[str, Program]] = {}
    for folder, found in corpora.programs.items():
        named = {one: called(one, key) for one in found}
        programs[folder] = {named[one]: program for one, program in found.items()}
        ids |= {f"{folder}/{name}": one for one, name in named.items()}
    places = {name: at for name, at in corpora.places.items() if is_nameless(Layout(at))}
    return corpora._replace(programs=programs, places=places), ids


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file, in hexadecimal digits."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _of_marking(path: Path) -> dict[str, Program]:
    place = place_of(Layout(path))
    if not place.is_file():
        headline = f"`{path}` keeps no programs to compare with"
        note = "an earlier vrts marked it, or it had fewer than two programs, or it was purged"
        remedy = "mark it again, or name the folder of its programs"
        raise Refused((error(NO_PROGRAMS, headline, notes=(note,), help=(remedy,)),))
    return read_kept(place).programs


def _of_programs(path: Path) -> dict[str, Program]:
    if path.is_file() and is_kept(path):
        return read_kept(path).programs
    with open_place(path) as tree:
        found = take_in_tree(tree, program=None)
        return {
            entry.identifier: Program(entry.data)
            for entry in entries(tree, found.rows)
            if entry.data is not None
        }


def _name(path: Path, known: dict[str, dict[str, Program]]) -> str:
    """Return the name of a folder, told apart from those before it."""
    whole = path.resolve()
    name = first = safe(whole.name if path.is_dir() else whole.stem)
    number = 2
    while name in known:
        name, number = f"{first}-{number}", number + 1
    return name
