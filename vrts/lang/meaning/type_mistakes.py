"""What is said of an expression of a wrong type, and of a name that cannot be given a value."""

import re
from collections.abc import Collection

from vrts.base.diagnostic import Fix, Rule
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.steps.unknown_words import KEYWORD_AS_NAME
from vrts.lang.syntax.expressions import (
    Element,
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Text,
)
from vrts.lang.vocabulary.functions import CONSTANTS

WRONG_TYPE = Rule("V202", "wrong-type")
RESERVED_NAME = Rule("V211", "reserved-name")
SUBSCRIPTS = Rule("V214", "subscripts")
INVALID_SWITCH = Rule("V218", "invalid-switch")
INVALID_PARAMETER = Rule("V219", "invalid-parameter")

_FORMAT_BEHIND = re.compile(r"[ \t]*(?P<format>/(?:[CXUBSHO]|[FIGED])\d*(?:\.\d+)?)(?![\w.])", re.I)
_STRING_COMPARED = re.compile(r"\$[\w.]+(?:\[[^\]]*\])?[ \t]*(?:==|<>)[ \t]*$", re.ASCII)
_PLACE = r"(?P<other>[A-Za-z][\w.]*(?:\[[^\]]*\])?)"  # a location beside a comparison
_SAME = r"[ \t]*(?P<sign>==|<>)[ \t]*"
_COMPARED_BEFORE = re.compile(rf"{_PLACE}{_SAME}$", re.ASCII)
_COMPARED_BEHIND = re.compile(rf"{_SAME}{_PLACE}", re.ASCII)
NOT_COUNTED = (
    "LEN counts the letters of a string, and nothing counts the elements of an array"
    ": keep their number in a variable, as in `count = 4`"
)
MAX_SUBSCRIPTS = 3  # [manual language/numbers#dimensions]
_COUNTED = re.compile(r"(?<![\w.$#])LEN[ \t]*\([ \t]*\Z", re.IGNORECASE)
_BEFORE = 12  # signs before an array in which LEN is looked for
_OF_POSE = 6  # numbers of a location, as in `p[x, y, z, rx, ry, rz]`
NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)")
NAME = re.compile(r"#?[A-Za-z][\w.]*", re.ASCII)
_GIVEN = re.compile(r"[ \t]*=(?!=)[ \t]*(?P<value>[^;\n]+)")
_TAKE_A_VALUE = frozenset(  # of AS, behind their word and without `=`
    [
        "SPEED",
        "TIMER",
        "DELAY",
        "TWAIT",
        "STABLE",
        "LDEPART",
        "JDEPART",
        "LMOVE",
        "JMOVE",
        "TYPE",
        "PRINT",
        "LOCK",
        "WEIGHT",
        "TOOL",
    ]
)
TYPES_SAY = "VAL-II says *Illegal operator*"
IN_WORDS = {
    Type.REAL: "a number",
    Type.STRING: "a string",
    Type.POSE: "a location",
    Type.JOINTS: "a precision point",
    Type.DYNAMIC: "a value",
}


