"""Writes what was found out about similar programs, where only the staff sees it."""

from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from vrts.assignments.pack import read_zip
from vrts.assignments.packed import is_packed
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.ranking import Ranking, similarity, to_bytes
from vrts.marking.submission.marker import Marker
from vrts.marking.whole_class import Marked
from vrts.pipeline.files import read_bytes
from vrts.pipeline.setting import Setting
from vrts.scene.block import location_block

PAGE, DATA = "similarity.html", "similarity.json"
FEWEST = 2  # programs that can be compared
LARGEST = 4_000_000  # bytes of a file that students were given
GIVEN = ("start.v2", "handout/*.v2")  # in the folder of a task


def given(task: Path, setting: Setting) -> tuple[bytes, ...]:
    """Return what everybody was given: programs beside the task, and the scene's locations."""
    return (*_programs(task), location_block(setting.scene.locations).encode())


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


def compare_class(marked: Marked, marker: Marker, layout: Layout) -> None:
    """Compare the programs of a class, each with each, and write what was found.

    A class with less than two programs has nothing to compare; what was written before goes.
    """
    programs = {
        done.entry.identifier: done.entry.data
        for done in marked.done
        if done.entry.data is not None
    }
    if len(programs) < FEWEST:
        for name in (PAGE, DATA):
            (layout.staff / name).unlink(missing_ok=True)
        return
    write_similarity(
        programs,
        given(Path(marker.place.task), marker.whole),
        layout,
        marked.rows.title,
        names={row.id: row.student.name for row in marked.rows.rows},
        groups=marked.groups,
        pages=marker.wanted.pages,
    )


def write_similarity(
    programs: Mapping[str, bytes],
    given: tuple[bytes, ...],
    layout: Layout,
    title: str,
    *,
    names: Mapping[str, str],
    groups: Mapping[str, str],
    pages: bool = True,
) -> Ranking:
    """Write page and data, and return the ranking.

    Args:
        programs: By identifier.
        given: What everybody was given.
        layout: Of the results.
        title: Of the class.
        names: Of the students, by identifier.
        groups: By identifier, the same for those who handed in together.
        pages: Whether there are pages about the submissions to link to.
    """
    ranking = similarity(programs, given, groups)
    page = similarity_page(ranking, programs, title, names, pages=pages)
    write_atomically(layout.staff / PAGE, page.encode())
    write_atomically(layout.staff / DATA, to_bytes(ranking))
    return ranking
