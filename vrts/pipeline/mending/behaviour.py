"""A program that does the wrong thing, and the smallest changes that would earn the full mark."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.check.rules.hints import Hints
from vrts.lang.compiler import Options
from vrts.pipeline.assess import assess
from vrts.pipeline.execution import compiled_for
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of
from vrts.repair.edit import Candidate, Change
from vrts.repair.ranking import Repair, implausible, standing_out
from vrts.repair.search import Budget, search
from vrts.repair.trying.reach import Reach, reach
from vrts.repair.trying.trial import Place
from vrts.report.assessment import Assessment


class Mended(NamedTuple):
    """What would mend a program."""

    assessment: Assessment
    repairs: tuple[Repair, ...]  # likeliest first
    executions: int
    refused: str | None = None  # why nothing was looked for
    reach: Reach | None = None  # of the number that stands out: which others would do
    better: Repair | None = None  # where nothing earns the full mark: what earns most
    shown: tuple[int, ...] = ()  # lines at which what is lost shows; () where no line is known


def mended(
    request: Request,
    budget: Budget | None = None,
    *,
    reaching: bool = False,
    hints: Hints | None = None,
    only: Callable[[Candidate], bool] | None = None,
    hear: Callable[[], None] = lambda: None,
) -> Mended:
    """Return what would mend a program that compiles and loses points in its task.

    Args:
        request: The program and its setting.
        budget: How much is executed.
        reaching: Whether to look how far a number may go, where one stands out.
        hints: What may be told, whatever the task allows: of those who mark. None: as it says.
        only: Which changes are asked about; None: all.
        hear: Called before each that is tried; what it raises ends the search.
    """
    compiled = compiled_for(request)
    found = assess(request, compiled)
    why = _refused(request, found, hints)
    if why is not None:
        return Mended(found, (), 0, why)
    task, grade, run, judgement = found.task, found.grade, found.run, found.judgement
    assert task is not None
    assert grade is not None
    assert run is not None
    assert judgement is not None
    assert found.source is not None
    assert found.scene is not None
    assert compiled.compilation is not None
    if grade.mark == grade.total:
        return Mended(found, (), 0)
    place = Place(
        found.scene,
        task,
        scenario_of(request.setting),
        Options(compiled.compilation.dialect),
        request.program.name,
        request.entry or (task.program and task.program.lower()),
    )
    result = search(place, found.source, run, judgement, grade, budget or Budget(), only, hear)
    best = standing_out(result.repairs) if reaching else None
    far = None
    if best is not None and task.hints >= Hints.NUMBER:

        def legal(each: Change) -> bool:
            hear()
            return implausible(each) == 0

        far = reach(place, found.source, best.change, legal)
    return Mended(
        found,
        result.repairs,
        result.executions,
        reach=far,
        better=result.better,
        shown=result.blame.shown,
    )


def _refused(request: Request, found: Assessment, hints: Hints | None) -> str | None:
    """Return why nothing may or can be looked for."""
    task = found.task
    if task is None:
        return "only a task says what would be right: give `--task`, or put a `task.toml` beside it"
    if (task.hints if hints is None else hints) is Hints.NOTHING:
        return "the task allows no hints"
    if found.run is None:
        return "the program does not compile: `vrts fix` mends what is certain of its language"
    if request.reading.others:
        return "programs in several files are not mended: put them into one"
    if task.proof is not None or request.setting.hidden:
        return "a task that asks for every future, or has hidden checks, is not mended for"
    return None
