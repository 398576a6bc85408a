"""Says what is wrong with a step that does not parse, in the terms of who wrote it.

The tables know which tokens could have come next; what a writer most likely meant depends on the
instruction. The first explanation that fits wins.
"""

from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.lang.grammar.lalr import END, Failure, expected
from vrts.lang.grammar.shapes import LABEL_EXPECTED, UNEXPECTED_TEXT
from vrts.lang.problems import Problems
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import QUALIFIERS

MISSING_OPERAND = Rule("V124", "missing-operand")
INVALID_EXPRESSION = Rule("V126", "invalid-expression")
SINGLE_EQUALS = Rule("V127", "single-equals")
MISSING_KEYWORD = Rule("V130", "missing-keyword")
MISSING_COMMA = Rule("V131", "missing-comma")
INVALID_FORMAT = Rule("V132", "invalid-format")

_KEYWORDS = ("THEN", "DO", "OF", "TO", "BY")
_OPERANDS = frozenset({"NAME", "NUMBER", "STRING", "STRINGNAME", "JOINTNAME", "LPAREN", "PREFIX"})
_ARGUMENT_SAYS = "VAL-II says *Missing argument*"
_QUALIFIER_SAYS = "VAL-II says *Invalid qualifier*"
_TEXT_SAYS = "VAL-II says *Unexpected text at end of line*"


class _Case(NamedTuple):
    problems: Problems
    tokens: list[Token]
    failure: Failure
    wanted: frozenset[str]
    word: Word | None

    @property
    def here(self) -> Token | None:
        """The token in the way, or None at the end of the step."""
        at = self.failure.at
        return self.tokens[at] if at < len(self.tokens) else None

    @property
    def before(self) -> Token | None:
        """The last token that made sense."""
        return self.tokens[self.failure.at - 1] if self.failure.at else None


def explain(problems: Problems, tokens: list[Token], failure: Failure, word: Word | None) -> None:
    """Report one diagnostic for a step that does not parse."""
    case = _Case(problems, tokens, failure, expected(failure.states), word)
    for explanation in (
        _no_beginning,
        _compound_set,
        _empty_parentheses,
        _function_without_parentheses,
        _equals_for_compare,
        _label_wanted,
        _keyword_missing,
        _text_after_structure,
        _list_in_parentheses,
        _comma_missing,
        _format_misplaced,
        _operand_missing,
        _too_many,
    ):
        if explanation(case):
            return
    _anything_else(case)


def _no_beginning(case: _Case) -> bool:
    """`// comment`, `= 5`: the step begins with a sign."""
    here = case.here
    if case.failure.at or here is None or here.kind in _OPERANDS:
        return False
    comment = here.text in ("/", "*", "-")
    case.problems.error(
        INVALID_EXPRESSION,
        f"a step does not begin with `{_short(here.text)}`",
        here.start,
        here.end,
        notes=("VAL-II says *Unknown instruction*",),
        help=("begin comments with `;`",)
        if comment
        else ("a step begins with an instruction, as in `MOVE part`, or assigns, as in `n = 1`",),
    )
    return True


def _compound_set(case: _Case) -> bool:
    """`SET frame:part = ...`."""
    here = case.here
    if here is None or case.tokens[0].kind != "SET" or here.text != ":" or case.failure.at > 5:
        return False
    end = next((t.start for t in case.tokens if t.kind == "EQUAL"), here.end)
    case.problems.error(
        INVALID_EXPRESSION,
        "SET gives a value to one location, not to a compound",
        case.tokens[1].start,
        end,
        notes=("VAL-II says *Illegal assignment*",),
        help=("write `SET part = INVERSE(frame):...` for the part in its frame",),
    )
    return True


def _empty_parentheses(case: _Case) -> bool:
    here, before = case.here, case.before
    if case.failure.at != 2 or here is None or before is None or case.word is None:
        return False
    if before.kind != "LPAREN" or here.kind != "RPAREN":
        return False
    case.problems.error(
        UNEXPECTED_TEXT,
        f"{case.word.text} has no parentheses",
        before.start,
        here.end,
        "this is too much",
        notes=(_TEXT_SAYS,),
        help=(f"write `{case.word.usage}`",),
        fix=case.problems.replace(before.start, here.end, ""),
    )
    return True


def _function_without_parentheses(case: _Case) -> bool:
    """`WAIT SIG 1001`."""
    here, before = case.here, case.before
    if here is None or before is None or here.kind not in ("NUMBER", "NAME", "STRINGNAME"):
        return False
    signature = FUNCTIONS.get(before.text.lower())
    if before.kind != "NAME" or signature is None or signature.bare:
        return False
    name = before.text.upper()
    case.problems.error(
        INVALID_EXPRESSION,
        f"{name} without parentheses",
        before.start,
        here.end,
        notes=("VAL-II says *Missing parenthesis*",),
        help=(f"write `{name}({_short(here.text)})`",),
    )
    return True


