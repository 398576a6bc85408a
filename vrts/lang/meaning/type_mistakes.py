"""What is said of an expression of a wrong type, and of a function that is not as it has to be."""

import re
from collections.abc import Collection
from itertools import pairwise

from vrts.base.diagnostic import Fix, Rule
from vrts.ir.values import Type
from vrts.lang.meaning.forms import is_text
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.steps.other_forms import INVALID_FORMAT
from vrts.lang.steps.unknown_words import KEYWORD_AS_NAME
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Text,
)
from vrts.lang.vocabulary.function_forms import form_of
from vrts.lang.vocabulary.functions import FOREIGN_FUNCTIONS, Signature

WRONG_TYPE = Rule("V202", "wrong-type")
UNKNOWN_FUNCTION = Rule("V209", "unknown-function")
FUNCTION_ARGUMENTS = Rule("V210", "function-arguments")
RESERVED_NAME = Rule("V211", "reserved-name")
SUBSCRIPTS = Rule("V214", "subscripts")
DEFAULT_ANGLES = Rule("V215", "default-angles")
INVALID_SWITCH = Rule("V218", "invalid-switch")
INVALID_PARAMETER = Rule("V219", "invalid-parameter")

_GIVEN = re.compile(r"[ \t]*(\$?[A-Za-z][\w.]*)[ \t]*=[ \t]*")
MAX_SUBSCRIPTS = 3  # [manual language/numbers#dimensions]
_COUNTED = re.compile(r"(?<![\w.$#])LEN[ \t]*\([ \t]*\Z", re.IGNORECASE)
_BEFORE = 12  # signs before an array in which LEN is looked for
_OF_POSE = 6  # numbers of a location, as in `p[x, y, z, rx, ry, rz]`
_ANGLES = 3  # arguments of TRANS before its angles
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)")
NAME = re.compile(r"#?[A-Za-z][\w.]*", re.ASCII)
_RENAMED = {  # functions of other languages that take the same
    "signal": "SIG",
    "length": "LEN",
    "strlen": "LEN",
    "size": "LEN",
    "ord": "ASC",
    "chr": "$CHR",
    "str": "$ENCODE",
    "tostring": "$ENCODE",
    "num2str": "$ENCODE",
    "inttostr": "$ENCODE",
    "float": "VAL",
    "sgn": "SIGN",
}
_METHODS = {  # what other languages write behind the name of a string
    "length": "LEN({})",
    "len": "LEN({})",
    "size": "LEN({})",
    "count": "LEN({})",
    "substring": "$MID({}, first, count)",
    "substr": "$MID({}, first, count)",
    "charat": "$MID({}, first, 1)",
    "indexof": 'POS({}, "text")',
    "find": 'POS({}, "text")',
}
_FOR_COMMA = {  # operators that may stand between two arguments by mistake
    "atan2": ("/", ":"),
    "distance": ("-", ":"),
    "identical": ("==", "-", ":"),
}
_SHORTEST = 3  # letters of a name that may be a slip: `y(1)` hardly is one for DY
_TARGET = re.compile(r"[ \t]*(?:\d+[ \t]+)?(?P<target>\$?[A-Za-z][\w.]*)[ \t]*=[ \t]*", re.ASCII)
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
    elif wanted is Type.POSE and isinstance(node, Infix) and node.operator == "-":
        joined = written.replace(" ", "").replace("-", "_")
        help_ = (f"`-` subtracts; if this is meant as one name, write `{joined}`",)
    elif wanted is Type.POSE and found is Type.JOINTS:
        help_ = ("a precision point cannot stand in a compound: `SET p = #point` first",)
    elif wanted is Type.POSE and found is Type.REAL:
        help_ = ("name a location, or write `TRANS(x, y, z, o, a, t)`",)
        if why.startswith("TOOL"):
            tip = f"TOOL TRANS(0, 0, {written}, 90, -90, 0)"
            help_ = (f"for a tool of {written} mm that is not turned write `{tip}`",)
        if why.startswith("MOVE"):
            help_ = (
                "name a location, or write `TRANS(x, y, z, o, a, t)`",
                f"to go {written} mm up from here write `DRAW 0, 0, {written}`",
            )
    elif wanted is Type.STRING and found is Type.REAL:
        help_ = ("put text between double quotes; $ENCODE(x) turns a number into a string",)
    elif wanted is Type.REAL and found in (Type.POSE, Type.JOINTS):
        inner = written if found is Type.POSE else "l"
        help_ = (f"`DX({inner})`, `DY({inner})` and `DZ({inner})` are its coordinates",)
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
            return ("write a number here; text stands in TYPE and in names with `$`",), None
        fix = problems.replace(node.start, node.end, f"VAL({written})")
        return (f"VAL turns the text of a number into the number: `VAL({written})`",), fix
    if NAME.fullmatch(inner):
        fix = problems.replace(node.start, node.end, inner)
        return (f"a location is named without quotes: write `{inner}`",), fix
    return ("name a location, without `$` and without quotes",), None


