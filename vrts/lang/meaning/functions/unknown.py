"""What is said of a function that the language does not have, and what was meant by it."""

import re
from collections.abc import Collection

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.syntax.expressions import Application, Item, Name, Number, Text
from vrts.lang.vocabulary.functions import FOREIGN_FUNCTIONS
from vrts.lang.vocabulary.functions_elsewhere import compares_texts, help_with, rewritten

UNKNOWN_FUNCTION = Rule("V209", "unknown-function")

_GIVEN = re.compile(r"[ \t]*(\$?[A-Za-z][\w.]*)[ \t]*=[ \t]*")
_TARGET = re.compile(r"[ \t]*(?:\d+[ \t]+)?(?P<target>\$?[A-Za-z][\w.]*)[ \t]*=[ \t]*", re.ASCII)
_SHORTEST = 3  # letters of a name that may be a slip: `y(1)` hardly is one for DY
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
    "dist": "DISTANCE",
    "arctan2": "ATAN2",
}
_WRITTEN_AS = {"pi": "PI", "inc": "{}+1", "succ": "{}+1", "dec": "{}-1"}
_REWRITTEN = dict.fromkeys(
    ("time.time", "time", "time.clock", "time.perf_counter", "clock", "millis", "gettime", "tic"),
    "TIMER(1)",
)
_MAKERS = frozenset({"zeros", "ones", "array", "list", "new", "cell", "malloc", "np.zeros"})
_MODULES = frozenset({"math", "np", "numpy", "m"})
_COORDINATES = {"x": "DX", "y": "DY", "z": "DZ", "getx": "DX", "gety": "DY", "getz": "DZ"}
_ASKED = frozenset(
    [
        "input",
        "in",
        "digital_in",
        "get_input",
        "getinput",
        "read",
        "readinput",
        "di",
        "din",
        "dinput",
        "getdi",
        "get_di",
        "readdi",
        "read_di",
        "testdi",
        "digitalread",
        "digital_read",
        "digitalin",
        "read_digital",
        "readdigital",
        "get_digital_in",
        "get_standard_digital_in",
        "get_configurable_digital_in",
        "get_tool_digital_in",
        "read_input",
        "get_in",
        "getin",
        "input.signal",
        "din.read",
        "inputstate",
        "isinputon",
    ]
)
_ASKED_OUTPUTS = frozenset(
    [
        "dout",
        "doutput",
        "getdo",
        "get_do",
        "readdo",
        "digital_out",
        "get_digital_out",
        "get_standard_digital_out",
        "get_output",
        "getoutput",
        "outputstate",
    ]
)
_NUMBERS = frozenset({"float", "double", "real", "num", "number", "int2real", "cdbl", "csng"})
_BEHIND = re.compile(r"[ \t]*(?P<sign>==|<>|!=)[ \t]*(?P<value>0|1|TRUE|FALSE)\b", re.IGNORECASE)
_FIRST_INPUT = 1000
_EQUAL_METHODS = frozenset({"equals", "equal", "compareto", "eq", "is", "__eq__", "isequal"})
_FINDING_METHODS = frozenset({"contains", "includes", "find", "indexof", "index", "has"})
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