def _equals_for_compare(case: _Case) -> bool:
    here = case.here
    if here is None or here.kind != "EQUAL" or "INFIX" not in case.wanted:
        return False
    case.problems.error(
        SINGLE_EQUALS,
        "`=` does not compare",
        here.start,
        here.end,
        notes=(
            "`=` gives a value, `==` asks whether two are equal",
            "VAL-II says *Illegal operator*",
        ),
        help=("write `==`",),
        fix=case.problems.replace(here.start, here.end, "=="),
    )
    return True


def _label_wanted(case: _Case) -> bool:
    before = case.before
    if before is None or before.text != "GOTO" or case.wanted > frozenset({"NUMBER", "NAME"}):
        return False
    here = case.here
    at = here or before
    case.problems.error(
        LABEL_EXPECTED,
        f"`{here.text}` is not a label" if here else "GOTO needs a label",
        at.start if here else at.end,
        at.end,
        "the number of a label belongs here",
        notes=("VAL-II says *Invalid statement label*",),
        help=("labels are whole numbers at the start of a line: `10 MOVE a`, then `GOTO 10`",),
    )
    return True


def _keyword_missing(case: _Case) -> bool:
    if case.word is None:
        return False
    missing = [w for w in _KEYWORDS if w in case.wanted and w in case.word.qualifiers]
    here = case.here
    if not missing or (here is not None and here.text == "="):
        return False
    keyword = missing[0]
    before = case.before
    assert before is not None
    text = f"{keyword} belongs here"
    if here is not None and here.kind not in ("NAME", "NUMBER", "COMMA", *_OPERANDS):
        return False
    help_ = f"write `{case.word.usage}`"
    if keyword == "THEN" and here is not None and here.text.upper() in INSTRUCTIONS:
        help_ = "write THEN, the step in a line of its own, and END"
    joins = here is None
    fix = case.problems.replace(before.end, before.end, f" {keyword}") if joins else None
    if here is not None and here.kind == "COMMA":
        fix = case.problems.replace(here.start, here.end, f" {keyword}")
    case.problems.error(
        MISSING_KEYWORD,
        f"{case.word.text} without {keyword}",
        before.end if here is None else here.start,
        before.end if here is None else here.end,
        text,
        secondary=(case.problems.label(case.tokens[0].start, case.tokens[0].end, "begins here"),),
        notes=(_ARGUMENT_SAYS,),
        help=(help_,),
        fix=fix,
        data={"keyword": keyword},
    )
    return True


def _text_after_structure(case: _Case) -> bool:
    """`IF x THEN OPENI`, `ELSE IF`, `VALUE 1: MOVE a`, `END IF`."""
    here, before = case.here, case.before
    if here is None or before is None or case.wanted - {END, "ENDCOLON"}:
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
        case, here, f"{last} ends its line" if last != ":" else "`:` ends its line", help_
    )
    return True


def _list_in_parentheses(case: _Case) -> bool:
    """`MOVE (100,200,300)` and `SET p = 100,200,300`."""
    here = case.here
    if here is None or here.kind != "COMMA":
        return False
    start = None
    if "RPAREN" in case.wanted and "COMMA" not in case.wanted:
        start = next(t for t in reversed(case.tokens[: case.failure.at]) if t.kind == "LPAREN")
    elif case.tokens[0].kind == "SET" and END in case.wanted:
        start = case.before
    if start is None:
        return False
    case.problems.error(
        INVALID_EXPRESSION,
        "a list of numbers is not a location",
        here.start,
        here.end,
        secondary=(case.problems.label(start.start, start.end, "the list begins here"),),
        notes=("VAL-II says *Illegal expression syntax*",),
        help=("write `TRANS(x, y, z, o, a, t)`, in mm and degrees",),
    )
    return True


def _comma_missing(case: _Case) -> bool:
    here, before = case.here, case.before
    if here is None or before is None or "COMMA" not in case.wanted or here.kind not in _OPERANDS:
        return False
    after = _operand_after(case)
    case.problems.error(
        MISSING_COMMA,
        f"a comma is missing before `{_short(here.text)}`",
        before.end,
        here.start if here.start > before.end else here.end,
        "a comma belongs here",
        notes=(_TEXT_SAYS,),
        help=(f"write `{case.word.usage}`" if after and case.word else "put a comma between them",),
        fix=case.problems.replace(before.end, before.end, ","),
    )
    return True


def _operand_after(case: _Case) -> bool:
    return case.word is not None and len(case.word.operands) > 1


