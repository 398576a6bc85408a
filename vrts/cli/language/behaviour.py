"""`vrts fix --behaviour`: what a program does, mended by one change.

It needs a robot: it is imported only when it is asked for.
"""

from collections.abc import Sequence
from pathlib import Path

from vrts.assignments.packed import found_setting
from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.cli.language.changes import file_shown, print_diff
from vrts.cli.shared.console import HOLDS, WRONG, fail, out, out_bytes, say, warn, write_file
from vrts.cli.shared.options import Language
from vrts.cli.shared.programs import Given, given_program
from vrts.cli.shared.requests import verify_request
from vrts.pipeline.compiling.fixing import rewritten
from vrts.pipeline.mending.behaviour import Mended, mended
from vrts.pipeline.where import Where
from vrts.repair.ranking import Repair, standing_out
from vrts.repair.telling import most, sentence, shows
from vrts.report.plain import plain_text


def mend_behaviour(
    programs: Sequence[str], task: Path | None, dialect: str, *, show: bool, write: bool
) -> int:
    """Mend each program, or say what would; return the exit status."""
    status = HOLDS
    for program in programs:
        given = given_program(program)
        setting = found_setting(given.path, Where(task=task))
        if setting is None or setting.task is None:
            fail(
                "only a task says what would be right",
                ("give `--task`, or put a `task.toml` beside the program",),
            )
        request = verify_request(given, setting, Language(dialect=dialect))
        found = mended(request, reaching=not (show or write))
        status = max(status, _done(found, given, show=show, write=write))
    return status


def _done(found: Mended, given: Given, *, show: bool, write: bool) -> int:
    """Tell or write what would mend a program; return the exit status for it."""
    name, task, grade = given.program.name, found.assessment.task, found.assessment.grade
    if found.refused is not None:
        warn(f"{name}: {found.refused}")
        return WRONG
    assert task is not None
    assert grade is not None
    if grade.mark == grade.total:
        say(f"{name}: nothing to mend: it earns {float(grade.mark):g}")
        if write and given.path is None:
            out_bytes(given.program.data)
        return HOLDS
    best = standing_out(found.repairs)
    if (show or write) and task.hints < Hints.EDIT:
        warn(f"{name}: the task does not allow a hint that tells the change")
    elif (show or write) and best is not None:
        _changed(found, best, given, write=write)
        return HOLDS
    told = sentence(found.repairs, task.hints, found.reach)
    if told is None:
        nothing = f"{name}: {float(grade.mark):g}; no change was found that earns the full mark"
        where = shows(found.shown, task.hints)
        nothing = nothing if where is None else f"{nothing}; {where}"
        earns_most = None if found.better is None else most(found.better, task.hints)
        if earns_most is None:
            warn(nothing)
        else:
            out(plain_text(f"{nothing}; {earns_most}"))
        return WRONG
    out(plain_text(f"{name}: {float(grade.mark):g}; {told}"))
    return WRONG if show or write else HOLDS


def _changed(found: Mended, best: Repair, given: Given, *, write: bool) -> None:
    """Print the change as a diff, or write it."""
    name, source = given.program.name, found.assessment.source
    assert isinstance(source, SourceFile)
    if not write:
        print_diff(source.text, best.text, name)
        return
    data = rewritten(given.program.data, best.change.edits)
    if given.path is None:
        out_bytes(data)
    else:
        write_file(given.path, data)
        say(f"mended {file_shown(given.path, name)}: it now earns {float(best.mark):g}")
