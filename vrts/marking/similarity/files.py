"""Writes what was found out about similar programs, where only the staff sees it."""

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path, PurePosixPath
from urllib.parse import quote

import msgspec

from vrts.assignments.pack import read_zip
from vrts.assignments.packed import is_packed
from vrts.assignments.variants.places import with_places
from vrts.marking.layout import COMPARED, Layout, write_atomically
from vrts.marking.marking import Done
from vrts.marking.overview.links import staff_report
from vrts.marking.privacy.others import write_others
from vrts.marking.privacy.pseudonyms import NAMES
from vrts.marking.result import Kind
from vrts.marking.similarity.corpus import NONE, Corpora, nameless
from vrts.marking.similarity.groups import Group, Link
from vrts.marking.similarity.kept import Kept, keep, place_of, with_sketches
from vrts.marking.similarity.likeness import likeness
from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.pair_page import Side, pair_page
from vrts.marking.similarity.ranking import Corpus, Ranking, similarity, to_bytes
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.report_files import REPORT
from vrts.marking.variants.marker import VariantsMarker
from vrts.marking.whole_class import Marked
from vrts.pipeline.files import read_bytes
from vrts.pipeline.setting import Setting
from vrts.scene.block import location_block

PAGE, DATA = "similarity.html", "similarity.json"
PAIR = "pair-"  # begins the names of pages of two programs
MOST_PAGES = 300  # of two programs; each group has one at least
ENDED = frozenset({Kind.RESOURCE, Kind.FAULT})  # their programs may end a comparison too
FEWEST = 2  # programs that can be compared
LARGEST = 4_000_000  # bytes of a file that students were given
GIVEN = ("start.v2", "handout/*.v2")  # in the folder of a task


def given(task: Path, setting: Setting) -> tuple[bytes, ...]:
    """Return what everybody was given: programs beside the task, and the scene's locations."""
    return (*_programs(task), location_block(setting.scene.locations).encode())


def given_to(students: Iterable[str], marker: Marker) -> tuple[bytes, ...]:
    """Return what everybody was given, and what each was given in a variant of the task."""
    found = given(Path(marker.place.task), marker.whole)
    if not isinstance(marker, VariantsMarker):
        return found
    texts, before = found[:-1], marker.whole.scene.locations
    several = dict.fromkeys(found)  # each once
    for tag in sorted({marker.tags.get(student, "") for student in students} & {*marker.places}):
        now = marker.by(tag).whole.scene.locations
        several |= dict.fromkeys(with_places(text, before, now) for text in texts)
        several[location_block(now).encode()] = None
    return tuple(several)


def _programs(task: Path) -> list[bytes]:
    if is_packed(task):
        files = read_zip(read_bytes(task)).files
        return [
            data
            for name, data in sorted(files.items())
            if any(PurePosixPath(name).match(pattern) for pattern in GIVEN)
        ]
    home = task if task.is_dir() else task.parent
    paths = sorted(path for pattern in GIVEN for path in home.glob(pattern) if path.is_file())
    return [path.read_bytes() for path in paths if path.stat().st_size <= LARGEST]


def compare_class(marked: Marked, marker: Marker, layout: Layout, corpora: Corpora = NONE) -> None:
    """Compare the programs of a class, each with each and with those of a corpus; write it.

    A submission whose process was ended is left out. A class with less than two programs has
    nothing to compare, unless there is a corpus; what was written before goes.
    """
    programs = programs_of(marked.done)
    remove_written(layout)
    if not programs or len(programs) + len(corpora.programs) < FEWEST:
        return
    kept = Kept(
        marked.rows.title,
        with_sketches(programs, layout),
        marked.groups,
        given_to(programs, marker),
    )
    keep(kept, layout)
    write_similarity(
        kept,
        layout,
        names={row.id: row.student.name for row in marked.rows.rows},
        corpora=corpora,
        pages=marker.wanted.pages,
    )


def programs_of(done: Iterable[Done]) -> dict[str, bytes]:
    """Return the programs of submissions by identifier, without those whose process was ended."""
    return {
        one.entry.identifier: one.entry.data
        for one in done
        if one.entry.data is not None and one.result.kind not in ENDED
    }


def remove_written(layout: Layout) -> None:
    """Delete what an earlier comparison wrote and kept."""
    remove_pages(layout)
    place_of(layout).unlink(missing_ok=True)


