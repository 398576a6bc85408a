"""What a step says in the form of another language, or of another instruction.

Each function reports its mistake where a step has it, and returns whether it does.
"""

from vrts.base.diagnostic import Rule
from vrts.lang.grammar.lalr import END
from vrts.lang.problems import short
from vrts.lang.steps.broken_step import OPERANDS, BrokenStep
from vrts.lang.syntax.token import Token

INVALID_EXPRESSION = Rule("V126", "invalid-expression")
SINGLE_EQUALS = Rule("V127", "single-equals")
_JOINTS = 6
_ASSIGNED = 2  # tokens of `= h`
INVALID_FORMAT = Rule("V132", "invalid-format")


def beginning(step: BrokenStep) -> bool:
    """`// comment`, `= 5`: the step begins with a sign."""
    here = step.here
    if step.failure.at or here is None or here.kind in OPERANDS:
        return False
    comment = here.text in ("/", "*", "-")
    if here.text == "=" and _turned(step, here):
        return True
    step.problems.error(
        INVALID_EXPRESSION,
        f"a step does not begin with `{short(here.text)}`",
        here.start,
        here.end,
        notes=("VAL-II says *Unknown instruction*",),
        help=("begin comments with `;`",)
        if comment
        else ("a step begins with an instruction, as in `MOVE part`, or assigns, as in `n = 1`",),
    )
    return True


def _turned(step: BrokenStep, equals: Token) -> bool:
    """`50 = h`, where the number was taken for a label."""
    source = step.problems.source
    begin = source.text.rfind("\n", 0, equals.start) + 1
    number = source.text[begin : equals.start].strip()
    if len(step.tokens) != _ASSIGNED or step.tokens[1].kind != "NAME" or not number.isdecimal():
        return False
    name = step.tokens[1]
    start = equals.start - len(source.text[begin : equals.start].lstrip())
    meant = f"{name.text} = {number}"
    step.problems.error(
        INVALID_EXPRESSION,
        "the variable that gets a value stands left of `=`",
        start,
        name.end,
        notes=("VAL-II says *Unknown instruction*",),
        help=(f"write `{meant}`",),
        fix=step.problems.replace(start, name.end, meant),
    )
    return True


def compound_set(step: BrokenStep) -> bool:
    """`SET frame:part = ...`."""
    here = step.here
    if here is None or step.tokens[0].kind != "SET" or here.text != ":" or step.failure.at > 5:
        return False
    end = next((t.start for t in step.tokens if t.kind == "EQUAL"), here.end)
    step.problems.error(
        INVALID_EXPRESSION,
        "SET gives a value to one location, not to a compound",
        step.tokens[1].start,
        end,
        notes=("VAL-II says *Illegal assignment*",),
        help=("write `SET part = INVERSE(frame):...` for the part in its frame",),
    )
    return True


def equals_for_compare(step: BrokenStep) -> bool:
    """`IF a = b THEN`."""
    here = step.here
    if here is None or here.kind != "EQUAL" or "INFIX" not in step.wanted:
        return False
    step.problems.error(
        SINGLE_EQUALS,
        "`=` does not compare",
        here.start,
        here.end,
        notes=(
            "`=` gives a value, `==` asks whether two are equal",
            "VAL-II says *Illegal operator*",
        ),
        help=("write `==`",),
        fix=step.problems.replace(here.start, here.end, "==", sure=not _goes_on(step)),
    )
    return True


def _goes_on(step: BrokenStep) -> bool:
    """Whether `= c` follows as in `a = b = c`, which compares nothing that is meant."""
    for token in step.tokens[step.failure.at + 1 :]:
        if token.text.upper() in ("AND", "OR", "XOR"):
            return False
        if token.kind == "EQUAL":
            return True
    return False


def list_in_parentheses(step: BrokenStep) -> bool:
    """`MOVE (100,200,300)` and `SET p = 100,200,300`."""
    here = step.here
    if here is None or here.kind != "COMMA":
        return False
    start = None
    if "RPAREN" in step.wanted and "COMMA" not in step.wanted:
        start = next(t for t in reversed(step.tokens[: step.failure.at]) if t.kind == "LPAREN")
    elif step.tokens[0].kind == "SET" and END in step.wanted:
        start = step.before
    if start is None:
        return False
    given = step.tokens[1] if step.tokens[0].kind == "SET" else None
    if given is not None and given.kind == "JOINTNAME" and start is step.before:
        return _joints(step, here, given)
    step.problems.error(
        INVALID_EXPRESSION,
        "a list of numbers is not a location",
        here.start,
        here.end,
        secondary=(step.problems.label(start.start, start.end, "the list begins here"),),
        notes=("VAL-II says *Illegal expression syntax*",),
        help=("write `TRANS(x, y, z, o, a, t)`, in mm and degrees",),
    )
    return True


def _joints(step: BrokenStep, comma: Token, given: Token) -> bool:
    """`SET #tuck = 0, -90, 90, 0, 30, 0`."""
    source = step.problems.source.text
    equals = next(t for t in step.tokens if t.kind == "EQUAL")
    start, end = equals.end, step.tokens[-1].end
    values = source[start:end].strip()
    meant = f"#PPOINT({values})"
    six = values.count(",") == _JOINTS - 1 and "(" not in values
    step.problems.error(
        INVALID_EXPRESSION,
        f"a list of numbers is not a precision point: `{short(given.text)}` gets one of #PPOINT",
        comma.start,
        comma.end,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"write `{meant}`, with the angles of the joints in degrees",),
        fix=step.problems.replace(start, end, f" {meant}", sure=six),
    )
    return True


def format_misplaced(step: BrokenStep) -> bool:
    """`MOVE /F8.2`."""
    here = step.here
    if here is None or here.kind != "FORMAT":
        return False
    step.problems.error(
        INVALID_FORMAT,
        f"the format `{short(here.text)}` does not belong here",
        here.start,
        here.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=(
            "formats stand between the commas of TYPE and $ENCODE; a division needs a left side",
        ),
    )
    return True
