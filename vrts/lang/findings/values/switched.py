"""SIGNAL with ON, OFF or NOT, which yield numbers: `SIGNAL 5, OFF`."""

from vrts.lang.findings.values.comparisons import COMPARISONS, bare
from vrts.lang.findings.values.complaints import NO_SUCH_SIGNAL
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.syntax.expressions import Element, Infix, Item, Name, Number, Prefix
from vrts.lang.syntax.statements import Simple

_ON = frozenset({"on", "true"})
_OFF = frozenset({"off", "false"})


def says_off_by_zero(types: NameUses) -> bool:
    """Return whether some `SIGNAL n, 0` shows that its writer takes the last number for a state."""
    return any(
        isinstance(asked.node, Simple)
        and asked.node.word == "SIGNAL"
        and len(asked.node.operands) > 1
        and number_of(asked.node.operands[-1]) == 0.0
        for asked in types.asked
    )


def check_switched(types: NameUses, node: Simple, *, zeros: bool) -> bool:
    """Warn of states among the signals; return whether there are any.

    With `zeros`, 1 and 0 behind a signal are states in this file: see `says_off_by_zero`.
    """
    states = [(part, state) for part in node.operands if (state := _state(part)) is not None]
    signals = [part for part in node.operands if _state(part) is None]
    if not states and len(signals) == 2 and (zeros or number_of(signals[1]) == 0.0):
        number = number_of(signals[1])
        if number in (0.0, 1.0) and signals[1] is not None:
            states = [(signals.pop(), number == 1.0)]
    if not states:
        return _computed(types, node)
    problems = types.problems
    text = problems.source.text
    said, on = states[0]
    assert said is not None
    word = text[said.start : said.end].upper()
    if isinstance(said, Number):
        why, text_ = (f"{word} is another signal" if on else f"{word} is no signal"), ""
    else:
        why = f"{word} is the number {-1 if on else 0}"
        text_ = "this switches signal 1 off" if on else "this switches nothing"
    plain = [part for part in signals if isinstance(part, Number | Name | Element)]
    one_state = len(states) == 1 and len(plain) == len(signals) > 0
    instead = "SIGNAL " + ", ".join(
        ("" if on else "-") + text[part.start : part.end] for part in plain
    )
    help_ = f"write `{instead}`" if one_state else "write `SIGNAL 5` for on, `SIGNAL -5` for off"
    problems.warning(
        NO_SUCH_SIGNAL,
        f"SIGNAL takes numbers of signals only: {why}",
        said.start,
        said.end,
        text_,
        notes=("a signal is switched on by its number, and off by the number with a minus sign",),
        help=(help_,),
        fix=problems.replace(node.start, node.end, instead, sure=len(signals) == 1)
        if one_state
        else None,
    )
    return True


def _computed(types: NameUses, node: Simple) -> bool:
    """`SIGNAL NOT 4` and `SIGNAL 4 == OFF`: both yield -1 or 0, and no signal."""
    problems = types.problems
    text = problems.source.text
    for part in node.operands:
        if isinstance(part, Prefix) and part.operator == "NOT":
            inner, sign = bare(part.operand), "-"
            headline = "NOT yields true or false, and no number of a signal"
        elif isinstance(part, Infix) and part.operator in COMPARISONS:
            inner, sign = part.left, "-" if _is_off(part.right) else ""
            headline = "SIGNAL takes numbers of signals only: a comparison is no signal"
        elif isinstance(part, Infix) and _lists(text, part):
            inner, sign = part.left, ""
            headline = f"`{part.operator}` makes one number of two: SIGNAL takes a list"
        else:
            continue
        instead = f"{sign}{text[inner.start : inner.end]}"
        help_ = f"to switch it {'off' if sign else 'on'} write `SIGNAL {instead}`"
        if isinstance(part, Infix) and part.operator not in COMPARISONS:
            second = text[part.right.start : part.right.end]
            instead += f", {'-' if part.operator == '-' else ''}{second}"
            help_ = f"write commas between the signals: `SIGNAL {instead}`"
        problems.warning(
            NO_SUCH_SIGNAL,
            headline,
            part.start,
            part.end,
            notes=("a signal is switched off by its number with a minus sign",),
            help=(help_,),
            fix=problems.replace(part.start, part.end, instead)
            if isinstance(inner, Number | Name | Element)
            else None,
        )
        return True
    return False


def _lists(text: str, part: Infix) -> bool:
    """`SIGNAL 5 AND 6`, `SIGNAL 5 + 6`, `SIGNAL 5 -6`: two signals, where the comma is missing."""
    if not isinstance(part.left, Number) or not isinstance(part.right, Number):
        return False
    if part.operator != "-":
        return part.operator in ("AND", "+")
    between = text[part.left.end : part.right.start]
    return between.startswith((" ", "\t")) and between.endswith("-")


def _is_off(node: Item) -> bool:
    return number_of(node) == 0.0 or _state(node) is False


def _state(node: Item | None) -> bool | None:
    """Return whether ON or OFF stands there; None for anything else."""
    if not isinstance(node, Name):
        return None
    word = node.text.lower()
    return True if word in _ON else False if word in _OFF else None
