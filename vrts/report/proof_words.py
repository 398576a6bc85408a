"""What a proof over every future says, in sentences: the same on every medium."""

from dataclasses import replace
from types import MappingProxyType

from vrts.base.diagnostic import Datum, Diagnostic, Label, Rule, Severity
from vrts.check.mark.losses import where
from vrts.check.verdict import Answer
from vrts.prove.proof import Decided, Proof, What, Wronged
from vrts.report.plain import capital, one_line
from vrts.scene.writing.scenario_text import scenario_text

IN_SOME_FUTURE = Rule("V560", "in-some-future")
FUTURES_LEFT = Rule("V564", "futures-left")

MOST_TOLD = 3  # lines of a story where it is one finding among others
SEE_IT = (
    "write it as a scenario with `vrts prove PROGRAM{environment} --counterexample bad.toml`,"
    " and look at it with `--scenario bad.toml`"
)


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
        case What.ANALOG:
            return f"analog input {decided.number} reads {value:g}"
        case What.ANSWER:
            return f"the operator answers {one_line(repr(value))}"
        case What.RANDOM:
            return f"RANDOM draws {value:g}" if isinstance(value, float) else "RANDOM draws"
        case What.GRIP:
            return "the hand grips" if value else "the hand misses"
        case What.STOP:
            if value == What.STOP.value:
                return "the operator stops the program"
            return f"the operator types {one_line(str(value)).upper()}"
        case What.SPEED:
            return f"the monitor speed is {value} %"
        case What.AGAIN:
            return "the program is executed again"
        case What.TURN:
            return "the process control program has its turn first"


def place(wronged: Wronged | Decided) -> str:
    """Return where in the program: `line 17`, or nothing."""
    return f"line {wronged.cause.span.line}" if wronged.cause is not None else ""


def story(wronged: Wronged) -> list[tuple[float, str, str]]:
    """Return (time [s], where, what) of each decision that matters, and of what goes wrong."""
    rows = [(one.time_s, place(one), decision(one)) for one in wronged.decisions]
    return [*rows, (wronged.time_s, place(wronged), capital(one_line(wronged.headline)))]


def short_story(wronged: Wronged) -> list[str]:
    """Return what came from outside in at most three lines: of many only the first and last."""
    told = [_noted(*row) for row in story(wronged)[:-1]]
    if len(told) <= MOST_TOLD:
        return told
    left = len(told) - MOST_TOLD + 1
    return [*told[: MOST_TOLD - 2], f"then {left} others, not told here", told[-1]]


def scenario_of(wronged: Wronged) -> str:
    """Return the text of a scenario file in which it goes wrong."""
    return scenario_text(wronged.headline, wronged.scenario)


# --- where a task asks for it ---------------------------------------------------------------------


def sentence(proof: Proof) -> str:
    """Return the answer as the summary of a verdict: with cause, time, line and story."""
    match proof.answer:
        case Answer.HOLDS:
            return f"nothing goes wrong, in any future: {_looked_at(proof)}"
        case Answer.UNDETERMINED:
            why = f": {proof.open[0]}" if proof.open else ""
            return f"nothing went wrong as far as could be looked{why}"
        case Answer.VIOLATED:
            first = proof.found[0]
            place = where(first.time_s, first.cause)
            told = f"{_when(first)}, {place}, {one_line(first.headline)}"
            before = "; ".join(short_story(first))
            return f"{told} ({before})" if before else told


def _looked_at(proof: Proof) -> str:
    covered = proof.covered
    return f"{counted(covered.states, 'state')}, {counted(covered.decisions, 'decision')}"


def of_verdict(proof: Proof, environment: str | None = None) -> tuple[Diagnostic, ...]:
    """Return the one finding of a verdict on every future; none where nothing goes wrong.

    Args:
        proof: What was found.
        environment: The file to be named when it is looked at; None: the task names it.
    """
    match proof.answer:
        case Answer.HOLDS:
            return ()
        case Answer.UNDETERMINED:
            headline = "not every future of the program could be looked at"
            remedy = "make the program simpler where it waits, asks and counts"
            notes = tuple(map(one_line, proof.open[:MOST_TOLD]))
            return (
                Diagnostic(FUTURES_LEFT, Severity.WARNING, headline, notes=notes, help=(remedy,)),
            )
        case Answer.VIOLATED:
            first, *others = proof.found
            named = "" if environment is None else f" --environment {environment}"
            notes = short_story(first)
            notes += [f"{one_line(one.headline)}: this can go wrong too" for one in others[:2]]
            data: dict[str, Datum] = {**diagnostic(first).data, "scenario": scenario_of(first)}
            return (
                replace(
                    diagnostic(first),
                    notes=tuple(notes),
                    help=(SEE_IT.format(environment=named),),
                    data=MappingProxyType(data),
                ),
            )