def wrong_type(problems: Problems, node: Expression, found: Type, wanted: Type, why: str) -> None:
    """Report an expression of another type than its place wants."""
    help_: tuple[str, ...] = ()
    fix: Fix | None = None
    written = problems.source.text[node.start : node.end]
    if found is Type.STRING and wanted is not Type.STRING:
        help_, fix = _no_string(problems, node, wanted)
        if why.startswith("FOR counts a number") and written[:1] == "$":
            help_ = (f"the name of a number has no `$`: write `{written[1:]}`",)
            fix = problems.replace(node.start, node.start + 1, "")
    elif wanted is Type.POSE and isinstance(node, Infix) and node.operator == "-":
        joined = written.replace(" ", "").replace("-", "_")
        help_ = (f"`-` subtracts; if this is meant as one name, write `{joined}`",)
    elif wanted is Type.POSE and found is Type.JOINTS:
        help_ = ("a precision point cannot stand in a compound: `SET p = #point` first",)
    elif wanted is Type.POSE and found is Type.REAL:
        help_ = ("name a location, or write `TRANS(x, y, z, o, a, t)`",)
        if why.startswith("`+` joins"):
            shift = f"`SHIFT(part BY 0, 0, {written})`"
            help_ = (f"shift a location by {shift}: the offsets along X, Y and Z",)
        if why.startswith("TOOL"):
            tip = f"TOOL TRANS(0, 0, {written}, 90, -90, 0)"
            help_ = (f"for a tool of {written} mm that is not turned write `{tip}`",)
        if isinstance(node, Name) and node.text.lower() in CONSTANTS:
            help_ = (f"`{written}` is a number of the language: give the location another name",)
        elif why.startswith("MOVE"):
            help_ = (
                "name a location, or write `TRANS(x, y, z, o, a, t)`",
                f"to go {written} mm up from here write `DRAW 0, 0, {written}`",
            )
    elif wanted is Type.STRING and found is Type.REAL:
        help_ = ("put text between double quotes; $ENCODE(x) turns a number into a string",)
    elif wanted is Type.REAL and found in (Type.POSE, Type.JOINTS):
        inner = written if found is Type.POSE else "l"
        same = _same_place(problems.source.text, node) if found is Type.POSE else ""
        help_ = (same or f"`DX({inner})`, `DY({inner})` and `DZ({inner})` are its coordinates",)
    problems.error(
        WRONG_TYPE,
        f"{why}, not {IN_WORDS[found]}",
        node.start,
        node.end,
        f"this is {IN_WORDS[found]}",
        notes=(TYPES_SAY,),
        help=help_,
        fix=fix,
    )


def _same_place(text: str, node: Expression) -> str:
    """Return how to ask what `HERE == pick` asks."""
    line = text[text.rfind("\n", 0, node.start) + 1 : node.start]
    before, behind = _COMPARED_BEFORE.search(line), _COMPARED_BEHIND.match(text, node.end)
    found = before or behind
    if found is None:
        return ""
    written, sign = text[node.start : node.end], ">" if found["sign"] == "<>" else "<"
    pair = f"{found['other']}, {written}" if before else f"{written}, {found['other']}"
    return f"two places are the same where `DISTANCE({pair}) {sign} 1`, in mm"


def _no_string(
    problems: Problems, node: Expression, wanted: Type
) -> tuple[tuple[str, ...], Fix | None]:
    """Return what to write where a string stands for a number or a location, and its fix."""
    written = problems.source.text[node.start : node.end]
    while isinstance(node, Parenthesised):
        node = node.inner
    inner = node.value.strip() if isinstance(node, Text) else ""
    if wanted is Type.REAL:
        if NUMBER.fullmatch(inner):
            fix = problems.replace(node.start, node.end, inner)
            return (f"a number stands without quotes: write `{inner}`",), fix
        if isinstance(node, Text):
            slash = _FORMAT_BEHIND.match(problems.source.text, node.end)
            if slash is not None:
                written += f", {slash['format']}"
                fix = problems.replace(node.end, slash.start("format"), ", ")
                return (f"a comma stands before a format: write `{written}`",), fix
            if NAME.fullmatch(inner) and problems.source.text[node.start - 1] == "[":
                fix = problems.replace(node.start, node.end, inner)
                return (f"a variable stands without quotes: write `{inner}`",), fix
            return ("write a number here; text stands in TYPE and in names with `$`",), None
        fix = problems.replace(node.start, node.end, f"VAL({written})")
        return (f"VAL turns the text of a number into the number: `VAL({written})`",), fix
    if NAME.fullmatch(inner):
        fix = problems.replace(node.start, node.end, inner)
        return (f"a location is named without quotes: write `{inner}`",), fix
    return ("name a location, without `$` and without quotes",), None


