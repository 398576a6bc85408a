"""Conditions that hardly ask what is meant: constants, SIG compared with 1, outputs waited for."""

from vrts.base.diagnostic import Fix, Rule
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.lang.findings.values.comparisons import is_truth, operands_of
from vrts.lang.findings.values.complaints import NO_SUCH_SIGNAL
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.in_range import check_in_range
from vrts.lang.findings.values.intervals import ANY, TRUTH
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.syntax.expressions import Application, Expression, Infix, Item, Name, Number
from vrts.lang.syntax.statements import If, Simple, Until, While

ALWAYS_TRUE = Rule("V239", "always-true")
SIGNAL_COMPARED = Rule("V240", "signal-compared")
WAITS_FOR_OUTPUT = Rule("V241", "waits-for-output")

_TRUTHS = frozenset({"true", "on"})
_TRUTH_FUNCTIONS = frozenset({"sig", "defined", "switch", "outside", "identical"})
_CLOCKS = frozenset({"timer", "utimer"})
_LOGICAL = (-1.0, 0.0, 1.0)  # numbers that may stand for true and false


def check_condition(types: NameUses, asked: Asked, *, beside: bool) -> None:
    """Warn of a condition that asks nothing, or something else."""
    if not types.problems.dialect.tolerant and check_in_range(types, asked):
        return
    match asked.node:
        case Infix("OR", left, right):
            if _signals_by_number(types, asked.node):
                return
            for operand, other in ((left, right), (right, left)):
                if _surely_true(operand) and evaluate(other, nothing_known) in (ANY, TRUTH):
                    _always(types, operand, "with it the whole condition is always true")
                    return
        case Infix("AND"):
            _signals_by_number(types, asked.node)
        case Infix("==" | "<>", Application(name) as call, Number(value)) if (
            name.text.lower() in _TRUTH_FUNCTIONS
        ):
            if value not in (-1.0, 0.0):
                _compared(types, asked.node, call)
        case Infix("==", Application(name) as call, Number(value)) if (
            name.text.lower() in _CLOCKS and types.problems.dialect.has("+a")
        ):
            _exactly(types, asked.node, call)
        case Infix("==" | "<>", Name() as name, Number(1.0)) if is_truth(
            types, asked.program, name
        ):
            _compared(types, asked.node, name)
        case If(condition) | While(condition) | Until(condition):
            value = number_of(condition)
            if value is not None and value not in _LOGICAL:
                _always(types, condition, "a number that is not 0 is true")
        case Simple("WAIT", (Application(name, arguments) as condition,)):
            ours = not types.problems.dialect.tolerant and not beside
            if ours and name.text.lower() == "sig" and all(map(_is_output, arguments)):
                _waits(types, condition)
        case Simple("SIGNAL", operands):
            for operand in operands:
                if isinstance(operand, Number) and operand.value == 0.0:
                    _nothing(types, operand)
        case _:
            return


def _exactly(types: NameUses, node: Infix, call: Application) -> None:
    """`TIMER(1) == 3`: hardly ever is it just that when it is asked."""
    text = types.problems.source.text
    left, right = text[node.left.start : node.left.end], text[node.right.start : node.right.end]
    instead = f"{left} >= {right}"
    types.problems.warning(
        SIGNAL_COMPARED,
        f"{call.name.text.upper()} runs on between two looks: it is hardly ever exactly {right}",
        node.start,
        node.end,
        help=(f"ask whether it has come so far: write `{instead}`",),
        fix=types.problems.replace(node.operator_start, node.operator_start + 2, ">="),
    )


def _signals_by_number(types: NameUses, node: Infix) -> bool:
    """`1001 OR SIG(1002)`: a number of a signal is true, whatever the signal is."""
    problems = types.problems
    text = problems.source.text
    operands = operands_of(node)
    bare = [part for part in operands if _is_signal(number_of(part))]
    if not bare:
        return False
    written = [text[part.start : part.end] for part in operands]
    instead = f" {node.operator} ".join(
        f"SIG({part})" if number_of(operand) is not None else part
        for operand, part in zip(operands, written, strict=True)
    )
    problems.warning(
        ALWAYS_TRUE,
        "this is a number, and does not ask for the signal",
        bare[0].start,
        bare[0].end,
        "a number that is not 0 is true",
        help=(f"write `{instead}`",),
        fix=problems.replace(node.start, node.end, instead)
        if len(bare) == sum(number_of(part) is not None for part in operands)
        else None,
    )
    return True


def _is_signal(number: float | None) -> bool:
    return number is not None and (_is_in(INPUTS, number) or _is_in(INTERNAL, number))


def _is_in(signals: range, number: float) -> bool:
    """Whether a range holds the size of a number; to ask the range itself tries all its numbers."""
    size = abs(number)
    return signals.start <= size < signals.stop and size == int(size)


def _surely_true(node: Expression) -> bool:
    if isinstance(node, Number):
        return node.value != 0.0
    return isinstance(node, Name) and node.text.lower() in _TRUTHS


def _is_output(node: Item | None) -> bool:
    number = number_of(node)
    return number is not None and _is_in(OUTPUTS, number)


def _always(types: NameUses, node: Expression, text: str) -> None:
    problems = types.problems
    value = number_of(node)
    fix: Fix | None = None
    if value is not None and _is_signal(value):
        help_ = f"to ask for a signal write `SIG({value:g})`"
        fix = problems.replace(node.start, node.end, f"SIG({value:g})")
    else:
        help_ = "compare on both sides: `(x == 1) OR (x == 2)`"
    problems.warning(
        ALWAYS_TRUE,
        "this condition is always true",
        node.start,
        node.end,
        text,
        help=(help_,),
        fix=fix,
    )


def _compared(types: NameUses, node: Infix, call: Application | Name) -> None:
    problems = types.problems
    right = node.right
    fix: Fix | None = problems.replace(right.start, right.end, "ON")
    never = node.operator == "=="
    if never:
        fix = problems.replace(node.left.end, right.end, "")
    of = (
        f"{call.name.text.upper()} yields" if isinstance(call, Application) else f"`{call.text}` is"
    )
    problems.warning(
        SIGNAL_COMPARED,
        f"{of} -1 or 0: this is {'never' if never else 'always'} true",
        node.start,
        node.end,
        notes=("TRUE and ON are -1, FALSE and OFF are 0",),
        help=("leave the comparison out, or write `== ON`" if never else "write `<> ON`",),
        fix=fix,
    )


def _waits(types: NameUses, node: Application) -> None:
    types.problems.warning(
        WAITS_FOR_OUTPUT,
        "this waits for an output, which only a program sets",
        node.start,
        node.end,
        notes=("no other program runs beside this one: it goes on at once, or never",),
        help=("wait for an input, 1001 to 1032: `WAIT SIG(1001)`",),
    )


def _nothing(types: NameUses, node: Number) -> None:
    types.problems.warning(
        NO_SUCH_SIGNAL,
        "SIGNAL 0 sets no signal",
        node.start,
        node.end,
        help=("name an output, 1 to 32; a minus before it turns it off",),
    )