def remove_pages(layout: Layout) -> None:
    """Delete the pages and the data of an earlier comparison."""
    for name in (PAGE, DATA):
        (layout.staff / name).unlink(missing_ok=True)
    for path in (layout.staff / COMPARED).glob(f"{PAIR}*.html"):
        path.unlink()
    (layout.staff / COMPARED / NAMES).unlink(missing_ok=True)


def write_similarity(
    kept: Kept,
    layout: Layout,
    *,
    names: Mapping[str, str],
    corpora: Corpora = NONE,
    pages: bool = True,
) -> Ranking:
    """Write the pages and the data, and return the ranking.

    Args:
        kept: The programs of the class, who handed in together, and what everybody was given.
        layout: Of the results.
        names: Of the students, by identifier.
        corpora: Programs of earlier years and other folders.
        pages: Whether there are pages about the submissions to link to.
    """
    corpora, ids = nameless(corpora, layout)
    texts = {name: program.data for name, program in kept.programs.items()}
    ranking = similarity(texts, kept.given, kept.together)
    found = likeness(kept.programs, kept.given, kept.together, corpora.programs)
    groups = _with_pages(found.groups)
    corpus = tuple(
        Corpus(
            name,
            len(programs),
            sum(one.sketch is not None for one in programs.values()),
            corpora.kept.get(name, ""),
        )
        for name, programs in sorted(corpora.programs.items())
    )
    ranking = msgspec.structs.replace(ranking, groups=groups, corpus=corpus)
    sides = _Sides(kept, corpora, names, layout, pages=pages)
    for group in groups:
        for link in group.links:
            if link.page:
                both = sides.side(link.first), sides.side(link.second)
                evidence = found.evidence(link.first, link.second)
                page = pair_page(link, group, evidence, both, kept.title)
                write_atomically(layout.staff / link.page, page.encode())
    if ids:
        shown = sorted({one for group in groups for one in group.members} & ids.keys())
        write_others((one.split("/", 1) for one in shown), ids, layout)
    page = similarity_page(ranking, texts, kept.title, names, pages=pages)
    write_atomically(layout.staff / PAGE, page.encode())
    write_atomically(layout.staff / DATA, to_bytes(ranking))
    return ranking


def _with_pages(groups: Sequence[Group]) -> tuple[Group, ...]:
    """Return groups with the addresses of the pages of their pairs: of each group some first."""
    room = MOST_PAGES - min(len(groups), MOST_PAGES)
    number = 0
    told: list[Group] = []
    for group in groups:
        links: list[Link] = []
        for k, link in enumerate(group.links):
            if k == 0 or room > 0:
                room -= k > 0
                number += 1
                page = f"{COMPARED}/{PAIR}{number:03d}.html"
                links.append(msgspec.structs.replace(link, page=page))
            else:
                links.append(link)
        told.append(msgspec.structs.replace(group, links=tuple(links)))
    return tuple(told)


class _Sides:
    """Finds what a page of two programs shows of each."""

    def __init__(
        self,
        kept: Kept,
        corpora: Corpora,
        names: Mapping[str, str],
        layout: Layout,
        *,
        pages: bool,
    ) -> None:
        self._kept, self._corpora, self._names = kept, corpora, names
        self._layout, self._pages = layout, pages

    def side(self, name: str) -> Side:
        own = self._kept.programs.get(name)
        if own is not None:
            label = self._names.get(name, "") or name
            there = self._pages and (self._layout.grader(name) / REPORT).is_file()
            return Side(name, label, own.data, f"../{staff_report(name)}" if there else None)
        corpus, _, one = name.partition("/")
        return Side(name, name, self._corpora.programs[corpus][one].data, self._report(corpus, one))

    def _report(self, corpus: str, one: str) -> str | None:
        """Return the address of a report in another marking, if that is on the same disk."""
        place = self._corpora.places.get(corpus)
        if place is None or not (Layout(place).grader(one) / REPORT).is_file():
            return None
        try:
            way = os.path.relpath(Layout(place).staff, self._layout.staff / COMPARED)
        except ValueError:  # on Windows: on another drive
            return None
        return f"{quote(Path(way).as_posix())}/{staff_report(one)}"
