"""What the via points of a task have to say about a run."""

import numpy as np

from vrts.base.beside import beside
from vrts.base.diagnostic import Diagnostic, Label, Moment, Rule, Severity
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.timeline_arrays import lasting_of
from vrts.check.rounding import exact_deg, exact_mm, exact_s
from vrts.check.verdict import Answer, Verdict
from vrts.check.verdicts.vias import Lack, Passed, Visits
from vrts.engine.run import Run

VIA_MISSED = Rule("V662", "via-point-missed")
VIA_ORDER = Rule("V663", "via-point-order")
VIA_DIRECTION = Rule("V440", "via-point-direction")
VIA_SPEED = Rule("V441", "via-point-speed")
VIA_DOUBTFUL = Rule("V442", "undetermined-via-point")

METHOD = "certified on the polynomials"


def verdicts(run: Run, result: Passed) -> tuple[Verdict, ...]:
    """Return a verdict for every via point."""
    rows = zip(result.visits, result.lacks, result.certain, strict=True)
    return tuple(_verdict(run, visits, lack, certain=certain) for visits, lack, certain in rows)


def _verdict(run: Run, visits: Visits, lack: Lack | None, *, certain: bool) -> Verdict:
    name = visits.via.name
    check, evidence = f"via {name}", {"method": METHOD}
    if lack is None and certain:
        return Verdict(check, Answer.HOLDS, f"`{name}` is passed", (), evidence)
    if lack is None:
        time_s = _first_s(visits)
        summary = f"too near to tell: whether `{name}` is passed as it should be"
        finding = _finding(run, VIA_DOUBTFUL, Severity.WARNING, summary, time_s)
        return Verdict(check, Answer.UNDETERMINED, summary, (finding,), evidence)
    time_s = _first_s(visits) if lack is Lack.ORDER else visits.best_s
    rule = RULES.get(lack, VIA_MISSED)
    summary = _shortfall(visits, lack)
    finding = _finding(run, rule, Severity.ERROR, summary, time_s)
    return Verdict(check, Answer.VIOLATED, summary, (finding,), {**evidence, **_best(visits, lack)})


def _first_s(visits: Visits) -> float:
    return (visits.intervals or visits.doubtful)[0][0]


RULES = {
    Lack.DIRECTION: VIA_DIRECTION,
    Lack.TOO_FAST: VIA_SPEED,
    Lack.TOO_SLOW: VIA_SPEED,
    Lack.ORDER: VIA_ORDER,
}


def _shortfall(visits: Visits, lack: Lack) -> str:
    via, best = visits.via, visits.best
    match lack:
        case Lack.PLACE:
            near, wanted = beside(exact_mm(visits.nearest_m), exact_mm(via.radius), least=0)
            return (
                f"the tool never comes nearer than {near} mm to `{via.name}`; {wanted} mm is wanted"
            )
        case Lack.DIRECTION:
            turned, allowed = beside(exact_deg(best), exact_deg(via.cone), plain=True)
            return (
                f"the tool passes `{via.name}` turned {turned} degrees away from the"
                f" direction asked for; {allowed} are allowed"
            )
        case Lack.TOO_FAST:
            speed, most = beside(exact_mm(best), exact_mm(via.fastest), plain=True)
            return f"the tool passes `{via.name}` at {speed} mm/s; {most} mm/s is the most allowed"
        case Lack.TOO_SLOW:
            speed, few = beside(exact_mm(best), exact_mm(via.slowest), plain=True)
            return f"the tool passes `{via.name}` at {speed} mm/s; {few} mm/s is the least allowed"
        case Lack.ORDER:
            return f"`{via.name}` is passed, but not in the order of the task"


def _best(visits: Visits, lack: Lack) -> dict[str, float]:
    """Return what came nearest to what was asked for."""
    match lack:
        case Lack.PLACE:
            found = {"distance_mm": float(exact_mm(visits.best))}
        case Lack.DIRECTION:
            found = {"angle_deg": float(exact_deg(visits.best))}
        case Lack.TOO_FAST | Lack.TOO_SLOW:
            found = {"speed_mm_s": float(exact_mm(visits.best))}
        case Lack.ORDER:
            return {}
    return {**found, "at_s": float(exact_s(visits.best_s))}


def _finding(run: Run, rule: Rule, severity: Severity, headline: str, time_s: float) -> Diagnostic:
    time_s = min(time_s, run.horizon_s)
    when = f"at {float(exact_s(time_s)):.3f} s"
    if not lasting_of(run.timeline.segments):
        return Diagnostic(rule, severity, headline)
    motion = motion_of(run)
    at = np.array([time_s])
    index = int(motion.motions[motion.piece_at(at)[0]])
    label = None if index < 0 else Label(run.motions[index].cause.span, when)
    notes = () if label is not None else (when,)
    moment = Moment(time_s, tuple(motion.values(at)[0].tolist()))
    return Diagnostic(rule, severity, headline, label, notes=notes, moment=moment)
