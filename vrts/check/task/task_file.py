"""Reads `task.toml`: what is asked for, times and weights, in millimetres and degrees."""

import hashlib
import re
from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.base.units import MM
from vrts.check.rules.hints import Hints, read_hints
from vrts.check.rules.mark_file import read_mark
from vrts.check.rules.proof_file import read_proof
from vrts.check.rules.settings_file import read_settings
from vrts.check.task.demand_file import read_demands
from vrts.check.task.goal_file import read_goals
from vrts.check.task.late_file import read_exam, read_keep, read_late
from vrts.check.task.relation_file import read_relations
from vrts.check.task.task import Task
from vrts.check.task.via_file import read_via
from vrts.check.variants.section import read_variants
from vrts.controllers.models import MODELS
from vrts.scene.model import Scene

TIMES = Rule("V654", "times")
NOTHING_ASKED = Rule("V659", "nothing-asked")

PAR_SHARE = Fraction(5, 4)  # t_par is this times the reference solution
MAX_SHARE = 2  # t_max is this times t_par
ASKS = ("goal", "relation", "via", "zone", "upright", "limit", "rule", "prove")  # sections
NEAR_MISS_MM = 1.0, 50.0  # least and most of `near_miss_mm`


def read_task(
    source: SourceFile, scene: Scene, name: str | None = None
) -> tuple[Task | None, tuple[Diagnostic, ...]]:
    """Return the task a file describes, or None, with everything there is to say about it.

    Args:
        source: The file.
        scene: What the task is done in.
        name: Of the task; None: the folder's, as the source's name shows it.
    """
    top, problems = read_toml(source)
    named = name or _folder_shown(source)
    task = None if top is None else _task(top, problems, source, scene, named)
    if problems.any_error:
        task = None
    return task, problems.in_order()


def _folder_shown(source: SourceFile) -> str:
    folder = [part for part in re.split(r"[/\\]", source.name) if part]
    return folder[-2] if len(folder) > 1 else "task"


def _task(
    top: Table, problems: Problems, source: SourceFile, scene: Scene, name: str
) -> Task | None:
    section = top.table("task", required=True)
    if section is None:
        return None
    title = section.string("title", name)
    description = section.string("description", "").strip()
    scene_name = section.string("scene", required=True) or ""
    section.string("lab")  # for `task_places`
    section.string("controller", choices=MODELS)  # for `task_places`
    program = section.string("program")
    ordered = section.boolean("ordered", default=False)
    section.finish()
    goals = read_goals(top, problems, scene)
    relations = read_relations(top, problems, scene)
    vias = tuple(read_via(t, problems, number) for number, t in enumerate(top.tables("via"), 1))
    mark = read_mark(top, problems)
    demands = read_demands(top, problems, scene, mark.total)
    if not any(key in top for key in ASKS):
        _nothing_asked(top, problems)
    t_par, t_max = _times(top, problems)
    near_miss = _near_miss(top)
    late, keep = read_late(top, problems, mark.total), read_keep(top)
    exam = read_exam(top, problems)
    if exam is not None:
        late, keep = exam.rules, exam.keep
    locks = read_settings(top, problems)
    proof = read_proof(top, problems, mark.total)
    hints = read_hints(top)
    variants = read_variants(top, problems)
    if exam is not None and not exam.hints:
        hints = Hints.NOTHING
    top.finish()
    return Task(
        name,
        title,
        scene_name,
        program.lower() if program else None,
        goals,
        vias,
        ordered,
        t_par,
        t_max,
        mark,
        hashlib.sha256(source.text.encode()).hexdigest(),
        demands,
        near_miss,
        late,
        keep,
        relations,
        locks,
        proof,
        hints,
        description,
        variants,
        exam is not None and exam.offline,
    )


def _nothing_asked(top: Table, problems: Problems) -> None:
    problems.error(
        NOTHING_ASKED,
        "the task asks for nothing",
        top.span_of("task"),
        help=("add a `[[goal]]`, a `[[via]]`, or another thing to do or to keep to",),
    )


def _times(top: Table, problems: Problems) -> tuple[float, float]:
    section = top.table("time", required=True)
    if section is None:
        return 0.0, 0.0
    reference = section.fraction("reference_s", minimum=0.001, maximum=3600)
    par = section.fraction("t_par_s", minimum=0.001, maximum=3600)
    longest = section.fraction("t_max_s", minimum=0.001, maximum=7200)
    given = (("reference_s", reference), ("t_par_s", par), ("t_max_s", longest))
    section.finish()
    if any(key in section and found is None for key, found in given):
        return 0.0, 0.0  # said already
    if par is None and reference is not None:
        par = PAR_SHARE * reference
    if par is None:
        problems.error(
            TIMES,
            "the task does not say how long a good solution takes",
            section.span,
            help=("add `reference_s`, the duration of the reference solution in seconds",),
        )
        return 0.0, 0.0
    longest = MAX_SHARE * par if longest is None else longest
    if longest <= par:
        problems.error(
            TIMES,
            f"`t_max_s` must be more than {float(par):g} s, the time of a good solution",
            section.value_span("t_max_s"),
        )
    return float(par), float(longest)


def _near_miss(top: Table) -> float | None:
    section = top.table("collision")
    if section is None:
        return None
    least, most = NEAR_MISS_MM
    distance = section.number("near_miss_mm", minimum=least, maximum=most)
    section.finish()
    return None if distance is None else distance * MM
