"""What is too much in a step.

Each function reports its mistake where a step has it, and returns whether it does.
"""

from vrts.lang.grammar.lalr import END
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.problems import short
from vrts.lang.steps.broken_step import TEXT_SAYS, BrokenStep
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.words import QUALIFIERS

_QUALIFIER_SAYS = "VAL-II says *Invalid qualifier*"


def empty_parentheses(step: BrokenStep) -> bool:
    """`READY()`."""
    here, before = step.here, step.before
    if step.failure.at != 2 or here is None or before is None or step.word is None:
        return False
    if before.kind != "LPAREN" or here.kind != "RPAREN":
        return False
    step.problems.error(
        UNEXPECTED_TEXT,
        f"{step.word.text} has no parentheses",
        before.start,
        here.end,
        "this is too much",
        notes=(TEXT_SAYS,),
        help=(f"write `{step.word.usage}`",),
        fix=step.problems.replace(before.start, here.end, ""),
    )
    return True


def text_after_structure(step: BrokenStep) -> bool:
    """`IF x THEN OPENI`, `ELSE IF`, `VALUE 1: MOVE a`, `END IF`."""
    here, before = step.here, step.before
    if here is None or before is None or step.wanted - {END, "ENDCOLON"}:
        return False
    last = before.text
    if last not in ("THEN", "DO", "OF", "ELSE", "END", "ANY", "READY", "BREAK", "RETURN", ":"):
        return False
    help_ = "write the rest on a line of its own"
    if last == "THEN" and here.text.upper() == "GOTO":
        help_ = "write `IF condition GOTO label`, without THEN"
    elif last == "ELSE" and here.text.upper() == "IF":
        help_ = "write ELSE on a line of its own, and a new IF with its own END below"
    elif last == "END":
        help_ = "write END alone: it ends the structure that is open"
    elif here.kind == "LPAREN":
        help_ = f"write {last} alone"
    _report_extra(
        step, here, f"{last} ends its line" if last != ":" else "`:` ends its line", help_
    )
    return True


def too_many(step: BrokenStep) -> bool:
    """`MOVE part, 50`: the step could have ended before."""
    here = step.here
    if here is None or END not in step.wanted:
        return False
    help_ = ""
    name = step.word.text if step.word else ""
    if name in ("MOVE", "MOVES") and here.kind == "COMMA":
        other = "APPRO" if name == "MOVE" else "APPROS"
        help_ = f"to stop short of a location use `{other} location, distance`"
    elif name == "SPEED" and here.kind == "INFIX":
        help_ = "write MMPS for millimetres a second"
    elif name == "CALL":
        help_ = "write the arguments between parentheses: `CALL program(a, b)`"
    elif here.text.upper() in QUALIFIERS:
        help_ = f"{here.text.upper()} does not belong to {name or 'an assignment'}"
    elif step.word is not None:
        help_ = f"write `{step.word.usage}`"
    _report_extra(step, here, f"the step ends before `{short(here.text)}`", help_)
    return True


def _report_extra(step: BrokenStep, here: Token, headline: str, help_: str) -> None:
    step.problems.error(
        UNEXPECTED_TEXT,
        headline,
        here.start,
        step.tokens[-1].end,
        "this is too much",
        notes=(_QUALIFIER_SAYS if here.text.upper() in QUALIFIERS else TEXT_SAYS,),
        help=(help_,) if help_ else (),
    )
