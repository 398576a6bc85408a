"""`C2MOVE via, goal`, `LMOVE part, gripper`: behind a location of AS stands a clamp's number."""

from vrts.ir.values import Type
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry
from vrts.lang.meaning.type_mistakes import WRONG_TYPE
from vrts.lang.names import key
from vrts.lang.steps.misread.hand_words import NAMES_OF_HAND
from vrts.lang.syntax.expressions import Item, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

_ARCS = frozenset({"C1MOVE", "C2MOVE"})
_CLAMP = 1  # of the operands of a motion


def check_clamp(
    resolver: Resolver, program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report a name that holds no number where a motion takes the number of a clamp."""
    first = node.operands[0]
    clamp = node.operands[_CLAMP] if len(node.operands) > _CLAMP else None
    if clamp is None or first is None or not _without_value(resolver, program, clamp):
        return False
    problems = resolver.problems
    text = problems.source.text
    goal, other = text[first.start : first.end], text[clamp.start : clamp.end]
    if "clamp" in other.lower():
        return False  # surely its number, from the memory of the controller
    word = text[node.start : first.start].split("(")[0].strip().upper()
    helps = [f"behind the location stands a clamp, as in `{word} {goal}, 1`"]
    instead = f"{word} {goal}\n{word} {other}"
    if node.word in _ARCS:
        instead = f"C1MOVE {goal}\nC2MOVE {other}"
        helps = [
            f"an arc takes two steps, each with its own location: `C1MOVE {goal}`, `C2MOVE {other}`"
        ]
    elif other.lower() in NAMES_OF_HAND:
        instead = ""
    else:
        helps.append(f"or write two steps: `{word} {goal}`, `{word} {other}`")
    line = text[text.rfind("\n", 0, node.start) + 1 : node.start]
    indented = instead.replace("\n", f"\n{line}") if not line.strip() else ""
    problems.error(
        WRONG_TYPE,
        f"{word} takes one location, and behind it the number of a clamp",
        clamp.start,
        clamp.end,
        help=tuple(helps),
        fix=problems.replace(node.start, node.end, indented, sure=False) if indented else None,
    )
    return True


def check_hand(
    resolver: Resolver, program: ProgramText, node: Simple | Device | ReactStatement
) -> bool:
    """Report `OPENI gripper`: the hand is told by the number of its clamp."""
    clamp = node.operands[0]
    if not isinstance(clamp, Name) or clamp.text.lower() not in NAMES_OF_HAND:
        return False
    if not _without_value(resolver, program, clamp):
        return False
    problems = resolver.problems
    problems.error(
        WRONG_TYPE,
        f"{node.word} takes the number of a clamp, and no name",
        clamp.start,
        clamp.end,
        help=(f"write `{node.word} 1`, or `{node.word}` alone for clamp 1",),
        fix=problems.replace(clamp.start, clamp.end, "1"),
    )
    return True


def _without_value(resolver: Resolver, program: ProgramText, node: Item) -> bool:
    """Whether something is a name that surely holds no number."""
    if not isinstance(node, Name) or key(node.text) in resolver.bad_names:
        return False
    entry: Entry = resolver.scope.entry(program.name, key(node.text))
    if Type.POSE in entry.types or Type.JOINTS in entry.types or node.text[0] == "#":
        return True
    return entry.slot is None and not resolver.scope.may_have_value(entry)