def unknown_function(
    problems: Problems,
    node: Application,
    known: Collection[str],
    programs: Collection[str],
    *,
    is_place: bool = False,
) -> None:
    """Report a function that the language does not have; `is_place` where a location belongs."""
    lower = node.name.text.lower()
    shown = len(problems.found) < LIMIT  # what is not shown needs no suggestion
    meant = nearest(lower, known) if shown and len(lower) >= _SHORTEST else None
    fix: Fix | None = None
    of = node.arguments[0] if node.arguments else None
    module, _, last = lower.rpartition(".")
    own = problems.source.text[node.name.start : node.name.end].rpartition(".")[0]
    compared = _of_methods(problems, node, last, own) if module[:1] == "$" else ""
    if compared:
        help_ = (f"texts are compared by signs, and searched by functions: write `{compared}`",)
        fix = problems.replace(node.start, node.end, compared)
    elif module[:1] == "$" and last in _METHODS:
        instead = _METHODS[last].format(own)
        help_ = (f"functions take a string between their parentheses: write `{instead}`",)
        if "," not in instead:
            fix = problems.replace(node.start, node.end, instead)
    elif lower in programs:
        help_ = (f"a program gives no value back: write {_call(problems, node)}",)
    elif lower in ("prompt", "input", "raw_input") and (prompt := _prompt(problems, node)):
        help_ = (f"PROMPT is an instruction: write `{prompt}`",)
        line = problems.source.text[: node.start].rpartition("\n")[2]
        fix = problems.replace(node.start - len(line.lstrip()), node.end, prompt)
    elif module[:1] == "$":
        help_ = ("functions of strings are LEN, $MID, POS, VAL, ASC, as in `LEN($s)`",)
    elif lower in _COORDINATES and len(node.arguments) == 1 and isinstance(of, Name):
        help_ = (f"a coordinate of a location is `{_COORDINATES[lower]}({of.text})`",)
        fix = problems.replace(node.name.start, node.name.end, _COORDINATES[lower])
    elif lower in _ASKED and isinstance(of, Number) and of.value > _FIRST_INPUT:
        help_ = (f"a signal is asked for by SIG: write `SIG({of.value:g})`",)
        fix = problems.replace(node.name.start, node.name.end, "SIG")
    elif lower in _ASKED or lower in _ASKED_OUTPUTS:
        help_, fix = _signal(problems, node, lower)
    elif lower in _NUMBERS and of is not None and _is_no_text(problems, of):
        written = _written(problems, node)[0]
        help_ = (f"numbers are of one kind: write `{written}` alone",)
        fix = problems.replace(node.start, node.end, written)
    elif instead := rewritten(lower, _written(problems, node), problems.dialect):
        end, instead = _compared(problems, node, lower, instead)
        help_ = (f"write `{instead}`",)
        fix = problems.replace(node.start, end, instead)
    elif words := help_with(lower, problems.dialect):
        help_ = (words,)
    elif last in _COORDINATES and module and not node.arguments:
        instead = f"{_COORDINATES[last]}({node.name.text[: len(module)]})"
        help_ = (f"a coordinate of a location is `{instead}`",)
        fix = problems.replace(node.start, node.end, instead)
    elif f"${lower}" in known:
        help_ = (f"what gives a string begins with `$`: write `${node.name.text.upper()}`",)
        fix = problems.replace(node.name.start, node.name.start, "$")
    elif lower in _REWRITTEN:
        help_ = (f"write `{_REWRITTEN[lower]}`: seconds, counted up since the step `TIMER 1 = 0`",)
        fix = problems.replace(node.start, node.end, _REWRITTEN[lower])
    elif lower in _MAKERS:
        help_ = (_made(problems, node),)
    elif lower in FOREIGN_FUNCTIONS:
        help_ = (FOREIGN_FUNCTIONS[lower],)
        if lower in _RENAMED:
            fix = problems.replace(node.name.start, node.name.end, _RENAMED[lower])
        elif lower in _WRITTEN_AS and (lower == "pi") is (of is None):
            given = problems.source.text[of.start : of.end] if of is not None else ""
            fix = problems.replace(node.start, node.end, _WRITTEN_AS[lower].format(given))
    elif module in _MODULES and last in FOREIGN_FUNCTIONS:
        help_ = (FOREIGN_FUNCTIONS[last],)
    elif module in _MODULES and last in known:
        help_ = (f"write `{last.upper()}` alone",)
        fix = problems.replace(node.name.start, node.name.end, last.upper())
    elif meant is not None:
        help_ = (f"did you mean `{meant.upper()}`?",)
        fix = problems.replace(node.name.start, node.name.end, meant.upper())
    elif is_place or _is_array(problems.source.text, node.name.text):
        written = problems.source.text[node.name.end : node.end].strip()[1:-1]
        help_ = (f"an element of an array is written with brackets: `{node.name.text}[{written}]`",)
        fix = problems.replace(node.name.end, node.end, f"[{written}]")
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


