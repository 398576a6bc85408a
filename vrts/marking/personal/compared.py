"""What a marking keeps to compare programs with, and pages of it, without one student."""

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.marking.layout import Layout
from vrts.marking.similarity.copies import beside, corpora_of
from vrts.marking.similarity.corpus import NONE, Corpora, digest_of, read_corpora
from vrts.marking.similarity.files import FEWEST, remove_pages, remove_written
from vrts.marking.similarity.kept import keep, place_of, read_kept
from vrts.marking.similarity.redo import redo
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

WITHOUT = Rule("V925", "compared-without-a-corpus")


class Found(NamedTuple):
    """With what a marking was compared."""

    folders: tuple[Path, ...]  # that are here, and keep what they kept then
    lost: tuple[str, ...]  # names of the others


def corpora_found(folder: Path, others: Iterable[Path]) -> Found:
    """Return what a marking was compared with, as far as it is among folders, or beside it.

    Plain folders of programs are lost: nothing tells that they are as they were.
    """
    asked = corpora_of(folder)
    wanted = {one.sha256 for one in asked if one.sha256}
    found: dict[str, Path] = {}
    if wanted:
        for other in (*others, *beside(folder)):
            place = place_of(Layout(other))
            if place.is_file() and not place.is_symlink():
                digest = digest_of(place)
                if digest in wanted:
                    found.setdefault(digest, other.resolve())
    lost = tuple(one.name for one in asked if one.sha256 not in found)
    return Found(tuple(found.values()), lost)


def show_programs_of(folder: Path, others: Collection[Path]) -> bool:
    """Return whether a marking was compared with one of some others, as they are now."""
    held = {place_of(Layout(one)) for one in others if one.resolve() != folder.resolve()}
    digests = {digest_of(place) for place in held if place.is_file() and not place.is_symlink()}
    return any(one.sha256 in digests for one in corpora_of(folder))


def keep_without(layout: Layout, ids: Collection[str]) -> None:
    """Keep no program of a student any more.

    Raises:
        Refused: What is kept is damaged.
    """
    place = place_of(layout)
    if place.is_file():
        kept = read_kept(place)
        rest = {name: program for name, program in kept.programs.items() if name not in ids}
        if len(rest) < len(kept.programs):
            keep(kept._replace(programs=rest), layout)


def compare_again(layout: Layout, folders: Collection[str]) -> tuple[Diagnostic, ...]:
    """Write pages and data of what is kept now.

    Args:
        layout: Of a marking whose programs were compared.
        folders: To compare with.
    """
    if not place_of(layout).is_file():
        remove_pages(layout)  # an earlier vrts has kept nothing to compare again
        return ()
    corpora, told = NONE, tuple[Diagnostic, ...]()
    if folders:
        corpora, told = _corpora(layout, folders)
    kept = read_kept(place_of(layout))
    if not kept.programs or len(kept.programs) + len(corpora.programs) < FEWEST:
        remove_written(layout)
    else:
        redo(layout, corpora)
    return (*corpora.findings, *told)


def _corpora(layout: Layout, folders: Collection[str]) -> tuple[Corpora, tuple[Diagnostic, ...]]:
    try:
        return read_corpora([Path(one) for one in folders], layout.root), ()
    except (CannotRead, Refused):
        return NONE, tuple(_without(layout, [Path(one).name for one in folders]))


def told_lost(layout: Layout, names: Collection[str]) -> Iterator[Diagnostic]:
    """Yield that a marking was compared again without something."""
    if names:
        yield from _without(layout, names)


def _without(layout: Layout, names: Collection[str]) -> Iterator[Diagnostic]:
    shown = ", ".join(f"`{name}`" for name in names)
    headline = f"`{layout.root}` is compared again without {shown}"
    notes = (
        "it was compared with that, which is not here, or cannot be told to be as it was",
        "groups that reach into it are not in the pages any more",
    )
    remedy = f"compare with it again: `vrts grade similarity {layout.root} --corpus FOLDER`"
    yield warning(WITHOUT, headline, notes=notes, help=(remedy,))
