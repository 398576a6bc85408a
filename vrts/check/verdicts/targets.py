"""What the goals and relations of a task have to say about the end of a run."""

from fractions import Fraction

from vrts.base.diagnostic import Datum, Diagnostic, Rule, Severity
from vrts.base.units import deg, mm
from vrts.check.goals.reached import Reached
from vrts.check.goals.related import FARTHEST
from vrts.check.rounding import exact_deg, exact_mm
from vrts.check.task.goals import Goal, Relation, Stands
from vrts.check.verdict import Answer, Verdict

NOT_REACHED = Rule("V660", "goal-not-reached")
PARTLY_REACHED = Rule("V661", "goal-missed-by-little")
NOT_RELATED = Rule("V680", "relation-not-kept")

MISSED_BY = {  # what is missing to be beside another object, and what was asked for
    Stands.LEFT: ("mm too far to the right", "left of"),
    Stands.RIGHT: ("mm too far to the left", "right of"),
    Stands.FARTHER: ("mm too near", "farther than"),
    Stands.NEARER: ("mm too far away", "nearer than"),
}


def verdicts(results: tuple[Reached, ...]) -> tuple[Verdict, ...]:
    """Return a verdict for every goal and relation."""
    return tuple(_verdict(result) for result in results)


def describe(result: Reached) -> str:
    """Return what is wrong with an object's place, in words after its name."""
    return f"{_place(result)}{_phases(result)}"


def _place(result: Reached) -> str:
    if result.problem is not None:
        return result.problem
    if isinstance(result.goal, Relation):
        return _relation(result, result.goal)
    parts: list[str] = []
    goal = result.goal
    which = f"its goal {result.where}" if result.where else "its goal"
    if result.position_mm > exact_mm(goal.position_tolerance):
        away = shown(result.position_mm, exact_mm(goal.position_tolerance))
        parts.append(f"is {away} mm from {which}")
    if result.orientation_deg > exact_deg(goal.orientation_tolerance):
        turned = shown(result.orientation_deg, exact_deg(goal.orientation_tolerance))
        parts.append(f"is turned {turned} degrees away from {'it' if parts else which}")
    return " and ".join(parts) or "is in place"


def _relation(result: Reached, wanted: Relation) -> str:
    off = shown(result.position_mm, exact_mm(wanted.tolerance or 0.0))
    other = f"`{wanted.other}`"
    if result.share == 1:
        return "is where it should be"
    match wanted.stands:
        case Stands.ON if result.position_mm >= exact_mm(FARTHEST):
            return f"does not stand on {other}"
        case Stands.ON:
            return f"is {off} mm beside the middle of {other}"
        case Stands.INSIDE:
            return f"sticks out of its box by {off} mm"
        case Stands.ALIGNED:
            parts: list[str] = []
            if result.position_mm > exact_mm(wanted.tolerance or 0.0):
                parts.append(f"is {off} mm out of line with {other}")
            if result.orientation_deg > exact_deg(wanted.turn_tolerance):
                turned = shown(result.orientation_deg, exact_deg(wanted.turn_tolerance))
                parts.append(f"is turned {turned} degrees away from {other}")
            return " and ".join(parts)
        case Stands.LEFT | Stands.RIGHT | Stands.FARTHER | Stands.NEARER:
            missed, words = MISSED_BY[wanted.stands]
            asked = f"{mm(wanted.distance):g} mm {words} {other}"
            return f"is {off} {missed} to be {asked}"


def _phases(result: Reached) -> str:
    """Return what an object went through, where points are given for it."""
    known = (("gripped", result.gripped), ("lifted", result.lifted))
    done = [word for word, so in known if so]
    open_ = [word for word, so in known if so is False]
    if result.share == 1 or not (done or open_):
        return ""
    words = [f"was {' and '.join(done)}"] if done else []
    words += [f"was not {' and not '.join(open_)}"] if open_ else []
    return f"; it {', but '.join(words)}"


def shown(value: Fraction, limit: Fraction) -> str:
    """Return a number as short as it can be told from a limit: "34", but "10.4" beside 10."""
    text = ""
    for decimals in (0, 1, 2):
        text = f"{float(value):.{decimals}f}"
        if value == limit or Fraction(text) != limit:
            break
    return text


def _verdict(result: Reached) -> Verdict:
    goal = result.goal
    summary = f"`{result.body}` {describe(result)}"
    evidence: dict[str, Datum] = {
        "position_mm": float(result.position_mm),
        "orientation_deg": float(result.orientation_deg),
        "share": round(float(result.share), 4),
    }
    if isinstance(goal, Relation) and result.position_mm >= exact_mm(FARTHEST):
        evidence.pop("position_mm")
    if result.where:
        evidence |= {"object": result.body, "place": result.where}
    for phase, so in (("gripped", result.gripped), ("lifted", result.lifted)):
        if so is not None:
            evidence[phase] = so
    if result.share == 1:
        return Verdict(goal.check, Answer.HOLDS, f"{goal.title}: {_fine(result)}", (), evidence)
    finding = Diagnostic(
        _rule(result),
        Severity.ERROR,
        summary,
        None,
        notes=(_tolerances(goal),),
        data={
            "object": result.body,
            "position_mm": float(result.position_mm),
            "orientation_deg": float(result.orientation_deg),
        },
    )
    return Verdict(goal.check, Answer.VIOLATED, summary, (finding,), evidence)


def _fine(result: Reached) -> str:
    if isinstance(result.goal, Relation):
        return "so it is"
    if not result.where:
        return "in place"
    return f"`{result.body}` is in place {result.where}"


def _rule(result: Reached) -> Rule:
    if isinstance(result.goal, Relation):
        return NOT_RELATED
    return NOT_REACHED if result.placed == 0 else PARTLY_REACHED


def _tolerances(goal: Goal | Relation) -> str:
    if isinstance(goal, Goal):
        position, orientation = mm(goal.position_tolerance), deg(goal.orientation_tolerance)
        return f"the goal, {goal.title}, allows {position:g} mm and {orientation:g} degrees"
    if goal.tolerance is None:
        return f"the task wants {goal.title}, exactly"
    return f"the task wants {goal.title}, within {mm(goal.tolerance):g} mm"
