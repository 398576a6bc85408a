"""What is said of a function with too few, too many or other arguments than it takes."""

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.decimal_commas import likeliest
from vrts.lang.meaning.forms import is_text
from vrts.lang.meaning.type_mistakes import TYPES_SAY, WRONG_TYPE
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Infix, Item
from vrts.lang.vocabulary.function_forms import form_of
from vrts.lang.vocabulary.functions import Signature

FUNCTION_ARGUMENTS = Rule("V210", "function-arguments")
DEFAULT_ANGLES = Rule("V215", "default-angles")

_OF_NUMBERS = frozenset({"int", "round", "fract"})
_ANGLES = 3  # arguments of TRANS before its angles
_FOR_COMMA = {  # operators that may stand between two arguments by mistake
    "atan2": ("/", ":"),
    "distance": ("-", ":"),
    "identical": ("==", "-", ":"),
}


def arguments_fit(problems: Problems, node: Application, signature: Signature) -> bool:
    """Return whether a function has as many arguments as it takes; report it where it has not."""
    given = len(node.arguments)
    most = signature.most
    enough = signature.required <= given <= (given if most is None else most)
    if enough and None not in node.arguments and signature.by in (None, node.by):
        return True
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
        every = "all arguments" if signature.required > 1 else "it"
        help_ = f"write {every}: `{form_of(signature)}`"
        parted = _parted(problems, node)
        if parted:
            help_ = f"write a comma between them: `{parted}`"
            fix = problems.replace(node.start, node.end, parted)
    elif most is not None and given > most:
        headline = f"{name} takes {_arguments(most)}, {given} given"
        if most == 0:
            return _no_arguments(problems, node, signature)
        surplus = "one" if given - most == 1 else f"{given - most} of them"
        help_ = f"leave {surplus} out: write `{form_of(signature)}`"
        pointed = likeliest(problems.source.text[node.start : node.end], given - most)
        if pointed:
            help_ = f"a comma is no decimal sign: write points, as in `{pointed.text}`"
            fix = problems.replace(node.start, node.end, pointed.text, sure=pointed.sure)
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
    if len(node.arguments) < _ANGLES or node.arguments[0] is None:
        return None
    if node.by is not None:
        return _by_moved(problems, node)
    comma = problems.source.text.find(",", node.arguments[0].end, node.end)
    blank = "" if problems.source.text[comma + 1 : comma + 2] in " \t" else " "
    return problems.replace(comma, comma + 1, f" BY{blank}") if comma >= 0 else None


def _by_moved(problems: Problems, node: Application) -> Fix | None:
    """Return what puts BY behind the location: `SHIFT(BY part, 0, 0, 50)`."""
    text = problems.source.text
    given = [text[a.start : a.end] for a in node.arguments if a is not None]
    if len(given) < len(node.arguments):
        return None
    moved = f"({given[0]} BY {', '.join(given[1:])})"
    return problems.replace(node.name.end, node.end, moved)


def _is_wanted(parameters: tuple[str, ...], i: int) -> bool:
    return i < len(parameters) and parameters[i][-1] not in "?*"


def number_of_text(problems: Problems, node: Application) -> bool:
    """Report `INT($answer)`, where other languages make a number of a text; return whether."""
    argument = node.arguments[0] if len(node.arguments) == 1 else None
    if node.name.text.lower() not in _OF_NUMBERS or argument is None or not is_text(argument):
        return False
    name = node.name.text.upper()
    written = problems.source.text[argument.start : argument.end]
    problems.error(
        WRONG_TYPE,
        f"{name} takes a number here, not a string",
        argument.start,
        argument.end,
        "this is a string",
        notes=(TYPES_SAY,),
        help=(f"VAL turns the text of a number into the number: write `VAL({written})`",),
        fix=problems.replace(node.start, node.end, f"VAL({written})"),
    )
    return True


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
        help=(f"write all six: `{_whole(problems, node)}`",),
        fix=problems.replace(node.end - 1, node.end - 1, ", 90, -90, 0")
        if len(node.arguments) == _ANGLES and None not in node.arguments
        else None,
    )


def _whole(problems: Problems, node: Application) -> str:
    """Return a TRANS with the angles that are taken where it names none."""
    if len(node.arguments) != _ANGLES or None in node.arguments:
        return "TRANS(x, y, z, 90, -90, 0)"
    return f"{problems.source.text[node.start : node.end - 1]}, 90, -90, 0)"


def _arguments(count: int) -> str:
    return f"{count} argument" if count == 1 else f"{count} arguments"