def computed_strings(problems: Problems, node: Infix) -> None:
    """Report `$a - "X"` and `$a OR $b`: of strings, the language has only sums and comparisons."""
    text = problems.source.text
    left = text[node.left.start : node.left.end]
    right = text[node.right.start : node.right.end]
    start, fix = node.start, None
    help_ = f"`+` joins strings; to take a part of one write `$MID({left}, first, count)`"
    if node.operator in ("AND", "OR"):
        help_ = f'compare each of them: `($s == "a") {node.operator} ($s == "b")`'
        line = text[text.rfind("\n", 0, node.start) + 1 : node.start]
        found = _STRING_COMPARED.search(line)
        if found is not None:
            start -= len(found.group())
            instead = f"({found.group()}{left}) {node.operator} ({found.group()}{right})"
            help_ = f"compare each of them: write `{instead}`"
            fix = problems.replace(start, node.end, instead)
    problems.error(
        WRONG_TYPE,
        f"`{node.operator}` takes numbers, and these are strings",
        node.start,
        node.end,
        notes=(TYPES_SAY,),
        help=(help_,),
        fix=fix,
    )


def added_locations(problems: Problems, node: Infix) -> None:
    """Report `+` between locations, and between a location and a number."""
    text = problems.source.text
    left, right = text[node.left.start : node.left.end], text[node.right.start : node.right.end]
    fix: Fix | None = None
    if isinstance(node.right, Number):
        help_ = f"shift a location by `SHIFT({left} BY 0, 0, {right})`: the offsets along X, Y, Z"
    else:
        help_ = f"join a frame and a location in it by `:`, as in `{left}:{right}`"
        help_ += f", or shift by `SHIFT({left} BY x, y, z)`"
        if not isinstance(node.right, Infix) and not isinstance(node.left, Infix):
            at = node.operator_start
            blanks = text[at - 1 : at] == " " and text[at + 1 : at + 2] == " "
            fix = problems.replace(at - blanks, at + 1 + blanks, ":")
    problems.error(
        WRONG_TYPE,
        "locations are not added",
        node.operator_start,
        node.operator_start + 1,
        notes=(TYPES_SAY,),
        help=(help_,),
        fix=fix,
    )


def joined_by_colon(problems: Problems, node: Infix) -> None:
    """Report `tray:part` in AS."""
    at = node.operator_start
    problems.error(
        WRONG_TYPE,
        "`:` does not join locations in AS",
        at,
        at + 1,
        notes=("AS writes `+` where VAL and V+ have `:`",),
        help=("write `+`",),
        fix=problems.replace(at, at + 1, "+"),
    )


def slice_of_string(problems: Problems, node: Element) -> None:
    """Report `$s[0:3]`, the first characters of a string in Python."""
    text = problems.source.text
    of = text[node.start : node.end].partition("[")[0].rstrip()
    first, _, last = (part.strip() for part in _inside(text, node).partition(":"))
    instead = ""
    if first.isdecimal() and last.isdecimal() and int(last) > int(first):
        instead = f"$MID({of}, {int(first) + 1}, {int(last) - int(first)})"
    problems.error(
        WRONG_TYPE,
        "a string has no slices in `[ ]`: $MID takes a part of it",
        node.start,
        node.end,
        notes=(TYPES_SAY,),
        help=(f"write `{instead or f'$MID({of}, first, count)'}`: characters count from 1",),
        fix=problems.replace(node.start, node.end, instead) if instead else None,
    )


def _inside(text: str, node: Element) -> str:
    return text[node.name.end : node.end].strip()[1:-1]


def wrong_subscripts(problems: Problems, node: Element) -> None:
    """Report `a[]` where one element is wanted, and more subscripts than an array has."""
    if not node.subscripts:
        help_ = "write an index: a whole array can only be passed by CALL"
        if _COUNTED.search(problems.source.text, max(0, node.start - _BEFORE), node.start):
            help_ = NOT_COUNTED
        problems.error(
            SUBSCRIPTS,
            f"`{node.name.text}[]` is a whole array",
            node.start,
            node.end,
            help=(help_,),
            notes=("VAL-II says *Missing argument*",),
        )
    if len(node.subscripts) > MAX_SUBSCRIPTS:
        pose = len(node.subscripts) == _OF_POSE
        written = problems.source.text[node.name.end : node.end].strip()[1:-1]
        help_ = f"a name has up to {MAX_SUBSCRIPTS} numbers between its brackets"
        if pose:
            help_ = f"numbers make no location: TRANS does, in mm and degrees: `TRANS({written})`"
        problems.error(
            SUBSCRIPTS,
            f"an array has at most {MAX_SUBSCRIPTS} subscripts",
            node.start,
            node.end,
            help=(help_,),
            fix=problems.replace(node.start, node.end, f"TRANS({written})", sure=False)
            if pose
            else None,
        )


