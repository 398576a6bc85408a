"""What a proof over every future says, in sentences: the same on every medium."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.check.verdict import Answer
from vrts.prove.proof import Decided, Proof, What, Wronged
from vrts.report.plain import capital, one_line

IN_SOME_FUTURE = Rule("V560", "in-some-future")


def counted(number: int, noun: str) -> str:
    """Return `1 state`, `1,234 states`."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}"


def diagnostic(wronged: Wronged) -> Diagnostic:
    """Return what goes wrong in a future as a diagnostic at its step."""
    cause = wronged.cause
    label = None if cause is None else Label(cause.span, "here")
    return Diagnostic(
        IN_SOME_FUTURE,
        Severity.ERROR,
        f"{_when(wronged)}: {wronged.headline}",
        label,
        notes=tuple(_noted(*row) for row in story(wronged)[:-1]),
        data={"wrong": wronged.wrong.value, "time_s": wronged.time_s},
    )


def _when(wronged: Wronged) -> str:
    kinds = {one.what for one in wronged.decisions}
    if not kinds:
        return "even if nothing comes from outside"
    return "for some inputs" if kinds == {What.INPUT} else "in some future"


def _noted(time_s: float, where: str, what: str) -> str:
    return f"at {time_s:.3f} s{', ' if where else ''}{where}: {what}"


def headline(proof: Proof) -> str:
    """Return the answer as one sentence, without a stop."""
    match proof.answer:
        case Answer.HOLDS:
            return "Nothing goes wrong, in any future"
        case Answer.VIOLATED:
            others = len(proof.found) - 1
            more = f"; {counted(others, 'other thing')} can go wrong too" if others else ""
            return f"This can go wrong: {one_line(proof.found[0].headline)}{more}"
        case Answer.UNDETERMINED:
            return "Nothing went wrong in the futures that were looked at, but not all were"


def counts(proof: Proof) -> str:
    """Return how much was looked at."""
    covered = proof.covered
    parts = [
        counted(covered.states, "state"),
        counted(covered.decisions, "decision"),
        counted(covered.ends, "end"),
    ]
    return f"{', '.join(parts)}; {covered.motion_s:.1f} s of different motion checked for contacts"


def decision(decided: Decided) -> str:
    """Return what outside decided, as the part of a sentence: `input 1001 goes on`."""
    value = decided.value
    match decided.what:
        case What.INPUT:
            return f"input {decided.number} is {'on' if value else 'off'}"
        case What.ANSWER:
            return f"the operator answers {one_line(repr(value))}"
        case What.RANDOM:
            return f"RANDOM draws {value:g}" if isinstance(value, float) else "RANDOM draws"
        case What.GRIP:
            return "the hand grips" if value else "the hand misses"
        case What.STOP:
            return f"the operator stops the program, then: {one_line(str(value))}"
        case What.SPEED:
            return f"the monitor speed is {value} %"
        case What.AGAIN:
            return "the program is executed again"


def place(wronged: Wronged | Decided) -> str:
    """Return where in the program: `line 17`, or nothing."""
    return f"line {wronged.cause.span.line}" if wronged.cause is not None else ""


def story(wronged: Wronged) -> list[tuple[float, str, str]]:
    """Return (time [s], where, what) of each decision that matters, and of what goes wrong."""
    rows = [(one.time_s, place(one), decision(one)) for one in wronged.decisions]
    return [*rows, (wronged.time_s, place(wronged), capital(one_line(wronged.headline)))]
