"""What is too much in a step.

Each function reports its mistake where a step has it, and returns whether it does.
"""

import re

from vrts.base.diagnostic import Fix
from vrts.lang.grammar.lalr import END
from vrts.lang.grammar.shapes import UNEXPECTED_TEXT
from vrts.lang.problems import short
from vrts.lang.steps.broken_step import OPERANDS, TEXT_SAYS, BrokenStep
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.words import QUALIFIERS

_ALONE = {  # instructions without operands, and what may be meant by a name behind them
    "READY": "write READY alone: it moves to a place of its own; to go to `{0}` write `MOVE {0}`",
    "BREAK": "write BREAK alone: it waits until the motion above it ends",
    "RETURN": "write RETURN alone: a program gives values back in its arguments",
}
_CONDITIONS = frozenset({"WAIT", "UNTIL"})
_EMPTY = 3  # tokens of `READY()`
_NUMBERS = ("no operand", "one operand", "two operands", "three operands", "few operands")
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
        "unexpected here",
        notes=(TEXT_SAYS,),
        help=(f"write `{step.word.usage}`",),
        fix=step.problems.replace(before.start, here.end, "")
        if step.word.terminal not in ("WORD12", "WORD1", "WORD2")
        else None,
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
        if here.text == "(" and step.tokens[-1].text == ")" and len(step.tokens) == _EMPTY:
            whole = step.problems.replace(before.end, step.tokens[-1].end, "")
            _report_extra(step, here, f"{last} has no parentheses", f"write `{last}`", whole)
            return True
    elif last in _ALONE and len(step.tokens) == 2 and here.kind in ("NAME", "NUMBER"):
        _report_extra(
            step,
            here,
            f"{last} takes no operand",
            _ALONE[last].format(short(here.text)) if here.kind == "NAME" else f"write {last} alone",
            step.problems.replace(before.end, here.end, ""),
        )
        return True
    _report_extra(
        step, here, f"{last} ends its line" if last != ":" else "`:` ends its line", help_
    )
    return True


def too_many(step: BrokenStep) -> bool:
    """`MOVE part, 50`: the step could have ended before."""
    here = step.here
    if here is None or END not in step.wanted:
        return False
    if _label_behind(step, here):
        return True
    help_ = ""
    fix: Fix | None = None
    name = step.word.text if step.word else ""
    if name in ("MOVE", "MOVES") and here.kind == "COMMA":
        other = "APPRO" if name == "MOVE" else "APPROS"
        help_ = f"to stop short of a location use `{other} location, distance`"
    elif name == "SPEED" and here.kind == "INFIX":
        help_ = "write MMPS for millimetres a second"
    elif name == "CALL":
        help_ = "write the arguments between parentheses: `CALL program(a, b)`"
        fix = _in_parentheses(step, here)
    elif here.kind == "NAME" and step.before is not None and step.before.kind == "NAME":
        one = f"{step.before.text}.{here.text}"
        help_ = f"a name is one word, as `{one}` or `{one.replace('.', '_')}`"
        help_ += "; between two names belongs a comma, and before a remark `;`"
    elif _second_point(step, here):
        help_ = "a number has one decimal point"
    elif here.text.upper() in QUALIFIERS:
        help_ = f"{here.text.upper()} does not belong to {name or 'an assignment'}"
        if here is step.tokens[-1] and step.before is not None:
            written = step.problems.source.text
            kept = written[step.tokens[0].start : step.before.end]
            help_ += f": take it out, and write `{short(kept)}`"
            fix = step.problems.replace(step.before.end, here.end, "")
    elif step.word is not None:
        help_ = f"write `{step.word.usage}`"
        written = step.problems.source.text
        if step.before is not None and not step.inside:
            rest = written[here.start : step.tokens[-1].end].strip()
            kept = written[step.tokens[0].start : step.before.end]
            help_ = f"take `{short(rest)}` out: write `{short(kept)}`"
            if step.failure.at == 1:
                fix = step.problems.replace(step.before.end, step.tokens[-1].end, "")
            if step.word.text in _CONDITIONS and here.kind in OPERANDS:
                help_ += "; conditions are joined by `AND` or `OR`"
            if here.kind == "COMMA":
                many = _NUMBERS[min(len(step.word.operands), len(_NUMBERS) - 1)]
                takes = f"{step.word.text} takes {many}"
                _report_extra(
                    step, here, f"{takes}: `{short(rest)}` does not belong here", help_, fix
                )
                return True
    else:
        help_ = "write an operator between them, as `+` or `*`, or take one of them out"
        texts = ("STRING", "STRINGNAME")
        if here.kind in texts:
            help_ = "strings are joined by `+`"
            if step.before is not None and step.before.kind in texts:
                fix = step.problems.replace(step.before.end, here.start, " + ")
    _report_extra(step, here, f"the step ends before `{short(here.text)}`", help_, fix)
    return True


def _second_point(step: BrokenStep, here: Token) -> bool:
    """`50.0.5`."""
    before = step.before
    glued = before is not None and before.kind == "NUMBER" and before.end == here.start
    return glued and here.kind == "NUMBER" and here.text[0] == "."


def _label_behind(step: BrokenStep, here: Token) -> bool:
    """`n = n+1 10`, where something jumps to 10."""
    problems = step.problems
    text = problems.source.text
    if step.word is not None and step.word.text in ("GOTO", "IF"):
        return False
    if here is not step.tokens[-1] or not here.text.isdecimal() or step.before is None:
        return False
    if not re.search(rf"\bGOTO[ \t]+{here.text}(?![\w.])", text, re.IGNORECASE):
        return False
    start = step.tokens[0].start
    line = text[text.rfind("\n", 0, start) + 1 : start]
    moved = f"{here.text} {text[start : step.before.end]}"
    problems.error(
        UNEXPECTED_TEXT,
        f"the label {here.text} stands behind its step",
        here.start,
        here.end,
        "labels stand before",
        notes=(TEXT_SAYS,),
        help=(f"write the label at the start of the line: `{moved}`",),
        fix=None if line.strip() else problems.replace(start, here.end, moved),
    )
    return True


def _in_parentheses(step: BrokenStep, here: Token) -> Fix | None:
    """`CALL fetch, a, 60`, `CALL show i`: the arguments as CALL takes them."""
    before = step.before
    if step.failure.at == 2 and here.kind == "LBRACKET" and step.tokens[-1].kind == "RBRACKET":
        arguments = step.problems.source.text[here.end : step.tokens[-1].start]
        return step.problems.replace(here.start, step.tokens[-1].end, f"({arguments})")
    if step.failure.at != 2 or before is None or here.kind not in ("COMMA", *OPERANDS):
        return None
    first = step.tokens[3] if here.kind == "COMMA" and len(step.tokens) > 3 else here
    if first.kind == "COMMA" or any(t.kind == "UNITOPEN" for t in step.tokens):
        return None
    end = step.tokens[-1].end
    arguments = step.problems.source.text[first.start : end]
    return step.problems.replace(before.end, end, f"({arguments})")


def _report_extra(
    step: BrokenStep, here: Token, headline: str, help_: str, fix: Fix | None = None
) -> None:
    step.problems.error(
        UNEXPECTED_TEXT,
        headline,
        here.start,
        step.tokens[-1].end,
        "unexpected here",
        notes=(_QUALIFIER_SAYS if here.text.upper() in QUALIFIERS else TEXT_SAYS,),
        help=(help_,) if help_ else (),
        fix=fix,
    )
