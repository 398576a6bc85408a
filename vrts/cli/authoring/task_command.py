"""`vrts task`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.authoring.fair_check import HowTo, check_variants, members_of
from vrts.cli.authoring.variants_command import command as variants
from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.cores import one_thread_each
from vrts.cli.shared.options import color_option, file_option, jobs_option, lab_option

if TYPE_CHECKING:
    from vrts.assignments.task_check import TaskCheck
    from vrts.assignments.task_folder import TaskFiles
    from vrts.base.diagnostic import Diagnostic
    from vrts.pipeline.setting import Setting

EPILOG = """\b
Examples:
  vrts task check lab1
  vrts task check lab1 --lab lab.toml
  vrts task check lab1 --write
  vrts task check lab1 --roster grades.csv
  vrts task pack lab1 -o handout
"""

folder_argument = click.argument("folder", type=click.Path(path_type=Path))


@click.group(name="task", epilog=EPILOG)
def command() -> None:
    """Check an assignment before it is handed out, and pack it."""


@command.command(name="check", epilog=EPILOG)
@folder_argument
@file_option(
    "--reference",
    help="The reference solution; without it staff/solution.v2 or solution.v2 in FOLDER.",
)
@lab_option
@click.option("--write", is_flag=True, help="Write the part of README.md that follows the task.")
@file_option("--roster", help="Of a task with variants: the class, as Moodle or Canvas export it.")
@file_option("--key", help="The key that decides; without it variants.key beside the task.")
@jobs_option("Variants that are tried at a time; without it, one for each core.")
@color_option
@guarded
def check(
    folder: Path,
    reference: Path | None,
    lab: Path | None,
    write: bool,
    roster: Path | None,
    key: Path | None,
    jobs: int | None,
    color: str,
) -> None:
    """Say whether the task in FOLDER, with its hidden part, is ready to be handed out.

    The reference must get the full mark, a program that does nothing must get 0, and every goal
    must be within reach. It proposes times, and lists what everything is worth. It warns where
    README.md does not say what the task says. With a lab, it says whether the task would work
    there. Exit status 1 when something is wrong.

    A task with `[variants]` is tried in a set of variants in which every value and every pair of
    values is, and with a roster in those of all students: each must be as the task has to be, and
    as hard as the others. What falls out is named. It says how often the solution of another
    student would earn more than half.
    """
    one_thread_each()
    from vrts.assignments.task_check import check_task
    from vrts.assignments.task_folder import reference_of
    from vrts.cli.authoring.mesh_pieces import task_pieces

    setting = _setting(folder, lab)
    if setting.task is None or setting.task.variants is None:
        for name, given in (("--roster", roster), ("--key", key)):
            if given is not None:
                help_ = "add `[variants]` to its task.toml"
                fail(f"`{name}` is for a task with variants", (help_,))
    members = members_of(roster)
    if write:
        _write_readme(_folder(folder))
    found = check_task(setting, reference or reference_of(_folder(folder)))
    told = (*_told(_folder(folder)), *task_pieces(setting, _folder(folder)))
    found = found._replace(findings=(*found.findings, *told))
    show_diagnostics(found.findings, color)
    out(_text(setting, found))
    ready = found.ready
    if setting.task is not None and setting.task.variants is not None:
        if lab is not None:
            say("note: variants are tried where the task is set, without `--lab`")
        elif ready:
            how = HowTo(reference, members, key, jobs, color)
            ready = check_variants(_folder(folder), how)
        else:
            say("note: variants are tried once the task itself is ready")
    sys.exit(HOLDS if ready else WRONG)


@command.command(name="pack", epilog=EPILOG)
@folder_argument
@file_option("-o", "--output", "target", default=Path("."))
@click.option(
    "--allow",
    "versions",
    multiple=True,
    metavar="VERSION",
    help="A version of vrts that may mark; without it this one.",
)
@color_option
@guarded
def pack(folder: Path, target: Path, versions: tuple[str, ...], color: str) -> None:
    """Write NAME-student.zip, without the folder `staff`, and NAME-staff.zip with everything.

    Students get task.toml, scenario.toml, README.md, start.v2, the scene, and the folders pictures
    and handout: nothing else. In README.md the part that follows the task is written again. The
    task must pass `vrts task check`.
    """
    from vrts.assignments.handed.of_folder import readme_to_hand_out
    from vrts.assignments.handed.readme import DIFFERS, NAME
    from vrts.assignments.pack import staff_zip, student_zip
    from vrts.assignments.task_check import check_task
    from vrts.assignments.task_folder import read_folder, reference_of
    from vrts.pipeline.settings import load_task

    setting = _setting(folder)
    found = check_task(setting, reference_of(_folder(folder)))
    if not found.ready:
        show_diagnostics(found.findings, color)
        fail("nothing is packed: the task does not pass `vrts task check`", status=WRONG)
    files = read_folder(_folder(folder))
    files.public[NAME] = readme_to_hand_out(_folder(folder), load_task(folder))
    told = _told(_folder(folder))
    show_diagnostics([d for d in told if d.rule is not DIFFERS], color)  # the rest is mended here
    student = student_zip(_for_students(files, setting, folder), setting.hidden, versions)
    staff = staff_zip(files, setting.hidden, versions)
    target.mkdir(parents=True, exist_ok=True)
    for data, audience, count in (
        (student, "student", len(files.public)),
        (staff, "staff", len(files.public) + len(files.staff)),
    ):
        path = target / f"{files.name}-{audience}.zip"
        write_file(path, data)
        out(f"{path}: {count} files")
    checks = "1 hidden check" if setting.hidden == 1 else f"{setting.hidden} hidden checks"
    out(f"students are told of {checks}")
    rules = None if setting.task is None else setting.task.late
    if rules is not None and rules.opens is not None:
        opens = rules.opens.isoformat(" ")
        out(f"exam: hand {files.name}-student.zip out at {opens}; a zip cannot lock itself")


command.add_command(variants)


def _for_students(files: "TaskFiles", setting: "Setting", folder: Path) -> "TaskFiles":
    """Return the files of a task without `[variants]`, which is for staff."""
    if setting.task is None or setting.task.variants is None:
        return files
    from vrts.assignments.handed.readme import NAME as README
    from vrts.assignments.variants.of_task import load_varied

    own = "`vrts task variants` gives each student their own"
    say(f"note: students get the task as it is written; {own}")
    written = load_varied(folder).as_written()
    return files._replace(
        public={**files.public, **{n: written[n] for n in written if n != README}}
    )


def _folder(path: Path) -> Path:
    return path if path.is_dir() else path.parent


def _setting(folder: Path, lab: Path | None = None) -> "Setting":
    from vrts.pipeline.files import TASK_FILE
    from vrts.pipeline.settings import load_task

    if folder.is_dir() and not (folder / TASK_FILE).is_file():
        fail(f"there is no `{TASK_FILE}` in `{folder}`", (f"begin with `vrts new task {folder}`",))
    return load_task(folder, staff=True, lab=lab)


def _told(folder: Path) -> "tuple[Diagnostic, ...]":
    """Return where the words for students are not those of the task in a folder."""
    from vrts.assignments.handed.of_folder import handed_findings
    from vrts.pipeline.settings import load_task

    return handed_findings(folder, load_task(folder))


def _write_readme(folder: Path) -> None:
    """Write the part of README.md that follows the task, where it is not as it should be."""
    from vrts.assignments.handed.of_folder import readme_to_hand_out
    from vrts.assignments.handed.readme import NAME
    from vrts.pipeline.settings import load_task

    path = folder / NAME
    data = readme_to_hand_out(folder, load_task(folder))
    if path.is_file() and path.read_bytes() == data:
        return
    write_file(path, data)
    say(f"wrote {path}")


def _text(setting: "Setting", found: "TaskCheck") -> str:
    """Return what was found out, for the terminal."""
    from vrts.report.plain import plain_text

    task = setting.task
    assert task is not None
    total = f"{float(task.mark.total):g}"
    wide = max(4, len(f"{float(task.mark.total):.1f}"))
    lines = [f"{task.title}: {'ready to be handed out' if found.ready else 'not ready'}"]
    if found.reference is not None and found.reference.grade is not None:
        lines.append(f"  reference      {float(found.reference.grade.mark):{wide}.1f} of {total}")
    assert found.empty.grade is not None
    lines.append(f"  empty program  {float(found.empty.grade.mark):{wide}.1f} of {total}")
    lines.append(f"  hidden checks  {setting.hidden:2d}")
    if found.times is not None:
        lines += ["", "times [s]        now   from the reference"]
        times = found.times
        lines.append(f"  reference_s      -   {float(times.reference_s):6.2f}")
        lines.append(f"  t_par_s     {task.t_par:6.2f}   {float(times.t_par_s):6.2f}")
        lines.append(f"  t_max_s     {task.t_max:6.2f}   {float(times.t_max_s):6.2f}")
    lines += ["", "points  lost by"]
    lines += [f"  {float(worth.points):{wide + 1}.2f}  {worth.what}" for worth in found.worths]
    return plain_text("\n".join(lines))
