"""Legal steps that beginners regret: each warning needs no run to be seen."""

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.scope import Scope
from vrts.lang.structure import Block
from vrts.lang.syntax import (
    Application,
    CallStatement,
    Element,
    Expression,
    Goto,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    ProgramText,
    Simple,
    SpeedStatement,
    Statement,
    Text,
    Until,
    While,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS

CONSTANT_WAIT = Rule("V152", "constant-wait")
NEGATIVE_APPROACH = Rule("V220", "negative-approach")
HAND_ON_THE_WAY = Rule("V221", "hand-on-the-way")
ENDLESS_LOOP = Rule("V222", "endless-loop")

_ARRIVING = frozenset({"MOVE", "MOVES"})
_LEAVING = frozenset({"DEPART", "DEPARTS"})
_MOTIONS = _ARRIVING | _LEAVING | {"APPRO", "APPROS", "DRIVE", "READY"}
_ENDINGS = frozenset({"RETURN", "STOP", "HALT", "PAUSE"})


def check_habits(
    problems: Problems,
    scope: Scope,
    programs: list[ProgramText],
    structures: dict[str, list[Block]],
) -> None:
    """Warn of what the language allows and the writer hardly means."""
    for program in programs:
        steps = [s.statement for s in program.steps]
        for at, node in enumerate(steps):
            if isinstance(node, Simple):
                _waiting(problems, node)
                _approach(problems, scope, program, node)
                _hand(problems, steps, at, node)
        for block in structures[program.name]:
            if block.word in ("WHILE", "DO"):
                _loop(problems, scope, program, block)


def constant(scope: Scope, program: str, node: Item | None) -> float | None:
    """Return the value of an operand that is a number, or a variable only ever given one."""
    sign, node = _unsigned(node)
    if isinstance(node, Number):
        return sign * node.value
    if isinstance(node, Name) and node.text.lower() not in CONSTANTS:
        entry = scope.entry(program, key(node.text))
        if entry.slot is None and not entry.passed and len(entry.values) == 1:
            value = entry.values[0]
            inner = value.operand if isinstance(value, Prefix) else value
            if isinstance(inner, Number) and len(entry.writes) == 1:
                found = constant(scope, program, value)
                return None if found is None else sign * found
    return None


def number_of(node: Item | None) -> float | None:
    """Return the value of an operand that is a number, with or without sign."""
    sign, node = _unsigned(node)
    return sign * node.value if isinstance(node, Number) else None


def _unsigned(node: Item | None) -> tuple[float, Item | None]:
    sign = 1.0
    while isinstance(node, Prefix | Parenthesised):
        if isinstance(node, Parenthesised):
            node = node.inner
        elif node.operator in "+-":
            sign = -sign if node.operator == "-" else sign
            node = node.operand
        else:
            break
    return sign, node


def _waiting(problems: Problems, node: Simple) -> None:
    if node.word != "WAIT" or not isinstance(node.operands[0] if node.operands else None, Number):
        return
    value = node.operands[0]
    assert isinstance(value, Number)
    waits = "at once" if value.value else "never"
    problems.warning(
        CONSTANT_WAIT,
        f"this WAIT goes on {waits}",
        value.start,
        value.end,
        "a constant condition",
        notes=("WAIT takes a condition, not a time; any number but 0 is true",),
        help=(
            f"to wait {value.value:g} s write `DELAY {value.value:g}`",
            f"to wait for a signal write `WAIT SIG({value.value:g})`",
        ),
    )


def _approach(problems: Problems, scope: Scope, program: ProgramText, node: Simple) -> None:
    away = {"APPRO": 1, "APPROS": 1, "DEPART": 0, "DEPARTS": 0}.get(node.word)
    if away is None:
        return
    operand = node.operands[away]
    distance = constant(scope, program.name, operand)
    if operand is None or distance is None or distance >= 0:
        return
    approach = node.word.startswith("APPRO")
    problems.warning(
        NEGATIVE_APPROACH,
        f"{node.word} by {distance:g} mm goes {'beyond the location' if approach else 'forward'}",
        operand.start,
        operand.end,
        f"{-distance:g} mm along the tool, towards what lies in front of it",
        notes=(
            "the distance counts backwards from the "
            + ("location" if approach else "tool")
            + ": positive is away from the part",
        ),
        help=(f"write `{-distance:g}` to keep away from the part",),
        data={"distance_mm": distance},
    )


def _hand(problems: Problems, steps: list[Statement | None], at: int, node: Simple) -> None:
    """`MOVES part / CLOSE / DEPARTS 50`: the hand closes while it leaves."""
    if node.word not in ("OPEN", "CLOSE"):
        return
    following = next((s for s in steps[at + 1 :] if _counts(s)), None)
    before = next((s for s in reversed(steps[:at]) if _counts(s)), None)
    if not isinstance(following, Simple) or not isinstance(before, Simple):
        return
    leaves = following.word in _LEAVING
    grips = node.word == "CLOSE" and following.word in _MOTIONS
    if before.word not in _ARRIVING or not (leaves or grips):
        return
    does = "close" if node.word == "CLOSE" else "open"
    problems.warning(
        HAND_ON_THE_WAY,
        f"the hand only begins to {does} when {following.word} begins",
        node.start,
        node.end,
        f"acts together with the {following.word} below",
        secondary=(
            problems.label(following.start, following.end, f"the hand {does}s during this motion"),
        ),
        notes=(f"{node.word} belongs to the next motion, whether BREAK stands before it or not",),
        help=(f"write `{node.word}I`: it waits for the arm, {does}s, and waits for the hand",),
        fix=problems.replace(node.start, node.start + len(node.word), f"{node.word}I")
        if problems.source.text[node.start : node.end].upper() == node.word
        else None,
    )


def _counts(node: Statement | None) -> bool:
    """Whether a step matters for when the hand acts."""
    if node is None or isinstance(node, SpeedStatement):
        return False
    return not (isinstance(node, Simple) and node.word in ("BREAK", "TYPE", "SIGNAL"))


def _loop(problems: Problems, scope: Scope, program: ProgramText, block: Block) -> None:
    """A loop whose condition nothing in the loop can change."""
    at = block.opener if block.word == "WHILE" else block.end
    node = program.steps[at].statement
    if not isinstance(node, While | Until):
        return
    names: list[Name] = []
    if not _fixed(node.condition, names) or not names:
        return
    inside = [step.statement for step in program.steps[block.opener : block.end + 1]]
    changed = _changed(scope, inside, set())
    if changed is None:
        return
    keys = {key(name.text) for name in names}
    if changed & keys or any(scope.entry(program.name, k).type is not Type.REAL for k in keys):
        return
    ordered = list(dict.fromkeys(key(name.text) for name in names))
    shown = " or ".join(f"`{name}`" for name in ordered)
    first = ordered[0]
    problems.warning(
        ENDLESS_LOOP,
        "this loop never ends once it has begun"
        if block.word == "WHILE"
        else "this loop ends after one pass or never",
        node.condition.start,
        node.condition.end,
        f"nothing in the loop changes {shown}",
        help=(f"change {shown} in the loop, as in `{first} = {first}+1`",),
    )


def _changed(scope: Scope, steps: list[Statement | None], seen: set[str]) -> set[str] | None:
    """Return the names that steps and the programs they call may give a value.

    None when they may also leave the loop, or call a program that is not in the file.
    """
    changed: set[str] = set()
    for node in steps:
        if isinstance(node, Goto) and not seen:
            return None
        if isinstance(node, Simple) and node.word in _ENDINGS - ({"RETURN"} if seen else set()):
            return None
        target = getattr(node, "target", None)
        if isinstance(target, Name | Element):
            changed.add(key((target if isinstance(target, Name) else target.name).text))
        if not isinstance(node, CallStatement):
            continue
        for argument in node.arguments:
            if isinstance(argument, Name | Element):
                changed.add(key((argument if isinstance(argument, Name) else argument.name).text))
        name = key(node.program.text)
        called = scope.programs.get(name)
        if called is None:
            return None
        if name not in seen:
            inner = _changed(scope, [s.statement for s in called.steps], seen | {name})
            if inner is None:
                return None
            changed |= inner
    return changed


def _fixed(node: Expression, names: list[Name]) -> bool:
    """Whether an expression depends on plain variables only; collects them."""
    match node:
        case Number() | Text():
            return True
        case Name():
            lower = node.text.lower()
            if lower in CONSTANTS:
                return True
            names.append(node)
            return not (lower in FUNCTIONS and FUNCTIONS[lower].bare) and node.text[0] not in "$#"
        case Parenthesised(inner):
            return _fixed(inner, names)
        case Prefix(_, operand):
            return _fixed(operand, names)
        case Infix():
            return _fixed(node.left, names) and _fixed(node.right, names)
        case Application() | Element():
            return False
