"""The files about one submission: two pages, a recording, what its run did, and our faults."""

from collections.abc import Collection
from pathlib import Path

from vrts.marking.submission.one import Marked, Wanted
from vrts.marking.submission.sketch import SKETCH, sketch
from vrts.marking.submission.sketch import to_bytes as sketch_to_bytes
from vrts.pipeline.curve import with_curve
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience, for_student
from vrts.report.page.html import Markup
from vrts.report.page.page import page_parts, replay_scripts
from vrts.report.page.stills import page_stills

REPORT, RECORDING, FAULT = "report.html", "run.rrd", "fault.txt"


class Reader:
    """Somebody for whom files are written: a student, or whoever marks."""

    def __init__(self, folder: Path, setting: Setting, *, grader: bool) -> None:
        """Take the folder, and the setting that the program was marked in for this reader."""
        self.folder = folder
        self.setting = setting
        self.grader = grader


def write_files(
    staff: tuple[Marked, Reader],
    student: tuple[Marked, Reader],
    wanted: Wanted,
    hidden: Collection[str] = (),
) -> None:
    """Write what is wanted about one submission, for both; what is the same is made once.

    Args:
        staff: What was found out for those who mark.
        student: The same for the student; may be the same assessment.
        wanted: Which files.
        hidden: Names of the checks that students do not see.
    """
    rows = (staff, student)
    for _, reader in rows:
        reader.folder.mkdir(parents=True, exist_ok=True)
    if wanted.pages:
        _write_pages(rows, hidden)
    a = student[0].assessment
    if wanted.recordings and a.run is not None:
        from vrts.report.recording import write_recording  # rerun is optional, and heavy

        write_recording(a, student[1].folder / RECORDING)
    if a.run is not None and a.scene is not None:
        (staff[1].folder / SKETCH).write_bytes(sketch_to_bytes(sketch(a.run, a.scene)))
    if staff[0].fault is not None:
        (staff[1].folder / FAULT).write_bytes(staff[0].fault.encode())


def _write_pages(rows: tuple[tuple[Marked, Reader], ...], hidden: Collection[str]) -> None:
    made: dict[int, tuple[Assessment, dict[str, bytes], list[Markup]]] = {}
    for row, reader in rows:
        a = row.assessment
        if id(a) not in made:
            curved = with_curve(a)
            made[id(a)] = (curved, page_stills(a), replay_scripts(for_student(curved)))
        full, stills, scripts = made[id(a)]
        audience = Audience.GRADER if reader.grader else Audience.STUDENT
        more = 0 if reader.grader else reader.setting.more
        parts = page_parts(
            full, stills, audience=audience, more=more, hidden=hidden, scripts=scripts
        )
        with (reader.folder / REPORT).open("wb") as file:
            file.writelines(part.encode() for part in parts)
