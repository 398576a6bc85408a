"""What is missing from a step: a keyword, a comma, an operand or a label.

Each function reports its mistake where a step has it, and returns whether it does.
"""

from vrts.base.diagnostic import Rule
from vrts.lang.grammar.lalr import END
from vrts.lang.grammar.shapes import LABEL_EXPECTED, MISSING_KEYWORD, MISSING_OPERAND
from vrts.lang.problems import short
from vrts.lang.steps.broken_step import ARGUMENT_SAYS, OPERANDS, TEXT_SAYS, BrokenStep, outside
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.word import Word

MISSING_COMMA = Rule("V131", "missing-comma")

_KEYWORDS = ("THEN", "DO", "OF", "TO", "BY")


def label(step: BrokenStep) -> bool:
    """`GOTO` without a label, or with what is none."""
    before = step.before
    if before is None or before.text != "GOTO" or step.wanted > frozenset({"NUMBER", "NAME"}):
        return False
    here = step.here
    at = here or before
    step.problems.error(
        LABEL_EXPECTED,
        f"`{here.text}` is not a label" if here else "GOTO needs a label",
        at.start if here else at.end,
        at.end,
        "the number of a label belongs here",
        notes=("VAL-II says *Invalid statement label*",),
        help=("labels are whole numbers at the start of a line: `10 MOVE a`, then `GOTO 10`",),
    )
    return True


def keyword(step: BrokenStep) -> bool:
    """`IF x` without THEN, `FOR n = 1` without TO."""
    if step.word is None:
        return False
    missing = [w for w in _KEYWORDS if w in step.wanted and w in step.word.qualifiers]
    here = step.here
    if not missing or (here is not None and here.text == "="):
        return False
    keyword = missing[0]
    before = step.before
    assert before is not None
    text = f"{keyword} belongs here"
    if here is not None and here.kind not in ("NAME", "NUMBER", "COMMA", *OPERANDS):
        return False
    help_ = f"write `{step.word.usage}`"
    if keyword == "THEN" and here is not None and here.text.upper() in INSTRUCTIONS:
        help_ = "write THEN, the step in a line of its own, and END"
    joins = here is None
    fix = step.problems.replace(before.end, before.end, f" {keyword}") if joins else None
    if here is not None and here.kind == "COMMA":
        fix = step.problems.replace(here.start, here.end, f" {keyword}")
    elif keyword == "TO" and here is not None and here.start > before.end:
        fix = step.problems.replace(before.end, before.end, f" {keyword}")  # `FOR i = 1 5`
    step.problems.error(
        MISSING_KEYWORD,
        f"{step.word.text} without {keyword}",
        before.end if here is None else here.start,
        before.end if here is None else here.end,
        text,
        secondary=(step.problems.label(step.tokens[0].start, step.tokens[0].end, "begins here"),),
        notes=(ARGUMENT_SAYS,),
        help=(help_,),
        fix=fix,
        data={"keyword": keyword},
    )
    return True


def comma(step: BrokenStep) -> bool:
    """`APPRO part 50`."""
    here, before = step.here, step.before
    if here is None or before is None or "COMMA" not in step.wanted or here.kind not in OPERANDS:
        return False
    if here.text.upper() == "TRANS" and before.kind in ("NAME", "RBRACKET") and not step.inside:
        return _colon(step, here, before)
    after = _operand_after(step)
    step.problems.error(
        MISSING_COMMA,
        f"a comma is missing before `{short(here.text)}`",
        before.end,
        here.start if here.start > before.end else here.end,
        "a comma belongs here",
        notes=(TEXT_SAYS,),
        help=(f"write `{step.word.usage}`" if after and step.word else "put a comma between them",),
        fix=step.problems.replace(before.end, before.end, ","),
    )
    return True