def computed_strings(problems: Problems, node: Infix) -> None:
    """Report `$a - "X"` and `$a OR $b`: of strings, the language has only sums and comparisons."""
    left = problems.source.text[node.left.start : node.left.end]
    help_ = f"`+` joins strings; to take a part of one write `$MID({left}, first, count)`"
    if node.operator in ("AND", "OR"):
        help_ = f'compare each of them: `($s == "a") {node.operator} ($s == "b")`'
    problems.error(
        WRONG_TYPE,
        f"`{node.operator}` takes numbers, and these are strings",
        node.start,
        node.end,
        notes=(TYPES_SAY,),
        help=(help_,),
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


def format_here(problems: Problems, node: FormatItem) -> None:
    """Report a format in an expression."""
    problems.error(
        INVALID_FORMAT,
        f"the format `{node.text}` does not belong here",
        node.start,
        node.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=("formats stand in TYPE and $ENCODE",),
    )


def unknown_format(problems: Problems, item: FormatItem) -> None:
    """Report `/Q`."""
    problems.error(
        INVALID_FORMAT,
        f"`{item.text}` is not a format",
        item.start,
        item.end,
        notes=("VAL-II says *Invalid format specifier*",),
        help=("formats are /D /F8.2 /I4 /G8.2 /E10.2 /H /O /C /X /U /B /S",),
    )


def wrong_subscripts(problems: Problems, node: Element) -> None:
    """Report `a[]` where one element is wanted, and more subscripts than an array has."""
    if not node.subscripts:
        help_ = "write an index: a whole array can only be passed by CALL"
        if _COUNTED.search(problems.source.text, max(0, node.start - _BEFORE), node.start):
            help_ = (
                "LEN counts the letters of a string, and nothing counts the elements of an array"
            )
            help_ += ": keep their number in a variable, as in `count = 4`"
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


def arguments_fit(problems: Problems, node: Application, signature: Signature) -> bool:
    """Return whether a function has as many arguments as it takes; report it where it has not."""
    given = len(node.arguments)
    most = signature.most
    omitted = [
        i
        for i, argument in enumerate(node.arguments)
        if argument is None and (signature.name == "$encode" or _is_wanted(signature.parameters, i))
    ]
    name = node.name.text.upper()
    fix: Fix | None = None
    if signature.by is not None and node.by != signature.by:
        headline = f"{name} without BY"
        help_ = f"write `{form_of(signature)}`"
        fix = _with_by(problems, node)
    elif given < signature.required or omitted:
        headline = f"{name} needs {_arguments(signature.required)}, {given} given"
        help_ = f"write `{form_of(signature)}`"
        parted = _parted(problems, node)
        if parted:
            help_ = f"write a comma between them: `{parted}`"
            fix = problems.replace(node.start, node.end, parted)
    elif most is not None and given > most:
        headline = f"{name} takes {_arguments(most)}, {given} given"
        commas = _decimal_commas(problems, node)
        if most == 0:
            return _no_arguments(problems, node, signature)
        surplus = "one" if given - most == 1 else f"{given - most} of them"
        help_ = f"leave {surplus} out: write `{form_of(signature)}`"
        if len(commas) == given - most:
            left, right = commas[0]
            written = problems.source.text[left.start : left.end]
            behind = problems.source.text[right.start : right.end]
            help_ = f"a comma is no decimal sign: write a point, as in `{written}.{behind}`"
            if len(commas) == 1:
                fix = problems.replace(left.end, right.start, ".")
    else:
        return True
    problems.error(
        FUNCTION_ARGUMENTS,
        headline,
        node.start,
        node.end,
        notes=("VAL-II says *Missing argument*",),
        help=(help_,) if help_ else (),
        fix=fix,
    )
    return False


def _no_arguments(problems: Problems, node: Application, signature: Signature) -> bool:
    """Report `RANDOM(6)` and `HAND(1)`; False, as they do not fit."""
    name = signature.name.upper()
    text = problems.source.text
    given = [text[a.start : a.end] for a in node.arguments if a is not None]
    help_ = f"write `{name}` alone"
    fix = problems.replace(node.name.end, node.end, "")
    if name == "RANDOM" and 0 < len(given) <= 2:
        first, last = ("1", given[0]) if len(given) == 1 else given
        many = last if first == "1" else f"({last}-{first}+1)"
        written = f"INT({many}*RANDOM)+{first}"
        help_ = f"RANDOM is a number from 0 to 1: for one from {first} to {last} write `{written}`"
        fix = problems.replace(node.start, node.end, written, sure=False)
    problems.error(
        FUNCTION_ARGUMENTS,
        f"{name} takes no argument",
        node.start,
        node.end,
        notes=("VAL-II says *Missing argument*",),
        help=(help_,),
        fix=fix,
    )
    return False


def _parted(problems: Problems, node: Application) -> str:
    """Return `ATAN2(y, x)` for `ATAN2(y/x)`: an operator that stands for the comma."""
    argument = node.arguments[0] if len(node.arguments) == 1 else None
    if not isinstance(argument, Infix):
        return ""
    if argument.operator not in _FOR_COMMA.get(node.name.text.lower(), ()):
        return ""
    text = problems.source.text
    first = text[argument.left.start : argument.left.end]
    second = text[argument.right.start : argument.right.end]
    return f"{node.name.text}({first}, {second})"


def _with_by(problems: Problems, node: Application) -> Fix | None:
    """Return what puts BY in the place of the first comma: `SHIFT(part, 0, 0, 50)`."""
    if len(node.arguments) < _ANGLES or node.arguments[0] is None or node.by is not None:
        return None
    comma = problems.source.text.find(",", node.arguments[0].end, node.end)
    return problems.replace(comma, comma + 1, " BY") if comma >= 0 else None


def _is_number(text: str, name: str) -> bool:
    """Whether a file gives a name one value, and never an element."""
    name = re.escape(name)
    given = re.search(rf"^[ \t\d]*(?:FOR[ \t]+)?{name}[ \t]*=(?!=)", text, re.I | re.M)
    return given is not None and re.search(rf"(?<![\w.$#]){name}[ \t]*\[", text, re.I) is None


def _decimal_commas(problems: Problems, node: Application) -> list[tuple[Number, Number]]:
    """Return the arguments that may be one number written as in German: `2,25`."""
    text = problems.source.text
    return [
        (left, right)
        for left, right in pairwise(node.arguments)
        if isinstance(left, Number) and isinstance(right, Number)
        if text[left.end : right.start] == ","
        and text[left.start : left.end].isdecimal()
        and text[right.start : right.end].isdecimal()
    ]


def _is_wanted(parameters: tuple[str, ...], i: int) -> bool:
    return i < len(parameters) and parameters[i][-1] not in "?*"


def no_variable(problems: Problems, node: Application, first: Item) -> None:
    """Report `DEFINED(1)`."""
    problems.error(
        FUNCTION_ARGUMENTS,
        f"{node.name.text.upper()} takes a variable",
        first.start,
        first.end,
        notes=("VAL-II says *Illegal assignment*",),
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


def no_string_variable(problems: Problems, node: Application, argument: Item) -> None:
    """Report `$DECODE("text", ...)`, which changes its first argument."""
    problems.error(
        FUNCTION_ARGUMENTS,
        f"{node.name.text.upper()} takes a string variable first",
        argument.start,
        argument.end,
        notes=("it takes the piece that it returns out of the variable",),
        help=("assign the text to a variable: `$s = ...`",),
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


def unknown_function(
    problems: Problems, node: Application, known: Collection[str], programs: Collection[str]
) -> None:
    """Report a function that the language does not have."""
    lower = node.name.text.lower()
    shown = len(problems.found) < LIMIT  # what is not shown needs no suggestion
    meant = nearest(lower, known) if shown and len(lower) >= _SHORTEST else None
    fix: Fix | None = None
    module, _, last = lower.rpartition(".")
    if module[:1] == "$" and last in _METHODS:
        instead = _METHODS[last].format(node.name.text[: len(module)])
        help_ = (f"functions take a string between their parentheses: write `{instead}`",)
        if "," not in instead:
            fix = problems.replace(node.start, node.end, instead)
    elif lower in ("prompt", "input", "raw_input") and (prompt := _prompt(problems, node)):
        help_ = (f"PROMPT is an instruction: write `{prompt}`",)
        line = problems.source.text[: node.start].rpartition("\n")[2]
        fix = problems.replace(node.start - len(line.lstrip()), node.end, prompt)
    elif module[:1] == "$":
        help_ = ("functions of strings are LEN, $MID, POS, VAL, ASC, as in `LEN($s)`",)
    elif lower in FOREIGN_FUNCTIONS:
        help_ = (FOREIGN_FUNCTIONS[lower],)
        if lower in _RENAMED:
            fix = problems.replace(node.name.start, node.name.end, _RENAMED[lower])
    elif module in ("math", "np", "numpy") and last in known:
        help_ = (f"write `{last.upper()}` alone",)
        fix = problems.replace(node.name.start, node.name.end, last.upper())
    elif meant is not None:
        help_ = (f"did you mean `{meant.upper()}`?",)
        fix = problems.replace(node.name.start, node.name.end, meant.upper())
    elif lower in programs:
        help_ = (f"a program gives no value back: write {_call(problems, node)}",)
    elif _is_number(problems.source.text, node.name.text):
        behind = problems.source.text[node.name.end : node.end].strip()
        help_ = (f"`{node.name.text}` is a number: to multiply write `{node.name.text}*{behind}`",)
    else:
        written = problems.source.text[node.name.end : node.end].strip()[1:-1]
        help_ = (
            f"an element of an array is written with brackets: `{node.name.text}[{written}]`",
            f"a program gives no value back: if it is one, write {_call(problems, node)}",
        )
    problems.error(
        UNKNOWN_FUNCTION,
        f"there is no function `{node.name.text}`",
        node.name.start,
        node.name.end,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=help_,
        fix=fix,
    )


def _prompt(problems: Problems, node: Application) -> str:
    """Return the step for `n = PROMPT("How many? ")`."""
    text = problems.source.text
    line = text[text.rfind("\n", 0, node.start) + 1 : node.start]
    target = _GIVEN.fullmatch(line)
    asked = node.arguments[0] if len(node.arguments) == 1 else None
    if target is None or not isinstance(asked, Text):
        return ""
    return f"PROMPT {text[asked.start : asked.end]}, {target[1]}"


def _call(problems: Problems, node: Application) -> str:
    """Return how a program is called that was taken for a function."""
    text = problems.source.text
    given = text[node.name.end : node.end].strip()[1:-1].strip()
    begin = text.rfind("\n", 0, node.start) + 1
    target = _TARGET.fullmatch(text[begin : node.start])
    alone = text[node.end : text.find("\n", node.end)].partition(";")[0].strip() == ""
    result = target["target"] if target is not None and alone else "result"
    arguments = f"{given}, {result}" if given else result
    return f"`CALL {node.name.text}({arguments})`, with the result in an argument"


def joints_without_sign(problems: Problems, node: Application) -> None:
    """Report `PPOINT(...)`."""
    written = problems.source.text[node.name.start : node.end]
    problems.error(
        UNKNOWN_FUNCTION,
        "the name of #PPOINT begins with `#`, as do all precision points",
        node.name.start,
        node.name.end,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=(f"write `#{written}`",),
        fix=problems.replace(node.name.start, node.name.start, "#"),
    )


def default_angles(problems: Problems, node: Application) -> None:
    """Warn of `TRANS(x, y, z)`, which other controllers read otherwise."""
    given = node.arguments[_ANGLES:]
    if any(argument is not None for argument in given) or not node.arguments:
        return
    problems.warning(
        DEFAULT_ANGLES,
        "TRANS without angles",
        node.start,
        node.end,
        "taken as 90, -90, 0: not turned",
        notes=("other controllers take omitted angles as 0, 0, 0: the hand level",),
        help=("write all six: `TRANS(x, y, z, 90, -90, 0)`",),
    )


def reserved_name(problems: Problems, name: Name) -> None:
    """`HERE SIGNAL` and `FOR END = 1 TO 5` of AS: a keyword is given a value."""
    problems.error(
        KEYWORD_AS_NAME,
        f"{name.text.upper()} is a word of the language, and no name",
        name.start,
        name.end,
        "the name of a variable belongs here",
        help=("choose another name",),
    )


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


def _arguments(count: int) -> str:
    return f"{count} argument" if count == 1 else f"{count} arguments"
