"""What a program does, beside what a step asks of it."""

from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.base.pose import Pose
from vrts.check.verdict import Answer as Verdicts
from vrts.engine.memory.events import Grasped
from vrts.engine.memory.records import Ending
from vrts.learn.lesson import DONE, Answer, ProgramWish
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen
from vrts.scene.reach import reach

COLLISION = "collision"  # name of the verdict


def look_at_program(wish: ProgramWish, assessed: Callable[[], Assessment], path: Path) -> Answer:
    """Return whether a program does what a step asks for: the first thing that it does not do.

    Args:
        wish: What is asked for.
        assessed: Compiles, executes and checks the program.
        path: Of its file.
    """
    if not path.is_file():
        return not_there(wish.file)
    a = assessed()
    if wish.finds is not None:
        return _finds(a, wish.finds)
    errors = [d for d in a.diagnostics if d.is_error]
    if a.module is None:
        nothing = Answer(done=False, why="there is no program in it yet")
        return said(errors[0]) if errors else nothing
    for answer in _asked(wish, a):
        if not answer.done:
            return answer
    return DONE


def _asked(wish: ProgramWish, a: Assessment) -> Iterable[Answer]:
    """Ask one thing after the other."""
    yield _teaches(wish, a)
    if wish.own_places:
        yield _own_places(wish, a)
    if wish.holds is not None:
        yield _holds(a, wish.holds)
    yield from (_in_place(a, name) for name in wish.in_place)
    if wish.untouched:
        yield _untouched(a)
    if wish.mark is not None:
        yield mark_reached(a, wish.mark)


def not_there(name: str, what: str = "file") -> Answer:
    """Return what is said where something has not been made yet."""
    return Answer(done=False, why=f"there is no {what} `{name}` yet")


def said(d: Diagnostic) -> Answer:
    """Return a diagnostic as an answer, with its line and its help."""
    line = "" if d.primary is None else f"line {d.primary.span.line}: "
    hint = d.help[0] if d.help else f"`vrts explain {d.rule.code}` says more"
    return Answer(done=False, why=f"{line}{d.headline}", hint=hint)


def mark_reached(a: Assessment, mark: Fraction) -> Answer:
    """Return whether a mark is reached; what costs most where it is not."""
    if a.grade is None:
        return Answer(done=False, why="there is no task to mark it by")
    if a.grade.mark >= mark:
        return DONE
    screen = first_screen(a)
    why = f"the mark is {float(a.grade.mark):.1f}, and {float(mark):.1f} is wanted: {screen.cause}"
    return Answer(done=False, why=why, hint=screen.hint or "")


def _teaches(wish: ProgramWish, a: Assessment) -> Answer:
    taught = {datum.name for datum in (a.module.data if a.module else ())}
    missing = [name for name in wish.teaches if name not in taught]
    if not missing:
        return DONE
    return Answer(done=False, why=f"`{wish.file}` does not say yet where `{missing[0]}` is")


def _own_places(wish: ProgramWish, a: Assessment) -> Answer:
    assert a.module is not None
    assert a.scene is not None
    known = a.scene.locations
    own = [datum for datum in a.module.data if datum.name not in known]
    poses = {datum.name: datum.value for datum in own if isinstance(datum.value, Pose)}
    good = [name for name, X_WT in poses.items() if reach(a.scene, X_WT).reachable]
    if len(good) >= wish.own_places:
        return DONE
    if poses:
        why = f"the arm cannot reach `{next(iter(poses))}`"
        return Answer(done=False, why=why, hint="go nearer to the robot")
    return Answer(done=False, why=f"`{wish.file}` has no location of your own yet")


def _holds(a: Assessment, name: str) -> Answer:
    events = () if a.run is None else a.run.events
    if any(isinstance(event, Grasped) and event.body == name for event in events):
        return DONE
    return _or_first_error(a, f"the hand never takes hold of `{name}`")


def _in_place(a: Assessment, name: str) -> Answer:
    verdicts = () if a.judgement is None else a.judgement.verdicts
    for verdict in verdicts:
        if verdict.check == f"target {name}" and verdict.answer is Verdicts.HOLDS:
            return DONE
        if verdict.check == f"target {name}":
            return _or_first_error(a, verdict.summary)
    return _or_first_error(a, f"`{name}` is not at its goal")


def _untouched(a: Assessment) -> Answer:
    verdicts = () if a.judgement is None else a.judgement.verdicts
    for verdict in verdicts:
        if verdict.check == COLLISION and verdict.answer is Verdicts.HOLDS:
            return DONE
        if verdict.check == COLLISION and verdict.findings:
            return said(verdict.findings[0])
    return _or_first_error(a, "nothing shows yet that the way is free")


def _finds(a: Assessment, code: str) -> Answer:
    if any(d.rule.code == code for d in a.findings):
        return DONE
    return Answer(done=False, why=f"{code} is not found in it", hint=f"`vrts explain {code}`")


def _or_first_error(a: Assessment, why: str) -> Answer:
    """Return an answer; the error that stopped the run, if one did, comes before it."""
    errors = [d for d in a.findings if d.is_error]
    if errors and (a.run is None or a.run.ending is Ending.ERROR):
        return said(errors[0])
    return Answer(done=False, why=why)