def not_read_into(problems: Problems, operands: tuple[Item | None, ...], node: Item) -> None:
    """Report an operand of PROMPT that cannot be read into, with the order that is meant."""
    text = problems.source.text
    written = text[node.start : node.end]
    first = operands[0]
    shown = f"{text[first.start : first.end]}, " if first is not None and is_text(first) else ""
    help_ = ('write the text first, then the variables: `PROMPT "text", n`',)
    fix: Fix | None = None
    if is_text(node) and len(operands) == 2 and isinstance(first, Name | Element):
        swapped = f"{written}, {text[first.start : first.end]}"
        help_ = (f"the text comes first, then the variable: `PROMPT {swapped}`",)
        fix = problems.replace(first.start, node.end, swapped)
    elif is_text(node) and len(operands) > 2:
        help_ = ("PROMPT shows one text: write a PROMPT of its own for each, on its own line",)
    elif isinstance(node, Text) and node.value.isidentifier():
        help_ = (f"the variable stands without quotes: `PROMPT {shown}{node.value}`",)
        fix = problems.replace(node.start, node.end, node.value)
    elif isinstance(node, Number | Infix):
        help_ = (f"name a variable for the answer: `PROMPT {shown}n`",)
    problems.error(
        WRONG_TYPE,
        "PROMPT reads into variables",
        node.start,
        node.end,
        f"this is a {'text' if is_text(node) else 'value'}",
        notes=(TYPES_SAY,),
        help=help_,
        fix=fix,
    )


def unknown_system_name(
    problems: Problems, node: Item, text: str, known: Collection[str], what: str
) -> None:
    """Report a switch or parameter that the controller does not have."""
    shown = len(problems.found) < LIMIT
    meant = nearest(text, known) if text and shown else None
    rule = INVALID_SWITCH if what == "switch" else INVALID_PARAMETER
    written = problems.source.text[node.start : node.end]
    problems.error(
        rule,
        f"there is no {what} `{written}`",
        node.start,
        node.end,
        notes=("VAL-II says *Invalid switch*",) if what == "switch" else (),
        help=(f"did you mean `{meant}`?" if meant else f"known are {', '.join(known)}",),
        fix=problems.replace(node.start, node.end, meant) if meant else None,
    )


def reserved_name(problems: Problems, name: Name) -> None:
    """`HERE SIGNAL` and `FOR END = 1 TO 5` of AS: a keyword is given a value."""
    text = problems.source.text
    upper = name.text.upper()
    help_, fix = "choose another name", None
    given = _GIVEN.match(text, name.end)
    if given is not None and upper in _TAKE_A_VALUE and _begins_step(text, name.start):
        numbered = f"{upper} 1 = " if upper == "TIMER" else f"{upper} "
        help_ = f"write `{numbered}{given['value'].strip()}`, or choose another name"
        fix = problems.replace(name.start, given.start("value"), numbered)
    problems.error(
        KEYWORD_AS_NAME,
        f"{upper} is a word of the language, and no name",
        name.start,
        name.end,
        "the name of a variable belongs here",
        help=(help_,),
        fix=fix,
    )


def _begins_step(text: str, start: int) -> bool:
    line = text[text.rfind("\n", 0, start) + 1 : start]
    return line.strip() == "" or line.strip().isdecimal()


def predefined_name(problems: Problems, name: Name, instructions: Collection[str]) -> None:
    """Report a value given to a constant or to a function of the language."""
    lower = name.text.lower()
    problems.error(
        RESERVED_NAME,
        f"{name.text.upper()} cannot be given a value",
        name.start,
        name.end,
        notes=("VAL-II says *Illegal assignment*",),
        help=(f"write `{lower.upper()} ...` without `=`, or choose another name",)
        if lower.upper() in instructions
        else ("choose another name",),
    )