def _colon(step: BrokenStep, here: Token, before: Token) -> bool:
    """`SET slot = tray TRANS(...)`: no distance can be a location."""
    step.problems.error(
        MISSING_COMMA,
        f"a colon is missing before `{short(here.text)}`",
        before.end,
        here.start if here.start > before.end else here.end,
        "a colon belongs here",
        notes=("`:` joins two locations to a compound", TEXT_SAYS),
        help=(f"write `:` between them: `{before.text}:{here.text}(...)`",),
        fix=step.problems.replace(before.end, here.start, ":"),
    )
    return True


def _operand_after(step: BrokenStep) -> bool:
    return step.word is not None and len(step.word.operands) > 1


def operand(step: BrokenStep) -> bool:
    """The step ends, or goes on with `,` or `)`, where something to compute with belongs."""
    here, before = step.here, step.before
    if here is not None and here.kind in OPERANDS:
        return False
    if here is None and "COMMA" in step.wanted and END not in step.wanted and step.word is not None:
        return _next_operand(step)
    if "NAME" not in step.wanted and "NUMBER" not in step.wanted:
        return False
    first = step.tokens[0]
    at = here or before or first
    where = (at.start, at.end) if here is not None else (at.end, at.end)
    if step.word is not None and step.failure.at == 1:
        what = step.word.operands[0] if step.word.operands else "an operand"
        step.problems.error(
            MISSING_OPERAND,
            f"{step.word.text} needs {what}",
            *((first.start, first.end) if here is None else where),
            f"{what} belongs here" if here is not None else "nothing follows",
            notes=(ARGUMENT_SAYS,),
            help=(_forms(step.word),),
        )
        return True
    what = "a value"
    if step.word is not None and before is not None and before.kind == "COMMA":
        place = sum(1 for t in outside(step.tokens[: step.failure.at]) if t.kind == "COMMA")
        if place < len(step.word.operands) and not step.inside:
            what = step.word.operands[place]
    after = f"after `{before.text}`" if before is not None else "here"
    if here is not None:
        headline = f"{what} is missing before `{short(here.text)}`"
    else:
        headline = f"{what} is missing {after}"
    step.problems.error(
        MISSING_OPERAND,
        headline,
        *where,
        f"{what} belongs here",
        notes=(ARGUMENT_SAYS,),
        help=_behind(step),
    )
    return True


def _behind(step: BrokenStep) -> tuple[str, ...]:
    """Return what to write where an operand is missing within a step."""
    if step.here is None and step.before is not None and step.before.text == ":":
        return ("write the name of the location in that frame behind `:`, as in `frame:part`",)
    if step.word is not None and step.word.operands:
        return (f"write `{step.word.usage}`",)
    here, before = step.here, step.before
    if here is not None and before is not None and before.kind != "EQUAL":
        return (f"write a value between `{before.text}` and `{short(here.text)}`, or remove one",)
    if here is not None or before is None:
        return ("write a number, a variable or a sum there",)
    if before.kind == "EQUAL":
        return ("write a number, a variable or a sum behind `=`",)
    return (f"write a value behind `{before.text}`, or remove `{before.text}`",)


def _forms(word: Word) -> str:
    """Return how an instruction is written, with one operand too where one is enough."""
    shortest = word.usage.split(",")[0]
    either = f"`{shortest}` or " if word.terminal == "WORD12" and shortest != word.usage else ""
    return f"write {either}`{word.usage}`"


def _next_operand(step: BrokenStep) -> bool:
    """`APPRO part` ends where a comma and a distance belong."""
    word, before = step.word, step.before
    assert word is not None
    assert before is not None
    place = 1 + sum(1 for t in outside(step.tokens) if t.kind == "COMMA")
    if place >= len(word.operands):
        return False
    step.problems.error(
        MISSING_OPERAND,
        f"{word.text} needs {word.operands[place]}",
        before.end,
        before.end,
        f"`,` and {word.operands[place]} belong here",
        notes=(ARGUMENT_SAYS,),
        help=(f"write `{word.usage}`",),
    )
    return True
