"""Compares the programs of a marking again, from what it kept."""

from vrts.base.diagnostic import error
from vrts.marking.about import NAME as ABOUT
from vrts.marking.about import from_bytes as about_from_bytes
from vrts.marking.layout import Layout
from vrts.marking.result import Damaged
from vrts.marking.row import LARGEST, Class, class_from_bytes
from vrts.marking.similarity.corpus import NO_PROGRAMS, Corpora
from vrts.marking.similarity.files import remove_pages, write_similarity
from vrts.marking.similarity.kept import place_of, read_kept
from vrts.marking.similarity.ranking import Ranking
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused


def redo(layout: Layout, corpora: Corpora) -> Ranking:
    """Compare the programs of a marking again, and write pages and data anew.

    Raises:
        CannotRead: There is no marking.
        Refused: It kept no programs, or they are damaged.
    """
    try:
        about = about_from_bytes((layout.staff / ABOUT).read_bytes())
    except (OSError, Damaged) as problem:
        hint = "name the folder that was given to `vrts grade` with `-o`"
        raise CannotRead(f"`{layout.root}` is not the output of a marking", (hint,)) from problem
    place = place_of(layout)
    if not place.is_file():
        headline = f"`{layout.root}` keeps no programs to compare"
        note = "an earlier vrts marked it, or it had nothing to compare"
        remedy = "mark the class again into this folder: what has not changed is not marked again"
        raise Refused((error(NO_PROGRAMS, headline, notes=(note,), help=(remedy,)),))
    kept = read_kept(place)
    names = {row.id: row.student.name for row in _rows(layout).rows}
    remove_pages(layout)
    return write_similarity(kept, layout, names=names, corpora=corpora, pages=about.wanted.pages)


def _rows(layout: Layout) -> Class:
    try:
        if layout.results.stat().st_size <= LARGEST:
            return class_from_bytes(layout.results.read_bytes())
    except (OSError, Damaged) as problem:
        why = f"`{layout.results}` cannot be read"
        raise CannotRead(why, ("mark the class again",)) from problem
    raise CannotRead(f"`{layout.results}` is too large")
