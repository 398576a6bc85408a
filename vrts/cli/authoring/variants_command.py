"""`vrts task variants`."""

from pathlib import Path

import click

from vrts.cli.authoring.fair_check import by_name
from vrts.cli.shared.console import WRONG, fail, guarded, out, say, show_diagnostics, write_file
from vrts.cli.shared.cores import one_thread_each, workers_of
from vrts.cli.shared.options import color_option, file_option, jobs_option
from vrts.cli.shared.progress import Progress

EPILOG = """\b
Examples:
  vrts task variants lab1 --roster grades.csv -o zips
  vrts task variants lab1 --roster grades.csv -o zips --key ~/lab1.key

\b
Afterwards, with the same list and the same key:
  vrts grade lab1 download.zip --roster grades.csv -o out
"""


@click.command(name="variants", epilog=EPILOG)
@click.argument("task", type=click.Path(path_type=Path))
@file_option(
    "--roster",
    "class_list_file",
    required=True,
    help="Moodle's grading worksheet, or the grade book of Canvas: who is in the class.",
)
@file_option("-o", "--output", "target", required=True, help="Folder for zips and table.")
@file_option("--key", help="The key that decides; without it variants.key beside the task.")
@click.option(
    "--allow",
    "versions",
    multiple=True,
    metavar="VERSION",
    help="A version of vrts that may mark; without it this one.",
)
@click.option("--untried", is_flag=True, help="Do not try the variants of the class first.")
@jobs_option("Variants that are tried and written at a time; without it, one for each core.")
@color_option
@guarded
def command(
    task: Path,
    class_list_file: Path,
    target: Path,
    key: Path | None,
    versions: tuple[str, ...],
    untried: bool,
    jobs: int | None,
    color: str,
) -> None:
    """Write a zip of TASK for each student of a class, with the variant of that student.

    TASK is a folder or a zip with `[variants]` in its task.toml. OUTPUT/students has the zips: the
    files of `vrts task pack` for students, with the numbers of that variant. OUTPUT/variants.csv
    tells who has which, and is not for students. With Moodle's list, moodle-feedback.zip has them
    all, for "Upload multiple feedback files in a zip". Canvas has nothing like it before hand-ins.

    A key decides which variant each gets. If there is none, it is made, and only its owner may read
    it. With another key everybody has another variant: keep a copy. Beside it KEY.handed.json tells
    what was handed out: who is in there keeps that variant, and is marked by it.

    The task as it is written must pass `vrts task check`; of a zip this is not looked at again. The
    variants of the class must be as the task has to be, and as hard as each other: else nothing is
    written, unless you say --untried.
    """
    one_thread_each()
    from vrts.assignments.fair.fairness import fairness
    from vrts.assignments.fair.in_words import fair_findings
    from vrts.assignments.packed import is_packed
    from vrts.assignments.task_check import check_task
    from vrts.assignments.task_folder import reference_of
    from vrts.assignments.variants.key import (
        key_made,
        note_handed,
        place_of_handed,
        place_of_key,
    )
    from vrts.assignments.variants.of_task import load_varied
    from vrts.marking.intake.tables.roster import read_roster
    from vrts.marking.variants.class_list import class_list
    from vrts.marking.variants.hand_out import MOODLE, STUDENTS, TABLE, hand_out
    from vrts.marking.variants.handed import (
        changed,
        changed_since,
        handed_bytes,
        read_handed,
        record_gone,
        variants_of,
    )
    from vrts.pipeline.files import read_bytes

    if not task.exists():
        fail(f"there is no `{task}`")
    if target.exists() and not target.is_dir():
        fail(f"`{target}` is a file, and zips want a folder", ("name another one with `-o`",))
    varied = load_varied(task)
    varied.as_written()  # which students could not read, it says
    members = class_list(
        read_roster(read_bytes(class_list_file), class_list_file.name, None), class_list_file.name
    )
    if not is_packed(task):
        found = check_task(varied.base, reference_of(task if task.is_dir() else task.parent))
        if not found.ready:
            show_diagnostics(found.findings, color)
            fail("nothing is written: the task does not pass `vrts task check`", status=WRONG)
    place = key or place_of_key(task)
    secret, made = key_made(place)
    if made:
        say(f"made the key {place}: keep a copy, and give it to no student")
    varied = varied.with_key(secret)
    was = read_handed(place, secret, varied.variants.assignment)
    show_diagnostics(record_gone(place, varied.variants.assignment, was), color)
    show_diagnostics(changed_since(place, secret, varied), color)
    given = variants_of(varied, members, secret, was)
    if given.gone:
        raise changed(given.gone, place)
    if not untried and varied.solution is not None:
        trying = Progress()
        named = by_name(members, given.variants)
        tried = fairness(varied, named, workers_of(jobs), trying.advance)
        trying.clear()
        if not tried.fair:
            show_diagnostics(fair_findings(varied.variants, tried), color)
            remedies = ("`vrts task check TASK --roster LIST` tells more",)
            remedies += ("hand them out all the same with `--untried`",)
            fail("nothing is written: not all variants are fit to be handed out", remedies, WRONG)
    writing = Progress()
    handed = hand_out(varied, members, given.variants, versions, workers_of(jobs), writing.advance)
    writing.clear()
    _check_no_others(target / STUDENTS, [Path(name).name for name in handed.files])
    record = handed_bytes(place, secret, varied, members, given)
    show_diagnostics(handed.told, color)
    if handed.same_pictures:
        say(f"note: these pictures are the same for all: {', '.join(handed.same_pictures)}")
    (target / STUDENTS).mkdir(parents=True, exist_ok=True)
    for name, data in handed.files.items():
        write_file(target / name, data, private=True)
    write_file(target / TABLE, handed.table, private=True)
    write_file(place_of_handed(place), record, private=True)
    note_handed(place, varied.variants.assignment)
    if handed.moodle is not None:
        write_file(target / MOODLE, handed.moodle, private=True)
    count = len(handed.files)
    students = "1 student" if count == 1 else f"{count} students"
    different = "1 variant" if handed.variants == 1 else f"{handed.variants} different variants"
    out(f"{target / STUDENTS}: zips for {students}, {different}")
    out(f"{target / TABLE}: who has which; not for students")
    if handed.moodle is not None:
        out(f"{target / MOODLE}: all zips, to be uploaded as feedback files")
    else:
        say("note: attach each zip in SpeedGrader: Canvas takes feedback only for what it received")


def _check_no_others(folder: Path, names: list[str]) -> None:
    """Fail where zips of somebody else, or of another hand-out, would stay beside the new ones."""
    others = sorted({path.name for path in folder.glob("*.zip")} - set(names))
    if others:
        more = f" and {len(others) - 1} more" if len(others) > 1 else ""
        fail(
            f"`{folder}` has zips of nobody in the list: `{others[0]}`{more}",
            ("delete them, or name another folder with `-o`",),
        )
