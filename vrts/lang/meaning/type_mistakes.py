"""What is said of an expression of a wrong type, and of a function that is not as it has to be."""

from collections.abc import Collection
from itertools import pairwise

from vrts.base.diagnostic import Fix, Rule
from vrts.ir.values import Type
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.spelling import nearest
from vrts.lang.steps.other_forms import INVALID_FORMAT
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Item,
    Name,
    Number,
)
from vrts.lang.vocabulary.functions import FOREIGN_FUNCTIONS, Signature

WRONG_TYPE = Rule("V202", "wrong-type")
UNKNOWN_FUNCTION = Rule("V209", "unknown-function")
FUNCTION_ARGUMENTS = Rule("V210", "function-arguments")
RESERVED_NAME = Rule("V211", "reserved-name")
SUBSCRIPTS = Rule("V214", "subscripts")
DEFAULT_ANGLES = Rule("V215", "default-angles")
INVALID_SWITCH = Rule("V218", "invalid-switch")
INVALID_PARAMETER = Rule("V219", "invalid-parameter")

MAX_SUBSCRIPTS = 3  # [manual language/numbers#dimensions]
_ANGLES = 3  # arguments of TRANS before its angles
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
    if wanted is Type.POSE and isinstance(node, Infix) and node.operator == "-":
        text = problems.source.text[node.start : node.end]
        joined = text.replace(" ", "").replace("-", "_")
        help_ = (f"`-` subtracts; if this is meant as one name, write `{joined}`",)
    elif wanted is Type.POSE and found is Type.JOINTS:
        help_ = ("a precision point cannot stand in a compound: `SET p = #point` first",)
    elif wanted is Type.POSE and found is Type.REAL:
        help_ = ("name a location, or write `TRANS(x, y, z, o, a, t)`",)
        if why.startswith("SET"):
            help_ = ("a number is given a value by `=`, without SET",)
    elif wanted is Type.REAL and found is Type.STRING:
        help_ = ("a string variable begins with `$`; VAL($s) turns a string into a number",)
    elif wanted is Type.STRING and found is Type.REAL:
        help_ = ("put text between double quotes; $ENCODE(x) turns a number into a string",)
    elif wanted is Type.REAL and found in (Type.POSE, Type.JOINTS):
        help_ = ("DX(l), DY(l) and DZ(l) are the coordinates of a location",)
    problems.error(
        WRONG_TYPE,
        f"{why}, not {IN_WORDS[found]}",
        node.start,
        node.end,
        f"this is {IN_WORDS[found]}",
        notes=(TYPES_SAY,),
        help=help_,
    )


def added_locations(problems: Problems, node: Infix) -> None:
    """Report `+` between locations."""
    problems.error(
        WRONG_TYPE,
        "locations are not added",
        node.operator_start,
        node.operator_start + 1,
        notes=(TYPES_SAY,),
        help=("join a frame and a location in it by `:`, or shift by `SHIFT(a BY x, y, z)`",),
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
        problems.error(
            SUBSCRIPTS,
            f"`{node.name.text}[]` is a whole array",
            node.start,
            node.end,
            help=("write an index: a whole array can only be passed by CALL",),
            notes=("VAL-II says *Missing argument*",),
        )
    if len(node.subscripts) > MAX_SUBSCRIPTS:
        problems.error(
            SUBSCRIPTS,
            f"an array has at most {MAX_SUBSCRIPTS} subscripts",
            node.start,
            node.end,
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
        help_ = f"write `{name}(location BY ...)`"
        fix = _with_by(problems, node)
    elif given < signature.required or omitted:
        headline = f"{name} needs {_arguments(signature.required)}, {given} given"
        help_ = ""
    elif most is not None and given > most:
        headline = f"{name} takes {_arguments(most)}, {given} given"
        commas = _decimal_commas(problems, node)
        help_ = ""
        if commas:
            left, right = commas[0]
            written = problems.source.text[left.start : left.end]
            behind = problems.source.text[right.start : right.end]
            help_ = f"a comma is no decimal sign: write a point, as in `{written}.{behind}`"
            if len(commas) == given - most == 1:
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


def _with_by(problems: Problems, node: Application) -> Fix | None:
    """Return what puts BY in the place of the first comma: `SHIFT(part, 0, 0, 50)`."""
    if len(node.arguments) < _ANGLES or node.arguments[0] is None or node.by is not None:
        return None
    comma = problems.source.text.find(",", node.arguments[0].end, node.end)
    return problems.replace(comma, comma + 1, " BY") if comma >= 0 else None


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
    meant = nearest(lower, known) if shown else None
    fix: Fix | None = None
    module, _, last = lower.rpartition(".")
    if lower in FOREIGN_FUNCTIONS:
        help_ = (FOREIGN_FUNCTIONS[lower],)
    elif module in ("math", "np", "numpy") and last in known:
        help_ = (f"write `{last.upper()}` alone",)
        fix = problems.replace(node.name.start, node.name.end, last.upper())
    elif meant is not None:
        help_ = (f"did you mean `{meant.upper()}`?",)
        fix = problems.replace(node.name.start, node.name.end, meant.upper())
    elif lower in programs:
        help_ = ("a program is called by CALL and yields no value",)
    else:
        help_ = ("an element of an array is written with brackets: `a[1]`",)
    problems.error(
        UNKNOWN_FUNCTION,
        f"there is no function `{node.name.text}`",
        node.name.start,
        node.name.end,
        notes=("VAL-II says *Illegal expression syntax*",),
        help=help_,
        fix=fix,
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