def _written(problems: Problems, node: Application) -> list[str]:
    """Return the arguments as they are written; empty ones for those left out."""
    text = problems.source.text
    return [text[a.start : a.end] if a is not None else "" for a in node.arguments]


def _of_methods(problems: Problems, node: Application, method: str, of: str) -> str:
    """Return what asks the same as `$code.equals("R")` and `$s.contains("x")`; empty if none."""
    given = _written(problems, node)
    if len(given) != 1 or not given[0]:
        return ""
    if method in _EQUAL_METHODS:
        return f"{of} == {given[0]}"
    if method in _FINDING_METHODS or method in ("startswith", "concat", "append"):
        return rewritten(method, [of, *given], problems.dialect)
    return ""


def _compared(problems: Problems, node: Application, lower: str, instead: str) -> tuple[int, str]:
    """Return where `strcmp($a, $b) == 0` of C ends, and what asks the same."""
    behind = _BEHIND.match(problems.source.text, node.end)
    if behind is None or not compares_texts(lower, problems.dialect):
        return node.end, instead
    equal = behind["sign"] == "=="
    if behind["value"].upper() in ("1", "TRUE"):
        equal = not equal if lower.startswith("strcmp") else equal
    else:
        equal = equal if lower.startswith("str") else not equal
    return behind.end(), instead if equal else instead.replace(" == ", " <> ")


def _is_no_text(problems: Problems, node: Item) -> bool:
    """Whether what stands between the parentheses of `float(x)` is a number already."""
    return "$" not in (text := problems.source.text[node.start : node.end]) and '"' not in text


def _signal(
    problems: Problems, node: Application, lower: str
) -> tuple[tuple[str, ...], Fix | None]:
    """Return what asks for the signal that `get_digital_in(1)` and `TestDI(di1)` ask for."""
    of = node.arguments[0] if len(node.arguments) == 1 else None
    outputs = lower in _ASKED_OUTPUTS
    written = problems.source.text[of.start : of.end] if of is not None else ""
    digits = re.fullmatch(r"[a-z]*_?(\d+)", written, re.IGNORECASE)
    if digits is None:
        return (f"a signal is asked for by SIG: write `SIG({1 if outputs else 1001})`",), None
    number = int(digits[1]) + (0 if outputs or int(digits[1]) > _FIRST_INPUT else _FIRST_INPUT)
    end = node.end
    behind = _BEHIND.match(problems.source.text, node.end)
    asked = f"SIG({number})"
    if behind is not None:
        end = behind.end()
        on = behind["value"].upper() in ("1", "TRUE")
        asked = asked if on is (behind["sign"] == "==") else f"SIG(-{number})"
    why = "signals are asked for by SIG" if outputs else "input 1 is signal 1001"
    return (f"write `{asked}`: {why}",), problems.replace(node.start, end, asked)


def _made(problems: Problems, node: Application) -> str:
    """Say what to do instead of `count = zeros(1, 3)`."""
    line = problems.source.text[: node.start].rpartition("\n")[2]
    target = _TARGET.fullmatch(line)
    name = target["target"] if target is not None else "values"
    return f"leave it out: an array has no size, and an element begins with `{name}[1] = 0`"


def _is_array(text: str, name: str) -> bool:
    """Whether a file writes an element of an array of this name."""
    return re.search(rf"(?<![\w.$#]){re.escape(name)}[ \t]*\[", text, re.I) is not None


def _is_number(text: str, name: str) -> bool:
    """Whether a file gives a name one value, and never an element."""
    name = re.escape(name)
    given = re.search(rf"^[ \t\d]*(?:FOR[ \t]+)?{name}[ \t]*=(?!=)", text, re.I | re.M)
    return given is not None and re.search(rf"(?<![\w.$#]){name}[ \t]*\[", text, re.I) is None


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