def _operand_missing(case: _Case) -> bool:
    """The step ends, or goes on with `,` or `)`, where something to compute with belongs."""
    here, before = case.here, case.before
    if here is not None and here.kind in _OPERANDS:
        return False
    if here is None and "COMMA" in case.wanted and END not in case.wanted and case.word is not None:
        return _next_operand(case)
    if "NAME" not in case.wanted and "NUMBER" not in case.wanted:
        return False
    first = case.tokens[0]
    at = here or before or first
    where = (at.start, at.end) if here is not None else (at.end, at.end)
    if case.word is not None and case.failure.at == 1:
        what = case.word.operands[0] if case.word.operands else "an operand"
        case.problems.error(
            MISSING_OPERAND,
            f"{case.word.text} needs {what}",
            *((first.start, first.end) if here is None else where),
            f"{what} belongs here" if here is not None else "nothing follows",
            notes=(_ARGUMENT_SAYS,),
            help=(f"write `{case.word.usage}`",),
        )
        return True
    what = "a value"
    if case.word is not None and before is not None and before.kind == "COMMA":
        place = sum(1 for t in _level(case.tokens[: case.failure.at]) if t.kind == "COMMA")
        if place < len(case.word.operands) and not _inside(case):
            what = case.word.operands[place]
    after = f"after `{before.text}`" if before is not None else "here"
    if here is not None:
        headline = f"{what} is missing before `{_short(here.text)}`"
    else:
        headline = f"{what} is missing {after}"
    case.problems.error(
        MISSING_OPERAND,
        headline,
        *where,
        f"{what} belongs here",
        notes=(_ARGUMENT_SAYS,),
        help=(f"write `{case.word.usage}`",) if case.word and case.word.operands else (),
    )
    return True


def _next_operand(case: _Case) -> bool:
    """`APPRO part` ends where a comma and a distance belong."""
    word, before = case.word, case.before
    assert word is not None
    assert before is not None
    place = 1 + sum(1 for t in _level(case.tokens) if t.kind == "COMMA")
    if place >= len(word.operands):
        return False
    case.problems.error(
        MISSING_OPERAND,
        f"{word.text} needs {word.operands[place]}",
        before.end,
        before.end,
        f"`,` and {word.operands[place]} belong here",
        notes=(_ARGUMENT_SAYS,),
        help=(f"write `{word.usage}`",),
    )
    return True


def _format_misplaced(case: _Case) -> bool:
    here = case.here
    if here is None or here.kind != "FORMAT":
        return False
    case.problems.error(
        INVALID_FORMAT,
        f"the format `{_short(here.text)}` does not belong here",
        here.start,
        here.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=(
            "formats stand between the commas of TYPE and $ENCODE; a division needs a left side",
        ),
    )
    return True


def _too_many(case: _Case) -> bool:
    here = case.here
    if here is None or END not in case.wanted:
        return False
    help_ = ""
    name = case.word.text if case.word else ""
    if name in ("MOVE", "MOVES") and here.kind == "COMMA":
        other = "APPRO" if name == "MOVE" else "APPROS"
        help_ = f"to stop short of a location use `{other} location, distance`"
    elif name == "SPEED" and here.kind == "INFIX":
        help_ = "write MMPS for millimetres a second"
    elif name == "CALL":
        help_ = "write the arguments between parentheses: `CALL program(a, b)`"
    elif here.text.upper() in QUALIFIERS:
        help_ = f"{here.text.upper()} does not belong to {name or 'an assignment'}"
    elif case.word is not None:
        help_ = f"write `{case.word.usage}`"
    _report_extra(case, here, f"the step ends before `{_short(here.text)}`", help_)
    return True


def _report_extra(case: _Case, here: Token, headline: str, help_: str) -> None:
    case.problems.error(
        UNEXPECTED_TEXT,
        headline,
        here.start,
        case.tokens[-1].end,
        "this is too much",
        notes=(_QUALIFIER_SAYS if here.text.upper() in QUALIFIERS else _TEXT_SAYS,),
        help=(help_,) if help_ else (),
    )


def _anything_else(case: _Case) -> None:
    here, before = case.here, case.before
    if here is not None and "EQUAL" in case.wanted:
        headline = f"`=` is missing before `{_short(here.text)}`"
        where = (here.start, here.end)
    elif here is not None:
        headline = f"`{_short(here.text)}` does not belong here"
        where = (here.start, here.end)
    else:
        last = before or case.tokens[0]
        headline = f"the step breaks off after `{_short(last.text)}`"
        where = (last.end, last.end)
    case.problems.error(
        INVALID_EXPRESSION,
        headline,
        *where,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"write `{case.word.usage}`",) if case.word else (),
    )


def _level(tokens: list[Token]) -> list[Token]:
    """Return the tokens outside all parentheses and brackets."""
    depth = 0
    outside: list[Token] = []
    for token in tokens:
        if token.kind in ("LPAREN", "LBRACKET"):
            depth += 1
        elif token.kind in ("RPAREN", "RBRACKET"):
            depth -= 1
        elif depth == 0:
            outside.append(token)
    return outside


def _inside(case: _Case) -> bool:
    tokens = case.tokens[: case.failure.at]
    opened = sum(t.kind in ("LPAREN", "LBRACKET") for t in tokens)
    return opened > sum(t.kind in ("RPAREN", "RBRACKET") for t in tokens)


def _short(text: str) -> str:
    return text if len(text) <= 40 else text[:37] + "..."
